// The lists of stations, to be changed: x of each half, what the drawing calls them, and which half is drawn left.

import { make } from "./dom.js";
import { keptNames, withStations } from "./review_document.js";

const HALVES = ["aft", "fore"];

export function stationEditor(app) {
  const aftSide = app.stations.aft_side;
  return make(
    "details",
    { open: app.editingStations, ontoggle: (event) => (app.editingStations = event.target.open) },
    make("summary", { "data-key": "edit stations" }, "Edit the list"),
    ...HALVES.flatMap((half) => [
      field(`${half}, x in m from aft forward`, "list", half, app.stations[`${half}_stations_m`]),
      field(`${half}, names on the drawing (may be left empty)`, "names", half, app.stations[`${half}_station_names`]),
    ]),
    make(
      "p",
      { class: "row" },
      make(
        "button",
        { "data-key": "apply stations", id: "apply-stations", onclick: (event) => apply(app, event) },
        "Use these",
      ),
      make(
        "button",
        { "data-key": "swap sides", id: "swap-sides", onclick: () => swap(app) },
        `Aft half is drawn ${aftSide === "left" ? "right" : "left"}`,
      ),
    ),
  );
}

function field(label, what, half, values) {
  return make(
    "label",
    {},
    label,
    make(
      "textarea",
      {
        rows: 2,
        "data-key": `${what} ${half}`,
        [`data-${what}`]: half,
        spellcheck: "false",
        oninput: (event) => (event.target.dataset.dirty = ""),
      },
      values.join(", "),
    ),
  );
}

function apply(app, event) {
  const details = event.target.closest("details");
  const typed = (what, half, apart) => {
    const area = details.querySelector(`[data-${what}=${half}]`);
    delete area.dataset.dirty;
    return area.value
      .split(apart)
      .map((word) => word.trim())
      .filter(Boolean);
  };
  const before = app.stations;
  const changed = { aft_side: before.aft_side };
  for (const half of HALVES) changed[`${half}_stations_m`] = typed("list", half, /[\s,;]+/).map(Number);
  if (
    HALVES.some((half) => !changed[`${half}_stations_m`].length || changed[`${half}_stations_m`].some(Number.isNaN))
  ) {
    app.say("The lists of stations are numbers in metres, apart by commas.");
    return;
  }
  for (const half of HALVES) {
    const key = `${half}_station_names`;
    const names = typed("names", half, /[,;]+/);
    const untouched = names.join() === before[key].join();
    changed[key] = untouched ? keptNames(before, changed, half) : names;
  }
  app.change(withStations(app.document, changed), "change the stations");
}

function swap(app) {
  const aft_side = app.stations.aft_side === "left" ? "right" : "left";
  app.change(withStations(app.document, { ...app.stations, aft_side }), "swap the halves");
}

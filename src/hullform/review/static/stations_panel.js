// The stations of both halves: how many were expected and found, how sure each is, and what the drawing shows.

import { byId, make, redraw } from "./dom.js";
import { showStation } from "./doubtful.js";
import { sameStation } from "./layers.js";
import { corrections } from "./review_document.js";
import { stationEditor } from "./station_editor.js";

const WORDS = { sure: "sure", fair: "look at it", poor: "poor", missing: "not found" };

export function drawStations(app) {
  const halves = ["aft", "fore"].map((half) => drawHalf(app, half));
  const left = app.leftHalf;
  const columns = left === "aft" ? halves : halves.reverse();
  redraw(byId("stations-panel").querySelector(".body"), [
    make("div", { class: "halves" }, ...columns),
    make(
      "p",
      { class: "key" },
      ...Object.entries(WORDS).map(([standing, words]) => make("span", { class: `swatch ${standing}` }, words)),
    ),
    stationEditor(app),
  ]);
}

function drawHalf(app, half) {
  const read = app.reading?.halves.find((one) => one.half === half);
  const listed = app.stations[`${half}_stations_m`];
  const rows = read?.stations ?? listed.map((x_m) => ({ x_m, name: "", standing: "missing", shared_with_m: [] }));
  const marked = new Set(
    corrections(app.document)
      .filter((one) => one.half === half && (one.kind === "mark" || one.kind === "drawn"))
      .map((one) => `${one.kind} ${one.station_m}`),
  );
  const all = read && read.found === read.expected;
  return make(
    "div",
    { class: "half" },
    make(
      "h3",
      {},
      `${half} (${half === app.leftHalf ? "left" : "right"})`,
      make(
        "span",
        { class: `count${all ? "" : " short"}`, "data-count": half },
        read ? `${read.found} of ${read.expected}` : "–",
      ),
    ),
    make(
      "p",
      { class: "columns", "aria-hidden": "true" },
      make("span", {}, rows.some((row) => row.name) ? "name, x" : "x, m"),
      make("span", { title: "distance from the line, px" }, "px"),
      make("span", { title: "confidence" }, "%"),
    ),
    make("ul", { "data-scroll": half }, ...rows.map((row) => make("li", {}, button(app, half, row, marked)))),
    sharing(rows),
  );
}

// Stations that share a curve were not seen one by one: that they lie in the parallel body is what the list says.
function sharing(rows) {
  const shared = rows.filter((row) => row.shared_with_m.length);
  if (!shared.length) return null;
  const first = (row) => Math.min(row.x_m, ...row.shared_with_m);
  const curves = new Set(shared.map(first)).size;
  const words = curves === 1 ? "one curve" : `${curves} curves`;
  return make(
    "p",
    { class: "sharing", title: "Stations of a parallel body are drawn as one curve. Are these in it?" },
    `= ${shared.length} stations share ${words}`,
  );
}

function button(app, half, row, marked) {
  const station = { half, x_m: row.x_m };
  const chosen = sameStation(station, app.station);
  const sure = row.confidence === null || row.confidence === undefined ? "" : `${Math.round(100 * row.confidence)}`;
  const sign = marked.has(`drawn ${row.x_m}`) ? "✎" : marked.has(`mark ${row.x_m}`) ? "●" : "";
  const facts = [
    WORDS[row.standing],
    sure ? `confidence ${sure} %` : "",
    row.residual_px ? `${row.residual_px.toFixed(2)} px from the line` : "",
    row.shared_with_m.length ? `one curve with ${row.shared_with_m.join(", ")}` : "",
    row.curves > 1 ? "two contours" : "",
  ].filter(Boolean);
  return make(
    "button",
    {
      class: `station ${row.standing}${chosen ? " chosen" : ""}`,
      "data-key": `${half}:${row.x_m}`,
      "data-station": `${half}:${row.x_m}`,
      "aria-pressed": String(chosen),
      title: facts.join("; "),
      onclick: () => {
        app.selectStation(station);
        showStation(app, station);
      },
      ondblclick: () => showStation(app, station, true),
    },
    make("span", { class: "swatch", "aria-label": WORDS[row.standing] }),
    make("span", { class: "name" }, row.name || `${row.x_m}`, row.name ? make("small", {}, `${row.x_m}`) : null),
    make("span", { class: "with" }, row.shared_with_m.length ? "=" : "", row.curves > 1 ? "2" : "", sign),
    make("span", { class: "residual" }, row.residual_px ? row.residual_px.toFixed(1) : ""),
    make("span", { class: "sure" }, sure),
  );
}

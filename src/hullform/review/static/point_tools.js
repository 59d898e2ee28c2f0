// Tools of one or two clicks: mark, delete, cut, join, cross, run together, knuckle.

import { shape } from "./dom.js";
import { without, withCorrection, withOnly } from "./review_document.js";
import { grabPoint } from "./vertices.js";

const ring = (px, kind) => shape("circle", { cx: px[0], cy: px[1], r: 0, class: `preview-point ${kind}` });

function onePoint(kind, key, name, title, hint) {
  return {
    id: kind,
    key,
    name,
    title,
    hint: () => hint,
    grab: grabPoint,
    click(app, px, event) {
      app.change(withCorrection(app.document, { kind, px: app.snap(px, event) }), title.toLowerCase());
    },
  };
}

function twoPoints(kind, key, name, title, hints) {
  return {
    id: kind,
    key,
    name,
    title,
    first: null,
    hint() {
      return this.first ? hints[1] : hints[0];
    },
    grab: grabPoint,
    leave() {
      this.first = null;
    },
    cancel(app) {
      this.first = null;
      app.changed("preview");
    },
    click(app, px, event) {
      const at = app.snap(px, event);
      if (this.first === null) {
        this.first = at;
        app.changed("preview");
        app.say("");
        return;
      }
      const pair = [this.first, at];
      this.first = null;
      app.change(withCorrection(app.document, { kind, px: pair }), title.toLowerCase());
    },
    preview(app) {
      if (this.first === null) return [];
      const [u, v] = app.pointer ?? this.first;
      return [shape("path", { d: `M${this.first}L${[u, v]}`, class: `correction ${kind}` }), ring(this.first, kind)];
    },
  };
}

export const deleteTool = onePoint(
  "delete",
  "x",
  "Delete run",
  "Delete a run",
  "Click a line that is no station's; no curve will run along it.",
);
export const cutTool = onePoint(
  "cut",
  "c",
  "Cut",
  "Cut a curve",
  "Click where a curve must end; what lies before and behind become two.",
);
export const crossTool = onePoint(
  "cross",
  "o",
  "Cross",
  "These two cross",
  "Click where two curves cross; each will go straight on.",
);
export const knuckleTool = onePoint(
  "knuckle",
  "k",
  "Knuckle",
  "Mark a knuckle",
  "Click a corner of a curve; it will not be rounded.",
);
export const joinTool = twoPoints("join", "j", "Join", "Join two pieces", [
  "Click the end of one piece.",
  "Now click the end of the piece that goes on from it. Esc forgets the first.",
]);
export const togetherTool = twoPoints("together", "t", "Together", "These run together", [
  "Click where several curves come together on one line.",
  "Now click where they part. Esc forgets the first.",
]);

// The station after this one in the list of its half, then in the other half; null after the last.
export function stationAfter(app, { half, x_m }) {
  const all = ["aft", "fore"].flatMap((name) =>
    app.stations[`${name}_stations_m`].map((x) => ({ half: name, x_m: x })),
  );
  const at = all.findIndex((one) => one.half === half && Math.abs(one.x_m - x_m) < 1e-3);
  return all[at + 1] ?? null;
}

export function needsStation(app, px) {
  if (!app.station) return "Choose a station in the list first, or press N for the next doubtful one.";
  const half = app.halfAt(px);
  const slack = 0.01 * app.ship.breadth_m;
  if (half !== app.station.half && Math.abs(app.metresAt(px)[0]) > slack) {
    const name = app.nameOf(app.station);
    return `Station ${name} is of the ${app.station.half} half, but you clicked in the ${half} half.`;
  }
  return null;
}

export const markTool = {
  id: "mark",
  key: "m",
  name: "Mark",
  title: "Mark a station",
  grab: grabPoint,
  hint(app) {
    const { station } = app;
    if (!station) return "Choose a station in the list, then click its curve.";
    const which = app.secondContour ? "second contour" : "curve";
    const named = `${app.nameOf(station)} (${station.half})`;
    return `Click the ${which} of station ${named}; the next station follows by itself.`;
  },
  enter(app) {
    if (!app.station) app.station = { half: "aft", x_m: app.stations.aft_stations_m[0] };
  },
  click(app, px, event) {
    const missing = needsStation(app, px);
    if (missing) {
      app.say(missing);
      return;
    }
    const { half, x_m } = app.station;
    const mark = { kind: "mark", station_m: x_m, half, px: app.snap(px, event), curve: app.secondContour ? 1 : 0 };
    const next = stationAfter(app, app.station);
    app.change(withOnly(app.document, mark), `mark station ${app.nameOf({ half, x_m })}`);
    if (!app.secondContour && next) app.selectStation(next);
  },
};

export function deleteSelected(app) {
  const one = app.selectedCorrection;
  if (one) app.change(without(app.document, one.id), `remove ${one.kind}`);
}

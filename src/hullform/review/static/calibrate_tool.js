// Calibration in the picture: drag the lines that carry the scale, or click points that are known.

import { dragged, figuresOf } from "./calibration.js";
import { distance, mapped } from "./geometry.js";
import { withCalibration } from "./review_document.js";
import { gridSpacing } from "./layers.js";

const REACH_PX = 14; // of the screen

// The handles stand where nothing else is: on the lines' ends and clear of the keel.
function places({ breadth_m, depth_m }) {
  const half = breadth_m / 2;
  return {
    "centre line": [0, 0.62 * depth_m],
    "base line": [0.3 * half, 0],
    turn: [-0.7 * half, 0],
    "B/2": [half, 0.4 * depth_m],
    "B/2 left": [-half, 0.4 * depth_m],
    depth: [0.3 * half, depth_m],
  };
}

export const calibrateTool = {
  id: "calibrate",
  key: "b",
  name: "Calibrate",
  title: "Calibrate by hand",
  pointMode: false,
  points: [], // known points, while there are too few for a scale
  hint() {
    return this.pointMode
      ? "Click places whose half-breadth and height you know, and type these at the side: two, better four to eight."
      : "Drag the centre line, base line, B/2 and depth onto those of the drawing; the ring called turn turns them.";
  },
  setPointMode(app, on) {
    this.pointMode = on;
    this.points = on ? (app.document.calibration?.points ?? []) : [];
    app.changed();
  },
  enter(app) {
    this.setPointMode(app, this.pointMode || Boolean(app.document.calibration?.points?.length));
  },
  handles(app) {
    if (this.pointMode) return this.points.map((point, index) => ({ px: point.px, name: `${index + 1}` }));
    const matrix = app.calibration.pixel_from_metres;
    return Object.entries(places(app.ship)).map(([name, metres]) => ({ px: mapped(matrix, metres), name }));
  },
  grab(app, px) {
    const reach = REACH_PX / app.viewport.scale;
    const held = this.handles(app).find((handle) => distance(handle.px, px) < reach);
    if (!held) return null;
    return this.pointMode ? grabKnownPoint(app, Number(held.name) - 1) : grabLine(app, held.name);
  },
  click(app, px) {
    if (!this.pointMode) return;
    const [y, z] = app.metresAt(px);
    const [across, up] = gridSpacing(app);
    const rounded = (value, step) => Math.round(value / (step / 2)) * (step / 2);
    const at = px.map(to(2));
    this.setPoints(app, [...this.points, { px: at, m: [rounded(y, across), rounded(z, up)] }], "a known point");
  },
  setPoints(app, points, what) {
    this.points = points;
    if (points.length > 1) app.change(withCalibration(app.document, { points }), what);
    else if (app.document.calibration?.points) app.change(withCalibration(app.document, null), what);
    else app.changed();
  },
  // after undo and redo the points are those of the review
  follow(app) {
    const given = app.document.calibration?.points;
    if (given?.length) this.points = given;
    else if (this.points.length > 1) this.points = [];
  },
};

function grabLine(app, name) {
  const before = figuresOf(app.calibration);
  const handle = name === "B/2 left" ? "B/2" : name;
  return {
    move(px) {
      app.draft = dragged(before, handle, px, app.ship);
      app.changed("calibration");
    },
    drop() {
      app.change(withCalibration(app.document, rounded(app.draft)), `drag the ${handle}`);
    },
    cancel() {
      app.draft = null;
      app.changed("calibration");
    },
  };
}

function grabKnownPoint(app, index) {
  const before = calibrateTool.points;
  let points = before;
  return {
    move(px) {
      points = before.map((point, at) => (at === index ? { ...point, px: px.map(to(2)) } : point));
      calibrateTool.points = points;
      app.changed("preview");
    },
    drop() {
      calibrateTool.setPoints(app, points, "move a known point");
    },
    cancel() {
      calibrateTool.points = before;
      app.changed("preview");
    },
  };
}

const to = (places) => (value) => Number(value.toFixed(places));

function rounded({ centreline_px, baseline_px, metres_per_px, rotation_deg }) {
  return {
    centreline_px: to(2)(centreline_px),
    baseline_px: to(2)(baseline_px),
    metres_per_px: Number(metres_per_px.toPrecision(8)),
    rotation_deg: to(4)(rotation_deg),
  };
}

// The calibration in figures: what was found, given or dragged, whether a person confirmed it, and known points.

import { calibrateTool } from "./calibrate_tool.js";
import { confirmed, figuresOf } from "./calibration.js";
import { byId, make, numberInput, redraw } from "./dom.js";
import { gridSpacing } from "./layers.js";
import { withCalibration } from "./review_document.js";

const FIGURES = [
  ["centreline_px", "centre line", "px", 0.5, 2],
  ["baseline_px", "base line", "px", 0.5, 2],
  ["metres_per_px", "scale", "m/px", 0.00001, 6],
  ["rotation_deg", "turned by", "°", 0.05, 3],
];

export function drawCalibration(app) {
  const { calibration } = app;
  const given = app.document.calibration;
  const status = given ? "confirmed here" : app.ship.calibrated ? "given in ship.toml" : "found, not confirmed";
  redraw(byId("calibration-panel").querySelector(".body"), [
    make(
      "p",
      { class: `status ${given ? "good" : "open"}`, id: "calibration-status" },
      status,
      calibration.residual_px ? `; misfit ${calibration.residual_px.toFixed(2)} px` : "",
    ),
    make("div", { class: "figures" }, ...FIGURES.map((figure) => row(app, calibration, figure))),
    grid(app),
    make("p", { class: "source" }, calibration.source ?? ""),
    make(
      "p",
      { class: "row" },
      make(
        "button",
        {
          id: "confirm",
          "data-key": "confirm",
          class: given ? "" : "main",
          disabled: !app.reading || Boolean(given),
          onclick: () => confirm(app),
        },
        "Confirm",
      ),
      make(
        "button",
        { "data-key": "forget", disabled: !given, onclick: () => forget(app) },
        app.ship.calibrated ? "As in ship.toml" : "Find it again",
      ),
      make(
        "button",
        {
          "data-key": "points",
          "aria-pressed": String(app.tool === calibrateTool && calibrateTool.pointMode),
          onclick: () => {
            const on = !(app.tool === calibrateTool && calibrateTool.pointMode);
            if (app.tool !== calibrateTool) app.choose(calibrateTool);
            calibrateTool.setPointMode(app, on);
          },
        },
        "Known points",
      ),
    ),
    calibrateTool.pointMode && app.tool === calibrateTool ? points(app) : null,
  ]);
}

function confirm(app) {
  const kept = confirmed(app.reading.calibration, app.ship);
  app.change(withCalibration(app.document, kept), "confirm the calibration");
}

function forget(app) {
  calibrateTool.points = [];
  app.change(withCalibration(app.document, null), "forget the calibration");
}

function row(app, calibration, [name, label, unit, step, places]) {
  const report = (value) =>
    app.change(withCalibration(app.document, { ...figuresOf(app.calibration), [name]: value }), `set the ${label}`);
  const value = Number(calibration[name].toFixed(places));
  return make("label", {}, label, numberInput(`figure ${name}`, label, value, step, report), make("span", {}, unit));
}

function grid(app) {
  const spacing = gridSpacing(app);
  const set = (at) => (value) => {
    if (value <= 0) return;
    app.gridSpacing = gridSpacing(app).map((old, index) => (index === at ? value : old));
    app.changed();
  };
  const found = app.calibration.grid_m ? "found" : "shown";
  return make(
    "div",
    { class: "grid-row" },
    `grid ${found}, m`,
    numberInput("grid across", "spacing of the buttocks in metres", Number(spacing[0].toFixed(4)), 0.1, set(0)),
    "by",
    numberInput("grid up", "spacing of the waterlines in metres", Number(spacing[1].toFixed(4)), 0.1, set(1)),
  );
}

function points(app) {
  const list = calibrateTool.points;
  if (!list.length)
    return make("p", { class: "quiet" }, "No point yet: click one in the picture. y is negative in the left half.");
  const set = (index, axis) => (value) => {
    const changed = calibrateTool.points.map((point, at) =>
      at === index ? { ...point, m: point.m.map((old, which) => (which === axis ? value : old)) } : point,
    );
    calibrateTool.setPoints(app, changed, "set a known point");
  };
  return make(
    "ol",
    { class: "points" },
    ...list.map((point, index) =>
      make(
        "li",
        {},
        make("span", {}, `${point.px.map((value) => value.toFixed(0)).join(", ")} px`),
        "y",
        numberInput(
          `point ${index} y`,
          `half-breadth of point ${index + 1} in metres`,
          point.m[0],
          "any",
          set(index, 0),
        ),
        "z",
        numberInput(`point ${index} z`, `height of point ${index + 1} in metres`, point.m[1], "any", set(index, 1)),
        make(
          "button",
          {
            "aria-label": `Remove point ${index + 1}`,
            "data-key": `point ${index} gone`,
            class: "small",
            onclick: () =>
              calibrateTool.setPoints(
                app,
                calibrateTool.points.filter((_, at) => at !== index),
                "remove a known point",
              ),
          },
          "×",
        ),
      ),
    ),
  );
}

// The tool for looking: click a curve or a correction to select it, drag points of corrections, drag the picture.

import { nearestLine } from "./geometry.js";
import { changePoints, grabPoint, lineAt, pointAt } from "./vertices.js";

const REACH_PX = 8; // of the screen

export const selectTool = {
  id: "select",
  key: "v",
  name: "Select",
  title: "Select and move",
  hint(app) {
    const one = app.selectedCorrection;
    if (one) return `Drag its points; Delete removes the ${one.kind}; a double click on its line adds a point.`;
    return "Click a curve or a correction. Drag to move the picture, wheel to zoom.";
  },
  grab: grabPoint,
  click(app, px) {
    const correction = pointAt(app, px) ?? lineAt(app, px);
    if (correction) {
      app.selectCorrection(correction.correction.id);
      return;
    }
    const found = nearestLine(px, app.reading?.curves ?? [], REACH_PX / app.viewport.scale);
    if (!found) {
      app.selectStation(null);
      return;
    }
    const { half, stations_m } = found.line;
    // clicking a shared curve again goes on to the next of its stations
    const at = app.station?.half === half ? stations_m.findIndex((x) => Math.abs(x - app.station.x_m) < 1e-3) : -1;
    app.selectStation({ half, x_m: stations_m[(at + 1) % stations_m.length] });
  },
  double: changePoints,
  cancel(app) {
    app.selectStation(null);
  },
};

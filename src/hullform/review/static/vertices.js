// The points of corrections, to be dragged; those of lines can be added and taken away.

import { distance, nearestOnLine } from "./geometry.js";
import { lineOf } from "./glyphs.js";
import { corrections, pointsOf, withPoint, withReplaced } from "./review_document.js";

const REACH_PX = 9; // of the screen
const FEWEST = { drawn: 2, deck: 2, ignore: 3 };

// The point of a correction under the pointer; points of the selected one first.
export function pointAt(app, px) {
  let best = null;
  for (const one of corrections(app.document)) {
    pointsOf(one).forEach((point, index) => {
      const far = distance(point, px) * app.viewport.scale - (one.id === app.correction ? 3 : 0);
      if (far < REACH_PX && far < (best?.far ?? Infinity)) best = { far, correction: one, index };
    });
  }
  return best;
}

// The line of a correction under the pointer.
export function lineAt(app, px) {
  let best = null;
  for (const one of corrections(app.document)) {
    const points = pointsOf(one);
    if (points.length < 2) continue;
    const line = lineOf(one);
    const found = nearestOnLine(px, one.kind === "ignore" ? [...line, line[0]] : line);
    const far = found.distance * app.viewport.scale;
    if (far < REACH_PX && far < (best?.far ?? Infinity)) best = { far, correction: one };
  }
  return best;
}

export function grabPoint(app, px) {
  const found = pointAt(app, px);
  if (!found) return null;
  let { correction } = found;
  return {
    move(to, event) {
      // only now: a mere click there is the tool's, for the station that is chosen
      if (app.correction !== correction.id) app.selectCorrection(correction.id);
      correction = withPoint(correction, found.index, app.snap(to, event));
      app.tentative = withReplaced(app.history.document, correction);
      app.changed("preview");
    },
    drop() {
      app.tentative = null;
      app.change(withReplaced(app.document, correction), `move a point of ${correction.kind}`);
    },
    cancel() {
      app.tentative = null;
      app.changed("preview");
    },
  };
}

// A double click takes a point of a line away, or adds one where there is none.
export function changePoints(app, px, event) {
  const point = pointAt(app, px);
  if (point) {
    const { kind } = point.correction;
    const points = pointsOf(point.correction);
    if (!(kind in FEWEST) || points.length <= FEWEST[kind]) return false;
    const fewer = points.filter((_, index) => index !== point.index);
    app.change(withReplaced(app.document, { ...point.correction, px: fewer }), `take a point from ${kind}`);
    return true;
  }
  const line = lineAt(app, px);
  if (!line || !(line.correction.kind in FEWEST)) return false;
  const points = pointsOf(line.correction);
  const { index } = nearestOnLine(px, line.correction.kind === "ignore" ? [...points, points[0]] : points);
  const more = [...points.slice(0, index + 1), app.snap(px, event), ...points.slice(index + 1)];
  app.change(withReplaced(app.document, { ...line.correction, px: more }), `add a point to ${line.correction.kind}`);
  return true;
}

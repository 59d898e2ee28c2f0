// How each correction is drawn over the picture, in its pixels.

import { pathOf, shape } from "./dom.js";
import { smoothThrough } from "./geometry.js";
import { pointsOf } from "./review_document.js";

const CLOSED = new Set(["ignore"]);
export const LINED = new Set(["drawn", "deck", "ignore", "join", "together"]);

export function lineOf(correction) {
  const points = pointsOf(correction);
  return correction.kind === "drawn" && correction.smooth !== false ? smoothThrough(points) : points;
}

export function correctionShapes(correction, chosen) {
  if (!LINED.has(correction.kind)) return [];
  return [
    shape("path", {
      d: pathOf(lineOf(correction), CLOSED.has(correction.kind)),
      class: `correction ${correction.kind}${chosen ? " chosen" : ""}`,
    }),
  ];
}

// The sign at each place of a correction, about 0, 0 in pixels of the screen.
const SIGNS = {
  mark: "M-5 0A5 5 0 1 1 5 0A5 5 0 1 1 -5 0M-1 0H1",
  delete: "M-5-5L5 5M5-5L-5 5",
  cut: "M-6 0H6M0-2V2",
  join: "M-4 0A4 4 0 1 1 4 0A4 4 0 1 1 -4 0",
  cross: "M-6-6L6 6M-6 6L6-6M-6 0A6 6 0 1 1 6 0A6 6 0 1 1 -6 0",
  together: "M-5-3H5M-5 0H5M-5 3H5",
  drawn: "M-4-4H4V4H-4Z",
  deck: "M-4-4H4V4H-4Z",
  knuckle: "M-6 4L0-5L6 4",
  ignore: "M-4-4H4V4H-4Z",
};

export const signOf = (kind) => SIGNS[kind];

// The calibration as figures and as a map from metres [y, z] (y negative in the left half) to pixels.

import { distance, inverse, mapped } from "./geometry.js";

const SAME_PX = 0.05; // between the corners of two maps that are one to the eye

export function matrixOf({ centreline_px, baseline_px, metres_per_px, rotation_deg }) {
  const turn = (rotation_deg * Math.PI) / 180;
  const [across, down] = [Math.cos(turn) / metres_per_px, -Math.sin(turn) / metres_per_px];
  return [
    [across, down, centreline_px],
    [down, -across, baseline_px],
    [0, 0, 1],
  ];
}

const FIGURES = ["centreline_px", "baseline_px", "metres_per_px", "rotation_deg"];

export const figuresOf = (calibration) => Object.fromEntries(FIGURES.map((name) => [name, calibration[name]]));

// A start where nothing was found: the ship in the middle of the picture.
export const assumed = (picture, ship) => ({
  centreline_px: picture.width_px / 2,
  baseline_px: 0.85 * picture.height_px,
  metres_per_px: ship.breadth_m / (0.8 * picture.width_px),
  rotation_deg: 0,
});

export const corners = ({ breadth_m, depth_m }) => [
  [-breadth_m / 2, 0],
  [breadth_m / 2, 0],
  [breadth_m / 2, depth_m],
  [-breadth_m / 2, depth_m],
];

// What confirms a calibration as it stands: its four figures, or four points where it has perspective or a stretch.
export function confirmed(calibration, ship) {
  const figures = figuresOf(calibration);
  const plain = matrixOf(figures);
  const exact = corners(ship).map((m) => mapped(calibration.pixel_from_metres, m));
  const apart = corners(ship).map((m, index) => distance(mapped(plain, m), exact[index]));
  if (Math.max(...apart) < SAME_PX) return figures;
  const rounded = (px) => px.map((value) => Math.round(value * 1000) / 1000);
  return { points: corners(ship).map((m, index) => ({ px: rounded(exact[index]), m })) };
}

// What the figures become when the handle of that name is dragged to a pixel.
export function dragged(figures, name, px, ship) {
  const [y, z] = mapped(inverse(matrixOf(figures)), px);
  const origin = [figures.centreline_px, figures.baseline_px];
  const moved = (metres) => {
    const [u, v] = mapped(matrixOf(figures), metres);
    return { ...figures, centreline_px: u, baseline_px: v };
  };
  if (name === "centre line") return moved([y, 0]);
  if (name === "base line") return moved([0, z]);
  if (name === "turn") {
    const side = px[0] < origin[0] ? -1 : 1;
    const turn = Math.atan2(-side * (px[1] - origin[1]), side * (px[0] - origin[0]));
    return { ...figures, rotation_deg: (turn * 180) / Math.PI };
  }
  const [is, means] = name === "depth" ? [z, ship.depth_m] : [Math.abs(y), ship.breadth_m / 2];
  return is > 0.05 * means ? { ...figures, metres_per_px: (figures.metres_per_px * means) / is } : figures;
}

// A spacing that makes some eight lines over a length.
export function roundSpacing(length) {
  const rough = length / 8;
  const power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map((n) => n * power).find((n) => n >= rough);
}

// What is drawn over the picture in its own pixels: the predicted grid and lines, curves, unused lines, the sheer.

import { byId, pathOf, shape } from "./dom.js";
import { mapped } from "./geometry.js";
import { roundSpacing } from "./calibration.js";
import { correctionShapes } from "./glyphs.js";

const REACH = 1.04; // of B/2: how far the lines of the frame are drawn

export const sameStation = (a, b) => a && b && a.half === b.half && Math.abs(a.x_m - b.x_m) < 1e-3;

export class Layers {
  constructor(app) {
    this.app = app;
    this.world = shape("g", { id: "world" });
    this.parts = Object.fromEntries(
      ["grid", "frame", "lines", "sheer", "curves", "corrections", "preview"].map((name) => [
        name,
        shape("g", { class: name }),
      ]),
    );
    this.world.append(...Object.values(this.parts));
    byId("overlay").append(this.world);
  }

  place() {
    const { scale, left, top } = this.app.viewport;
    this.world.setAttribute("transform", `matrix(${scale} 0 0 ${scale} ${left + scale / 2} ${top + scale / 2})`);
  }

  draw() {
    const { app, parts } = this;
    for (const [name, shown] of Object.entries(app.shown)) parts[name].toggleAttribute("hidden", !shown);
    parts.grid.replaceChildren(...this.#grid());
    parts.frame.replaceChildren(...this.#frame());
    parts.lines.replaceChildren(...(app.reading?.unused ?? []).map((line) => shape("path", { d: pathOf(line.px) })));
    parts.sheer.replaceChildren(
      ...Object.values(app.reading?.sheer ?? {}).map((px) => shape("path", { d: pathOf(px) })),
    );
    parts.curves.replaceChildren(...(app.reading?.curves ?? []).flatMap((curve) => this.#curve(curve)));
    this.drawCorrections();
  }

  drawCorrections() {
    const { app, parts } = this;
    parts.corrections.replaceChildren(
      ...(app.document.corrections ?? []).flatMap((one) => correctionShapes(one, one.id === app.correction)),
    );
    this.drawPreview();
  }

  drawPreview() {
    this.parts.preview.replaceChildren(...(this.app.tool?.preview?.(this.app) ?? []));
  }

  #curve(curve) {
    const { app } = this;
    const chosen = curve.stations_m.some((x_m) => sameStation({ half: curve.half, x_m }, app.station));
    const d = pathOf(curve.px);
    return [
      chosen ? shape("path", { d, class: "halo" }) : null,
      shape("path", { d, class: `curve ${curve.standing}${chosen ? " chosen" : ""}` }),
    ].filter(Boolean);
  }

  #segment(from, to, attributes = {}) {
    const matrix = this.app.calibration.pixel_from_metres;
    return shape("path", { d: pathOf([mapped(matrix, from), mapped(matrix, to)]), ...attributes });
  }

  #grid() {
    const { breadth_m, depth_m } = this.app.ship;
    const [across, up] = gridSpacing(this.app);
    const out = [];
    for (let n = 1; n * across < breadth_m / 2 - 1e-9; n += 1) {
      for (const side of [-1, 1]) out.push(this.#segment([side * n * across, 0], [side * n * across, depth_m]));
    }
    for (let n = 1; n * up < depth_m - 1e-9; n += 1) {
      out.push(this.#segment([-breadth_m / 2, n * up], [breadth_m / 2, n * up]));
    }
    return out;
  }

  #frame() {
    const { breadth_m, depth_m, draught_m } = this.app.ship;
    const reach = (REACH * breadth_m) / 2;
    const low = -0.03 * depth_m;
    return [
      this.#segment([0, low], [0, depth_m], { class: "centre" }),
      ...[-1, 1].map((side) => this.#segment([(side * breadth_m) / 2, low], [(side * breadth_m) / 2, depth_m])),
      this.#segment([-reach, 0], [reach, 0], { class: "base" }),
      this.#segment([-reach, depth_m], [reach, depth_m]),
      this.#segment([-reach, draught_m], [reach, draught_m], { class: "draught" }),
    ];
  }
}

export function gridSpacing(app) {
  const { breadth_m, depth_m } = app.ship;
  return (
    app.gridSpacing ?? app.calibration.grid_m ?? app.gridFound ?? [roundSpacing(breadth_m / 2), roundSpacing(depth_m)]
  );
}

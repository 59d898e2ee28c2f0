// A lens in the corner: the picture about the pointer, enlarged, with the curves.

import { byId } from "./dom.js";
import { curveColour } from "./colours.js";

const ENLARGED = 3; // times as on the screen, but never less than
const LEAST_SCALE = 5; // screen pixels a pixel of the picture

export class Loupe {
  constructor(app) {
    this.app = app;
    this.canvas = byId("loupe");
    this.picture = byId("picture");
    this.paths = [];
    this.version = -1;
  }

  draw() {
    const { app, canvas } = this;
    const shown = app.pointer !== null && app.tool?.loupe !== false && app.viewport.scale < 12;
    canvas.hidden = !shown;
    if (!shown || !this.picture.complete || !this.picture.naturalWidth) return;
    // on the side where the pointer is not, so that it never hides what is pointed at
    canvas.classList.toggle("right", app.viewport.toScreen(app.pointer)[0] < app.viewport.window[0] / 2);
    this.#collect();
    const size = canvas.width;
    const scale = Math.max(LEAST_SCALE, ENLARGED * app.viewport.scale);
    const reach = size / scale / 2;
    const [u, v] = app.pointer;
    const stored = this.picture.naturalWidth / app.picture.width_px;
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = "#fff";
    context.fillRect(0, 0, size, size);
    context.imageSmoothingEnabled = false;
    const [left, top] = [(u + 0.5 - reach) * stored, (v + 0.5 - reach) * stored];
    context.drawImage(this.picture, left, top, 2 * reach * stored, 2 * reach * stored, 0, 0, size, size);
    context.setTransform(scale, 0, 0, scale, size / 2 - scale * u, size / 2 - scale * v);
    context.lineWidth = 1.4 / scale;
    for (const { path, colour } of app.shown.curves ? this.paths : []) {
      context.strokeStyle = colour;
      context.stroke(path);
    }
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.strokeStyle = "rgba(20, 30, 40, 0.65)";
    context.lineWidth = 1;
    context.beginPath();
    for (const [x, y] of [
      [1, 0],
      [-1, 0],
      [0, 1],
      [0, -1],
    ]) {
      context.moveTo(size / 2 + 6 * x, size / 2 + 6 * y);
      context.lineTo(size / 2 + 22 * x, size / 2 + 22 * y);
    }
    context.stroke();
  }

  #collect() {
    const { app } = this;
    if (this.version === app.version) return;
    this.version = app.version;
    this.paths = (app.reading?.curves ?? []).map((curve) => {
      const path = new Path2D();
      curve.px.forEach(([u, v], index) => (index ? path.lineTo(u, v) : path.moveTo(u, v)));
      return { path, colour: curveColour(curve.standing) };
    });
  }
}

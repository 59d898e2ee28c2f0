// What keeps its size on the screen: names of curves, values of the frame's lines, signs and points of corrections.

import { byId, shape } from "./dom.js";
import { mapped } from "./geometry.js";
import { LINED, signOf } from "./glyphs.js";
import { sameStation } from "./layers.js";
import { pointsOf } from "./review_document.js";

const LETTER_PX = 6.6;
const HEIGHT_PX = 13;
const SHARES = [0.97, 0.9, 0.82, 0.74, 0.66, 0.58, 0.5, 0.42, 0.34, 0.26];

export class Labels {
  constructor(app) {
    this.app = app;
    this.names = shape("g", { class: "names" });
    this.signs = shape("g", { class: "signs" });
    byId("overlay").append(this.names, this.signs);
  }

  draw() {
    this.#draw(this.names, this.#names());
    this.#draw(this.signs, this.#signs());
  }

  #draw(group, children) {
    group.replaceChildren(...children);
  }

  #names() {
    const { app } = this;
    const taken = [];
    const out = this.#values(taken);
    if (!app.shown.curves) return out;
    const curves = [...(app.reading?.curves ?? [])];
    const chosen = (curve) => curve.stations_m.some((x_m) => sameStation({ half: curve.half, x_m }, app.station));
    // the chosen station's name has the first choice of a place
    curves.sort((a, b) => chosen(b) - chosen(a));
    for (const curve of curves) {
      const width = LETTER_PX * curve.label.length + 6;
      const place = this.#place(curve.px, width, taken);
      if (!place) continue;
      const text = shape("text", { x: place[0] + width / 2, y: place[1] + 4, "text-anchor": "middle" }, curve.label);
      text.classList.add(curve.standing);
      if (chosen(curve)) text.classList.add("chosen");
      out.push(text);
    }
    return out;
  }

  // The first place along a curve, from the deck down, that no other name has.
  #place(px, width, taken) {
    const { viewport } = this.app;
    for (const share of SHARES) {
      const [x, y] = viewport.toScreen(px[Math.round(share * (px.length - 1))]);
      for (const left of [x + 4, x - 4 - width]) {
        const box = [left, y - HEIGHT_PX / 2, left + width, y + HEIGHT_PX / 2];
        const [right, bottom] = viewport.window;
        if (box[0] < 0 || box[1] < 0 || box[2] > right || box[3] > bottom) continue;
        if (taken.some((other) => overlap(box, other))) continue;
        taken.push(box);
        return [left, y];
      }
    }
    return null;
  }

  #values(taken) {
    const { app } = this;
    if (!app.shown.grid) return [];
    const { breadth_m, depth_m, draught_m } = app.ship;
    const matrix = app.calibration.pixel_from_metres;
    const half = breadth_m / 2;
    const words = [
      [[-half * 1.04, 0], "BL 0", "end"],
      [[-half * 1.04, depth_m], draught_m === depth_m ? `D = T ${depth_m}` : `D ${depth_m}`, "end"],
      draught_m === depth_m ? null : [[-half * 1.04, draught_m], `T ${draught_m}`, "end"],
      [[0, -0.03 * depth_m], "CL", "middle"],
      [[-half, -0.03 * depth_m], `B/2 ${half}`, "middle"],
      [[half, -0.03 * depth_m], `B/2 ${half}`, "middle"],
    ].filter(Boolean);
    return words.map(([metres, text, anchor]) => {
      const [x, y] = app.viewport.toScreen(mapped(matrix, metres));
      const width = LETTER_PX * text.length;
      const left = Math.max(2, anchor === "end" ? x - 4 - width : x - width / 2);
      const down = anchor === "end" ? y + 4 : y + 13;
      taken.push([left, down - HEIGHT_PX, left + width, down + 2]);
      return shape("text", { x: left, y: down, class: "value" }, text);
    });
  }

  #signs() {
    const { app } = this;
    const out = [];
    for (const one of app.document.corrections ?? []) {
      for (const [index, px] of pointsOf(one).entries()) {
        const [x, y] = app.viewport.toScreen(px);
        const chosen =
          one.id === app.correction ||
          (one.station_m !== undefined && sameStation({ half: one.half, x_m: one.station_m }, app.station));
        out.push(
          shape("path", {
            d: signOf(one.kind),
            transform: `translate(${x} ${y}) scale(${chosen || !LINED.has(one.kind) ? 1 : 0.6})`,
            class: `sign ${one.kind}${chosen ? " chosen" : ""}`,
            "data-correction": one.id,
            "data-point": index,
          }),
        );
      }
    }
    for (const { px, name } of app.tool?.handles?.(app) ?? []) {
      const [x, y] = app.viewport.toScreen(px);
      out.push(shape("circle", { cx: x, cy: y, r: 7, class: "handle", "data-handle": name }));
      out.push(shape("text", { x: x + 11, y: y + 4, class: "handle-name" }, name));
    }
    return out;
  }
}

const overlap = (a, b) => a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];

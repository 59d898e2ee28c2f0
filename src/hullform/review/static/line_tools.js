// Tools of many clicks: a curve drawn by hand, the deck line, a region to ignore.

import { pathOf, shape } from "./dom.js";
import { distance, smoothThrough } from "./geometry.js";
import { needsStation, stationAfter } from "./point_tools.js";
import { withCorrection, withOnly } from "./review_document.js";
import { grabPoint } from "./vertices.js";

const CLOSE_PX = 8; // of the screen: a click so near to the first point of an outline closes it

// What all of them share: points gathered by clicks, Enter or a double click ends, Esc or Backspace takes back.
function gathering(tool) {
  return {
    points: [],
    grab(app, px) {
      return this.points.length ? null : grabPoint(app, px);
    },
    leave() {
      this.points = [];
    },
    cancel(app) {
      this.points = [];
      app.changed("preview");
    },
    back(app) {
      this.points = this.points.slice(0, -1);
      app.changed("preview");
      return true;
    },
    click(app, px, event) {
      const refused = this.refuses?.(app, px);
      if (refused) {
        app.say(refused);
        return;
      }
      const at = this.snaps === false ? px : app.snap(px, event);
      const last = this.points.at(-1);
      if (last && distance(last, at) * app.viewport.scale < 2) return;
      this.points = [...this.points, at];
      app.say("");
      app.changed("preview");
    },
    double(app) {
      this.finish(app);
      return true;
    },
    finish(app) {
      if (this.points.length < this.fewest) {
        app.say(`At least ${this.fewest} points are needed; there are ${this.points.length}.`);
        return;
      }
      const { points } = this;
      this.points = [];
      this.done(app, points);
    },
    preview(app) {
      const points = app.pointer && this.points.length ? [...this.points, app.pointer] : this.points;
      if (!points.length) return [];
      const line = this.smooths?.(app) ? smoothThrough(points) : points;
      return [shape("path", { d: pathOf(line, this.closed), class: `correction ${this.kind} preview-line` })];
    },
    handles() {
      return this.points.map((px, index) => ({ px, name: index === 0 && this.closed ? "close" : "" }));
    },
    ...tool,
  };
}

export const drawTool = gathering({
  id: "draw",
  key: "d",
  kind: "drawn",
  name: "Draw",
  title: "Draw a curve by hand",
  fewest: 2,
  smooth: true,
  hint(app) {
    const { station } = app;
    if (!station) return "Choose a station in the list, then click points along its curve from keel to deck.";
    const contour = app.secondContour ? "the second contour" : "the curve";
    const which = `${contour} of station ${app.nameOf(station)} (${station.half})`;
    const between = this.smooth ? "smooth" : "straight";
    return this.points.length
      ? `${this.points.length} points of ${which}. Enter ends, Backspace takes one back, Esc drops them.`
      : `Click points along ${which}, keel to deck, ${between} between them (L); 2: the other contour.`;
  },
  enter(app) {
    if (!app.station) app.station = { half: "aft", x_m: app.stations.aft_stations_m[0] };
  },
  // a bulb is drawn at the centre line, so the half of a click says nothing here but before the first point
  refuses(app, px) {
    return this.points.length ? null : needsStation(app, px);
  },
  smooths() {
    return this.smooth;
  },
  done(app, points) {
    const { half, x_m } = app.station;
    const drawn = {
      kind: "drawn",
      station_m: x_m,
      half,
      curve: app.secondContour ? 1 : 0,
      px: points,
      smooth: this.smooth,
    };
    app.change(withOnly(app.document, drawn), `draw station ${app.nameOf({ half, x_m })}`);
    const next = stationAfter(app, app.station);
    if (!app.secondContour && next) app.selectStation(next);
  },
});

export const deckTool = gathering({
  id: "deck",
  key: "e",
  kind: "deck",
  name: "Deck line",
  title: "Draw the deck edge",
  fewest: 2,
  hint() {
    return this.points.length
      ? `${this.points.length} points. Enter ends, Backspace takes one back, Esc drops them.`
      : "Click along the deck edge of one half, from the centre line outwards: every station ends there.";
  },
  done(app, points) {
    const half = app.halfAt(points.at(-1));
    app.change(withOnly(app.document, { kind: "deck", half, px: points }), `draw the ${half} deck line`);
  },
});

export const ignoreTool = gathering({
  id: "ignore",
  key: "i",
  kind: "ignore",
  name: "Ignore",
  title: "Ignore a region",
  fewest: 3,
  closed: true,
  snaps: false,
  box: null, // while one is being dragged
  hint() {
    return this.points.length
      ? `${this.points.length} corners. Enter or the first corner closes the outline, Esc drops it.`
      : "Drag a box, or click the corners of an outline: nothing inside is drawn by a station.";
  },
  // a drag that begins at no point of another correction is a box
  grab(app, px) {
    if (this.points.length) return null;
    const held = grabPoint(app, px);
    if (held) return held;
    const tool = this;
    return {
      move(to) {
        tool.box = [px, [to[0], px[1]], to, [px[0], to[1]]];
        app.changed("preview");
      },
      drop() {
        const { box } = tool;
        tool.box = null;
        tool.done(app, box);
      },
      cancel() {
        tool.box = null;
        app.changed("preview");
      },
    };
  },
  refuses(app, px) {
    const near = this.points.length > 2 && distance(this.points[0], px) * app.viewport.scale < CLOSE_PX;
    if (near) this.finish(app);
    return near ? " " : null;
  },
  preview(app) {
    const points = this.box ?? (this.points.length && app.pointer ? [...this.points, app.pointer] : this.points);
    if (!points.length) return [];
    return [shape("path", { d: pathOf(points, true), class: "correction ignore preview-line" })];
  },
  done(app, points) {
    const px = points.map((point) => point.map((value) => Math.round(value * 10) / 10));
    app.change(withCorrection(app.document, { kind: "ignore", px }), "ignore a region");
  },
});

// The state of the page: the review and its history, what was read of it, what is selected, and the tool in hand.

import * as api from "./api.js";
import { assumed, matrixOf } from "./calibration.js";
import { inverse, mapped, nearestLine } from "./geometry.js";
import { History } from "./history.js";
import { correctionById, keptNames } from "./review_document.js";

const SNAP_SCREEN_PX = 9; // a click so near to a line means the line,
const SNAP_PICTURE_PX = 12; // but never farther in the picture than this

export class App {
  constructor(opened, viewport) {
    this.ship = opened.ship;
    this.picture = opened.picture;
    this.reviewFile = opened.review_file;
    this.revision = opened.revision; // of the review file that this page goes on from
    this.overwrites = null; // the revision that a save would write over, where that is another
    this.viewport = viewport;
    this.history = new History(opened.review);
    this.reading = opened.reading;
    this.gridFound = opened.reading?.calibration.grid_m; // the last one: with known points none is looked for
    this.failure = opened.failure; // of the last reading
    this.unsaved = null; // why the last save failed
    this.version = 0;
    this.station = null; // { half, x_m }: the one that marks and drawn curves are for
    this.secondContour = false;
    this.correction = null; // id
    this.tool = null;
    this.pointer = null; // where the mouse is, in the picture
    this.tentative = null; // the review while a point of it is being dragged
    this.draft = null; // figures of a calibration that is being dragged
    this.snapping = true;
    this.shown = { curves: true, grid: true, lines: false };
    this.faded = true; // the picture, so that what is drawn over it stands out
    this.gridSpacing = null; // chosen by hand, [across, up] in metres
    this.message = "";
    this.noticeClosed = ""; // the words of the notice that was closed
    this.listeners = [];
    this.busy = false;
    this.again = false;
  }

  get document() {
    return this.tentative ?? this.history.document;
  }

  // The stations as the review has them; without names of its own each keeps the one of ship.toml.
  get stations() {
    const own = this.document.stations;
    if (!own) return this.ship.stations;
    const names = ["aft", "fore"].map((half) => [`${half}_station_names`, keptNames(this.ship.stations, own, half)]);
    return { ...own, ...Object.fromEntries(names) };
  }

  // What the drawing calls a station, else its x.
  nameOf({ half, x_m }) {
    const at = this.stations[`${half}_stations_m`].findIndex((x) => Math.abs(x - x_m) < 1e-3);
    return this.stations[`${half}_station_names`][at] ?? `${x_m}`;
  }

  get leftHalf() {
    return this.stations.aft_side === "left" ? "aft" : "fore";
  }

  // The calibration as it is now: being dragged, read, or assumed where none could be found.
  get calibration() {
    if (this.draft) return { ...this.draft, pixel_from_metres: matrixOf(this.draft), grid_m: null };
    if (this.reading) return this.reading.calibration;
    const figures = { ...assumed(this.picture, this.ship), ...this.document.calibration };
    return {
      ...figures,
      pixel_from_metres: matrixOf(figures),
      grid_m: null,
      residual_px: 0,
      source: "a guess to start from: nothing was found",
    };
  }

  get selectedCorrection() {
    return correctionById(this.document, this.correction);
  }

  on(listener) {
    this.listeners.push(listener);
  }

  // Redraws what hangs on the state; "pointer" and "view" are frequent and concern the picture alone.
  changed(what = "all") {
    for (const listener of this.listeners) listener(what);
  }

  say(message) {
    this.message = message;
    this.changed("status");
  }

  sideOf(half) {
    return half === this.leftHalf ? -1 : 1;
  }

  // [y, z] in metres of a pixel, y negative in the left half.
  metresAt(px) {
    return mapped(inverse(this.calibration.pixel_from_metres), px);
  }

  pixelAt(metres) {
    return mapped(this.calibration.pixel_from_metres, metres);
  }

  halfAt(px) {
    const left = this.metresAt(px)[0] < 0;
    return left ? this.leftHalf : this.leftHalf === "aft" ? "fore" : "aft";
  }

  // The place on the nearest line of the drawing, where the pointer means one; else the place itself.
  snap(px, event) {
    const plain = px.map((value) => Math.round(value * 100) / 100);
    if (!this.snapping || event?.altKey || !this.reading) return plain;
    const reach = Math.min(SNAP_PICTURE_PX, SNAP_SCREEN_PX / this.viewport.scale);
    const found = nearestLine(px, [...this.reading.curves, ...this.reading.unused], reach);
    return found ? found.point.map((value) => Math.round(value * 100) / 100) : plain;
  }

  rowOf({ half, x_m }) {
    const rows = this.reading?.halves.find((one) => one.half === half)?.stations ?? [];
    return rows.find((row) => Math.abs(row.x_m - x_m) < 1e-3);
  }

  curvesOf({ half, x_m }) {
    const curves = this.reading?.curves ?? [];
    return curves.filter((one) => one.half === half && one.stations_m.some((x) => Math.abs(x - x_m) < 1e-3));
  }

  selectStation(station) {
    this.station = station;
    this.correction = null;
    this.secondContour = false;
    this.changed();
  }

  selectCorrection(id) {
    this.correction = id;
    const found = this.selectedCorrection;
    if (found?.station_m !== undefined) this.station = { half: found.half, x_m: found.station_m };
    this.changed();
  }

  choose(tool) {
    this.tool?.leave?.(this);
    this.tool = tool;
    tool.enter?.(this);
    this.message = "";
    this.changed();
  }

  // One step of the history, and a new reading of the picture.
  change(document, what) {
    this.history.push(document, what);
    this.#follow();
  }

  undo() {
    this.history.undo();
    this.#follow();
  }

  redo() {
    this.history.redo();
    this.#follow();
  }

  #follow() {
    if (!this.selectedCorrection) this.correction = null;
    this.message = "";
    this.changed();
    this.solve();
  }

  // One call at a time: what changed meanwhile is read once, as it is then.
  async solve() {
    if (this.busy) {
      this.again = true;
      return;
    }
    this.busy = true;
    this.changed("status");
    do {
      this.again = false;
      const began = performance.now();
      try {
        this.reading = await api.solve(this.history.document);
        this.roundTripMs = performance.now() - began;
        this.failure = null;
        this.version += 1;
        this.gridFound = this.reading.calibration.grid_m ?? this.gridFound;
      } catch (error) {
        if (!(error instanceof api.Superseded)) this.failure = error.message;
      }
      if (!this.again) this.draft = null;
    } while (this.again);
    this.busy = false;
    this.changed();
  }

  async save() {
    const { document } = this.history;
    this.overwrites = null;
    try {
      const { file, revision } = await api.save(document, this.revision);
      this.history.markSaved(document);
      this.savedTo = file;
      this.revision = revision;
      this.unsaved = null;
    } catch (error) {
      this.unsaved = error.message;
      if (error instanceof api.ChangedMeanwhile) this.overwrites = error.revision;
    }
    this.noticeClosed = "";
    this.changed();
  }

  // Saves over what another page or program has saved meanwhile.
  saveOver() {
    this.revision = this.overwrites;
    return this.save();
  }
}

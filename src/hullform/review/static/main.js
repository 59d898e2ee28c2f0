// Starts the page: opens the review, builds its parts, and redraws those that a change concerns.

import * as api from "./api.js";
import { App } from "./app.js";
import { drawCalibration } from "./calibration_panel.js";
import { calibrateTool } from "./calibrate_tool.js";
import { drawCorrections } from "./corrections_panel.js";
import { byId } from "./dom.js";
import { nextDoubtful } from "./doubtful.js";
import { drawDoubts } from "./doubts_panel.js";
import { drawForm } from "./form_panel.js";
import { fillHelp, listenToKeys } from "./keyboard.js";
import { Labels } from "./labels.js";
import { Layers } from "./layers.js";
import { Loupe } from "./loupe.js";
import { listen } from "./pointer.js";
import { drawStations } from "./stations_panel.js";
import { drawNotice, drawStatus } from "./status.js";
import { drawStrip } from "./strip_panel.js";
import { drawTools, TOOLS } from "./tools.js";
import { Viewport } from "./viewport.js";

const stage = byId("stage");

// The picture is moved and drawn over once a frame, however many events ask for it.
function framed(draw) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      draw();
    });
  };
}

async function start() {
  let app = null;
  const viewport = new Viewport(stage, () => app?.changed("view"));
  app = new App(await api.opening(), viewport);
  const picture = byId("picture");
  picture.src = "/picture";
  picture.style.width = `${app.picture.width_px}px`;
  picture.style.height = `${app.picture.height_px}px`;
  viewport.size = [app.picture.width_px, app.picture.height_px];

  const layers = new Layers(app);
  const labels = new Labels(app);
  const loupe = new Loupe(app);
  const place = framed(() => {
    const { scale, left, top } = viewport;
    picture.style.transform = `translate(${left}px, ${top}px) scale(${scale})`;
    picture.classList.toggle("large", scale > 3);
    picture.classList.toggle("faded", app.faded);
    layers.place();
    labels.draw();
    loupe.draw();
    drawStatus(app);
  });
  const pointed = framed(() => {
    layers.drawPreview();
    loupe.draw();
    drawStatus(app);
  });
  const previewed = framed(() => {
    layers.drawCorrections();
    labels.draw();
    loupe.draw();
    drawStatus(app);
  });
  const recalibrated = framed(() => {
    layers.draw();
    labels.draw();
    drawCalibration(app);
  });
  const everything = () => {
    calibrateTool.follow(app);
    layers.draw();
    drawTools(app);
    for (const draw of [drawStations, drawForm, drawStrip, drawCalibration, drawCorrections, drawDoubts]) draw(app);
    drawActions(app);
    drawNotice(app);
    place();
    // the state is told after all that belongs to it is drawn
    document.body.dataset.state = app.busy ? "reading" : "ready";
  };
  const concerned = {
    view: place,
    pointer: pointed,
    preview: previewed,
    calibration: recalibrated,
    status: () => {
      drawStatus(app);
      drawNotice(app);
      document.body.dataset.state = app.busy ? "reading" : "ready";
    },
  };
  app.on((what) => (concerned[what] ?? everything)());

  byId("ship-name").textContent = app.ship.name;
  document.title = `Review: ${app.ship.name}`;
  byId("ship-figures").textContent = figures(app);
  listen(app, stage);
  listenToKeys(app);
  fillHelp();
  wireButtons(app);
  new ResizeObserver(place).observe(stage);
  addEventListener("beforeunload", (event) => {
    if (app.history.changed) event.preventDefault();
  });
  await picture.decode().catch(() => app.say("The picture could not be shown."));
  viewport.fit();
  app.choose(TOOLS[0]);
  globalThis.hullformReview = app;
}

function figures({ ship, picture }) {
  const { length_overall_m, breadth_m, depth_m, draught_m } = ship;
  const file = picture.file.split(/[\\/]/).at(-1);
  const ours = `LOA ${length_overall_m} m, B ${breadth_m} m, D ${depth_m} m, T ${draught_m} m`;
  return `${ours}; ${file}, ${picture.width_px} × ${picture.height_px} px`;
}

function wireButtons(app) {
  const buttons = {
    doubts: () => {
      const panel = byId("doubts-panel");
      panel.scrollIntoView({ block: "nearest" });
      panel.querySelector("ul")?.focus({ preventScroll: true });
    },
    worst: () => nextDoubtful(app),
    undo: () => app.undo(),
    redo: () => app.redo(),
    save: () => app.save(),
    "zoom-in": () => app.viewport.zoomAt(1.25),
    "zoom-out": () => app.viewport.zoomAt(0.8),
    fit: () => app.viewport.fit(),
  };
  for (const [id, act] of Object.entries(buttons)) byId(id).addEventListener("click", act);
}

function drawActions(app) {
  const { history } = app;
  byId("undo").disabled = !history.canUndo;
  byId("undo").title = history.canUndo ? `Undo: ${history.undoes} (Ctrl-Z)` : "Nothing to undo";
  byId("redo").disabled = !history.canRedo;
  byId("redo").title = history.canRedo ? `Redo: ${history.redoes} (Ctrl-Shift-Z)` : "Nothing to redo";
  byId("save").classList.toggle("unsaved", history.changed);
  byId("save").title = history.changed ? "Save the review (S): there are changes" : "All is saved";
}

start().catch((error) => {
  document.body.dataset.state = "failed";
  const notice = byId("notice");
  notice.hidden = false;
  notice.textContent = error.message;
});

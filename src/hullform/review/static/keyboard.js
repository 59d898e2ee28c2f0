// Keys: every tool and every button has one; while something is being typed they are letters.

import { byId, make } from "./dom.js";
import { nextDoubtful } from "./doubtful.js";
import { deleteSelected } from "./point_tools.js";
import { flip, TOGGLES, toggleByKey, TOOLS, toolByKey } from "./tools.js";

const STEP_PX = 60; // of the screen, by an arrow key
const ZOOM_STEP = 1.25;
const ARROWS = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const PLAIN = {
  "+": (app) => app.viewport.zoomAt(ZOOM_STEP),
  "=": (app) => app.viewport.zoomAt(ZOOM_STEP),
  "-": (app) => app.viewport.zoomAt(1 / ZOOM_STEP),
  0: (app) => app.viewport.fit(),
  n: nextDoubtful,
  s: (app) => app.save(),
  "?": () => byId("help").showModal(),
  Enter: (app) => app.tool.finish?.(app),
  Escape: (app) => (app.tool.cancel ? app.tool.cancel(app) : app.selectStation(null)),
  Delete: deleteSelected,
  Backspace: (app) => app.tool.back?.(app) || deleteSelected(app),
};

export function listenToKeys(app) {
  addEventListener("keydown", (event) => {
    if (document.querySelector("dialog[open]")) return;
    const typing = event.target.closest("input, textarea, select");
    if (event.ctrlKey || event.metaKey) {
      withControl(app, event, typing);
      return;
    }
    if (typing || event.altKey) return;
    // Enter and the arrows are a button's own where it has the focus
    if (event.key === "Enter" && event.target.closest("button, summary")) return;
    if (event.key in ARROWS) {
      if (event.target.closest("aside")) {
        walk(event);
        return;
      }
      const [dx, dy] = ARROWS[event.key];
      app.viewport.panBy(dx * STEP_PX, dy * STEP_PX);
    } else {
      const act = PLAIN[event.key] ?? PLAIN[event.key.toLowerCase()];
      const [tool, choice] = [toolByKey(event.key), toggleByKey(event.key)];
      if (act) act(app);
      else if (tool) app.choose(tool);
      else if (choice) flip(app, choice);
      else return;
    }
    event.preventDefault();
  });
}

// Up and down go through the stations of a half.
function walk(event) {
  const row = event.target.closest(".station")?.parentElement;
  const next = { ArrowUp: row?.previousElementSibling, ArrowDown: row?.nextElementSibling }[event.key];
  if (!next) return;
  event.preventDefault();
  const button = next.querySelector("button");
  button.focus();
  button.click();
}

function withControl(app, event, typing) {
  const key = event.key.toLowerCase();
  if (key === "s") app.save();
  else if (typing) return;
  else if (key === "z" && event.shiftKey) app.redo();
  else if (key === "z") app.undo();
  else if (key === "y") app.redo();
  else return;
  event.preventDefault();
}

const OTHERS = [
  ["+ −", "zoom; the wheel too"],
  ["0", "fit the picture"],
  ["arrows", "move the picture; drag, or hold Space and drag"],
  ["Enter", "end a line that is being drawn"],
  ["Esc", "drop what was begun"],
  ["Backspace", "take back the last point"],
  ["Delete", "remove the selected correction"],
  ["Alt", "with a click: exactly here, not on the nearest line"],
  ["N", "next doubtful station"],
  ["Ctrl-Z", "undo; Ctrl-Shift-Z or Ctrl-Y redo"],
  ["S", "save; Ctrl-S too"],
];

export function fillHelp() {
  const rows = [...TOOLS, ...TOGGLES].map((one) => [one.key.toUpperCase(), one.title]).concat(OTHERS);
  byId("help").append(
    make("h2", {}, "Keys"),
    make("dl", {}, ...rows.flatMap(([keys, words]) => [make("dt", {}, make("kbd", {}, keys)), make("dd", {}, words)])),
    make("form", { method: "dialog" }, make("button", { class: "main" }, "Close")),
  );
}

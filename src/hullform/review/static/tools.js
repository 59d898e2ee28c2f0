// The tools and the choices beside them, in the order of their buttons, and the buttons.

import { calibrateTool } from "./calibrate_tool.js";
import { byId, make, redraw } from "./dom.js";
import { deckTool, drawTool, ignoreTool } from "./line_tools.js";
import { cutTool, crossTool, deleteTool, joinTool, knuckleTool, markTool, togetherTool } from "./point_tools.js";
import { selectTool } from "./select_tool.js";

export const TOOLS = [
  selectTool,
  markTool,
  deleteTool,
  cutTool,
  joinTool,
  crossTool,
  togetherTool,
  drawTool,
  deckTool,
  knuckleTool,
  ignoreTool,
  calibrateTool,
];

export const toolByKey = (key) => TOOLS.find((tool) => tool.key === key.toLowerCase());

const shown = (key, name, layer, title) => ({
  key,
  name,
  title,
  is: (app) => app.shown[layer],
  set: (app, on) => (app.shown[layer] = on),
});

const chosen = (key, name, property, title) => ({
  key,
  name,
  title,
  is: (app) => app[property],
  set: (app, on) => (app[property] = on),
});

export const TOGGLES = [
  chosen("2", "2nd contour", "secondContour", "Mark or draw the station's second contour"),
  {
    key: "l",
    name: "smooth",
    title: "Draw smooth curves, or straight pieces",
    is: () => drawTool.smooth,
    set: (_, on) => (drawTool.smooth = on),
  },
  chosen("p", "snap", "snapping", "Clicks go to the nearest line (with Alt: exactly where you point)"),
  shown("h", "curves", "curves", "Show or hide the traced curves"),
  shown("g", "grid", "grid", "Show or hide the predicted grid"),
  shown("u", "unused", "lines", "Show the lines that no curve took"),
  chosen("f", "fade", "faded", "Fade the picture under what is drawn over it"),
];

export const toggleByKey = (key) => TOGGLES.find((choice) => choice.key === key.toLowerCase());

export function flip(app, choice) {
  choice.set(app, !choice.is(app));
  app.changed();
}

export function drawTools(app) {
  const buttons = TOOLS.map((tool) =>
    make(
      "button",
      {
        "data-tool": tool.id,
        "data-key": `tool ${tool.id}`,
        "aria-pressed": String(app.tool === tool),
        "aria-keyshortcuts": tool.key.toUpperCase(),
        title: tool.title,
        onclick: () => app.choose(tool),
      },
      tool.name,
      make("kbd", {}, tool.key.toUpperCase()),
    ),
  );
  const toggles = TOGGLES.map((choice) =>
    make(
      "button",
      {
        class: "toggle",
        "data-key": `toggle ${choice.name}`,
        "data-toggle": choice.name,
        "aria-pressed": String(choice.is(app)),
        "aria-keyshortcuts": choice.key.toUpperCase(),
        title: choice.title,
        onclick: () => flip(app, choice),
      },
      choice.name,
      make("kbd", {}, choice.key.toUpperCase()),
    ),
  );
  const keys = make(
    "button",
    { class: "toggle", "data-key": "help", title: "All keys", onclick: () => byId("help").showModal() },
    "keys",
    make("kbd", {}, "?"),
  );
  redraw(byId("tools"), [...buttons, make("hr"), ...toggles, keys]);
}

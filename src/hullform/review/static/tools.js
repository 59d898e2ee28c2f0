// The tools, in the order of their buttons, and the buttons.

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
  const toggle = (key, label, on, flip, title) =>
    make(
      "button",
      {
        class: "toggle",
        "data-key": `toggle ${label}`,
        "data-toggle": label,
        "aria-pressed": String(on),
        title,
        onclick: () => {
          flip();
          app.changed();
        },
      },
      label,
      make("kbd", {}, key),
    );
  const { shown } = app;
  redraw(byId("tools"), [
    ...buttons,
    make("hr"),
    toggle("H", "curves", shown.curves, () => (shown.curves = !shown.curves), "Show or hide the traced curves"),
    toggle("G", "grid", shown.grid, () => (shown.grid = !shown.grid), "Show or hide the predicted grid"),
    toggle("U", "unused", shown.lines, () => (shown.lines = !shown.lines), "Show the lines that no curve took"),
    toggle("F", "fade", app.faded, () => (app.faded = !app.faded), "Fade the picture under what is drawn over it"),
    toggle("P", "snap", app.snapping, () => (app.snapping = !app.snapping), "Clicks go to the nearest line (Alt: not this one)"),
    make("button", { class: "toggle", "data-key": "help", onclick: () => byId("help").showModal() }, "keys", make("kbd", {}, "?")),
  ]);
}

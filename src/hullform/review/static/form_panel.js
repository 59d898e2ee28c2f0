// The form of what was traced: sectional areas along the ship, and waterlines in plan. What is not fair, is not right.

import { byId, make, pathOf, redraw, shape } from "./dom.js";
import { sameStation } from "./layers.js";

const WIDTH = 300;
const HEIGHT = 104;
const MARGIN = { left: 6, right: 6, top: 20, bottom: 14 };

export function drawForm(app) {
  const body = byId("form-panel").querySelector(".body");
  if (!app.reading) {
    redraw(body, [make("p", { class: "quiet" }, "Nothing was read.")]);
    return;
  }
  redraw(body, [areas(app), lines(app)]);
}

function scales(app, largest) {
  const length = app.ship.length_overall_m;
  return (x, value) => [
    MARGIN.left + (x / length) * (WIDTH - MARGIN.left - MARGIN.right),
    HEIGHT - MARGIN.bottom - (value / (largest || 1)) * (HEIGHT - MARGIN.top - MARGIN.bottom),
  ];
}

function frame(app, label, words, children) {
  const foot = HEIGHT - MARGIN.bottom;
  return shape(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: "plot", role: "img", "aria-label": label },
    shape("path", { d: `M${MARGIN.left} ${foot}H${WIDTH - MARGIN.right}`, class: "axis" }),
    shape("text", { x: MARGIN.left, y: HEIGHT - 3 }, "aft"),
    shape("text", { x: WIDTH - MARGIN.right, y: HEIGHT - 3, "text-anchor": "end" }, "fore"),
    shape("text", { x: MARGIN.left, y: 9 }, words),
    ...children,
  );
}

function areas(app) {
  const points = app.reading.areas;
  const largest = Math.max(...points.map((point) => point.area_m2), 1e-9);
  const at = scales(app, largest);
  const places = points.map((point) => at(point.x_m, point.area_m2));
  return frame(
    app,
    "Sectional areas to the draught along the ship",
    `area to T = ${app.ship.draught_m} m, up to ${largest.toPrecision(3)} m²`,
    [
      shape("path", { d: pathOf(places), class: "area-line" }),
      ...points.map((point, index) => {
        const station = { half: point.half, x_m: point.x_m };
        const dot = shape(
          "circle",
          {
            cx: places[index][0],
            cy: places[index][1],
            r: sameStation(station, app.station) ? 5 : 3,
            class: `dot ${standing(app, station)}${sameStation(station, app.station) ? " chosen" : ""}`,
            "data-area": `${point.half}:${point.x_m}`,
            onclick: () => app.selectStation(station),
          },
          shape("title", {}, `${point.half} ${point.x_m} m: ${point.area_m2.toPrecision(4)} m²`),
        );
        return dot;
      }),
    ],
  );
}

const standing = (app, station) => app.rowOf(station)?.standing ?? "missing";

function lines(app) {
  const at = scales(app, app.ship.breadth_m / 2);
  const drawn = app.reading.waterlines;
  const heights = drawn.map((line) => Number(line.height_m.toPrecision(3)));
  return frame(
    app,
    "Waterlines in plan",
    `waterlines at ${heights.join(", ")} m`,
    [
      ...drawn.map((line, index) =>
        shape("path", {
          d: pathOf(line.points.map(([x, y]) => at(x, y))),
          class: "waterline",
          opacity: 0.35 + (0.65 * (index + 1)) / drawn.length,
        }),
      ),
      app.station
        ? shape("path", { d: `M${at(app.station.x_m, 0)[0]} ${MARGIN.top}V${HEIGHT - MARGIN.bottom}`, class: "here" })
        : null,
    ].filter(Boolean),
  );
}

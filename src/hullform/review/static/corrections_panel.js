// The corrections in their order: click to select and see, × to take one back.

import { byId, make, redraw, shape } from "./dom.js";
import { signOf } from "./glyphs.js";
import { correctionById, corrections, describe, pointsOf, without, withReplaced } from "./review_document.js";

export function drawCorrections(app) {
  const all = corrections(app.document);
  const body = byId("corrections-panel").querySelector(".body");
  if (!all.length) {
    redraw(body, [make("p", { class: "quiet" }, "None yet. What you mark, cut, join or draw is listed here.")]);
    return;
  }
  redraw(body, [
    make("ol", { class: "corrections", "data-scroll": "corrections" }, ...all.map((one) => row(app, one))),
  ]);
}

function row(app, one) {
  const chosen = one.id === app.correction;
  const doubt = app.reading?.unheeded[one.id];
  const show = () => {
    app.selectCorrection(one.id);
    const points = pointsOf(app.selectedCorrection);
    if (!points.some((point) => app.viewport.inSight(point))) app.viewport.show(points, app.viewport.scale);
  };
  const bend = () => {
    const now = correctionById(app.document, one.id);
    const smooth = now.smooth === false;
    app.change(withReplaced(app.document, { ...now, smooth }), smooth ? "make it smooth" : "make it straight");
  };
  return make(
    "li",
    { class: chosen ? "chosen" : "" },
    make(
      "button",
      {
        class: "correction",
        "data-key": `correction ${one.id}`,
        "data-correction": one.id,
        "aria-pressed": String(chosen),
        onclick: show,
      },
      shape(
        "svg",
        { viewBox: "-8 -8 16 16", width: 14, height: 14, "aria-hidden": "true" },
        shape("path", { d: signOf(one.kind), class: `sign ${one.kind}` }),
      ),
      describe(one, (station) => app.nameOf(station)),
      doubt ? make("span", { class: "warning", title: doubt }, "no effect") : null,
    ),
    one.kind === "drawn"
      ? make(
          "button",
          { class: "small", "data-key": `bend ${one.id}`, onclick: bend },
          one.smooth === false ? "straight" : "smooth",
        )
      : null,
    make(
      "button",
      {
        class: "small",
        "data-key": `drop ${one.id}`,
        "aria-label": `Remove ${describe(one, (station) => app.nameOf(station))}`,
        onclick: () => app.change(without(app.document, one.id), `remove ${one.kind}`),
      },
      "×",
    ),
  );
}

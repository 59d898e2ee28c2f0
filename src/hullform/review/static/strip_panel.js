// The picture along the selected curve, straightened: where the dark line leaves the middle, the curve is wrong.

import { stripAddress } from "./api.js";
import { byId, make } from "./dom.js";

export function drawStrip(app) {
  const panel = byId("strip-panel");
  const curves = app.station ? app.curvesOf(app.station) : [];
  const curve = curves[Math.min(app.secondContour ? 1 : 0, curves.length - 1)];
  panel.hidden = !curve;
  if (!curve) return;
  const address = stripAddress(curve.half, app.station.x_m, curve.curve, app.version);
  const body = panel.querySelector(".body");
  if (body.dataset.address === address) return;
  body.dataset.address = address;
  const residual = curve.residual_px === null ? "no line under it" : `${curve.residual_px.toFixed(2)} px from the line`;
  body.replaceChildren(
    make(
      "p",
      { class: "quiet" },
      `station ${app.nameOf(app.station)} (${curve.half}), keel left, outboard up; ${residual}`,
    ),
    make("div", { class: "strip" }, make("img", { src: address, alt: "The picture along the curve, straightened" })),
  );
}

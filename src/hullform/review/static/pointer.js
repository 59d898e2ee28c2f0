// The mouse over the picture: a click is the tool's, a drag is the handle's or moves the picture, the wheel zooms.

import { distance } from "./geometry.js";

const CLICK_PX = 4; // a press that moves no farther is a click
const WHEEL_RATE = 0.0016;
const LINE_PX = 16; // of a wheel that counts in lines

export function listen(app, stage) {
  let press = null;
  let spaceHeld = false;

  stage.addEventListener("pointerdown", (event) => {
    if (event.target.closest("button, #notice")) return;
    stage.focus({ preventScroll: true });
    if (event.button > 1) return;
    event.preventDefault();
    stage.setPointerCapture(event.pointerId);
    const start = [event.clientX, event.clientY];
    const panning = event.button === 1 || spaceHeld;
    const px = app.viewport.ofEvent(event);
    press = {
      start,
      last: start,
      px,
      moved: false,
      panning,
      grip: panning ? null : (app.tool.grab?.(app, px) ?? null),
    };
  });

  stage.addEventListener("pointermove", (event) => {
    app.pointer = app.viewport.ofEvent(event);
    if (press) drag(event);
    app.changed("pointer");
  });

  function drag(event) {
    const here = [event.clientX, event.clientY];
    if (!press.moved && distance(here, press.start) < CLICK_PX) return;
    press.moved = true;
    if (press.grip) press.grip.move(app.pointer, event);
    else app.viewport.panBy(here[0] - press.last[0], here[1] - press.last[1]);
    press.last = here;
    stage.classList.add(press.grip ? "gripping" : "panning");
  }

  stage.addEventListener("pointerup", (event) => {
    const done = press;
    press = null;
    stage.classList.remove("gripping", "panning");
    if (!done || done.panning) return;
    if (done.moved) done.grip?.drop();
    else app.tool.click?.(app, app.viewport.ofEvent(event), event);
  });

  stage.addEventListener("pointercancel", () => {
    press?.grip?.cancel();
    press = null;
  });

  stage.addEventListener("pointerleave", () => {
    if (press) return;
    app.pointer = null;
    app.changed("pointer");
  });

  stage.addEventListener("dblclick", (event) => {
    if (event.target.closest("button, #notice")) return;
    app.tool.double?.(app, app.viewport.ofEvent(event), event);
  });

  stage.addEventListener("contextmenu", (event) => event.preventDefault());

  stage.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const box = stage.getBoundingClientRect();
      const turned = event.deltaY * (event.deltaMode === 1 ? LINE_PX : 1);
      app.viewport.zoomAt(Math.exp(-turned * WHEEL_RATE), [event.clientX - box.left, event.clientY - box.top]);
    },
    { passive: false },
  );

  addEventListener("keydown", (event) => {
    if (event.code !== "Space" || event.target.closest("button, input, textarea, select, summary")) return;
    spaceHeld = true;
    stage.classList.add("pannable");
    event.preventDefault();
  });
  addEventListener("keyup", (event) => {
    if (event.code !== "Space") return;
    spaceHeld = false;
    stage.classList.remove("pannable");
  });
}

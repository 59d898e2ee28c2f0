// The line under the picture, and the notice over it: what to do next, where the pointer is, what went wrong.

import { byId, make } from "./dom.js";

export function drawStatus(app) {
  const hint = byId("hint");
  const words = app.message.trim() || app.tool?.hint(app) || "";
  // told again only when it is new: a screen reader reads out every change
  if (hint.textContent !== words) hint.textContent = hint.title = words;
  const parts = [];
  if (app.pointer) {
    const [u, v] = app.pointer;
    const [y, z] = app.metresAt(app.pointer);
    parts.push(`${u.toFixed(1)}, ${v.toFixed(1)} px`, `y ${Math.abs(y).toFixed(3)} m, z ${z.toFixed(3)} m`);
  }
  parts.push(`${Math.round(100 * app.viewport.scale)} %`);
  byId("where").textContent = parts.join("   ");
  byId("timing").textContent = app.busy
    ? "reading …"
    : app.roundTripMs
      ? `read in ${Math.round(app.roundTripMs)} ms`
      : "";
}

// A reading that failed is told until one succeeds, whatever is saved meanwhile.
export function drawNotice(app) {
  const notice = byId("notice");
  const { failure, unsaved, savedTo } = app;
  const parts = [];
  if (failure) {
    const before = app.reading ? "This was refused; what you see is the reading before it. " : "Nothing could be read yet. ";
    parts.push(make("p", {}, make("strong", {}, before), failure));
  }
  if (unsaved) {
    const over = app.overwrites
      ? make("button", { class: "small", id: "save-over", onclick: () => app.saveOver() }, "Save over it")
      : null;
    parts.push(make("p", {}, make("strong", {}, "Not saved. "), unsaved, " ", over));
  } else if (savedTo && !app.history.changed) {
    const then = failure
      ? [". The commands read it now, and refuse it as this page does."]
      : [". Every command reads it now: ", make("code", {}, `hullform run ${app.ship.file}`)];
    parts.push(make("p", {}, make("strong", {}, "Saved "), make("code", {}, savedTo), ...then));
  }
  const words = parts.map((part) => part.textContent).join(" ");
  notice.hidden = !words || words === app.noticeClosed;
  if (notice.hidden) return;
  notice.className = failure || unsaved ? "bad" : "good";
  const close = make(
    "button",
    {
      class: "small",
      "aria-label": "Close this notice",
      onclick: () => {
        app.noticeClosed = words;
        notice.hidden = true;
      },
    },
    "×",
  );
  notice.replaceChildren(make("div", {}, ...parts), close);
}

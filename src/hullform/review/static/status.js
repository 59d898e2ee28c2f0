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

export function drawNotice(app) {
  const notice = byId("notice");
  const { failure, unsaved, savedTo } = app;
  notice.className = failure || unsaved ? "bad" : "good";
  const refused = failure
    ? [
        make(
          "strong",
          {},
          app.reading ? "This was refused; what you see is the reading before it. " : "Nothing could be read yet. ",
        ),
        failure,
        " ",
      ]
    : [];
  const lost = unsaved ? [make("strong", {}, "Not saved. "), unsaved] : [];
  const words = failure || unsaved
    ? [...refused, ...lost]
    : savedTo && !app.history.changed
      ? [
          make("strong", {}, "Saved "),
          make("code", {}, savedTo),
          ". Every command reads it now: ",
          make("code", {}, `hullform run ${app.ship.file}`),
        ]
      : [];
  notice.hidden = !words.length;
  if (notice.hidden) return;
  const close = make(
    "button",
    { class: "small", "aria-label": "Close this notice", onclick: () => (notice.hidden = true) },
    "×",
  );
  notice.replaceChildren(make("span", {}, ...words), close);
}

// What the reader is not sure of, in its own words; a doubt that names a station leads there.

import { byId, make, redraw } from "./dom.js";
import { showStation } from "./doubtful.js";

export function drawDoubts(app) {
  const doubts = app.reading?.doubts ?? [];
  byId("doubts-panel").querySelector("h2").textContent = doubts.length ? `Doubts (${doubts.length})` : "Doubts";
  const count = byId("doubts");
  count.textContent = app.reading ? `${doubts.length || "No"} doubt${doubts.length === 1 ? "" : "s"}` : "Not read";
  count.classList.toggle("some", !app.reading || doubts.length > 0);
  const body = byId("doubts-panel").querySelector(".body");
  const notes = app.reading?.notes ?? [];
  redraw(body, [
    doubts.length
      ? make("ul", { class: "doubts", "data-scroll": "doubts", tabindex: "0", "aria-label": "Doubts" }, ...doubts.map((words, index) => make("li", {}, entry(app, words, index))))
      : make(
          "p",
          { class: "quiet" },
          app.reading ? "None: all stations were found and the checks hold." : "Nothing was read.",
        ),
    notes.length
      ? make(
          "details",
          { open: app.readingNotes, ontoggle: (event) => (app.readingNotes = event.target.open) },
          make("summary", { "data-key": "notes" }, `Notes (${notes.length})`),
          make("ul", { class: "notes" }, ...notes.map((words) => make("li", {}, words))),
        )
      : null,
  ]);
}

function entry(app, words, index) {
  const named = app.reading.station_doubts.find((doubt) => doubt.text === words);
  if (!named) return words;
  const station = { half: named.half, x_m: named.x_m };
  return make(
    "button",
    {
      class: "doubt",
      "data-key": `doubt ${index}`,
      onclick: () => {
        app.selectStation(station);
        showStation(app, station, true);
      },
    },
    words,
  );
}

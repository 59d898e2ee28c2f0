// The calls to the server of this page. A refused call throws an error with the server's own words.

const token = document.querySelector("meta[name=review-token]").content;

export class Superseded extends Error {}

// The review file was changed by another page or program; `revision` is what it is now.
export class ChangedMeanwhile extends Error {
  constructor(message, revision) {
    super(message);
    this.revision = revision;
  }
}

async function call(method, path, body, headers = {}) {
  let answer;
  try {
    answer = await fetch(path, {
      method,
      headers: { "content-type": "application/json", "x-review-token": token, ...headers },
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  } catch {
    throw new Error(
      "The server does not answer. Was 'hullform review' ended? Start it again; the page keeps your changes.",
    );
  }
  const document = await answer.json().catch(() => ({ message: `The server failed (${answer.status}).` }));
  if (answer.status === 409) throw new Superseded(document.message);
  if (answer.status === 412) throw new ChangedMeanwhile(document.message, document.revision);
  if (!answer.ok) throw new Error(document.message);
  return document;
}

export const opening = () => call("GET", "/api/opening");
export const solve = (review) => call("PUT", "/api/review", review);
// Saves over the file of that revision only.
export const save = (review, revision) => call("POST", "/api/save", review, { "x-review-revision": revision });

export const stripAddress = (half, station_m, curve, version) =>
  `/api/strip?${new URLSearchParams({ half, station_m, curve, version })}`;

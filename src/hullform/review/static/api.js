// The calls to the server of this page. A refused call throws an error with the server's own words.

const token = document.querySelector("meta[name=review-token]").content;

export class Superseded extends Error {}

async function call(method, path, body) {
  let answer;
  try {
    answer = await fetch(path, {
      method,
      headers: { "content-type": "application/json", "x-review-token": token },
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  } catch {
    throw new Error(
      "The server does not answer. Was 'hullform review' ended? Start it again; the page keeps your changes.",
    );
  }
  const document = await answer.json().catch(() => ({ message: `The server failed (${answer.status}).` }));
  if (answer.status === 409) throw new Superseded(document.message);
  if (!answer.ok) throw new Error(document.message);
  return document;
}

export const opening = () => call("GET", "/api/opening");
export const solve = (review) => call("PUT", "/api/review", review);
export const save = (review) => call("POST", "/api/save", review);

export const stripAddress = (half, station_m, curve, version) =>
  `/api/strip?${new URLSearchParams({ half, station_m, curve, version })}`;

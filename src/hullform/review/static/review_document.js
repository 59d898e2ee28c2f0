// Pure functions of the review document: each returns a new one.

const KINDS = {
  mark: "mark",
  delete: "delete",
  cut: "cut",
  join: "join",
  cross: "cross",
  together: "run together",
  drawn: "drawn curve",
  deck: "deck line",
  knuckle: "knuckle",
  ignore: "ignored region",
};

export const corrections = (document) => document.corrections ?? [];

export const correctionById = (document, id) => corrections(document).find((one) => one.id === id);

function nextId(document) {
  const numbers = corrections(document).map((one) => Number(/^c(\d+)$/.exec(one.id)?.[1] ?? 0));
  return `c${Math.max(0, ...numbers) + 1}`;
}

export const withCorrection = (document, correction) => ({
  ...document,
  corrections: [...corrections(document), { id: nextId(document), ...correction }],
});

export const withReplaced = (document, changed) => ({
  ...document,
  corrections: corrections(document).map((one) => (one.id === changed.id ? changed : one)),
});

export const without = (document, id) => ({
  ...document,
  corrections: corrections(document).filter((one) => one.id !== id),
});

// One mark and one drawn curve for each curve of a station, one deck line a half: a new one takes the old one's place.
export function withOnly(document, correction) {
  const same = (one) =>
    one.kind === correction.kind &&
    one.half === correction.half &&
    one.station_m === correction.station_m &&
    (one.curve ?? 0) === (correction.curve ?? 0);
  const kept = { ...document, corrections: corrections(document).filter((one) => !same(one)) };
  return withCorrection(kept, correction);
}

export function withCalibration(document, calibration) {
  const { calibration: _, ...rest } = document;
  return calibration === null ? rest : { ...rest, calibration };
}

// Marks and drawn curves of stations that are gone go too.
export function withStations(document, stations) {
  const listed = (one) =>
    one.station_m === undefined || stations[`${one.half}_stations_m`].some((x) => Math.abs(x - one.station_m) < 1e-3);
  const named = Object.entries(stations).filter(([key, value]) => !key.endsWith("_names") || value.length);
  return { ...document, stations: Object.fromEntries(named), corrections: corrections(document).filter(listed) };
}

// The names of a changed list of stations: its own, else those of the former list, new stations called by their x.
export function keptNames(former, changed, half) {
  const own = changed[`${half}_station_names`] ?? [];
  const [before, names] = [former[`${half}_stations_m`], former[`${half}_station_names`]];
  if (own.length || !names.length) return own;
  return changed[`${half}_stations_m`].map((x) => names[before.indexOf(x)] ?? `${x} m`);
}

const isPoint = (px) => typeof px[0] === "number";

// The places of a correction as a list of points, and the correction with one of them elsewhere.
export const pointsOf = (correction) => (isPoint(correction.px) ? [correction.px] : correction.px);

export function withPoint(correction, index, point) {
  if (isPoint(correction.px)) return { ...correction, px: point };
  return { ...correction, px: correction.px.map((old, at) => (at === index ? point : old)) };
}

export function describe(correction, nameOf) {
  const words = KINDS[correction.kind];
  if (correction.station_m !== undefined) {
    const second = correction.curve ? ", second contour" : "";
    return `${words}, ${correction.half} ${nameOf({ half: correction.half, x_m: correction.station_m })}${second}`;
  }
  return correction.half ? `${words}, ${correction.half}` : words;
}

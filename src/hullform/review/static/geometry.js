// Plane geometry of pixels and metres.

export const distance = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

export function nearestOnLine(point, line) {
  let best = { distance: Infinity, point: null, index: -1 };
  for (let index = 0; index + 1 < line.length; index += 1) {
    const [a, b] = [line[index], line[index + 1]];
    const [du, dv] = [b[0] - a[0], b[1] - a[1]];
    const length = du * du + dv * dv;
    const share = length ? Math.min(1, Math.max(0, ((point[0] - a[0]) * du + (point[1] - a[1]) * dv) / length)) : 0;
    const at = [a[0] + share * du, a[1] + share * dv];
    const far = distance(point, at);
    if (far < best.distance) best = { distance: far, point: at, index };
  }
  return best;
}

// The nearest of several lines to a point, with the place on it; null where all are farther than the reach.
export function nearestLine(point, lines, reach) {
  let best = null;
  for (const line of lines) {
    const found = nearestOnLine(point, line.px);
    if (found.distance <= (best?.distance ?? reach)) best = { ...found, line };
  }
  return best;
}

// A homography, rows of 3 x 3, on a point; and its inverse.
export function mapped(m, [a, b]) {
  const depth = m[2][0] * a + m[2][1] * b + m[2][2];
  return [(m[0][0] * a + m[0][1] * b + m[0][2]) / depth, (m[1][0] * a + m[1][1] * b + m[1][2]) / depth];
}

export function inverse([[a, b, c], [d, e, f], [g, h, i]]) {
  const [A, B, C] = [e * i - f * h, f * g - d * i, d * h - e * g];
  const determinant = a * A + b * B + c * C;
  return [
    [A, c * h - b * i, b * f - c * e],
    [B, a * i - c * g, c * d - a * f],
    [C, b * g - a * h, a * e - b * d],
  ].map((row) => row.map((value) => value / determinant));
}

// A smooth line through points, for the eye while it is being drawn: centripetal Catmull-Rom.
export function smoothThrough(points, pieces = 12) {
  if (points.length < 3) return points;
  const first = [2 * points[0][0] - points[1][0], 2 * points[0][1] - points[1][1]];
  const [y, z] = [points.at(-1), points.at(-2)];
  const all = [first, ...points, [2 * y[0] - z[0], 2 * y[1] - z[1]]];
  const out = [points[0]];
  for (let n = 1; n + 2 < all.length; n += 1) {
    const four = all.slice(n - 1, n + 3);
    const knots = [0];
    for (let k = 1; k < 4; k += 1) knots.push(knots[k - 1] + Math.max(1e-6, Math.sqrt(distance(four[k], four[k - 1]))));
    for (let piece = 1; piece <= pieces; piece += 1) {
      const t = knots[1] + ((knots[2] - knots[1]) * piece) / pieces;
      out.push(
        [0, 1].map((axis) =>
          catmullRom(
            four.map((point) => point[axis]),
            knots,
            t,
          ),
        ),
      );
    }
  }
  return out;
}

function catmullRom(values, knots, t) {
  const between = (a, b, from, to) => (a * (knots[to] - t) + b * (t - knots[from])) / (knots[to] - knots[from]);
  const [a, b, c] = [0, 1, 2].map((k) => between(values[k], values[k + 1], k, k + 1));
  return between(between(a, b, 0, 2), between(b, c, 1, 3), 1, 2);
}

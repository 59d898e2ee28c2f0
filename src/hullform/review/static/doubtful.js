// Which stations a person should look at, the worst first, and the way to them.

const SEVERITY = { missing: 0, poor: 1, fair: 2 };

export function doubtful(app) {
  const rows = (app.reading?.halves ?? []).flatMap((one) =>
    one.stations.filter((row) => row.standing in SEVERITY).map((row) => ({ half: one.half, ...row })),
  );
  return rows.sort((a, b) => SEVERITY[a.standing] - SEVERITY[b.standing] || (a.confidence ?? 0) - (b.confidence ?? 0));
}

export function nextDoubtful(app) {
  const rows = doubtful(app);
  if (!rows.length) {
    app.say("No station is in doubt.");
    return;
  }
  const at = rows.findIndex((row) => row.half === app.station?.half && row.x_m === app.station?.x_m);
  const { half, x_m } = rows[(at + 1) % rows.length];
  app.selectStation({ half, x_m });
  showStation(app, { half, x_m }, true);
}

// Brings a station's curve, or its half where it has none, into the window; closely only when asked.
export function showStation(app, station, closely = false) {
  const curves = app.curvesOf(station);
  const points = curves.flatMap((curve) => curve.px);
  if (points.length) {
    if (closely || !points.some((point) => app.viewport.inSight(point))) app.viewport.show(points);
    return;
  }
  const { breadth_m, depth_m } = app.ship;
  const outer = (app.sideOf(station.half) * breadth_m) / 2;
  app.viewport.show([app.pixelAt([0, 0]), app.pixelAt([outer, depth_m])]);
}

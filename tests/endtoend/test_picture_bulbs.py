"""Bulbs, domes and tunnels drawn by formula come back as the curves they are, under the names of their stations."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from reading_accuracy import to_polyline

from hullform.body_plan import Station
from hullform.hull.crossings import crossing_triangles
from hullform.hull.loft import Hull
from hullform.picture.reading import PictureReading, read_picture
from hullform.ship import read_ship

Array = NDArray[np.float64]
Contours = tuple[Array, ...]

BREADTH_M, DEPTH_M, DRAUGHT_M = 20.0, 16.0, 9.0
HALF_PX = 500.0  # B/2
CENTRE, BASE = 560, 1000  # px
METRES_PER_PX = BREADTH_M / 2 / HALF_PX
AFT_M = (5.0, 10.0, 20.0, 50.0)
FORE_M = (50.0, 65.0, 75.0, 83.0, 90.0, 97.0, 100.5, 102.0)  # from amidships to the stem

# A line is 2 px wide, its axis is read to a fraction of that; corners at the centre line are rounded by some pixels.
WORST_RMS = 0.006  # of B/2: 3 px


def plain(fullness: float) -> Contours:
    """A section without a bulb: y = B/2 f (1 - 0.6 (1 - z/D)^6) over a flat of bottom, f = 1 amidships."""
    z = np.linspace(0.0, DEPTH_M, 200)
    y = BREADTH_M / 2 * fullness * (1 - 0.6 * (1 - z / DEPTH_M) ** 6)
    return (np.vstack([[[0.0, 0.0]], np.column_stack([y, z])]),)


def bulbous(fullness: float) -> Contours:
    """A section with a bulb at a quarter of the depth; two contours where the fullness is below -0.07.

    y = B/2 (f + b exp(-(9 (z/D - 1/4))^2) + (t - f) (z/D)^2) where that is positive, with t = min(1, 2 f + 0.4), held
    to f or more, and b = 0.28, less for full sections.
    """
    z = np.linspace(0.0, DEPTH_M, 1600)
    t = z / DEPTH_M
    bump = 0.28 * np.clip((0.7 - fullness) / 0.4, 0.0, 1.0) * np.exp(-((9 * (t - 0.25)) ** 2))
    y = BREADTH_M / 2 * (fullness + bump + (np.clip(2 * fullness + 0.4, fullness, 1.0) - fullness) * t**2)
    inside = np.concatenate([[False], y > 0, [False]])
    edges = np.flatnonzero(np.diff(inside.astype(np.int8))).reshape(-1, 2)
    contours = []
    for start, stop in edges.tolist():
        points = np.column_stack([y[start:stop], z[start:stop]])
        low = [(0.0, points[0, 1])]
        high = [(0.0, points[-1, 1])] if stop < len(z) else []
        contours.append(np.vstack([low, points, *[np.array(high)] * bool(high)]))
    return tuple(contours)


def dome(fullness: float) -> Contours:
    """A section with a dome below the base line: rounded, 1.4 m and more below it, a waist, a straight flare."""
    around = np.linspace(-np.pi / 2, 0.6, 80)
    radius = 1.5 + fullness
    belly = np.column_stack([radius * np.cos(around), -0.4 + (1 + fullness / 2) * np.sin(around)])
    waist = np.array([1.1 + fullness, 2.6])
    top = np.array([3.0 + 2 * fullness, DEPTH_M])
    share = np.linspace(0.0, 1.0, 60)[:, None]
    # a parabola from the belly's end, along its tangent, to the waist, and a line from there
    end = belly[-1]
    tangent = np.array([-radius * np.sin(0.6), (1 + fullness / 2) * np.cos(0.6)])
    control = end + tangent / np.linalg.norm(tangent)
    over = (1 - share) ** 2 * end + 2 * share * (1 - share) * control + share**2 * waist
    return (np.vstack([belly, over[1:], waist + share[1:] * (top - waist)]),)


def necked(number: int) -> Contours:
    """A dome below a neck that all such sections have in common: the finer the flare above it, the larger the dome."""
    share = np.linspace(0.0, 1.0, 120)
    bottom, neck, width = -1.0 - 0.5 * number, (1.2, 1.2), 0.7 + 0.7 * number
    below = np.column_stack(
        [
            neck[0] * np.sqrt(np.sin(np.pi / 2 * share)) + width * np.sin(np.pi * share) ** 2,
            bottom + (neck[1] - bottom) * share,
        ]
    )
    rise = share[1:, None]
    above = np.column_stack([neck[0] + (5.0 - 1.2 * number) * rise**1.6, neck[1] + (DEPTH_M - neck[1]) * rise])
    return (np.vstack([below, above]),)


def tunnel(fullness: float) -> Contours:
    """A section with a tunnel: from the base line up to a roof, down to a bilge, up a straight side."""
    roof, bilge = 5.0 + fullness, 9.0 + fullness / 2
    y = np.linspace(2.0, bilge, 200)
    share = (y - 2.0) / (bilge - 2.0)
    z = 4.2 * np.exp(-(((y - roof) / 2.2) ** 2)) * (1 - np.exp(-3 * share)) + 1.5 * share**4
    return (np.vstack([[[0.0, 0.0]], np.column_stack([y, z]), [[bilge + 0.3, DEPTH_M]]]),)


def barge(fullness: float) -> Contours:
    """A flat of bottom, a bilge of an ellipse 2.5 m wide and 2 m high, a straight side."""
    around = np.linspace(0.0, np.pi / 2, 40)
    side = BREADTH_M / 2 * fullness
    bilge = np.column_stack([side - 2.5 * (1 - np.sin(around)), 2 * (1 - np.cos(around))])
    return (np.vstack([[[0.0, 0.0]], bilge, [[side, DEPTH_M]]]),)


def drawing(folder: Path, aft: Sequence[Contours], fore: Sequence[Contours]) -> PictureReading:
    """Draw both halves over a grey grid, and read the picture."""
    image = np.full((1180, 1120), 252, np.uint8)

    def line(points: Array, side: int, grey: int, width: int) -> None:
        at = np.column_stack([CENTRE + side * points[:, 0] / METRES_PER_PX, BASE - points[:, 1] / METRES_PER_PX])
        cv2.polylines(image, [np.round(at * 16).astype(np.int32)], False, grey, width, cv2.LINE_AA, 4)

    for y in (-10.0, -7.5, -5.0, -2.5, 2.5, 5.0, 7.5, 10.0):
        line(np.array([[y, -0.6], [y, DEPTH_M + 0.4]]), 1, 160, 1)
    for z in (2.5, 5.0, 7.5, 10.0, 12.5, 15.0):
        line(np.array([[-10.4, z], [10.4, z]]), 1, 160, 1)
    line(np.array([[-10.4, 0.0], [10.4, 0.0]]), 1, 0, 2)
    line(np.array([[0.0, -3.0], [0.0, DEPTH_M + 0.6]]), 1, 0, 2)
    for side, stations in ((-1, aft), (1, fore)):
        for contours in stations:
            for contour in contours:
                line(contour, side, 10, 2)
    cv2.imwrite(str(folder / "bodyplan.png"), image)
    (folder / "ship.toml").write_text(
        f"""schema = 1
[ship]
name = "drawn"
type = "container"
length_overall_m = 104.0
length_between_perpendiculars_m = 104.0
breadth_m = {BREADTH_M}
depth_m = {DEPTH_M}
draught_m = {DRAUGHT_M}
[body_plan]
image = "bodyplan.png"
aft_side = "left"
aft_stations_m = {list(AFT_M[: len(aft)])}
fore_stations_m = {list(FORE_M[: len(fore)])}
"""
    )
    return read_picture(read_ship(folder / "ship.toml"))


FULLNESS = (0.85, 0.62, 0.4, 0.2, 0.0, -0.1, -0.14)  # of bulbous sections, of which the last two are two contours
AFT = [plain(f) for f in (0.35, 0.6, 0.85, 1.0)]


def missed(station: Station, truth: Contours) -> tuple[float, float]:
    """RMS distance of the true contours from the read ones, and of the read from the true, in parts of B/2."""
    read = [curve.points for curve in station.curves]

    def distance(points: Array, lines: Sequence[Array]) -> float:
        return float(np.sqrt(np.mean(np.min([to_polyline(points, line) for line in lines], axis=0) ** 2)))

    return (
        distance(np.vstack(truth), read) / (BREADTH_M / 2),
        distance(np.vstack(read), truth) / (BREADTH_M / 2),
    )


def fore_stations(reading: PictureReading) -> list[Station]:
    return [station for station in reading.body_plan.stations if station.half == "fore"]


def test_bulbs_are_read_with_their_flares(tmp_path: Path) -> None:
    fore = [plain(1.0), *(bulbous(f) for f in FULLNESS)]
    stations = fore_stations(drawing(tmp_path, AFT, fore))
    assert [station.x_m for station in stations] == list(FORE_M)
    assert [len(station.curves) for station in stations] == [1, 1, 1, 1, 1, 1, 2, 2]
    for station, truth in zip(stations, fore, strict=True):
        assert max(missed(station, truth)) < WORST_RMS, station.name


def test_the_second_curve_is_the_loop_and_its_ends_lie_on_the_centre_line(tmp_path: Path) -> None:
    fore = [plain(1.0), *(bulbous(f) for f in FULLNESS)]
    flare, loop = fore_stations(drawing(tmp_path, AFT, fore))[-1].curves
    assert loop.half_breadth_m[0] == loop.half_breadth_m[-1] == 0.0
    assert loop.height_m.max() < flare.height_m.min()
    # the flare ends at the deck, to a line's width
    assert flare.height_m[-1] == pytest.approx(DEPTH_M, abs=3 * METRES_PER_PX)


def test_domes_are_followed_below_the_base_line(tmp_path: Path) -> None:
    fore = [plain(1.0), plain(0.85), plain(0.7), dome(1.2), dome(0.7), dome(0.2)]
    stations = fore_stations(drawing(tmp_path, AFT, fore))
    assert [station.x_m for station in stations] == list(FORE_M[: len(fore)])
    for station, truth in zip(stations, fore, strict=True):
        assert max(missed(station, truth)) < WORST_RMS, station.name
    lowest = [float(station.curves[0].height_m.min()) for station in stations]
    assert lowest == pytest.approx([0.0, 0.0, 0.0, -2.0, -1.75, -1.5], abs=3 * METRES_PER_PX)


def test_domes_whose_necks_run_through_one_place_keep_their_flares(tmp_path: Path) -> None:
    fore = [plain(1.0), plain(0.85), plain(0.7), *(necked(number) for number in range(4))]
    stations = fore_stations(drawing(tmp_path, AFT, fore))
    assert [station.x_m for station in stations] == list(FORE_M[: len(fore)])
    lowest = [float(station.curves[0].height_m.min()) for station in stations]
    assert lowest == pytest.approx([0.0, 0.0, 0.0, -1.0, -1.5, -2.0, -2.5], abs=4 * METRES_PER_PX)
    for station, truth in zip(stations, fore, strict=True):
        assert max(missed(station, truth)) < 2 * WORST_RMS, station.x_m  # the neck is one ribbon of four lines


def test_a_mark_on_a_dome_gives_it_to_that_station(tmp_path: Path) -> None:
    # the smaller dome marked as the one of the finer flare, against the fair waterlines
    fore = [plain(1.0), plain(0.85), plain(0.7), *(necked(number) for number in range(4))]
    drawing(tmp_path, AFT, fore)
    y, z = necked(1)[0][60]
    mark = f"px = [{CENTRE + y / METRES_PER_PX:.1f}, {BASE - z / METRES_PER_PX:.1f}]"
    text = (tmp_path / "ship.toml").read_text(encoding="utf-8")
    said = f'{text}[[body_plan.marks]]\nstation_m = {FORE_M[5]}\nhalf = "fore"\n{mark}\n'
    (tmp_path / "ship.toml").write_text(said, encoding="utf-8")
    marked = fore_stations(read_picture(read_ship(tmp_path / "ship.toml")))[5].curves[0]
    assert marked.height_m.min() == pytest.approx(-1.5, abs=4 * METRES_PER_PX)
    assert marked.half_breadth_m[-1] == pytest.approx(necked(2)[0][-1, 0], abs=4 * METRES_PER_PX)


def test_letters_below_the_base_line_are_no_dome(tmp_path: Path) -> None:
    reading = drawing(tmp_path, AFT, [plain(f) for f in (1.0, 0.8, 0.6)])
    image = cv2.imread(str(tmp_path / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    for words, at in (("CL", (545, 1060)), ("2.5", (670, 1050)), ("BODY PLAN 1:100", (600, 1110))):
        cv2.putText(image, words, at, cv2.FONT_HERSHEY_SIMPLEX, 0.9, 0, 2, cv2.LINE_AA)
    cv2.imwrite(str(tmp_path / "bodyplan.png"), image)
    again = read_picture(read_ship(tmp_path / "ship.toml"))
    for before, after in zip(reading.body_plan.stations, again.body_plan.stations, strict=True):
        assert after.curves[0].points.min() > -3 * METRES_PER_PX
        assert max(missed(after, tuple(curve.points for curve in before.curves))) < WORST_RMS


def test_a_tunnel_is_followed_over_its_roof(tmp_path: Path) -> None:
    aft = [tunnel(-1.0), barge(0.92), barge(0.96), barge(1.0)]
    reading = drawing(tmp_path, aft, [barge(1.0), plain(0.8), plain(0.6)])
    stations = [station for station in reading.body_plan.stations if station.half == "aft"]
    assert max(missed(stations[0], aft[0])) < 2 * WORST_RMS  # its bilge is a corner, which is rounded


@pytest.mark.parametrize("fore_most", [bulbous, dome])
def test_the_hull_of_such_a_picture_is_lofted_whole_and_by_super_ellipses_with_a_doubt(
    tmp_path: Path, fore_most: Callable[[float], Contours]
) -> None:
    values = (0.1, -0.1, -0.14) if fore_most is bulbous else (1.2, 0.7, 0.2)
    reading = drawing(tmp_path, AFT, [plain(1.0), plain(0.9), *(fore_most(f) for f in values)])
    main = read_ship(tmp_path / "ship.toml").particulars
    hull = Hull.from_body_plan(reading.body_plan, main)
    assert not any("super-ellipse" in doubt for doubt in hull.doubts)
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0
    forced = Hull.from_body_plan(reading.body_plan, main, sections="super-ellipse")
    assert any("super-ellipse cannot follow" in doubt and "'auto'" in doubt for doubt in forced.doubts)

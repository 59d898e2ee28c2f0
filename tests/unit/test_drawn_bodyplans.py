"""The drawn ships: their forms against closed forms, and their pictures against their calibration."""

from __future__ import annotations

from dataclasses import replace
from math import gamma

import draw_bodyplans
import numpy as np
import pytest
from drawing.form import faults
from drawing.interpolation import interpolate
from drawing.outline import Station
from drawing.ships import outline
from drawing.tables import DS_TANKER, PARTICULARS, SCIM_CONTAINERSHIP

SHIPS = list(PARTICULARS)
BY_FORMULA = ("handymax-bulk-carrier", "fast-ropax")


@pytest.mark.parametrize("ship", SHIPS)
def test_forms_pictures_and_station_lists_are_in_order(ship: str) -> None:
    assert draw_bodyplans.differences(ship) == []


def test_a_form_that_misses_its_figures_is_reported() -> None:
    tanker = outline("ds-tanker")
    heavier = replace(tanker, particulars=replace(tanker.particulars, displacement_t=137000.0))
    assert len(faults(heavier)) == 1
    assert "displacement" in faults(heavier)[0]


# The curve is a polygon of 2400 points: its area lies below the exact one by about (1/1200)^2, a cusp by a little more.
@pytest.mark.parametrize(("p", "q"), [(2.0, 2.0), (20.0, 20.0), (0.464, 1.75), (0.8, 0.93), (1.0, 2.0)])
def test_area_under_a_station_is_the_closed_form(p: float, q: float) -> None:
    points = Station(16.1, 19.5, 19.5, p, q).curve()
    area = np.trapezoid(points[:, 0], points[:, 1])
    exact = 16.1 * 19.5 * gamma(1 + 1 / p) * gamma(1 + 1 / q) / gamma(1 + 1 / p + 1 / q)
    assert area == pytest.approx(exact, rel=1e-5)


def test_wigley_is_exact() -> None:
    hull = outline("wigley")
    assert hull.volume(6.25) == pytest.approx(4.0 / 9.0 * 100.0 * 10.0 * 6.25, rel=1e-6)
    y, z = hull.section(30.0).T
    # Points lie on the chords of the fine polygon: off the curve by the square of its steps, 1e-6 of the depth at most.
    assert y == pytest.approx(5.0 * (1 - 0.4**2) * (1 - ((6.25 - z) / 6.25) ** 2), abs=1e-5)


@pytest.mark.parametrize("ship", [ship for ship in SHIPS if ship not in BY_FORMULA])
def test_sections_run_from_keel_to_deck_in_equal_steps_without_tumblehome(ship: str) -> None:
    hull = outline(ship)
    for _, x in hull.particulars.aft_stations + hull.particulars.fore_stations:
        station, points = hull.station(x), hull.section(x, 300)
        steps = np.hypot(*np.diff(points, axis=0).T)
        assert points.shape == (300, 2)
        assert points[0] == pytest.approx([0.0, station.keel], abs=1e-9)
        assert points[-1] == pytest.approx([station.half_breadth, station.top], abs=1e-9)
        # Chords of the bend are shorter than its arc: by 1 - cos of half the turn within one step, a per cent or so.
        assert steps.max() <= 1.02 * np.median(steps)
        assert (np.diff(points, axis=0) >= -1e-12).all()


@pytest.mark.parametrize("ship", BY_FORMULA)
def test_curves_of_ships_by_formula_bound_the_areas_that_they_are_said_to(ship: str) -> None:
    hull = outline(ship)
    main = hull.particulars
    two = 0
    for _, x in main.aft_stations + main.fore_stations:
        curves = hull.curves(x, 1500)
        two += len(curves) == 2
        assert curves[-1][-1] == pytest.approx(hull.deck_edge(x), abs=1e-9)
        assert all(curve[0, 0] == 0.0 for curve in curves)
        # the half-breadths summed over the heights, past the curves
        z = np.linspace(0.0, main.draught_m, 4001)
        y = hull.hull.half_breadths(x, z)
        # a curve begins where the section is 0.1 % of the breadth wide, and its corners are cut by half a step
        assert hull.section_area(x, main.draught_m) == pytest.approx(
            2 * np.trapezoid(y, z), abs=2e-3 * main.breadth_m * main.draught_m
        )
    assert two >= 2  # bulb and flare


@pytest.mark.parametrize("table", [SCIM_CONTAINERSHIP, DS_TANKER])
def test_interpolation_passes_through_the_table_and_never_leaves_its_neighbours(
    table: tuple[tuple[float, ...], ...],
) -> None:
    rows = np.array(table)
    fine = np.linspace(rows[0, 0], rows[-1, 0], 5001)
    piece = np.clip(np.searchsorted(rows[:, 0], fine, side="right") - 1, 0, len(rows) - 2)
    for column in rows[:, 1:].T:
        assert interpolate(rows[:, 0], column, rows[:, 0]) == pytest.approx(column, abs=1e-12)
        between = interpolate(rows[:, 0], column, fine)
        assert (between >= np.minimum(column[piece], column[piece + 1]) - 1e-9).all()
        assert (between <= np.maximum(column[piece], column[piece + 1]) + 1e-9).all()


@pytest.mark.parametrize("ship", ["scim-containership", "ds-tanker"])
def test_stations_drawn_give_the_volume_by_straight_lines_between_them(ship: str) -> None:
    hull = outline(ship)
    main = hull.particulars
    x = np.array([0.0, *(x for _, x in (main.aft_stations + main.fore_stations)[1:]), main.length_overall_m])
    areas = [hull.section_area(float(s), main.draught_m) for s in x]
    # Straight lines under a convex area curve lose (step)^2 of it; half a per cent shows that no feature goes undrawn.
    assert np.trapezoid(areas, x) == pytest.approx(hull.volume(main.draught_m), rel=5e-3)


def test_unknown_ship_and_place_outside_are_refused() -> None:
    with pytest.raises(ValueError, match="there is no drawn ship 'titanic'"):
        outline("titanic")
    with pytest.raises(ValueError, match="outside wigley"):
        outline("wigley").section(100.1)


@pytest.mark.parametrize(("ship", "options"), [("scim-containership", {}), *draw_bodyplans.further_pictures()])
def test_curves_lie_where_the_calibration_says(ship: str, options: dict[str, float]) -> None:
    hull = outline(ship)
    drawing = draw_bodyplans.draw(hull, **options)
    curve_px = options.get("curve_px", 2.2)
    assert 0.5 * hull.particulars.breadth_m / drawing.metres_per_px / curve_px >= 250.0
    dark = 255.0 - drawing.image.min(axis=2).astype(float)
    assert dark.shape[1] == options.get("width_px", 2000)
    reach = round(1.5 * curve_px + 2.0)
    for sign, stations in ((-1.0, hull.particulars.aft_stations), (1.0, hull.particulars.fore_stations)):
        _, x = stations[len(stations) // 2 - 2]
        y, z = hull.section(x).T
        steep = np.gradient(z) > 0.7 * np.gradient(y)  # where a row cuts the curve cleanly
        y, z = y[steep], z[steep]
        rows = np.round(drawing.baseline_px - z / drawing.metres_per_px).astype(int)
        y_there = np.interp((drawing.baseline_px - rows) * drawing.metres_per_px, z, y)
        true = drawing.centreline_px + sign * y_there / drawing.metres_per_px
        columns = np.round(true).astype(int)[:, None] + np.arange(-reach, reach + 1)
        ink = dark[rows[:, None], columns]
        ink -= ink.min(axis=1, keepdims=True)
        crossed = ink.max(axis=1) > 150.0  # not so in a row that lies within a horizontal line
        assert crossed.mean() > 0.5
        off = (ink * columns)[crossed].sum(axis=1) / ink[crossed].sum(axis=1) - true[crossed]
        # Grid lines and letters in the window spoil single rows, not the median; the sides where the window cuts a
        # slanting line are alike. A slip of the half pixel in the drawing's mapping would show as 0.5.
        assert abs(np.median(off)) < 0.1


def test_labels_keep_clear_of_the_curves() -> None:
    first, second = (draw_bodyplans.draw(outline("ds-tanker"), label_seed=seed).image for seed in (0, 3))
    # Other places for the numbers move letters only: the curves are ink in both.
    apart = (np.abs(first.astype(int) - second).max(axis=2) > 40).mean()
    assert 0.0 < apart < 0.01

"""Hulls whose stations no super-ellipse follows: bulbs, gondolas, chines; closed, whole, of true volume."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.errors import HullError
from hullform.hull import Hull, SuperEllipse
from hullform.hull.contours import Contours
from hullform.hull.crossings import crossing_triangles
from hullform.hull.sections import Sections
from hullform.loading.structure import structure_of
from hullform.ship_structure import StructureInput


@dataclass(frozen=True)
class Particulars:
    length_overall_m: float = 100.0
    length_between_perpendiculars_m: float = 96.0
    aft_perpendicular_m: float = 2.0
    breadth_m: float = 16.0
    depth_m: float = 9.0
    draught_m: float = 6.0


def station(x: float, *contours: np.ndarray) -> Station:
    curves = tuple(TracedCurve(*points.T) for points in contours)
    return Station(x, "aft" if x < 50 else "fore", curves)


def ellipse(a: float, depth: float, p: float, q: float, top: float = 9.0) -> np.ndarray:
    y, zeta = SuperEllipse(a, depth, p, q).points(120).T
    return np.stack([y, top - zeta], -1)


def drop(width: float, low: float, high: float) -> np.ndarray:
    turn = np.linspace(0.0, np.pi, 80)
    return np.stack([width * np.sin(turn), (low + high) / 2 - (high - low) / 2 * np.cos(turn)], -1)


def bulbous(width: float, neck: float, deck: float) -> np.ndarray:
    low = drop(width, 0.0, 4.0)
    low[40:, 0] = neck + (low[40:, 0]) * (1 - neck / width)
    return np.concatenate(
        [low, np.stack([neck + deck * np.linspace(0, 1, 40)[1:] ** 2, np.linspace(4, 9, 40)[1:]], -1)]
    )


MIDSHIP = ellipse(8.0, 9.0, 8.0, 6.0)


def ship() -> BodyPlan:
    """A transom above the water, a gondola under a counter, a bulb that stands out before the stem."""
    return BodyPlan(
        (
            station(0.0, ellipse(6.5, 3.0, 3.0, 2.0)),
            station(6.0, ellipse(7.0, 4.0, 2.0, 2.0)),
            station(12.0, drop(1.0, 0.3, 3.0), ellipse(7.4, 4.8, 1.6, 2.0)),
            station(18.0, bulbous(1.4, 0.6, 7.0)),
            station(35.0, MIDSHIP),
            station(65.0, MIDSHIP),
            station(85.0, bulbous(2.2, 1.6, 5.0)),
            station(92.0, bulbous(1.8, 0.5, 4.0)),
            station(97.0, drop(1.3, 0.6, 4.2), ellipse(2.5, 4.0, 0.9, 1.1)),
            station(99.0, drop(0.8, 1.0, 3.8), ellipse(1.6, 3.0, 0.9, 1.1)),
        ),
        "offsets",
    )


@pytest.fixture(scope="module")
def hull() -> Hull:
    return Hull.from_body_plan(ship(), Particulars())


def test_drawn_stations_come_back_with_their_contours(hull: Hull) -> None:
    assert isinstance(hull.sections, Contours)
    assert hull.doubts == ()
    kinds = {fit.x_m: fit.model.kind for fit in hull.fits if fit.model is not None}
    assert kinds[0.0] == kinds[35.0] == "super-ellipse"
    assert kinds[12.0] == kinds[97.0] == "spline"
    for drawn in ship().stations:
        assert drawn.x_m in hull.x_m
        found = hull.section_curves(drawn.x_m)
        assert len(found) == len(drawn.curves)
        for height in (2.0, 6.0, 20.0):
            true = drawn.area_below(height)
            assert hull.sectional_areas(height, drawn.x_m) == pytest.approx(true, rel=6e-3, abs=0.02)


def test_the_mesh_is_one_closed_body_that_does_not_cross_itself(hull: Hull) -> None:
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert len(np.unique(np.sort(mesh.faces, axis=1), axis=0)) == len(mesh.faces)
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=2e-3)
    # the plate between bulb and stem, which would have no thickness, is not there
    assert mesh.area_faces.min() > 0
    for x, area in ((0.0, hull.sectional_areas()[0]), (100.0, hull.sectional_areas()[-1])):
        end = (np.abs(mesh.triangles_center[:, 0] - x) < 1e-9) & (np.abs(mesh.face_normals[:, 0]) > 1 - 1e-9)
        assert mesh.area_faces[end].sum() == pytest.approx(area, rel=1e-5)


def test_a_gondola_that_ends_between_stations_is_closed_there(hull: Hull) -> None:
    # at 12 m a drop of 0.3 to 3.0 m stands apart, at 6 m there is none: half an ellipsoid as long as it is high
    x = hull.x_m[(hull.x_m >= 6.0) & (hull.x_m <= 12.0)]
    low = np.array([float(hull.sections_at(place).areas_below(3.0)) for place in x])
    share = np.maximum(1 - ((12.0 - x) / 2.7) ** 2, 0.0)
    np.testing.assert_allclose(low, share * np.pi * 1.0 * 1.35, rtol=0.01, atol=1e-6)
    # abaft it the keel is the counter's
    assert (hull.keel_height_m[(hull.x_m > 6.0) & (hull.x_m < 9.2)] > 3.9).all()


def test_a_bulb_ahead_of_which_there_is_a_stem_does_not_grow_into_it() -> None:
    bow = (
        station(90.0, drop(1.2, 0.5, 4.5), ellipse(3.0, 4.0, 0.9, 1.1)),
        station(100.0, ellipse(1.0, 1.5, 0.9, 1.1)),
    )
    plan = BodyPlan(
        (station(0.0, MIDSHIP), station(60.0, MIDSHIP), station(80.0, bulbous(1.8, 1.0, 4.0)), *bow), "offsets"
    )
    hull = Hull.from_body_plan(plan, Particulars())
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0
    # closed at 94 m, or at the next section
    ahead = mesh.vertices[mesh.vertices[:, 0] > 95.5]
    assert ahead[:, 2].min() > 4.5


def test_nothing_overshoots_what_is_drawn(hull: Hull) -> None:
    assert hull.sections.keel.min() >= -1e-9
    assert hull.half_breadth_m.max() <= 8.0 * 1.005
    body = (hull.x_m > 35) & (hull.x_m < 65)
    areas = hull.sectional_areas(6.0)[body]
    np.testing.assert_allclose(areas, areas[0], rtol=1e-9)


def test_a_knuckle_is_a_line_of_points_from_station_to_station() -> None:
    chines = {0.0: (5.0, 1.5), 30.0: (6.0, 1.0), 60.0: (5.5, 1.2), 90.0: (2.6, 2.0)}
    plan = BodyPlan(
        tuple(station(x, np.array([[0, 0], chine, [chine[0] + 1, 6]])) for x, chine in chines.items()), "offsets"
    )
    hull = Hull.from_body_plan(plan, replace(Particulars(), length_overall_m=90.0), sections="traced")
    numbers = set()
    for x, chine in chines.items():
        outline = hull.sections_at(x).points(hull.sections.outline.shape[1])
        apart = np.linalg.norm(outline - chine, axis=1)
        assert apart.min() < 1e-4
        numbers.add(int(apart.argmin()))
    assert len(numbers) == 1
    # between stations the chine is as sharp: the section at 45 m has a corner there, not a round
    number = numbers.pop()
    outline = hull.sections_at(45.0).points(hull.sections.outline.shape[1])
    one, other = np.diff(outline[[number - 3, number, number + 3]], axis=0)
    assert np.degrees(np.arccos(one @ other / np.linalg.norm(one) / np.linalg.norm(other))) > 40


def test_two_halves_that_draw_one_station_are_averaged() -> None:
    wide, narrow = (np.array([[0, 0], [a, 1.0], [a + 1, 9.0]]) for a in (5.01, 4.99))
    middle = [Station(50.0, half, (TracedCurve(*points.T),)) for half, points in (("aft", wide), ("fore", narrow))]  # type: ignore[arg-type]
    ends = (station(0.0, wide), station(100.0, wide))
    hull = Hull.from_body_plan(BodyPlan((*ends, *middle), "offsets"), Particulars(), sections="traced")
    assert hull.sections_at(50.0).half_breadth == pytest.approx(6.0, abs=1e-9)


BOX = np.array([[0.0, 0.0], [8.0, 0.0], [8.0, 9.0]])


def test_a_box_barge_is_exact() -> None:
    plan = BodyPlan(tuple(station(x, BOX) for x in (0.0, 20.0, 50.0, 100.0)), "offsets")
    hull = Hull.from_body_plan(plan, Particulars())
    found, exact = hull.hydrostatics(4.0, density=1000.0), {"rel": 1e-12}
    assert found.volume_m3 == pytest.approx(100 * 16 * 4, **exact)
    assert found.lcb_x_m == pytest.approx(50, **exact)
    assert found.kb_m == pytest.approx(2, **exact)
    assert found.bm_transverse_m == pytest.approx(16**2 / (12 * 4), **exact)
    assert found.bm_longitudinal_m == pytest.approx(100**2 / (12 * 4), **exact)
    assert found.waterplane_area_m2 == pytest.approx(1600, **exact)
    assert found.wetted_surface_m2 == pytest.approx(100 * (16 + 2 * 4), **exact)
    assert hull.mesh().volume == pytest.approx(100 * 16 * 9, rel=1e-9)
    assert hull.draught_for(1025.0 * 100 * 16 * 3.3) == pytest.approx(3.3, rel=1e-9)


def wigley(count: int) -> BodyPlan:
    v = np.linspace(1.0, 0.0, 201)
    x = np.linspace(0.0, 100.0, count)
    return BodyPlan(
        tuple(
            station(float(s), np.stack([5 * (1 - (2 * s / 100 - 1) ** 2) * (1 - v**2), 6.25 * (1 - v)], -1)) for s in x
        ),
        "offsets",
    )


@pytest.mark.parametrize("sections", ["auto", "traced"])
def test_wigley_from_a_hundred_drawn_stations(sections: str) -> None:
    main = Particulars(100.0, 100.0, 0.0, 10.0, 6.25, 6.25)
    hull = Hull.from_body_plan(wigley(100), main, sections=sections)  # type: ignore[arg-type]
    assert isinstance(hull.sections, Sections if sections == "auto" else Contours)
    found, close = hull.hydrostatics(), {"rel": 5e-4}
    volume = 4 / 9 * 100 * 10 * 6.25
    assert found.volume_m3 == pytest.approx(volume, **close)
    assert found.waterplane_area_m2 == pytest.approx(2 / 3 * 1000, **close)
    assert found.lcb_x_m == pytest.approx(50.0, **close)
    assert found.kb_m == pytest.approx(5 / 8 * 6.25, **close)
    assert found.bm_transverse_m == pytest.approx(4 * 100 * 10**3 / 105 / volume, **close)
    assert found.bm_longitudinal_m == pytest.approx(100**3 * 10 / 30 / volume, **close)


def test_the_same_ship_by_parameters_and_by_points_has_the_same_structure() -> None:
    plan = BodyPlan(
        tuple(
            station(x, ellipse(a, 9.0, p, q))
            for x, a, p, q in ((0, 5, 2, 1.5), (25, 8, 6, 4), (50, 8, 8, 6), (75, 7.8, 5, 4), (100, 3, 1, 1.2))
        ),
        "offsets",
    )
    one = Hull.from_body_plan(plan, Particulars())
    other = Hull.from_body_plan(plan, Particulars(), sections="traced")
    assert isinstance(one.sections, Sections)
    assert isinstance(other.sections, Contours)
    x = [0.0, 25.0, 50.0, 75.0, 100.0]  # where they are drawn; between, the two interpolations differ
    found = [structure_of(hull, StructureInput(midship_second_moment_m4=3.0)) for hull in (one, other)]
    for name in ("area_m2", "second_moment_m4", "shear_area_m2", "neutral_axis_m", "girth_m"):
        drawn = [np.interp(x, structure.x_m, getattr(structure, name)) for structure in found]
        np.testing.assert_allclose(drawn[1], drawn[0], rtol=4e-3)


def test_outside_the_drawn_stations_the_last_section_goes_on() -> None:
    plan = BodyPlan(
        tuple(
            station(x, np.array([[0, 0], [a, 1.5], [a + 1, 9]]))
            for x, a in ((10, 5.0), (30, 5.5), (50, 6.0), (70, 5.5), (80, 5.0), (96, 2.0))
        ),
        "offsets",
    )
    hull = Hull.from_body_plan(plan, Particulars(), sections="traced")
    assert [(span.from_m, span.to_m) for span in hull.extrapolated] == [(0.0, 10.0), (96.0, 100.0)]
    assert len(hull.doubts) == 2
    assert hull.half_breadth_m[-1] < 3.0
    assert (np.diff(hull.half_breadth_m[hull.x_m >= 80]) <= 1e-12).all()
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0


def test_a_plan_of_lines_has_no_shape_in_either_way() -> None:
    lines = tuple(station(x, np.array([[0.0, 0.0], [0.0, 9.0]])) for x in (0.0, 50.0, 100.0))
    with pytest.raises(HullError, match="one of them with a shape"):
        Hull.from_body_plan(BodyPlan(lines, "offsets"), Particulars(), sections="traced")


def test_a_bulb_beyond_the_last_station_is_closed_as_an_ellipsoid_is(hull: Hull) -> None:
    # the last station, at 99 m of 100, has a drop of its own from 1.0 to 3.8 m: nothing of it is left at the end
    assert len(hull.section_curves(99.0)) == 2
    assert hull.sectional_areas(4.5)[-1] == pytest.approx(0.0, abs=1e-9)
    lowest = [contour[0, 1] for contour in hull.section_curves(99.0)]
    assert lowest[0] == pytest.approx(1.0, abs=0.02)
    near = hull.x_m[np.argmin(np.abs(hull.x_m - 99.5))]
    share = np.sqrt(1 - (near - 99.0) ** 2)
    assert hull.sectional_areas(4.5, near) == pytest.approx(share**2 * np.pi * 0.8 * 1.4, rel=0.02)


def test_a_single_station_of_two_contours_between_others_leaves_no_edge_of_four_sides() -> None:
    two = (drop(1.0, 0.0, 3.0), ellipse(5.0, 5.0, 1.2, 1.5))
    plan = BodyPlan(
        (
            station(0.0, MIDSHIP),
            station(60.0, MIDSHIP),
            station(80.0, bulbous(1.4, 0.4, 5.0)),
            station(88.0, *two),
            station(95.0, bulbous(1.2, 0.3, 4.0)),
            station(100.0, bulbous(1.0, 0.3, 3.0)),
        ),
        "offsets",
    )
    hull = Hull.from_body_plan(plan, Particulars())
    mesh = hull.mesh()
    assert len(hull.section_curves(88.0)) == 2
    assert mesh.is_watertight
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0


def test_a_station_without_breadth_gives_the_line_of_the_stem() -> None:
    stem = np.array([[0.0, 5.0], [0.0, 9.0]])
    before = (station(0.0, MIDSHIP), station(50.0, MIDSHIP), station(80.0, bulbous(1.6, 0.5, 4.0)))
    hull = Hull.from_body_plan(BodyPlan((*before, station(100.0, stem)), "offsets"), Particulars())
    assert hull.extrapolated == ()
    assert (hull.keel_height_m[-1], hull.top_height_m[-1]) == pytest.approx((5.0, 9.0))
    assert hull.sectional_areas()[-1] == pytest.approx(0.0, abs=1e-9)
    mesh = hull.mesh()
    assert mesh.is_watertight
    # the form ends in an edge, the line that was given
    end = mesh.vertices[np.abs(mesh.vertices[:, 0] - 100.0) < 1e-9]
    np.testing.assert_allclose(end[:, 1], 0.0, atol=1e-9)
    assert (end[:, 2].min(), end[:, 2].max()) == pytest.approx((5.0, 9.0))
    assert len(crossing_triangles(mesh.vertices, mesh.faces)) == 0

"""Which curve stands for a station: each rung for the shape that it can follow, and none below what was drawn."""

import itertools

import numpy as np
import pytest
from shapely import LineString, hausdorff_distance

from hullform.body_plan import Station, TracedCurve
from hullform.hull import SuperEllipse
from hullform.hull.fair_curve import fair_curve
from hullform.hull.ladder import SectionModel, chosen_model, near_enough, super_ellipse_model
from hullform.hull.outlines import area_below, contours_of, corners_of, largest_distance

BREADTH, DRAUGHT = 16.0, 6.0
V = (1 + np.cos(np.linspace(0.0, np.pi, 200))) / 2  # share of the depth below the deck, keel first


def ellipse(a: float, depth: float, p: float, q: float, top: float = 9.0) -> np.ndarray:
    y, zeta = SuperEllipse(a, depth, p, q).points(200).T
    return np.stack([y, top - zeta], -1)


def model(*drawn: list[list[float]] | np.ndarray, choice: str = "auto") -> SectionModel:
    curves = tuple(np.array(points, dtype=float) for points in drawn)
    first = super_ellipse_model(curves, BREADTH, DRAUGHT)
    return chosen_model(curves, BREADTH, DRAUGHT, choice, first)  # type: ignore[arg-type]


FULL = ellipse(8.0, 9.0, 8.0, 6.0)
FLARED = np.stack([3.0 * (1 - V**3.0) ** (1 / 1.2) + 4.0 * (1 - V) ** 3.0, 9.0 * (1 - V)], -1)
KNUCKLED = np.concatenate(
    [ellipse(4.0, 5.0, 2.0, 2.5, top=5.0), ellipse(3.5, 4.0, 1.2, 1.0)[1:] + np.array([4.0, 0.0])]
)
BULB_AND_FLARE = (
    np.stack([1.8 * np.sin(np.linspace(0, np.pi, 80)), 2.5 - 2.0 * np.cos(np.linspace(0, np.pi, 80))], -1),
    ellipse(4.0, 3.0, 1.0, 0.9),
)
BULBOUS = np.stack(
    [2.2 * np.sin(np.linspace(0, 0.97 * np.pi, 200)) ** 2 + 6 * np.linspace(0, 1, 200) ** 5, np.linspace(0, 9, 200)], -1
)
# a coarse table: its chords leave the arc by 1.4 % of the breadth, and no curve that is smooth follows them
COARSE = 12 * np.stack([np.sin(np.radians(22.5 * np.arange(5))), 1 - np.cos(np.radians(22.5 * np.arange(5)))], -1)


@pytest.mark.parametrize(
    ("kind", "drawn"),
    [
        ("super-ellipse", (FULL,)),
        ("flared rectellipse", (FLARED,)),
        ("two super-ellipses", (KNUCKLED,)),
        ("spline", BULB_AND_FLARE),
        ("spline", (BULBOUS,)),
        ("spline", ([[0, 0], [3, 0.5], [4.5, 1.0], [5, 4], [7, 9]],)),
        ("traced polyline", (COARSE,)),
    ],
)
def test_each_shape_stands_on_its_rung(kind: str, drawn: tuple[np.ndarray, ...]) -> None:
    found = model(*drawn)
    assert found.kind == kind
    assert near_enough(found, BREADTH)
    assert len(found.contours) == len(drawn)
    assert (found.ellipse is not None) == (kind == "super-ellipse")
    # what it says of its errors, by other means: densely spaced points, and areas by trapezoids
    for curve, points in zip(found.contours, drawn, strict=True):
        apart = hausdorff_distance(LineString(curve), LineString(points), densify=0.02)
        assert apart <= found.largest_deviation_m * 1.02 + 2e-3
    true = sum(area_below(np.array(points, dtype=float), DRAUGHT) for points in drawn)
    assert found.area_error == pytest.approx(sum(area_below(c, DRAUGHT) for c in found.contours) / true - 1, abs=1e-12)


def test_the_choice_of_the_user_is_kept() -> None:
    assert model(FULL, choice="traced").kind == "spline"
    forced = model(*BULB_AND_FLARE, choice="super-ellipse")
    assert forced.kind == "super-ellipse"
    assert not near_enough(forced, BREADTH)
    assert forced.largest_deviation_m > 0.05 * BREADTH


def test_an_area_below_the_waterline_counts_by_itself() -> None:
    # a counter that dips into the water: within 0.5 % of the breadth the immersed sliver may be twice as large
    counter = np.array([[0.0, 5.95], [0.8, 5.98], [2.0, 6.05], [4.0, 6.3], [6.0, 7.0], [6.5, 9.0]])
    found = model(counter)
    assert abs(found.area_error) <= 0.005


def test_contours_are_closed_to_the_centre_line_and_the_lowest_comes_first() -> None:
    flare = TracedCurve(np.array([0.1, 2.0, 4.0]), np.array([6.0, 7.0, 9.0]))
    bulb = TracedCurve(np.array([0.5, 1.5, 0.2]), np.array([0.0, 2.0, 4.0]))
    lower, upper = contours_of(Station(50.0, "fore", (flare, bulb)))
    np.testing.assert_array_equal(lower, [[0, 0], [0.5, 0], [1.5, 2], [0.2, 4], [0, 4]])
    np.testing.assert_array_equal(upper, [[0, 6], [0.1, 6], [2, 7], [4, 9]])


def test_a_trace_that_goes_down_the_centre_line_begins_where_it_turns() -> None:
    hook = TracedCurve(np.array([0.0, 0.003, 0.005, 2.0, 5.0]), np.array([1.2, 1.1, 1.0, 2.0, 9.0]))
    (points,) = contours_of(Station(50.0, "fore", (hook,)))
    np.testing.assert_array_equal(points, [[0, 1.0], [0.005, 1.0], [2, 2], [5, 9]])
    # a tunnel goes down too, but away from the centre line
    tunnel = TracedCurve(np.array([0.0, 1.0, 3.0, 5.0]), np.array([1.5, 1.4, 0.0, 9.0]))
    assert len(contours_of(Station(5.0, "aft", (tunnel,)))[0]) == 4


def test_corners_are_found_and_round_bilges_are_not() -> None:
    chine = np.array([[0.0, 0.0], [5.0, 1.0], [6.0, 5.0], [8.0, 9.0]])
    dense = np.concatenate([np.linspace(a, b, 50, endpoint=False) for a, b in itertools.pairwise(chine)])
    found = dense[corners_of(dense, BREADTH)]
    np.testing.assert_allclose(found, [[5.0, 1.0]], atol=1e-9)
    for radius, corners in ((0.3, 1), (1.6, 0)):
        turn = np.linspace(0, np.pi / 2, 30)
        bilge = np.stack([8 - radius + radius * np.sin(turn), radius - radius * np.cos(turn)], -1)
        whole = np.concatenate([[[0.0, 0.0]], bilge, [[8.0, 9.0]]])
        assert len(corners_of(whole, BREADTH)) == corners


def test_a_spline_keeps_corners_and_smooths_a_pens_width() -> None:
    rng = np.random.default_rng(4)
    clean = np.concatenate(
        [np.linspace([0.0, 0.0], [5.0, 1.0], 80), ellipse(2.0, 8.0, 1.0, 2.0)[1:] + np.array([5.0, 0.0])]
    )
    noisy = clean + rng.normal(0.0, 1e-4 * BREADTH, clean.shape)
    noisy[0] = clean[0]
    fair = fair_curve(noisy, BREADTH)
    # by 0.02 % in the mean, some times that at the worst
    assert largest_distance(fair, clean) < 1e-3 * BREADTH
    (corner,) = corners_of(noisy, BREADTH)
    assert np.min(np.linalg.norm(fair - noisy[corner], axis=1)) < 1e-12

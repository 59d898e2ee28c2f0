"""Ships drawn by formula, lofted with the profile that lies beside them: nearer to the form where something begins.

The form is known everywhere from the drawing script, which shares no geometry with the package.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from drawing.moulded import Moulded
from drawing.ships import outline
from fairness import distances, drawn_plan, waves_of

from hullform.doors.profile_reading import read_profile
from hullform.hull import Hull
from hullform.hull.crossings import crossing_triangles
from hullform.ship import read_ship

FOLDER = Path(__file__).parents[2] / "bodyplans"
Pair = tuple[Moulded, Hull, Hull]


def lofted(ship: str) -> Pair:
    form = outline(ship)
    plan, described = drawn_plan(form), read_ship(FOLDER / ship / "ship.toml")
    assert described.profile_path is not None
    with_profile = replace(plan, profile=read_profile(described, described.profile_path))
    return form, *(Hull.from_body_plan(given, form.particulars) for given in (plan, with_profile))


@pytest.fixture(scope="module")
def bulk_carrier() -> Pair:
    return lofted("handymax-bulk-carrier")


@pytest.fixture(scope="module")
def ropax() -> Pair:
    return lofted("fast-ropax")


# Largest distance from the form, per cent of the breadth: without the profile more than the first, with it less than
# the second. Measured with it: 1.1, 0.5 and 0.5 per cent.
@pytest.mark.parametrize(
    ("from_m", "to_m", "estimated", "given"),
    [
        (10.0, 14.5, 11.0, 1.5),  # the skeg
        (181.0, 188.5, 2.0, 0.8),  # the stem's foot above the bulb, and the bulb's tip
        (188.5, 190.0, 4.0, 0.8),  # the stem beyond the last station
    ],
)
def test_the_bulk_carrier_is_nearer_to_her_form(
    bulk_carrier: Pair, from_m: float, to_m: float, estimated: float, given: float
) -> None:
    form, without, with_profile = bulk_carrier
    places = np.linspace(from_m, to_m, 13)[1:-1]
    assert distances(without, form, places).max() > estimated
    assert distances(with_profile, form, places).max() < given


@pytest.mark.parametrize(
    ("from_m", "to_m", "estimated", "given"),
    [(14.6, 23.2, 3.0, 0.6), (178.0, 180.9, 1.2, 0.5), (180.9, 186, 20.0, 1.0)],
)
def test_the_ferry_is_nearer_to_her_form(
    ropax: Pair, from_m: float, to_m: float, estimated: float, given: float
) -> None:
    form, without, with_profile = ropax
    places = np.linspace(from_m, to_m, 13)[1:-1]
    assert distances(without, form, places).max() > estimated
    assert distances(with_profile, form, places).max() < given


@pytest.mark.parametrize("ship", ["bulk_carrier", "ropax"])
def test_the_rest_of_the_hull_is_as_good(ship: str, request: pytest.FixtureRequest) -> None:
    form, without, with_profile = request.getfixturevalue(ship)
    main = form.particulars
    x = np.array(sorted({x for _, x in main.aft_stations + main.fore_stations}))
    # the stations stay as they are
    for place in x.tolist():
        for one, other in zip(without.section_curves(place), with_profile.section_curves(place), strict=True):
            assert one == pytest.approx(other, abs=1e-9)
    # volume: what is left between 20 stations, 0.2 %; LCB likewise, in per cent of the length
    truth = form.coefficients()
    found = with_profile.hydrostatics()
    assert found.displacement_kg / 1e3 == pytest.approx(truth["displacement_t"], rel=1.5e-3)
    lcb_percent = 100 * found.lcb_from_midships_m / main.length_between_perpendiculars_m
    assert lcb_percent == pytest.approx(truth["lcb_percent"], abs=0.02)
    # no ripple that was not there
    before, after = waves_of(without, x), waves_of(with_profile, x)
    assert after.count <= before.count
    assert after.largest_percent <= before.largest_percent + 1e-6
    mesh = with_profile.mesh()
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume == pytest.approx(with_profile.volume_m3, rel=1e-3)
    assert len(crossing_triangles(np.asarray(mesh.vertices), np.asarray(mesh.faces))) == 0
    assert with_profile.doubts == ()

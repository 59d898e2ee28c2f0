"""The drawn ships, lofted from the stations that their drawings show, against the drawing script's own integration.

The script shares no geometry code with the package: it interpolates 1/p and 1/q and sums trapezoids.
"""

import numpy as np
import pytest
from drawing.ships import outline

from hullform.body_plan import BodyPlan, Station, TracedCurve
from hullform.hull import Hull


@pytest.mark.parametrize("ship", ["scim-containership", "ds-tanker", "wigley"])
@pytest.mark.parametrize("noise", [0.0, 1e-3])
def test_displacement_and_trim_of_a_drawn_ship(ship: str, noise: float) -> None:
    drawn = outline(ship)
    main, truth = drawn.particulars, drawn.coefficients()
    rng = np.random.default_rng(7)
    stations = []
    for half, shown in (("aft", main.aft_stations), ("fore", main.fore_stations)):
        for name, x in shown:
            # noise: as a share of the half-breadth, 0.5 px of a 2000 px drawing.
            y, z = (drawn.section(x, 300) + rng.normal(0.0, noise * main.breadth_m / 2, (300, 2))).T
            stations.append(Station(x, half, (TracedCurve(np.abs(y), z),), name))
    hull = Hull.from_body_plan(BodyPlan(tuple(stations), "offsets"), main)
    found = hull.hydrostatics()
    # What the two interpolations make of the form between the shown stations: the drawing's tables have finer steps at
    # the ends than the stations shown, worth a per cent of area there and a tenth of that in volume.
    assert found.displacement_kg / 1e3 == pytest.approx(truth["displacement_t"], rel=2e-3)
    lcb_percent = 100 * found.lcb_from_midships_m / main.length_between_perpendiculars_m
    assert lcb_percent == pytest.approx(truth["lcb_percent"], abs=0.05)
    assert found.waterplane_coefficient == pytest.approx(truth["waterplane"], rel=3e-3)
    assert found.midship_coefficient == pytest.approx(truth["midship"], rel=2e-3)
    for place in np.linspace(0.02, 0.98, 25) * main.length_overall_m:
        area = float(hull.sectional_areas(main.draught_m, place))
        largest = truth["midship"] * main.breadth_m * main.draught_m
        assert abs(area - drawn.section_area(float(place), main.draught_m)) < 0.025 * largest
    mesh = hull.mesh()
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(hull.volume_m3, rel=1e-3)

"""Girders in water that others solved: a 157.5 m ship with tabled added mass, an elastic barge of 1.52 m.

Regressions for solvers: the ship's tables contradict themselves in places, and nothing of either was measured. The
data lie outside the repository: HULLFORM_SHARED points at them.
"""

import numpy as np
import pytest
from floating_bodies import prism_sections, rectangle
from shared import reference

from hullvib import FiniteElements, Girder, PointMass, StodolaRitz, solve, wet


@pytest.fixture(scope="module")
def ship():
    return reference("ship157.json")


@pytest.fixture(scope="module")
def barge():
    return reference("measured.json")["elastic_barge_1p52m"]


def girder_of(ship, added):
    mass = np.array(ship["m_kg_per_m"]) + added * np.array(ship["added_mass_j2_kg_per_m"])
    return Girder.from_tables(mass=(ship["x_m"], mass), rigidity=(ship["x_EI"], ship["EI_Nm2"]))


@pytest.mark.parametrize(("added", "medium"), [(0.0, "dry"), (1.0, "wet_j2")])
@pytest.mark.parametrize("method", [StodolaRitz(12), FiniteElements(100)], ids=["stodola", "elements"])
def test_ship_of_157_m_with_the_added_mass_in_her_girder(ship, added, medium, method):
    found = solve(girder_of(ship, added), method, 3).angular_frequencies
    assert found == pytest.approx(ship["computed_rad_s"][medium]["FEM"], rel=1e-4)


def test_ship_of_157_m_with_the_added_mass_in_the_water(ship):
    """The same, the added mass given to the strips as theirs: dry modes and water apart, one Ritz basis."""
    half, draught = np.array(ship["sections"]["B_m"]) / 2, np.array(ship["sections"]["T_m"])
    curves = [[[0.0, -t], [b, -t], [b, 0.0]] for b, t in zip(half, draught, strict=True)]
    flow = wet.StripFlow(wet.Sections(ship["x_m"], curves), ship["added_mass_j2_kg_per_m"], "none")
    found = wet.solve(girder_of(ship, 0.0), flow, modes=3, hydrostatics=False)
    assert found.modes.angular_frequencies == pytest.approx(ship["computed_rad_s"]["wet_j2"]["FEM"], rel=1e-6)


def test_her_sections_have_lewis_coefficients(ship):
    sections = ship["sections"]
    found = wet.lewis_coefficient(sections["B_m"], sections["T_m"], sections["A_m2"])
    # one section, near the aft end, is finer than the family reaches: it is brought to its limit
    fullness = np.array(sections["A_m2"]) / (np.array(sections["B_m"]) * np.array(sections["T_m"]))
    ratio = np.array(sections["B_m"]) / (2 * np.array(sections["T_m"]))
    inside = fullness > 3 * np.pi / 32 * (2 - np.minimum(ratio, 1 / ratio))
    assert np.count_nonzero(~inside) == 1
    np.testing.assert_allclose(found[inside], np.array(sections["C_lewis_computed"])[inside], atol=2e-3)


def elastic_barge(barge, mass_per_length):
    length, youngs = barge["L"], barge["E"]
    shear = youngs / (2 * (1 + barge["nu"])) * barge["A"] * barge["kv"]
    masses = [
        PointMass(station * length / 20, mass)
        for station, mass in zip(barge["point_stations_of_20"], barge["point_masses_kg"], strict=True)
    ]
    return Girder(
        [0.0, length], [mass_per_length] * 2, [youngs * barge["Iv"]] * 2, shear_rigidity=[shear] * 2,
        point_masses=masses,
    )  # fmt: skip


def test_elastic_barge(barge):
    spread = (barge["displacement_kg"] - sum(barge["point_masses_kg"])) / barge["L"]
    girder = elastic_barge(barge, spread)
    dry = solve(girder, StodolaRitz(16, shear=True)).frequencies_hz
    assert dry == pytest.approx(barge["computed"]["barge_dry_Timo_Hz"], rel=0.005)
    sections = prism_sections(rectangle(barge["B"], barge["T"]), barge["L"])
    flow = wet.PanelFlow(
        wet.Panels.from_sections(sections, 46, 11),
        neutral_axis_m=barge["z_centroid_over_bottom"] - barge["T"],
        density_kg_m3=barge["rho"],
    )
    wet_hz = wet.solve(girder, flow, StodolaRitz(16), 3, functions=16).modes.frequencies_hz
    assert wet_hz == pytest.approx(barge["computed"]["barge_wet_EB_w_inf_Hz"], rel=0.01)

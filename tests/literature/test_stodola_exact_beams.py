"""Stodola-Ritz and its brackets on beams with exact answers: tapered, sharp, exponential, end masses, stepped.

Every beam is given on x = 0..1 with unit mass and rigidity at its reference section. The answers come from
characteristic equations in 45-digit arithmetic (tests/data/exact_beams.json).
"""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial import Polynomial
from reference_girders import beam

from hullvib import Girder, NotProven, StodolaRitz, bracket, solve

DATA = Path(__file__).parents[1] / "data"
XI = Polynomial([0.0, 1.0])

# the first three of each, 15 digits
FINITE = {
    "uniform": [22.3732854480613, 61.6728228679202, 120.903391727123],
    "wedge_c0.5": [16.7241578083102, 45.5025996741302, 88.7110698874817],
    "wedge_c0.2": [13.3835369963825, 34.4883412776594, 65.7365637166755],
    "cone_c0.5": [17.0793337536618, 45.9629821823247, 89.2138763444349],
    "double_wedge_c0.5": [21.8259727948387, 49.9768523635885, 94.6291263794068],
    "exponential_a2": [22.9377267723740, 62.4227321831193, 121.722732372407],
    "abrate_quartic_c0.5": [24.6194206709236, 64.5650477731381, 124.074303364798],
    "timoshenko_hull_b0.75_c0.75": [28.5514146706233, 71.2715842546370, 132.866298797446],
    "timoshenko_hull_b0.5_c0.5": [25.5418790436556, 66.2508813398146, 126.274004243647],
    "timoshenko_hull_b0.75_c0.5": [25.2051584504303, 64.0101470400540, 120.496131822550],
    "uniform_endmass_0.1_0.1": [17.2695451982366, 49.9601489278055, 101.317895577884],
    "uniform_endmass_0.5_0.5": [12.7937136057281, 42.8576063710817, 92.4036042551996],
}
SHARP = {
    "wedge_sharp": [12.7575088709440, 27.7553529693745, 47.5759448930284],
    "cone_sharp": [17.4164576741972, 35.0269759566952, 57.3796409776707],
    "double_wedge_sharp": [26.3746164271633, 43.6094489507007, 70.8499989190958],
    "double_cone_sharp": [40.7064658182003, 61.6273420895527, 95.2775725440371],
    "jacobi_a0_b0": [19.5959179422654, 43.8178046004132, 75.8946638440411],
    "jacobi_a1_b1": [30.9838667696593, 63.4980314655501, 103.691851174525],
    "jacobi_a2_b1": [36.6606055596467, 73.3212111192934, 117.575507653592],
}
# (a, mu, e): segments [0, a], [a, 1 - a], [1 - a, 1] with m = mu, 1, mu and EI = e, 1, e; transfer matrices
STEPPED = {
    (0.25, 0.5, 0.25): [24.870305803505, 52.075042570106, 97.118969195744],
    (0.2, 2.0, 0.4): [18.024868993184, 46.485694759540, 80.074837492509],
}


def stepped(a: float, mu: float, e: float) -> Girder:
    return Girder([0, a, a, 1 - a, 1 - a, 1], [mu, mu, 1, 1, mu, mu], [e, e, 1, 1, e, e])


@pytest.mark.parametrize("name", FINITE)
def test_finite_ends(name):
    # two steps leave 2e-13 in mode 3 where measured on another beam; the table has 15 digits
    assert solve(beam(name), modes=3).angular_frequencies == pytest.approx(FINITE[name], rel=1e-10, abs=0)


@pytest.mark.parametrize("name", SHARP)
def test_sharp_ends_with_sixteen_functions(name):
    # uniform modes converge slowly towards a sharp end; what two steps leave of that is 3e-9 in mode 3
    errors = solve(beam(name), StodolaRitz(16), modes=3).angular_frequencies / SHARP[name] - 1
    assert np.abs(errors).max() < 1e-8


@pytest.mark.parametrize("shape", STEPPED)
def test_steps_of_mass_and_rigidity(shape):
    assert solve(stepped(*shape), modes=3).angular_frequencies == pytest.approx(STEPPED[shape], rel=1e-10, abs=0)


@pytest.mark.parametrize("name", FINITE)
def test_brackets_contain_the_exact_answers(name):
    if name == "exponential_a2":
        with pytest.raises(NotProven, match="extremes"):
            bracket(beam(name))
        return
    found = bracket(beam(name), modes=3)
    exact = np.array(FINITE[name])
    assert (found.lower <= exact * (1 + 1e-15)).all()
    assert (found.upper >= exact * (1 - 1e-15)).all()
    # margins for rounding are 1e-8 to 1e-7 with functions good to 1e-10
    assert (found.relative_width < 1e-6).all()


@pytest.mark.parametrize("shape", STEPPED)
def test_brackets_of_stepped_beams(shape):
    found = bracket(stepped(*shape), modes=3)
    assert (found.lower <= STEPPED[shape]).all()
    assert (found.upper >= STEPPED[shape]).all()


@pytest.mark.parametrize("name", SHARP)
def test_sharp_ends_have_no_comparison_beam(name):
    with pytest.raises(NotProven, match="vanishes at x"):
        bracket(beam(name))


def test_the_whole_file():
    content = json.loads((DATA / "exact_beams.json").read_text(encoding="utf-8"))
    names = [name for name in content["beams"] if name in FINITE or name in SHARP]
    assert len(names) == len(FINITE) + len(SHARP)
    for name in names:
        exact = np.array([float(value) for value in content["beams"][name]["Omega"][:5]])
        functions, tolerance = (16, 1e-8) if name in SHARP else (12, 1e-10)
        found = solve(beam(name), StodolaRitz(functions), modes=5).angular_frequencies
        assert found[:3] == pytest.approx(exact[:3], rel=tolerance, abs=0), name
    for entry in content["extra"]["stepped_symmetric"]["cases"]:
        exact = [float(value) for value in entry["Omega"]]
        found = solve(stepped(entry["a"], entry["mu"], entry["e"]), modes=3).angular_frequencies
        assert found == pytest.approx(exact[:3], rel=1e-10, abs=0)

"""The three bench girders against 20-digit answers of another computation (exact pieces in high precision)."""

import json
from pathlib import Path

import numpy as np
import pytest
from reference_girders import ANSWERS, LENGTH, case

from hullvib import FiniteElements, Girder, Ritz, solve

DATA = Path(__file__).parents[1] / "data"

# Case C, N = 12, modes 1, 2, 3 and 6: measured with a separate program for the same trial space, kept to one digit.
RITZ_ERRORS_C = {0: 1e-3, 1: 4e-3, 2: 3e-3, 5: 4e-3}


@pytest.mark.parametrize("name", ANSWERS)
def test_finite_elements(name):
    # 100 elements: (g h)^4 / 1440 with g L = 20 at mode 6 is 1e-6
    frequencies = solve(case(name), FiniteElements(100), modes=6).angular_frequencies
    assert frequencies == pytest.approx(ANSWERS[name], rel=2e-6)
    assert (frequencies > np.array(ANSWERS[name]) * (1 - 1e-9)).all()


@pytest.mark.parametrize(("name", "tolerance"), [("A", 1e-13), ("B", 5e-5)])
def test_ritz_on_smooth_girders(name, tolerance):
    # A lies in the trial space; B converges with N^-7: (1/12)^7 times a few for the lowest modes, 5e-5 at mode 6
    frequencies = solve(case(name), Ritz(12), modes=6).angular_frequencies
    assert frequencies == pytest.approx(ANSWERS[name], rel=tolerance)


def test_ritz_on_the_saw_tooth_girder_errs_as_measured_elsewhere():
    errors = solve(case("C"), Ritz(12), modes=6).angular_frequencies / ANSWERS["C"] - 1
    for mode, printed in RITZ_ERRORS_C.items():
        assert float(f"{errors[mode]:.0e}") == printed


def test_the_case_file_defines_the_same_girders():
    content = json.loads((DATA / "bench_cases.json").read_text(encoding="utf-8"))
    answers = json.loads((DATA / "bench_reference.json").read_text(encoding="utf-8"))
    for name, entry in content["cases"].items():
        segments = entry["segments"]
        breaks = [segments[0]["x0"], *(segment["x1"] for segment in segments)]
        girder = Girder.from_polynomials(breaks, [s["m"] for s in segments], [s["EI"] for s in segments])
        x = np.linspace(0.05, LENGTH - 0.05, 997)
        # the file's numbers carry 16 digits, of which differences of neighbours lose a few
        assert girder.mass_per_length(x) == pytest.approx(case(name).mass_per_length(x), rel=1e-11)
        assert girder.flexural_rigidity(x) == pytest.approx(case(name).flexural_rigidity(x), rel=1e-11)
        exact = [float(value) for value in answers[name]["omega"]]
        assert solve(girder, FiniteElements(100), modes=6).angular_frequencies == pytest.approx(exact, rel=2e-6)

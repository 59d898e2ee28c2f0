"""Stodola-Ritz and its brackets on the bench girders, against 20-digit answers of another computation."""

import numpy as np
import pytest
from reference_girders import ANSWERS, LENGTH, case

from hullvib import FiniteElements, StodolaRitz, bracket, solve


@pytest.mark.parametrize("name", ANSWERS)
def test_two_steps_on_twelve_functions(name):
    errors = np.abs(solve(case(name), modes=6).angular_frequencies / ANSWERS[name] - 1)
    # an independent trial code, two steps: 7e-16, 1e-16, 2e-13 in modes 1 to 3 and 8e-9 in mode 6 of case C
    assert (errors[:3] < 1e-11).all()
    assert errors[5] < 1e-7


def test_one_step_errs_as_measured_elsewhere():
    errors = solve(case("C"), StodolaRitz(steps=1), modes=6).angular_frequencies / ANSWERS["C"] - 1
    # of the same trial code, printed with one digit
    assert [float(f"{errors[mode]:.0e}") for mode in (0, 1, 2, 5)] == [1e-11, 2e-9, 1e-8, 4e-6]


@pytest.mark.parametrize("name", ANSWERS)
def test_brackets_contain_the_answers_and_are_narrow(name):
    found = bracket(case(name), modes=5, functions=12)
    exact = np.array(ANSWERS[name][:5])
    assert (found.lower <= exact).all()
    assert (exact <= found.upper).all()
    # the truncation is below 1e-6 in mode 5; margins for rounding make it 1e-8 to 1e-7
    assert (found.relative_width <= 1e-6).all()


def test_shapes_and_forces_agree_with_fine_elements():
    girder = case("C")
    ours, fine = solve(girder, modes=4), solve(girder, FiniteElements(400), modes=4)
    x = np.linspace(0.0, LENGTH, 500)
    # cubic elements of h = L/400 err by (g h)^4 / 384 in shapes: 2e-8, and by one order of h less a derivative
    for quantity, tolerance in (("shape", 1e-6), ("slope", 1e-5), ("curvature", 2e-3), ("moment", 1e-5)):
        a, b = getattr(ours, quantity)(x), getattr(fine, quantity)(x)
        assert np.abs(a - b).max() < tolerance * np.abs(b).max(), quantity

"""Stodola-Ritz and its brackets on the bench girders, against 20-digit answers of another computation."""

import numpy as np
import pytest

from hullvib import FiniteElements, Girder, StodolaRitz, bracket, solve

LENGTH, RIGIDITY, MEAN_MASS = 262.0, 52.118e12, 284962.0

# bench/reference.json, rad/s, modes 1-6
ANSWERS = {
    "A": [4.4078578114550473, 12.150429791097198, 23.819700548360490, 39.375174990086805, 58.819718340975258,
          82.153159709890292],
    "B": [4.9218558239898846, 12.818834605080646, 24.314249693211140, 39.406710633532919, 58.124341559928812,
          80.485025116693479],
    "C": [4.9991976900179876, 11.993742931176827, 21.490464361706317, 34.180751878304377, 50.339321490990351,
          70.079276652104245],
}  # fmt: skip


def case(name: str) -> Girder:
    if name == "A":
        return Girder([0, LENGTH], [MEAN_MASS] * 2, [RIGIDITY] * 2)
    if name == "B":
        u = np.polynomial.Polynomial([-1.0, 2.0 / LENGTH])
        mass, rigidity = MEAN_MASS / (1 - 0.7 / 3) * (1 - 0.7 * u**2), RIGIDITY * (1 - 0.6 * u**4)
        return Girder.from_polynomials([0, LENGTH], [mass.coef], [rigidity.coef])
    weights = np.array([3, 6, 4, 12, 5, 13, 6, 15, 5, 14, 7, 16, 6, 15, 5, 12, 4, 9, 3, 5])
    edges = np.arange(21) * (LENGTH / 20)
    return Girder.from_tables(
        mass=(np.repeat(edges, 2)[1:-1], np.repeat(weights / weights.mean() * MEAN_MASS, 2)),
        rigidity=(
            LENGTH * np.array([0, 0.2, 0.2, 0.5, 0.75, 0.75, 1]),
            RIGIDITY * np.array([0.25, 0.65, 0.95, 1.1, 1.0, 0.6, 0.15]),
        ),
    )


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

"""Timoshenko's beam against exact answers, against codes of others, and its rate of convergence.

Exact: uniform free-free beams from the characteristic equation, W'''' + Om^2 (r^2 + s^2) W'' - Om^2 (1 - Om^2 r^2 s^2)
W = 0 in 40-digit arithmetic; parabolic beams (m, EI, kGA, J all ~ 1 - 0.75 (2 xi - 1)^2) by a Legendre-Ritz solution
good to 6e-12. r^2 = J / (m L^2), s^2 = EI / (kGA L^2); Omega in sqrt(EI / (m L^4)), so with L = m = EI = 1 it is omega.
The codes of others: printed results of a commercial code for a 157 m ship, and two published flexible models.
"""

import numpy as np
import pytest
from scipy.linalg import eigh

from hullvib import (
    FiniteElements,
    Girder,
    PointMass,
    SolutionError,
    StodolaRitz,
    TimoshenkoElements,
    TimoshenkoRitz,
    solve,
)
from hullvib.timoshenko_elements import assemble

# (r^2, s^2): Omega
UNIFORM = {
    (0.0004, 0.002): [21.8972652337164166, 57.9377963025271747, 107.562089346385398, 166.824927283419284],
    (0.0009, 0.0045): [21.3540475685849563, 54.2151245952879069, 96.2774724102625469, 143.14960451132135],
    (0.0016, 0.012): [20.2751978733346516, 47.452153342161793, 78.4358753054047528, 109.879689657326161],
}
PARABOLIC = {
    (0.0004, 0.002): [27.805716034057042, 66.54051626416016, 117.43630632368257, 177.23183073705658],
    (0.0016, 0.012): [25.29626617023083, 53.66453271960962, 84.6848240675941, 116.03200408310518],
}


def uniform(r2, s2):
    return Girder([0, 1], [1, 1], [1, 1], [1 / s2] * 2, [r2] * 2)


def parabolic(r2, s2):
    row = np.array([0.25, 3.0, -3.0])
    return Girder.from_polynomials([0, 1], [row], [row], [row / s2], [row * r2])


CASES = [(uniform(*key), value) for key, value in UNIFORM.items()]
CASES += [(parabolic(*key), value) for key, value in PARABOLIC.items()]
IDS = [f"uniform {key}" for key in UNIFORM] + [f"parabolic {key}" for key in PARABOLIC]


@pytest.mark.parametrize(("girder", "exact"), CASES, ids=IDS)
def test_two_field_ritz_reaches_the_exact_answers(girder, exact):
    modes = solve(girder, TimoshenkoRitz(20), modes=4)
    # spectral convergence: 4e-11 at N = 20 on the parabola; the project's promise is 1e-8
    assert modes.angular_frequencies == pytest.approx(exact, rel=1e-10)
    assert modes.theory == "Timoshenko"
    assert modes.method == {
        "method": "timoshenko_ritz",
        "functions": 20,
        "basis": "legendre",
        "stretches": 1,
        "rotary_inertia": "as the girder has it",
    }


@pytest.mark.parametrize(("girder", "exact"), CASES, ids=IDS)
def test_uniform_modes_converge_slowly_from_above(girder, exact):
    coarse, fine = (
        solve(girder, TimoshenkoRitz(n, basis="uniform"), modes=3).angular_frequencies / exact[:3] - 1 for n in (10, 20)
    )
    # strains and their gradients leave end terms that fall with N^-2, their energies with N^-3: 2^3 less 2.6 .. 3 for
    # the low numbers
    assert (fine > 0).all()
    assert (fine < coarse / 5).all()
    assert fine.max() < 1e-5


@pytest.mark.parametrize(("girder", "exact"), CASES, ids=IDS)
def test_elements_converge_with_h4_from_above(girder, exact):
    errors = [solve(girder, TimoshenkoElements(n), modes=4).angular_frequencies ** 2 / np.square(exact) - 1 for n in
              (20, 40)]  # fmt: skip
    # interior unknowns are solved sparsely: round-off 1e-10 against errors above 1e-7
    assert (errors[1] > 0).all()
    assert np.log2(errors[0] / errors[1]) == pytest.approx(np.full(4, 4.0), abs=0.06)
    assert errors[1].max() < 1e-4


def stepped():
    x = [0, 0.3, 0.3, 0.55, 0.55, 1]
    points = [PointMass(0.1, 0.2, 3e-3), PointMass(1.0, 0.1, 2e-3)]
    return Girder(x, [1, 2, 0.5, 1, 1, 1], [1, 2, 0.7, 1, 3, 2], [80, 90, 20, 30, 60, 50], [1e-3] * 6, points)


def test_steps_and_point_masses_keep_the_order_and_both_methods_agree():
    girder = stepped()
    squares = [solve(girder, TimoshenkoElements(n), modes=4).angular_frequencies ** 2 for n in (20, 40, 80)]
    ritz = solve(girder, TimoshenkoRitz(48), modes=4)
    # four stretches of twelve functions: spectral
    assert ritz.method["stretches"] == 4
    errors = [s / ritz.angular_frequencies**2 - 1 for s in squares]
    assert np.log2(errors[1] / errors[2]) == pytest.approx(np.full(4, 4.0), abs=0.15)
    assert (errors[2] > 0).all()
    assert errors[2].max() < 1e-5


def test_the_textbook_stiffness_matrix_is_condensed_from_the_element():
    # Przemieniecki, Theory of Matrix Structural Analysis, eq. (5.116): prismatic, phi = 12 EI / (kGA h^2)
    shear = 7.0
    girder = Girder([0, 1], [1, 1], [1, 1], [shear, shear])
    band, _, unit = assemble(girder, np.array([0.0, 1.0]), rotary=False)
    full = np.diag(band[0]) + sum(np.diag(band[k, :-k], -k) + np.diag(band[k, :-k], k) for k in range(1, 6))
    outer, inner = [0, 1, 4, 5], [2, 3]
    condensed = full[np.ix_(outer, outer)] - full[np.ix_(outer, inner)] @ np.linalg.solve(
        full[np.ix_(inner, inner)], full[np.ix_(inner, outer)]
    )
    phi = 12 / shear
    book = np.array(
        [[12, 6, -12, 6], [6, 4 + phi, -6, 2 - phi], [-12, -6, 12, -6], [6, 2 - phi, -6, 4 + phi]]
    ) / (1 + phi)  # fmt: skip
    assert unit == 1.0
    assert condensed == pytest.approx(book, rel=1e-13)


@pytest.mark.parametrize("shear", [1e6, 1e9, 1e13])
def test_nothing_locks_in_the_slender_limit(shear):
    girder = Girder([0, 1], [1, 1], [1, 1], [shear, shear])
    bernoulli = solve(Girder([0, 1], [1, 1], [1, 1]), FiniteElements(8), modes=3).angular_frequencies
    # shear lowers omega by about g^2 s^2 (1 + ...) / 2 with g^2 = 121 for mode 3; 1e-9 is round-off of 8 elements
    allowed = 200.0 / shear + 1e-9
    assert solve(girder, TimoshenkoElements(8), modes=3).angular_frequencies == pytest.approx(bernoulli, rel=allowed)
    exact = solve(Girder([0, 1], [1, 1], [1, 1]), modes=3).angular_frequencies
    for basis in ("legendre", "uniform"):
        ritz = solve(girder, TimoshenkoRitz(16, basis=basis), modes=3).angular_frequencies
        # Legendre polynomials of degree 17 leave 2e-13 on mode 3
        assert ritz == pytest.approx(exact, rel=allowed)


def test_without_rotary_inertia_the_theory_is_called_shear_flexible():
    bare = Girder([0, 1], [1, 1], [1, 1], [500, 500])
    full = uniform(0.0004, 0.002)
    for method in (TimoshenkoRitz(16), TimoshenkoElements(60)):
        modes = solve(bare, method)
        assert modes.theory == "shear-flexible"
        assert modes.method["rotary_inertia"] == "none given, taken as zero"
        left_out = solve(full, type(method)(rotary_inertia=False))
        assert left_out.theory == "shear-flexible"
        assert left_out.method["rotary_inertia"] == "left out"
        # rotary inertia lowers, here by more than a tenth of a per cent
        assert (modes.angular_frequencies > solve(full, method).angular_frequencies * 1.001).all()


def test_point_masses_bring_their_rotary_inertia():
    girder = Girder([0, 1], [1, 1], [1, 1], [300, 300], point_masses=[PointMass(0.0, 0.3, 0.01), PointMass(0.6, 0.2)])
    ritz, elements = solve(girder, TimoshenkoRitz(32), modes=3), solve(girder, TimoshenkoElements(200), modes=3)
    assert ritz.theory == elements.theory == "Timoshenko"
    # 200 elements: (g h)^4 / 1440 = 1e-8
    assert elements.angular_frequencies == pytest.approx(ritz.angular_frequencies, rel=1e-7)
    light = Girder([0, 1], [1, 1], [1, 1], [300, 300], point_masses=[PointMass(0.0, 0.3), PointMass(0.6, 0.2)])
    assert (solve(light, TimoshenkoRitz(32), modes=3).angular_frequencies > ritz.angular_frequencies * 1.01).all()


def test_rotation_shear_and_moment_satisfy_the_laws_of_the_section():
    girder = stepped()
    for method, limit in ((TimoshenkoRitz(48), 1e-5), (TimoshenkoElements(100), 5e-3)):
        modes = solve(girder, method, modes=3)
        # off the steps; five polynomials serve the first tenth; elements have linear curvatures and strains, with an
        # error of h^2 (g = 11: 1.2e-2 / 12)
        x = np.linspace(0.013, 0.987, 40)
        moment, shear = modes.moment(x), modes.shear(x)
        size = np.abs(moment).max(axis=1, keepdims=True)
        assert (np.abs(girder.flexural_rigidity(x) * modes.bending_curvature(x) - moment) < limit * size).all()
        # kGA (w' - psi) = - V with dM/dx = V - omega^2 J psi
        size = np.abs(shear).max(axis=1, keepdims=True)
        assert (np.abs(girder.shear_rigidity(x) * modes.shear_strain(x) + shear) < limit * size).all()
        assert np.abs(modes.rotation(x) - modes.slope(x)).max() > 0.05
        # the end mass of 0.1 with its rotary inertia of 0.002 hangs on the last section
        squares = modes.angular_frequencies**2
        held = -0.1 * squares * modes.shape([1.0])[:, 0], 2e-3 * squares * modes.rotation([1.0])[:, 0]
        assert np.abs(modes.shear([1.0])[:, 0] - held[0]).max() < 1e-6 * np.abs(shear).max()
        assert np.abs(modes.moment([1.0])[:, 0] - held[1]).max() < 1e-6 * np.abs(moment).max()


def test_a_girder_without_shear_rigidity_is_refused_with_the_remedy():
    for method in (TimoshenkoRitz(), TimoshenkoElements()):
        with pytest.raises(SolutionError, match=r"no shear rigidity.*shear_rigidity_N"):
            solve(Girder([0, 1], [1, 1], [1, 1]), method)


@pytest.mark.parametrize("method", [TimoshenkoRitz(24), TimoshenkoElements(40)], ids=str)
def test_a_massless_bay_is_solved_and_too_little_mass_is_refused(method):
    x, shear = [0, 4, 4, 6, 6, 10], [9, 9, 5, 5, 9, 9]
    girder = Girder(x, [2, 2, 0, 0, 1, 1], [5, 5, 1, 1, 5, 5], shear)
    nearly = Girder(x, [2, 2, 1e-9, 1e-9, 1, 1], [5, 5, 1, 1, 5, 5], shear)
    assert solve(girder, method, 3).angular_frequencies == pytest.approx(
        solve(nearly, method, 3).angular_frequencies, rel=1e-7
    )
    with pytest.raises(SolutionError, match="one point"):
        solve(Girder([0, 2], [0, 0], [3, 3], [9, 9], point_masses=[PointMass(0.5, 1.0)]), method)
    pair = Girder([0, 2], [0, 0], [3, 3], [9, 9], point_masses=[PointMass(0.5, 1.0), PointMass(2.0, 3.0)])
    with pytest.raises(SolutionError, match="only 0 elastic modes"):
        solve(pair, method)


# measured.json, ansys_beam3_157m: 20 prismatic bays of A = 195.453 m^2, I = 1190.675 m^4 with densities and moduli that
# hide the ship's own values; bay 4 without mass; the code printed its frequencies in Hz
NODES = [0.0, 7.88, 15.75, 23.63, 31.5, 39.38, 47.25, 55.13, 63.0, 70.88, 78.75, 86.63, 94.5, 102.38, 110.25, 118.13,
         126.0, 133.88, 141.75, 149.63, 157.5]  # fmt: skip
MODULI = [2975622460.23, 3843512344.46, 4711402228.69, 5269331439.99, 5703276382.1, 6044154385.5, 6260943137.28,
          *[6446762067.0] * 7, 6384769933.0, 6167797462.0, 5950824991.0, 5733852520.0, 5516880049.0,
          4835141539.0]  # fmt: skip
DENSITIES = [145.96, 266.24, 373.033, 0.0, 568.14, 661.642, 753.538, 841.874, 889.792, 895.93, 896.933, 883.737,
             832.036, 751.379, 665.123, 580.045, 501.892, 430.507, 329.192, 201.177]  # fmt: skip


def test_a_commercial_code_is_met_to_every_printed_digit_with_one_element_a_bay():
    x, density = np.repeat(NODES, 2)[1:-1], np.repeat(DENSITIES, 2)
    girder = Girder(x, 195.453 * density, 1190.675 * np.repeat(MODULI, 2), None, 1190.675 * density)
    modes = solve(girder, FiniteElements(20, rotary_inertia=True), modes=6)
    assert modes.method["elements"] == 20
    assert modes.theory == "Euler-Bernoulli with rotary inertia"
    printed = ["1.4241", "3.5227", "6.6445", "10.825", "15.93", "21.457"]
    decimals = [4, 4, 4, 3, 2, 3]
    assert [f"{f:.{d}f}" for f, d in zip(modes.frequencies_hz, decimals, strict=True)] == printed
    plain = solve(girder, FiniteElements(20), modes=6)
    assert plain.frequencies_hz == pytest.approx([1.4333, 3.5661, 6.7901, 11.2044, 16.7509, 22.8798], abs=5.1e-5)


@pytest.mark.parametrize("method", [TimoshenkoElements(100), TimoshenkoRitz(60)], ids=str)
def test_a_flexible_model_of_a_130_m_ship(method):
    """1:32, twenty intervals of constant mass on a uniform backbone; dry, computed by others: 8.098, 22.507 .. Hz."""
    full_scale = [50, 121, 119, 118, 78, 68, 71, 73, 83, 76, 80, 71, 73, 90, 70, 71, 76, 71, 38, 90]  # t/m
    length, modulus, area = 130 / 32, 2.1e11, 0.0012214
    x = np.repeat(np.linspace(0, length, 21), 2)[1:-1]
    ones = np.ones(40)
    shear = 0.36 * area * modulus / (2 * 1.29)
    girder = Girder(x, np.repeat(full_scale, 2) * 1e3 / 32**2, modulus * 5.009e-7 * ones, shear * ones)
    modes = solve(girder, method, modes=4)
    assert modes.theory == "shear-flexible"
    # their mesh is not known; 0.2 % is what the comparison is asked for, it holds to 2e-5
    assert modes.frequencies_hz == pytest.approx([8.09751, 22.5074, 43.3035, 70.4304], rel=2e-3)


@pytest.mark.parametrize("method", [TimoshenkoElements(100), TimoshenkoRitz(40)], ids=str)
def test_an_elastic_barge_with_point_masses(method):
    """1.52 m, eight point masses of 9.27 kg on a uniform hull, 15.6 kg in all; dry, shear, no rotary inertia."""
    length, modulus, area = 1.52, 2.15e9, 0.0036945
    masses = [0.5, 0.5, 0.5, 1, 2, 2.77, 1, 1]
    places = [1, 2.5, 4.5, 6.5, 8, 12, 15.5, 17.5]
    points = [PointMass(s * length / 20, m) for s, m in zip(places, masses, strict=True)]
    hull, shear = (15.6 - sum(masses)) / length, 0.32148 * area * modulus / (2 * 1.22)
    girder = Girder([0, length], [hull] * 2, [modulus * 5.9969e-6] * 2, [shear] * 2, point_masses=points)
    modes = solve(girder, method, modes=5)
    assert modes.frequencies_hz == pytest.approx([56.83856, 136.73483, 276.39603, 327.2083, 539.79094], rel=2e-3)
    euler = solve(girder, FiniteElements(100))
    assert euler.frequencies_hz == pytest.approx([58.90253, 156.53424, 348.42147, 471.78191, 901.17597], rel=1e-6)


def linear_elements(girder, count):
    """Frequencies by an independent method: linear deflection and angle, one point for shear, consistent mass."""
    nodes = np.linspace(0, girder.length, count + 1)
    h, middle = girder.length / count, 0.5 * (nodes[1:] + nodes[:-1])
    stiffness, mass = np.zeros((2 * count + 2, 2 * count + 2)), np.zeros((2 * count + 2, 2 * count + 2))
    bending, shear = girder.flexural_rigidity(middle) / h, girder.shear_rigidity(middle) * h
    inertia = girder.mass_per_length(middle) * h / 6
    strain, pair = np.array([-1 / h, -0.5, 1 / h, -0.5]), np.array([[2.0, 1.0], [1.0, 2.0]])
    for e in range(count):
        rows = slice(2 * e, 2 * e + 4)
        stiffness[rows, rows] += shear[e] * np.outer(strain, strain)
        stiffness[2 * e + 1 : 2 * e + 4 : 2, 2 * e + 1 : 2 * e + 4 : 2] += bending[e] * np.array([[1, -1], [-1, 1]])
        mass[2 * e : 2 * e + 3 : 2, 2 * e : 2 * e + 3 : 2] += inertia[e] * pair
    values = eigh(mass, stiffness + 1e-3 * mass, eigvals_only=True)[::-1]
    return np.sqrt(1 / values[2:5] - 1e-3)


def test_shear_lowers_a_container_ship_as_published_and_as_independent_elements_have_it():
    """A uniform beam with the midship values of a 262 m containership: I = 253 m^4, shear area 0.97 m^2, 74660 t."""
    mass, rigidity, shear = 74660e3 / 262, 2.06e11 * 253, 2.06e11 / 2.6 * 0.97
    girder = Girder([0, 262], [mass] * 2, [rigidity] * 2, [shear] * 2)
    bernoulli = solve(girder, modes=3).angular_frequencies
    methods = (TimoshenkoRitz(20), TimoshenkoElements(100), StodolaRitz(12, 2, shear=True))
    found = [solve(girder, method, modes=3).angular_frequencies for method in methods]
    for frequencies in found:
        # the known falls, to the digits in which they are quoted
        assert 100 * (1 - frequencies / bernoulli) == pytest.approx([5.6, 17.0, 29.0], abs=0.25)
        # fourth order with 100 elements: (11 / 100)^4 / 1440
        assert frequencies == pytest.approx(found[0], rel=1e-6)
    # (g h)^2 / 24 of linear elements: 1.3e-4 at g = 11
    assert linear_elements(girder, 200) == pytest.approx(found[0], rel=1e-3)

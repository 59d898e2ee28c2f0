"""The girder: its refusals, its exact integrals, its immutability."""

import math
import pickle

import numpy as np
import pytest

from hullvib import Girder, GirderError, PointMass


def test_integrals_of_a_table_with_a_jump_are_exact():
    # 0..2 m: 1 -> 3 kg/m; 2..6 m: 5 kg/m; point mass 8 kg at 6 m.
    girder = Girder([0, 2, 2, 6], [1, 3, 5, 5], [1, 1, 2, 2], point_masses=[PointMass(6.0, 8.0)])
    assert girder.length == 6.0
    assert girder.total_mass == pytest.approx(4 + 20 + 8, rel=1e-15)
    # first moment: int_0^2 (1 + x) x dx = 2 + 8/3; 5 * (36 - 4) / 2 = 80; 48
    assert girder.centre_of_gravity == pytest.approx((2 + 8 / 3 + 80 + 48) / 32, rel=1e-15)


def test_properties_are_continuous_from_the_right_at_a_jump():
    girder = Girder([0, 2, 2, 6], [1, 3, 5, 7], [1, 1, 2, 2])
    assert girder.mass_per_length([0.0, 1.0, 2.0, 4.0, 6.0]).tolist() == [1.0, 2.0, 5.0, 6.0, 7.0]
    assert girder.flexural_rigidity(2.0) == 2.0
    assert girder.shear_rigidity(1.0) is None


def test_tables_with_breakpoints_of_their_own_are_merged():
    girder = Girder.from_tables(
        mass=([0, 3, 3, 10], [2, 2, 4, 4]), rigidity=([0, 5, 10], [1, 2, 1]), shear_rigidity=([0, 10], [1, 3])
    )
    assert girder.breaks.tolist() == [0.0, 3.0, 5.0, 10.0]
    assert girder.flexural_rigidity([3.0, 5.0, 7.5]) == pytest.approx([1.6, 2.0, 1.5], rel=1e-15)
    assert girder.shear_rigidity([0.0, 5.0, 10.0]) == pytest.approx([1.0, 2.0, 3.0], rel=1e-15)
    assert girder.total_mass == pytest.approx(34.0, rel=1e-15)


def test_tables_whose_breakpoints_differ_by_round_off_share_them():
    girder = Girder.from_tables(mass=([0, 0.1 + 0.2, 1], [1, 1, 2]), rigidity=([0, 0.3, 1], [1, 1, 2]))
    assert len(girder.breaks) == 3


def test_polynomials_are_power_series_in_the_distance_from_the_left_break():
    girder = Girder.from_polynomials([0, 2, 5], mass=[[1.0], [2, 0, 3]], rigidity=[[4, 1], [6]])
    assert girder.mass_per_length([1.0, 4.0]) == pytest.approx([1.0, 2 + 3 * 4], rel=1e-14)
    assert girder.flexural_rigidity([1.0, 4.0]) == pytest.approx([5.0, 6.0], rel=1e-14)


def test_functions_are_fitted_to_round_off_and_never_called_on_a_breakpoint():
    seen = []

    def mass(x):
        seen.append(x)
        return 2.0 + math.sin(x) if x < 3 else 5.0

    girder = Girder.from_functions(10.0, mass, lambda x: math.exp(-0.3 * x), breakpoints=[3.0])
    assert girder.residual < 1e-12  # the fit's own tolerance is 2e-13, halved until reached
    assert not {0.0, 3.0, 10.0} & set(seen)
    x = np.linspace(0.01, 2.99, 57)
    # 1e-12: the residual between the probes may be a few times that at the probes
    assert girder.mass_per_length(x) == pytest.approx(2 + np.sin(x), rel=1e-12)
    # int_0^3 2 + sin x dx = 7 - cos 3
    assert girder.total_mass == pytest.approx(7 - math.cos(3) + 35, rel=1e-13)


def test_a_jump_that_is_not_named_leaves_its_mark_in_the_residual():
    girder = Girder.from_functions(1.0, lambda x: 1.0 if x < 0.3 else 2.0, lambda x: 1.0)
    assert girder.residual > 0.05
    assert len(girder.breaks) < 100


def test_a_further_breakpoint_changes_no_value():
    girder = Girder.from_polynomials([0, 4], mass=[[1, 2, 3, 4]], rigidity=[[5, -1]])
    finer = girder.refined([1.0, 2.5, 4.0])
    x = np.linspace(0, 4, 101)
    assert finer.breaks.tolist() == [0.0, 1.0, 2.5, 4.0]
    assert finer.mass_per_length(x) == pytest.approx(girder.mass_per_length(x), rel=1e-13)
    assert finer.flexural_rigidity(x) == pytest.approx(girder.flexural_rigidity(x), rel=1e-13)
    with pytest.raises(GirderError, match="cannot cut"):
        girder.refined([5.0])


def test_a_girder_is_immutable_and_equal_by_content():
    girder = Girder([0, 1], [1, 2], [3, 4], [5, 6], [7, 8], [PointMass(0.5, 1.0, 2.0)], name="one")
    twin = Girder([0.0, 1.0], [1, 2], [3, 4], [5, 6], [7, 8], [PointMass(0.5, 1.0, 2.0)], name="another")
    assert girder == twin
    assert hash(girder) == hash(twin)
    assert girder != Girder([0, 1], [1, 2], [3, 4])
    assert girder != "one"
    with pytest.raises(ValueError, match="read-only"):
        girder.mass_coefficients[0, 0] = 9.0
    with pytest.raises(AttributeError, match="immutable"):
        girder.name = "x"
    with pytest.raises(AttributeError, match="immutable"):
        del girder.name
    copy = pickle.loads(pickle.dumps(girder))
    assert copy == girder
    assert copy.name == "one"
    assert not copy.breaks.flags.writeable
    assert "one" in repr(girder)


def test_the_callers_arrays_are_neither_frozen_nor_shared():
    x, m = np.array([0.0, 1.0]), np.array([1.0, 2.0])
    girder = Girder(x, m, m)
    m[0] = 5.0
    x[1] = 3.0
    assert girder.mass_per_length(0.0) == 1.0
    assert girder.length == 1.0
    coefficients = np.array([[1.0, 1.0]])
    other = Girder.from_bernstein([0, 1], coefficients, coefficients)
    coefficients[0, 0] = 7.0
    assert other.mass_per_length(0.0) == 1.0


def test_a_massless_bay_and_sharp_ends_are_allowed():
    Girder([0, 1, 1, 2], [0, 0, 1, 1], [1, 1, 1, 1])
    Girder([0, 1, 2], [0, 1, 0], [0, 1, 0])
    Girder.from_polynomials([0, 1], mass=[[1]], rigidity=[[1, -3, 3, -1]])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([0], [1], [1]), "at least 2 breakpoints"),
        (([0, 0], [1, 1], [1, 1]), "zero length"),
        (([1, 2], [1, 1], [1, 1]), "starts at 1 m"),
        (([0, 2, 1], [1, 1, 1], [1, 1, 1]), "falls from 2 m to 1 m at index 2"),
        (([0, 1, 1, 1, 2], [1] * 5, [1] * 5), "three times from index 1"),
        (([0, 1, 1], [1] * 3, [1] * 3), "an end, stands twice"),
        (([0, 0, 1], [1] * 3, [1] * 3), "an end, stands twice"),
        (([0, 1], [1, math.nan], [1, 1]), "mass per length has nan at index 1"),
        (([0, math.inf], [1, 1], [1, 1]), "x has inf at index 1"),
        (([0, 1], [1, 1], [1, math.inf]), "flexural rigidity has inf at index 1"),
        (([0, 1], [1, -2], [1, 1]), "mass per length is -2 at x = 1 m"),
        (([0, 1], [0, 0], [1, 1]), "no mass at all"),
        (([0, 1, 2], [1, 1, 1], [1, 0, 1]), "flexural rigidity is 0 at x = 1 m"),
        (([0, 1], [1, 1], [0, 0]), "flexural rigidity is 0 within"),
        (([0, 1], [1, 1], [1, -1]), "flexural rigidity is -1"),
        (([0, 1], [1, 1, 1], [1, 1]), "has 3 values but x has 2"),
        (([[0, 1]], [1, 1], [1, 1]), "2 dimensions"),
        (([0, 1], ["a", 1], [1, 1]), "not a sequence of numbers"),
        (([0, 1, 2], [1, 1, 1], [1, 1, 1], [1, 0, 1]), "shear rigidity is 0 at x = 1 m"),
        (([0, 1], [1, 1], [1, 1], None, [1, -1]), "rotary inertia is -1"),
        (([0, 1], [1, 1], [1, 1], None, None, [PointMass(1.5, 2.0)]), "outside 0 .. 1 m"),
    ],
)
def test_a_wrong_table_is_refused_with_the_place(arguments, message):
    with pytest.raises(GirderError, match=message):
        Girder(*arguments)


def test_a_curve_that_dips_below_zero_within_a_piece_is_refused():
    # 1 - 6 s + 6 s^2 is 1 at both ends and -0.5 in the middle
    with pytest.raises(GirderError, match=r"mass per length is -0\.5 at x = 0\.5 m"):
        Girder.from_polynomials([0, 1], mass=[[1, -6, 6]], rigidity=[[1]])
    # 1 - 3 s + 3 s^2 has a negative coefficient in Bernstein form, but stays above 1/4
    Girder.from_polynomials([0, 1], mass=[[1, -3, 3]], rigidity=[[1, -3, 3]])


@pytest.mark.parametrize("mass", [-1.0, math.nan])
def test_a_wrong_point_mass_is_refused(mass):
    with pytest.raises(GirderError, match="mass_kg"):
        PointMass(0.0, mass)


def test_mismatched_pieces_and_lengths_are_refused():
    with pytest.raises(GirderError, match="2 pieces"):
        Girder.from_polynomials([0, 1, 2], mass=[[1]], rigidity=[[1], [1]])
    with pytest.raises(GirderError, match="empty polynomial"):
        Girder.from_polynomials([0, 1], mass=[[]], rigidity=[[1]])
    with pytest.raises(GirderError, match="shape"):
        Girder.from_bernstein([0, 1], [1.0, 1.0], [[1.0]])
    with pytest.raises(GirderError, match="equally long rows"):
        Girder.from_bernstein([0, 1, 2], [[1.0, 1.0], [1.0]], [[1.0]] * 2)
    with pytest.raises(GirderError, match="no length"):
        Girder.from_bernstein([0, 2, 1], [[1.0]] * 2, [[1.0]] * 2)
    with pytest.raises(GirderError, match="whole length"):
        Girder.from_tables(mass=([0, 1], [1, 1]), rigidity=([0, 2], [1, 1]))
    with pytest.raises(GirderError, match="must be finite"):
        Girder.from_functions(1.0, lambda x: math.nan, lambda x: 1.0)
    with pytest.raises(GirderError, match="outside the girder"):
        Girder([0, 1], [1, 1], [1, 1]).mass_per_length(1.5)


def test_a_girder_cut_anew_keeps_the_residual_of_its_fit():
    girder = Girder.from_functions(10, lambda x: 1 + (x > 3.3), lambda x: 1)
    assert girder.residual > 0.1  # a jump that is not named
    assert girder.refined([1.0, 2.0, 7.0]).residual == girder.residual


@pytest.mark.parametrize("value", [10**400, "heavy", None])
def test_a_point_mass_that_is_no_number_is_refused(value):
    with pytest.raises(GirderError, match="mass_kg is"):
        PointMass(0.0, value)

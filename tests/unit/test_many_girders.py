"""solve_many gives what solve gives one by one, in any chunks."""

import numpy as np
import pytest

import hullvib.many
from hullvib import (
    ArgumentError,
    Girder,
    GirderError,
    GirderStack,
    PointMass,
    Ritz,
    SolutionError,
    StodolaRitz,
    solve,
    solve_many,
)

BREAKS = np.linspace(0, 262, 21)
METHODS = [Ritz(12), StodolaRitz(12, 1), StodolaRitz(12, 2)]


def stack(count: int, *, steep: float = 1.0) -> GirderStack:
    rng = np.random.default_rng(7)
    mass = 2e5 * (0.5 + rng.random((count, 20, 2)))
    rigidity = 3e13 * (1.0 + steep * rng.random((count, 20, 2)))
    return GirderStack(BREAKS, mass, rigidity, np.array([0.0, 100.0]), 1e6 * rng.random((count, 2)))


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("steep", [1.0, 30.0])
def test_the_same_as_one_by_one(method, steep):
    girders = stack(40, steep=steep)
    many = solve_many(girders, method, modes=6)
    assert many.angular_frequencies.shape == (40, 6)
    assert many.shapes.shape == (40, 6, 21)
    for number in range(40):
        alone = solve(girders.girder(number), method, modes=6)
        # the same algebra; cells that suit all girders move the truncation of 1e-12
        assert many.angular_frequencies[number] == pytest.approx(alone.angular_frequencies, rel=1e-10)
        shape = alone.normalised("unit-modal-mass").shape(BREAKS)
        assert np.abs(many.shapes[number] - shape).max() < 1e-7 * np.abs(shape).max()


def test_chunks_change_nothing(monkeypatch):
    girders = stack(11)
    whole = solve_many(girders, modes=4)
    monkeypatch.setattr(hullvib.many, "_NUMBERS", 1)
    single = solve_many(girders, modes=4)
    assert single.angular_frequencies == pytest.approx(whole.angular_frequencies, rel=1e-12)
    assert single.shapes == pytest.approx(whole.shapes, rel=1e-8, abs=1e-12)


def test_the_record_and_the_units():
    many = solve_many(stack(2), Ritz(9), modes=3)
    assert many.method == {"method": "ritz", "functions": 9, "rigid_body": True}
    assert solve_many(stack(2)).method == {"method": "stodola_ritz", "functions": 12, "steps": 1}
    assert many.frequencies_hz == pytest.approx(many.angular_frequencies / (2 * np.pi), rel=1e-15)


def test_a_stack_from_girders():
    girders = [
        Girder(BREAKS, np.full(21, m), np.full(21, 1e13), point_masses=[PointMass(30, m)]) for m in (1e5, 2e5, 3e5)
    ]
    many = solve_many(GirderStack.from_girders(girders), modes=3)
    for girder, omega in zip(girders, many.angular_frequencies, strict=True):
        assert omega == pytest.approx(solve(girder, StodolaRitz(steps=1), modes=3).angular_frequencies, rel=1e-12)
    assert len(GirderStack.from_girders(girders)) == 3


def test_refusals():
    with pytest.raises(GirderError, match="girder 1 has other breakpoints"):
        GirderStack.from_girders([Girder([0, 1], [1, 1], [1, 1]), Girder([0, 2], [1, 1], [1, 1])])
    with pytest.raises(GirderError, match="at least one"):
        GirderStack.from_girders([])
    with pytest.raises(GirderError, match="rigidity is 0 in girder 0, piece 1"):
        GirderStack([0, 1, 2], np.ones((1, 2, 2)), np.array([[[1.0, 1.0], [1.0, 0.0]]]))
    with pytest.raises(GirderError, match="mass has the shape"):
        GirderStack([0, 1, 2], np.ones((1, 1, 2)), np.ones((1, 2, 2)))
    with pytest.raises(GirderError, match="point masses have the shape"):
        GirderStack([0, 1], np.ones((1, 1, 2)), np.ones((1, 1, 2)), np.array([3.0]), np.ones((1, 1)))
    with pytest.raises(ArgumentError, match="13 modes were asked"):
        solve_many(stack(1), modes=13)
    with pytest.raises(ArgumentError, match="leaves shear out"):
        solve_many(stack(1), StodolaRitz(shear=True))
    with pytest.raises(ArgumentError, match="rigid-body functions only"):
        solve_many(stack(1), Ritz(rigid_body=False))
    with pytest.raises(SolutionError, match="no mass at all"):
        solve_many(GirderStack([0, 1], np.zeros((1, 1, 2)), np.ones((1, 1, 2))))


def test_a_stack_keeps_frozen_copies_and_needs_a_girder():
    mass, rigidity = np.ones((2, 1, 2)), np.ones((2, 1, 2))
    stack = GirderStack(np.array([0.0, 1.0]), mass, rigidity, [0.5], [[1.0], [2.0]])
    mass[:] = 7.0
    assert (stack.mass == 1.0).all()
    assert rigidity.flags.writeable
    for array in (stack.breaks, stack.mass, stack.rigidity, stack.point_x, stack.point_mass):
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0.0
    for empty in (np.ones((0, 1, 2)), 1.0):
        with pytest.raises(GirderError, match="at least one girder"):
            GirderStack(np.array([0.0, 1.0]), empty, empty)
    with pytest.raises(GirderError, match="mass is not an array of numbers"):
        GirderStack([0.0, 1.0], "heavy", rigidity)
    with pytest.raises(GirderError, match="one dimension"):
        GirderStack([0.0, 1.0], mass, rigidity, [[0.5]])


def test_many_modes_are_whole_finite_and_frozen():
    stack = GirderStack([0.0, 1.0], np.ones((2, 1, 2)), np.ones((2, 1, 2)))
    found = solve_many(stack, modes=2)
    with pytest.raises(ValueError, match="read-only"):
        found.angular_frequencies[0] = 1.0
    with pytest.raises(ArgumentError, match=r"2\.5 modes"):
        solve_many(stack, modes=2.5)
    with pytest.raises(SolutionError, match="girder 1 are too large or too small"):
        solve_many(
            GirderStack([0.0, 1.0], np.array([[[1.0, 1.0]], [[1e200, 1e200]]]), [[[1.0, 1.0]], [[1e-200, 1e-200]]])
        )

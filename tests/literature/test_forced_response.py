"""Forced response of the uniform free-free beam against its closed form.

With damping by the rate of strain, EI* = EI (1 + i w tau), the beam under a harmonic load at its end x = 0 is exactly a
sum of cos, sin, cosh and sinh of b x, b^4 = m w^2 / EI*, whose four factors follow from a free end at L and, for an
upward force F and a moment M at x = 0, from EI* d3z/dx3 = F and EI* d2z/dx2 = -M (equilibrium of a thin slice). Every
mode then has the damping zeta_n = w_n tau / 2.
"""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

import hullvib
from hullvib.errors import ArgumentError
from hullvib.forced import HarmonicLoad, forced_response, modal_amplitudes, participation

LENGTH, MASS, RIGIDITY = 120.0, 8.0e4, 2.0e13
GIRDER = hullvib.Girder([0.0, LENGTH], [MASS, MASS], [RIGIDITY, RIGIDITY])
MODES = hullvib.solve(GIRDER, hullvib.Ritz(40), modes=38)
X = np.linspace(0.0, LENGTH, 61)
FIRST = float(MODES.angular_frequencies[0])
TAU = 2 * 0.01 / FIRST  # 1 % of critical in mode 1


def closed_form(w: float, force: float, moment: float) -> NDArray[np.complex128]:
    """Deflection at X under an upward force and a moment, slopes positive, at the aft end."""
    rigidity = RIGIDITY * (1 + 1j * w * TAU)
    b = (MASS * w**2 / rigidity) ** 0.25
    end = b * LENGTH

    def row(x: complex, derivative: int) -> list[complex]:
        c, s, ch, sh = np.cos(x), np.sin(x), np.cosh(x), np.sinh(x)
        table = {
            0: [c, s, ch, sh],
            2: [-c, -s, ch, sh],
            3: [s, -c, sh, ch],
        }
        return [b**derivative * value for value in table[derivative]]

    system = np.array([row(0, 2), row(0, 3), row(end, 2), row(end, 3)])
    right = np.array([-moment / rigidity, force / rigidity, 0, 0])
    a = np.linalg.solve(system, right)
    return np.array([np.dot(row(b * x, 0), a) for x in X])


def rigid_body(w: float, force: float, moment: float) -> NDArray[np.complex128]:
    """Heave and pitch under the same load, which are not among the modes."""
    mass, inertia = MASS * LENGTH, MASS * LENGTH**3 / 12
    arm = -LENGTH / 2
    turn = (force * arm + moment) / (-(w**2) * inertia)
    return np.asarray(force / (-(w**2) * mass) + turn * (X - LENGTH / 2), dtype=np.complex128)


@pytest.mark.parametrize("share", [0.7, 0.98, 1.0, 1.03, 2.2])
@pytest.mark.parametrize(("force", "moment"), [(1.0e5, 0.0), (0.0, 3.0e6)])
def test_the_sum_of_modes_is_the_closed_form(share: float, force: float, moment: float) -> None:
    w = share * FIRST
    damping = MODES.angular_frequencies * TAU / 2
    found = forced_response(MODES, HarmonicLoad(0.0, force, moment), w, np.minimum(damping, 0.99), X)
    exact = closed_form(w, force, moment)
    # what the modes beyond 38 add at x = 0, static for them: 4 F L^3 / EI sum 1 / (bL)^4 and 4 M L^2 / EI sum 1 /
    # (bL)^3 with bL = (n + 1/2) pi; the damping cut at 0.99 is that of modes of 99 times the first frequency and more
    last = 39.0
    left = 4 * force * LENGTH**3 / RIGIDITY / (3 * np.pi**4 * last**3)
    left += 4 * moment * LENGTH**2 / RIGIDITY / (2 * np.pi**3 * last**2)
    np.testing.assert_allclose(found.deflection + rigid_body(w, force, moment), exact, rtol=0, atol=1.1 * left)


def test_at_resonance_one_mode_has_the_amplitude_of_the_textbook() -> None:
    """Q / (2 zeta w^2 m), a quarter of a cycle behind the load; the uniform beam's modal mass is mL/4."""
    zeta, force = 0.012, 2.0e4
    found = forced_response(MODES, HarmonicLoad(LENGTH, force_n=force), FIRST, zeta, X, only_mode=1)
    assert MODES.modal_mass[0] == pytest.approx(MASS * LENGTH / 4, rel=1e-9)
    amplitude = force / (2 * zeta * FIRST**2 * MASS * LENGTH / 4)
    assert found.amplitude_m[0] == pytest.approx(amplitude, rel=1e-9)
    assert found.deflection[0] == pytest.approx(-1j * amplitude, rel=1e-9)
    assert found.peak_velocity_m_s[0] == pytest.approx(FIRST * amplitude, rel=1e-9)


def test_a_moment_works_on_the_slope() -> None:
    """The mode's slope at its end is 0.98250 * 4.73004 / L of its deflection there (Blevins, table 8-1: sigma, beta L).

    phi = cosh + cos - sigma (sinh + sin), phi(0) = 2, phi'(0) = -2 sigma beta.
    """
    zeta, moment = 0.01, 5.0e6
    found = forced_response(MODES, HarmonicLoad(0.0, moment_n_m=moment), FIRST, zeta, X, only_mode=1)
    slope = 0.982502215 * 4.73004074 / LENGTH
    assert found.amplitude_m[0] == pytest.approx(moment * slope / (2 * zeta * FIRST**2 * MASS * LENGTH / 4), rel=1e-7)


def test_participation_of_force_and_moment_is_where_the_mode_moves_and_turns() -> None:
    force, moment = (participation(MODES, LENGTH / 2, acts) for acts in ("force", "moment"))
    # midships: antinode of modes 1, 3; node, and steepest slope but for the ends, of mode 2
    assert abs(force[0]) == pytest.approx(0.6078, abs=1e-4)
    assert abs(moment[0]) < 1e-9
    assert abs(force[1]) < 1e-9
    assert participation(MODES, 0.0, "force")[:4] == pytest.approx(1.0, abs=1e-12)
    assert np.abs(participation(MODES, 0.0, "moment"))[:4] == pytest.approx(1.0, abs=1e-12)
    # the node of mode 1 at 0.2242 L: no force there moves it, a moment does
    node = float(MODES.nodes()[0][0])
    assert node / LENGTH == pytest.approx(0.2242, abs=1e-4)
    assert abs(participation(MODES, node, "force")[0]) < 1e-9
    assert abs(participation(MODES, node, "moment")[0]) > 0.8


def test_nonsense_is_refused() -> None:
    load = HarmonicLoad(0.0, force_n=1.0)
    with pytest.raises(ArgumentError, match="damping"):
        forced_response(MODES, load, FIRST, 0.0, X)
    with pytest.raises(ArgumentError, match="exciting frequency"):
        modal_amplitudes(FIRST, 1.0, 1.0, -1.0, 0.01)
    with pytest.raises(ArgumentError, match="no mode 99"):
        forced_response(MODES, load, FIRST, 0.01, X, only_mode=99)
    with pytest.raises(ArgumentError, match="within 0"):
        forced_response(MODES, HarmonicLoad(200.0, force_n=1.0), FIRST, 0.01, X)

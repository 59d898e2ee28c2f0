"""Bodies whose flow is known: sections and panels of spheroids, cylinders and boxes, and motions to shake them with."""

from dataclasses import dataclass

import numpy as np

from hullvib import Girder
from hullvib.sea import GRAVITY_M_S2, SEA_WATER_KG_M3
from hullvib.uniform_beam import uniform_modes
from hullvib.wet import AddedMass, Panels, Sections, spheroid_added_mass

QUARTER = np.linspace(0.0, np.pi / 2, 181)
SEMICIRCLE = np.stack([np.sin(QUARTER), -np.cos(QUARTER)], axis=-1)
"""Half of a semicircle of radius 1, from the keel to the waterline."""


def rectangle(breadth, draught):
    """Half a rectangle, from the keel to the waterline."""
    return np.array([[0.0, -draught], [breadth / 2, -draught], [breadth / 2, 0.0]])


def spheroid_sections(length, breadth, count):
    """Half-submerged, `count` sections at equal steps of the angle from end to end."""
    angle = np.linspace(0.0, np.pi, count)
    radius = 0.5 * breadth * np.sin(angle)
    radius[[0, -1]] = 0.0
    return Sections(0.5 * length * (1.0 - np.cos(angle)), radius[:, None, None] * SEMICIRCLE)


def spheroid_panels(length, breadth, lengthwise, girthwise):
    return Panels.from_sections(spheroid_sections(length, breadth, lengthwise + 1), girthwise=girthwise)


def prism_sections(half_section, length, count=2):
    """One section all along."""
    return Sections(np.linspace(0.0, length, count), np.broadcast_to(half_section, (count, *np.shape(half_section))))


def uniform_girder(length, mass_per_length, rigidity, shear_rigidity=None):
    shear = None if shear_rigidity is None else [shear_rigidity] * 2
    return Girder([0.0, length], [mass_per_length] * 2, [rigidity] * 2, shear_rigidity=shear)


@dataclass(frozen=True)
class UniformMotions:
    """Heave, pitch and the uniform beam's modes, which turn the sections by their slope."""

    length: float
    modes: int

    @property
    def ranks(self):
        return np.arange(1, self.modes + 3)

    def deflections(self, x):
        xi = np.asarray(x) / self.length
        return np.vstack([np.ones_like(xi), 2 * xi - 1, uniform_modes(xi, self.modes, (0,))[0]])

    def angles(self, x):
        xi = np.asarray(x) / self.length
        turn = np.vstack([np.zeros_like(xi), np.full_like(xi, 2.0), uniform_modes(xi, self.modes, (1,))[0]])
        return turn / self.length


@dataclass(frozen=True)
class Waves:
    """Deflections cos(k (x - origin)), one for each wave number, of sections that do not turn."""

    wave_numbers: tuple
    origin: float

    @property
    def ranks(self):
        return np.arange(1, len(self.wave_numbers) + 1)

    def deflections(self, x):
        return np.cos(np.outer(self.wave_numbers, np.asarray(x) - self.origin))

    def angles(self, x):
        return np.zeros((len(self.wave_numbers), len(x)))


@dataclass(frozen=True)
class SpheroidFlow:
    """The exact flow about a half-submerged spheroid, whose girder lies in the waterline."""

    length: float
    breadth_m: float
    density_kg_m3: float = SEA_WATER_KG_M3
    gravity_m_s2: float = GRAVITY_M_S2

    def added_mass(self, motions):
        def of_mu(mu):
            x = 0.5 * self.length * (mu + 1.0)
            return motions.deflections(x), motions.angles(x) * (0.5 * self.length)

        matrix = spheroid_added_mass(of_mu, self.length, self.breadth_m, self.density_kg_m3)
        return AddedMass(matrix, 0.0, np.array([0.0, self.length]), np.zeros((len(matrix), 1)), {"flow": "spheroid"})

    def hydrostatic_stiffness(self, motions):
        mu, weights = np.polynomial.legendre.leggauss(200)
        shapes = motions.deflections(0.5 * self.length * (mu + 1.0))
        breadth = self.breadth_m * np.sqrt(1.0 - mu**2)
        return (shapes * (weights * breadth * 0.5 * self.length * self.density_kg_m3 * self.gravity_m_s2)) @ shapes.T

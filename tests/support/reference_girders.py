"""Girders whose answers are known: the bench cases, and the beams of data/exact_beams.json by their names."""

import numpy as np
from numpy.polynomial import Polynomial

from hullvib import Girder, PointMass

LENGTH, RIGIDITY, MEAN_MASS = 262.0, 52.118e12, 284962.0

# 20-digit reference (data/bench_reference.json), rad/s, modes 1-6, copied to 17 digits
ANSWERS = {
    "A": [4.4078578114550473, 12.150429791097198, 23.819700548360490, 39.375174990086805, 58.819718340975258,
          82.153159709890292],
    "B": [4.9218558239898846, 12.818834605080646, 24.314249693211140, 39.406710633532919, 58.124341559928812,
          80.485025116693479],
    "C": [4.9991976900179876, 11.993742931176827, 21.490464361706317, 34.180751878304377, 50.339321490990351,
          70.079276652104245],
}  # fmt: skip


def case(name: str) -> Girder:
    """Bench case A (uniform), B (smooth) or C (saw-tooth)."""
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


def beam(name: str) -> Girder:
    """The beam of exact_beams.json, from its name."""
    xi = Polynomial([0.0, 1.0])
    if name == "uniform":
        return Girder([0, 1], [1, 1], [1, 1])
    if name.startswith("uniform_endmass"):
        aft, fore = (float(part) for part in name.split("_")[-2:])
        return Girder([0, 1], [1, 1], [1, 1], point_masses=[PointMass(0, aft), PointMass(1, fore)])
    if name == "exponential_a2":
        return Girder.from_functions(1.0, lambda x: np.exp(2 * x), lambda x: np.exp(2 * x))
    if name.startswith("timoshenko_hull"):
        b, c = (float(part[1:]) for part in name.split("_")[-2:])
        u = 2 * xi - 1
        return Girder.from_polynomials([0, 1], [(1 - c * u**2).coef], [(1 - b * u**2).coef])
    if name.startswith("jacobi"):
        a, b = (int(part[1:]) for part in name.split("_")[-2:])
        aft, fore = 2 * xi, 2 - 2 * xi
        return Girder.from_polynomials([0, 1], [(fore**a * aft**b).coef], [(fore ** (a + 2) * aft ** (b + 2)).coef])
    c = 0.0 if name.endswith("sharp") else float(name.split("_c")[-1])
    power = {"wedge": (1, 3), "cone": (2, 4), "quartic": (4, 4)}
    n, k = next(value for key, value in power.items() if key in name)
    if name.startswith("double"):
        aft, fore = c + 2 * (1 - c) * xi, 1 - 2 * (1 - c) * xi
        return Girder.from_polynomials([0, 0.5, 1], [(aft**n).coef, (fore**n).coef], [(aft**k).coef, (fore**k).coef])
    s = 1 - (1 - c) * xi
    return Girder.from_polynomials([0, 1], [(s**n).coef], [(s**k).coef])

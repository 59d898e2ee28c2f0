"""Prismatic two-node elements with the textbook's shear-flexible stiffness, sharing no code with the solvers.

J. S. Przemieniecki, Theory of Matrix Structural Analysis, section 5.6; masses lumped at the nodes so that each
element's total and centre are kept, properties at the element's middle.
"""

from __future__ import annotations

import numpy as np

from hullvib import Girder


def matrices(girder: Girder, elements: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Nodes (n,) in m, stiffness (2 n, 2 n) and lumped masses (2 n,); unknowns at a node: deflection, angle."""
    x = np.linspace(0.0, girder.length, elements + 1)
    h, middle = girder.length / elements, (x[1:] + x[:-1]) / 2
    ei, shear = girder.flexural_rigidity(middle), girder.shear_rigidity(middle)
    stiffness = np.zeros((2 * elements + 2, 2 * elements + 2))
    mass = np.zeros(2 * elements + 2)
    for element in range(elements):
        phi = 12 * ei[element] / (shear[element] * h**2)
        block = (
            ei[element]
            / (h**3 * (1 + phi))
            * np.array(
                [
                    [12, 6 * h, -12, 6 * h],
                    [6 * h, (4 + phi) * h**2, -6 * h, (2 - phi) * h**2],
                    [-12, -6 * h, 12, -6 * h],
                    [6 * h, (2 - phi) * h**2, -6 * h, (4 + phi) * h**2],
                ]
            )
        )
        at = slice(2 * element, 2 * element + 4)
        stiffness[at, at] += block
        places = np.linspace(x[element], x[element + 1], 41)[:-1] + h / 80
        share = (places - x[element]) / h
        parts = girder.mass_per_length(places) * h / 40
        mass[2 * element] += (parts * (1 - share)).sum()
        mass[2 * element + 2] += (parts * share).sum()
    for point in girder.point_masses:
        mass[2 * round(point.x_m / h)] += point.mass_kg
    return x, stiffness, mass

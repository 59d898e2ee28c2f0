"""Vertical added mass of a section at the surface in the high-frequency limit, phi = 0 on z = 0.

Two ways: F. M. Lewis' family of sections, known by breadth, draught and area (Trans. SNAME 37 (1929) 1-20; L. Landweber
and M. C. de Macagno, J. Ship Research 1:3 (1957) 20-30), and Green's identity on the section's own curve.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullvib.wet.sections import Sections

Array = NDArray[np.float64]

SECTION_PANELS = 40
"""Pieces that a half section is cut into."""


def lewis_coefficient(breadth_m: ArrayLike, draught_m: ArrayLike, area_m2: ArrayLike) -> Array:
    """Added mass over that of the semicircle of the same breadth, pi/8 rho B^2, for Lewis sections; any shape.

    breadth B and area S are those of the whole section, draught T > 0. S / (B T) is brought within the family's range,
    3 pi / 32 (2 - H') to pi / 32 (10 + H + 1 / H), H = B / (2 T) and H' the smaller of H and 1 / H. Very full sections
    lie beyond it: a rectangle's figure comes out 5 to 9 per cent low.
    """
    ratio = np.asarray(breadth_m, dtype=np.float64) / (2.0 * np.asarray(draught_m, dtype=np.float64))
    fullness = np.asarray(area_m2, dtype=np.float64) / (2.0 * ratio * np.asarray(draught_m, dtype=np.float64) ** 2)
    a1, a3 = lewis_parameters(ratio, fullness)
    return np.asarray(((1.0 + a1) ** 2 + 3.0 * a3**2) / (1.0 + a1 + a3) ** 2, dtype=np.float64)


def lewis_parameters(ratio: ArrayLike, fullness: ArrayLike) -> tuple[Array, Array]:
    """a1 and a3 of the map z = M (zeta + a1 / zeta + a3 / zeta^3), from B / (2 T) and S / (B T)."""
    h = np.asarray(ratio, dtype=np.float64)
    lowest = 3.0 * np.pi / 32.0 * (2.0 - np.minimum(h, 1.0 / h))
    highest = np.pi / 32.0 * (10.0 + h + 1.0 / h)
    full = 4.0 / np.pi * np.clip(np.asarray(fullness, dtype=np.float64), lowest, highest)
    c = 3.0 + full + (1.0 - full) * ((h - 1.0) / (h + 1.0)) ** 2
    a3 = (3.0 - c + np.sqrt(np.maximum(9.0 - 2.0 * c, 0.0))) / c
    return np.asarray((1.0 + a3) * (h - 1.0) / (h + 1.0)), np.asarray(a3)


def lewis_added_mass(sections: Sections, density_kg_m3: float) -> Array:
    """Added mass per length of each section in kg/m by Lewis' family, (n,); 0 without breadth in the waterline."""
    breadth, draught, area = 2.0 * sections.half_breadth_m, sections.draught_m, sections.area_m2
    wet = (breadth > 1e-6 * breadth.max()) & (draught > 1e-6 * draught.max()) & (area > 0.0)
    out = np.zeros(len(breadth))
    coefficient = lewis_coefficient(breadth[wet], draught[wet], area[wet])
    out[wet] = coefficient * (np.pi / 8.0 * density_kg_m3) * breadth[wet] ** 2
    return out


def section_added_mass(sections: Sections, density_kg_m3: float, panels: int = SECTION_PANELS) -> Array:
    """Added mass per length of each section in kg/m, (n,), by Green's identity on so many panels of the half section.

    With the sources' and dipoles' images in the centre plane (+) and the surface (-), constant on straight panels whose
    integrals are exact.
    """
    curves, area = sections.cut(panels), sections.area_m2
    out = np.zeros(len(area))
    wet = area > 1e-9 * area.max()
    out[wet] = density_kg_m3 * _half_potential(curves[wet])
    return out


def _half_potential(curves: Array) -> Array:
    """-2 int phi n_z ds over the half sections (n, panels + 1, 2), keel to waterline, for unit speed upwards."""
    start, end = curves[:, :-1], curves[:, 1:]
    step = end - start
    length = np.maximum(np.hypot(step[..., 0], step[..., 1]), 1e-300)
    tangent = step / length[..., None]
    centres = 0.5 * (start + end)
    count = length.shape[1]
    # along from the keel the water lies to the right
    upward = -tangent[..., 0]
    single, double = (np.zeros((len(curves), count, count)) for _ in range(2))
    for mirror_y, mirror_z in ((1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)):
        signs = np.array([mirror_y, mirror_z])
        t = tangent * signs
        normal = np.stack([tangent[..., 1], -tangent[..., 0]], axis=-1) * signs
        r = centres[:, :, None] - (start * signs)[:, None]
        along = np.einsum("spqj,sqj->spq", r, t)
        beside = np.einsum("spqj,sqj->spq", r, normal)
        if mirror_y > 0.0 and mirror_z > 0.0:
            beside[:, np.arange(count), np.arange(count)] = 0.0
        behind, ahead = -along, length[:, None] - along
        height = np.abs(beside)
        angle = np.sign(beside) * (np.arctan2(ahead, height) - np.arctan2(behind, height))
        logarithms = ahead * np.log(np.hypot(ahead, beside)) - behind * np.log(np.hypot(behind, beside))
        single -= mirror_z * (logarithms - length[:, None] + beside * angle)
        double += mirror_z * angle
    double[:, np.arange(count), np.arange(count)] -= np.pi
    potential = np.linalg.solve(double, np.einsum("spq,sq->sp", single, upward)[..., None])[..., 0]
    return np.asarray(-2.0 * (potential * upward * length).sum(axis=1), dtype=np.float64)

"""A sectional-area curve after the main particulars, for a ship of which there is no drawing yet.

Entrance and run are 1 - (1 - s)^n, s from the end to the shoulder, on either side of a parallel body; n follows from
the prismatic coefficient, and swinging the curve (x moves by k A, which keeps its area) puts the centre of buoyancy
where it is wanted. Of Cp = 2/3 without a parallel body the curve is a parabola, Wigley's own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from hullform.errors import BodyPlanError

Array = NDArray[np.float64]

# Entrance and run over LPP of the Series 60 parents, by block coefficient (Todd, DTMB Report 1712, 1963); what is left
# is their parallel body. Beyond the last parent they go on in a straight line.
_BLOCK = np.array([0.60, 0.65, 0.70, 0.75, 0.80, 0.90])
_ENTRANCE = np.array([0.500, 0.472, 0.410, 0.350, 0.290, 0.170])
_RUN = np.array([0.500, 0.493, 0.471, 0.440, 0.410, 0.350])
# Fullness of entrance and run, n / (n + 1), between a straight line and a shoulder that is all but a corner.
_LEAST_FULLNESS, _GREATEST_FULLNESS = 0.5, 0.93
# Of the slope of the curve at its ends that swinging may use up before the curve falls over.
_MOST_SWING = 0.9
_LEAST_PRISMATIC = 0.56
_SAMPLES = 4001


@dataclass(frozen=True)
class AreaCurve:
    """Sectional area over the largest, over the length between perpendiculars.

    Attributes:
        entrance, run: their lengths over LPP.
        exponent: n of both.
        swing: k, by which the largest section moves forward over LPP.
    """

    entrance: float
    run: float
    exponent: float
    swing: float

    @property
    def parallel_body(self) -> float:
        """Its length over LPP."""
        return 1.0 - self.entrance - self.run

    @property
    def shoulders(self) -> tuple[float, float]:
        """Places over LPP between which the areas are the largest."""
        return self.run + self.swing, 1 - self.entrance + self.swing

    def before_swinging(self, share: ArrayLike) -> Array:
        """Areas over the largest at places over LPP, 0 at the aft perpendicular."""
        u = np.asarray(share, dtype=np.float64)
        aft, fore = np.clip(u / self.run, 0.0, 1.0), np.clip((1 - u) / self.entrance, 0.0, 1.0)
        return np.asarray((1 - (1 - np.minimum(aft, fore)) ** self.exponent) * ((u >= 0) & (u <= 1)))

    def __call__(self, share: ArrayLike) -> Array:
        """Areas over the largest at places over LPP, 0 at the aft perpendicular; 0 beyond both ends."""
        u = np.sort(np.append(_cosine_spaced(_SAMPLES), [self.run, 1 - self.entrance]))
        area = self.before_swinging(u)
        return np.interp(np.asarray(share, dtype=np.float64), u + self.swing * area, area, left=0.0, right=0.0)


def area_curve(
    block_coefficient: float, midship_coefficient: float, lcb_share: float, parallel_body: float | None = None
) -> AreaCurve:
    """The curve of a prismatic coefficient Cb / Cm and a centre of buoyancy.

    Args:
        block_coefficient, midship_coefficient: with LPP.
        lcb_share: centre of buoyancy over LPP, forward of midships positive.
        parallel_body: its length over LPP; by default that of Series 60.

    Raises:
        BodyPlanError: no such curve has this fullness or this centre.
    """
    prismatic = block_coefficient / midship_coefficient
    entrance, run = (float(np.interp(block_coefficient, _BLOCK, values)) for values in (_ENTRANCE, _RUN))
    if parallel_body is not None:
        entrance, run = (part * (1 - parallel_body) / (entrance + run) for part in (entrance, run))
    fullness = (prismatic - (1 - entrance - run)) / (entrance + run)
    if not _LEAST_FULLNESS < fullness < _GREATEST_FULLNESS:
        raise BodyPlanError(
            f"no sectional-area curve of ours has a prismatic coefficient of {prismatic:.3f} with a parallel body of "
            f"{1 - entrance - run:.2f} LPP: entrance and run would have {fullness:.2f} of their box, within "
            f"{_LEAST_FULLNESS:g} to {_GREATEST_FULLNESS:g}; correct ship.block_coefficient or displacement_t, or "
            "give body_plan.midship_coefficient and parallel_body_share"
        )
    level = AreaCurve(entrance, run, fullness / (1 - fullness), 0.0)
    u = _cosine_spaced(_SAMPLES)
    area = level.before_swinging(u)
    whole = float(np.trapezoid(area, u))
    lever = lcb_share - (float(np.trapezoid(area * u, u)) / whole - 0.5)
    # each place moves by k A: the centre by k times that of the area's own height
    swing = lever * 2 * whole / float(np.trapezoid(area**2, u))
    steepest = level.exponent / (entrance if swing > 0 else run)
    if abs(swing) * steepest > _MOST_SWING:
        raise BodyPlanError(
            f"no sectional-area curve of ours has its centre {100 * lcb_share:.1f} % of LPP forward of midships at a "
            f"prismatic coefficient of {prismatic:.3f}; correct ship.lcb_from_midships_m, forward of midships positive"
        )
    return AreaCurve(entrance, run, level.exponent, swing)


def _cosine_spaced(count: int) -> Array:
    return (1 - np.cos(np.linspace(0.0, np.pi, count))) / 2


def midship_coefficient(block_coefficient: float) -> float:
    """An estimate: Cm = 1.006 - 0.0056 Cb^-3.56, but no more than leaves a prismatic coefficient of 0.56.

    The formula is Kerlen's (1970), in Schneekluth & Bertram, Ship Design for Efficiency and Economy (1998), from
    memory; it is near the Series 60 parents' own. It was not made for fine vessels, hence the other limit.
    """
    kerlen = 1.006 - 0.0056 * float(block_coefficient**-3.56)
    return min(kerlen, block_coefficient / _LEAST_PRISMATIC)


def lcb_share(prismatic_coefficient: float) -> float:
    """An estimate of LCB over LPP, forward of midships positive: 0.194 Cp - 0.135.

    In the same book, of Japanese ships, from memory; near that of the Series 60 parents.
    """
    return 0.194 * prismatic_coefficient - 0.135

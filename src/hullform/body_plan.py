"""The body plan: transverse sections of a hull as curves, whatever they were read from.

One type for every source, so that the stages after it need not know whether a picture, a table or a mesh
was read.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from hullform.errors import BodyPlanError
from hullform.profile import Profile

Half = Literal["aft", "fore"]
Source = Literal["picture", "offsets", "mesh", "particulars"]


@dataclass(frozen=True, eq=False)
class TracedCurve:
    """One curve of a station, from keel to deck.

    Attributes:
        half_breadth_m: (n,) moulded half-breadths y >= 0, in metres.
        height_m: (n,) heights z above the base line, in metres; need not increase.
        confidence: 0 (guessed) to 1 (certain).

    Raises:
        BodyPlanError: fewer than two points, arrays of unequal length, numbers that are not finite.
    """

    half_breadth_m: NDArray[np.float64]
    height_m: NDArray[np.float64]
    confidence: float = 1.0

    def __post_init__(self) -> None:
        for name in ("half_breadth_m", "height_m"):
            values = np.array(getattr(self, name), dtype=np.float64)
            values.setflags(write=False)
            object.__setattr__(self, name, values)
        y, z = self.half_breadth_m, self.height_m
        if y.ndim != 1 or y.shape != z.shape or y.size < 2:
            raise BodyPlanError(
                f"a curve needs two or more points (y, z); got {y.shape} half-breadths and {z.shape} heights"
            )
        if not (np.isfinite(y).all() and np.isfinite(z).all()):
            raise BodyPlanError("a curve has a half-breadth or height that is not a finite number")

    @property
    def points(self) -> NDArray[np.float64]:
        """(n, 2) points [half-breadth, height] in metres, from keel to deck."""
        return np.column_stack([self.half_breadth_m, self.height_m])


@dataclass(frozen=True, eq=False)
class Station:
    """The section at one place along the ship.

    Attributes:
        x_m: distance from the aft end of the length overall, positive forward.
        half: the half of the drawing that shows it, 'aft' or 'fore'.
        curves: one curve, or two where the section has two contours (a bulb below a flare).
        name: what the drawing calls it; by default its x.
        shared_with_m: x of the other stations that share this drawn curve (a parallel body is drawn once).
    """

    x_m: float
    half: Half
    curves: tuple[TracedCurve, ...]
    name: str = ""
    shared_with_m: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if not self.curves:
            raise BodyPlanError(f"the station at x = {self.x_m:g} m has no curve")
        if not self.name:
            object.__setattr__(self, "name", f"{self.x_m:g}")

    @property
    def confidence(self) -> float:
        """The lowest confidence of the station's curves."""
        return min(curve.confidence for curve in self.curves)

    def area_below(self, height_m: float) -> float:
        """Area of the section, both sides, below a height above the base line: 2 ∮ y dz along each curve, m2.

        A curve that turns back counts its inner part against its outer.
        """
        total = 0.0
        for curve in self.curves:
            y, z = curve.half_breadth_m, curve.height_m
            below = np.minimum(z, height_m)
            rise = np.diff(z)
            slope = np.divide(np.diff(y), rise, out=np.zeros_like(rise), where=np.abs(rise) > 1e-12)
            start = y[:-1] + slope * (below[:-1] - z[:-1])
            end = y[:-1] + slope * (below[1:] - z[:-1])
            total += float(np.sum((start + end) * np.diff(below)))
        return total


@dataclass(frozen=True)
class Calibration:
    """How pixels became metres.

    After the rotation, y = (u - centreline) * metres_per_px and z = (baseline - v) * metres_per_px.

    Attributes:
        pixel_from_metres: 3 x 3 homography, (y, z, 1) in metres (y negative in the left half) to pixels
            (u right, v down, pixel centres at integers) of the picture as stored.
        centreline_px: u of the centre line where it meets the base line.
        baseline_px: v of the base line there.
        metres_per_px: the scale there.
        rotation_deg: of the drawing in the picture, positive counter-clockwise.
        residual_px: largest misfit of the lines or points used; 0 where the calibration was given.
        source: where each figure came from, in words, for the report.
    """

    pixel_from_metres: tuple[tuple[float, float, float], ...]
    centreline_px: float
    baseline_px: float
    metres_per_px: float
    rotation_deg: float
    residual_px: float
    source: str

    def pixels(self, points_m: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) [u, v] px of the picture as stored, of points (n, 2) [y, z] in m, y negative in the left half."""
        mapped = np.column_stack([points_m, np.ones(len(points_m))]) @ np.array(self.pixel_from_metres).T
        return np.asarray(mapped[:, :2] / mapped[:, 2:], dtype=np.float64)


@dataclass(frozen=True, eq=False)
class BodyPlan:
    """The stations of a ship, aft to fore, and what the reader was not sure of.

    Attributes:
        stations: sorted by x, aft half before fore half at equal x.
        source: what the stations come from; of 'particulars' nothing was drawn.
        calibration: for a picture, how its pixels became metres.
        notes: what was found or assumed, in words, for the report.
        doubts: what a person should look at; a run with doubts ends with exit code 3.
        profile: the contour in the centre plane, where it is known.
    """

    stations: tuple[Station, ...]
    source: Source
    calibration: Calibration | None = None
    notes: tuple[str, ...] = ()
    doubts: tuple[str, ...] = field(default=())
    profile: Profile | None = None

    def __post_init__(self) -> None:
        if len({station.x_m for station in self.stations}) < 3:
            raise BodyPlanError(
                f"a hull needs stations at three or more different x; the body plan has {len(self.stations)}"
            )
        order = sorted(self.stations, key=lambda station: (station.x_m, station.half))
        object.__setattr__(self, "stations", tuple(order))

"""What the labels of a drawing propose: which curve is which station, by the word that stands nearest to it.

A label tells less than a mark: it may stand at its neighbour's curve, in a column beside the drawing, or be misread.
So each adds a small cost to the naming, and what speaks against a naming is told, not obeyed.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from hullform.picture.image.labels import Label
from hullform.picture.pieces.frame import DiagonalFrame
from hullform.station_names import StationNames, number_of, same_name

Array = NDArray[np.float64]

OUTBOARD = 1.03  # of B/2: what stands farther out is the scale of the frame
NEAR_ITS_VALUE = 1.0  # of a letter's height: a number so near to the height that it tells is a waterline's
STROKES = " |/\\'`\".,:;-_=~()[]"  # pieces of curves and leaders, which a word takes up at its ends
RANGE = re.compile(r"[-–—]")
COST_PER_HEIGHT = 8.0
SLACK = 0.5  # of a letter's height: no difference
MOST = 3.0  # letters' heights that are counted
WEIGHT_OF_CLEAR = 2.0  # of a label that stands at one curve; still less than a curve without a name
CLEAR = 1.0  # of a letter's height by which a label is nearer to one curve than to every other
AT_CURVE = 1.2  # of a letter's height from its curve: a label that stands there


@dataclass(frozen=True)
class PlacedLabel:
    """A word in one half: its centre and half its width and height, px of the drawing."""

    text: str
    confidence: float
    y_px: float
    z_px: float
    reach_px: tuple[float, float]

    @property
    def height_px(self) -> float:
        """Of the letters."""
        return 2 * self.reach_px[1]

    def distance_px(self, curve: Array) -> float:
        """From the box to a curve's points (n, 2)."""
        beside = np.abs(curve - (self.y_px, self.z_px)) - self.reach_px
        return float(np.hypot(*np.maximum(beside, 0.0).T).min())


def labels_in_half(labels: Sequence[Label], frame: DiagonalFrame) -> tuple[PlacedLabel, ...]:
    """The words that stand inside the drawing of a half and are not the scale of its heights.

    Args:
        labels: of the whole picture.
        frame: of the half.
    """
    scale = frame.metres_per_px
    placed = []
    for label in labels:
        y_px, z_px = (float(value) for value in frame.from_picture(*label.centre_px))
        reach = (label.width_px / 2, label.height_px / 2)
        text = label.text.strip(STROKES)
        inside = 0.0 < y_px < OUTBOARD * frame.half_breadth_px and -reach[1] < z_px < frame.top_px
        number = number_of(text)
        heights_px = [] if number is None else [number / scale, number / 1000 / scale]
        is_scale = any(abs(height - z_px) < NEAR_ITS_VALUE * label.height_px for height in heights_px if height > 0)
        if inside and text and not is_scale:
            placed.append(PlacedLabel(text, label.confidence, y_px, z_px, reach))
    return tuple(placed)


@dataclass(frozen=True)
class LabelledHalf:
    """The words in one half, and which of them are names of its stations.

    Attributes:
        names: of the half's stations.
        inner_first: x of the stations from the centre line outwards, m.
        placed: all words inside the drawing.
        named: index in `inner_first`, and label, of those that are names.
    """

    names: StationNames
    inner_first: tuple[float, ...]
    placed: tuple[PlacedLabel, ...] = ()
    named: tuple[tuple[int, PlacedLabel], ...] = ()


def label_half(
    labels: Sequence[Label], frame: DiagonalFrame, names: StationNames, inner_first: tuple[float, ...]
) -> LabelledHalf:
    """Place the words of a picture in a half; without names for its stations none can be one.

    Args:
        labels: of the whole picture.
        frame: of the half.
        names: of its stations.
        inner_first: x of the stations from the centre line outwards, m.
    """
    if not names.names:
        return LabelledHalf(names, inner_first)
    placed = labels_in_half(labels, frame)
    return LabelledHalf(names, inner_first, placed, named_labels(placed, [names.of(x) for x in inner_first]))


def named_labels(labels: Sequence[PlacedLabel], names: Sequence[str]) -> tuple[tuple[int, PlacedLabel], ...]:
    """The labels that are a station's name, with the index of the name."""
    known = {same_name(name): index for index, name in enumerate(names)}
    # print sets a fraction close to its number
    known = {same_name(name.replace(" ", "")): index for index, name in enumerate(names)} | known
    found = []
    for label in labels:
        # '10-15' stands at the one curve of a parallel body, and names all its stations
        ends = [label.text] if number_of(label.text) is not None else RANGE.split(label.text)
        at = [known[same_name(end)] for end in ends if same_name(end) in known]
        if len(at) == len(ends) <= 2:
            found += [(index, label) for index in range(min(at), max(at) + 1)]
    return tuple(found)


def label_costs(labels: Sequence[tuple[int, PlacedLabel]], curves: Sequence[Array], stations: int) -> Array | None:
    """(stations, curves) what naming each curve after each station costs by the labels; None without any.

    Args:
        labels: station index and label.
        curves: (n, 2) points of each, px of the drawing.
        stations: number of names.
    """
    if not labels or not curves:
        return None
    costs = np.full((stations, len(curves)), np.inf)
    for station, label in labels:
        away = _distances(label, curves)
        beyond = np.clip(away - away.min() - SLACK, 0.0, MOST)
        costs[station] = np.minimum(costs[station], COST_PER_HEIGHT * beyond)
    for station, _ in clear_labels(labels, curves):
        costs[station] *= WEIGHT_OF_CLEAR
    return np.where(np.isfinite(costs), costs, 0.0)


def clear_labels(labels: Sequence[tuple[int, PlacedLabel]], curves: Sequence[Array]) -> list[tuple[int, int]]:
    """(station, curve) of the labels that alone stand at a curve, clearly nearer to it than to any other."""
    found = []
    at: dict[int, set[PlacedLabel]] = {}
    for station, label in labels:
        away = _distances(label, curves)
        nearest, *others = np.sort(away)
        if nearest < AT_CURVE and all(other > nearest + CLEAR for other in others[:1]):
            curve = int(np.argmin(away))
            found.append((station, curve))
            at.setdefault(curve, set()).add(label)
    return [(station, curve) for station, curve in found if len(at[curve]) == 1]


def _distances(label: PlacedLabel, curves: Sequence[Array]) -> Array:
    """(curves,) in letters' heights."""
    return np.array([label.distance_px(curve) for curve in curves]) / label.height_px

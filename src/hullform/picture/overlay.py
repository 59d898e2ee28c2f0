"""What was read, drawn over the faded picture: to be confirmed by eye before any figure is believed."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from hullform.body_plan import Half, Station
from hullform.errors import OutputError
from hullform.files import whole_file
from hullform.picture.reading import PictureReading

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Colour = tuple[int, int, int]
Box = tuple[float, float, float, float]  # left, top, right, bottom, px

IMAGE_TYPES = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".webp", ".bmp")
FADED = 0.3  # of the picture's ink that stays
# BGR; neighbours differ in hue and in lightness
STATION_COLOURS: tuple[Colour, ...] = (
    (40, 39, 214),
    (180, 119, 31),
    (44, 130, 20),
    (0, 110, 230),
    (189, 70, 148),
    (75, 86, 140),
    (150, 140, 0),
    (160, 30, 90),
)
GRID_COLOUR: Colour = (225, 205, 150)
LINE_COLOUR: Colour = (150, 90, 0)
VALUE_COLOUR: Colour = (140, 120, 40)
SAME_LINE = 0.004  # of B/2 or D: a grid line so near to a line with a name of its own is that line
LARGEST_MULTIPLE = 12  # of the grid's spacing below the base line
LINE_REACH_PX = 2
LINE_SHADE = 0.96  # of the paper's level: the faintest line
FONT = cv2.FONT_HERSHEY_SIMPLEX


def draw_overlay(reading: PictureReading) -> Image:
    """The picture, faded, with the predicted grid and lines, their values, and every traced curve with its name.

    Returns:
        (rows, columns, 3) BGR.
    """
    faded = 255 - FADED * (255 - reading.grey.astype(np.float32))
    image = np.ascontiguousarray(np.repeat(faded.astype(np.uint8)[..., None], 3, axis=2))
    taken = _draw_lines(image, reading)
    stroke = max(1, round(image.shape[1] / 1000))
    halves: tuple[Half, Half] = ("aft", "fore")
    labels: list[tuple[str, Array, Colour]] = []
    for half in halves:
        stations = [station for station in reading.body_plan.stations if station.half == half]
        drawn = _drawn_once(stations if half == "aft" else stations[::-1])
        for position, (station, names) in enumerate(drawn):
            colour = STATION_COLOURS[position % len(STATION_COLOURS)]
            for curve in station.curves:
                points = _pixels(reading, reading.side_of(half) * curve.half_breadth_m, curve.height_m)
                cv2.polylines(image, [_fixed(points)], False, colour, stroke, cv2.LINE_AA, SHIFT)
                labels.append((names, points, colour))
    for words, points, colour in labels:
        _label(image, words, points, colour, taken)
    return image


def write_overlay(reading: PictureReading, path: Path) -> None:
    """Draw the overlay into an image file of the type that its name says; the file is written whole or not at all.

    Raises:
        OutputError: unknown type, or the file cannot be written.
    """
    if path.suffix.lower() not in IMAGE_TYPES:
        raise OutputError(f"{path}: '{path.suffix}' is no image type; use {', '.join(IMAGE_TYPES)}")
    with whole_file(path) as aside:
        done, data = cv2.imencode(path.suffix.lower(), draw_overlay(reading))
        if not done:
            raise OutputError(f"{path}: this OpenCV writes no '{path.suffix}'; use .png or .jpg")
        aside.write_bytes(data.tobytes())


SHIFT = 4  # fractional bits of the coordinates that polylines takes


def _fixed(points: Array) -> NDArray[np.int32]:
    return np.round(points * (1 << SHIFT)).astype(np.int32)


def _pixels(reading: PictureReading, y_m: Array, z_m: Array) -> Array:
    """(n, 2) pixels of points in metres, y negative in the left half."""
    y, z = np.broadcast_arrays(np.asarray(y_m, dtype=np.float64), np.asarray(z_m, dtype=np.float64))
    stored = reading.calibration.pixels(np.column_stack([y.ravel(), z.ravel()]))
    return np.column_stack(reading.reduction.read((stored[:, 0], stored[:, 1])))


def _drawn_once(stations: list[Station]) -> list[tuple[Station, str]]:
    """Each drawn curve with the names of all stations that share it."""
    out: list[tuple[Station, str]] = []
    seen: set[float] = set()
    names = {station.x_m: station.name for station in stations}
    for station in stations:
        if station.x_m in seen:
            continue
        seen |= {station.x_m, *station.shared_with_m}
        everyone = sorted((station.x_m, *station.shared_with_m))
        out.append((station, station.name if len(everyone) == 1 else f"{names[everyone[0]]}-{names[everyone[-1]]}"))
    return out


def _draw_lines(image: Image, reading: PictureReading) -> list[Box]:
    """The predicted grid, the sheer line, and the lines that carry the scale, with their values.

    Returns:
        where the values stand.
    """
    taken: list[Box] = []
    values: list[tuple[str, tuple[float, float]]] = []
    half_breadth, depth, draught = reading.breadth_m / 2, reading.depth_m, reading.draught_m
    reach = 1.03 * half_breadth

    def line(points: tuple[tuple[float, float], tuple[float, float]], colour: Colour) -> Array:
        ends = _pixels(reading, np.array([p[0] for p in points]), np.array([p[1] for p in points]))
        cv2.polylines(image, [_fixed(ends)], False, colour, 1, cv2.LINE_AA, SHIFT)
        return ends

    if reading.grid_m is not None:
        across, up = reading.grid_m
        lowest = -up * max((n for n in range(1, LARGEST_MULTIPLE) if _is_drawn(reading, -n * up)), default=0)
        least, most = _traced_heights(reading)
        least = min(least, lowest)
        for y in across * np.arange(-int(half_breadth / across), int(half_breadth / across) + 1):
            if 0 < abs(y) < (1 - SAME_LINE) * half_breadth:
                ends = line(((y, min(0.0, least)), (y, depth)), GRID_COLOUR)
                values.append((f"{abs(y):g}", (float(ends[0, 0]) + 2, float(ends[0, 1]) + _line_height(image))))
        for z in up * np.arange(int(np.ceil(least / up)), int(max(most, depth) / up) + 1):
            if min(abs(z), abs(z - depth), abs(z - draught)) > SAME_LINE * depth:
                ends = line(((-reach, z), (reach, z)), GRID_COLOUR)
                values += [(f"{z:g}", (float(end[0]) + 2, float(end[1]) - 3)) for end in ends]
    for half, points in reading.sheer_m.items():
        sheer = _pixels(reading, reading.side_of(half) * points[:, 0], points[:, 1])
        cv2.polylines(image, [_fixed(sheer)], False, LINE_COLOUR, 1, cv2.LINE_AA, SHIFT)
    heights = [(0.0, "BL 0 m"), (depth, f"D {depth:g} m"), (draught, f"T {draught:g} m")]
    if draught == depth:
        heights[1:] = [(depth, f"D = T {depth:g} m")]
    for z, words in heights:
        ends = line(((-reach, z), (reach, z)), LINE_COLOUR)
        _write(image, words, (float(ends[0, 0]) + 2, float(ends[0, 1]) - 3), LINE_COLOUR, taken)
    for y, words in (
        (-half_breadth, f"B/2 {half_breadth:g} m"),
        (0.0, "CL"),
        (half_breadth, f"B/2 {half_breadth:g} m"),
    ):
        ends = line(((y, -0.03 * depth), (y, depth)), LINE_COLOUR)
        _write(image, words, (float(ends[0, 0]) + 3, float(ends[0, 1])), LINE_COLOUR, taken)
    for words, at in values:
        if not any(_overlap(_box(image, words, at), other) for other in taken):
            _write(image, words, at, VALUE_COLOUR, taken)
    return taken


def _is_drawn(reading: PictureReading, z_m: float) -> bool:
    """Whether the picture has a level line at a height; below the base line no others are shown."""
    y = np.linspace(-0.9, 0.9, 400) * reading.breadth_m / 2
    u, v = np.round(_pixels(reading, y, np.full(y.shape, z_m))).astype(int).T
    rows, columns = reading.grey.shape
    if u.min() < 0 or u.max() >= columns or v.min() < LINE_REACH_PX or v.max() >= rows - LINE_REACH_PX:
        return False
    near = np.min([reading.grey[v + k, u] for k in range(-LINE_REACH_PX, LINE_REACH_PX + 1)], axis=0)
    return bool(np.mean(near < LINE_SHADE * float(np.median(reading.grey))) > 0.5)


def _traced_heights(reading: PictureReading) -> tuple[float, float]:
    """Heights in metres, of the lowest and the highest point of the traced curves."""
    heights = [curve.height_m for station in reading.body_plan.stations for curve in station.curves]
    return min(float(z.min()) for z in heights), max(float(z.max()) for z in heights)


def _label(image: Image, words: str, points: Array, colour: Colour, taken: list[Box]) -> None:
    """Name a curve at the first place along it, from the deck down, that no other name has; none where all is full."""
    (width, _), _ = cv2.getTextSize(words, FONT, *_text_size(image))
    for share in np.arange(0.97, 0.2, -0.03):
        u, v = points[round(share * (len(points) - 1))]
        for left in (u + 4, u - 4 - width):
            box = _box(image, words, (left, v))
            inside = box[0] >= 0 and box[1] >= 0 and box[2] < image.shape[1] and box[3] < image.shape[0]
            if inside and not any(_overlap(box, other) for other in taken):
                _write(image, words, (float(left), float(v)), colour, taken)
                return


def _line_height(image: Image) -> float:
    """Of a line of text, px."""
    return 1.6 * float(cv2.getTextSize("0", FONT, *_text_size(image))[0][1])


def _box(image: Image, words: str, at: tuple[float, float]) -> Box:
    """What a text covers with its halo, its lower left corner given."""
    (width, height), _ = cv2.getTextSize(words, FONT, *_text_size(image))
    return at[0] - 2, at[1] - height - 2, at[0] + width + 2, at[1] + 4


def _overlap(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _text_size(image: Image) -> tuple[float, int]:
    """Scale and weight of the letters."""
    size = image.shape[1] / 3600
    return size, max(1, round(1.6 * size))


def _write(image: Image, words: str, at: tuple[float, float], colour: Colour, taken: list[Box]) -> None:
    """Text on a light halo, so that it can be read over lines; kept inside the picture, its place noted in `taken`."""
    size, weight = _text_size(image)
    (width, height), _ = cv2.getTextSize(words, FONT, size, weight)
    u = int(np.clip(at[0], 0, max(0, image.shape[1] - width)))
    v = int(np.clip(at[1], height, image.shape[0] - 2))
    taken.append((u - 2, v - height - 2, u + width + 2, v + 4))
    cv2.putText(image, words, (u, v), FONT, size, (255, 255, 255), weight + 3, cv2.LINE_AA)
    cv2.putText(image, words, (u, v), FONT, size, colour, weight, cv2.LINE_AA)

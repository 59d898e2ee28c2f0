"""What a scanner, a copier or a camera does to a sheet, with the way of every point through it."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from generator.canvas import Image
from generator.levels import Level
from generator.sections import Array

_TABLE = np.array([140.0, 118.0, 96.0])  # colour of the table below a photographed sheet
_WAVES = 3  # of the paper's distortion
_ROUNDS = 30  # of the fixed-point iteration that inverts it


@dataclass(frozen=True, eq=False)
class Distortion:
    """A homography, then a smooth displacement of the paper; pixels of the sheet to pixels of the picture.

    Attributes:
        matrix: 3 x 3.
        waves: (n, 5) of the displacement: amplitudes across and down (px), wave numbers (rad/px), phase.
    """

    matrix: Array
    waves: Array

    def of(self, points: Array) -> Array:
        """Return where points (n, 2) of the sheet lie in the picture."""
        flat = cv2.perspectiveTransform(points[None].astype(np.float64), self.matrix)[0]
        out = flat.copy()
        for _ in range(_ROUNDS if len(self.waves) else 0):
            out = flat + self._displacement(out[:, 0], out[:, 1])
        return np.asarray(out)

    def applied_to(self, image: Image) -> tuple[Image, Array]:
        """Return the picture (paper beyond the sheet is white), and (rows, columns) how much of each pixel is sheet."""
        height, width = image.shape[:2]
        u, v = np.meshgrid(np.arange(width, dtype=np.float32), np.arange(height, dtype=np.float32))
        if len(self.waves):
            moved = self._displacement(u, v)
            u, v = u - moved[..., 0], v - moved[..., 1]
        back = np.linalg.inv(self.matrix).astype(np.float32)
        w = back[2, 0] * u + back[2, 1] * v + back[2, 2]
        across = ((back[0, 0] * u + back[0, 1] * v + back[0, 2]) / w).astype(np.float32)
        down = ((back[1, 0] * u + back[1, 1] * v + back[1, 2]) / w).astype(np.float32)
        white = (255,) * 4
        picture = cv2.remap(image, across, down, cv2.INTER_CUBIC, borderMode=cv2.BORDER_CONSTANT, borderValue=white)
        inside = (np.minimum(across, width - 1 - across) > 0) & (np.minimum(down, height - 1 - down) > 0)
        return np.asarray(picture, np.uint8), cv2.GaussianBlur(inside.astype(np.float32), (0, 0), 1.0)

    def _displacement(self, u: Array, v: Array) -> Array:
        total = np.zeros((*np.shape(u), 2), dtype=np.asarray(u).dtype)
        for across, down, ku, kv, phase in self.waves:
            wave = np.sin(ku * u + kv * v + phase)
            total[..., 0] += across * wave
            total[..., 1] += down * wave
        return total


def distortion_of(level: Level, width: int, height: int, random: np.random.Generator) -> Distortion:
    """Draw a level's rotation, perspective and warp."""
    angle = np.radians(random.uniform(-level.rotation_deg, level.rotation_deg))
    size = random.uniform(0.90, 0.95) if level.photograph else 1.0
    centre = np.array([[1.0, 0.0, width / 2], [0.0, 1.0, height / 2], [0.0, 0.0, 1.0]])
    turn = np.array(
        [
            [size * np.cos(angle), size * np.sin(angle), 0.0],
            [-size * np.sin(angle), size * np.cos(angle), 0.0],
            [0.0, 0.0, 1.0],
        ]
    )
    tilt, direction = random.uniform(*level.perspective), random.uniform(0.0, 2.0 * np.pi)
    lean = np.eye(3)
    lean[2, :2] = tilt / width * np.array([np.cos(direction), np.sin(direction)])
    matrix = centre @ lean @ turn @ np.linalg.inv(centre)
    waves = np.zeros((0, 5))
    if level.warp_px[1] > 0:
        largest = random.uniform(*level.warp_px) * width / 1000.0
        heading = random.uniform(0.0, 2.0 * np.pi, (2, _WAVES))
        number = 2.0 * np.pi / (width * random.uniform(0.9, 2.0, _WAVES))
        share = largest / _WAVES
        waves = np.column_stack(
            [
                share * np.cos(heading[0]),
                share * np.sin(heading[0]),
                number * np.cos(heading[1]),
                number * np.sin(heading[1]),
                random.uniform(0.0, 2.0 * np.pi, _WAVES),
            ]
        )
    return Distortion(matrix, waves)


def spoilt(image: Image, level: Level, random: np.random.Generator) -> tuple[Image, Distortion]:
    """Return a sheet as the level's scanner, copier or camera gives it, and the way of its points."""
    height, width = image.shape[:2]
    distortion = distortion_of(level, width, height, random)
    lossy = _with_gaps(image, int(random.integers(level.gaps[0], level.gaps[1] + 1)), random)
    moved = not (np.allclose(distortion.matrix, np.eye(3)) and not len(distortion.waves))
    picture, sheet = distortion.applied_to(lossy) if moved else (lossy, np.ones(image.shape[:2], np.float32))
    light = np.asarray(picture, np.float32)
    shade = random.uniform(*level.shade)
    if shade > 0:
        light *= _expanded(_lamp(width, height, shade, random), light.ndim)
    if level.photograph:
        table = np.broadcast_to(_TABLE, (height, width, 3)) * (1 + 0.08 * _grain(width, height, random))[..., None]
        cover = sheet[..., None]
        light = light * cover + table.astype(np.float32) * (1 - cover)
    blur = random.uniform(*level.blur_px)
    if blur > 0:
        light = cv2.GaussianBlur(light, (0, 0), blur * max(1.0, width / 2000.0) if level.photograph else blur)
        light = light + random.normal(0.0, 2.5, light.shape).astype(np.float32)
    picture = np.asarray(np.clip(light, 0, 255), np.uint8)
    if level.salt:
        _sprinkle(picture, level.salt * random.uniform(0.5, 1.0), random)
    return picture, distortion


def encoded(picture: Image, level: Level) -> tuple[bytes, str]:
    """Return the file of a picture and its suffix: JPEG where the level has a quality, PNG otherwise."""
    suffix, options = (".jpg", [cv2.IMWRITE_JPEG_QUALITY, level.jpeg]) if level.jpeg else (".png", [])
    stored = picture[..., ::-1] if picture.ndim == 3 else picture
    _, data = cv2.imencode(suffix, np.ascontiguousarray(stored), options)
    return data.tobytes(), suffix


def _expanded(map_: Array, dimensions: int) -> Array:
    return map_[..., None] if dimensions == 3 else map_


def _lamp(width: int, height: int, shade: float, random: np.random.Generator) -> Array:
    """Light that falls off linearly across the sheet and in a broad spot: 1 at best, 1 - shade at worst."""
    u, v = np.meshgrid(np.linspace(-1, 1, width, dtype=np.float32), np.linspace(-1, 1, height, dtype=np.float32))
    heading = random.uniform(0.0, 2.0 * np.pi)
    slope = np.cos(heading) * u + np.sin(heading) * v
    at = random.uniform(-0.6, 0.6, 2)
    spot = np.exp(-((u - at[0]) ** 2 + (v - at[1]) ** 2) / 0.8)
    mixed = 0.6 * slope + 1.0 * spot
    return np.asarray(1.0 - shade * (mixed.max() - mixed) / np.ptp(mixed), np.float32)


def _grain(width: int, height: int, random: np.random.Generator) -> Array:
    """Streaks of a wooden table, about -1 to 1."""
    small = random.normal(0.0, 1.0, (max(height // 6, 2), max(width // 90, 2))).astype(np.float32)
    return np.asarray(cv2.resize(small, (width, height), interpolation=cv2.INTER_CUBIC))


def _with_gaps(image: Image, batches: int, random: np.random.Generator) -> Image:
    """Take the ink off in batches of small round places."""
    if not batches:
        return image
    out = image.copy()
    height, width = image.shape[:2]
    for _ in range(batches):
        at = random.uniform((0.1 * width, 0.1 * height), (0.9 * width, 0.9 * height))
        for place in at + random.normal(0.0, 0.03 * width, (6, 2)):
            radius = random.uniform(0.0015, 0.004) * width
            white = (255,) * (3 if image.ndim == 3 else 1)
            cv2.circle(out, (round(place[0]), round(place[1])), max(1, round(radius)), white, -1, cv2.LINE_AA)
    return out


def _sprinkle(picture: Image, share: float, random: np.random.Generator) -> None:
    """Dark and light specks of a pixel or two."""
    height, width = picture.shape[:2]
    count = int(share * height * width / 2)
    for value in (30, 240):
        v, u = random.integers(0, height - 1, count), random.integers(0, width - 1, count)
        picture[v, u] = value
        wide = random.random(count) < 0.3
        picture[v[wide], u[wide] + 1] = value

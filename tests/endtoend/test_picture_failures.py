"""What the reader says of pictures that it cannot read: file, what was seen, what to do."""

from __future__ import annotations

import re
from pathlib import Path

import cv2
import numpy as np
import pytest

from hullform.errors import PictureError
from hullform.picture.reading import read_picture
from hullform.ship import Ship, read_ship

BODYPLANS = Path(__file__).parents[2] / "bodyplans"


def ship_with(folder: Path, picture: bytes | None) -> Ship:
    """The container ship with another picture."""
    text = (BODYPLANS / "scim-containership" / "ship.toml").read_text(encoding="utf-8")
    (folder / "ship.toml").write_text(text, encoding="utf-8")
    if picture is not None:
        (folder / "bodyplan.png").write_bytes(picture)
    return read_ship(folder / "ship.toml")


def png(image: np.ndarray) -> bytes:
    return bytes(cv2.imencode(".png", image)[1].tobytes())


def noise() -> np.ndarray:
    return np.random.default_rng(1).integers(0, 256, (600, 800), dtype=np.uint8)


def a_circle() -> np.ndarray:
    image = np.full((600, 800), 255, np.uint8)
    cv2.circle(image, (400, 300), 200, 0, 2, cv2.LINE_AA)
    return image


def a_cross() -> np.ndarray:
    image = np.full((600, 800), 255, np.uint8)
    cv2.line(image, (20, 550), (780, 550), 0, 2)
    cv2.line(image, (400, 20), (400, 580), 0, 2)
    return image


@pytest.mark.parametrize(
    ("picture", "words"),
    [
        (None, "no such picture"),
        (b"", "empty"),
        (b"no image at all", "no image that can be decoded"),
        (png(np.full((600, 800), 255, np.uint8)), "blank"),
        (png(np.full((100, 200), 255, np.uint8)), "too small"),
        (png(noise()), "dark"),
        (png(a_circle()), "no centre line"),
        (png(a_cross()), "no ship's side|too few curves"),
    ],
    ids=["missing", "empty", "text", "blank", "small", "noise", "circle", "cross"],
)
def test_one_clear_message(picture: bytes | None, words: str, tmp_path: Path) -> None:
    ship = ship_with(tmp_path, picture)
    with pytest.raises(PictureError, match=words) as caught:
        read_picture(ship)
    assert "bodyplan.png" in str(caught.value)


def test_far_fewer_curves_than_stations_is_a_doubt_with_both_numbers(tmp_path: Path) -> None:
    image = cv2.imread(str(BODYPLANS / "wigley" / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    text = (BODYPLANS / "wigley" / "ship.toml").read_text(encoding="utf-8")
    head, _, rest = text.partition("aft_stations_m")
    names = ", ".join(f"{0.5 * n + 1:.1f}" for n in range(40))
    (tmp_path / "ship.toml").write_text(
        f"{head}aft_stations_m = [{names}]\n#{rest.partition(']')[2]}", encoding="utf-8"
    )
    (tmp_path / "bodyplan.png").write_bytes(png(image))
    doubts = "\n".join(read_picture(read_ship(tmp_path / "ship.toml")).body_plan.doubts)
    assert re.search(r"aft half: \d+ curves for 40 stations, .* check aft_stations_m", doubts)

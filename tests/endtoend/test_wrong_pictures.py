"""Pictures that are no body plan, or not upright: a message that says what they look like, and no hull."""

from __future__ import annotations

import re
import shutil
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
import wrong_pictures
from numpy.typing import NDArray

from hullform.cli import main
from hullform.errors import PictureError
from hullform.picture.reading import read_picture
from hullform.ship import read_ship

BODYPLANS = Path(__file__).parents[2] / "bodyplans"
CONTAINER, TANKER, WIGLEY = "scim-containership", "ds-tanker", "wigley"
Picture = NDArray[np.uint8]


def shipped(name: str) -> Picture:
    image = cv2.imread(str(BODYPLANS / name / "bodyplan.png"), cv2.IMREAD_GRAYSCALE)
    return np.asarray(image, dtype=np.uint8)


def message(folder: Path, name: str, picture: Picture) -> str:
    """What the reader says of a ship with another picture."""
    shutil.copy(BODYPLANS / name / "ship.toml", folder)
    cv2.imwrite(str(folder / "bodyplan.png"), picture)
    with pytest.raises(PictureError) as caught:
        read_picture(read_ship(folder / "ship.toml"))
    return str(caught.value)


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
@pytest.mark.parametrize(
    ("draw", "words"),
    [
        (wrong_pictures.text_page, "looks like text: .* pieces as small as letters"),
        (wrong_pictures.table, "looks like a table or an empty grid: 21 by 11 long lines"),
        (
            wrong_pictures.profile,
            r"waterlines plan, or breadth_m or depth_m is wrong: the drawing is 4\.7 times as wide as high",
        ),
        (wrong_pictures.waterlines_plan, "looks like a profile or a waterlines plan"),
        (wrong_pictures.photograph, "looks like a photograph"),
        (wrong_pictures.pale_photograph, "looks like a photograph"),
    ],
)
def test_other_pictures(draw: Callable[[], Picture], words: str, name: str, tmp_path: Path) -> None:
    said = message(tmp_path, name, draw())
    assert re.search(words, said)
    assert said.count("bodyplan.png") == 1


@pytest.mark.parametrize("name", [CONTAINER, TANKER, WIGLEY])
def test_upside_down(name: str, tmp_path: Path) -> None:
    assert "upside down" in message(tmp_path, name, shipped(name)[::-1, ::-1])


def test_flipped_upside_down(tmp_path: Path) -> None:
    assert "upside down" in message(tmp_path, TANKER, shipped(TANKER)[::-1])


@pytest.mark.parametrize("quarter", [1, 3])
def test_on_its_side(quarter: int, tmp_path: Path) -> None:
    assert "on its side" in message(tmp_path, CONTAINER, np.ascontiguousarray(np.rot90(shipped(CONTAINER), quarter)))


def test_one_half_only(tmp_path: Path) -> None:
    assert "half a body plan" in message(tmp_path, TANKER, shipped(TANKER)[:, 1000:])


def test_light_lines_on_a_dark_ground_read_alike(tmp_path: Path) -> None:
    shutil.copy(BODYPLANS / WIGLEY / "ship.toml", tmp_path)
    cv2.imwrite(str(tmp_path / "bodyplan.png"), 255 - shipped(WIGLEY))
    reading = read_picture(read_ship(tmp_path / "ship.toml"))
    assert reading.body_plan.doubts == ()
    assert np.array_equal(reading.grey, shipped(WIGLEY))


def test_the_command_writes_no_hull(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(BODYPLANS / WIGLEY / "ship.toml", tmp_path)
    cv2.imwrite(str(tmp_path / "bodyplan.png"), wrong_pictures.profile())
    assert main(["trace", str(tmp_path / "ship.toml"), "-o", str(tmp_path / "offsets.csv")]) == 1
    assert "profile or a waterlines plan" in capsys.readouterr().err
    assert not (tmp_path / "offsets.csv").exists()

"""Image files of every kind give the same grey; damaged, wrong and missing ones a message."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from hullform.errors import PictureError
from hullform.picture.image.image_files import load_grey

Picture = NDArray[np.uint8]


def drawing() -> Picture:
    grey = np.full((500, 700), 255, np.uint8)
    grey[100:400, 300:310] = 20
    grey[400:404, 100:600] = 0
    return grey


def file_of(kind: str, image: Image.Image, **options: object) -> bytes:
    out = io.BytesIO()
    image.save(out, kind, **options)
    return out.getvalue()


GREY = Image.fromarray(drawing())
HARD = GREY.point(lambda level: 255 * (level > 128))
SIXTEEN = Image.fromarray(drawing().astype(np.uint16) * 257)
TWELVE = Image.fromarray(drawing().astype(np.uint16) << 4)
YELLOW = Image.merge("RGB", [Image.new("L", GREY.size, 255), Image.new("L", GREY.size, 255), GREY])
ON_NOTHING = Image.merge("RGBA", [Image.new("L", GREY.size, 0)] * 3 + [GREY.point(lambda level: 255 - level)])
HOLE = GREY.convert("RGBA").quantize(8)
LOSSLESS = {
    "grey png": ("PNG", GREY, {}),
    "palette png": ("PNG", GREY.convert("P"), {}),
    "png with alpha": ("PNG", GREY.convert("LA"), {}),
    "black on transparent": ("PNG", ON_NOTHING, {}),
    "transparent colour of a palette": ("PNG", HOLE, {"transparency": HOLE.getpixel((5, 5))}),
    "drawn in yellow": ("PNG", YELLOW, {}),
    "16-bit png": ("PNG", SIXTEEN, {}),
    "grey tiff": ("TIFF", GREY, {"compression": "tiff_lzw"}),
    "palette tiff": ("TIFF", GREY.convert("P"), {}),
    "tiff with alpha": ("TIFF", ON_NOTHING, {}),
    "16-bit tiff": ("TIFF", SIXTEEN, {}),
    "12 bits in 16": ("TIFF", TWELVE, {}),
    "webp": ("WEBP", GREY.convert("RGB"), {"lossless": True}),
    "webp with alpha": ("WEBP", ON_NOTHING, {"lossless": True, "exact": True}),
    "grey bmp": ("BMP", GREY, {}),
    "palette bmp": ("BMP", GREY.convert("P"), {}),
}


@pytest.mark.parametrize("kind", LOSSLESS)
def test_kinds_of_pictures_read_alike(kind: str, tmp_path: Path) -> None:
    form, image, options = LOSSLESS[kind]
    path = tmp_path / "spanter-ü-図"
    path.write_bytes(file_of(form, image, **options))
    # the alpha channel rounds a level to the nearest 1/255
    assert np.abs(load_grey(path).astype(int) - drawing()).max() <= 1


@pytest.mark.parametrize("form", ["PNG", "TIFF", "BMP", "group4"])
def test_one_bit_pictures(form: str, tmp_path: Path) -> None:
    options = {"compression": "group4"} if form == "group4" else {}
    (tmp_path / "picture").write_bytes(file_of("TIFF" if options else form, HARD.convert("1"), **options))
    assert np.array_equal(load_grey(tmp_path / "picture"), np.asarray(HARD))


@pytest.mark.parametrize("mode", ["L", "RGB", "CMYK"])
def test_jpeg_loses_little(mode: str, tmp_path: Path) -> None:
    (tmp_path / "picture.jpg").write_bytes(file_of("JPEG", GREY.convert(mode), quality=95))
    # edges ring by some tens of levels; on average next to nothing changes
    assert np.abs(load_grey(tmp_path / "picture.jpg").astype(int) - drawing()).mean() < 0.5


# what must be done to the stored picture, as the EXIF standard says of the tag
@pytest.mark.parametrize(
    ("tag", "turn"),
    [
        (1, None),
        (2, Image.Transpose.FLIP_LEFT_RIGHT),
        (3, Image.Transpose.ROTATE_180),
        (4, Image.Transpose.FLIP_TOP_BOTTOM),
        (5, Image.Transpose.TRANSPOSE),
        (6, Image.Transpose.ROTATE_270),
        (7, Image.Transpose.TRANSVERSE),
        (8, Image.Transpose.ROTATE_90),
    ],
)
@pytest.mark.parametrize("form", ["PNG", "TIFF", "WEBP"])
def test_a_camera_s_turn_is_obeyed(form: str, tag: int, turn: Image.Transpose | None, tmp_path: Path) -> None:
    exif = Image.Exif()
    exif[0x0112] = tag
    stored = GREY.convert("RGB")
    (tmp_path / "picture").write_bytes(
        file_of(form, stored, exif=exif, **({"lossless": True} if form == "WEBP" else {}))
    )
    upright = GREY if turn is None else GREY.transpose(turn)
    assert np.array_equal(load_grey(tmp_path / "picture"), np.asarray(upright))


@pytest.mark.parametrize("form", ["PNG", "JPEG", "TIFF", "WEBP", "BMP"])
@pytest.mark.parametrize("share", [0.02, 0.5, 0.97])
def test_a_file_cut_short(form: str, share: float, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    content = file_of(form, GREY)
    (tmp_path / "picture").write_bytes(content[: int(share * len(content))])
    with pytest.raises(PictureError, match="damaged"):
        load_grey(tmp_path / "picture")
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize(
    ("size", "words"),
    [
        ((640, 400), "640 x 400 px is too small"),
        ((9000, 7000), "9000 x 7000 px is more than 60 Mpx"),
        ((20000, 15000), "the picture is more than 60 Mpx"),
    ],
)
def test_sizes_that_are_refused_before_decoding(size: tuple[int, int], words: str, tmp_path: Path) -> None:
    (tmp_path / "picture.png").write_bytes(file_of("PNG", Image.new("1", size, 1)))
    with pytest.raises(PictureError, match=words):
        load_grey(tmp_path / "picture.png")


def test_a_page_of_a_tiff_of_several(tmp_path: Path) -> None:
    path = tmp_path / "picture.tif"
    path.write_bytes(file_of("TIFF", Image.new("L", (700, 500), 255), save_all=True, append_images=[GREY]))
    assert load_grey(path).min() == 255
    assert np.array_equal(load_grey(path, 2), drawing())
    with pytest.raises(PictureError, match=r"has 2 pages, but .* page = 3"):
        load_grey(path, 3)


def pdf(tmp_path: Path) -> Path:
    """Two pages of 350 x 250 points: a blank one, and the drawing at 144 dpi."""
    path = tmp_path / "plans.pdf"
    path.write_bytes(
        file_of("PDF", Image.new("L", (700, 500), 255), save_all=True, append_images=[GREY], resolution=144)
    )
    return path


def test_a_page_of_a_pdf(tmp_path: Path) -> None:
    grey = load_grey(pdf(tmp_path), 2)
    assert grey.shape[1] == 3600
    assert grey.shape[0] == pytest.approx(3600 * 500 / 700, abs=1)
    small = np.asarray(Image.fromarray(grey).resize(GREY.size, Image.Resampling.BOX)).astype(int)
    inner = np.abs(small - drawing())[110:390, 302:308]
    # images lie in a PDF as JPEG, and are drawn five times larger
    assert inner.mean() < 5
    assert load_grey(pdf(tmp_path)).min() > 250
    with pytest.raises(PictureError, match=r"has 2 pages, but .* page = 7"):
        load_grey(pdf(tmp_path), 7)


def test_a_damaged_pdf(tmp_path: Path) -> None:
    (tmp_path / "plans.pdf").write_bytes(b"%PDF-1.7\nnothing")
    with pytest.raises(PictureError, match=r"plans\.pdf: the PDF cannot be opened"):
        load_grey(tmp_path / "plans.pdf")


def test_without_the_reader_of_pdf_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = pdf(tmp_path)
    monkeypatch.setitem(sys.modules, "pypdfium2", None)
    with pytest.raises(PictureError, match=r"python -m pip install 'hullform\[pdf\]'"):
        load_grey(path)

"""What every figure of the report shares: colours, type, axes, and how it becomes a file and a piece of a page."""

from __future__ import annotations

import base64
import html
import io
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, Literal

import matplotlib
from matplotlib.axes import Axes
from matplotlib.figure import Figure

INK = "#1f2a36"
ACCENT = "#1b3a57"
WARM = "#b5532a"
QUIET = "#8794a1"
GRID = "#e4e8ec"
# One colour a loading condition, in the order of ship.toml; repeated where there are more.
SERIES = (ACCENT, WARM, "#4f7f3f", "#7d4f8a", "#8a7a2a")
# By the name of the weight; the two kinds of machinery are told apart from hull and cargo.
WEIGHT_COLOURS = {
    "steel": "#5d7388",
    "machinery": "#b5532a",
    "deck machinery": "#dba35a",
    "outfit": "#dba35a",
    "deadweight": "#b9cbd9",
}
# Weights of other names, the items of a list, in turn.
ITEM_COLOURS = (
    "#7f9f6f", "#a98bb3", "#c7b35f", "#6fa3a8", "#8794a1",
    "#c98f82", "#4f6b45", "#d8c3de", "#8a7434", "#bcdcdc", "#6b4f76", "#cfd8b4",
)  # fmt: skip

PAGE_WIDTH = 9.2  # inches, of every figure
JPEG_QUALITY = 82

# Text stays text: small files that can be searched. The fonts are the reader's own, measured with a wide one, so
# that no label is cut off.
_STYLE: Any = {
    "svg.fonttype": "none",
    "font.family": ["sans-serif"],
    "font.sans-serif": ["DejaVu Sans", "Segoe UI", "Helvetica Neue", "Arial"],
    "font.size": 9.0,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.8,
    "axes.titlesize": 9.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlecolor": INK,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.width": 0.8,
    "ytick.major.width": 0.8,
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "path.simplify_threshold": 0.3,
}
_FONTS_ON_SCREEN = "system-ui, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif"


@dataclass(frozen=True)
class Picture:
    """A finished figure: a file of its own, and what the page shows.

    Attributes:
        name: file name without suffix.
        caption: below the figure.
        alternative: what it shows, for those who cannot see it.
        suffix: of the file.
        content: of the file.
    """

    name: str
    caption: str
    alternative: str
    suffix: Literal["svg", "png", "jpg"]
    content: bytes

    @property
    def file_name(self) -> str:
        """The name of the file in the folder of figures."""
        return f"{self.name}.{self.suffix}"

    @property
    def inline(self) -> str:
        """The SVG element, its ids made unique in the page; empty for a pixel picture."""
        if self.suffix != "svg":
            return ""
        text = self.content.decode("utf-8")
        element = text[text.index("<svg") :].strip()
        element = re.sub(r"\bid=\"|url\(#|href=\"#", lambda found: f"{found[0]}{self.name}-", element)
        element = re.sub(r"'DejaVu Sans'[^;\"]*", _FONTS_ON_SCREEN, element)
        # Without a size of its own the drawing takes the width of its column.
        element = re.sub(r" (?:width|height)=\"[\d.]+pt\"", "", element, count=2)
        return element.replace("<svg", f'<svg role="img" aria-label="{html.escape(self.alternative)}"', 1)

    @property
    def data_uri(self) -> str:
        """A pixel picture as a data URI."""
        kind = "jpeg" if self.suffix == "jpg" else self.suffix
        return f"data:image/{kind};base64,{base64.b64encode(self.content).decode('ascii')}"


@contextmanager
def house_style() -> Iterator[None]:
    """Draw figures in the report's type and colours within the block."""
    with matplotlib.rc_context(_STYLE):
        yield


def finish(axes: Axes, x_label: str, y_label: str, length_m: float | None = None) -> None:
    """Label axes, with units, on a quiet grid; x from 0 to length_m where it runs along the ship."""
    axes.set_xlabel(x_label)
    axes.set_ylabel(y_label)
    axes.grid(color=GRID, linewidth=0.7)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    if length_m is not None:
        axes.set_xlim(0.0, length_m)


def as_svg(figure: Figure, name: str, caption: str, alternative: str) -> Picture:
    """The figure as SVG, the same bytes for the same drawing."""
    stream = io.BytesIO()
    with matplotlib.rc_context({"svg.hashsalt": name}):
        figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None})
    return Picture(name, caption, alternative, "svg", stream.getvalue())

"""The common look: colours that colour-blind people can tell apart, plain type, sizes in inches of paper."""

from __future__ import annotations

import io
import re
import warnings
from collections.abc import Callable
from functools import wraps
from typing import TYPE_CHECKING, Any, ParamSpec, TypeVar

import matplotlib
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.patheffects import AbstractPathEffect, withStroke
from matplotlib.text import Text
from matplotlib.textpath import text_to_path
from matplotlib.ticker import ScalarFormatter

from sweetspot.reports.quantities import PALETTE, with_minus_signs
from sweetspot.units.text import GROUPED_FROM

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

Given = ParamSpec("Given")
Result = TypeVar("Result")

INK, MUTED, GRID, PAPER = "#1d232a", "#59636e", "#dfe3e7", "#ffffff"
ZONE, ZONE_EDGE, ZONE_INK = "#e2f1e7", "#86b99a", "#2b6645"

OF_PAPER = {"ink": INK, "muted": MUTED, "grid": GRID, "paper": PAPER}
OF_THE_ZONE = {"zone": ZONE, "zone-edge": ZONE_EDGE, "zone-ink": ZONE_INK}
PAGE_COLOURS = {colour: name for name, colour in (OF_PAPER | OF_THE_ZONE | PALETTE).items()}
"""Colours of the pictures that a page's style sheet sets, so that they change with a dark screen."""

FIVE_DIGITS = re.compile(r"(?<![\d.])\d{5,}")
"""Before the point of a number."""

SMALL, NORMAL, LARGE, HUGE = 7.5, 8.5, 10.0, 17.0
"""Type sizes in points."""
SHEET = 7.17
"""Inches between the margins of an A4 sheet, the width of pictures that are laid out for paper."""

PLAIN, BOLD = (FontProperties(family="DejaVu Sans", weight=weight) for weight in ("normal", "bold"))

LOOK: dict[RcKeyType, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": NORMAL,
    "text.color": INK,
    "axes.edgecolor": MUTED,
    "axes.labelcolor": MUTED,
    "axes.labelsize": SMALL,
    "axes.linewidth": 0.7,
    "axes.facecolor": "none",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": False,
    "axes.unicode_minus": True,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.labelsize": SMALL,
    "ytick.labelsize": SMALL,
    "xtick.major.size": 3.0,
    "ytick.major.size": 0.0,
    "xtick.major.width": 0.7,
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "figure.facecolor": PAPER,
    "savefig.facecolor": PAPER,
    "path.simplify_threshold": 0.2,
    "svg.fonttype": "path",
    "svg.hashsalt": "sweetspot",
}
"""matplotlib settings, in force only while one of our functions draws or saves."""


def styled(draw: Callable[Given, Result]) -> Callable[Given, Result]:
    """Return a drawing function that runs in our look and leaves matplotlib's settings as they were.

    Negative numbers in a figure's words get minus signs, whoever wrote them; numbers of its axes get commas from
    10,000 on.
    """

    @wraps(draw)
    def wrapped(*args: Given.args, **kwargs: Given.kwargs) -> Result:
        with matplotlib.rc_context(LOOK):
            result = draw(*args, **kwargs)
            if isinstance(result, Figure):
                for axis in result.findobj(Axis):
                    _with_grouped_ticks(axis)
                for text in result.findobj(Text):
                    assert isinstance(text, Text)
                    text.set_text(with_minus_signs(text.get_text()))
            return result

    return wrapped


class GroupedTicks(ScalarFormatter):
    """Numbers of an axis as answers write them, with commas from 10,000 on."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Return one of them."""
        text = super().__call__(x, pos)
        return FIVE_DIGITS.sub(lambda whole: f"{int(whole[0]):,}", text)


def _with_grouped_ticks(axis: Any) -> None:
    if type(axis.get_major_formatter()) is ScalarFormatter and max(map(abs, axis.get_view_interval())) >= GROUPED_FROM:
        axis.set_major_formatter(GroupedTicks())


def fitted(words: str, *, width: float, size: float, smallest: float = 9.0, bold: bool = True) -> tuple[str, float]:
    """Return words and a type size in points with which they take at most ``width`` inches of paper.

    The type shrinks to ``smallest``; words too long even then are cut and end in an ellipsis.
    """
    words = " ".join(words.split())
    type_face = (BOLD if bold else PLAIN).copy()
    size = max(smallest, min(size, 72 * width * size / max(_width(words, type_face, size), 1e-9)))
    while len(words) > 1 and _width(words, type_face, size) > 72 * width * 1.001:
        words = words[:-2].rstrip() + "…"
    return words, size


def _width(words: str, type_face: FontProperties, size: float) -> float:
    """Return how wide words are in points."""
    type_face.set_size(size)
    with warnings.catch_warnings():  # a letter the typeface lacks is drawn as a box, which has a width too
        warnings.simplefilter("ignore")
        return float(text_to_path.get_text_width_height_descent(words, type_face, ismath=False)[0])


def halo(width: float = 2.5) -> list[AbstractPathEffect]:
    """Return the effect that keeps a label readable over lines: an outline in the colour of the paper."""
    return [withStroke(linewidth=width, foreground=PAPER)]


DOTS_PER_INCH = 200
QUICK = {"compress_level": 3}
"""Of PNG: a sixth larger than at the usual 6, and written in two thirds of the time."""


@styled
def png_bytes(figure: Figure) -> bytes:
    """Return a figure as PNG, 200 dots per inch, the same bytes every time."""
    return _rendered(figure, format="png", dpi=DOTS_PER_INCH, metadata={"Software": "sweetspot"}, pil_kwargs=QUICK)


@styled
def svg_bytes(figure: Figure) -> bytes:
    """Return a figure as SVG, text as outlines, the same bytes every time."""
    return _rendered(figure, format="svg", metadata={"Date": None, "Creator": "sweetspot"})


def _rendered(figure: Figure, **options: Any) -> bytes:
    buffer = io.BytesIO()
    with warnings.catch_warnings():  # a name in a script the typeface lacks is drawn as boxes; the page has it right
        warnings.filterwarnings("ignore", message="Glyph .* missing from font")
        figure.savefig(buffer, **options)
    return buffer.getvalue()

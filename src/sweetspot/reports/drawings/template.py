"""A sheet at full size on several pages, to print, cut and glue together."""

from __future__ import annotations

import io
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from sweetspot.reports.drawings.sheet import DrawingView, Layer, Sheet
from sweetspot.reports.drawings.svg import STEP
from sweetspot.reports.quantities import Reader
from sweetspot.units import INCH

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PAPERS: Mapping[str, tuple[float, float]] = {"a4": (297.0, 210.0), "letter": (279.4, 215.9)}
"""Width and height in mm of a sheet that lies."""
MARGIN, OVERLAP, HEAD = 10.0, 15.0, 24.0
"""mm that printers leave white, by which strips overlap, and for the words at the head of a page."""
BELOW = 18.0
"""mm below a strip for its sizes."""
CHORD = 5e-6
"""m by which straight pieces may be off the curves."""
LINES: Mapping[Layer, tuple[str, float, str]] = {
    "OUTLINE": ("black", 0.6, "-"),
    "HOLLOW": ("black", 0.4, "--"),
    "PARTS": ("tab:blue", 0.4, "--"),
    "FILL": ("tab:brown", 0.4, ":"),
    "CENTRE": ("black", 0.3, "-."),
}
"""Color, width in points and dashes of each layer."""
WAYS = {"mm": (100.0, "100 mm"), "in": (4e3 * INCH, "4 in")}
"""Lines that check the scale: length in mm and words."""


@dataclass(frozen=True)
class _Strip:
    """A part of a view from ``start`` on, mm from the butt end; ``number`` counts along the view."""

    view: DrawingView
    start: float
    number: int

    @property
    def height(self) -> float:
        return 2e3 * self.view.reach + 4.0 + (BELOW if self.view.sizes is not None else 4.0)


def template_pdf(sheet: Sheet, reading: Reader, *, paper: str = "a4") -> bytes:
    """Return a sheet 1 : 1 as a PDF of lying pages.

    ``paper``: a name of `PAPERS`.
    """
    from matplotlib import rc_context
    from matplotlib.backends.backend_pdf import PdfPages
    from matplotlib.figure import Figure

    size = PAPERS[paper]
    pages = _pages(sheet, size)
    content = io.BytesIO()
    undated = {"CreationDate": None, "Title": sheet.name, "Creator": "sweetspot", "Producer": None}
    with rc_context({"pdf.fonttype": 42}), PdfPages(content, metadata=undated) as pdf:
        for number, strips in enumerate(pages, 1):
            figure = Figure(figsize=(size[0] / 25.4, size[1] / 25.4))
            axes = figure.add_axes((0, 0, 1, 1), xlim=(0, size[0]), ylim=(0, size[1]))
            axes.axis("off")
            _head(axes, sheet, size, f"page {number} of {len(pages)}", whole=number == 1)
            top = size[1] - MARGIN - _head_height(sheet, whole=number == 1)
            for strip in strips:
                axis = top - 2.0 - 1e3 * strip.view.reach
                _draw(axes, strip, axis, size[0] - 2 * MARGIN, sheet.length, reading)
                top -= strip.height
            pdf.savefig(figure)
    return content.getvalue()


def _head_height(sheet: Sheet, *, whole: bool) -> float:
    return HEAD + (4.0 * len(sheet.remarks) if whole else 0.0)


def _pages(sheet: Sheet, size: tuple[float, float]) -> list[list[_Strip]]:
    """Return the strips of every page."""
    room = size[0] - 2 * MARGIN
    count = max(1, math.ceil((1e3 * sheet.length - OVERLAP) / (room - OVERLAP)))
    strips = [_Strip(view, i * (room - OVERLAP), i) for view in sheet.views for i in range(count)]
    pages: list[list[_Strip]] = [[]]
    left = size[1] - 2 * MARGIN - _head_height(sheet, whole=True)
    for strip in strips:
        if pages[-1] and strip.height > left:
            pages.append([])
            left = size[1] - 2 * MARGIN - _head_height(sheet, whole=False)
        pages[-1].append(strip)
        left -= strip.height
    return pages


def _head(axes: Axes, sheet: Sheet, size: tuple[float, float], page: str, *, whole: bool) -> None:
    """Draw the words of a page and the lines that check its scale."""
    top = size[1] - MARGIN
    axes.text(MARGIN, top, f"{sheet.name}, full size, {page}", va="top", fontsize=9, weight="bold")
    advice = "Print at 100 % (no fitting to the page). Measure these two lines: if they are off, so is the template."
    axes.text(MARGIN, top - 5, advice, va="top", fontsize=7)
    start = MARGIN
    for length, words in WAYS.values():
        y = top - 14
        axes.plot([start, start + length], [y, y], color="black", linewidth=0.6)
        for x in (start, start + length):
            axes.plot([x, x], [y - 2, y + 2], color="black", linewidth=0.6)
        axes.text(start + length / 2, y + 0.8, words, ha="center", va="bottom", fontsize=7)
        start += length + 12
    for row, words in enumerate(sheet.remarks if whole else ()):
        axes.text(MARGIN, top - 19 - 4 * row, words, va="top", fontsize=6.5)


def _draw(axes: Axes, strip: _Strip, axis: float, room: float, length: float, reading: Reader) -> None:
    """Draw one strip; ``axis``: height of its axis in mm, ``room``: its length in mm."""
    from matplotlib.patches import Rectangle

    low, high = strip.start, strip.start + room
    reach = 1e3 * strip.view.reach
    window = Rectangle((MARGIN, axis - reach - 2), room, 2 * reach + 4, transform=axes.transData)
    for drawn in strip.view.strokes:
        color, width, dashes = LINES[drawn.layer]
        for curve in drawn.curves:
            x, y = 1e3 * curve.points(CHORD).T
            if x.max() < low or x.min() > high:
                continue
            (path,) = axes.plot(x - low + MARGIN, y + axis, color=color, linewidth=width, linestyle=dashes)
            path.set_clip_path(window)
    _marks(axes, strip, axis, room, 1e3 * length)
    if strip.view.sizes is not None:
        _sizes(axes, strip, axis - reach - 3, room, length, reading)


def _marks(axes: Axes, strip: _Strip, axis: float, room: float, length: float) -> None:
    """Draw crosses that two strips share, each with its letter: they lie on each other when the strips are joined."""
    reach = 1e3 * strip.view.reach
    shared = [(strip.number - 1, MARGIN + OVERLAP / 2), (strip.number, MARGIN + room - OVERLAP / 2)]
    for number, x in shared:
        if number < 0 or strip.start + (x - MARGIN) > length:
            continue
        for y in (axis - reach, axis, axis + reach):
            axes.plot([x - 3, x + 3], [y, y], color="tab:red", linewidth=0.3)
            axes.plot([x, x], [y - 2, y + 2], color="tab:red", linewidth=0.3)
        axes.text(x + 1, axis + reach - 0.5, chr(ord("A") + number), color="tab:red", fontsize=7, va="top")


def _sizes(axes: Axes, strip: _Strip, foot: float, room: float, length: float, reading: Reader) -> None:
    """Write the sizes along a strip, each at its place."""
    assert strip.view.sizes is not None
    kind, sizes = strip.view.sizes
    step = STEP[reading.unit("place")]
    places = np.arange(0.0, length + 1e-9, step)
    places = places[(1e3 * places >= strip.start) & (1e3 * places <= strip.start + room)]
    digits = 3 if reading.unit("place") == "in" else 2
    for place, size in zip(places.tolist(), sizes(places).tolist(), strict=True):
        x = 1e3 * place - strip.start + MARGIN
        axes.plot([x, x], [foot, foot - 1.5], color="gray", linewidth=0.3)
        words = f"{reading.number(place, 'place', digits=0)}: {reading.number(size, 'length', digits=digits)}"
        axes.text(x, foot - 2, words, rotation=270, ha="center", va="top", fontsize=5.5)
    note = f"{strip.view.name}: {kind} ({reading.unit('length')}) from the end in the hand ({reading.unit('place')})"
    axes.text(MARGIN, foot - BELOW + 4.5, note, fontsize=5.5, va="top")

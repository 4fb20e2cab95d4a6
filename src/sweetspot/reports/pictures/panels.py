"""What every picture is laid out and drawn with: pages in inches of paper, and panels with titles, labels and grids."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.style import HUGE, INK, MUTED, NORMAL, PAPER, SMALL, fitted

DASHED, SPARSE = (0, (4, 2.5)), (0, (4, 3))
"""Lines of what is not the thing itself: a rigid bat, a fit, an axis."""


class Page:
    """A figure whose panels and words are placed in inches of paper from its upper left corner.

    Parameters
    ----------
    side : inches of margin, left and right.
    """

    def __init__(self, width: float, height: float, side: float) -> None:
        self.figure = Figure(figsize=(width, height))
        self.width, self.height, self.side = width, height, side

    @property
    def across(self) -> float:
        """Inches between the margins."""
        return self.width - 2 * self.side

    def panel(self, top: float, height: float, *, left: float | None = None, width: float | None = None) -> Axes:
        """Return new axes, from margin to margin by default."""
        left, width = self.side if left is None else left, self.across if width is None else width
        place = (left / self.width, 1 - (top + height) / self.height, width / self.width, height / self.height)
        return self.figure.add_axes(place)

    def write(self, words: str, down: float, *, right: bool = False, **look: Any) -> None:
        """Write words at a margin; ``down``: inches from the top, below zero from the bottom."""
        place = 1 - self.side / self.width if right else self.side / self.width
        height = 1 - down / self.height if down > 0 else -down / self.height
        self.figure.text(place, height, words, ha="right" if right else "left", **({"parse_math": False} | look))

    def title(self, words: str, note: str = "", *, down: float = 0.42, beside: float = 0.0, size: float = HUGE) -> None:
        """Write the title, and a quiet line below it; ``beside``: inches that something right of it takes."""
        words, size = fitted(words, width=self.across - beside, size=size)
        self.write(words, down, size=size, weight="bold")
        if note:
            self.write(note, down + 0.24, color=MUTED, size=NORMAL)

    def foot(self, words: str, up: float = 0.12) -> None:
        """Write small print at the foot."""
        self.write(words, -up, color=MUTED, size=SMALL)


def heading(axes: Axes, title: str, note: str = "") -> None:
    """Write a panel's title, and a quieter note after it, above its upper left corner."""
    text = beside(axes, title, (0, 1), (0, 5), xycoords="axes fraction", ha="left", va="baseline", weight="bold")
    if note:
        beside(axes, note, (1, 0), (7, 0), xycoords=text, color=MUTED, size=SMALL, va="bottom", ha="left")


@dataclass(frozen=True)
class Panel:
    """What stands around the curves of a panel: title and note, labels, a faint grid, how many ticks go upwards."""

    title: str
    note: str = ""
    x: str = ""
    y: str = ""
    grid: Literal["both", "y", "none"] = "both"
    ticks: int | None = None
    prune: Literal["lower", "upper"] | None = None
    labelpad: float = 4.0


def frame(axes: Axes, panel: Panel) -> None:
    """Write what stands around a panel."""
    if panel.title:
        heading(axes, panel.title, panel.note)
    axes.set_xlabel(panel.x, labelpad=panel.labelpad)
    axes.set_ylabel(panel.y)
    if panel.grid != "none":
        axes.set_axisbelow(True)
        axes.grid(visible=True, axis=panel.grid)
    if panel.ticks is not None:
        axes.yaxis.set_major_locator(MaxNLocator(nbins=panel.ticks, prune=panel.prune))


def rows_only(axes: Axes) -> None:
    """Take ticks and line from the left of a panel whose rows have names."""
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)


def write(axes: Axes, x: float, y: float, words: str, **look: Any) -> Text:
    """Write words at a place."""
    return axes.text(x, y, words, **look)


def beside(axes: Axes, words: str, place: tuple[float, float], aside: tuple[float, float], **look: Any) -> Annotation:
    """Write words some points of paper right of and above a place."""
    return axes.annotate(words, place, xytext=aside, textcoords="offset points", **look)


def beside_row(axes: Axes, row: float, words: str, gap: float = 8, *, ahead: bool = False, **look: Any) -> None:
    """Write left of a panel what a row is, or right of it (``ahead``) what it comes to, ``gap`` points away."""
    side = {"ha": "left" if ahead else "right", "color": INK, "parse_math": False}
    place, aside = (float(ahead), row), (gap if ahead else -gap, 0)
    beside(axes, words, place, aside, xycoords=("axes fraction", "data"), **(side | look))


def dot(axes: Axes, place: float, height: float, colour: str, *, size: float = 5.0, zorder: float = 5) -> None:
    """Draw a dot with a rim in the colour of the paper, over everything else."""
    (mark,) = axes.plot(place, height, "o", color=colour, markersize=size)
    mark.set(markeredgecolor=PAPER, markeredgewidth=0.8, zorder=zorder)


def ring(axes: Axes, place: float, height: float, colour: str) -> None:
    """Draw a small ring, over everything else."""
    (mark,) = axes.plot(place, height, "o", color=PAPER, markersize=4.2)
    mark.set(markeredgecolor=colour, markeredgewidth=1.2, zorder=5)


def double_arrow(axes: Axes, start: float, end: float, height: float, colour: str, *, width: float = 1.0) -> None:
    """Draw a level arrow with two heads that ends where it is said to."""
    arrow = {"arrowstyle": "<->", "color": colour, "linewidth": width, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 8}
    axes.annotate("", (start, height), (end, height), arrowprops=arrow)


def band(axes: Axes, places: Array, low: Array, high: Array, colour: str, *, alpha: float = 0.22) -> None:
    """Draw an interval around a curve."""
    axes.fill_between(places, low, high, color=colour, alpha=alpha, linewidth=0, zorder=1.5, gid="band")


def roomy(values: ArrayLike, below: float, above: float, *, least: float = 0.0) -> tuple[float, float]:
    """Return limits that hold all values, with parts of their range free below and above; ``least`` of no range."""
    low, high = float(np.nanmin(values)), float(np.nanmax(values))
    span = high - low or least
    return low - below * span, high + above * span


def second_scale(axes: Axes, factor: float, label: str) -> None:
    """Add a scale on the right: what the left one says times ``factor``."""
    there, back = partial(np.multiply, factor), partial(np.multiply, 1 / factor)
    second = axes.secondary_yaxis("right", functions=(there, back))
    second.spines["right"].set_visible(True)
    second.set_ylabel(label)

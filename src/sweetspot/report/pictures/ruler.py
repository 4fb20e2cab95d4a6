"""The one horizontal axis of all pictures: metres from the knob end inside, inches or cm from the tip for people."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.markers import TICKDOWN

from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.report.pictures.style import GRID, MUTED
from sweetspot.report.quantities import Reader
from sweetspot.report.sport_words import words_of

MARGIN = 0.02
"""Empty part of the bat's length at either end of the axis."""
CENTIMETRE_STEP = 10
TICKS = {"in": ("inches", 3), "cm": ("centimetres", 10)}
"""By the unit of places: its name in full, and how many of them lie between ticks."""


def set_limits(axes: Axes, length: float) -> None:
    """Let an axis span a bat of ``length`` m with a little air at both ends."""
    axes.set_xlim(-MARGIN * length, (1 + MARGIN) * length)


SMALL_FACE = 0.3
"""Part of the length below which the panels show the face alone, and what lies near it."""
AROUND_FACE = 0.15
"""How much of the shaft such panels show, as a part of the face."""
STEPS, MOST_TICKS = (1, 2, 5, 10, 20, 50), 16
"""Places between ticks where a part of the length is shown, and how many ticks there may be."""


def window(implement: Implement) -> tuple[float, float]:
    """Return the part of an implement in m that panels show: all of it, or the face where that is small."""
    face = implement.outline
    if face is None or face.end - face.start > SMALL_FACE * implement.length:
        return 0.0, implement.length
    return max(0.0, face.start - AROUND_FACE * (face.end - face.start)), implement.length


def is_zoomed(implement: Implement) -> bool:
    """Return whether panels show the face alone."""
    return window(implement)[0] > 0


def set_window(axes: Axes, implement: Implement) -> None:
    """Let an axis span what panels show of an implement, with a little air at both ends."""
    low, high = window(implement)
    axes.set_xlim(low - MARGIN * (high - low), high + MARGIN * (high - low))


def metres_per_inch_of_paper(length: float, width: float) -> float:
    """Return the drawing's scale: metres of bat per inch of paper on an axis ``width`` inches wide."""
    return (1 + 2 * MARGIN) * length / width


def show_from_tip(axes: Axes, length: float, reading: Reader, *, labels: bool = True, grid: bool = False) -> None:
    """Put ticks every few inches or centimetres from the tip, as people count.

    Marks and grid are one artist each: of matplotlib's own ticks every one takes five.

    Parameters
    ----------
    labels : whether numbers stand below, and a mark for every unit.
    grid : whether a faint line goes up from every tick.
    """
    unit = reading.units["place"]
    limits = axes.get_xlim()
    shown = limits[1] - limits[0]
    step = TICKS[unit.name][1]
    if shown <= length / 2:
        step = next(one for one in STEPS if shown / (one * unit.size) < MOST_TICKS)
    counts = np.arange(0, length / unit.size + 1e-6, step)
    places = length - counts * unit.size
    seen = (places >= limits[0]) & (places <= limits[1])
    places, counts = places[seen], counts[seen]
    if grid:
        axes.vlines(places, 0, 1, transform=axes.get_xaxis_transform(), colors=GRID, linewidth=0.6, zorder=0.5)
    if labels:
        axes.set_xticks(places, [f"{value:.0f}" for value in counts])
        every = length - np.arange(0, length / unit.size + 1e-6) * unit.size
        every = every[(every >= limits[0]) & (every <= limits[1])]
        _marks(axes, every, size=1.8, width=0.5)
    else:
        axes.set_xticks([])
        _marks(axes, places, size=3.0, width=0.7)
    axes.set_xlim(limits)


def _marks(axes: Axes, places: Array, *, size: float, width: float) -> None:
    """Draw short lines below the axis."""
    axes.plot(
        places, np.zeros_like(places), linestyle="", marker=TICKDOWN, markersize=size, markeredgewidth=width,
        color=MUTED, transform=axes.get_xaxis_transform(), clip_on=False, scalex=False, scaley=False,
    )  # fmt: skip


def from_the_tip(implement: Implement, reading: Reader) -> str:
    """Return what the numbers along an implement count: "inches from the tip"."""
    return f"{TICKS[reading.unit('place')][0]} from the {words_of(implement).tip}"


def show_centimetres(axes: Axes, length: float, *, offset: float, butt: str = "knob end") -> Axes:
    """Add a second ruler, in cm from the knob, ``offset`` points below the axis; return it."""
    places = np.arange(0, length + 1e-9, CENTIMETRE_STEP / 100)
    ruler = axes.twiny()
    ruler.set_xlim(axes.get_xlim())
    ruler.xaxis.set_ticks_position("bottom")
    ruler.xaxis.set_label_position("bottom")
    ruler.spines[["left", "right", "top"]].set_visible(False)
    ruler.spines["bottom"].set_visible(True)
    ruler.spines["bottom"].set_position(("outward", offset))
    ruler.set_xticks(places, [f"{100 * place:.0f}" for place in places])
    ruler.set_xlabel(f"cm from the {butt}", labelpad=2)
    return ruler

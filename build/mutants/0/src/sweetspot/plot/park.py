"""Parks from above: fences in the field's frame, home plate at the origin, centre field up."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from sweetspot.park import FOUL_LINE, Park, fence_at
from sweetspot.plot.style import BLUE, GREEN, INK, MUTED, ORANGE, PURPLE, RED, SKY, halo, styled
from sweetspot.units import FOOT

COLOURS = (RED, BLUE, GREEN, ORANGE, PURPLE, SKY)
BASE_PATH = 90.0
"""ft between bases."""
RINGS = (300, 350, 400)
"""ft from home plate."""


@styled
def parks_figure(parks: Sequence[Park], named: Sequence[Park] = ()) -> Figure:
    """Return many fences laid over each other, those in ``named`` in colour with their heights as thickness.

    Parameters
    ----------
    parks : drawn thin and grey.
    named : up to six, drawn in colour and with names.
    """
    figure = Figure(figsize=(7.0, 5.6), layout="constrained")
    axes = figure.subplots()
    draw_field(axes)
    for park in parks:
        draw_fence(axes, park, colour=MUTED, alpha=0.35)
    for park, colour in zip(named, COLOURS, strict=False):
        draw_fence(axes, park, colour=colour, thick=True, label=park.name)
    if named:
        axes.legend(loc="lower left", frameon=False, title="line as thick as the wall is high")
    return figure


def draw_field(axes: Axes) -> None:
    """Draw foul lines, the infield and distance rings in ft, and fix the axes' shape."""
    line = np.array([0.0, 420.0]) * math.sin(FOUL_LINE)
    for side in (-1, 1):
        axes.plot(side * line, line, color=INK, linewidth=0.8)
    half = BASE_PATH * math.sin(FOUL_LINE)
    axes.plot([0, half, 0, -half, 0], [0, half, 2 * half, half, 0], color=INK, linewidth=0.8)
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    for ring in RINGS:
        axes.plot(ring * np.sin(turn), ring * np.cos(turn), color=MUTED, linewidth=0.5, linestyle=":")
        axes.annotate(f"{ring} ft", (0, ring), size=6.5, color=MUTED, ha="center", va="center", path_effects=halo(2))
    axes.set(aspect="equal", xlim=(-310, 310), ylim=(-10, 440))
    axes.axis("off")


def draw_fence(
    axes: Axes, park: Park, *, colour: str = INK, alpha: float = 1.0, thick: bool = False, label: str | None = None
) -> None:
    """Draw a fence from above in ft; ``thick``: the line is as thick as the wall is high, 1 pt for 8 ft."""
    place, height = outline(park)
    if not thick:
        axes.plot(*place.T, color=colour, alpha=alpha, linewidth=0.7, label=label)
        return
    for start in range(len(place) - 1):
        width = 0.9 * (height[start] + height[start + 1]) / 2 / 8
        axes.plot(*place[start : start + 2].T, color=colour, linewidth=max(0.5, width), solid_capstyle="butt")
    axes.plot([], [], color=colour, linewidth=1.8, label=label)


def outline(park: Park) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return points of a fence, one per degree, right and out in ft, shape (91, 2), and its height there in ft."""
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    distance, height = fence_at(park, turn)
    return (distance * np.stack([np.sin(turn), np.cos(turn)])).T / FOOT, height / FOOT

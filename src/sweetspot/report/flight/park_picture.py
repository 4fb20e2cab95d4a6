"""Parks from above: fences in the field's frame, home plate at the origin, centre field up."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.report.pictures.style import INK, LARGE, MUTED, halo, styled
from sweetspot.report.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY, US, Reader
from sweetspot.units import FOOT

COLOURS = (RED, BLUE, GREEN, ORANGE, PURPLE, SKY)
BASE_PATH = 90 * FOOT
"""m between bases."""
RINGS = {"ft": (300, 350, 400), "m": (90, 105, 120)}
SMALL_RINGS = {"ft": (100, 150, 200, 250), "m": (30, 45, 60, 75)}
"""From home plate, in the unit of the readers; on a field for youth."""
REACH = 440 * FOOT
"""m that is drawn towards centre field."""


@styled
def parks_figure(
    parks: Sequence[Park], named: Sequence[Park] = (), reading: Reader = US, *, size: tuple[float, float] = (7.0, 5.6)
) -> Figure:
    """Return many fences laid over each other, those in ``named`` in colour with their heights as thickness.

    Parameters
    ----------
    parks : drawn thin and grey.
    named : up to six, drawn in colour and with names.
    size : inches of paper.
    """
    figure = Figure(figsize=size, layout="constrained")
    axes = figure.subplots()
    draw_field(axes, reading)
    for park in parks:
        draw_fence(axes, park, colour=MUTED, alpha=0.35, reading=reading)
    for park, colour in zip(named, COLOURS, strict=False):
        draw_fence(axes, park, colour=colour, thick=True, label=park.name, reading=reading)
    heading = ", ".join(park.name for park in named) if len(named) == 1 else f"Fences of {len(parks)} parks"
    figure.suptitle(heading, x=0.02, ha="left", weight="bold", size=LARGE, parse_math=False)
    if named:
        others = "the others" if set(named) <= set(parks) else "those of the Major Leagues"
        axes.legend(
            loc="lower left", frameon=False, title=f"line as thick\nas the wall is high;\ngrey: {others}",
            alignment="left",
        )  # fmt: skip
    return figure


def draw_field(axes: Axes, reading: Reader = US, *, small: bool = False) -> None:
    """Draw foul lines, the infield and distance rings in the readers' unit, and fix the axes' shape.

    Parameters
    ----------
    small : a field for youth, whose bases are 60 ft apart.
    """
    unit = reading.units["distance"].size
    line = np.array([0.0, 0.95 * REACH / unit]) * math.sin(FOUL_LINE)
    for side in (-1, 1):
        axes.plot(side * line, line, color=INK, linewidth=0.8)
    half = BASE_PATH * (2 / 3 if small else 1) / unit * math.sin(FOUL_LINE)
    axes.plot([0, half, 0, -half, 0], [0, half, 2 * half, half, 0], color=INK, linewidth=0.8)
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    for ring in (SMALL_RINGS if small else RINGS)[reading.unit("distance")]:
        axes.plot(ring * np.sin(turn), ring * np.cos(turn), color=MUTED, linewidth=0.5, linestyle=":")
        end = ring * math.sin(FOUL_LINE)
        axes.annotate(
            f"{ring} {reading.unit('distance')}", (end, end), xytext=(4, -1), textcoords="offset points", size=6.5,
            color=MUTED, va="top", path_effects=halo(2),
        )  # fmt: skip
    axes.set(aspect="equal", xlim=(-0.7 * REACH / unit, 0.7 * REACH / unit), ylim=(-0.02 * REACH / unit, REACH / unit))
    axes.axis("off")


def draw_fence(
    axes: Axes,
    park: Park,
    *,
    colour: str = INK,
    alpha: float = 1.0,
    thick: bool = False,
    label: str | None = None,
    reading: Reader = US,
) -> None:
    """Draw a fence from above; ``thick``: the line is as thick as the wall is high, 1 pt for 8 ft."""
    place, height = outline(park)
    place = place / reading.units["distance"].size
    if not thick:
        axes.plot(*place.T, color=colour, alpha=alpha, linewidth=0.7, label=label)
        return
    for start in range(len(place) - 1):
        width = 0.9 * (height[start] + height[start + 1]) / 2 / (8 * FOOT)
        axes.plot(*place[start : start + 2].T, color=colour, linewidth=max(0.5, width), solid_capstyle="butt")
    axes.plot([], [], color=colour, linewidth=1.8, label=label)


def outline(park: Park) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return points of a fence, one per degree, right and out in m, shape (91, 2), and its height there in m."""
    turn = np.linspace(-FOUL_LINE, FOUL_LINE, 91)
    distance, height = fence_at(park, turn)
    return (distance * np.stack([np.sin(turn), np.cos(turn)])).T, height

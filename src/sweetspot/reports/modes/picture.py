"""The motions of a bat in one picture: how it bends in its first modes, and where it stands still."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.marks import TICKS
from sweetspot.reports.pictures.style import INK, MUTED, NORMAL, PAPER, SMALL, heading, light_grid, styled
from sweetspot.reports.quantities import BLUE, SKY, Reader

MOST_SHOWN = 4
COLOURS = (SKY, BLUE, MUTED, MUTED)
"""Of the first bending modes, the lowest first."""
POINTS = 200


@styled
def modes_figure(modes: Modes, reading: Reader) -> Figure:
    """Return the first bending modes, each on its own line, nodes as dots; places count from the end of the grip."""
    bending = modes.of_family("bending")[:MOST_SHOWN]
    figure = Figure(figsize=(8.0, 1.0 + 0.75 * len(bending)), layout="constrained")
    axes = figure.subplots()
    places = np.linspace(modes.shapes.ends[0], modes.shapes.ends[-1], POINTS)
    unit = reading.units["place"]
    for row, index in enumerate(bending):
        draw_mode(axes, modes, index, row, places / unit.size, modes.shape_at(places)[:, index], unit.size)
        label_mode(
            axes, row, f"mode {modes.harmonics[index]}", reading.shown(float(modes.frequency[index]), "frequency")
        )
    axes.set(ylim=(-len(bending) + 0.45, 0.6), yticks=[], xlabel=f"{TICKS[unit.name][0]} from the end of the grip")
    axes.spines["left"].set_visible(False)
    light_grid(axes)
    heading(axes, "Bending modes", "a hit at a node does not ring that mode")
    return figure


def draw_mode(axes: Axes, modes: Modes, index: int, row: int, along: Array, shape: Array, size: float = 1.0) -> None:
    """Draw how a mode bends about its own line, which lies ``row`` below the first, and its nodes.

    Parameters
    ----------
    along : where the shape is known, in units of ``size`` m.
    """
    colour = COLOURS[row]
    axes.axhline(-row, color=MUTED, linewidth=0.5)
    axes.plot(along, -row + 0.42 * shape / np.abs(shape).max(), color=colour)
    nodes = modes.nodes(index)
    for node in nodes:
        draw_dot(axes, float(node) / size, -row, colour, filled=row < 2 and node == nodes[-1])


def label_mode(axes: Axes, row: int, called: str, rings: str) -> None:
    """Write a mode's number before its line, and how high it rings behind it."""
    axes.annotate(
        rings, (1, -row), xycoords=("axes fraction", "data"), xytext=(6, 0),
        textcoords="offset points", ha="left", va="center_baseline", color=INK, size=NORMAL,
    )  # fmt: skip
    axes.annotate(
        called, (0, -row), xycoords=("axes fraction", "data"), xytext=(-6, 0),
        textcoords="offset points", ha="right", va="center_baseline", color=MUTED, size=SMALL,
    )  # fmt: skip


def draw_dot(axes: Axes, place: float, height: float, colour: str, *, filled: bool = True) -> None:
    """Draw a node or a sweet spot: a full dot, or a ring."""
    axes.plot(
        place, height, "o", color=colour if filled else PAPER, markersize=5.5 if filled else 4.2,
        markeredgecolor=PAPER if filled else colour, markeredgewidth=0.8 if filled else 1.2, zorder=5,
    )  # fmt: skip

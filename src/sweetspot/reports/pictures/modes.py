"""The motions of a bat in one picture: how it bends in its first modes, and where it stands still."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array
from sweetspot.reports.pictures.marks import TICKS
from sweetspot.reports.pictures.panels import Panel, beside_row, dot, frame, ring, rows_only
from sweetspot.reports.pictures.style import MUTED, NORMAL, SMALL, styled
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
        rings = reading.shown(float(modes.frequency[index]), "frequency")
        draw_mode(axes, modes, index, row, places / unit.size, rings, unit.size)
    axes.set_ylim(-len(bending) + 0.45, 0.6)
    rows_only(axes)
    ruler = f"{TICKS[unit.name][0]} from the end of the grip"
    frame(axes, Panel("Bending modes", "a hit at a node does not ring that mode", x=ruler))
    return figure


def draw_mode(axes: Axes, modes: Modes, index: int, row: int, along: Array, rings: str, size: float = 1.0) -> None:
    """Draw how a mode bends about its own line, which lies ``row`` below the first, and its nodes.

    Parameters
    ----------
    along : where the shape is drawn, in units of ``size`` m.
    rings : how high, in words.
    """
    colour, shape = COLOURS[row], modes.shape_at(along * size)[:, index]
    axes.axhline(-row, color=MUTED, linewidth=0.5)
    axes.plot(along, -row + 0.42 * shape / np.abs(shape).max(), color=colour)
    nodes = modes.nodes(index)
    for node in nodes:
        if row < 2 and node == nodes[-1]:
            dot(axes, float(node) / size, -row, colour, size=5.5)
        else:
            ring(axes, float(node) / size, -row, colour)
    beside_row(axes, -row, rings, 6, ahead=True, va="center_baseline", size=NORMAL)
    beside_row(axes, -row, f"mode {modes.harmonics[index]}", 6, va="center_baseline", color=MUTED, size=SMALL)

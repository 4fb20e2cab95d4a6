"""A grid of answers in colours, with its numbers where there is room, or a curve."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.numerics.arrays import Array
from sweetspot.reports.grid import Grid, varied
from sweetspot.reports.pictures.panels import Panel, frame
from sweetspot.reports.pictures.style import INK, LARGE, MUTED, PAPER, SMALL, fitted, styled
from sweetspot.reports.quantities import BLUE, QUANTITIES, Reader

MOST_NUMBERS = 15
"""Rows or columns beyond which the cells have no numbers, and only some values are named."""
DARK = 0.55
"""Part of the range from which numbers are written in white."""


@styled
def grid_figure(grid: Grid, reading: Reader, title: str = "") -> Figure:
    """Return the picture of a grid; ``title`` says what it is about."""
    figure = Figure(figsize=(8.0, 5.0), layout="constrained")
    axes = figure.subplots()
    sides = [QUANTITIES[name].label for name, _ in (grid.down, *([grid.across] if grid.across else []))]
    words = f"{_label(grid.answer, reading)} by {' and '.join(sides)}"
    words = f"{title}: {words}" if title else words[0].upper() + words[1:]
    words, size = fitted(words, width=7.7, size=LARGE, smallest=SMALL)
    figure.suptitle(words, x=0.01, ha="left", weight="bold", size=size, parse_math=False)
    (_curve if grid.across is None else _cells)(axes, grid, reading)
    return figure


def _curve(axes: Axes, grid: Grid, reading: Reader) -> None:
    name, values = grid.down
    unit, size = reading.units[QUANTITIES[name].scale], reading.units[QUANTITIES[grid.answer].scale]
    along = (np.asarray(values) - unit.zero) / unit.size
    axes.plot(along, (grid.values[:, 0] - size.zero) / size.size, color=BLUE, marker="o", markersize=4)
    frame(axes, Panel("", x=_label(name, reading)))


def _cells(axes: Axes, grid: Grid, reading: Reader) -> None:
    assert grid.across is not None
    low, high = float(np.nanmin(grid.values, initial=np.inf)), float(np.nanmax(grid.values, initial=-np.inf))
    axes.imshow(np.ma.masked_invalid(grid.values), cmap="Blues", aspect="auto", vmin=low, vmax=high)
    for set_ticks, (name, values) in ((axes.set_yticks, grid.down), (axes.set_xticks, grid.across)):
        places = _some(values)
        set_ticks(places, [varied(name, values[place]).read(reading) for place in places])
    axes.set(xlabel=_label(grid.across[0], reading), ylabel=_label(grid.down[0], reading))
    axes.spines[:].set_visible(False)
    if max(grid.values.shape) > MOST_NUMBERS:
        return
    for (row, column), value in np.ndenumerate(grid.values):
        finite = bool(np.isfinite(value))
        dark = finite and value - low > DARK * (high - low) > 0
        words, colour = grid.number(float(value), reading) if finite else "none", INK if finite else MUTED
        axes.text(column, row, words, ha="center", va="center", size=SMALL, color=PAPER if dark else colour)


def _some(values: Sequence[float] | Array) -> list[int]:
    """Return the places of the values that are named on an axis."""
    step = -(-len(values) // MOST_NUMBERS)
    return list(range(0, len(values), step))


def _label(name: str, reading: Reader) -> str:
    unit = reading.unit(QUANTITIES[name].scale)
    words = QUANTITIES[name].label
    return f"{words} ({unit})" if unit else words

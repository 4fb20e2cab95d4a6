"""Who imports whom in the package: a folder a row, what it takes from each other one in the columns."""

from __future__ import annotations

from imports import arrows, layers
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from figures.style import BLUE, GREY, INK, WOOD

FULL = 100
"""Imports from which a square is of the full color."""


def architecture_figure() -> Figure:
    """Return a square for each pair of folders, the darker the more the row takes from the column."""
    rows = layers()
    names = [name for row in rows for name in row]
    found = arrows()
    figure = Figure(figsize=(8.6, 7.4), layout="constrained")
    axes = figure.subplots()
    start = 0
    for row in rows:
        axes.add_patch(
            Rectangle((start - 0.5, start - 0.5), len(row), len(row), facecolor=WOOD, edgecolor=INK, zorder=2)
        )
        start += len(row)
    for y, upper in enumerate(names):
        for x, lower in enumerate(names):
            if count := found[upper, lower]:
                shade = min(1.0, 0.12 + 0.88 * count / FULL)
                axes.add_patch(Rectangle((x - 0.5, y - 0.5), 1, 1, facecolor=BLUE, alpha=shade, linewidth=0))
                color = "white" if shade > 0.5 else INK
                axes.text(x, y, f"{count}", ha="center", va="center", fontsize=7, color=color, zorder=3)
    axes.set_xticks(range(len(names)), names, rotation=60, ha="left", rotation_mode="anchor", fontsize=9)
    axes.set_yticks(range(len(names)), names, fontsize=9)
    axes.xaxis.tick_top()
    axes.set_xlim(-0.5, len(names) - 0.5)
    axes.set_ylim(len(names) - 0.5, -0.5)
    axes.set_aspect("equal")
    axes.tick_params(length=0)
    axes.grid(visible=True, color=GREY, alpha=0.15)
    axes.set_axisbelow(True)
    return figure

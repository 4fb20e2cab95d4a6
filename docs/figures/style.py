"""Shared style of the documentation's figures."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.equipment.bat import Bat

INK, WOOD, RED, BLUE, GREEN, GREY = "#222222", "#e8cfa6", "#b3352b", "#1f5f99", "#2f7d4f", "#888888"
CENTIMETRES = 100.0


def new_figure(width: float, height: float, rows: int = 1, **options: object) -> tuple[Figure, list[Axes]]:
    """Return a figure of this size in inches with one column of axes."""
    figure = Figure(figsize=(width, height), layout="constrained")
    axes = figure.subplots(rows, 1, squeeze=False, **options)[:, 0]  # type: ignore[arg-type]
    return figure, list(axes)


def draw_bat(axes: Axes, bat: Bat, *, scale: float = CENTIMETRES, stretch: float = 1.0) -> None:
    """Draw a bat's outline along the x axis; ``stretch`` exaggerates its diameter."""
    places = np.unique(np.concatenate([np.linspace(0, bat.length, 300), bat.breakpoints()]))
    half = bat.diameter_at(places) / 2 * stretch
    axes.fill_between(places * scale, -half * scale, half * scale, color=WOOD, linewidth=0)
    for side in (-1, 1):
        axes.plot(places * scale, side * half * scale, color=INK, linewidth=0.8)
    for end in (0, -1):
        axes.plot([places[end] * scale] * 2, [-half[end] * scale, half[end] * scale], color=INK, linewidth=0.8)

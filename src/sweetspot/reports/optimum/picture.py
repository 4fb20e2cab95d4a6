"""The best way to hit in one picture: a row with a dot for every pitch, exit speed and park."""

from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.answers.optimum import OptimumAnswer
from sweetspot.reports.pictures.style import (
    HUGE,
    INK,
    NORMAL,
    SMALL,
    axes_in_inches,
    fitted,
    heading,
    light_grid,
    styled,
)
from sweetspot.reports.quantities import BLUE, GREEN, RED, Reader

WIDTH, SIDE, HEADER, ROW, BETWEEN, FOOTER, NAMES = 8.0, 0.62, 1.0, 0.24, 0.8, 0.5, 2.3
"""Inches of paper: page, margins, title, one row, the gap between panels, the foot, and the names of the rows."""
ROOM = 0.12
"""Part of a panel's range left free on either side."""

Row = tuple[str, float, str]
"""Of a panel: name, value in SI, and what stands beside its dot."""


@styled
def optimum_figure(answer: OptimumAnswer, reading: Reader) -> Figure:
    """Return the figure: a panel for every question that was answered."""
    panels = _panels(answer, reading)
    heights = [ROW * (len(rows) + 0.5) for _, _, rows, _ in panels]
    height = HEADER + sum(heights) + BETWEEN * (len(panels) - 1) + FOOTER
    figure = Figure(figsize=(WIDTH, height))
    title, size = fitted(f"The best way to hit: {answer.bat}", width=WIDTH - 2 * SIDE, size=HUGE)
    figure.text(SIDE / WIDTH, 1 - 0.42 / height, title, size=size, weight="bold", parse_math=False)
    top = HEADER
    for (title, scale, rows, colour), tall in zip(panels, heights, strict=True):
        axes = axes_in_inches(figure, left=SIDE + NAMES, top=top, width=WIDTH - 2 * SIDE - NAMES, height=tall)
        _draw(axes, rows, title, scale, colour, reading)
        top += tall + BETWEEN
    return figure


def _panels(answer: OptimumAnswer, reading: Reader) -> list[tuple[str, str, Sequence[Row], str]]:
    """Return title, scale, rows and colour of every panel."""
    as_text = reading.shown
    panels: list[tuple[str, str, Sequence[Row], str]] = []
    if answer.swings:
        swings = [
            (best.pitch, float(best.carry), f"attack {as_text(float(best.attack_angle), 'angle', digits=0)}")
            for best in answer.swings
        ]
        panels.append(("Farthest carry of each pitch", "distance", swings, BLUE))
    if answer.launches:
        launches = [
            (
                as_text(float(best.exit_speed), "speed", digits=0),
                float(best.carry),
                f"at {as_text(float(best.launch_angle), 'angle')}",
            )
            for best in answer.launches
        ]
        panels.append(("Farthest carry of each exit speed", "distance", launches, GREEN))
    if answer.parks:
        ordered = sorted((float(best.exit_speed), best.park) for best in answer.parks)
        parks = [(name, speed, as_text(speed, "speed")) for speed, name in ordered]
        panels.append(("Slowest home run of each park", "speed", parks, RED))
    return panels


def _draw(axes: Axes, rows: Sequence[Row], title: str, scale: str, colour: str, reading: Reader) -> None:
    values = [value / reading.units[scale].size for _, value, _ in rows]
    heading(axes, title, reading.unit(scale))
    axes.plot(values, range(len(rows)), "o", color=colour, markersize=5)
    for row, ((name, _, words), value) in enumerate(zip(rows, values, strict=True)):
        axes.annotate(
            words, (value, row), xytext=(7, 0), textcoords="offset points", va="center", size=SMALL, parse_math=False
        )
        axes.annotate(
            name, (0, row), xycoords=("axes fraction", "data"), xytext=(-8, 0), textcoords="offset points", ha="right",
            va="center", size=NORMAL, color=INK, parse_math=False,
        )  # fmt: skip
    room = ROOM * (max(values) - min(values)) or 0.05 * max(values)
    axes.set(xlim=(min(values) - room, max(values) + 2 * room), ylim=(len(rows) - 0.5, -0.5))
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    light_grid(axes)

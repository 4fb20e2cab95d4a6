"""The best way to hit in one picture: a row with a dot for every pitch, exit speed and park."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.answers.optimum import OptimumAnswer
from sweetspot.reports.pictures.panels import Page, Panel, beside, beside_row, frame, roomy, rows_only
from sweetspot.reports.pictures.style import NORMAL, SMALL, styled
from sweetspot.reports.quantities import BLUE, GREEN, RED, Reader

WIDTH, SIDE, HEADER, ROW, BETWEEN, FOOTER, NAMES = 8.0, 0.62, 1.0, 0.24, 0.8, 0.5, 2.3
"""Inches of paper: page, margins, title, one row, the gap between panels, the foot, and the names of the rows."""
ROOM = 0.12
"""Part of a panel's range left free on either side."""


class Rows(NamedTuple):
    """A panel: its title, the scale of its values, its rows (name, value in SI, words beside the dot), its colour."""

    title: str
    scale: str
    rows: Sequence[tuple[str, float, str]]
    colour: str


@styled
def optimum_figure(answer: OptimumAnswer, reading: Reader) -> Figure:
    """Return the figure: a panel for every question that was answered."""
    panels = _panels(answer, reading)
    heights = [ROW * (len(panel.rows) + 0.5) for panel in panels]
    page = Page(WIDTH, HEADER + sum(heights) + BETWEEN * (len(panels) - 1) + FOOTER, SIDE)
    page.title(f"The best way to hit: {answer.bat}")
    top = HEADER
    for panel, tall in zip(panels, heights, strict=True):
        _draw(page.panel(top, tall, left=SIDE + NAMES, width=page.across - NAMES), panel, reading)
        top += tall + BETWEEN
    return page.figure


def _panels(answer: OptimumAnswer, reading: Reader) -> list[Rows]:
    as_text = reading.shown
    swings = [
        (best.pitch, float(best.carry), f"attack {as_text(float(best.attack_angle), 'angle', digits=0)}")
        for best in answer.swings or ()
    ]
    launches = [
        (as_text(speed, "speed", digits=0), float(best.carry), f"at {as_text(float(best.launch_angle), 'angle')}")
        for best in answer.launches or ()
        for speed in [float(best.exit_speed)]
    ]
    ordered = sorted((float(best.exit_speed), best.park) for best in answer.parks or ())
    panels = (
        Rows("Farthest carry of each pitch", "distance", swings, BLUE),
        Rows("Farthest carry of each exit speed", "distance", launches, GREEN),
        Rows("Slowest home run of each park", "speed", [(name, v, as_text(v, "speed")) for v, name in ordered], RED),
    )
    return [panel for panel in panels if panel.rows]


def _draw(axes: Axes, panel: Rows, reading: Reader) -> None:
    values = [value / reading.units[panel.scale].size for _, value, _ in panel.rows]
    frame(axes, Panel(panel.title, reading.unit(panel.scale)))
    axes.plot(values, range(len(values)), "o", color=panel.colour, markersize=5)
    for row, ((name, _, words), value) in enumerate(zip(panel.rows, values, strict=True)):
        beside(axes, words, (value, row), (7, 0), va="center", size=SMALL, parse_math=False)
        beside_row(axes, row, name, va="center", size=NORMAL)
    limits = roomy(values, ROOM, 2 * ROOM, least=0.05 * max(values) / ROOM)
    axes.set(xlim=limits, ylim=(len(values) - 0.5, -0.5))
    rows_only(axes)

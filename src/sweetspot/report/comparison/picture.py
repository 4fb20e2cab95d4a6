"""One picture of several bats: the exit speed along each, tips aligned, with their sweet zones below."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.equipment.implement import Implement
from sweetspot.report.pictures import ruler
from sweetspot.report.pictures.conditions_line import told
from sweetspot.report.pictures.style import (
    HUGE,
    INK,
    MUTED,
    NORMAL,
    PAPER,
    SMALL,
    axes_in_inches,
    fitted,
    heading,
    light_grid,
    styled,
)
from sweetspot.report.quantities import BLUE, GREEN, ORANGE, PURPLE, RED, SKY

WIDTH, SIDE, HEADER, CURVES, ROW, BETWEEN, FOOTER = 8.0, 0.62, 1.05, 3.1, 0.27, 0.62, 0.85
"""Inches of paper: page, margins, title, curves, one bat's row of the zones, the gap, the foot."""
NAME_WIDTH = 2.3
"""Inches of paper for a bat's name in its row."""
COLOURS = (INK, RED, BLUE, GREEN, ORANGE, PURPLE, SKY)
DASHES: tuple[Any, ...] = ("solid", (0, (5, 1.5)), (0, (1.5, 1.2)))
"""The reference is drawn in ink; from the eighth bat on the colours come again, dashed."""


@styled
def compare_figure(comparison: Comparison[Implement]) -> Figure:
    """Return the figure: curves of exit speed above, a row with zone, best place and speed for every bat below."""
    compared = comparison.compared
    length = max(found.analysis.bat.length for found in compared)
    rows = ROW * (len(compared) + 0.4)
    height = HEADER + CURVES + BETWEEN + rows + FOOTER
    figure = Figure(figsize=(WIDTH, height))
    across = WIDTH - 2 * SIDE
    _header(figure, comparison, height)
    curves = axes_in_inches(figure, left=SIDE, top=HEADER, width=across, height=CURVES)
    zones = axes_in_inches(figure, left=SIDE, top=HEADER + CURVES + BETWEEN, width=across, height=rows)
    for axes in (curves, zones):
        ruler.set_limits(axes, length)
    _curves(curves, compared, length)
    _zones(zones, compared, length)
    words = "Boxes: sweet zones. Dots: best places. Change: against the first bat. Free bats, hit straight on."
    figure.text(SIDE / WIDTH, 0.12 / height, words, color=MUTED, size=SMALL)
    return figure


def _header(figure: Figure, comparison: Comparison[Implement], height: float) -> None:
    conditions, law = comparison.reference.analysis.conditions, comparison.law
    telling = told(comparison.reference.analysis.bat)
    left, tool = SIDE / WIDTH, telling.words.implement
    number = len(comparison.compared)
    title = f"One {tool}" if number == 1 else f"{number} {tool}s, one player"
    figure.text(left, 1 - 0.42 / height, title, size=HUGE, weight="bold")
    effort = f"all at the same {tool} speed" if law is None else f"same effort by the law of {law.name}"
    arriving = (
        f"{telling.speed(conditions.pitch.speed, digits=0)} {telling.words.incoming}"
        if conditions.pitch.speed
        else telling.coming(0.0)
    )
    first = (
        f"{arriving}; {telling.speed(conditions.swing.bat_speed, digits=0)} of {tool} speed with the first {tool}, "
        f"{effort}"
    )
    figure.text(left, 1 - 0.66 / height, first, color=MUTED, size=NORMAL, parse_math=False)


def _curves(axes: Axes, compared: tuple[Compared[Implement], ...], length: float) -> None:
    telling = told(compared[0].analysis.bat)
    size = telling.speed_size
    ruler.show_from_tip(axes, length, telling, labels=False)
    axes.yaxis.set_major_locator(MaxNLocator(nbins=6))
    light_grid(axes)
    heading(axes, "Exit speed", f"how fast the ball leaves, {telling.words.speed_unit}")
    tops, lows = [], []
    for number, found in reversed(list(enumerate(compared))):  # the reference last, on top
        scan = found.analysis.scan
        places = scan.position + length - found.analysis.bat.length
        speed = scan.exit_speed / size
        colour, dash = _look(number)
        axes.plot(places, speed, color=colour, linestyle=dash, linewidth=1.5)
        axes.plot(_best(found, length), found.exit_speed.value / size, "o", color=colour, markersize=5,
                  markeredgecolor=PAPER, markeredgewidth=0.8, zorder=5)  # fmt: skip
        tops.append(float(np.nanmax(speed)))
        lows.append(float(np.nanmin(speed)))
    axes.set_ylim(min(0.0, *lows), 1.08 * max(tops))


def _zones(axes: Axes, compared: tuple[Compared[Implement], ...], length: float) -> None:
    """Draw a row per bat: name, sweet zone on the common axis, exit speed, and the change with its interval."""
    telling = told(compared[0].analysis.bat)
    ruler.show_from_tip(axes, length, telling)
    axes.set_xlabel(f"{telling.place_long} from the {telling.words.tip}", labelpad=2)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    axes.set_ylim(-len(compared) + 0.3, 0.7)
    heading(axes, "Sweet zones", "fast and quiet; with the exit speed at the best place, and the change")
    edge = axes.get_xlim()[0]
    for number, found in enumerate(compared):
        colour, dash = _look(number)
        zone, best = found.analysis.sweet_spots.zone, _best(found, length)
        if zone is not None:
            start = zone[0] + length - found.analysis.bat.length
            axes.add_patch(
                Rectangle((start, -number - 0.3), zone[1] - zone[0], 0.6, facecolor=colour, alpha=0.22, linewidth=0,
                          gid="zone")
            )  # fmt: skip
        axes.plot(best, -number, "o", color=colour, markersize=5, markeredgecolor=PAPER, markeredgewidth=0.8, zorder=5)
        axes.plot([edge, edge + 0.025 * length], [-number, -number], color=colour, linestyle=dash, linewidth=2)
        name, size = fitted(found.label, width=NAME_WIDTH, size=NORMAL, smallest=SMALL)
        look: dict[str, Any] = {"va": "center_baseline", "color": INK, "size": size, "parse_math": False}
        axes.text(edge + 0.035 * length, -number, name, ha="left", **look)
        words = telling.speed(found.exit_speed.value)
        words += "" if number == 0 else f"  {_change(found, telling.speed_size)}"
        left = edge + 0.66 * (axes.get_xlim()[1] - edge)
        axes.text(left, -number, words, ha="right", va="center_baseline", color=INK, size=SMALL, parse_math=False)


def _change(found: Compared[Implement], size: float) -> str:
    change = found.change
    text = f"{change.value / size:+.1f}"
    return text if change.low == change.high else f"{text} ({change.low / size:+.1f} to {change.high / size:+.1f})"


def _look(number: int) -> tuple[str, Any]:
    return COLOURS[number % len(COLOURS)], DASHES[min(number // len(COLOURS), len(DASHES) - 1)]


def _best(found: Compared[Implement], length: float) -> float:
    """Return the best place in m on the common axis, on which all tips lie at ``length``."""
    return found.analysis.sweet_spots.max_exit_speed + length - found.analysis.bat.length

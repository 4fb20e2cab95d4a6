"""One picture of a player: what the place of contact is worth, what single changes bring, and the bats tried."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.motion.swing_law import Interval
from sweetspot.player.advice import PLACES, Advice
from sweetspot.player.posterior import Posterior
from sweetspot.player.prior import NAMES
from sweetspot.report.pictures.style import (
    HUGE,
    INK,
    MUTED,
    NORMAL,
    SMALL,
    axes_in_inches,
    fitted,
    heading,
    light_grid,
    styled,
)
from sweetspot.report.player.goals import GOALS, goal_words
from sweetspot.report.player.tried_bats import option_words
from sweetspot.report.player.words import changes
from sweetspot.report.quantities import BLUE, GREEN, RED, SKY, US, Reader, Unit
from sweetspot.report.sentences import Slot, say, within

WIDTH, SIDE, HEADER, CURVE, BETWEEN, ROW, FOOTER, NAMES_WIDTH = 8.0, 0.62, 1.05, 2.3, 0.75, 0.23, 0.7, 2.5
"""Inches of paper: page, margins, title, curve, gap, one row, the foot, and the names of the rows."""
NOTHING = 0.05
"""Of the unit shown; a smaller change is drawn as none."""


@styled
def player_figure(posterior: Posterior, advice: Advice, *, player: str = "", reading: Reader = US) -> Figure:
    """Return the figure: expected goal against contact point, worth of single changes, bats tried."""
    worth = [(words.read(reading), advice.worth[key].gain) for key, words in changes().items()]
    bats = [(option_words(option.candidate).read(reading), option.change) for option in advice.options]
    rows = len(worth), len(bats)
    height = HEADER + CURVE + 2 * BETWEEN + ROW * (sum(rows) + 1) + FOOTER
    figure = Figure(figsize=(WIDTH, height))
    _header(figure, posterior, advice, height, player, reading)
    across = WIDTH - 2 * SIDE
    _contact(axes_in_inches(figure, left=SIDE, top=HEADER, width=across, height=CURVE), posterior, advice, reading)
    top = HEADER + CURVE + BETWEEN
    left, width = SIDE + NAMES_WIDTH, across - NAMES_WIDTH
    axes = axes_in_inches(figure, left=left, top=top, width=width, height=ROW * (rows[0] + 0.5))
    unit = _unit(advice, reading)
    _rows(axes, worth, unit, f"What a change of the player is worth, {unit.name}")
    axes = axes_in_inches(figure, left=left, top=top + BETWEEN + ROW * (rows[0] + 0.5), width=width,
                          height=ROW * (rows[1] + 0.5))  # fmt: skip
    _rows(axes, bats, unit, f"What another bat is worth, {unit.name}")
    words = (
        "Curve: band and ticks are what the swings allow for the mean contact; its scale does not begin at 0.\n"
        "Dots and lines: most likely value and 95 % interval. Green: a gain; orange: a loss; grey: cannot tell."
    )
    figure.text(SIDE / WIDTH, 0.12 / height, words, color=MUTED, size=SMALL)
    return figure


def _unit(advice: Advice, reading: Reader) -> Unit:
    scale, digits = GOALS[advice.goal.name]
    unit = reading.units[scale]
    return replace(unit, digits=unit.digits if digits is None else digits)


def _header(figure: Figure, posterior: Posterior, advice: Advice, height: float, player: str, reading: Reader) -> None:
    left, learned = SIDE / WIDTH, posterior.learned
    title = f"Training report: {player}" if player else "Training report"
    words, size = fitted(title, width=WIDTH - 2 * SIDE, size=HUGE)
    figure.text(left, 1 - 0.42 / height, words, size=size, weight="bold", parse_math=False)
    line = say(
        "{count} swings, {bat}: bat speed {speed}, pitch {pitch} at the plate", count=len(posterior.model.swings),
        bat=posterior.model.bats[0].bat.name, speed=within(learned["bat_speed"].interval, "speed"),
        pitch=Slot(advice.pitch_speed, "speed", 0),
    )  # fmt: skip
    words, size = fitted(line.read(reading), width=WIDTH - 2 * SIDE, size=NORMAL, smallest=6.0)
    figure.text(left, 1 - 0.66 / height, words, color=MUTED, size=size, parse_math=False)


def _contact(axes: Axes, posterior: Posterior, advice: Advice, reading: Reader) -> None:
    """Draw the expected goal against the mean contact point, and where the player meets the ball now."""
    unit, inch = _unit(advice, reading), reading.units["place"].size
    heading(
        axes, f"Expected {goal_words(advice.goal).read(reading)}, {unit.name}",
        "against where the ball is met on average, with this scatter",
    )  # fmt: skip
    axes.plot(PLACES / inch, advice.contact_curve / unit.size, color=BLUE)
    now, best = posterior.learned["position"].interval, advice.contact_point
    bottom, top = axes.get_ylim()
    axes.axvspan(now.low / inch, now.high / inch, color=SKY, alpha=0.25, linewidth=0)
    axes.axvline(now.value / inch, color=BLUE, linewidth=0.8)
    axes.axvline(best.value / inch, color=RED, linewidth=0.8)
    between = (now.value + best.value) / 2  # labels on the outer sides: the axis runs down to the tip
    low, high = bottom + 0.12 * (top - bottom), bottom + 0.22 * (top - bottom)
    for place, height, words, colour in ((now.value, low, "now", BLUE), (best.value, high, "best", RED)):
        axes.annotate(
            words, (place / inch, height), xytext=(-4 if place >= between else 4, 0), textcoords="offset points",
            color=colour, ha="right" if place >= between else "left", va="bottom", size=SMALL,
        )  # fmt: skip
    rug = posterior.draws[:: max(1, len(posterior.draws) // 400), NAMES.index("position")] / inch
    axes.plot(rug, np.full_like(rug, bottom), "|", color=BLUE, alpha=0.25, markersize=7)
    axes.set_xlim(PLACES[-1] / inch, PLACES[0] / inch)
    axes.set_ylim(bottom, top)
    axes.set_xlabel(f"{reading.unit('place')} from the tip")
    light_grid(axes)


def _rows(axes: Axes, bars: list[tuple[str, Interval]], unit: Unit, title: str) -> None:
    """Draw a row with dot and interval for every change."""
    size = unit.size
    heading(axes, title)
    for row, (words, gain) in enumerate(bars):
        colour = GREEN if gain.low > NOTHING * size else RED if gain.high < -NOTHING * size else MUTED
        axes.plot([gain.low / size, gain.high / size], [row, row], color=colour, linewidth=1.6)
        axes.plot(gain.value / size, row, "o", color=colour, markersize=4)
        where: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points", "va": "center"}
        axes.annotate(words, (0, row), xytext=(-180, 0), ha="left", size=SMALL, color=INK, parse_math=False, **where)
        axes.annotate(unit.number(gain.value, sign=True), (0, row), xytext=(-12, 0), ha="right", weight="bold", **where)
    axes.axvline(0, color=MUTED, linewidth=0.7)
    axes.set_ylim(len(bars) - 0.5, -0.5)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    light_grid(axes, vertical=True)

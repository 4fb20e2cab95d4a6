"""One picture of a player: what the place of contact is worth, what single changes bring, and the bats tried."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.numerics.interval import Interval, sure_sign
from sweetspot.player.advice import PLACES, Advice
from sweetspot.player.prior import NAMES
from sweetspot.reports.pictures.style import (
    HUGE,
    INK,
    MUTED,
    NORMAL,
    SHEET,
    SMALL,
    axes_in_inches,
    fitted,
    heading,
    light_grid,
    styled,
)
from sweetspot.reports.player.phrases import GOALS, goal_words, option_words, pitch_words
from sweetspot.reports.player.words import changes
from sweetspot.reports.quantities import BLUE, GREEN, RED, SKY, US, Reader, Unit
from sweetspot.reports.sentences import say, within


@dataclass(frozen=True)
class Paper:
    """Inches of paper: page, margins, title, curve, gap, one row, the foot, the rows' names and the numbers behind."""

    width: float = 9.8
    side: float = 0.5
    header: float = 1.02
    curve: float = 2.0
    between: float = 0.8
    row: float = 0.225
    footer: float = 0.68
    names: float = 2.2
    figures: float = 0.66
    letters: float = NORMAL

    @property
    def column(self) -> float:
        """Inches of either of the two columns."""
        return (self.width - 3 * self.side) / 2


ALONE = Paper()
ON_A_SHEET = Paper(SHEET, 0.34, 0.22, 0.8, 0.56, 0.13, 0.56, 1.84, 0.4, 7.2)
"""Whose page says whom it is for."""
SURE = {1: GREEN, -1: RED, 0: MUTED}
"""Colours of a gain, a loss and an undecided change."""
LIGHTER = 1.06
"""How much wider bold letters are than the rows' names."""


@styled
def player_figure(
    advice: Advice,
    *,
    player: str = "",
    day: str = "",
    reading: Reader = US,
    paper: Paper = ALONE,
) -> Figure:
    """Return the figure: expected goal against contact point, worth of single changes, bats tried."""
    worth = [
        (words.read(reading), gain, sure_sign(gain.low, gain.high, nothing=advice.goal.nothing))
        for words, gain in ((words, advice.worth[key].gain) for key, words in changes().items())
    ]
    bats = [
        (option_words(option.candidate).read(reading), option.change, advice.sign_of(option))
        for option in advice.options
    ]
    deep = [paper.row * (len(rows) + 0.5) for rows in (worth, bats)]
    top, side, column, named = paper.header, paper.side, paper.column, paper.names + paper.figures
    below = top + paper.curve + paper.between
    height = max(below + deep[0], top + deep[1]) + paper.footer
    figure = Figure(figsize=(paper.width, height))
    if paper is ALONE:
        _header(figure, advice, height, reading, player=player, day=day)
    axes = axes_in_inches(figure, left=side, top=top, width=column, height=paper.curve)
    _contact(axes, advice, reading, note="by where the ball is met on average" if paper is ALONE else "")
    unit = _unit(advice, reading)
    for rows, left, start, size, words in (
        (worth, side, below, deep[0], "What a change of the player is worth"),
        (bats, 2 * side + column, top, deep[1], "What another bat is worth"),
    ):
        axes = axes_in_inches(figure, left=left + named, top=start, width=column - named, height=size)
        _rows(axes, rows, unit, f"{words}, {unit.name}", paper)
    words = (
        "Curve: band and ticks are what the swings allow for the mean contact; its scale does not begin at 0.\n"
        "Dots and lines: most likely value and 90 % interval. Green: a gain; orange: a loss; grey: cannot tell."
    )
    figure.text(side / paper.width, (0.12 if paper is ALONE else 0.05) / height, words, color=MUTED, size=SMALL)
    return figure


def _unit(advice: Advice, reading: Reader) -> Unit:
    scale, digits = GOALS[advice.goal.name]
    unit = reading.units[scale]
    return replace(unit, digits=unit.digits if digits is None else digits)


def _header(figure: Figure, advice: Advice, height: float, reading: Reader, *, player: str, day: str) -> None:
    left, room, posterior = ALONE.side / ALONE.width, ALONE.width - 2 * ALONE.side, advice.posterior
    title = f"Training report: {player}" if player else "Training report"
    words, size = fitted(title, width=room, size=HUGE)
    figure.text(left, 1 - 0.42 / height, words, size=size, weight="bold", parse_math=False)
    line = say(
        "{day}{count} swings, {bat}: bat speed {speed}, {pitch}",
        day=f"{day}: " if day else "",
        count=len(posterior.model.swings),
        bat=posterior.model.bats[0].bat.name,
        speed=within(posterior.learned["bat_speed"].interval, "speed"),
        pitch=pitch_words(advice.pitch_speed),
    )
    words, size = fitted(line.read(reading), width=room, size=NORMAL, smallest=6.0)
    figure.text(left, 1 - 0.66 / height, words, color=MUTED, size=size, parse_math=False)


def _contact(axes: Axes, advice: Advice, reading: Reader, *, note: str) -> None:
    """Draw the expected goal against the mean contact point, and where the player meets the ball now."""
    unit, inch, posterior = _unit(advice, reading), reading.units["place"].size, advice.posterior
    heading(axes, f"Expected {goal_words(advice.goal).read(reading)}, {unit.name}", note)
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
            words,
            (place / inch, height),
            xytext=(-4 if place >= between else 4, 0),
            textcoords="offset points",
            color=colour,
            ha="right" if place >= between else "left",
            va="bottom",
            size=SMALL,
        )
    rug = posterior.draws[:: max(1, len(posterior.draws) // 400), NAMES.index("position")] / inch
    axes.plot(rug, np.full_like(rug, bottom), "|", color=BLUE, alpha=0.25, markersize=7)
    axes.set_xlim(PLACES[-1] / inch, PLACES[0] / inch)
    axes.set_ylim(bottom, top)
    axes.set_xlabel(f"{reading.unit('place')} from the tip")
    light_grid(axes)


def _rows(axes: Axes, bars: list[tuple[str, Interval, int]], unit: Unit, title: str, paper: Paper) -> None:
    """Draw a row with dot and interval for every change, coloured by its sign where that is sure."""
    size = unit.size
    start = -72 * (paper.names + paper.figures)
    axes.annotate(
        title,
        (0, 1),
        xycoords="axes fraction",
        xytext=(start, 5),
        textcoords="offset points",
        weight="bold",
        va="baseline",
    )
    for row, (words, gain, sign) in enumerate(bars):
        colour = SURE[sign]
        axes.plot([gain.low / size, gain.high / size], [row, row], color=colour, linewidth=1.6)
        axes.plot(gain.value / size, row, "o", color=colour, markersize=4)
        where: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points", "va": "center"}
        named, letters = fitted(words, width=LIGHTER * paper.names, size=paper.letters, smallest=6.8)
        axes.annotate(named, (0, row), xytext=(start, 0), ha="left", size=letters, color=INK, parse_math=False, **where)
        axes.annotate(
            unit.number(gain.value, sign=True),
            (0, row),
            xytext=(-12, 0),
            ha="right",
            weight="bold",
            size=paper.letters,
            **where,
        )
    axes.axvline(0, color=MUTED, linewidth=0.7)
    axes.set_ylim(len(bars) - 0.5, -0.5)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    light_grid(axes, vertical=True)

"""One picture of a player: what the place of contact is worth, what single changes bring, and the bats tried."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.numerics.interval import Interval, sure_sign
from sweetspot.player.advice import PLACES, Advice
from sweetspot.player.prior import NAMES
from sweetspot.reports.pictures.panels import Page, Panel, beside, beside_row, frame, rows_only
from sweetspot.reports.pictures.style import MUTED, NORMAL, SHEET, SMALL, fitted, styled
from sweetspot.reports.player.phrases import GOALS, changes, goal_words, option_words, pitch_words
from sweetspot.reports.quantities import BLUE, GREEN, RED, SKY, US, Reader, Unit
from sweetspot.reports.sentences import say


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
    advice: Advice, *, player: str = "", day: str = "", reading: Reader = US, paper: Paper = ALONE
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
    page, unit = Page(paper.width, height, side), _unit(advice, reading)
    if paper is ALONE:
        _header(page, advice, reading, player=player, day=day)
    axes = page.panel(top, paper.curve, width=column)
    _contact(axes, advice, reading, note="by where the ball is met on average" if paper is ALONE else "")
    for rows, left, start, size, words in (
        (worth, side, below, deep[0], "What a change of the player is worth"),
        (bats, 2 * side + column, top, deep[1], "What another bat is worth"),
    ):
        axes = page.panel(start, size, left=left + named, width=column - named)
        _rows(axes, rows, unit, f"{words}, {unit.name}", paper)
    words = (
        "Curve: band and ticks are what the swings allow for the mean contact; its scale does not begin at 0.\n"
        "Dots and lines: most likely value and 90 % interval. Green: a gain; orange: a loss; grey: cannot tell."
    )
    page.foot(words, 0.12 if paper is ALONE else 0.05)
    return page.figure


def player_sheet(advice: Advice, reading: Reader = US) -> Figure:
    """Return the figure for a printed sheet, whose page says whom it is for."""
    return player_figure(advice, reading=reading, paper=ON_A_SHEET)


def _unit(advice: Advice, reading: Reader) -> Unit:
    scale, digits = GOALS[advice.goal.name]
    unit = reading.units[scale]
    return replace(unit, digits=unit.digits if digits is None else digits)


def _header(page: Page, advice: Advice, reading: Reader, *, player: str, day: str) -> None:
    posterior = advice.posterior
    page.title(f"Training report: {player}" if player else "Training report")
    line = say(
        "{day}{count} swings, {bat}: bat speed {speed:speed, ends}, {pitch}",
        day=f"{day}: " if day else "",
        count=len(posterior.model.swings),
        bat=posterior.model.bats[0].bat.name,
        speed=posterior.learned["bat_speed"].interval,
        pitch=pitch_words(advice.pitch_speed),
    )
    words, size = fitted(line.read(reading), width=page.across, size=NORMAL, smallest=6.0)
    page.write(words, 0.66, color=MUTED, size=size)


def _contact(axes: Axes, advice: Advice, reading: Reader, *, note: str) -> None:
    """Draw the expected goal against the mean contact point, and where the player meets the ball now."""
    unit, inch, posterior = _unit(advice, reading), reading.units["place"].size, advice.posterior
    title = f"Expected {goal_words(advice.goal).read(reading)}, {unit.name}"
    frame(axes, Panel(title, note, x=f"{reading.unit('place')} from the tip"))
    axes.plot(PLACES / inch, advice.contact_curve / unit.size, color=BLUE)
    now, best = posterior.learned["position"].interval, advice.contact_point
    bottom, top = axes.get_ylim()
    axes.axvspan(now.low / inch, now.high / inch, color=SKY, alpha=0.25, linewidth=0)
    axes.axvline(now.value / inch, color=BLUE, linewidth=0.8)
    axes.axvline(best.value / inch, color=RED, linewidth=0.8)
    between = (now.value + best.value) / 2  # labels on the outer sides: the axis runs down to the tip
    low, high = bottom + 0.12 * (top - bottom), bottom + 0.22 * (top - bottom)
    for place, height, words, colour in ((now.value, low, "now", BLUE), (best.value, high, "best", RED)):
        aside, side = (-4, "right") if place >= between else (4, "left")
        beside(axes, words, (place / inch, height), (aside, 0), color=colour, ha=side, va="bottom", size=SMALL)
    rug = posterior.draws[:: max(1, len(posterior.draws) // 400), NAMES.index("position")] / inch
    axes.plot(rug, np.full_like(rug, bottom), "|", color=BLUE, alpha=0.25, markersize=7)
    axes.set(xlim=(PLACES[-1] / inch, PLACES[0] / inch), ylim=(bottom, top))


def _rows(axes: Axes, bars: list[tuple[str, Interval, int]], unit: Unit, title: str, paper: Paper) -> None:
    """Draw a row with dot and interval for every change, coloured by its sign where that is sure."""
    size, start = unit.size, 72 * (paper.names + paper.figures)
    beside(axes, title, (0, 1), (-start, 5), xycoords="axes fraction", weight="bold", va="baseline")
    frame(axes, Panel(""))
    for row, (words, gain, sign) in enumerate(bars):
        colour = SURE[sign]
        axes.plot([gain.low / size, gain.high / size], [row, row], color=colour, linewidth=1.6)
        axes.plot(gain.value / size, row, "o", color=colour, markersize=4)
        named, letters = fitted(words, width=LIGHTER * paper.names, size=paper.letters, smallest=6.8)
        beside_row(axes, row, named, start, ha="left", va="center", size=letters)
        number = unit.number(gain.value, sign=True)
        beside_row(axes, row, number, 12, va="center", weight="bold", size=paper.letters)
    axes.axvline(0, color=MUTED, linewidth=0.7)
    axes.set_ylim(len(bars) - 0.5, -0.5)
    rows_only(axes)

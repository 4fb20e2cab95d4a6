"""One picture of a player: contacts on the barrel, speeds, what changes and bats bring, and the swing itself."""

from __future__ import annotations

from dataclasses import dataclass, replace

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.numerics.interval import Interval, sure_sign
from sweetspot.player.advice import Advice
from sweetspot.reports.pictures.panels import Page, Panel, beside, beside_row, frame, rows_only
from sweetspot.reports.pictures.style import MUTED, NORMAL, SHEET, fitted, styled
from sweetspot.reports.player.phrases import GOALS, changes, option_words, pitch_words
from sweetspot.reports.player.swing_picture import draw_behind, draw_contacts, draw_side, draw_speeds
from sweetspot.reports.quantities import GREEN, RED, US, Reader, Unit
from sweetspot.reports.sentences import say


@dataclass(frozen=True)
class Paper:
    """Inches of paper, from the top down, and of a row's parts; ``captions``: of the words below the drawings."""

    width: float = 9.8
    side: float = 0.5
    header: float = 1.02
    maps: float = 2.1
    between: float = 0.8
    row: float = 0.225
    drawing: float = 1.1
    captions: float = 0.35
    footer: float = 0.8
    names: float = 2.2
    figures: float = 0.66
    letters: float = NORMAL

    @property
    def column(self) -> float:
        """Inches of either of the two columns."""
        return (self.width - 3 * self.side) / 2


ALONE = Paper()
ON_A_SHEET = Paper(SHEET, 0.34, 0.22, 1.05, 0.56, 0.13, 0.6, 0.3, 0.56, 1.78, 0.52, 7.2)
"""Whose page says whom it is for."""
SURE = {1: GREEN, -1: RED, 0: MUTED}
"""Colours of a gain, a loss and an undecided change."""
LIGHTER = 1.06
"""How much wider bold letters are than the rows' names."""


@styled
def player_figure(
    advice: Advice, *, player: str = "", day: str = "", reading: Reader = US, paper: Paper = ALONE
) -> Figure:
    """Return the figure: contacts and speeds, worth of changes and bats, and the swing from the side and behind."""
    worth = [
        (
            changes()[change.key].read(reading),
            change.gain,
            sure_sign(change.gain.low, change.gain.high, nothing=advice.goal.nothing),
        )
        for change in advice.ranked_worth
    ]
    bats = [
        (option_words(option.candidate).read(reading), option.change, advice.sign_of(option))
        for option in advice.options
    ]
    deep = [paper.row * (len(rows) + 0.5) for rows in (worth, bats)]
    top, side, column, named = paper.header, paper.side, paper.column, paper.names + paper.figures
    right = 2 * side + column
    below = top + paper.maps + paper.between
    last = below + deep[0] + paper.between
    height = max(below + deep[1], last + paper.drawing + paper.captions) + paper.footer
    page, unit = Page(paper.width, height, side), _unit(advice, reading)
    if paper is ALONE:
        _header(page, advice, reading, player=player, day=day)
    step = draw_contacts(page.panel(top, paper.maps, width=column), advice, reading)
    draw_speeds(page.panel(top, paper.maps, left=right, width=column), advice, reading)
    for rows, left, size, words in (
        (worth, side, deep[0], "What a change of the player is worth"),
        (bats, right, deep[1], "What another bat is worth"),
    ):
        axes = page.panel(below, size, left=left + named, width=column - named)
        _rows(axes, rows, unit, f"{words}, {unit.name}", paper)
    half = (column - side) / 2
    draw_side(page.panel(last, paper.drawing, width=half), advice, reading)
    draw_behind(page.panel(last, paper.drawing, left=2 * side + half, width=half), advice, reading)
    words = (
        f"Contacts: shades of {step}; grey: the barrel; dots: where the swings allow contact; red: best mean.\n"
        "Speeds: the line is the most that the own bat allows; orange dots are other bats.\n"
        "Rows: most likely value and 90 % interval. Green: a gain; orange: a loss; grey: cannot tell."
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

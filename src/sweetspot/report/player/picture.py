"""One picture of a player: what the place of contact is worth, what single changes bring, and the bats tried."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from sweetspot.motion.swing_law import Interval
from sweetspot.player.advice import PLACES, Advice
from sweetspot.player.goal import told
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
from sweetspot.report.player.units import scale
from sweetspot.report.quantities import BLUE, GREEN, RED, SKY
from sweetspot.units import INCH, MPH

WIDTH, SIDE, HEADER, CURVE, BETWEEN, ROW, FOOTER, NAMES_WIDTH = 8.0, 0.62, 1.05, 2.3, 0.75, 0.23, 0.7, 2.5
"""Inches of paper: page, margins, title, curve, gap, one row, the foot, and the names of the rows."""
NOTHING = 0.05
"""Of the unit shown; a smaller change is drawn as none."""
WORTH = {
    "bat_speed": "1 mph more bat speed",
    "position_spread": "1 in less scatter along the bat",
    "offset_spread": "1/4 in less scatter over and under",
    "towards_tip": "contact 1 in nearer the tip",
    "towards_hands": "contact 1 in nearer the hands",
}
"""Changes shown, by key of `Advice.worth`."""


@styled
def player_figure(posterior: Posterior, advice: Advice) -> Figure:
    """Return the figure: expected goal against contact point, worth of single changes, bats tried."""
    rows = len(WORTH), len(advice.options)
    height = HEADER + CURVE + 2 * BETWEEN + ROW * (sum(rows) + 1) + FOOTER
    figure = Figure(figsize=(WIDTH, height))
    _header(figure, posterior, advice, height)
    across = WIDTH - 2 * SIDE
    _contact(axes_in_inches(figure, left=SIDE, top=HEADER, width=across, height=CURVE), posterior, advice)
    top = HEADER + CURVE + BETWEEN
    left, width = SIDE + NAMES_WIDTH, across - NAMES_WIDTH
    axes = axes_in_inches(figure, left=left, top=top, width=width, height=ROW * (rows[0] + 0.5))
    unit = scale(advice.goal)
    bars = [(words, advice.worth[key].gain) for key, words in WORTH.items()]
    _rows(axes, bars, unit, f"What a change of the player is worth, {unit[2]}")
    axes = axes_in_inches(figure, left=left, top=top + BETWEEN + ROW * (rows[0] + 0.5), width=width,
                          height=ROW * (rows[1] + 0.5))  # fmt: skip
    bars = [(option.candidate.label, option.change) for option in advice.options]
    _rows(axes, bars, unit, f"What another bat is worth, {unit[2]}")
    words = "Dots and lines: most likely value and 95 % interval. Green: a gain; red: a loss; grey: cannot tell."
    figure.text(SIDE / WIDTH, 0.12 / height, words, color=MUTED, size=SMALL)
    return figure


def _header(figure: Figure, posterior: Posterior, advice: Advice, height: float) -> None:
    left = SIDE / WIDTH
    count, own = len(posterior.model.swings), posterior.model.bats[0].bat.name
    speed = posterior.learned["bat_speed"].interval
    figure.text(left, 1 - 0.42 / height, "Training report", size=HUGE, weight="bold")
    line = (
        f"{count} swings, {own}: bat speed {speed.value / MPH:.1f} mph ({speed.low / MPH:.1f} to "
        f"{speed.high / MPH:.1f}), pitch {advice.pitch_speed / MPH:.0f} mph at the plate"
    )
    words, size = fitted(line, width=WIDTH - 2 * SIDE, size=NORMAL, smallest=6.0)
    figure.text(left, 1 - 0.66 / height, words, color=MUTED, size=size, parse_math=False)


def _contact(axes: Axes, posterior: Posterior, advice: Advice) -> None:
    """Draw the expected goal against the mean contact point, and where the player meets the ball now."""
    size, _, name = scale(advice.goal)
    heading(
        axes, f"Expected {told(advice.goal)}, {name}", "against where the ball is met on average, with this scatter"
    )
    axes.plot(PLACES / INCH, advice.contact_curve / size, color=BLUE)
    now, best = posterior.learned["position"].interval, advice.contact_point
    bottom, top = axes.get_ylim()
    axes.axvspan(now.low / INCH, now.high / INCH, color=SKY, alpha=0.25, linewidth=0)
    axes.axvline(now.value / INCH, color=BLUE, linewidth=0.8)
    axes.axvline(best.value / INCH, color=RED, linewidth=0.8)
    low, high = bottom + 0.12 * (top - bottom), bottom + 0.22 * (top - bottom)
    for place, height, words, colour in ((now.value, low, "now", BLUE), (best.value, high, "best", RED)):
        axes.text(place / INCH - 0.06, height, words, color=colour, ha="left", va="bottom", size=SMALL)
    rug = posterior.draws[:: max(1, len(posterior.draws) // 400), NAMES.index("position")] / INCH
    axes.plot(rug, np.full_like(rug, bottom), "|", color=BLUE, alpha=0.25, markersize=7)
    axes.set_xlim(PLACES[-1] / INCH, PLACES[0] / INCH)
    axes.set_ylim(bottom, top)
    axes.set_xlabel("inches from the tip")
    light_grid(axes)


def _rows(axes: Axes, bars: list[tuple[str, Interval]], unit: tuple[float, int, str], title: str) -> None:
    """Draw a row with dot and interval for every change."""
    size, digits, _ = unit
    heading(axes, title)
    for row, (words, gain) in enumerate(bars):
        colour = GREEN if gain.low > NOTHING * size else RED if gain.high < -NOTHING * size else MUTED
        axes.plot([gain.low / size, gain.high / size], [row, row], color=colour, linewidth=1.6)
        axes.plot(gain.value / size, row, "o", color=colour, markersize=4)
        where: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points", "va": "center"}
        axes.annotate(words, (0, row), xytext=(-180, 0), ha="left", size=SMALL, color=INK, parse_math=False, **where)
        axes.annotate(
            f"{gain.value / size:+z.{digits}f}", (0, row), xytext=(-12, 0), ha="right", weight="bold", **where
        )
    axes.axvline(0, color=MUTED, linewidth=0.7)
    axes.set_ylim(len(bars) - 0.5, -0.5)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    light_grid(axes, vertical=True)

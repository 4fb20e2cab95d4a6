"""One play on one page: the contact, the path from the side and from above, the fence."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence

from matplotlib.figure import Figure

from sweetspot.ball import Ball
from sweetspot.motion import BallMotion
from sweetspot.park import Park
from sweetspot.play import Play
from sweetspot.plot.contact import draw_contact
from sweetspot.plot.flight import draw_above, draw_side
from sweetspot.plot.style import NORMAL, styled
from sweetspot.swing_path import SwingPath

LINE = 118
"""Letters in a line of the words below."""


@styled
def play_figure(
    play: Play,
    *,
    ball: Ball,
    bat_radius: float,
    offset: float,
    path: SwingPath,
    pitch: BallMotion,
    park: Park | None = None,
    words: Sequence[str] = (),
) -> Figure:
    """Return the picture of a play; a miss has no flight to draw.

    Parameters
    ----------
    bat_radius, offset : m, where they meet.
    words : sentences for the foot of the page.
    """
    figure = Figure(figsize=(9.0, 7.4), layout="constrained")
    grid = figure.add_gridspec(3, 2, height_ratios=(2.3, 1.25, 0.4), width_ratios=(1, 1.15))
    contact = figure.add_subplot(grid[0, 0])
    draw_contact(contact, play.strike, ball=ball, bat_radius=bat_radius, offset=offset, path=path, pitch=pitch)
    if play.flight is not None:
        draw_above(figure.add_subplot(grid[0, 1]), play.flight, park)
        draw_side(figure.add_subplot(grid[1, :]), play.flight, park)
    foot = figure.add_subplot(grid[2, :])
    foot.set_axis_off()
    foot.text(0, 1, textwrap.fill(" ".join(words), LINE), va="top", size=NORMAL, transform=foot.transAxes)
    return figure

"""One play on one page: the contact, the path from the side and from above, the fence."""

from __future__ import annotations

import textwrap

from matplotlib.figure import Figure

from sweetspot.answers.play import PlayAnswer
from sweetspot.report.flight.picture import draw_above, draw_side
from sweetspot.report.pictures.style import LARGE, NORMAL, styled
from sweetspot.report.play.contact_picture import draw_contact
from sweetspot.report.quantities import US, Reader
from sweetspot.report.sentences import Sentence

LINE = 118
"""Letters in a line of the words below."""


@styled
def play_figure(answer: PlayAnswer, words: Sentence, reading: Reader = US) -> Figure:
    """Return the picture of a play; a miss has no flight to draw.

    Parameters
    ----------
    words : for the foot of the page.
    """
    figure = Figure(figsize=(9.0, 6.9), layout="constrained")
    figure.get_layout_engine().set(rect=(0.01, 0, 0.98, 0.95))  # type: ignore[union-attr, call-arg]
    figure.text(0.02, 0.965, answer.bat, weight="bold", size=LARGE, parse_math=False)
    grid = figure.add_gridspec(3, 2, height_ratios=(2.3, 1.25, 0.45), width_ratios=(1.2, 1))
    contact = figure.add_subplot(grid[0, 0])
    draw_contact(contact, answer, reading)
    flight, park = answer.play.flight, answer.question.park
    if flight is not None:
        draw_above(figure.add_subplot(grid[0, 1]), flight, park, reading)
        draw_side(figure.add_subplot(grid[1, :]), flight, park, reading)
    foot = figure.add_subplot(grid[2, :])
    foot.set_axis_off()
    foot.text(0, 1, textwrap.fill(words.read(reading), LINE), va="top", size=NORMAL, transform=foot.transAxes)
    return figure

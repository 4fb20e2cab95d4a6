"""One play on one page: the contact, the path from the side and from above, the fence."""

from __future__ import annotations

import math
import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle

from sweetspot.answers.play import PlayAnswer
from sweetspot.reports.flight.picture import draw_above, draw_side
from sweetspot.reports.pictures.panels import SPARSE, beside, heading
from sweetspot.reports.pictures.style import INK, LARGE, MUTED, NORMAL, PAPER, SMALL, halo, styled
from sweetspot.reports.quantities import BLUE, GREEN, RED, US, Reader
from sweetspot.reports.sentences import Sentence

LINE = 118
"""Letters in a line of the words below."""


@styled
def play_figure(answer: PlayAnswer, words: Sentence, reading: Reader = US) -> Figure:
    """Return the picture of a play; a miss has no flight to draw."""
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


WOOD = "#ecd9b8"
ARROW = 0.0016
"""m of drawing per m/s."""
GAP = 0.004
"""m of drawing between things that must not touch."""


def draw_contact(axes: Axes, answer: PlayAnswer, reading: Reader = US) -> None:
    """Draw ball and barrel across the bat's axis, with the speeds before and after and the line of centres."""
    asked, strike = answer.question, answer.play.strike
    ball, pitch, offset = asked.conditions.ball, asked.pitch, float(answer.offset)
    bat_radius = float(asked.reduced.bat.width_at(float(answer.position))) / 2
    forward, up, _ = asked.path.axes
    reach = ball.radius + bat_radius
    lift = math.asin(max(-1.0, min(1.0, offset / reach)))
    tilt = math.atan2(forward[2], math.hypot(forward[0], forward[1]))

    def turned(vector: np.ndarray) -> np.ndarray:
        """Return the parts of a vector in the plane of the picture, with the ground level."""
        out, above = float(vector @ forward), float(vector @ up)
        return np.array([out * math.cos(tilt) - above * math.sin(tilt), out * math.sin(tilt) + above * math.cos(tilt)])

    def speed(value: float) -> str:
        return reading.shown(value, "speed", digits=0)

    missed = strike.launched is None
    distance = reach if not missed else reach * 1.05
    centre = distance * np.array([math.cos(tilt + lift), math.sin(tilt + lift)])
    axes.add_patch(Circle((0, 0), bat_radius, facecolor=WOOD, edgecolor=INK, linewidth=1.0))
    axes.add_patch(Circle(tuple(centre), ball.radius, facecolor=PAPER, edgecolor=INK, linewidth=1.0))
    ends = np.array([[0, 0], centre]) * 1.0
    axes.plot(*ends.T, color=MUTED, linewidth=0.8, linestyle=SPARSE)
    _arrow(axes, np.zeros(2), strike.bat_speed * turned(forward), RED)
    axes.text(0, -bat_radius - GAP, f"bat {speed(strike.bat_speed)}", color=RED, size=SMALL, ha="center", va="top")
    arriving = turned(pitch.velocity)
    leaving = None if strike.launched is None else turned(strike.launched.velocity)
    rises = leaving is None or _along(leaving)[1] >= _along(-arriving)[1]
    if pitch.speed:
        shaft = max(0.5 * ARROW * pitch.speed, 3 * GAP)  # outside the ball, so half as long as the others
        tail = centre + (ball.radius + GAP / 2 + shaft) * _along(-arriving)
        _arrow(axes, tail, centre + (ball.radius + GAP / 2) * _along(-arriving) - tail, BLUE, scale=1)
        _label(axes, tail, f"pitch {speed(pitch.speed)}", BLUE, under=rises)
    else:
        below = (float(centre[0]), float(centre[1]) - ball.radius - GAP)
        axes.text(*below, "ball at rest", color=BLUE, size=SMALL, ha="center", va="top", path_effects=halo())
    top, low = float(centre[1]) + ball.radius, min(-bat_radius, float(centre[1]) - ball.radius) - 5 * GAP
    if strike.launched is not None and leaving is not None:
        climb = strike.launched.launch_angle
        rising = f"{reading.shown(abs(climb), 'angle', digits=0)} {'up' if climb >= 0 else 'down'}"
        _arrow(axes, centre, leaving, GREEN)
        head = _beyond(centre, ARROW * leaving, ball.radius)
        _label(axes, head, f"ball {speed(strike.launched.speed)}, {rising}", GREEN, under=not rises)
        top, low = max(top, float(head[1]) + 4 * GAP), min(low, float(head[1]) - 5 * GAP)
    side = "above" if offset >= 0 else "below"
    aside = reading.shown(abs(offset), "offset")
    heading(axes, "Contact", f"seen along the bat; ball's centre {aside} {side} the bat's axis")
    axes.set_aspect("equal")
    axes.set(xlim=(-bat_radius - GAP, float(centre[0]) + ball.radius + 0.105), ylim=(low, top + 2 * GAP))
    axes.set_axis_off()


def _along(vector: np.ndarray) -> np.ndarray:
    return vector / max(float(np.hypot(*vector)), 1e-9)


def _beyond(centre: np.ndarray, arrow: np.ndarray, radius: float) -> np.ndarray:
    """Return the end of an arrow from a ball's centre, moved just outside the ball if it lies inside."""
    return centre + max(float(np.hypot(*arrow)), radius + 2 * GAP) * _along(arrow)


def _label(axes: Axes, place: np.ndarray, words: str, colour: str, *, under: bool) -> None:
    """Write beside the end of an arrow, on the side where the other arrow is not."""
    aside, side = (-3, "top") if under else (3, "bottom")
    beside(axes, words, tuple(place), (3, aside), color=colour, size=SMALL, va=side, path_effects=halo())


def _arrow(axes: Axes, start: np.ndarray, velocity: np.ndarray, colour: str, *, scale: float = ARROW) -> None:
    """Draw a velocity as an arrow."""
    end = start + scale * velocity
    axes.annotate("", tuple(end), tuple(start), arrowprops={"arrowstyle": "-|>", "color": colour, "linewidth": 1.6})

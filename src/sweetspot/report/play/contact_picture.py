"""The moment of contact seen along the bat, from its tip: who was where, and which way everything went."""

from __future__ import annotations

import math

import numpy as np
from matplotlib.axes import Axes
from matplotlib.patches import Circle

from sweetspot.report.pictures.style import INK, MUTED, PAPER, SMALL, halo, heading
from sweetspot.report.play.played_pitch import PlayedPitch
from sweetspot.report.quantities import BLUE, GREEN, RED, US, Reader

WOOD = "#ecd9b8"
ARROW = 0.0016
"""m of drawing per m/s."""


def draw_contact(axes: Axes, played: PlayedPitch, reading: Reader = US) -> None:
    """Draw ball and barrel across the bat's axis, with the speeds before and after and the line of centres."""
    strike, ball, bat_radius, offset = played.play.strike, played.ball, played.bat_radius, played.offset
    forward, up, _ = played.path.axes
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
    axes.plot(*ends.T, color=MUTED, linewidth=0.8, linestyle=(0, (4, 3)))
    _arrow(axes, np.zeros(2), strike.bat_speed * turned(forward), RED, f"bat {speed(strike.bat_speed)}")
    arriving = turned(played.pitch.velocity)
    _arrow(axes, centre - ARROW * arriving, arriving, BLUE, f"pitch {speed(played.pitch.speed)}", at_tail=True)
    if strike.launched is not None:
        leaving = turned(strike.launched.velocity)
        rising = reading.shown(strike.launched.launch_angle, "angle", digits=0)
        words = f"ball {speed(strike.launched.speed)}, {rising} up"
        _arrow(axes, centre, leaving, GREEN, words)
    side = "above" if offset >= 0 else "below"
    aside = reading.shown(abs(offset), "offset")
    heading(axes, "Contact", f"seen along the bat; ball's centre {aside} {side} the bat's axis")
    axes.set_aspect("equal")
    axes.set(xlim=(-0.07, 0.19), ylim=(-0.075, 0.125))
    axes.set_axis_off()


def _arrow(
    axes: Axes, start: np.ndarray, velocity: np.ndarray, color: str, words: str, *, at_tail: bool = False
) -> None:
    """Draw a velocity as an arrow, with its words at the head, or at the tail."""
    end = start + ARROW * velocity
    axes.annotate("", tuple(end), tuple(start), arrowprops={"arrowstyle": "-|>", "color": color, "linewidth": 1.6})
    place = start if at_tail else end
    axes.annotate(
        words, tuple(place), xytext=(2, 4), textcoords="offset points", color=color, size=SMALL, path_effects=halo()
    )

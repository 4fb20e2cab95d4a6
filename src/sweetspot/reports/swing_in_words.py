"""A swing and a hit in space, in words."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.answers.flight import BallLeaving
from sweetspot.numerics.arrays import Array
from sweetspot.reports.sentences import Sentence, Slot, say

LEVEL = math.radians(0.5)
"""rad below which a path is called level."""
SQUARE = 0.0005
"""m by which the ball may be off the bat's axis and yet be met on it."""
STILL = 1.0
"""rad/s below which a ball does not turn."""


def space_words(*, attack_angle: float, tilt: float, offset: float, leaving: BallLeaving, spin: Array) -> Sentence:
    """Return how a bat comes to the ball, and how the ball leaves and turns.

    Parameters
    ----------
    attack_angle, tilt : rad, of the barrel's path and of the plane that it swings in.
    offset : m by which the ball is met above the bat's axis.
    spin : rad/s, shape (3,), of the ball afterwards.
    """
    way = say("moves level")
    if abs(attack_angle) >= LEVEL:
        way = say(f"{'rises' if attack_angle > 0 else 'falls'} {{angle}}", angle=Slot(abs(attack_angle), "angle"))
    where = say("on its axis")
    if abs(offset) >= SQUARE:
        where = say(f"{{offset}} {'above' if offset > 0 else 'below'} its axis", offset=Slot(abs(offset), "offset"))
    speed, up = float(np.linalg.norm(spin)), float(leaving.launch_angle)
    turns = say("without spin")
    if speed > STILL:
        lean = math.asin(min(1.0, abs(float(spin[2])) / speed))
        turns = say(
            "turning {spin} about an axis {lean} off the level", spin=Slot(speed, "spin"), lean=Slot(lean, "angle")
        )
    return say(
        f"The barrel {{way}} in a plane tilted {{tilt}} and meets the ball {{where}}; the ball leaves at {{speed}}, "
        f"{{angle}} {'down' if up < 0 else 'up'}, {{turns}}.",
        way=way,
        tilt=Slot(tilt, "angle"),
        where=where,
        speed=Slot(leaving.exit_speed, "speed"),
        angle=Slot(abs(up), "angle"),
        turns=turns,
    )

"""What a hit is computed under."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.records import Columns, Length, Mass, Ratio, Speed
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.interval import Number
from sweetspot.uncertainty.drawn_hits import Draws
from sweetspot.units.dimensions import SLOPE_PER_SPEED


@dataclass(frozen=True)
class HitConditions:
    """Pitch, swing, hands and ball; places from the knob end. See `Conditions`.

    Parameters
    ----------
    ball_restitution, ball_restitution_speed, ball_restitution_slope : the ball's law on a wall: restitution at a speed,
        and its fall with speed.
    """

    pitch_speed: Speed
    bat_speed: Speed
    bat_speed_at: Length
    pivot: Length
    hands: Length
    ball: str
    ball_mass: Mass
    ball_restitution: Ratio
    ball_restitution_speed: Speed
    ball_restitution_slope: Annotated[Number, SLOPE_PER_SPEED]


def hit_conditions(conditions: Conditions) -> HitConditions:
    """Return the conditions under which a hit is computed."""
    swing, ball = conditions.swing, conditions.ball
    return HitConditions(
        pitch_speed=conditions.pitch.speed,
        bat_speed=swing.bat_speed,
        bat_speed_at=swing.measured_at,
        pivot=swing.pivot,
        hands=conditions.hands.position,
        ball=ball.name,
        ball_mass=ball.mass,
        ball_restitution=ball.restitution.reference,
        ball_restitution_speed=ball.restitution.reference_speed,
        ball_restitution_slope=ball.restitution.slope,
    )


def conditions_columns(draws: Draws) -> Columns:
    """Return the speeds and balls of every draw, by the fields of `HitConditions`."""
    laws = [ball.restitution for ball in draws.balls]
    return {
        "pitch_speed": draws.pitch_speed,
        "bat_speed": draws.bat_speed,
        "ball_mass": draws.ball_mass,
        "ball_restitution": np.array([law.reference for law in laws]),
        "ball_restitution_slope": np.array([law.slope for law in laws]),
    }

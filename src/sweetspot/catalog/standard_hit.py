"""The standard hit: the conditions that the command line, the docs and the published comparisons start from."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.catalog.sports import sport
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions, Hands, Pitch, Swing
from sweetspot.units import INCH

SPEED_FROM_TIP = 6 * INCH
"""m: where people measure the speed of a bat."""


def standard_conditions(implement: Implement) -> Conditions:
    """Return the usual stroke at the usual ball of an implement's sport, turning about the bottom of the grip.

    For a baseball bat that is a 90 mph pitch and 70 mph of bat speed 6 in from the tip; a softball bat meets a
    softball at a softball's speed.

    >>> standard_conditions(catalog.bat("slow-pitch")).ball.name
    'softball, 12 in, fast pitch'
    """
    usual = sport(implement.sport)
    stroke = usual.stroke
    return Conditions(
        pitch=Pitch(speed=stroke.ball_speed.value),
        swing=Swing(
            bat_speed=stroke.swing_speed.value,
            measured_at=implement.length - stroke.from_tip,
            pivot=implement.choke + stroke.pivot,
        ),
        hands=Hands(position=implement.choke + stroke.hands),
        ball=catalog.ball(usual.balls[0]),
    )

"""The standard hit: the conditions that the command line, the docs and the published comparisons start from."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.bat import Bat
from sweetspot.catalog.sports import DEFAULT_SPORT, sport
from sweetspot.implement import Implement
from sweetspot.swing import Conditions, Hands, Pitch, Swing
from sweetspot.units import INCH, MPH

PITCH_SPEED = 90 * MPH
BAT_SPEED = 70 * MPH
SPEED_FROM_TIP = 6 * INCH
HANDS = 6 * INCH
"""m above the bottom of the grip."""


def standard_conditions(bat: Implement) -> Conditions:
    """Return a 90 mph pitch, 70 mph of bat speed 6 in from the tip, turning about the bottom of the grip.

    The top hand is 6 in above the bottom of the grip; the ball is the catalogue's baseball. Any other implement than a
    bat gets the usual stroke and ball of its sport, turning about the bottom of the grip as well.
    """
    if not isinstance(bat, Bat) and bat.sport != DEFAULT_SPORT:
        return _usual_stroke(bat)
    return Conditions(
        pitch=Pitch(speed=PITCH_SPEED),
        swing=Swing(bat_speed=BAT_SPEED, measured_at=bat.length - SPEED_FROM_TIP, pivot=bat.choke),
        hands=Hands(position=bat.choke + HANDS),
        ball=catalog.ball(),
    )


def _usual_stroke(bat: Implement) -> Conditions:
    found = sport(bat.sport)
    stroke = found.stroke
    return Conditions(
        pitch=Pitch(speed=stroke.ball_speed.value),
        swing=Swing(
            bat_speed=stroke.swing_speed.value,
            measured_at=bat.length - stroke.from_tip,
            pivot=bat.choke + stroke.pivot,
        ),
        hands=Hands(position=bat.choke + stroke.hands),
        ball=catalog.ball(found.balls[0]),
    )

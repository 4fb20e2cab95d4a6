"""The standard hit: the conditions that the command line, the docs and the published comparisons start from."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.bat import Bat
from sweetspot.swing import Conditions, Hands, Pitch, Swing
from sweetspot.units import INCH, MPH

PITCH_SPEED = 90 * MPH
BAT_SPEED = 70 * MPH
SPEED_FROM_TIP = 6 * INCH
HANDS = 6 * INCH
"""m above the bottom of the grip."""


def standard_conditions(bat: Bat) -> Conditions:
    """Return a 90 mph pitch, 70 mph of bat speed 6 in from the tip, turning about the bottom of the grip.

    The top hand is 6 in above the bottom of the grip; the ball is the catalogue's baseball.
    """
    return Conditions(
        pitch=Pitch(speed=PITCH_SPEED),
        swing=Swing(bat_speed=BAT_SPEED, measured_at=bat.length - SPEED_FROM_TIP, pivot=bat.choke),
        hands=Hands(position=bat.choke + HANDS),
        ball=catalog.ball(),
    )

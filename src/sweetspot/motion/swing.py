"""The bat and the ball before contact, and the hands that hold the bat."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from sweetspot.equipment.ball import Ball
from sweetspot.equipment.base import NonNegative, Validated
from sweetspot.plausibility import check_place, check_possible
from sweetspot.units import INCH, format_length

SPEED_FROM_TIP = 6 * INCH
"""m from the tip where the speed of a bat is measured, as Statcast does [statcast]."""
LIGHTEST_HAND = 0.01
"""kg."""


class Pitch(Validated):
    """The ball as it arrives.

    Parameters
    ----------
    speed : m/s towards the bat, >= 0 (0 is a ball on a tee), at most 70.
    """

    speed: NonNegative

    @model_validator(mode="after")
    def _is_possible(self) -> Pitch:
        check_possible(self.speed, "speed", "pitch_speed")
        return self


class Swing(Validated):
    """The bat turning about one axis at the moment of contact.

    Parameters
    ----------
    bat_speed : m/s at ``measured_at``, > 0, at most 70.
    measured_at : m from the knob end, beyond ``pivot``.
    pivot : m from the knob end of the axis the bat turns about; negative: beyond the knob.
    """

    bat_speed: float
    measured_at: Annotated[float, Field(gt=0)]
    pivot: float = 0.0

    @model_validator(mode="after")
    def _is_a_swing(self) -> Swing:
        check_place(self.measured_at, "measured_at")
        check_place(self.pivot, "pivot")
        check_possible(self.bat_speed, "bat speed", "bat_speed")
        if self.measured_at <= self.pivot:
            raise ValueError(
                f"bat speed is measured at {format_length(self.measured_at)}, not beyond the pivot at "
                f"{format_length(self.pivot)}; give a place further out"
            )
        return self

    @property
    def angular_speed(self) -> float:
        """Angular speed in rad/s."""
        return self.bat_speed / (self.measured_at - self.pivot)

    def speed_at(self, position: float) -> float:
        """Return the bat's speed in m/s at a position from the knob end in m."""
        return self.angular_speed * (position - self.pivot)


class Hands(Validated):
    """Two hands on the handle, each a mass behind a spring and a damper (its flesh).

    The top hand is centred at ``position``; the bottom hand one ``spacing`` nearer the knob.

    Parameters
    ----------
    position : m from the knob end, >= 0.
    spacing : m between the centres of the hands.
    mass, stiffness, damping : kg, N/m and N s/m per hand; mass 0 for a hand that is not there,
        without stiffness and damping.
    """

    position: NonNegative
    spacing: NonNegative = 0.089
    mass: NonNegative = 0.0
    stiffness: NonNegative = 0.0
    damping: NonNegative = 0.0

    @model_validator(mode="after")
    def _weigh_something_or_nothing(self) -> Hands:
        if 0 < self.mass < LIGHTEST_HAND:
            raise ValueError(
                f"a hand of {self.mass:g} kg was given; allowed is 0 for no hand, or at least {LIGHTEST_HAND:g} kg"
            )
        if self.mass == 0 and (self.stiffness or self.damping):
            raise ValueError(
                f"hands of {self.stiffness:g} N/m and {self.damping:g} N s/m without a mass hold nothing; give "
                "the mass of each, or no stiffness and damping"
            )
        return self

    @property
    def places(self) -> tuple[float, float]:
        """Positions of the top and the bottom hand in m; the bottom one never beyond the knob."""
        return self.position, max(0.0, self.position - self.spacing)


class Conditions(Validated):
    """Everything about a hit that is not the bat: the pitch, the swing, the hands and the ball.

    `standard_conditions` has the usual ones; ``conditions.replaced(pitch=Pitch(speed=38.0))`` others.

    Parameters
    ----------
    pitch : the ball's speed as it arrives.
    swing : how fast the bat turns, and about what.
    hands : where they hold, and whether their mass counts.
    ball : the one that is hit.
    """

    pitch: Pitch
    swing: Swing
    hands: Hands
    ball: Ball

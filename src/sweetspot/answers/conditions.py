"""What a hit is computed under."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.records import Columns, Length, Mass, MomentOfInertia, Ratio, Speed
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Number
from sweetspot.uncertainty.drawn_hits import Draws
from sweetspot.units.dimensions import SLOPE_PER_SPEED


@dataclass(frozen=True)
class HitConditions:
    """Pitch, swing, hands and ball; places from the knob end. See `Conditions`.

    ``ball_restitution``, ``ball_restitution_speed``, ``ball_restitution_slope``: the ball's law on a wall: restitution
    at a speed, and its fall with speed.
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
        ball_restitution_slope=ball.restitution.slope_at(ball.restitution.reference_speed),
    )


def conditions_columns(draws: Draws) -> Columns:
    """Return the speeds and balls of every draw, by the fields of `HitConditions`."""
    laws = [ball.restitution for ball in draws.balls]
    return {
        "pitch_speed": draws.pitch_speed,
        "bat_speed": draws.bat_speed,
        "ball_mass": draws.ball_mass,
        "ball_restitution": np.array([law.reference for law in laws]),
        "ball_restitution_slope": np.array([law.slope_at(law.reference_speed) for law in laws]),
    }


@dataclass(frozen=True)
class MassProperties:
    """Name, length and mass properties; positions and axes from the knob end.

    ``moi_cm``, ``moi_knob``, ``moi_6in``: about axes across it, through the balance point, the knob end and 6 in from
    that. ``roll_moi``: about its own axis.
    """

    name: str
    length: Length
    mass: Mass
    balance_point: Length
    moi_cm: MomentOfInertia
    moi_knob: MomentOfInertia
    moi_6in: MomentOfInertia
    roll_moi: MomentOfInertia


def mass_properties(implement: Implement, body: RigidBody) -> MassProperties:
    """Return the mass, balance point and moments of inertia of an implement."""
    return MassProperties(
        name=implement.name,
        length=implement.length,
        mass=body.mass,
        balance_point=body.balance_point,
        moi_cm=body.moi_cm,
        moi_knob=body.moi(0.0),
        moi_6in=body.moi(STANDARD_AXIS),
        roll_moi=body.roll_moi,
    )


def mass_columns(draws: Draws) -> Columns:
    """Return the mass properties of every draw, by the fields of `MassProperties`; none where nothing is open."""
    body = draws.bats.bending
    if not isinstance(draws.beam.bat, Bat) and not draws.sources.unknowns:
        return {}
    return {
        "mass": body.mass,
        "balance_point": body.balance_point,
        "moi_cm": body.moi_cm,
        "moi_knob": body.moi(0.0),
        "moi_6in": body.moi(STANDARD_AXIS),
        "roll_moi": body.roll_moi,
    }

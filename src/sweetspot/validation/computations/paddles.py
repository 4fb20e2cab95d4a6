"""Paddles: lead on them, the test in a clamp, contact, worn balls; and drops that land short."""

from __future__ import annotations

import math
from functools import cache
from typing import NamedTuple

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_paddle_test import PaddleTest, paddle_test
from sweetspot.analysis.drop_test import ROOM_AIR, terminal_speed
from sweetspot.collision.aside import aside_angle
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.paddle_modes import DEFLECTED, Clamp, face_stiffness, plate_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import AddedMass
from sweetspot.equipment.paddle import Paddle
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.units import INCH, POUND_FORCE
from sweetspot.validation.computations.sports import SHEET_AIR

AXIS, REACH = 2 * INCH, 0.09
"""m from the butt end: the clamp's axis [kewcor], and to where it holds the handle (assumed)."""
NEAR_THE_TIP = (3.4 * INCH, 5.4 * INCH)
"""m from the tip, between which rebounds were equal in two clamps [technicalpickleball_clamp]."""
LEAD = {"position": 0.275, "mass": 0.012, "lateral": 0.095}
"""At 3 and 9 o'clock, on the edge of the face: 9.6 cm beside the line and 22.4 cm from the axis follow from the
published change of twist and swing weight themselves."""
STEP = 0.1
"""Relative change by which a slope is taken."""


class PaddleWeights(NamedTuple):
    """Swing weight about the clamp's axis and twist weight, kg m^2."""

    swing_weight: float
    twist_weight: float


def leaded_weights(*, implement: str) -> PaddleWeights:
    """Return the weights of a paddle with lead at 3 and 9 o'clock."""
    body = rigid_body(beam_model(_leaded(_paddle(implement))))
    return PaddleWeights(body.moi(AXIS), body.roll_moi)


def aside_with_lead(*, implement: str, ball: str, from_tip: float, lateral: float, speed: float) -> float:
    """Return the change by lead of the angle at which a ball leaves that met the face beside its line, as a part."""
    plain, leaded = (
        _angle(tool, ball, (from_tip, lateral), speed) for tool in (_paddle(implement), _leaded(_paddle(implement)))
    )
    return leaded / plain - 1


def paddle_impact(*, implement: str, ball: str, from_tip: float, closing_speed: float) -> Impact:
    """Return a hit on a paddle that hangs freely."""
    tool = _paddle(implement)
    return hit(
        plate_modes(beam_model(tool)),
        ball=catalog.ball(ball),
        position=tool.length - from_tip,
        closing_speed=closing_speed,
    )


def deformed_share(*, implement: str, ball: str, from_tip: float, closing_speed: float) -> float:
    """Return the part of the energy that is left as vibration of the paddle."""
    energy = paddle_impact(implement=implement, ball=ball, from_tip=from_tip, closing_speed=closing_speed).energy
    return (energy.bending + energy.face) / energy.incoming


def rebound_by_wear(*, implement: str, ball: str, worn: str, from_tip: float, closing_speed: float) -> float:
    """Return the relative change of the rebound by the wear of the ball."""
    new, old = (
        paddle_impact(implement=implement, ball=each, from_tip=from_tip, closing_speed=closing_speed)
        for each in (ball, worn)
    )
    return old.collision_efficiency / new.collision_efficiency - 1


def pbcor_in_clamp(*, implement: str, ball: str, speed: float, moi: float, swing_weight: float = 0.0) -> float:
    """Return the greatest paddle-ball restitution over the face, in a clamp of a moment of inertia.

    ``swing_weight``: of the paddle in kg m^2, where it is another.
    """
    tool = _paddle(implement)
    tool = tool.replaced(moi=swing_weight) if swing_weight else tool
    return _scan(tool, ball, speed, moi).best_pbcor


def pbcor_slope(*, implement: str, ball: str, speed: float, moi: float, from_tip: float) -> float:
    """Return by how much the restitution changes with speed, s/m."""
    tool = _paddle(implement)
    place = np.array([tool.length - from_tip])
    slow, fast = (float(_tested(tool, ball, faster * speed, moi, place).pbcor[0]) for faster in (1 - STEP, 1 + STEP))
    return (fast - slow) / (2 * STEP * speed)


def rebounds_in_two_clamps(*, implement: str, ball: str, speed: float, moi: float, other_moi: float) -> float:
    """Return the greatest relative difference of the rebounds near the tip in two clamps."""
    tool = _paddle(implement)
    heavy, light = (_scan(tool, ball, speed, each) for each in (moi, other_moi))
    from_tip = tool.length - heavy.position
    near = (from_tip >= NEAR_THE_TIP[0]) & (from_tip <= NEAR_THE_TIP[1])
    return float(np.abs(light.rebound[near] / heavy.rebound[near] - 1).max())


def rebound_felt_by_clamp(*, implement: str, ball: str, speed: float, moi: float, from_tip: float) -> float:
    """Return by how much a clamp changes the rebound at a place, relative to a paddle on an axle alone."""
    tool = _paddle(implement)
    place = np.array([tool.length - from_tip])
    held, free = (float(_tested(tool, ball, speed, each, place).rebound[0]) for each in (moi, 0.0))
    return held / free - 1


def pbcor_per_force(*, implement: str, ball: str, speed: float, moi: float) -> float:
    """Return the change of the restitution with the force in lbf that presses the face in by 1/16 in, by the core."""
    found = [
        _paddle(implement).replaced(core_shear=factor * _paddle(implement).core_shear)
        for factor in (1 - STEP, 1 + STEP)
    ]
    softer, stiffer = ((_scan(tool, ball, speed, moi).best_pbcor, _force(tool)) for tool in found)
    return (stiffer[0] - softer[0]) / (stiffer[1] - softer[1])


def pbcor_per_swing_weight(*, implement: str, ball: str, speed: float, moi: float) -> float:
    """Return the change of the restitution for each kg cm^2 of swing weight."""
    swing = _paddle(implement).moi or 0.0
    low, high = (
        pbcor_in_clamp(implement=implement, ball=ball, speed=speed, moi=moi, swing_weight=factor * swing)
        for factor in (1 - STEP / 2, 1 + STEP / 2)
    )
    return (high - low) / (STEP * swing * 1e4)


def landing_of_drop(*, ball: str, air: str, speed: float, launch_angle: float, height: float) -> float:
    """Return the distance in m that a ball without spin flies to the ground."""
    start = batted_ball(speed=speed, launch_angle=launch_angle, position=(0.0, 0.0, height))
    flown = fly(start, FlightConditions(ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics(air), air=SHEET_AIR))
    return float(flown.positions[-1][1])


def conditioned_rebound(*, ball: str, temperature: float, height: float) -> float:
    """Return rebound over fall of a ball at a temperature in degC, dropped through air onto a rigid floor.

    With the terminal speed u: v^2 = u^2 (1 - exp(-2 g h / u^2)) at the floor, and u^2 / (2 g) ln(1 + (e v)^2 / u^2) up.
    """
    thing = catalog.ball(ball).conditioned(temperature=temperature)
    squared, gravity = terminal_speed(thing, air_density=ROOM_AIR) ** 2, 2 * STANDARD_GRAVITY
    landing = squared * (1 - math.exp(-gravity * height / squared))
    leaving = landing * float(thing.restitution.at(math.sqrt(landing))) ** 2
    return squared / gravity * math.log1p(leaving / squared) / height


def _paddle(name: str) -> Paddle:
    tool = catalog.implement(name)
    assert isinstance(tool, Paddle)
    return tool


def _leaded(tool: Paddle) -> Paddle:
    return tool.replaced(added=(*tool.added, AddedMass(**LEAD)))


def _force(tool: Paddle) -> float:
    return face_stiffness(tool) * DEFLECTED / POUND_FORCE


def _angle(tool: Paddle, ball: str, place: tuple[float, float], speed: float) -> float:
    """Return the angle in rad at which a ball leaves a free paddle whose face is rough."""
    from_tip, lateral = place
    found = hit(
        plate_modes(beam_model(tool)),
        ball=catalog.ball(ball),
        position=tool.length - from_tip,
        closing_speed=speed,
        lateral=lateral,
    )
    roll = rigid_body(beam_model(tool)).roll_moi
    return aside_angle(found, roll_moi=roll, face=tool.face, leaves_at=found.collision_efficiency * speed)


@cache
def _scan(tool: Paddle, ball: str, speed: float, moi: float) -> PaddleTest:
    return _tested(tool, ball, speed, moi, None)


def _tested(tool: Paddle, ball: str, speed: float, moi: float, positions: Array | None) -> PaddleTest:
    clamp = Clamp(axis=AXIS, reach=REACH, moi=moi)
    return paddle_test(tool, ball=catalog.ball(ball), speed=speed, clamp=clamp, positions=positions)

"""The best swing and the best launch angle."""

from __future__ import annotations

import math
from functools import cache
from typing import Literal

from sweetspot import catalog
from sweetspot.analysis.optimum import BestSwing, best_launch, best_swing
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.oblique_contact import FRICTION, TANGENTIAL_RESTITUTION, Friction
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.units import DEGREE, FOOT, MPH, RPM

BAT = "r161-ash"
SHEET = Air(temperature=21.11, humidity=0.5, elevation=15 * FOOT)
PITCHES = {"fastball": (85.4, 2347, -4.9), "curve": (72.1, -2549, -9.8), "knuckleball": (72.1, 0, -9.0)}
"""Speed at the plate in mph, backspin in rpm, all of it active, and approach angle in degrees."""
Model = Literal["measured", "rolling"]


@cache
def best(pitch: str, model: Model, friction: float = FRICTION) -> BestSwing:
    """Return the best level swing at a pitch.

    "measured": friction gives a part of the sliding back and drag grows with spin; "rolling": the ball leaves rolling
    on the bat and its drag does not know of its spin.
    """
    bat, ball = catalog.bat(BAT), catalog.ball()
    speed, backspin, fall = PITCHES[pitch]
    arriving = batted_ball(
        speed=speed * MPH, launch_angle=fall * DEGREE, spray=math.pi, backspin=backspin * RPM, position=(0.0, 0.6, 0.9)
    )
    law = catalog.aerodynamics()
    return best_swing(
        reduced_bat(bat, ball=ball),
        FlightConditions(
            ball=ball, aerodynamics=law if model == "measured" else law.replaced(drag_per_active_spin=0.0), air=SHEET
        ),
        swing=standard_conditions(bat).swing,
        pitch=arriving,
        friction=Friction(
            coefficient=friction, tangential_restitution=TANGENTIAL_RESTITUTION if model == "measured" else 0.0
        ),
    )


def best_carry_gain(*, pitch: str, other_pitch: str, model: Model) -> float:
    """Return by how much a pitch, hit at its best, is carried farther than another."""
    return best(pitch, model).carry - best(other_pitch, model).carry


def best_carry_change_by_friction(*, pitch: str, friction: float) -> float:
    """Return what another coefficient of friction changes of the best carry."""
    return best(pitch, "measured", friction).carry - best(pitch, "measured").carry


def best_launch_angle(*, exit_speed: float, backspin: float, law: str = "baseball") -> float:
    """Return the launch angle that carries farthest."""
    launch = best_launch(
        exit_speed,
        FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(law), air=SHEET),
        backspin=backspin,
    )
    return launch.launch_angle


COMPUTATIONS = (best_carry_gain, best_carry_change_by_friction, best_launch_angle)

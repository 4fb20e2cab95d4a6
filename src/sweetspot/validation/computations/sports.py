"""Other sports: the arithmetic of rackets and clubs, drop tests of rule books, forces on their balls."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced, dead_spot, exit_speed_of
from sweetspot.analysis.drop_test import Rebound, fire
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.closed_form import collision_efficiency
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion
from sweetspot.equipment.implement import Implement
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing import Conditions
from sweetspot.paper.sports import rule_book_drops


def racket_percussion(*, mass: float, balance_point: float, moi: float, axis: float) -> float:
    """Return the centre of percussion from the butt of a racket that turns about ``axis``."""
    return centre_of_percussion(_racket(mass, balance_point, moi, axis), pivot=axis)


def percussion_gain(*, mass: float, balance_point: float, moi: float, axis: float, added_mass: float) -> float:
    """Return how far a weight at the butt moves the centre of percussion."""
    before = _racket(mass, balance_point, moi, axis)
    return centre_of_percussion(_weighted(before, added_mass), pivot=axis) - centre_of_percussion(before, pivot=axis)


def balance_gain(*, mass: float, balance_point: float, moi: float, axis: float, added_mass: float) -> float:
    """Return how far a weight at the butt moves the balance point."""
    return _weighted(_racket(mass, balance_point, moi, axis), added_mass).balance_point - balance_point


def swing_weight_gain(*, mass: float, balance_point: float, moi: float, axis: float, added_mass: float) -> float:
    """Return how much a weight at the butt adds to the moment of inertia about ``axis``."""
    return _weighted(_racket(mass, balance_point, moi, axis), added_mass).moi(axis) - moi


def smash_factor(*, ball_mass: float, mass: float, restitution: float) -> float:
    """Return ball speed over head speed of a free head hit in its middle, 1 + q = (1 + e) / (1 + m / M)."""
    return 1 + collision_efficiency(restitution, recoil=ball_mass / mass)


def efficiency_of_speed_ratio(*, share: float) -> float:
    """Return q of an implement that sends a ball at rest off at this share of its own speed."""
    return share - 1


def rule_book_rebound(*, sport: str, test: str) -> float:
    """Return the height that the ball of a sport reaches in a drop test of its rule book."""
    return rule_book_drops(sport)[test].rebound


def driven_golf_force(*, mass: float, speed: float) -> float:
    """Return the peak force on a golf ball under a free club head of ``mass`` at ``speed``."""
    return _driven(mass, speed).impact.peak_force


def driven_golf_time(*, mass: float, speed: float) -> float:
    """Return how long that head touches the ball: a wall's time at the speed of equal energy, less sqrt(1 + m/M)."""
    return _driven(mass, speed).impact.contact_time / math.sqrt(1 + catalog.ball("golf").mass / mass)


def swing_law_loss(*, moi: float, other_moi: float, speed: float) -> float:
    """Return how much slower a head moves with ``other_moi`` than with ``moi`` at ``speed``, by the bats' power law."""
    law = replace(swing_law(), lightest_moi=min(moi, other_moi))
    return speed * (1 - law.speed_ratio(other_moi, reference_moi=moi))


def efficiency_on(*, implement: str, from_tip: float, closing_speed: float) -> float:
    """Return q of the usual ball, at rest, hit at this place of an implement that comes with ``closing_speed``."""
    return _struck(implement, from_tip, closing_speed).collision_efficiency


def contact_time_on(*, implement: str, from_tip: float, closing_speed: float) -> float:
    """Return how long that ball touches it."""
    return _struck(implement, from_tip, closing_speed).contact_time


def first_node_from_tip(*, implement: str) -> float:
    """Return the node of the first mode nearest to the tip, from the tip."""
    analysis = _usual(implement)
    return analysis.bat.length - analysis.sweet_spots.node_1


def percussion_towards_hands(*, implement: str) -> float:
    """Return how far the centre of percussion lies nearer to the hands than the node of the first mode."""
    spots = _usual(implement).sweet_spots
    return spots.node_1 - spots.center_of_percussion


def faster_ball(*, implement: str, share: float) -> float:
    """Return the part that the ball gains when the implement is swung faster by this part, at its best place."""
    analysis, conditions = _usual(implement), _conditions(implement)
    swing = conditions.swing
    faster = conditions.replaced(swing=swing.replaced(bat_speed=(1 + share) * swing.bat_speed))
    after = analyse_reduced(_reduced(implement), faster)
    return exit_speed_of(after.best, faster) / exit_speed_of(analysis.best, conditions) - 1


def best_bounce_from_throat(*, implement: str) -> float:
    """Return the place of the greatest q from the throat end of the strings."""
    analysis = _usual(implement)
    assert analysis.bat.outline is not None, "only rackets are asked"
    return analysis.sweet_spots.max_collision_efficiency - analysis.bat.outline.start


def node_from_middle(*, implement: str) -> float:
    """Return how much nearer the tip than the middle of its face the head's node of an implement's first mode lies."""
    analysis = _usual(implement)
    assert analysis.bat.outline is not None, "only rackets are asked"
    return analysis.sweet_spots.node_1 - analysis.bat.outline.middle


def dead_spot_from_tip(*, implement: str) -> float:
    """Return the place near the tip where a ball is left with no speed, from the tip."""
    analysis = _usual(implement)
    place = dead_spot(analysis)
    assert place is not None, "only rackets with a dead spot are asked"
    return analysis.bat.length - place


def usual_smash_factor(*, implement: str) -> float:
    """Return exit speed over the implement's speed at its best place under the usual stroke."""
    analysis, conditions = _usual(implement), _conditions(implement)
    return exit_speed_of(analysis.best, conditions) / conditions.swing.speed_at(analysis.best.position)


def usual_exit_speed(*, implement: str) -> float:
    """Return the greatest exit speed under the usual stroke."""
    return exit_speed_of(_usual(implement).best, _conditions(implement))


def sport_carry(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> float:
    """Return how far a ball flies from the ground to the ground at 70 degF and sea level."""
    return _flown(ball, air, speed, launch_angle, backspin).carry


def sport_hang_time(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> float:
    """Return how long it flies."""
    return _flown(ball, air, speed, launch_angle, backspin).hang_time


def sport_apex(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> float:
    """Return how high it flies."""
    return _flown(ball, air, speed, launch_angle, backspin).apex_height


def sport_landing_angle(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> float:
    """Return how steeply it comes down."""
    return _flown(ball, air, speed, launch_angle, backspin).landing_angle


def drag_from_two_cameras(*, ball: str, air: str, speed: float, distance: float) -> float:
    """Return the drag coefficient that two level speeds a distance apart give: 2 m ln(v1 / v2) / (rho pi R^2 x)."""
    flight = _flown(ball, air, speed, math.radians(5), 0.0)
    thing = catalog.ball(ball)
    along = flight.positions[:, 1]
    index = int((along < distance).sum())
    first, second = (float(flight.velocities[k][1]) for k in (0, index))
    area = math.pi * thing.radius**2
    return 2 * thing.mass * math.log(first / second) / (SHEET_AIR.density * area * float(along[index]))


SHEET_AIR = Air(temperature=(70 - 32) / 1.8)
"""70 degF, sea level."""


@cache
def _flown(ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> Flight:
    start = batted_ball(speed=speed, launch_angle=launch_angle, backspin=backspin)
    return fly(start, FlightConditions(ball=catalog.ball(ball), aerodynamics=catalog.aerodynamics(air), air=SHEET_AIR))


@cache
def _conditions(implement: str) -> Conditions:
    return standard_conditions(catalog.implement(implement))


@cache
def _reduced(implement: str) -> ReducedBat[Implement]:
    return reduced_bat(catalog.implement(implement), ball=_conditions(implement).ball)


@cache
def _usual(implement: str) -> Analysis[Implement]:
    return analyse_reduced(_reduced(implement), _conditions(implement))


def _struck(implement: str, from_tip: float, closing_speed: float) -> Impact:
    reduced = _reduced(implement)
    place = reduced.bat.length - from_tip
    return hit(reduced.modes, ball=_conditions(implement).ball, position=place, closing_speed=closing_speed)


def _driven(mass: float, speed: float) -> Rebound:
    ball = catalog.ball("golf")
    wall = Block(material=catalog.material("steel"), thickness=0.1, floor_modulus=None)
    return fire(wall, ball=ball, speed=speed / math.sqrt(1 + ball.mass / mass))


def _racket(mass: float, balance_point: float, moi: float, axis: float) -> RigidBody:
    return RigidBody(mass, balance_point, moi - mass * (balance_point - axis) ** 2, 0.0)


def _weighted(body: RigidBody, added_mass: float) -> RigidBody:
    """Return a body with a weight at its butt end."""
    mass = body.mass + added_mass
    balance = body.mass * body.balance_point / mass
    about_butt = body.moi(0.0)
    return RigidBody(mass, balance, about_butt - mass * balance**2, body.roll_moi)

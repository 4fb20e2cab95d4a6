"""Other sports: the arithmetic of rackets and clubs, drop tests of rule books, forces on their balls."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from typing import NamedTuple

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse_reduced, dead_spot, exit_speed_of
from sweetspot.analysis.drop_test import Rebound, fire
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.closed_form import collision_efficiency
from sweetspot.collision.coupled import hit
from sweetspot.collision.gear_effect import SideShot, side_shot
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.block import Block
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.dynamics.rigid import RigidBody, centre_of_percussion
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import Flight, fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing import Conditions
from sweetspot.papers.sports import rule_book_drops
from sweetspot.validation.computations.rigid import listed_body


def racket_percussion(*, axis: float, **line: float) -> float:
    """Return the center of percussion from the butt of a racket that turns about ``axis``."""
    return centre_of_percussion(listed_body(axis=axis, **line), pivot=axis)


class ButtWeight(NamedTuple):
    """Changes of a racket by a weight at its butt: center of percussion, balance point, moment about the axis."""

    percussion: float
    balance_point: float
    swing_weight: float


def butt_weight(*, mass: float, balance_point: float, moi: float, axis: float, added_mass: float) -> ButtWeight:
    """Return the changes caused by a weight at the butt."""
    before = listed_body(mass=mass, balance_point=balance_point, moi=moi, axis=axis)
    heavier = mass + added_mass
    balance = mass * balance_point / heavier
    after = RigidBody(heavier, balance, before.moi(0.0) - heavier * balance**2, 0.0)
    shift = centre_of_percussion(after, pivot=axis) - centre_of_percussion(before, pivot=axis)
    return ButtWeight(shift, balance - balance_point, after.moi(axis) - moi)


def smash_factor(*, ball_mass: float, mass: float, restitution: float) -> float:
    """Return ball speed over head speed of a free head hit in its middle, 1 + q = (1 + e) / (1 + m / M)."""
    return 1 + collision_efficiency(restitution, recoil=ball_mass / mass)


def efficiency_of_speed_ratio(*, share: float) -> float:
    """Return q of an implement that sends a ball at rest off at this share of its own speed."""
    return share - 1


def rule_book_rebound(*, sport: str, test: str) -> float:
    """Return the height that the ball of a sport reaches in a drop test of its rule book."""
    return rule_book_drops(sport)[test].rebound


def driven_golf(*, mass: float, speed: float) -> Rebound:
    """Return a golf ball on a wall at the speed of equal energy to a free club head of ``mass`` at ``speed``."""
    ball = catalog.ball("golf")
    wall = Block(material=catalog.material("steel"), thickness=0.1, floor_modulus=None)
    return fire(wall, ball=ball, speed=speed / math.sqrt(1 + ball.mass / mass))


def driven_golf_time(*, mass: float, speed: float) -> float:
    """Return the contact time with that head: the wall's over sqrt(1 + m/M)."""
    return driven_golf(mass=mass, speed=speed).impact.contact_time / math.sqrt(1 + catalog.ball("golf").mass / mass)


def swing_law_loss(*, moi: float, other_moi: float, speed: float) -> float:
    """Return the loss of head speed with ``other_moi`` against ``moi`` at ``speed``, by the bats' power law."""
    law = replace(swing_law(), lightest_moi=min(moi, other_moi))
    return speed * (1 - law.speed_ratio(other_moi, reference_moi=moi))


def struck(*, implement: str, from_tip: float, closing_speed: float, lateral: float = 0.0) -> Impact:
    """Return the hit of the usual ball, at rest, at a place of an implement that comes with ``closing_speed``."""
    reduced = _reduced(implement)
    place, ball = reduced.bat.length - from_tip, _conditions(implement).ball
    return hit(reduced.modes, ball=ball, position=place, lateral=lateral, closing_speed=closing_speed)


def _golf_shot(lateral: float, ball_speed: float, **head: float | None) -> SideShot:
    """Return how the usual ball leaves the usual driver's head, some of its numbers changed, at ``ball_speed``."""
    club, ball = catalog.implement("golf-driver"), catalog.ball("golf")
    assert isinstance(club, GolfClub)
    impulse, struck_head = ball.mass * ball_speed, club.head.replaced(**head)
    speed = ball_speed / usual_smash_factor(implement="golf-driver")
    return side_shot(struck_head, ball=ball, lateral=lateral, normal_impulse=impulse, speed=speed)


def share_of_full_gearing(*, moi: float, depth: float, lateral: float, ball_speed: float) -> float:
    """Return the spin from a head that turns, with a flat face, over that of a ball geared to it: J x C / (I R)."""
    ball = catalog.ball("golf")
    shot = _golf_shot(lateral, ball_speed, roll_moi=moi, depth=depth, bulge=None)
    return shot.spin * moi * ball.radius / (ball.mass * ball_speed * lateral * depth)


def spin_from_bulge(*, lateral: float, angle: float, ball_speed: float) -> float:
    """Return the spin that only the slant of the face gives, where it points aside by ``angle``."""
    bulged = _golf_shot(lateral, ball_speed, bulge=lateral / angle).spin
    return _golf_shot(lateral, ball_speed, bulge=None).spin - bulged


def bulged_direction(*, lateral: float, angle: float, ball_speed: float) -> float:
    """Return the direction of a ball from a face that points aside by ``angle`` there."""
    return _golf_shot(lateral, ball_speed, bulge=lateral / angle).aside


def first_node_from_tip(*, implement: str) -> float:
    """Return the node of the first mode nearest to the tip, from the tip."""
    analysis = _usual(implement)
    return analysis.bat.length - analysis.sweet_spots.node_1


def percussion_towards_hands(*, implement: str, axis: float) -> float:
    """Return the distance from the node of the first mode to the center of percussion about ``axis``, to the hands."""
    return _usual(implement).sweet_spots.node_1 - centre_of_percussion(_reduced(implement).body, pivot=axis)


def moi_about_end(*, implement: str) -> float:
    """Return the moment of inertia of an implement about the end that the hands hold."""
    return _reduced(implement).body.moi(0.0)


def swing_time_about_end(*, implement: str) -> float:
    """Return the period of an implement that swings about the end that the hands hold."""
    body = _reduced(implement).body
    return pendulum_period(body.moi(0.0), mass=body.mass, balance_point=body.balance_point, pivot=0.0)


def faster_ball(*, implement: str, share: float) -> float:
    """Return the relative gain of exit speed at the best place from a swing faster by ``share``."""
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
    """Return the distance from the middle of the face to the head's node of the first mode, towards the tip."""
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
    best, conditions = _usual(implement).best, _conditions(implement)
    return exit_speed_of(best, conditions) / conditions.swing.speed_at(best.position)


def usual_exit_speed(*, implement: str) -> float:
    """Return the greatest exit speed under the usual stroke."""
    return exit_speed_of(_usual(implement).best, _conditions(implement))


def drag_from_two_cameras(*, ball: str, air: str, speed: float, distance: float) -> float:
    """Return the drag coefficient that two level speeds a distance apart give: 2 m ln(v1 / v2) / (rho pi R^2 x)."""
    flight = sport_flight(ball=ball, air=air, speed=speed, launch_angle=math.radians(5), backspin=0.0)
    thing = catalog.ball(ball)
    along = flight.positions[:, 1]
    index = int((along < distance).sum())
    first, second = (float(flight.velocities[k][1]) for k in (0, index))
    area = math.pi * thing.radius**2
    return 2 * thing.mass * math.log(first / second) / (SHEET_AIR.density * area * float(along[index]))


SHEET_AIR = Air(temperature=(70 - 32) / 1.8)
"""70 degF, sea level."""


@cache
def sport_flight(*, ball: str, air: str, speed: float, launch_angle: float, backspin: float) -> Flight:
    """Return the flight of a ball from the ground to the ground at 70 degF and sea level."""
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

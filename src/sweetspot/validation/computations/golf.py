"""Golf: free club heads, the tests of their faces, gear effect, and what changes a drive."""

from __future__ import annotations

import math

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.simulated_club_test import head_restitution
from sweetspot.analysis.drop_test import Rebound, fire
from sweetspot.collision.closed_form import collision_efficiency
from sweetspot.collision.gear_effect import SideShot, side_shot
from sweetspot.dynamics.block import Block
from sweetspot.equipment.golf_club import ClubHead, GolfClub, stiffness_by_pendulum
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.validation.computations.sports import SHEET_AIR, sport_flight, usual_smash_factor


def _head() -> ClubHead:
    club = catalog.implement("golf-driver")
    assert isinstance(club, GolfClub)
    return club.head


def restitution_by_pendulum(*, time: float) -> float:
    """Return the restitution of the usual driver's bare head with a face of that characteristic time."""
    head = _head()
    face = head.face.replaced(stiffness=stiffness_by_pendulum(time))
    return head_restitution(head.replaced(face=face), catalog.ball("golf"))


def smash_factor(*, ball_mass: float, mass: float, restitution: float) -> float:
    """Return ball speed over head speed of a free head hit in its middle, 1 + q = (1 + e) / (1 + m / M)."""
    return 1 + collision_efficiency(restitution, recoil=ball_mass / mass)


def driven_golf(*, mass: float, speed: float) -> Rebound:
    """Return a golf ball on a wall at the speed of equal energy to a free club head of ``mass`` at ``speed``."""
    ball = catalog.ball("golf")
    wall = Block(material=catalog.material("steel"), thickness=0.1, floor_modulus=None)
    return fire(wall, ball=ball, speed=speed / math.sqrt(1 + ball.mass / mass))


def driven_golf_time(*, mass: float, speed: float) -> float:
    """Return the contact time with that head: the wall's over sqrt(1 + m/M)."""
    return driven_golf(mass=mass, speed=speed).impact.contact_time / math.sqrt(1 + catalog.ball("golf").mass / mass)


def _golf_shot(lateral: float, ball_speed: float, **head: float | None) -> SideShot:
    """Return how the usual ball leaves the usual driver's head, some of its numbers changed, at ``ball_speed``."""
    ball = catalog.ball("golf")
    impulse, struck_head = ball.mass * ball_speed, _head().replaced(**head)
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


def golf_gain(
    *,
    speed: float,
    launch_angle: float,
    backspin: float,
    share: float = 0.0,
    elevation: float = 0.0,
    warmer: float = 0.0,
) -> float:
    """Return the relative gain of a golf ball's carry by a share of speed, elevation, or warmer air and ball (K).

    A warmer ball leaves faster by the change of 1 + e.
    """
    ball, law = catalog.ball("golf"), catalog.aerodynamics("golf")
    warm = ball.conditioned(temperature=ball.reference_temperature + warmer)
    livelier = (1 + warm.restitution.reference) / (1 + ball.restitution.reference)
    carries = []
    for factor, there in (
        (1.0, SHEET_AIR),
        ((1 + share) * livelier, Air(temperature=SHEET_AIR.temperature + warmer, elevation=elevation)),
    ):
        start = batted_ball(speed=speed * factor, launch_angle=launch_angle, backspin=backspin)
        carries.append(fly(start, FlightConditions(ball=ball, aerodynamics=law, air=there)).carry)
    return carries[1] / carries[0] - 1


def golf_spin_left(*, speed: float, launch_angle: float, backspin: float, time: float) -> float:
    """Return the part of its spin that a golf ball has left after a time."""
    flight = sport_flight(ball="golf", air="golf", speed=speed, launch_angle=launch_angle, backspin=backspin)
    return float(np.linalg.norm(flight.at(time).spin)) / backspin

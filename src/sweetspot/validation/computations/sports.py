"""Other sports: the arithmetic of rackets and clubs, drop tests of rule books, forces on their balls."""

from __future__ import annotations

import math
from dataclasses import replace

from sweetspot import catalog
from sweetspot.block import Block
from sweetspot.catalog.swing_laws import swing_law
from sweetspot.collision.momentum import collision_efficiency
from sweetspot.drop import Rebound, fire
from sweetspot.rigid import RigidBody, centre_of_percussion
from sweetspot.sport_rows import rule_book_drops


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


COMPUTATIONS = (
    racket_percussion,
    percussion_gain,
    balance_gain,
    swing_weight_gain,
    smash_factor,
    efficiency_of_speed_ratio,
    rule_book_rebound,
    driven_golf_force,
    driven_golf_time,
    swing_law_loss,
)

"""The rigid bat in closed form, and the measures that laboratories use.

Speeds are positive towards each other: the ball towards the bat, the bat towards the ball. The ball leaves with
v_f = q v_ball + (1 + q) v_bat.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import cast

import numpy as np

from sweetspot.collision.contact_law import FREELY, LEAST_DAMPING
from sweetspot.dynamics.rigid import RigidBody, effective_mass
from sweetspot.equipment.ball import Ball, RestitutionLaws, RestitutionLine, restitutions_at
from sweetspot.equipment.base import Real
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS


def exit_speed(collision_efficiency: Real, *, ball_speed: float, bat_speed: Real) -> Real:
    """Return v_f = q v_ball + (1 + q) v_bat, exact for any collision by a change of frame [nathan2003, eq. 3].

    >>> round(exit_speed(0.2, ball_speed=90.0, bat_speed=70.0), 9)  # any unit of speed
    102.0
    """
    return collision_efficiency * ball_speed + (1 + collision_efficiency) * bat_speed


def collision_efficiency(restitution: Real, *, recoil: Real) -> Real:
    """Return q = (e - r) / (1 + r), r = ball mass over effective bat mass [nathan2003, eq. 6].

    >>> round(collision_efficiency(0.50, recoil=0.25), 12)
    0.2
    """
    return (restitution - recoil) / (1 + recoil)


def restitution_from_efficiency(efficiency: Real, *, recoil: Real) -> Real:
    """Return the ball-bat restitution e = q (1 + r) + r; the inverse of `collision_efficiency`.

    With r about a pivot 6 in from the knob this is BBCOR [astm_f2219].

    >>> round(restitution_from_efficiency(0.2, recoil=0.25), 12)
    0.5
    """
    return efficiency * (1 + recoil) + recoil


def bbcor(efficiency: Real, *, body: RigidBody, ball: Ball, position: Real, pivot: float = STANDARD_AXIS) -> Real:
    """Return the BBCOR of a hit: e = q (1 + r) + r with r = m z^2 / I_pivot [astm_f2219; nathan2003].

    The laboratory's bat turns in a clamp; m z^2 / I_pivot is that clamp's recoil, so a free bat's BBCOR means
    little near the clamp itself.
    """
    recoil = ball.mass * (position - pivot) ** 2 / body.moi(pivot)
    return restitution_from_efficiency(efficiency, recoil=recoil)


def rigid_efficiency(
    ball: Ball, *, body: RigidBody, position: Real, closing_speed: Real, pivot: float | None = None
) -> Real:
    """Return q of a rigid bat, free or turning about a fixed ``pivot``.

    This is the exact limit of the coupled collision without vibrations.

    Parameters
    ----------
    closing_speed : m/s, ball speed plus bat speed at the point of impact, > 0.
    """
    recoil = ball.mass / effective_mass(body, position, pivot=pivot)
    return collision_efficiency(free_restitution(ball, closing_speed=closing_speed, recoil=recoil), recoil=recoil)


def free_restitution(ball: Ball, *, closing_speed: Real, recoil: Real) -> Real:
    """Return e of a ball and a rigid body that is free to recoil.

    Without a damper the ball stores the energy mu v^2 / 2, mu = m / (1 + r), as on a wall at v / sqrt(1 + r): its
    restitution is taken there. With one it stores E = mu A(c v) / c^2 (`damped_part`), springs back as from the wall
    that stores as much, with (n + 1) E / (p + 1) = E A(-e_w c v_w) / A(c v_w), and leaves with e v, where that equals
    mu A(-c e v) / c^2.

    Parameters
    ----------
    closing_speed : v in m/s, > 0.
    recoil : r, the ball's mass over the effective mass of the body.

    >>> from sweetspot import catalog
    >>> ball = catalog.ball()
    >>> round(free_restitution(ball, closing_speed=60.0, recoil=0.0) / ball.restitution.at(60.0), 9)  # a wall
    1.0
    """
    c = ball.damping
    if c < LEAST_DAMPING:
        on_wall: Real = closing_speed / (1 + recoil) ** 0.5  # a power, not np.sqrt: plain numbers stay plain
        return ball.restitution.at(on_wall)
    found = _damped_restitution(ball.restitution, c, np.asarray(closing_speed, float), np.asarray(recoil, float))
    return cast("Real", float(found) if found.ndim == 0 else found)


def free_restitutions(balls: Sequence[Ball], *, closing_speed: Array, recoil: Array) -> Array:
    """Return e of many balls and a rigid body each, shape (balls, places); see `free_restitution`.

    Parameters
    ----------
    closing_speed, recoil : shape (balls, places).
    """
    laws = [ball.restitution for ball in balls]
    numbers = RestitutionLaws(*(np.array([[getattr(law, name)] for law in laws]) for name in RestitutionLaws._fields))
    damping = np.array([[ball.damping] for ball in balls])
    undamped = restitutions_at(numbers, closing_speed / np.sqrt(1 + recoil))
    damped = _damped_restitution(numbers, np.maximum(damping, LEAST_DAMPING), closing_speed, recoil)
    return np.where(damping < LEAST_DAMPING, undamped, damped)


def _damped_restitution(
    law: RestitutionLine | RestitutionLaws, c: float | Array, closing_speed: Array, recoil: Array
) -> Array:
    """Return `free_restitution` of balls with a damper; numbers of the law and c (s/m) broadcast with the speeds."""
    number = c * np.maximum(closing_speed, 1e-9)
    stored = (number - np.log1p(number)) / (1 + recoil)  # times m / c^2
    wall = _pressed_number(stored)
    back = np.minimum(restitutions_at(law, wall / c) * wall, FREELY)
    returned = (-back - np.log1p(-back)) * (1 + recoil)
    return np.asarray(_freed_number(np.asarray(returned)) / number)


def _pressed_number(energy: Array) -> Array:
    """Return d with d - ln(1 + d) = X, by Newton's method."""
    number = np.sqrt(2 * energy) + 2 * energy / 3
    for _ in range(6):
        number = number - (number - np.log1p(number) - energy) * (1 + number) / number
    return np.asarray(number)


def _freed_number(energy: Array) -> Array:
    """Return x with -x - ln(1 - x) = Y, by Newton's method from an upper bound, whence it never overshoots."""
    number = np.minimum(np.sqrt(2 * energy), -np.expm1(-1 - energy))
    for _ in range(12):
        number = number - (-number - np.log1p(-number) - energy) * (1 - number) / number
    return np.asarray(number)

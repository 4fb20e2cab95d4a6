"""The rigid bat in closed form, and the measures that laboratories use.

Speeds are positive towards each other: the ball towards the bat, the bat towards the ball. The ball leaves with
v_f = q v_ball + (1 + q) v_bat.
"""

from __future__ import annotations

from sweetspot.ball import Ball
from sweetspot.rigid import RigidBody, effective_mass
from sweetspot.thing import Real


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


def bbcor(efficiency: Real, *, body: RigidBody, ball: Ball, position: Real, pivot: float = 0.1524) -> Real:
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

    The ball stores the energy mu v^2 / 2, mu = m / (1 + r), as on a wall at v / sqrt(1 + r): its restitution is
    taken there. This is the exact limit of the coupled collision without vibrations.

    Parameters
    ----------
    closing_speed : m/s, ball speed plus bat speed at the point of impact, > 0.
    """
    recoil = ball.mass / effective_mass(body, position, pivot=pivot)
    wall_speed: Real = closing_speed / (1 + recoil) ** 0.5  # a power, not np.sqrt: plain numbers stay plain
    restitution = ball.restitution.at(wall_speed)
    return collision_efficiency(restitution, recoil=recoil)

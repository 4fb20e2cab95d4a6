"""A ball that comes at a slant in the plane of bat and path: how far it travels along the bat while they touch.

The plane holds the bat's axis and the bat's normal; ``angle`` is measured from the normal, positive when the ball
moves towards the tip. The normal part of the collision is whatever `coupled.hit` found for the normal speed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from sweetspot.ball import Ball
from sweetspot.collision.impact import Impact
from sweetspot.errors import InputError
from sweetspot.rigid import RigidBody

Contact = Literal["smooth", "grip", "cling"]

FRICTION = 0.20
"""Ball on wood, at least 0.15 to 0.20 [kensrud2017]."""
TANGENTIAL_RESTITUTION = 0.405
"""e_x of a baseball, 0.405 +- 0.010 [kensrud2017]; 0 is rolling, -1 no friction."""
SPHERE = 2 / 5
"""I / (m r^2) of a uniform ball."""


@dataclass(frozen=True)
class ObliqueImpact:
    """What an oblique hit adds to its normal part.

    Parameters
    ----------
    normal_speed, along_speed : m/s of the ball before contact, decomposed.
    along_speed_after : m/s along the bat when it leaves, positive towards the tip.
    spin : rad/s about the axis across the bat, given by friction.
    travel : m that the ball moves along the bat between touch and release.
    gripped : whether friction was enough to stop the sliding.
    """

    normal_speed: float
    along_speed: float
    along_speed_after: float
    spin: float
    travel: float
    gripped: bool


def decompose(speed: float, angle: float) -> tuple[float, float]:
    """Return (normal, along) parts of a ball's speed: v cos(alpha), v sin(alpha) [paper2014, eq. 3-4].

    The paper prints the same symbol for both parts and calls the sine part the one along the bat, as here.

    >>> [round(part, 9) for part in decompose(40.0, 0.0)]
    [40.0, 0.0]
    """
    if not -math.pi / 2 < angle < math.pi / 2:
        raise InputError(
            f"entry angle is {math.degrees(angle):.4g} deg from the bat's normal; allowed is more than -90 and less "
            "than 90 deg"
        )
    return speed * math.cos(angle), speed * math.sin(angle)


def oblique(
    impact: Impact,
    *,
    ball: Ball,
    body: RigidBody,
    ball_speed: float,
    angle: float,
    contact: Contact = "grip",
    friction: float = FRICTION,
    tangential_restitution: float = TANGENTIAL_RESTITUTION,
) -> ObliqueImpact:
    """Return the motion along the bat that goes with a normal impact.

    Friction acts in step with the normal force: J_t(t) = J_t P(t), P the part of the normal impulse given so far.
    Gripping: J_t = m_t (1 + e_x) v_t with 1/m_t = (1 + 5/2)/m + 1/M for ball (rolling) and bat (sliding along its
    axis); never more than friction times the normal impulse. Travel S = v_t T - (J_t / m) int P dt.

    Parameters
    ----------
    impact : the normal part, from a closing speed that holds v cos(angle).
    ball_speed, angle : m/s and rad of the ball before contact.
    contact : "smooth" (no friction: the paper's elastic limit, S = v sin(alpha) T), "grip" (real), or "cling" (ball
        and bat move as one from first touch: the paper's plastic limit, S = 0).
    """
    normal, along = decompose(ball_speed, angle)
    if contact == "cling":
        return ObliqueImpact(normal, along, 0.0, 0.0, 0.0, gripped=True)
    impulse = np.concatenate([[0.0], np.cumsum(np.diff(impact.times) * (impact.force[1:] + impact.force[:-1]) / 2)])
    total = float(impulse[-1])
    tangential_mass = 1 / ((1 + 1 / SPHERE) / ball.mass + 1 / body.mass)
    wanted = tangential_mass * (1 + tangential_restitution) * abs(along)
    limit = 0.0 if contact == "smooth" else friction * total
    given = math.copysign(min(wanted, limit), along)
    progress = float(np.trapezoid(impulse, impact.times)) / total
    progress += impact.release_time - float(impact.times[-1])
    after = along - given / ball.mass
    return ObliqueImpact(
        normal_speed=normal,
        along_speed=along,
        along_speed_after=after,
        spin=given / (SPHERE * ball.mass * ball.radius),
        travel=along * impact.release_time - given / ball.mass * progress,
        gripped=contact == "grip" and wanted <= limit,
    )

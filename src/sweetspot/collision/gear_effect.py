"""A ball that meets a club head toward its toe or heel: the head turns, and friction turns the ball the other way."""

from __future__ import annotations

import math
from typing import NamedTuple

from sweetspot.collision.oblique_contact import FRICTION, SPHERE
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.golf_club import ClubHead


class SideShot(NamedTuple):
    """How a ball leaves a head in the horizontal plane.

    Parameters
    ----------
    aside : rad, to the side of the face where it was hit.
    spin : rad/s about the vertical; above zero it curves the ball back toward the middle line.
    """

    aside: float
    spin: float


def side_shot(
    head: ClubHead, *, ball: Ball, lateral: float, normal_impulse: float, speed: float, tilt: float = 0.0
) -> SideShot:
    """Return direction and side spin of a ball that a free head hits at ``lateral`` m from its middle.

    In the plane of toe and target the face's normal points to the side by delta = lateral / bulge + tilt. The contact
    lies at (lateral, depth) from the head's center of gravity, I is about the vertical through it. With a_t = depth
    cos delta + lateral sin delta and a_n = depth sin delta - lateral cos delta, the face slides on the ball by

        s = -v sin delta - J_n a_n a_t / I
        J_t = (1 + e_x) s / (7 / (2 m) + 1 / M + a_t^2 / I), at most mu J_n

    The first part is the slant of the bulge, the second the head that turns ("gear effect"). The ball leaves along J_n
    n + J_t t, with spin 5 J_t / (2 m R). That what slides during contact comes back with e_x too is assumed.

    Parameters
    ----------
    normal_impulse : J_n, N s.
    speed : v, m/s of the head against the ball.
    tilt : rad by which the head has turned, averaged with the force of the hit.

    Assumptions: the ball does not spin before, the shaft does nothing in half a millisecond, and loft is left out.
    """
    delta = (lateral / head.bulge if head.bulge is not None else 0.0) + tilt
    sine, cosine = math.sin(delta), math.cos(delta)
    around, outward = head.depth * cosine + lateral * sine, head.depth * sine - lateral * cosine
    slip = -speed * sine - normal_impulse * outward * around / head.roll_moi
    give = (1 + 1 / SPHERE) / ball.mass + 1 / head.mass + around**2 / head.roll_moi
    returned = head.face.tangential_restitution or 0.0
    limit = (FRICTION if head.face.friction is None else head.face.friction) * normal_impulse
    rubbed = max(-limit, min(limit, (1 + returned) * slip / give))
    across, forward = normal_impulse * sine + rubbed * cosine, normal_impulse * cosine - rubbed * sine
    side = math.copysign(1.0, lateral) if lateral else 0.0
    return SideShot(side * math.atan2(across, forward), side * rubbed / (SPHERE * ball.mass * ball.radius))

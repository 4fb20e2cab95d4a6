"""A ball that comes at a slant: friction, the ball's way on the bat while they touch, and how it leaves.

Whatever `coupled.hit` or `kernel.hits` found for the closing speed along the line of centres is the normal part.
Here the rest is added: friction along and around the bat, in step with the normal force. `oblique` is the paper's
case in the plane of the bat's axis; `launch` is the general one in space.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.ball import Ball
from sweetspot.collision.impact import Impact
from sweetspot.errors import InputError
from sweetspot.rigid import RigidBody

Array = NDArray[np.float64]
Contact = Literal["smooth", "grip", "cling"]

FRICTION = 0.20
"""Ball on wood, at least 0.15 to 0.20 [kensrud2017]."""
TANGENTIAL_RESTITUTION = 0.30
"""e_x of a baseball on a clamped wooden cylinder, 0.30 +- 0.02 [nathan2012oblique]; 0 is rolling, -1 no friction.

On free bats 0.405 +- 0.010 was found [kensrud2017] together with a bat's r_x of about 0.295. What was measured is the
spin, that is (1 + e_x)/(1 + r_x) = 1.085. Our exact roll inertia of a solid bat gives r_x = 0.19, and 0.30 then gives
1.09: the same spin, and the value of the clamped cylinder, where no bat's inertia enters."""
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


class Launch(NamedTuple):
    """How balls leave; one row per hit.

    Parameters
    ----------
    velocity, spin : m/s and rad/s, shape (..., 3).
    around, along : N s of friction on the ball around the bat (upwards in front of it) and along it (to the tip).
    gripped : whether friction was enough to stop the sliding.
    """

    velocity: Array
    spin: Array
    around: Array
    along: Array
    gripped: NDArray[np.bool_]


class ContactFrame(NamedTuple):
    """Unit vectors at the point of contact, shape (..., 3): out of the bat, around it and along it to the tip."""

    normal: Array
    around: Array
    along: Array


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


def friction_impulse(
    slip: ArrayLike,
    *,
    recoil: ArrayLike,
    ball_mass: float,
    normal_impulse: ArrayLike,
    friction: float = FRICTION,
    tangential_restitution: float = TANGENTIAL_RESTITUTION,
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the friction impulse on the ball (N s) and whether the contact gripped.

    Gripping turns every slip s into -e_x s: J_i = (1 + e_x) s_i / ((1 + 5/2)/m + K_i), the sphere's own give by
    moving and turning plus the bat's K_i. That is (1 + e_x)/(1 + r_x) of [kensrud2017], r_x = K_i m (2/5)/(7/5).
    Never more than friction times the normal impulse in all; then it keeps its direction.

    Parameters
    ----------
    slip : m/s, speed of the bat's surface past the ball's, shape (..., directions).
    recoil : 1/kg, speed that one N s gives the bat's surface in each direction, same shape.
    normal_impulse : N s, shape (...).
    """
    wanted = (1 + tangential_restitution) * np.asarray(slip) / ((1 + 1 / SPHERE) / ball_mass + np.asarray(recoil))
    size = np.sqrt(np.sum(wanted**2, axis=-1))
    limit = friction * np.asarray(normal_impulse)
    gripped = size <= limit
    part = np.where(gripped, 1.0, limit / np.where(size > 0, size, 1.0))
    return wanted * part[..., None], gripped


def contact_frame(forward: Array, up: Array, tip: Array, *, lift: ArrayLike) -> ContactFrame:
    """Return the directions at contact of a swing whose line of centres rises by ``lift`` rad above its path.

    Parameters
    ----------
    forward, up, tip : unit vectors of the swing, shape (..., 3), as in `sweetspot.swing_path.PathAxes`.
    """
    cos, sin = np.cos(lift)[..., None], np.sin(lift)[..., None]
    return ContactFrame(cos * forward + sin * up, cos * up - sin * forward, tip)


def launch(
    frame: ContactFrame,
    *,
    ball: Ball,
    ball_velocity: Array,
    ball_spin: Array,
    bat_velocity: Array,
    normal_impulse: ArrayLike,
    recoil_around: ArrayLike,
    recoil_along: ArrayLike,
    friction: float = FRICTION,
    tangential_restitution: float = TANGENTIAL_RESTITUTION,
) -> Launch:
    """Return velocity and spin of a ball after an oblique hit in space.

    v' = v + (J_n n + J_f)/m, omega' = omega - r n x J_f / ((2/5) m r^2): every impulse acts at the point of contact,
    so the ball keeps its angular momentum about that point.

    Parameters
    ----------
    frame : directions at contact.
    ball_velocity, ball_spin, bat_velocity : m/s and rad/s before contact, shape (..., 3), the bat's at the point of
        contact. Its surface, a radius ahead of its axis, also moves towards the hands by about 1.5 m/s as the bat
        turns; that is left out, as in the published models.
    normal_impulse : N s, m (1 + q) times the closing speed along the normal.
    recoil_around, recoil_along : 1/kg, what one N s of friction gives the bat's surface; see `recoil_across`.
    """
    arm = -ball.radius * frame.normal
    past = bat_velocity - ball_velocity - np.cross(ball_spin, arm)
    slip = np.stack([np.sum(past * frame.around, axis=-1), np.sum(past * frame.along, axis=-1)], axis=-1)
    given, gripped = friction_impulse(
        slip,
        recoil=np.stack(np.broadcast_arrays(recoil_around, recoil_along), axis=-1),
        ball_mass=ball.mass,
        normal_impulse=normal_impulse,
        friction=friction,
        tangential_restitution=tangential_restitution,
    )
    rubbed = given[..., :1] * frame.around + given[..., 1:] * frame.along
    pushed = np.asarray(normal_impulse)[..., None] * frame.normal
    return Launch(
        velocity=ball_velocity + (pushed + rubbed) / ball.mass,
        spin=ball_spin + np.cross(arm, rubbed) / (SPHERE * ball.mass * ball.radius**2),
        around=given[..., 0],
        along=given[..., 1],
        gripped=gripped,
    )


def recoil_across(shape: Array, velocity: Array, *, normal_impulse: ArrayLike) -> Array:
    """Return the speed of the bat's axis per N s of normal impulse when the ball leaves, 1/kg.

    sum_i shape_i p_i / J over the rigid and bending modes: 1/M + b^2/I_cm of a rigid bat, plus its vibration. The
    bat is round, so friction in step with the normal force shakes it the same way in the second plane.

    Parameters
    ----------
    shape : of those modes at the point of impact, 1/sqrt(kg), shape (..., n).
    velocity : modal velocities when the ball leaves, sqrt(kg) m/s, shape (..., n).
    """
    return np.asarray(np.sum(shape * velocity, axis=-1) / np.asarray(normal_impulse))


def travel(impact: Impact, *, ball: Ball, speed: float, impulse: float) -> float:
    """Return how far the ball's centre moves past the bat between touch and release, m.

    S = v T + (J/m) int P dt with P(t) the part of the normal impulse given so far: friction goes in step with it.

    Parameters
    ----------
    speed, impulse : m/s of the ball past the bat before contact, and N s of friction on it in the same direction.
    """
    given = np.concatenate([[0.0], np.cumsum(np.diff(impact.times) * (impact.force[1:] + impact.force[:-1]) / 2)])
    progress = float(np.trapezoid(given, impact.times)) / float(given[-1])
    progress += impact.release_time - float(impact.times[-1])
    return speed * impact.release_time + impulse / ball.mass * progress


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
    """Return the motion along the bat that goes with a normal impact, in the plane of bat and path.

    Friction meets the ball's rolling and the bat's sliding along its axis, K = 1/M; see `friction_impulse`.

    Parameters
    ----------
    impact : the normal part, from a closing speed that holds v cos(angle).
    ball_speed, angle : m/s and rad of the ball before contact; the angle from the bat's normal, positive when the
        ball moves towards the tip.
    contact : "smooth" (no friction: the paper's elastic limit, S = v sin(alpha) T), "grip" (real), or "cling" (ball
        and bat move as one from first touch: the paper's plastic limit, S = 0).
    """
    normal, along = decompose(ball_speed, angle)
    if contact == "cling":
        return ObliqueImpact(normal, along, 0.0, 0.0, 0.0, gripped=True)
    impulses, gripped = friction_impulse(
        [-along],
        recoil=[1 / body.mass],
        ball_mass=ball.mass,
        normal_impulse=float(np.trapezoid(impact.force, impact.times)),
        friction=0.0 if contact == "smooth" else friction,
        tangential_restitution=tangential_restitution,
    )
    given = float(impulses[0])
    return ObliqueImpact(
        normal_speed=normal,
        along_speed=along,
        along_speed_after=along + given / ball.mass,
        spin=-given / (SPHERE * ball.mass * ball.radius),
        travel=travel(impact, ball=ball, speed=along, impulse=given),
        gripped=contact == "grip" and bool(gripped),
    )

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

from sweetspot.collision.impact import Impact
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing_path import PathAxes
from sweetspot.numerics.arrays import Array

Rubbing = Literal["smooth", "grip", "cling"]

FRICTION = 0.20
"""Ball on wood, at least 0.15 to 0.20 [kensrud2017]."""
TANGENTIAL_RESTITUTION = 0.30
"""e_x of a baseball on a clamped wooden cylinder, 0.30 +- 0.02 [nathan2012oblique]; 0 is rolling, -1 no friction.

On free bats 0.405 +- 0.010 was found [kensrud2017] together with a bat's r_x of about 0.295. What was measured is the
spin, that is (1 + e_x)/(1 + r_x) = 1.085. Our exact roll inertia of a solid bat gives r_x = 0.19, and 0.30 then gives
1.09: the same spin, and the value of the clamped cylinder, where no bat's inertia enters."""
SPHERE = 2 / 5
"""I / (m r^2) of a uniform ball."""


class Friction(NamedTuple):
    """Friction between ball and bat.

    Parameters
    ----------
    coefficient : of friction, >= 0.
    tangential_restitution : e_x, part of the slip that comes back: 0 is rolling, -1 no friction.
    """

    coefficient: float = FRICTION
    tangential_restitution: float = TANGENTIAL_RESTITUTION


USUAL_FRICTION = Friction()
NO_FRICTION = Friction(coefficient=0.0)


@dataclass(frozen=True)
class ObliqueImpact:
    """Tangential part of an oblique hit, beside its normal part.

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


class SurfaceMobility(NamedTuple):
    """Mobility of the bat's surface at the point of contact, speed per impulse, 1/kg, each of shape (...).

    The bat is round and pushed at its surface, a radius R from its axis: a push along the line of centres also turns
    the front of the barrel towards the tip, and a push along the bat also moves it to and fro.

    Parameters
    ----------
    normal, around, along : in the direction of the push.
    coupling : towards the tip per N s that the ball gives along the line of centres; and, as every mobility is
        symmetric, towards the ball per N s of friction that drags the ball to the tip.
    """

    normal: ArrayLike
    around: ArrayLike
    along: ArrayLike
    coupling: ArrayLike = 0.0


class Impulses(NamedTuple):
    """Impulses on a ball at the point of contact, each of shape (...).

    Parameters
    ----------
    normal : N s along the line of centres.
    around, along : N s of friction around the bat (upwards in front of it) and along it (to the tip).
    gripped : whether friction was enough to stop the sliding.
    """

    normal: Array
    around: Array
    along: Array
    gripped: NDArray[np.bool_]


class Launch(NamedTuple):
    """Motion of balls after the hit; one row per hit.

    Parameters
    ----------
    velocity, spin : m/s and rad/s, shape (..., 3).
    impulses : what the bat gave.
    """

    velocity: Array
    spin: Array
    impulses: Impulses


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


def contact_impulses(
    slip_around: ArrayLike,
    slip_along: ArrayLike,
    *,
    give: SurfaceMobility,
    ball_mass: float,
    normal_impulse: ArrayLike,
    friction: Friction = USUAL_FRICTION,
) -> Impulses:
    """Return the impulses on the ball of a contact with friction.

    Gripping turns every slip s into -e_x s. With B = (1 + 5/2)/m + K, the sphere's own give by moving and turning
    plus the bat's K, and A = 1/m + K_n:

        B_t J_t = (1 + e_x) s_t
        B_a J_a = (1 + e_x) s_a + C J_n
        J_n = J_0 + (C / A) J_a

    J_0 is the normal impulse without friction. The first line is (1 + e_x)/(1 + r_x) of [kensrud2017], r_x =
    K m (2/5)/(7/5). What the normal push itself slides during contact, C J_n, is stopped and not returned: no
    measurement tells. Friction is never more than its coefficient times the normal impulse in all; then it keeps its
    direction, in step with the normal force. For rigid bodies this is Newton's and Euler's law with all six degrees
    of freedom of each.

    Parameters
    ----------
    slip_around, slip_along : m/s, speed of the bat's surface past the ball's before contact, shape (...).
    normal_impulse : N s, J_0, shape (...).
    """
    before, coupling = np.asarray(normal_impulse, float), np.asarray(give.coupling, float)
    sphere = (1 + 1 / SPHERE) / ball_mass
    raised = coupling / (1 / ball_mass + np.asarray(give.normal))
    limit, returned = friction.coefficient, 1 + friction.tangential_restitution
    around = returned * np.asarray(slip_around) / (sphere + np.asarray(give.around))
    pulled = returned * np.asarray(slip_along) + coupling * before
    along = pulled / (sphere + np.asarray(give.along) - coupling * raised)
    normal = before + raised * along
    size = np.hypot(around, along)
    gripped = size <= limit * normal
    toward = along / np.where(size > 0, size, 1.0)
    normal = np.where(gripped, normal, before / (1 - limit * raised * toward))
    part = np.where(gripped, 1.0, limit * normal / np.where(gripped, 1.0, size))
    return Impulses(normal, around * part, along * part, gripped)


def contact_frame(forward: Array, up: Array, tip: Array, *, lift: ArrayLike) -> ContactFrame:
    """Return the directions at contact of a swing whose line of centres rises by ``lift`` rad above its path.

    Parameters
    ----------
    forward, up, tip : unit vectors of the swing, shape (..., 3), as in `sweetspot.motion.swing_path.PathAxes`.
    """
    cos, sin = np.cos(lift)[..., None], np.sin(lift)[..., None]
    return ContactFrame(cos * forward + sin * up, cos * up - sin * forward, tip)


def launch(
    frame: ContactFrame,
    *,
    ball: Ball,
    pitch: BallMotion | BallMotions,
    surface_velocity: Array,
    normal_impulse: ArrayLike,
    give: SurfaceMobility,
    friction: Friction = USUAL_FRICTION,
) -> Launch:
    """Return velocity and spin of a ball after an oblique hit in space.

    v' = v + (J_n n + J_f)/m, omega' = omega - r n x J_f / ((2/5) m r^2): every impulse acts at the point of contact,
    so the ball keeps its angular momentum about that point.

    Parameters
    ----------
    surface_velocity : m/s before contact, shape (..., 3), of the bat where it is touched; see `turning_surface`.
    normal_impulse : N s without friction, m (1 + q) times the closing speed along the normal.
    """
    arm = -ball.radius * frame.normal
    ball_velocity, ball_spin = np.asarray(pitch.velocity, float), np.asarray(pitch.spin, float)
    past = surface_velocity - ball_velocity - np.cross(ball_spin, arm)
    given = contact_impulses(
        np.sum(past * frame.around, axis=-1),
        np.sum(past * frame.along, axis=-1),
        give=give,
        ball_mass=ball.mass,
        normal_impulse=normal_impulse,
        friction=friction,
    )
    rubbed = given.around[..., None] * frame.around + given.along[..., None] * frame.along
    pushed = given.normal[..., None] * frame.normal
    return Launch(
        velocity=ball_velocity + (pushed + rubbed) / ball.mass,
        spin=ball_spin + np.cross(arm, rubbed) / (SPHERE * ball.mass * ball.radius**2),
        impulses=given,
    )


def turning_surface(frame: ContactFrame, axes: PathAxes, *, angular_speed: ArrayLike, radius: ArrayLike) -> Array:
    """Return the velocity of the bat's surface at the contact relative to its axis, m/s, shape (..., 3).

    omega x R n: the front of a bat that turns by ``angular_speed`` in the plane of its path moves towards the hands,
    by about 1.4 m/s.

    Parameters
    ----------
    angular_speed, radius : rad/s of the swing and m of the bat, shape (...).
    """
    spin = np.asarray(angular_speed)[..., None] * np.cross(axes.tip, axes.forward)
    return np.cross(spin, np.asarray(radius)[..., None] * frame.normal)


def bat_give(
    modes: Modes, body: RigidBody, *, position: ArrayLike, radius: ArrayLike, velocity: Array, normal_impulse: ArrayLike
) -> SurfaceMobility:
    """Return the give of a round bat from how a normal impulse has left its modes moving.

    With s_i the shapes at the point of impact, p_i the modal velocities when the ball leaves, over the impulse, and R
    the radius: normal sum s_i p_i, over the hoop modes too; around sum s_i p_i over the beam's modes, the same in the
    second plane of a round bat, plus R^2/I_roll; coupling R sum s_i' p_i, as a tilted section carries its surface
    along. Of a rigid bat these are 1/M + b^2/I_cm, the same plus R^2/I_roll, and b R/I_cm. Along the bat
    1/M + R^2/I_cm; what its bending would add there is left out, 2 % of the sphere's own give.

    Parameters
    ----------
    position, radius : m, of shape (...).
    velocity : modal velocities when the ball leaves, sqrt(kg) m/s, shape (..., n).
    """
    size = np.asarray(radius, float)
    normal, around, tilting = spring_mobilities(
        modes, position=position, velocity=velocity, normal_impulse=normal_impulse
    )
    return SurfaceMobility(
        normal=normal,
        around=around + size**2 / body.roll_moi,
        along=1 / body.mass + size**2 / body.moi_cm,
        coupling=size * tilting,
    )


def spring_mobilities(
    modes: Modes, *, position: ArrayLike, velocity: Array, normal_impulse: ArrayLike
) -> tuple[Array, Array, Array]:
    """Return the modes' part of a bat's mobility along the line of centres, around the bat and in tilting.

    sum s_i p_i over all modes, over the beam's, and sum s_i' p_i over the beam's: 1/kg, 1/kg and 1/(kg m).

    Parameters
    ----------
    position, velocity, normal_impulse : as in `bat_give`.
    """
    places = np.asarray(position, float)
    beam = [index for index, family in enumerate(modes.families) if family != "hoop"]
    per_impulse = velocity / np.asarray(normal_impulse)[..., None]
    shape, slope = modes.shape_at(places), modes.slope_at(places)
    return (
        np.sum(shape * per_impulse, axis=-1),
        np.sum((shape * per_impulse)[..., beam], axis=-1),
        np.sum((slope * per_impulse)[..., beam], axis=-1),
    )


def travel(impact: Impact, *, ball: Ball, speed: float, impulse: float) -> float:
    """Return the distance that the ball's centre moves past the bat between touch and release, m.

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
    rubbing: Rubbing = "grip",
    friction: Friction = USUAL_FRICTION,
) -> ObliqueImpact:
    """Return the motion along the bat that goes with a normal impact, in the plane of bat and path.

    Friction meets the ball's rolling and the bat's sliding along its axis, K = 1/M; see `contact_impulses`. The paper's
    bat is a line: what a round bat's front does beside (`Give.coupling`) is `launch`'s.

    Parameters
    ----------
    impact : the normal part, from a closing speed that holds v cos(angle).
    ball_speed, angle : m/s and rad of the ball before contact; the angle from the bat's normal, positive when the
        ball moves towards the tip.
    rubbing : "smooth" (no friction: the paper's elastic limit, S = v sin(alpha) T), "grip" (real), or "cling" (ball
        and bat move as one from first touch: the paper's plastic limit, S = 0).
    """
    normal, along = decompose(ball_speed, angle)
    if rubbing == "cling":
        return ObliqueImpact(normal, along, 0.0, 0.0, 0.0, gripped=True)
    given = contact_impulses(
        0.0,
        -along,
        give=SurfaceMobility(normal=0.0, around=0.0, along=1 / body.mass),
        ball_mass=ball.mass,
        normal_impulse=float(np.trapezoid(impact.force, impact.times)),
        friction=NO_FRICTION if rubbing == "smooth" else friction,
    )
    rubbed = float(given.along)
    return ObliqueImpact(
        normal_speed=normal,
        along_speed=along,
        along_speed_after=along + rubbed / ball.mass,
        spin=-rubbed / (SPHERE * ball.mass * ball.radius),
        travel=travel(impact, ball=ball, speed=along, impulse=rubbed),
        gripped=rubbing == "grip" and bool(given.gripped),
    )

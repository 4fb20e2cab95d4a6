"""How a racket handles, in the numbers that its people compare: swing, recoil and twist weight, MGR/I, polarization."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, NamedTuple

from sweetspot.analysis.bat_analysis import exit_speed_of, hit_at
from sweetspot.answers.records import Angle, Length, MomentOfInertia, Ratio, Speed, Spin
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.collision.aside import aside_angle, mean_tilt
from sweetspot.collision.gear_effect import side_shot
from sweetspot.collision.impact import Impact
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.numerics.interval import Number
from sweetspot.units import INCH
from sweetspot.units.dimensions import PER_SECOND_SQUARED

BESIDE = {"cm": (0.03, 0.05), "in": (0.5 * INCH, INCH)}
"""m beside the line at which a hit off center is answered, by the unit of places of a sport [our choice]."""


@dataclass(frozen=True)
class Handling:
    """How a racket handles; see `handling_of`.

    ``axis``: from the butt, of the swing weight, I_axis. ``recoil_weight``: I_cm, about the balance point.
    ``twist_weight``: about its line. ``mgr_over_i``: M g R / I, R and I from the butt, the square of the rate of a
    pendulum that hangs there. ``polarization``: recoil weight over that of an even rod of its mass and length,
    M L^2 / 12; above 1 the mass sits at the ends [our choice] of how to say so.
    """

    swing_weight: MomentOfInertia
    axis: Length
    recoil_weight: MomentOfInertia
    twist_weight: MomentOfInertia
    mgr_over_i: Annotated[Number, PER_SECOND_SQUARED]
    polarization: Ratio


@dataclass(frozen=True)
class HitBeside:
    """A hit beside the line: ``lateral`` m to either side; ``aside``: the angle to that side at which the ball goes.

    ``gear_spin``: of a golf ball about the vertical, above zero where it curves back; None: of other balls.
    """

    position: Length
    lateral: Length
    exit_speed: Speed
    aside: Angle
    gear_spin: Spin | None = None


def handling_of(implement: Implement, body: RigidBody) -> Handling | None:
    """Return how a racket handles; None for what has no swing weight and no face.

    >>> from sweetspot import catalog, rigid_body
    >>> racket = catalog.implement("tennis-racket")
    >>> numbers = handling_of(racket, rigid_body(racket))
    >>> round(1e4 * numbers.recoil_weight, 1)  # 320 kg cm^2 less 0.318 kg x (22.5 cm)^2
    159.0
    >>> round(numbers.mgr_over_i, 2)  # 0.318 kg x 980.7 cm/s^2 x 32.5 cm over 495 kg cm^2
    20.48
    """
    convention = swing_weight(implement.sport)
    if implement.outline is None or convention.name != "swing weight" or convention.order != 2:
        return None
    return Handling(
        swing_weight=body.moi(convention.axis),
        axis=convention.axis,
        recoil_weight=body.moi_cm,
        twist_weight=body.roll_moi,
        mgr_over_i=body.mass * STANDARD_GRAVITY * body.balance_point / body.moi(0.0),
        polarization=body.moi_cm / (body.mass * implement.length**2 / 12),
    )


class Direction(NamedTuple):
    """Where a ball goes that met a face beside its line; see `HitBeside`."""

    aside: float
    gear_spin: float | None


def direction(implement: Implement, body: RigidBody, impact: Impact, conditions: Conditions) -> Direction | None:
    """Return the direction of the ball after a hit; None on the line, and for what is round.

    A club head is free and turns about a point far behind its face, which is bulged: see `side_shot`. Other faces turn
    about their own line: see `aside_angle`.
    """
    if not impact.lateral or implement.face is None:
        return None
    leaves = exit_speed_of(impact, conditions)
    if isinstance(implement, GolfClub):
        push = conditions.ball.mass * impact.closing_speed * (1 + impact.collision_efficiency)
        tilt = mean_tilt(impact, roll_moi=implement.head.roll_moi)
        speed = impact.closing_speed
        shot = side_shot(
            implement.head, ball=conditions.ball, lateral=impact.lateral, normal_impulse=push, speed=speed, tilt=tilt
        )
        return Direction(*shot)
    return Direction(aside_angle(impact, roll_moi=body.roll_moi, face=implement.face, leaves_at=leaves), None)


def hits_beside(implement: Implement, body: RigidBody, modes: Modes, conditions: Conditions) -> tuple[HitBeside, ...]:
    """Return hits at `BESIDE` beside the middle of a face, as far as they are on it; none for a round bat."""
    if implement.outline is None or implement.face is None:
        return ()
    position, found = implement.outline.middle, []
    for lateral in BESIDE[sport(implement.sport).words.place_unit]:
        if implement.outline.holds(position, lateral):
            impact = hit_at(position, modes=modes, conditions=conditions, lateral=lateral)
            way = direction(implement, body, impact, conditions)
            assert way is not None, "it is beside the line"
            found.append(HitBeside(position, lateral, exit_speed_of(impact, conditions), *way))
    return tuple(found)

"""The implemented paper's chain of arguments, as functions: its equations, its numbers.

Source: "Baseball best hitting point model research based on momentum medium theorem" [paper2014]. Its printed
``1 + x`` in equations 5 to 11 is ``l + x``; the same letter stands for different things in different sections, so
names here are words. `sweetspot.papers.chain` puts each statement beside the full model.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated

from sweetspot.collision.contact_law import loading_force
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_GRAVITY

PAPER_BALL_RESTITUTION, PAPER_WOOD_RESTITUTION, PAPER_METAL_RESTITUTION = 0.45, 0.45, 0.9
PAPER_WOOD_SHARE, PAPER_METAL_SHARE = 0.02, 0.10


Value = float | str | None


@dataclass(frozen=True)
class PaperRow:
    """One statement: the paper's number or claim, its formula evaluated here, the full model's answer.

    Parameters
    ----------
    name : of what is stated, by which `sweetspot.reports.paper.statements` has its words.
    facts : numbers in SI, words and conditions that stand in these.
    """

    equation: str
    name: str
    unit: str
    paper: Value
    computed: Value
    full_model: Value
    facts: Annotated[Mapping[str, object], "internal"] = field(default_factory=dict)


def path_acceleration(force: float, *, angle: float, ball_mass: float) -> float:
    """Return the ball's acceleration along its path in m/s^2, a = F cos(alpha) / m [paper2014, eq. 1].

    Parameters
    ----------
    force : N, along the bat's normal.
    angle : rad between path and normal.
    """
    return force * math.cos(angle) / ball_mass


def path_radius(force: float, *, angle: float, ball_mass: float, speed: float) -> float:
    """Return the radius in m on which the ball's path bends, r = m v^2 / (F sin(alpha)) [paper2014, eq. 2].

    Holds at one instant only: the force rises and falls within a millisecond. Infinite for a straight hit.
    """
    across = force * math.sin(angle)
    return math.inf if across == 0 else ball_mass * speed**2 / abs(across)


def rod(length: float, mass: float) -> RigidBody:
    """Return the paper's bat: a thin uniform rod, J_C = m L^2 / 12, without thickness."""
    return RigidBody(mass=mass, balance_point=length / 2, moi_cm=mass * length**2 / 12, roll_moi=0.0)


def best_point_beyond_centre(body: RigidBody, *, hands: float) -> float:
    """Return x = J_C / (m l) in m: how far beyond the mass centre a blow leaves the hands at rest [paper2014, eq. 10].

    l is the distance from the hands to the mass centre. The paper gives b = l + x from the hands [eq. 11]; the
    place itself is `sweetspot.dynamics.rigid.centre_of_percussion`.

    >>> round(best_point_beyond_centre(rod(0.84, 0.9), hands=0.0), 6)  # a sixth of the rod
    0.14
    """
    arm = body.balance_point - hands
    if arm <= 0:
        raise InputError(f"hands at {hands:.4g} m are beyond the mass centre at {body.balance_point:.4g} m")
    return body.moi_cm / (body.mass * arm)


def turning_per_blow(body: RigidBody, position: float, *, hands: float) -> float:
    """Return the angular speed about the hands per N s of blow, (l + x) / (J_C + m l^2) [paper2014, eq. 5, 6].

    The paper prints 1 + x and a unit impulse delta(t), so its alpha is an angular speed.

    >>> round(turning_per_blow(rod(0.84, 0.9), 0.84, hands=0.0), 6)  # 3 / (m L) of a rod hit at its end
    3.968254
    """
    arm = body.balance_point - hands
    return (position - hands) / (body.moi_cm + body.mass * arm**2)


def centre_speed_per_blow(body: RigidBody, position: float, *, hands: float) -> float:
    """Return the speed of the mass centre per N s of blow, l (l + x) / (J_C + m l^2), 1/kg [paper2014, eq. 7, 8].

    The hands give what is missing: F = I - m a_c, which is equation 9.
    """
    return (body.balance_point - hands) * turning_per_blow(body, position, hands=hands)


def hand_force_ratio(body: RigidBody, position: float, *, hands: float) -> float:
    """Return F / I = (J_C - m x l) / (J_C + m l^2), hand force over blow [paper2014, eq. 9].

    The same number as `sweetspot.dynamics.rigid.hand_impulse_ratio`, written as the paper writes it.
    """
    arm, beyond = body.balance_point - hands, position - body.balance_point
    return (body.moi_cm - body.mass * beyond * arm) / (body.moi_cm + body.mass * arm**2)


def mean_force(ball_mass: float, *, speed_change: float, contact_time: float) -> float:
    """Return the mean force in N from F t = m (v2 - v1) [paper2014, eq. 14].

    >>> round(mean_force(0.145, speed_change=200 * 0.44704, contact_time=0.7e-3), -1)
    18520.0
    """
    return ball_mass * speed_change / contact_time


def spring_force(stiffness: float, deformation: float) -> float:
    """Return F = k x in N [paper2014, eq. 13]. A softer k with a larger x need not give a larger force."""
    return stiffness * deformation


def energy_returned(*, bat_restitution: float, ball_restitution: float, share: float) -> float:
    """Return W = k_bat^2 z + k_ball^2 (1 - z), the part of the stored energy that comes back [paper2014].

    Two springs in series under one force: the bat holds the share z = k_b / (k_b + k_w) of the energy (k_b, k_w
    stiffness of ball and bat), and each gives back the square of its own restitution. W is e^2 of the pair and not
    a ratio of speeds. Holds for a wall without mass; a real wall must also swing back in time.

    Raises
    ------
    InputError
        when a number is outside 0 to 1.

    >>> round(energy_returned(bat_restitution=0.45, ball_restitution=0.45, share=0.02), 10)
    0.2025
    >>> round(energy_returned(bat_restitution=0.9, ball_restitution=0.45, share=0.10), 10)
    0.26325
    """
    for name, value in (("bat restitution", bat_restitution), ("ball restitution", ball_restitution), ("share", share)):
        if not 0 <= value <= 1:
            raise InputError(f"{name} is {value:g}; allowed is 0 to 1")
    return bat_restitution**2 * share + ball_restitution**2 * (1 - share)


def block_share(ball: Ball, *, material: Material, compression: float) -> float:
    """Return the share z of the energy that a thick block of a material takes when the ball is pressed into it.

    z = k_b / (k_b + k_w): k_b = F / u of the ball; k_w = 2 E a / (1 - nu^2), the stiffness of a half-space under a
    round patch of radius a = sqrt(R u) (Hertz). Across the grain for wood.

    Parameters
    ----------
    compression : m, of the ball.
    """
    modulus = material.across
    poisson = material.poisson
    patch = math.sqrt(ball.radius * compression)
    block = 2 * modulus * patch / (1 - poisson**2)
    ball_stiffness = loading_force(ball, compression) / compression
    return ball_stiffness / (ball_stiffness + block)


@dataclass(frozen=True)
class Drop:
    """A ball dropped on a block: fall speed (m/s), share of the block, restitution, rebound (m), lost energy (J)."""

    fall_speed: float
    share: float
    restitution: float
    rebound: float
    lost_energy: float


def drop_test(ball: Ball, *, height: float, material: Material, block_restitution: float = 1.0) -> Drop:
    """Return the rebound of a ball dropped from ``height`` (m) on a thick, fixed block, by the two-spring formula.

    m g dH = E_D with dH the height lost [paper2014, Figure 6]: E_D is what the impact loses, not an elastic energy.
    The ball's own restitution is its law at the fall speed.

    >>> from sweetspot.equipment.ball import RestitutionLaw
    >>> law = RestitutionLaw(reference=0.5, reference_speed=25.0)
    >>> ball = Ball(name="b", mass=0.145, radius=0.037, restitution=law, stiffness=1e7, exponent=1.5)
    >>> stiff = Material(name="stiff", density=1.0, longitudinal_modulus=1e15, poisson_ratio=0.3)
    >>> round(drop_test(ball, height=1.0, material=stiff).rebound, 4)
    0.25
    """
    if not height > 0 or not math.isfinite(height):
        raise InputError(f"height is {height:g} m; allowed is a number above zero")
    speed = math.sqrt(2 * STANDARD_GRAVITY * height)
    energy = ball.mass * speed**2 / 2
    share = block_share(ball, material=material, compression=peak_compression(ball, speed))
    back = energy_returned(bat_restitution=block_restitution, ball_restitution=ball.restitution.at(speed), share=share)
    return Drop(speed, share, math.sqrt(back), back * height, (1 - back) * energy)

"""A ball dropped or fired on a block: how high it comes back, and where the energy went.

The block is a list of modes (`sweetspot.dynamics.block`), the hit is the one that bats get
(`sweetspot.collision.coupled`).
The ball's restitution law is taken as its own, on a rigid wall; what a block adds or takes comes from the block.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.collision.contact_law import loading_force, unloading_exponent
from sweetspot.collision.coupled import hit
from sweetspot.collision.impact import Impact, Outcome
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.block import Block, SurfaceModes, block_modes, expected_patch
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball, peak_compression
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_GRAVITY

STEP, SHORTEST_STEP = 1e-6, 1e-7
"""s; a block's fastest motions are faster than a bat's."""
STEP_ERROR = 2e-4
"""Greatest h^2 F' / (12 mu): the ledger then closes within 1e-4 on wood and metal and within 1e-3 on cork and foam."""
SPEED_RANGE = (0.1, 120.0)
"""m/s, from a drop of half a millimetre to more than any bat test."""
DROP_DRAG = 0.5
"""Drag coefficient of a ball at the speeds of a drop, below its drag crisis: 0.4 to 0.55 [recalled]."""
ROOM_AIR = 1.2
"""kg/m^3, of air at 20 degC and sea level."""


def terminal_speed(ball: Ball, *, air_density: float = ROOM_AIR, drag_coefficient: float = DROP_DRAG) -> float:
    """Return the speed in m/s at which the air carries a falling ball: v_t^2 = 2 m g / (rho C_D pi R^2).

    Infinite where ``air_density`` (kg/m^3) is 0: in vacuum.

    >>> from sweetspot.equipment.ball import RestitutionLaw
    >>> law = RestitutionLaw(reference=0.9, reference_speed=2.4)
    >>> ball = Ball(name="b", mass=0.0027, radius=0.02, restitution=law, stiffness=6e4, exponent=1.0)
    >>> round(terminal_speed(ball), 2)
    8.38
    """
    pull = air_density * drag_coefficient * math.pi * ball.radius**2
    return math.sqrt(2 * ball.mass * STANDARD_GRAVITY / pull) if pull else math.inf


@dataclass(frozen=True)
class Rebound:
    """Rebound of a ball from a block.

    Parameters
    ----------
    fall_speed : m/s, with which the ball meets the block.
    compliance : m/N, static compliance of the face, translation left out.
    share : part of the energy at greatest compression that the block would hold, pressed slowly (the paper's z).
    restitution : e of ball and block; on a free block the relative speeds count, e = q (1 + r) + r, r = m/M.
    impact : the hit itself: contact time, peak force, energy ledger.
    terminal : m/s, speed at which air would carry the ball, for the heights; infinite in vacuum.
    """

    block: Block
    ball: Ball
    fall_speed: float
    compliance: float
    share: float
    restitution: float
    impact: Impact
    terminal: float = math.inf

    @property
    def fall_height(self) -> float:
        """Height in m of a fall that gives the fall speed: v^2 / 2g, or -v_t^2 ln(1 - v^2 / v_t^2) / 2g in air."""
        part = (self.fall_speed / self.terminal) ** 2
        slowed = -math.log1p(-part) / part if part else 1.0
        return slowed * self.fall_speed**2 / (2 * STANDARD_GRAVITY)

    @property
    def rebound_speed(self) -> float:
        """Speed in m/s upwards after the hit; negative when the ball pushes a light block away and follows it."""
        return self.impact.collision_efficiency * self.fall_speed

    @property
    def rebound(self) -> float:
        """Height in m that the ball reaches again, v_t^2 ln(1 + v^2 / v_t^2) / 2g in air; 0 when it does not."""
        speed = max(0.0, self.rebound_speed)
        part = (speed / self.terminal) ** 2
        slowed = math.log1p(part) / part if part else 1.0
        return slowed * speed**2 / (2 * STANDARD_GRAVITY)

    @property
    def deflection(self) -> float:
        """Static deflection of the face in m under the peak force; the model holds up to the thickness."""
        return self.compliance * self.impact.peak_force

    @property
    def energy_kept(self) -> float:
        """Part of the ball's energy that it leaves with: 1 - E_D / (m g H) of the paper."""
        return self.impact.energy.ball / self.impact.energy.incoming


def drop(block: Block, *, ball: Ball, height: float, air_density: float = 0.0) -> Rebound:
    """Return the rebound of a ball dropped from ``height`` (m, > 0): v = sqrt(2 g H), less the loss to air drag.

    In air v^2 = v_t^2 (1 - exp(-2 g H / v_t^2)), with `terminal_speed`. Drag takes 1 % of a baseball's fall from 1 m
    and matters for light balls.

    ``air_density``: kg/m^3, >= 0; 0: vacuum.
    """
    if not (math.isfinite(height) and height > 0):
        raise InputError(f"height is {height:g} m; allowed is a number above zero, for example 1 m")
    if not (math.isfinite(air_density) and air_density >= 0):
        raise InputError(f"air density is {air_density:g} kg/m^3; allowed is 0 (vacuum) and above")
    terminal = terminal_speed(ball, air_density=air_density)
    part = 2 * STANDARD_GRAVITY * height / terminal**2
    slowed = -math.expm1(-part) / part if part else 1.0
    landed = fire(block, ball=ball, speed=math.sqrt(2 * STANDARD_GRAVITY * height * slowed))
    return replace(landed, terminal=terminal)


def fire(block: Block, *, ball: Ball, speed: float) -> Rebound:
    """Return the rebound of a ball that hits the middle of a block's face at ``speed`` (m/s, 0.1 to 120).

    Weight is left out while they touch: it is a thousandth of the contact force. Only the first contact counts.
    """
    low, high = SPEED_RANGE
    if not (math.isfinite(speed) and low <= speed <= high):
        raise InputError(
            f"the ball would meet the block at {speed:.4g} m/s; allowed is {low:g} to {high:g} m/s, "
            "a fall from half a millimetre to the fastest shots"
        )
    modes = block_modes(block, patch=expected_patch(ball, speed))
    impact = hit(modes, ball=ball, position=0.0, closing_speed=speed, step=_step(modes, ball, speed))
    recoil = ball.mass / block.mass if block.support == "free" else 0.0
    restitution = impact.collision_efficiency * (1 + recoil) + recoil
    if impact.outcome is not Outcome.SEPARATED or restitution < 0:
        raise InputError(
            f"the ball does not come off {block.material.name} of {1e3 * block.thickness:.3g} mm in one clean contact: "
            "the block deflects too far and too slowly. Use a thicker, smaller or stiffer one"
        )
    give = SurfaceModes(modes.frequency, modes.shape_at(0.0)).compliance
    return Rebound(
        block=block,
        ball=ball,
        fall_speed=speed,
        compliance=give,
        share=static_share(ball, speed=speed, compliance=give),
        restitution=restitution,
        impact=impact,
    )


def bounce(block: Block, *, ball: Ball, height: float) -> tuple[float, float]:
    """Return (rebound height in m, the block's share) of `drop` in vacuum, by the compiled solution alone.

    The height is nan where the ball does not come off in one clean contact.
    """
    if not (math.isfinite(height) and height > 0):
        raise InputError(f"height is {height:g} m; allowed is a number above zero, for example 1 m")
    speed = math.sqrt(2 * STANDARD_GRAVITY * height)
    modes = block_modes(block, patch=expected_patch(ball, speed))
    step = _step(modes, ball, speed)
    rebounds = hits(modes, ball=ball, position=0.0, closing_speed=speed, step=step)
    share = static_share(ball, speed=speed, compliance=SurfaceModes(modes.frequency, modes.shape_at(0.0)).compliance)
    back = float(np.maximum(0.0, rebounds.collision_efficiency[0]))  # which keeps nan
    return back**2 * height, share


def _step(modes: Modes, ball: Ball, speed: float) -> float:
    """Return a time step in s that keeps h^2 F' / (12 mu) small for the lightest face and the steepest force."""
    peak = peak_compression(ball, speed)
    slope = unloading_exponent(ball, peak) * loading_force(ball, peak) / peak
    inverse_mass = 1 / ball.mass + float(np.sum(modes.shape_at(0.0) ** 2))
    return min(STEP, max(SHORTEST_STEP, math.sqrt(12 * STEP_ERROR / (slope * inverse_mass))))


def static_share(ball: Ball, *, speed: float, compliance: float) -> float:
    """Return the part of the energy that a slow spring holds when it and the ball carry the force of a rigid wall.

    z = E_s / (E_s + E_b), E_s = C F^2 / 2 and E_b = m v^2 / 2 = k U^(n+1) / (n+1), F = k U^n; the same number as
    `sweetspot.papers.formulas.block_share` for a deep block and a ball with n = 3/2.

    ``speed``: m/s, of the ball on the wall. ``compliance``: C in m/N, >= 0.

    >>> from sweetspot.equipment.ball import RestitutionLaw
    >>> law = RestitutionLaw(reference=0.5, reference_speed=25.0)
    >>> ball = Ball(name="b", mass=0.145, radius=0.037, restitution=law, stiffness=1e6, exponent=1.0)
    >>> round(static_share(ball, speed=30.0, compliance=1 / 49e6), 12)  # k_b / (k_b + k_s)
    0.02
    """
    held = compliance * loading_force(ball, peak_compression(ball, speed)) ** 2 / 2
    return held / (held + ball.mass * speed**2 / 2)

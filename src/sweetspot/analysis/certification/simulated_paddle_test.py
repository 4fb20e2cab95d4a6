"""The simulated certification test of paddles: a ball fired at a paddle whose handle a free-turning clamp holds.

The paddle-ball restitution takes the recoil out as BBCOR does for bats, with the clamp's moment of inertia in the
effective mass:

    PBCoR = (v_in + v_out) / v_in (1 + m / M_e) - 1,    M_e = (I_paddle + I_clamp) / x^2,

I about the clamp's axis and x from there to the ball [kewcor]. So a clamp counts twice: in the formula, and, as far as
the wave from the ball comes back from it in time, in the rebound. `wave_time` says when it does.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.paddle_modes import Clamp, plate_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.base import Real
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.units import INCH, format_length

STEP = 0.5 * INCH
"""m between places of the scan [coretek_test]."""
NEAREST = 1.0 * INCH
"""m from the tip, of the first place: nearer to it the ball meets the rim."""


@dataclass(frozen=True)
class PaddleTest:
    """A scan along a paddle at rest; arrays have one value per place.

    Parameters
    ----------
    position : m from the butt end, from the tip inwards.
    rebound : v_out over v_in.
    effective_mass, pbcor : M_e in kg and the restitution, with the clamp's moment of inertia.
    wave_time : s, that a wave needs from the ball to the clamp and back.
    contact_time : s.
    speed : m/s of the ball.
    best_position, best_pbcor : where it is greatest, at the top of a parabola through three places, and the value.
    """

    paddle: Paddle
    ball: Ball
    clamp: Clamp
    speed: float
    position: Array
    rebound: Array
    effective_mass: Array
    pbcor: Array
    wave_time: Array
    contact_time: Array
    best_position: float
    best_pbcor: float

    @property
    def best_rebound(self) -> float:
        """Rebound over incoming speed at the best place."""
        return (1 + self.best_pbcor) / (1 + self.ball.mass / self.best_effective_mass) - 1

    @property
    def best_effective_mass(self) -> float:
        """M_e in kg at the best place."""
        body = rigid_body(beam_model(self.paddle))
        return effective_mass_in(self.clamp, body, self.best_position)


def effective_mass_in(clamp: Clamp, body: RigidBody, position: Real) -> Real:
    """Return M_e in kg of a paddle in a clamp that turns about its axis, at a place in m from the butt end."""
    return (body.moi(clamp.axis) + clamp.moi) / (position - clamp.axis) ** 2


def paddle_restitution(rebound: Real, *, ball_mass: float, effective_mass: Real) -> Real:
    """Return the paddle-ball restitution of a rebound over the incoming speed.

    >>> round(paddle_restitution(11.58 / 50, ball_mass=0.02608, effective_mass=0.2116), 4)  # a published paddle
    0.3834
    """
    return (1 + rebound) * (1 + ball_mass / effective_mass) - 1


def wave_time(paddle: Paddle, position: Real, *, reach: float) -> Real:
    """Return the time in s of a wave from a place on the face to the clamp and back: 2 (x - x_c) / sqrt(S / rho).

    Parameters
    ----------
    reach : x_c in m from the butt end, to where the clamp holds the handle.

    >>> from sweetspot import catalog
    >>> paddle = catalog.implement("pickleball-paddle")
    >>> round(1e3 * wave_time(paddle, paddle.length - 0.112, reach=0.09), 1)  # ms, 4.4 in from the tip
    2.0
    """
    return 2 * (position - reach) / math.sqrt(paddle.shear / paddle.areal_mass)


def scanned_places(paddle: Paddle) -> Array:
    """Return the places of the scan in m from the butt end: from `NEAREST` the tip to the end of the face."""
    face = paddle.outline
    count = int((face.end - face.start - NEAREST) / STEP + 1e-9)
    return np.asarray(face.end - NEAREST - STEP * np.arange(count + 1))


def paddle_test(
    paddle: Paddle, *, ball: Ball, speed: float, clamp: Clamp, positions: Array | None = None, patch_factor: float = 1.0
) -> PaddleTest:
    """Return the test of a paddle.

    Parameters
    ----------
    speed : m/s of the ball, > 0.
    positions : m from the butt end; None: every half inch from an inch from the tip to the end of the face.
    patch_factor : on the radius of the ball's patch, > 0.

    Raises
    ------
    InputError
        for a clamp that reaches the face.

    >>> from sweetspot import catalog
    >>> from sweetspot.units import MPH
    >>> paddle, clamp = catalog.implement("pickleball-paddle"), Clamp(axis=0.0508, reach=0.09, moi=12.15e-4)
    >>> test = paddle_test(paddle, ball=catalog.ball("pickleball"), speed=50 * MPH, clamp=clamp)
    >>> bool(0.37 < test.best_pbcor < 0.43)
    True
    """
    face = paddle.outline
    if clamp.reach >= face.start:
        raise InputError(
            f"the clamp holds {paddle.name} up to {format_length(clamp.reach)} from the butt, where its face has begun "
            f"at {format_length(face.start)}; give a longer handle"
        )
    beam = beam_model(paddle)
    body, modes = rigid_body(beam), plate_modes(beam, patch_factor=patch_factor, clamp=clamp)
    places = scanned_places(paddle) if positions is None else positions
    found = hits(modes, ball=ball, position=places, closing_speed=speed)
    mass = effective_mass_in(clamp, body, places)
    pbcor = paddle_restitution(found.collision_efficiency, ball_mass=ball.mass, effective_mass=mass)
    if not np.isfinite(pbcor).any():
        raise InputError("no hit of the test ended with ball and paddle apart; check the paddle's core and the ball")
    index, shift, best = top(pbcor)
    return PaddleTest(
        paddle=paddle,
        ball=ball,
        clamp=clamp,
        speed=speed,
        position=places,
        rebound=found.collision_efficiency,
        effective_mass=mass,
        pbcor=pbcor,
        wave_time=wave_time(paddle, places, reach=clamp.reach),
        contact_time=found.contact_time,
        best_position=float(np.interp(index + shift, np.arange(len(places)), places)),
        best_pbcor=best,
    )

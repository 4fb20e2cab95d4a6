"""Tracked pitches: Statcast's nine parameters, a fit of constant acceleration, followed to the plate."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.pitch.home_plate import MIDDLE, PLATE, REFERENCE, RUBBER
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.numerics.arrays import Array
from sweetspot.units import FOOT, MPH


@dataclass(frozen=True)
class NineParameters:
    """Pitches as Statcast gives them: constant acceleration, referred to `REFERENCE` in front of the plate's tip.

    ``position``: m, shape (..., 3), there; see `nine_parameters`. ``velocity``: m/s, shape (..., 3), there; the second
    part negative, towards the plate. ``acceleration``: m/s^2, shape (..., 3).
    """

    position: Array
    velocity: Array
    acceleration: Array

    def reaches(self, forward: float) -> NDArray[np.bool_]:
        """Return which pitches come as near as ``forward`` (m in front of the plate's tip)."""
        towards, push = self.velocity[..., 1], self.acceleration[..., 1]
        return np.asarray((towards < 0) & (towards**2 + 2 * push * (forward - self.position[..., 1]) > 0))

    def time_to(self, forward: ArrayLike) -> Array:
        """Return the time in s from the reference to ``forward`` (m); negative before it, NaN where never reached.

        y = y0 + v t + a t^2 / 2, so t = 2 (y - y0) / (v + v_f), v_f = -sqrt(v^2 + 2 a (y - y0)).
        """
        way = np.asarray(forward, float) - self.position[..., 1]
        towards, push = self.velocity[..., 1], self.acceleration[..., 1]
        square = towards**2 + 2 * push * way
        final = -np.sqrt(np.where((square > 0) & (towards < 0), square, np.nan))
        return np.asarray(2 * way / (towards + final))

    def at(self, forward: ArrayLike) -> tuple[Array, Array]:
        """Return position and velocity at ``forward`` (m), each of shape (..., 3); NaN where never reached.

        >>> fast = nine_parameters([0.0, -41.0, -1.5], acceleration=[0.0, 8.2, -4.9])
        >>> position, velocity = fast.at(PLATE)
        >>> round(float(np.linalg.norm(velocity)), 2)
        38.07
        """
        time = self.time_to(forward)[..., None]
        return (
            self.position + time * self.velocity + time**2 / 2 * self.acceleration,
            self.velocity + time * self.acceleration,
        )


def nine_parameters(
    velocity: ArrayLike, *, acceleration: ArrayLike, side: ArrayLike = 0.0, height: ArrayLike = MIDDLE[1]
) -> NineParameters:
    """Return pitches by where they pass the front edge of the plate.

    Statcast's tables hold no position at 50 ft but the one at the plate, so the start follows from the end.

    ``velocity``: m/s, shape (..., 3), right, out (negative: towards the plate) and up, at 50 ft (vx0, vy0, vz0).
    ``acceleration``: m/s^2, shape (..., 3) (ax, ay, az). ``side``, ``height``: m, where the ball passes the front edge
    of the plate (plate_x, plate_z).

    Raises
    ------
    InputError
        for vectors that have not three numbers each.
    """
    speed, push = np.asarray(velocity, float), np.asarray(acceleration, float)
    if speed.shape != push.shape or speed.ndim == 0 or speed.shape[-1] != 3:
        raise InputError(
            f"velocity and acceleration have the shapes {speed.shape} and {push.shape}; give both three numbers a pitch"
        )
    start = np.zeros_like(speed)
    start[..., 1] = REFERENCE
    moved, _ = NineParameters(start, speed, push).at(PLATE)
    start[..., 0], start[..., 2] = np.asarray(side) - moved[..., 0], np.asarray(height) - moved[..., 2]
    return NineParameters(start, speed, push)


def at_plate(
    pitch: NineParameters, *, spin: Array, aerodynamics: Aerodynamics | None = None, release: float = RUBBER - 6 * FOOT
) -> BallMotion:
    """Return one tracked pitch where it passes the front edge of the plate.

    ``spin``: rad/s, shape (3,), at release; see `pitch_spin` and `spin_from_movement`. ``aerodynamics``: how the spin
    tires on the way; None: it stays. ``release``: m in front of the plate's tip, where the ball was let go.

    Raises
    ------
    InputError
        for a pitch that never comes to the plate.
    """
    if not pitch.reaches(PLATE):
        raise InputError(
            f"the pitch moves with {pitch.velocity[1]:.4g} m/s ({pitch.velocity[1] / MPH:.4g} mph) at 50 ft and an "
            f"acceleration of {pitch.acceleration[1]:.4g} m/s^2, so it never comes to the plate; give a faster one, "
            "with vy0 negative"
        )
    position, velocity = pitch.at(PLATE)
    way = float(np.linalg.norm(position - pitch.at(release)[0])) if pitch.reaches(release) else release - PLATE
    left = 1.0 if aerodynamics is None else math.exp(-aerodynamics.spin_decay_rate * way)
    return BallMotion(position=position, velocity=velocity, spin=left * np.asarray(spin, float))


def approach_angles(velocity: ArrayLike) -> tuple[Array, Array]:
    """Return the vertical and the horizontal approach angle of pitches in rad, negative: down, positive: to the right.

    ``velocity``: m/s, shape (..., 3), at the plate.
    """
    across, out, up = np.moveaxis(np.asarray(velocity, float), -1, 0)
    return np.arctan2(up, -out), np.arctan2(across, -out)

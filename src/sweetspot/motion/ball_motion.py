"""A ball at one moment: where it is, how fast it moves and how it spins.

Pitch, collision and flight meet here: the pitch ends in a `BallMotion`, the collision makes another of it, and the
flight starts from that. The frame is the field's: origin at the back tip of home plate, x to the right as the
catcher sees it, y to centre field, z up.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.plausibility import check_angles
from sweetspot.units import FOOT
from sweetspot.units.quantities import in_si

USUAL_CONTACT = (0.0, 2 * FOOT, 3 * FOOT)
"""m, where a ball is met unless said otherwise: 2 ft in front of the plate's tip, 3 ft high. [Our choice.]"""


@dataclass(frozen=True)
class BallMotion:
    """A ball at one moment.

    Parameters
    ----------
    position : m, shape (3,), of the ball's centre.
    velocity : m/s, shape (3,).
    spin : rad/s, shape (3,), right-handed; the air pushes along spin x velocity.

    Raises
    ------
    InputError
        for a vector that has not three finite numbers.
    """

    position: Array
    velocity: Array
    spin: Array

    def __post_init__(self) -> None:
        for name in ("position", "velocity", "spin"):
            vector = np.asarray(in_si(getattr(self, name), name), float)
            if vector.shape != (3,) or not np.isfinite(vector).all():
                raise InputError(f"{name} is {getattr(self, name)}; give three finite numbers: right, out and up")
            object.__setattr__(self, name, vector)

    @property
    def speed(self) -> float:
        """Speed in m/s."""
        return float(np.linalg.norm(self.velocity))

    @property
    def launch_angle(self) -> float:
        """Elevation of the velocity in rad, -pi/2 to pi/2."""
        across, out, up = self.velocity
        return math.atan2(up, math.hypot(across, out))

    @property
    def spray(self) -> float:
        """Direction over the ground in rad from centre field, positive to right field."""
        return math.atan2(self.velocity[0], self.velocity[1])

    @property
    def backspin(self) -> float:
        """Spin in rad/s about the level axis across the path; positive lifts the ball."""
        return float(self.spin @ spin_axes(self.launch_angle, self.spray)[0])

    @property
    def sidespin(self) -> float:
        """Spin in rad/s about the axis that stands up across the path; positive bends the path to the left."""
        return float(self.spin @ spin_axes(self.launch_angle, self.spray)[1])

    @property
    def gyrospin(self) -> float:
        """Spin in rad/s about the direction of motion, as of a rifle bullet; it pushes the ball nowhere."""
        return float(self.spin @ spin_axes(self.launch_angle, self.spray)[2])


@dataclass(frozen=True, kw_only=True)
class BallMotions:
    """Many balls, each at one moment; one row serves for all.

    Parameters
    ----------
    velocity, spin : m/s and rad/s, shape (3,) or (n, 3).
    position : m, shape (3,) or (n, 3); where balls usually are met, 2 ft in front of the plate's tip and 3 ft up.
    """

    velocity: ArrayLike
    spin: ArrayLike
    position: ArrayLike = (0.0, 0.6, 0.9)

    def __post_init__(self) -> None:
        for name in ("velocity", "spin", "position"):
            object.__setattr__(self, name, in_si(getattr(self, name), name))


@overload
def batted_ball(
    *,
    speed: float,
    launch_angle: float,
    spray: float = 0.0,
    backspin: float = 0.0,
    sidespin: float = 0.0,
    gyrospin: float = 0.0,
    position: ArrayLike = (0.0, 0.0, 0.0),
) -> BallMotion: ...
@overload
def batted_ball(
    *,
    speed: ArrayLike,
    launch_angle: ArrayLike,
    spray: ArrayLike = 0.0,
    backspin: ArrayLike = 0.0,
    sidespin: ArrayLike = 0.0,
    gyrospin: ArrayLike = 0.0,
    position: ArrayLike = (0.0, 0.0, 0.0),
) -> BallMotion | BallMotions: ...


def batted_ball(
    *,
    speed: ArrayLike,
    launch_angle: ArrayLike,
    spray: ArrayLike = 0.0,
    backspin: ArrayLike = 0.0,
    sidespin: ArrayLike = 0.0,
    gyrospin: ArrayLike = 0.0,
    position: ArrayLike = (0.0, 0.0, 0.0),
) -> BallMotion | BallMotions:
    """Return the ball that starts so, or many balls where any of the numbers is an array.

    Parameters
    ----------
    speed : m/s, >= 0; one number or shape (n,), as every angle and spin.
    launch_angle : rad, elevation.
    spray : rad from centre field, positive to right field.
    backspin, sidespin, gyrospin : rad/s; see the properties of `BallMotion`.
    position : m, shape (3,) or (n, 3), where it starts: to the right, in front of the plate's tip, above the ground.

    Raises
    ------
    InputError
        for an angle that is none in radians, a text, an infinite number, or arrays of different lengths. In arrays nan
        is what was not measured: such a ball has no flight, and the others do.

    >>> ball = batted_ball(speed=46.0, launch_angle=0.48, spray=-0.2, backspin=260.0, sidespin=-50.0)
    >>> round(ball.speed, 9), round(ball.spray, 9), round(ball.backspin, 9), round(ball.sidespin, 9)
    (46.0, -0.2, 260.0, -50.0)
    >>> batted_ball(speed=[40.0, 46.0], launch_angle=0.48, position=(0, 0, 1)).velocity.shape
    (2, 3)
    """
    try:
        given = [np.asarray(value, float) for value in (speed, launch_angle, spray, backspin, sidespin, gyrospin)]
        np.broadcast_shapes(*(value.shape for value in given))
    except (TypeError, ValueError):
        raise InputError(
            "speed, angles and spins do not fit together; give numbers, or arrays that are all of the same length"
        ) from None
    names = ("speed", "launch_angle", "spray", "backspin", "sidespin", "gyrospin", "position")
    for name, value in zip(names, (*given, np.asarray(position, float)), strict=True):
        _check_known(value, name, several=value.ndim > (name == "position"))
    check_angles(np.nan_to_num(given[1]), "launch_angle")
    check_angles(np.nan_to_num(given[2]), "spray")
    if any(value.ndim for value in given) or np.ndim(position) > 1:
        return _many_launched(np.broadcast_arrays(*map(np.atleast_1d, given)), position)
    speed, launch_angle, spray, backspin, sidespin, gyrospin = map(float, given)
    axes = spin_axes(launch_angle, spray)
    return BallMotion(
        position=np.asarray(position, float),
        velocity=speed * axes[2],
        spin=backspin * axes[0] + sidespin * axes[1] + gyrospin * axes[2],
    )


def _check_known(values: Array, name: str, *, several: bool) -> None:
    """Refuse infinities, and nan where there is no other row that could still be flown."""
    if not np.isfinite(values).all() and (np.isinf(values).any() or not several):
        raise InputError(f"{name} is not a finite number; leave out what was not measured")


def _many_launched(given: Sequence[Array], position: ArrayLike) -> BallMotions:
    """Return many balls from speeds, angles and spins of equal shapes (n,)."""
    speed, launch_angle, spray, *spins = given
    axes = spin_axes(launch_angle, spray)
    return BallMotions(
        velocity=speed[:, None] * axes[2],
        spin=sum((rate[:, None] * axis for rate, axis in zip(spins, axes, strict=True)), np.zeros((len(speed), 3))),
        position=np.asarray(position, float),
    )


def launch_angles(velocity: Array, spin: Array) -> tuple[Array, Array, Array]:
    """Return launch angle and spray of many balls, and their back, side and gyro spin.

    Parameters
    ----------
    velocity, spin : m/s and rad/s, shape (..., 3).

    Returns
    -------
    tuple
        launch angle and spray in rad, shape (...), and the three spins in rad/s, shape (3, ...).

    >>> ball = batted_ball(speed=40.0, launch_angle=0.3, spray=0.1, backspin=200.0, sidespin=-30.0, gyrospin=10.0)
    >>> up, aside, spins = launch_angles(ball.velocity, ball.spin)
    >>> round(float(up), 9), round(float(aside), 9), spins.round(9).tolist()
    (0.3, 0.1, [200.0, -30.0, 10.0])
    """
    across, out, up = np.moveaxis(velocity, -1, 0)
    launch, spray = np.arctan2(up, np.hypot(across, out)), np.arctan2(across, out)
    return launch, spray, np.einsum("i...j,...j->i...", spin_axes(launch, spray), spin)


def spin_axes(launch_angle: ArrayLike, spray: ArrayLike) -> Array:
    """Return the unit axes of back, side and gyro spin; the last is the direction of motion.

    Parameters
    ----------
    launch_angle, spray : rad, shape (...).

    Returns
    -------
    ndarray
        shape (3, ..., 3): back, side and gyro, each a vector.
    """
    up, level = np.sin(launch_angle), np.cos(launch_angle)
    right, out = np.sin(spray), np.cos(spray)
    rows = ((out, -right, 0 * up), (-up * right, -up * out, level), (level * right, level * out, up))
    return np.moveaxis(np.array([np.broadcast_arrays(*row) for row in rows]), 1, -1)

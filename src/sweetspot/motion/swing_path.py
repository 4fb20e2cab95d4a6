"""The way the bat goes in space: attack angle, attack direction and tilt, and the three directions they fix.

The bat turns in a plane, so at contact its axis is square to its path. `forward` is the way the barrel goes, `tip` the
way from knob to tip, `up` square to both; the field's frame is that of `sweetspot.motion.ball_motion`.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike
from pydantic import model_validator

from sweetspot.equipment.base import Validated
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array, vectors

Side = Literal["right", "left"]
STEEPEST = math.radians(80)
ROUNDING = 1e-9
"""rad by which a path may be steeper than its plane."""


class PathAxes(NamedTuple):
    """Unit vectors of a swing in the field's frame, each of shape (..., 3), square to each other."""

    forward: Array
    up: Array
    tip: Array


class Swings(NamedTuple):
    """Many swings.

    Parameters
    ----------
    bat_speed : m/s at the point of impact (not at the place where a swing is measured), shape (n,).
    axes : their directions, see `path_axes`, shape (n, 3) or (3,).
    pivot : m from the knob end, the axis that they turn about.
    """

    bat_speed: ArrayLike
    axes: PathAxes
    pivot: float = 0.0


class SwingPlane(NamedTuple):
    """Parameters of a swing's path except its attack angle; see `SwingPath`.

    Parameters
    ----------
    tilt : rad, of the plane against the ground; below the attack angle it counts as that (a level bat).
    attack_direction : rad, negative to the pull side.
    bats : "right" or "left".
    """

    tilt: float = 0.0
    attack_direction: float = 0.0
    bats: Side = "right"

    def axes(self, attack_angle: ArrayLike) -> PathAxes:
        """Return the directions of swings at such attack angles, rad."""
        tilt = steep_enough(self.tilt, attack_angle)
        return path_axes(attack_angle, self.attack_direction, tilt=tilt, left=self.bats == "left")


class SwingPath(Validated):
    """The direction of the swing at contact.

    Parameters
    ----------
    attack_angle : rad, of the barrel's path above the level, -80 to 80 degrees.
    attack_direction : rad, of the barrel's path over the ground from centre field; negative to the pull side, for
        right-handed and left-handed batters alike, as Statcast gives it.
    tilt : rad, of the plane of the swing against the ground, at least the attack angle's size, below 90 degrees;
        None for a bat held level.
    bats : "right" or "left", the side of a batter who bats right-handed stands left of the plate.

    >>> level = SwingPath(attack_angle=0.0)
    >>> [(axis.round(9) + 0.0).tolist() for axis in level.axes]
    [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]
    """

    attack_angle: float = 0.0
    attack_direction: float = 0.0
    tilt: float | None = None
    bats: Side = "right"

    @model_validator(mode="after")
    def _is_a_plane(self) -> SwingPath:
        if abs(self.attack_angle) > STEEPEST or abs(self.attack_direction) > STEEPEST:
            raise ValueError(
                f"attack angle {math.degrees(self.attack_angle):.4g} deg and direction "
                f"{math.degrees(self.attack_direction):.4g} deg; allowed is -80 to 80 deg for both"
            )
        if self.tilt is not None and not abs(self.attack_angle) <= self.tilt < math.pi / 2:
            raise ValueError(
                f"the plane of the swing is tilted by {math.degrees(self.tilt):.4g} deg and the barrel's path rises by "
                f"{math.degrees(self.attack_angle):.4g} deg; no path in a plane is steeper than the plane, so give a "
                "tilt of at least that and below 90 deg"
            )
        return self

    @property
    def axes(self) -> PathAxes:
        """The swing's three directions, each of shape (3,)."""
        tilt = abs(self.attack_angle) if self.tilt is None else self.tilt
        return path_axes(self.attack_angle, self.attack_direction, tilt=tilt, left=self.bats == "left")

    @property
    def barrel_drop(self) -> float:
        """Angle of the bat's axis below horizontal at contact, rad; 0 for a level bat."""
        return -math.asin(self.axes.tip[2])


def steep_enough(tilt: ArrayLike, attack_angle: ArrayLike) -> Array:
    """Return tilts, raised to the attack angle's size where a path would be steeper than its plane, rad.

    For tilts and attack angles that were measured or drawn apart from each other.

    >>> np.degrees(steep_enough(np.radians([30.0, 30.0]), np.radians([10.0, -40.0]))).round(9).tolist()
    [30.0, 40.0]
    """
    return np.asarray(np.maximum(np.asarray(tilt, float), np.abs(attack_angle)))


def path_axes(attack_angle: ArrayLike, attack_direction: ArrayLike, *, tilt: ArrayLike, left: ArrayLike) -> PathAxes:
    """Return the directions of many swings.

    The barrel goes along (cos a sin d, cos a cos d, sin a). The plane's normal makes the angle ``tilt`` with the
    vertical, which turns bat and normal about the path by beta, cos beta = cos(tilt) / cos(a); the barrel is below
    the hands.

    Raises `InputError` for paths that are steeper than the plane they are said to lie in.

    Parameters
    ----------
    attack_angle, attack_direction, tilt : rad, shapes that broadcast; the tilt at least the attack angle's size, see
        `steep_enough`.
    left : whether the batter bats left-handed.
    """
    lefty = np.asarray(left, bool)
    attack, pulled, plane = np.broadcast_arrays(*(np.asarray(v, float) for v in (attack_angle, attack_direction, tilt)))
    if np.any(steeper := np.abs(attack) > plane + ROUNDING):
        first = int(np.argmax(steeper))
        raise InputError(
            f"{int(np.sum(steeper))} of {steeper.size} paths are steeper than the plane of their swing, the first "
            f"with an attack angle of {math.degrees(attack.flat[first]):.4g} deg and a tilt of "
            f"{math.degrees(plane.flat[first]):.4g} deg; no path in a plane is, so give a tilt of at least that"
        )
    direction = np.where(lefty, -pulled, pulled)
    cos_turn = np.minimum(np.cos(plane) / np.cos(attack), 1.0)
    sin_turn = np.sqrt(1 - cos_turn**2)
    rise, level = np.sin(attack), np.cos(attack)
    right, out = np.sin(direction), np.cos(direction)
    forward = vectors(level * right, level * out, rise)
    above = vectors(-rise * right, -rise * out, level)
    hand = np.where(lefty, -1.0, 1.0)
    aside = vectors(hand * out, -hand * right, 0.0)
    cos_turn, sin_turn = cos_turn[..., None], sin_turn[..., None]
    return PathAxes(forward, cos_turn * above + sin_turn * aside, cos_turn * aside - sin_turn * above)

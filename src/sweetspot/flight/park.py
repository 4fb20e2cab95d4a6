"""A ball park: where its fence stands, how high it is, and how high the park lies.

Directions are in rad from centre field, positive to right field; distances are from the tip of home plate over the
ground. Fair territory lies between the foul lines, 45 deg to either side.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike
from pydantic import Field, model_validator

from sweetspot.equipment.base import Validated
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

Roof = Literal["open", "retractable", "fixed"]

FOUL_LINE = math.pi / 4
"""rad from centre field."""
ROUNDING = 1e-9
"""rad; a vertex on the foul line may miss it by so much."""
NEAREST_FENCE, FARTHEST_FENCE = 20.0, 250.0
"""m; from a backyard to more than any park ever had."""


class Park(Validated):
    """A ball park.

    Parameters
    ----------
    name : what people call it.
    team, city : whose it is and where.
    elevation : m above sea level.
    covered : share of games under a closed roof, 0 (none) to 1 (a fixed one).
    fence : (direction, distance, height) of its vertices, rad, m, m, from the left foul line to the right one.

    Raises
    ------
    InputError
        when the directions do not rise from one foul line to the other, or a distance or height cannot be.

    >>> round_park = Park(name="round", fence=((-FOUL_LINE, 100.0, 3.0), (FOUL_LINE, 100.0, 3.0)))
    >>> round(round_park.distance_at(0.0), 3)  # the wall between two vertices is straight: 100 cos(45 deg)
    70.711
    """

    name: str
    team: str = ""
    city: str = ""
    elevation: float = 0.0
    covered: float = Field(default=0.0, ge=0.0, le=1.0)
    fence: tuple[tuple[float, float, float], ...]

    @model_validator(mode="after")
    def _goes_round(self) -> Park:
        directions = [direction for direction, _, _ in self.fence]
        if len(directions) < 2 or any(right <= left for left, right in pairwise(directions)):
            raise ValueError(
                "fence needs at least two vertices, their directions rising from left field to right field"
            )
        if max(abs(directions[0] + FOUL_LINE), abs(directions[-1] - FOUL_LINE)) > ROUNDING:
            first, last = math.degrees(directions[0]), math.degrees(directions[-1])
            raise ValueError(
                f"fence goes from {first:.4g} to {last:.4g} deg; allowed is from foul line to foul line, -45 to 45 deg"
            )
        for _, distance, height in self.fence:
            if not NEAREST_FENCE <= distance <= FARTHEST_FENCE or height < 0:
                raise ValueError(
                    f"a vertex of the fence is {distance:.4g} m away and {height:.4g} m high; allowed is "
                    f"{NEAREST_FENCE:g} to {FARTHEST_FENCE:g} m away and no negative height"
                )
        return self

    @property
    def roof(self) -> Roof:
        """Return the kind of roof, "open" where there is none."""
        return "open" if self.covered == 0 else "fixed" if self.covered == 1 else "retractable"

    def distance_at(self, direction: float) -> float:
        """Return the distance of the fence in m; raises `InputError` for a direction in foul territory."""
        return float(fence_at(self, self._fair(direction))[0])

    def height_at(self, direction: float) -> float:
        """Return the height of the fence in m; raises `InputError` for a direction in foul territory."""
        return float(fence_at(self, self._fair(direction))[1])

    def _fair(self, direction: float) -> float:
        if not abs(direction) <= FOUL_LINE + ROUNDING:
            raise InputError(
                f"direction is {math.degrees(direction):.4g} deg from centre field, foul territory, where the fence of "
                f"{self.name} is not known; allowed is -45 (left) to 45 deg (right)"
            )
        return direction


def fence_at(park: Park, direction: ArrayLike) -> tuple[Array, Array]:
    """Return distance and height of the fence in m for many directions; beyond a foul line those of the foul pole.

    Between two vertices the wall is straight: 1/d = (sin(b - t)/d_a + sin(t - a)/d_b) / sin(b - a) for a direction t
    between those, a and b, of the vertices. Its height goes linearly with the direction.

    ``direction``: rad from centre field, any shape.
    """
    at, distance, height = np.array(park.fence).T
    wanted = np.clip(np.asarray(direction, float), at[0], at[-1])
    left = np.clip(np.searchsorted(at, wanted, side="right") - 1, 0, len(at) - 2)
    before, after = at[left], at[left + 1]
    inverse = np.sin(after - wanted) / distance[left] + np.sin(wanted - before) / distance[left + 1]
    return np.sin(after - before) / inverse, np.interp(wanted, at, height)


def nearest_fence(park: Park) -> float:
    """Return a distance in m that no point of the fence is nearer than: d_min cos(half the widest gap of directions).

    >>> round_park = Park(name="round", fence=((-FOUL_LINE, 100.0, 3.0), (FOUL_LINE, 100.0, 3.0)))
    >>> nearest_fence(round_park) == 100 * math.cos(FOUL_LINE)
    True
    """
    at, distance, _ = np.array(park.fence).T
    return float(distance.min() * math.cos(np.diff(at).max() / 2))

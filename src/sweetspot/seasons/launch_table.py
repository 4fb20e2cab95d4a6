"""What is known of a ball's flight before it is flown: how far it bends on its way, and what drag does to its carry.

Tabled once with the flight kernel for exit speeds, launch angles and bearings, in thin airs and thick. The bend tells
where the search for a launch direction begins, and its change how far to turn for what the landing missed.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import USUAL_AIR
from sweetspot.flight.carry_scatter import MORE_DRAG, SPEEDS, braked, usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.seasons.balls import Balls
from sweetspot.units import DEGREE


@compiled(nogil=True, error_model="numpy")
def fill_between(axes: tuple[Array, Array, Array], table: Array, asked: Array, part: Array, values: Array) -> None:
    """Fill what stands in a table between its nodes, in straight lines; beyond its ends the nearest counts.

    ``table``: shape (nodes of each axis, 6), three values in thin air and the same in thick. ``asked``: (3, n); NaN
    counts as the first node. ``part``: (n,), how far on each ball's air is from the thin one to the thick.
    """
    first, second, third = axes
    for i in range(len(part)):
        a, x = _place(first, asked[0, i])
        b, y = _place(second, asked[1, i])
        c, z = _place(third, asked[2, i])
        bend, two, three = 0.0, 0.0, 0.0
        thin, thick = 1 - part[i], part[i]
        for corner in range(8):
            p, q, r = corner >> 2, (corner >> 1) & 1, corner & 1
            weight = (x if p else 1 - x) * (y if q else 1 - y) * (z if r else 1 - z)
            node = table[a + p, b + q, c + r]
            bend += weight * (thin * node[0] + thick * node[3])
            two += weight * (thin * node[1] + thick * node[4])
            three += weight * (thin * node[2] + thick * node[5])
        values[0, i], values[1, i], values[2, i] = bend, two, three


@inner(forceinline=True, error_model="numpy")
def _place(nodes: Array, value: float) -> tuple[int, float]:
    last = len(nodes) - 1.0
    at = (value - nodes[0]) / (nodes[1] - nodes[0])
    at = min(max(at, 0.0), last) if math.isfinite(at) else 0.0
    low = min(int(at), len(nodes) - 2)
    return low, at - low


ANGLES: Array = np.arange(-85.0, 86.0, 2.5) * DEGREE
SPRAYS: Array = np.arange(-110.0, 111.0, 5.0) * DEGREE
BEARINGS: Array = np.arange(-90.0, 91.0, 5.0) * DEGREE
APART = 0.2
"""Of the usual air's density: steps between the airs that are tabled; others lie on straight lines between."""


@dataclass(frozen=True)
class Expected:
    """The expectations from a table for n balls, every array of shape (n,).

    Parameters
    ----------
    direction : rad from centre field, positive to right field: about which way they set out.
    turn : by how much that changes with the bearing.
    carry_per_drag : m by which the carry grows with the logarithm of drag; negative.
    """

    direction: Array
    turn: Array
    carry_per_drag: Array


def expected_of(balls: Balls, bearing: Array, *, ball: Ball, aerodynamics: Aerodynamics, density: Array) -> Expected:
    """Return the expected quantities of flights that come down in some direction.

    ``bearing``: where they come down, rad from centre field, shape (n,); 0 where it is not known. ``density``: of the
    air that each ball flies through, kg/m^3, shape (n,).
    """
    side = np.where(balls.left, -1.0, 1.0)  # a left-handed batter's ball is a right-handed one's in a mirror
    asked = np.stack([balls.exit_speed, balls.launch_angle, side * bearing])
    steps = density / (APART * USUAL_AIR.density)
    below = np.maximum(np.ceil(steps) - 1, 0)  # the usual air itself is the upper end of its band
    bend, turn, per_drag = values = np.empty((3, len(balls)))
    for thin in np.unique(below):
        mine = below == thin
        between = np.empty((3, int(mine.sum())))
        table = _table(ball, aerodynamics, int(thin))
        fill_between((SPEEDS, ANGLES, BEARINGS), table, asked[:, mine], steps[mine] - thin, between)
        values[:, mine] = between
    return Expected(bearing + side * bend, turn, per_drag)


@lru_cache(maxsize=16)
def _table(ball: Ball, aerodynamics: Aerodynamics, thin: int) -> Array:
    """Return the table for right-handed batters between two airs, shape (speeds, angles, bearings, 6)."""
    return np.ascontiguousarray(
        np.concatenate([_values(ball, aerodynamics, step) for step in (thin, thin + 1)], axis=-1)
    )


@lru_cache(maxsize=16)
def _values(ball: Ball, aerodynamics: Aerodynamics, step: int) -> Array:
    density = step * APART * USUAL_AIR.density
    speed, angle, spray = (grid.ravel() for grid in np.meshgrid(SPEEDS, ANGLES, SPRAYS, indexing="ij"))
    launch = usual_launch(speed, angle, spray, left=np.zeros(len(speed), bool))
    shape = (len(SPEEDS), len(ANGLES), len(SPRAYS))
    flown, again = (
        flights(launch, FlightConditions(ball=ball, aerodynamics=law, air=np.full(len(speed), density)))
        for law in (aerodynamics, braked(aerodynamics))
    )
    landed = np.unwrap(np.nan_to_num(flown.bearing).reshape(shape), axis=2)
    longer = np.nan_to_num((again.carry - flown.carry) / np.log1p(MORE_DRAG)).reshape(shape)
    bend, turn, per_drag = np.empty((3, len(SPEEDS), len(ANGLES), len(BEARINGS)))
    for place in np.ndindex(*shape[:2]):
        bend[place] = np.interp(BEARINGS, landed[place], SPRAYS - landed[place])
        turn[place] = 1 + np.gradient(bend[place], BEARINGS)
        per_drag[place] = np.interp(BEARINGS, landed[place], longer[place])
    return np.stack([bend, turn, per_drag], axis=-1)

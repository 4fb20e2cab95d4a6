"""The offset of the contact inferred from a launch angle, place by place along the bat, ready for a likelihood.

A hit's launch less attack angle is given by the bat's tables for every offset, with a scatter of its own. What it says
of the offset is therefore not normal: it bends where the ball is hardly turned further, and beyond that a grazing
hit may leave at the same angle. For every swing and place the whole of it is put into a few points with weights, those
of Gauss for that very law, so that whatever changes slowly with the offset is summed over to high order. None of this
depends on the player's parameters, so it is done once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.player.bat_response import MISSED, RATIOS, STEEPER, BatResponse
from sweetspot.player.prior import fixed, priors
from sweetspot.units import DEGREE

STEEPEST_LAUNCH = 60 * DEGREE
"""Launch angle, up and down, up to which a hit counts as one; beyond it only its bat speed does. Of what goes fair
hardly a part is steeper, and a limit that the fit sets itself is one that it knows. Our choice."""
POINTS = 3
"""Points that a launch angle is put into."""
UNTOLD_EVERY = 4
"""Of the tabled offsets those that are summed over where no launch angle was measured: every third of an inch."""
CELL = ((-2, 0.125), (-1, 0.25), (0, 0.25), (1, 0.25), (2, 0.125))
"""Tabled offsets that belong to one of those, and what each counts: its own and half of the way to the next ones."""
MEAN_ATTACKS = np.radians(np.linspace(-30.0, 30.0, 13))
"""Mean attack angles, less the usual one, for which the part of hits within `STEEPEST_LAUNCH` is tabled."""
TOGETHER = 16
"""Swings worked on at once, which a processor's fast memory has room for."""
NONE = 1e-200


class OffsetPoints(NamedTuple):
    """Offsets with weights, each of shape (n, points, places).

    ``offset``: m. ``share``: m/rad, density of the launch angle that was measured given the offset, times the step
    between offsets. ``retained``: part of the head-on exit speed that is left.
    """

    offset: Array
    share: Array
    retained: Array


def offset_points(
    tables: Sequence[BatResponse],
    bat: IntArray,
    *,
    ratio: Array,
    launch: Array,
    attack: Array,
    places: Array,
    angle_noise: float = 0.0,
) -> OffsetPoints:
    """Return points and weights for sums over offsets given the launch angles of swings; zeros where none was measured.

    ``bat``: which table, shape (n,). ``ratio``: pitch over bat speed, shape (n,). ``launch``: rad, shape (n,); nan: not
    measured. ``attack``: rad, shape (n,), measured where the launch angle was. ``places``: m from the tip.
    ``angle_noise``: rad, of an attack angle beyond what is usual.
    """
    shape = (len(ratio), POINTS, len(places))
    points = OffsetPoints(np.zeros(shape), np.zeros(shape), np.zeros(shape))
    for which, part in _together(bat, ~np.isnan(launch)):
        found = _points(tables[which], ratio[part], launch[part], attack[part], places, angle_noise)
        for whole, values in zip(points, found, strict=True):
            whole[part] = values
    return points


def untold_kept(
    tables: Sequence[BatResponse], bat: IntArray, *, ratio: Array, attack: Array, places: Array
) -> tuple[Array, Array]:
    """Return the retained part at each `UNTOLD_EVERY` th offset by swings, and its variance, each (n, offsets, places).

    What is retained changes up to the next offset, and with the attack angle where that was not measured.

    ``bat``: which table, shape (n,). ``ratio``: pitch over bat speed, shape (n,). ``attack``: rad, shape (n,); nan: not
    measured. ``places``: m from the tip.
    """
    shape = (len(ratio), len(tables[0].offset[::UNTOLD_EVERY]), len(places))
    retained, square = np.zeros(shape), np.zeros(shape)
    last = len(tables[0].offset) - 1
    cells = [(np.clip(np.arange(0, last + 1, UNTOLD_EVERY) + step, 0, last), part) for step, part in CELL]
    wide = np.sqrt(3) * np.hypot(fixed("attack_angle_spread"), priors()["attack_angle"].width)
    for which, part in _together(bat, np.ones(len(bat), bool)):
        unknown = np.isnan(attack[part])
        for side, share in ((-1, 1 / 6), (0, 2 / 3), (1, 1 / 6)):  # Gauss's three points of a normal law
            steeper = _steeper(attack[part]) + side * wide * unknown
            swung = at_swings(tables[which], ratio[part], steeper, places)[0].transpose(0, 2, 1)
            for those, counts in cells:
                retained[part] += share * counts * swung[:, those]
                square[part] += share * counts * swung[:, those] ** 2
    return retained, np.maximum(square - retained**2, 0.0)


def _together(bat: IntArray, those: NDArray[np.bool_]) -> Iterator[tuple[int, IntArray]]:
    """Yield a bat and some of its swings, until each of those had its turn."""
    for which in np.unique(bat[those]):
        mine = np.flatnonzero(those & (bat == which))
        for part in np.array_split(mine, -(-len(mine) // TOGETHER)):
            yield int(which), part


def _steeper(attack: Array) -> Array:
    """Return attack angles less the usual one; 0 where none was measured."""
    return np.where(np.isnan(attack), 0.0, attack - priors()["attack_angle"].centre)


def part_of_hits(table: BatResponse, *, ratio: float) -> Array:
    """Return the part of the balls met that leaves within `STEEPEST_LAUNCH`, shape (mean attacks, places, offsets)."""
    usual, spread = priors()["attack_angle"].centre, fixed("attack_angle_spread")
    steeper = np.linspace(MEAN_ATTACKS[0] - 3 * spread, MEAN_ATTACKS[-1] + 3 * spread, 49)
    noise = deflection_noise(table, np.array([ratio]))[0]
    _, deflection = at_swings(table, np.full(len(steeper), ratio), steeper, table.places)
    inside = _within(usual + steeper[:, None, None] + deflection, noise)
    away = (steeper - MEAN_ATTACKS[:, None]) / spread
    often = np.exp(-0.5 * away**2)
    return np.tensordot(often / often.sum(axis=1, keepdims=True), inside, axes=1)


def at_swings(table: BatResponse, ratio: Array, steeper: Array, places: Array) -> tuple[Array, Array]:
    """Return the part retained and the deflection of swings on the table's offsets, shape (n, places, offsets).

    ``ratio``: pitch over bat speed, shape (n,). ``steeper``: rad than usual, shape (n,).
    """
    up, right, along = _corners(STEEPER, steeper), _corners(RATIOS, ratio), _corners(table.places, places)
    found = []
    for whole in (table.retained, table.deflection):
        swung = np.zeros((len(ratio), *whole.shape[1:2], whole.shape[3]))
        for i, a in up:
            for j, b in right:
                swung += (a * b)[:, None, None] * whole[i, :, j]
        found.append(sum(part[:, None] * swung[:, k] for k, part in along))
    return np.asarray(found[0]), np.asarray(found[1])


def deflection_noise(table: BatResponse, ratio: Array) -> Array:
    """Return the standard deviation of launch less attack angle at every offset, rad, shape (n, offsets).

    ``ratio``: pitch over bat speed, shape (n,).
    """
    (low, first), (high, second) = _corners(RATIOS, ratio)
    unsteady = first[:, None] * table.unsteady[low] + second[:, None] * table.unsteady[high]
    return np.hypot(unsteady, fixed("deflection_noise"))


def _points(
    table: BatResponse, ratio: Array, launch: Array, attack: Array, places: Array, angle_noise: float
) -> OffsetPoints:
    retained, deflection = at_swings(table, ratio, _steeper(attack), places)
    noise = np.hypot(deflection_noise(table, ratio), angle_noise)[:, None]
    away = launch[:, None, None] - (attack[:, None, None] + deflection)
    share = np.exp(-0.5 * (away / noise) ** 2) / (noise * np.sqrt(2 * np.pi))
    offset, share = gauss_points(np.broadcast_to(table.offset, share.shape), share, POINTS)
    step = float(table.offset[1] - table.offset[0])
    at = np.clip((offset - table.offset[0]) / step, 0, len(table.offset) - 1.000001)
    low = at.astype(np.int64)
    first, second = (np.take_along_axis(retained, low + side, axis=-1) for side in (0, 1))
    there = first + (at - low) * (second - first)
    return OffsetPoints(*(values.transpose(0, 2, 1) for values in (offset, share * step, there)))


def gauss_points(places: Array, weights: Array, count: int) -> tuple[Array, Array]:
    """Return points and weights that sum polynomials up to the degree 2 count - 1 as the given ones do.

    Gauss's rule of a law of single places, by the recursion of its orthogonal polynomials [golub1969].

    ``places``, ``weights``: shape (..., n), weights not negative.

    >>> points, shares = gauss_points(np.linspace(-1, 1, 401), np.full(401, 1 / 401), 2)
    >>> points.round(2).tolist(), shares.round(3).tolist()
    ([-0.58, 0.58], [0.5, 0.5])
    """
    whole = weights.sum(axis=-1)
    safe = np.where(whole > NONE, whole, 1.0)
    jacobi = np.zeros((*whole.shape, count, count))
    before, now = np.zeros_like(weights), np.ones_like(weights) / np.sqrt(safe)[..., None]
    step = np.zeros_like(whole)
    for k in range(count):
        heavy = weights * now
        middle = np.sum(heavy * now * places, axis=-1)
        jacobi[..., k, k] = middle
        if k + 1 == count:
            break
        after = (places - middle[..., None]) * now - step[..., None] * before
        step = np.sqrt(np.sum(weights * after**2, axis=-1))
        jacobi[..., k, k + 1] = jacobi[..., k + 1, k] = step
        before, now = now, after / np.where(step > NONE, step, 1.0)[..., None]
    found, vectors = np.linalg.eigh(jacobi)
    return found, np.where(whole > NONE, whole, 0.0)[..., None] * vectors[..., 0, :] ** 2


def _corners(grid: Array, values: Array) -> list[tuple[IntArray, Array]]:
    """Return both neighbours of values on an even grid, and the part of each; beyond its ends their value."""
    at = np.clip((values - grid[0]) / (grid[1] - grid[0]), 0.0, len(grid) - 1.000001)
    low = at.astype(np.int64)
    return [(low, 1 - (at - low)), (low + 1, at - low)]


def _within(launch: Array, noise: Array) -> Array:
    """Return the part of launch angles that ends within `STEEPEST_LAUNCH`; none of what is no hit."""
    from scipy.special import erf

    root = np.sqrt(2) * noise
    inside = 0.5 * (erf((STEEPEST_LAUNCH - launch) / root) + erf((STEEPEST_LAUNCH + launch) / root))
    return np.asarray(np.where(launch < MISSED / 2, inside, 0.0))

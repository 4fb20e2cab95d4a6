"""Sweet spots, the zone, misses and nodes of many bats at once: as `sweet_spots` and `miss_costs` find one bat's."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import pairwise
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from sweetspot.analysis.sweet_spot import ZONE_LOSS, ZONE_STING, without_spikes
from sweetspot.calibration.unknowns import deviated
from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import bending_batch
from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.interpolants import tops
from sweetspot.numerics.interval import Number
from sweetspot.uncertainty.bat_draws import DrawnBats
from sweetspot.uncertainty.drawn_hits import Draws

NEWTON_STEPS, FARTHEST = 3, 0.02
"""Steps in which a node of the described bat is followed to another's, and how far it may lie from it, m."""


def best_positions(position: Array, curves: Array) -> Array:
    """Return the position of every curve's maximum, m, shape (draws,).

    ``position``: m, evenly spaced, shape (positions,). ``curves``: shape (draws, positions).
    """
    place, _ = tops(curves)
    return np.asarray(position[0] + place * (position[1] - position[0]))


def sweet_zones(position: Array, speed: Array, sting: Array) -> Array:
    """Return both ends of every draw's sweet zone in m, shape (draws, 2); nan where there is none. See `sweet_zone`.

    ``position``: m, evenly spaced, shape (positions,). ``speed``, ``sting``: exit speed and vibration at the hands in
    m/s, shape (draws, positions).
    """
    step = float(position[1] - position[0])
    held = without_spikes(speed, step=step)
    fast = held - (np.nanmax(held, axis=1) - ZONE_LOSS)[:, None]
    quiet = ZONE_STING * np.nanmean(sting, axis=1)[:, None] - sting
    best = (best_positions(position, held) - position[0]) / step
    row, first, last = _runs(np.minimum(fast, quiet) >= 0)
    apart = np.maximum(np.maximum(first - best[row], best[row] - last), 0.0)
    nearest = np.lexsort((first, apart, row))  # of every row's stretches the nearest comes first
    row, chosen = np.unique(row[nearest], return_index=True)
    first, last = first[nearest[chosen]], last[nearest[chosen]]
    zone_ends = np.full((len(speed), 2), np.nan)
    sides = (fast[row], quiet[row])
    zone_ends[row, 0] = np.maximum(*(_crossing(side, first, first - 1) for side in sides))
    zone_ends[row, 1] = np.minimum(*(_crossing(side, last, last + 1) for side in sides))
    return np.asarray(position[0] + step * zone_ends)


def _runs(good: NDArray[np.bool_]) -> tuple[IntArray, IntArray, IntArray]:
    """Return row, first and last index of every unbroken stretch of True, shape (rows, n), by rows."""
    edges = np.diff(np.pad(good.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    row, first = np.nonzero(edges > 0)
    return row, first, np.nonzero(edges < 0)[1] - 1


def _crossing(values: Array, inside: IntArray, outside: IntArray) -> Array:
    """Return the place at which every row falls to zero between an index and its neighbor, at most there."""
    last = values.shape[1] - 1
    rows = np.arange(len(values))
    good, bad = values[rows, inside], values[rows, np.clip(outside, 0, last)]
    with np.errstate(invalid="ignore", divide="ignore"):
        crossed = np.where(bad < 0, inside + (outside - inside) * good / (good - bad), outside)
    return np.where((outside < 0) | (outside > last), inside, crossed)


class MissCost(Protocol):
    """A miss by ``distance`` (m) towards the hands or towards the tip."""

    @property
    def distance(self) -> Number: ...


def costs_of_misses(position: Array, speed: Array, misses: Sequence[MissCost]) -> list[dict[str, Array]]:
    """Return the cost of each miss for every draw, m/s, shape (draws,): "inside", towards the hands, and "outside"."""
    step = float(position[1] - position[0])
    held = without_spikes(speed, step=step)
    place, _ = tops(held)
    top = _at(held, place)
    costs = []
    for miss in misses:
        sides = {}
        for way, name in ((-1, "inside"), (1, "outside")):
            sides[name] = top - _at(held, place + way * float(miss.distance) / step)
        costs.append(sides)
    return costs


def _at(values: Array, place: Array) -> Array:
    """Return every row's value at a place counted in steps, shape (rows,); nan beyond its ends."""
    last = values.shape[1] - 1
    cell = np.clip(np.nan_to_num(place).astype(int), 0, last - 1)
    rows, part = np.arange(len(values)), place - cell
    interpolated = values[rows, cell] * (1 - part) + values[rows, cell + 1] * part
    return np.where((place >= 0) & (place <= last), interpolated, np.nan)


def drawn_nodes(draws: Draws, families: Collection[str]) -> list[Array]:
    """Return the nodes of every bending mode, then of every wall mode, m, shapes (draws, nodes).

    Of an implement that is no bat they are those of all its modes of these families. They are smooth in what is not
    known, and found as described and with every unknown one standard deviation up and down; see `DrawnBats.followed`.
    """
    bats, unknowns = draws.bats, draws.sources.unknowns
    if bats.whole is not None:
        chosen = [index for index, family in enumerate(bats.whole.families) if family in families]
        return _followed_nodes(bats, [(modes, chosen) for modes in (bats.whole, *bats.wholes)])
    steps = np.diag(np.sqrt(np.diag(draws.sources.doubt.covariance)))
    ends = [deviated(draws.beam, unknowns, sign * step) for step in steps for sign in (1.0, -1.0)]
    around = bending_batch(BeamRow([draws.beam, *ends]), threads=1)
    beams = [around.modes(number) for number in range(len(around))]
    nodes = _followed_nodes(bats, [(beam, range(2, len(beam))) for beam in beams])
    return nodes + (_followed_nodes(bats, bats.walls) if bats.walls else [])


def _followed_nodes(bats: DrawnBats, bodies: Sequence[tuple[Modes, Sequence[int]]]) -> list[Array]:
    """Return the nodes of every mode of the first of some bodies in the draws."""
    first, order = bodies[0]
    nodes = [first.nodes(index) for index in order]
    ends = np.cumsum([0, *(len(node) for node in nodes)])
    owner = np.repeat(np.arange(len(nodes)), np.diff(ends))
    start = np.concatenate([np.zeros(0), *nodes])
    each = np.arange(len(start))
    moved = []
    for body, its_modes in bodies:
        places, mode = start, np.asarray(its_modes)[owner]
        for _ in range(NEWTON_STEPS):
            value, slope = body.shape_at(places)[each, mode], body.slope_at(places)[each, mode]
            shift = np.divide(value, slope, out=np.zeros_like(value), where=slope != 0)
            places = places - np.clip(shift, -FARTHEST, FARTHEST)
        moved.append(np.where(np.abs(places - start) < FARTHEST, places, np.nan))  # else it is another one
    drawn = bats.followed(moved)
    return [drawn[:, begin:end] for begin, end in pairwise(ends)]

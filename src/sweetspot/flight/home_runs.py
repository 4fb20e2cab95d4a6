"""Probability of a home run: a ball's chance in every park, with the scatter of its flight.

Two balls hit alike do not fly alike. Balls differ in drag, spin about the usual line, and no park's weather is known to
the breeze. One scatter of the drag coefficient stands for all of it, as wide as the scatter of tracked carries
(`tools/fit_aerodynamics.py` prints it), so a ball that would barely clear a fence has a chance of about one half:
a little less in the open, a little more under a roof (`CarryScatter`).
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from sweetspot.flight.air import PRESSURE_FALL, Air, Airs, air_density
from sweetspot.flight.batted_spin import backspin_scatter
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence_compiled import FOUL, TABLE_STEP, ParkTables, chances
from sweetspot.flight.kernel import STEP, flight_method, flight_rows
from sweetspot.flight.park import Park, fence_at, nearest_fence
from sweetspot.motion.ball_motion import BallMotion, BallMotions, spin_axes
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.threads import in_parts
from sweetspot.units import DEGREE

CHUNK = 2048
"""Balls per task handed to a thread."""
THIN = 800.0
"""m of elevation above which a park's air is too thin to be treated with that of the others; only Denver's is."""
ALIKE = 1e-4
"""Part of the pressure by which the airs that a ball is flown in differ at least."""
LINERS = 26 * DEGREE
"""Launch angle below which the scatter of backspin moves a carry by more than 2 ft (`batted_spin.backspin_scatter`)."""
LIKELY = 0.5
"""Chance above which a home run is likelier than not."""
DIRECTIONS = np.linspace(-FOUL, FOUL, round(2 * FOUL / TABLE_STEP) + 1)


@dataclass(frozen=True)
class CarryScatter:
    """Scatter of single flights, as fractions of the drag coefficient.

    ``roof``, ``open``: standard deviation under a roof that never opens and in the open. ``roof_shift``,
    ``open_shift``: what balls near the fence have more of there than the law says; see docs/theory/flight.md.
    ``closed``: how much of a fixed roof is a closed one that moves; see docs/theory/parks.md. ``spin``: how much of the
    usual scatter of backspin balls launched below `LINERS` have; 0 where it was measured. That of higher balls does
    little and is in the scatter of drag.
    """

    roof: float = 0.055
    open: float = 0.065
    roof_shift: float = -0.040
    open_shift: float = 0.015
    closed: float = 0.5
    spin: float = 1.0

    def of(self, park: Park) -> tuple[float, float]:
        """Return shift and standard deviation in a park."""
        covered = park.covered * (self.closed if park.roof == "retractable" else 1.0)
        return (
            covered * self.roof_shift + (1 - covered) * self.open_shift,
            covered * self.roof + (1 - covered) * self.open,
        )

    def drag(self, park: Park | None) -> float:
        """Return the standard deviation in a park, or in the open where none is named."""
        return self.open if park is None else self.of(park)[1]


USUAL = CarryScatter()
"""Fitted to which of the balls of 2022 left their parks [savant_2022rays]. Distances alone would have shifts of -0.037
and 0: in the open the fence asks 2.5 ft more of a ball than its carry says."""
SPIN_MEASURED = replace(USUAL, spin=0.0)
"""The same of balls whose spin is no other than it is."""
NONE = CarryScatter(roof=0.0, open=0.0, roof_shift=0.0, open_shift=0.0, spin=0.0)
"""Every ball flies by the law: chances are 0 or 1."""


def is_likely(chance: float) -> bool:
    """Return whether a home run is likelier than not: what words call a home run, and counts of parks count."""
    return chance > LIKELY


@dataclass(frozen=True)
class HomeRuns:
    """Chances of many balls in many parks.

    ``chance``: shape (n, parks), 0 to 1. ``clearance``: m from the fence's top up to the ball's centre over it as it
    flies by the law, shape (n, parks); negative where it falls short, NaN where it is foul or does not come near.
    """

    chance: Array
    clearance: Array

    @property
    def expected(self) -> Array:
        """In how many of the parks each ball is a home run on average, shape (n,)."""
        return np.asarray(self.chance.sum(axis=1))


def home_run_chances(
    motions: BallMotion | BallMotions,
    conditions: FlightConditions,
    *,
    parks: Iterable[Park],
    own_elevation: bool = True,
    scatter: CarryScatter = USUAL,
    step: float = STEP,
    threads: int | None = None,
) -> HomeRuns:
    """Return each ball's chance of a home run in each park.

    A ball is followed as far as the fences and nothing is kept of its path: 16 bytes per ball and park. What drag takes
    of its height is that in the middle of the parks' airs; docs/theory/parks.md says how far that puts chances off.
    Alone a park's is exact. Balls that have each its own air have that weather in every park.

    Parameters
    ----------
    motions : the balls as they leave the bat; shapes are broadcast together.
    conditions : as in `landings_everywhere`, or an air (`Airs`) or a wind for each ball; the wind does not know of
        shelter here.
    parks : with their own fences; ``own_elevation`` says whether each lies at its own elevation too.
    step : s, as `flights` takes it; up to 0.5.
    threads : workers; None: one per core.
    """
    everywhere, air = tuple(parks), conditions.weather
    levels, weights = _levels(tuple(park.elevation if own_elevation else 0.0 for park in everywhere))
    fences, nearest = _fences(everywhere)
    shifts, scatters = np.array([scatter.of(park) for park in everywhere]).T.copy()
    tables = ParkTables(weights, fences, nearest, shifts, scatters)
    start, method = flight_rows(motions, conditions), flight_method(conditions, step)
    densities = np.empty((len(levels), start.shape[1]))
    densities[:] = _densities(air, levels, own_elevation=own_elevation)
    count, (start, rows) = start.shape[1], _with_other_spins(start, scatter.spin)
    densities = densities[:, rows]
    chance = np.empty((start.shape[1], len(everywhere)))
    clearance = np.empty_like(chance)

    def work(part: slice) -> None:
        own_start, own_air = np.ascontiguousarray(start[:, part]), np.ascontiguousarray(densities[:, part])
        chances(own_start, own_air, tables, method, (chance[part], clearance[part]))

    in_parts(work, len(chance), size=CHUNK, threads=threads)
    liners = rows[count : count + (len(rows) - count) // 2]
    if len(liners):
        less, more = chance[count:].reshape(2, len(liners), -1)
        chance[liners] += (less - 2 * chance[liners] + more) / 6
    return HomeRuns(chance[:count], clearance[:count])


def _with_other_spins(start: Array, scatter: float) -> tuple[Array, IntArray]:
    """Return balls, then liners with less backspin, then with more, and which ball each is.

    Their backspins are the nodes of Gauss's and Hermite's rule, the square root of 3 standard deviations off, with
    weights of 1/6, 2/3 and 1/6.

    ``scatter``: of backspin, as a part of the usual one.
    """
    right, out, up = start[3:6]
    angle = np.arctan2(up, np.hypot(right, out))
    liners = np.flatnonzero((angle < LINERS) & (scatter > 0))
    rows = np.concatenate([np.arange(start.shape[1]), liners, liners])
    balls = start[:, rows]
    if len(liners):
        size = math.sqrt(3) * scatter * backspin_scatter(angle[liners])
        added = size[:, None] * spin_axes(angle[liners], np.arctan2(right, out)[liners])[0]
        balls[6:9, start.shape[1] :] += np.concatenate([-added, added]).T
    return balls, rows


@lru_cache(maxsize=64)
def _levels(elevations: tuple[float, ...]) -> tuple[Array, Array]:
    """Return three elevations that a ball is flown at, highest first, and how they mix to the air of each park.

    In any weather density is a straight line in how far the pressure has fallen, so one mixture does for every ball.
    """
    fallen = np.exp(-PRESSURE_FALL * np.array(elevations))
    apart = max(np.ptp(fallen) / 2, ALIKE)
    nodes = (fallen.min() + fallen.max()) / 2 + apart * np.array([-1.0, 0.0, 1.0])
    return -np.log(nodes) / PRESSURE_FALL, np.array([_weights(value, nodes) for value in fallen])


def _densities(air: Air | Airs, levels: Array, *, own_elevation: bool) -> Array:
    """Return the densities in which balls are flown, kg/m^3, shape (levels, 1) or (levels, n).

    ``own_elevation``: whether the levels are above the sea, or above the elevation of the air.
    """
    from_sea = levels[:, None] if own_elevation else levels[:, None] + np.asarray(air.elevation)
    return air_density(air.temperature, pressure=air.pressure, humidity=air.humidity, elevation=from_sea)


@lru_cache(maxsize=64)
def _fences(parks: tuple[Park, ...]) -> tuple[Array, float]:
    """Return distances and heights of the fences as tables, shape (2, parks, directions), and the nearest distance."""
    fences = np.array([fence_at(park, DIRECTIONS) for park in parks]).transpose(1, 0, 2).copy()
    return fences, min(nearest_fence(park) for park in parks)


def _weights(value: float, nodes: Array) -> list[float]:
    """Return the weights of Lagrange's parabola through the nodes.

    >>> [round(weight, 6) + 0.0 for weight in _weights(1.05, np.array([1.0, 1.1, 1.2]))]
    [0.375, 0.75, -0.125]
    """
    return [float(math.prod((value - other) / (node - other) for other in nodes if other != node)) for node in nodes]

"""The compiled heart of `home_runs`: one ball against every park, followed no further than the fences.

Parks differ in their air by little, so a ball is flown at three densities (one, where all are alike) and every park's
path lies on the parabola through them, moment by moment; that is right to a few millimetres at 130 m. One more flight,
with more drag, says how the height at a fence changes with drag. Nothing is kept of a ball but its chances.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.flight.compiled import FlightLaw, stepped
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled

STEP = 0.2
"""s, as in `kernel`."""
MOST_POINTS = 60
"""Steps of a path: 12 s, longer than any ball that comes near a fence is in the air."""
DEPTH = 12.0
"""m below the field down to which a path goes on, so that a ball that falls short says by how much."""
NEAR = 8.0
"""m by which paths through thinner or thicker air may be ahead at the nearest fence."""
MORE_DRAG = 0.1
"""Part of its drag coefficient that the extra flight has more."""
TURNS = 4
"""Corrections of the moment at which a path passes the fence."""
TABLE_STEP = math.pi / 720
"""rad between the entries of a park's fence."""
FOUL = math.pi / 4


@compiled(nogil=True, error_model="numpy")
def chances(
    start: Array, densities: Array, weights: Array, fences: Array, nearest: float, drags: Array, scatters: Array,
    per_density: float, law: FlightLaw, power: float | None, profile: float | None, chance: Array, margin: Array,
) -> None:  # fmt: skip
    """Fill the chance of a home run and the height over the fence of n balls in m parks.

    Parameters
    ----------
    start : (11, n), position, velocity, spin, wind to the right and out.
    densities : (k,), of the air, kg/m^3, thinnest first; ``weights`` (m, k) mix them to each park's air.
    fences : (2, m, directions), distance and height of the fence every `TABLE_STEP` from one foul line to the other.
    nearest : m, no fence is nearer.
    drags, scatters : (m,), what each park adds to the drag coefficient, and standard deviation of the latter, as parts
        of it.
    per_density, law, power, profile : as `compiled.solve` takes them.
    chance, margin : (n, m).
    """
    nodes, parks = len(densities), len(weights)
    paths = np.empty((nodes + 1, MOST_POINTS, 6))
    more = 1 + MORE_DRAG
    braked = FlightLaw(
        law.radius, law.drag * more, law.drag_per_spin * more, law.drag_per_active_spin * more,
        law.drag_per_spin_factor * more, law.viscous * more, law.lift_scale, law.lift_offset, law.lift_slope,
        law.decay, law.reference,
    )  # fmt: skip
    for ball in range(start.shape[1]):
        count, reach = _path(start[:, ball], per_density * densities[0], law, power, profile, paths[0])
        if not reach > nearest:
            chance[ball, :] = 0.0
            margin[ball, :] = np.nan
            continue
        for node in range(1, nodes):
            other, _ = _path(start[:, ball], per_density * densities[node], law, power, profile, paths[node])
            count = min(count, other)
        middle = nodes // 2
        other, _ = _path(start[:, ball], per_density * densities[middle], braked, power, profile, paths[nodes])
        count = min(count, other)
        first = 1
        while first < count - 1 and math.hypot(paths[middle, first, 0], paths[middle, first, 1]) < nearest - NEAR:
            first += 1
        for park in range(parks):
            height, fall = _over(paths, first, count, weights[park], middle, fences[:, park])
            height -= fall * drags[park] / MORE_DRAG
            margin[ball, park] = height
            spread = max(abs(fall) * scatters[park] / MORE_DRAG, 1e-9)
            chance[ball, park] = 0.5 * math.erfc(-height / spread / math.sqrt(2.0)) if math.isfinite(height) else 0.0


@compiled(error_model="numpy")
def _path(
    start: Array, strength: float, law: FlightLaw, power: float | None, profile: float | None, path: Array
) -> tuple[int, float]:  # fmt: skip
    """Fill position and velocity at every step down to `DEPTH`; return how many, and the greatest distance in m."""
    spin = (start[6], start[7], start[8], math.sqrt(start[6] ** 2 + start[7] ** 2 + start[8] ** 2))
    wind = (start[9], start[10])
    state = (start[0], start[1], start[2], start[3], start[4], start[5], 1.0)
    reach = 0.0
    for point in range(MOST_POINTS):
        for axis in range(6):
            path[point, axis] = state[axis]
        reach = max(reach, math.hypot(state[0], state[1]))
        if state[2] < -DEPTH or not math.isfinite(state[2]):
            return point + 1, reach
        state = stepped(state, STEP, spin, strength, wind, law, power, profile)
    return MOST_POINTS, reach


@compiled(error_model="numpy")
def _over(
    paths: Array, first: int, count: int, weights: Array, middle: int, fence: Array
) -> tuple[float, float]:  # fmt: skip
    """Return how high over a fence's top a ball passes, m, and what it loses of that by `MORE_DRAG`; NaN where foul.

    The path is looked at from the step ``first``.
    """
    before = -1.0
    for point in range(first, count):
        x, y = 0.0, 0.0
        for node in range(len(weights)):
            x += weights[node] * paths[node, point, 0]
            y += weights[node] * paths[node, point, 1]
        beyond = math.hypot(x, y) - _at(fence[0], math.atan2(x, y))
        if beyond < 0:
            before = beyond
            continue
        part = 0.5 if before >= 0 else before / (before - beyond)
        low, high = 0.0, 1.0
        height, direction = 0.0, 0.0
        for _ in range(TURNS):
            x = _mixed(paths, weights, point, 0, part)
            y = _mixed(paths, weights, point, 1, part)
            direction = math.atan2(x, y)
            miss = math.hypot(x, y) - _at(fence[0], direction)
            if miss > 0:
                high = part
            else:
                low = part
            speed = math.hypot(paths[middle, point, 3], paths[middle, point, 4]) * STEP
            part = part - miss / speed
            if not low < part < high:
                part = (low + high) / 2
        if abs(direction) > FOUL:
            return math.nan, 0.0
        height = _mixed(paths, weights, point, 2, part) - _at(fence[1], direction)
        return height, _lost(paths, len(weights), middle, point, part, x, y)
    return math.nan, 0.0


@compiled(error_model="numpy")
def _lost(paths: Array, extra: int, middle: int, point: int, part: float, x: float, y: float) -> float:
    """Return how much lower the flight with more drag is at the same distance, m."""
    change = np.empty(3)
    for axis in range(3):
        near = paths[extra, point - 1, axis] - paths[middle, point - 1, axis]
        change[axis] = (1 - part) * near + part * (paths[extra, point, axis] - paths[middle, point, axis])
    far = math.hypot(x, y)
    ahead = paths[middle, point]
    outwards = (x * ahead[3] + y * ahead[4]) / far
    shorter = (x * change[0] + y * change[1]) / far
    return float(ahead[5] / max(outwards, 1.0) * shorter - change[2])


@compiled(error_model="numpy")
def _mixed(paths: Array, weights: Array, point: int, axis: int, part: float) -> float:
    """Return a coordinate within a step, on the cubic through its ends."""
    value = 0.0
    rest = 1 - part
    for node in range(len(weights)):
        first, last = paths[node, point - 1, axis], paths[node, point, axis]
        rise, fall = STEP * paths[node, point - 1, axis + 3], STEP * paths[node, point, axis + 3]
        value += weights[node] * (
            rest * rest * (1 + 2 * part) * first + part * part * (3 - 2 * part) * last
            + part * rest * (rest * rise - part * fall)
        )  # fmt: skip
    return value


@compiled(error_model="numpy")
def _at(table: Array, direction: float) -> float:
    """Return the entry of an even table for a direction; beyond a foul line that of the line."""
    place = min(max((direction + FOUL) / TABLE_STEP, 0.0), len(table) - 1.0)
    left = min(int(place), len(table) - 2)
    return float(table[left] + (place - left) * (table[left + 1] - table[left]))

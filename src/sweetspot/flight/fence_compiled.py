"""The compiled heart of `home_runs`: balls against every park, followed no further than the fences.

Parks differ in their air by little, so a ball is flown at three densities and every park's path lies on the parabola
through them, moment by moment; that is right to a few millimetres at 130 m. One more flight, with more drag, says how
the height at a fence changes with drag, which goes with the root of the air's density, as flights
in one air alone say to two hundredths. Flights advance side by side in lanes, as in `compiled`; nothing is kept of a
ball but its chances.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from sweetspot.flight.compiled import (
    LANES,
    ROWS,
    FlightLaw,
    FlightMethod,
    X,
    Y,
    Z,
    flown_in,
    put_start,
    put_state,
    state_of,
    stepped,
)
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled, inner

MOST_POINTS = 60
"""Steps of a path: 12 s at 0.2 s each, longer than any ball that comes near a fence is in the air."""
DEPTH = 12.0
"""m below the field down to which a path goes on, so that a ball that falls short says by how much."""
NEAR = 8.0
"""m by which paths through thinner or thicker air may be ahead at the nearest fence."""
MORE_DRAG = 0.1
"""Part of its drag coefficient that the extra flight has more."""
TURNS, NO_MISS = 6, 1e-4
"""Most corrections of the moment at which a path passes the fence, and m beside it that call for none."""
AIRS, MIDDLE = 3, 1
"""Densities that every ball is flown at, and the one at which it is flown with more drag too."""
PATHS = AIRS + 1
"""Flights of one ball."""
BALLS = LANES // PATHS
SETTLED = 6.5
"""Standard deviations over or under a fence from which the chance is 1 or 0, right to 4e-11."""
SMALL = 0.03
"""rad up to which the arc tangent is its series; what is left out is below 1e-14."""
BRAKED = ROWS * LANES
"""First place of one more row of the lanes' numbers: the factor of the drag."""
# what is known of a path at a step, seen from home plate: distance, direction, height, and what they gain in a step
FAR, WAY, HIGH, FARTHER, TURNED, HIGHER = range(6)
TABLE_STEP = math.pi / 720
"""rad between the entries of a park's fence."""
FOUL, BEHIND = math.pi / 4, math.pi / 2


class ParkTables(NamedTuple):
    """What m parks ask of a ball.

    Parameters
    ----------
    weights : (m, 3), mix the paths through three airs to each park's.
    fences : (2, m, directions), distance and height of the fence every `TABLE_STEP` from one foul line to the other.
    nearest : m, no fence is nearer.
    drags, scatters : (m,), what each park adds to the drag coefficient, and standard deviation of the latter, as parts
        of it.
    """

    weights: Array
    fences: Array
    nearest: float
    drags: Array
    scatters: Array


@compiled(nogil=True, error_model="numpy")
def chances(
    start: Array, densities: Array, parks: ParkTables, method: FlightMethod, output: tuple[Array, Array]
) -> None:
    """Fill the chance of a home run, and the height over the fence by the law, of n balls in m parks.

    ``start``: (12, n), as `solve` takes it; its density does not count. ``densities``: (3, n), of the airs that each
    ball is flown in, kg/m^3, thinnest first. ``output``: both (n, m).
    """
    balls = start.shape[1]
    (weights, fences, nearest, drags, scatters), (chance, margin) = parks, output
    per_density, step = method.per_density, method.step
    lanes, paths = np.zeros((ROWS + 1) * LANES), np.empty((MOST_POINTS, 6, LANES))
    seen, lost = np.empty((MOST_POINTS, 6, AIRS)), np.empty((MOST_POINTS, 4))
    points, reach = np.empty(LANES, np.int64), np.empty(LANES)
    far = np.empty(balls, np.int64)
    count, farthest = 0, fences[0].max() + NEAR
    for first in range(0, balls, LANES):  # which balls come near a fence at all, in the thinnest air
        for lane in range(LANES):
            ball = min(first + lane, balls - 1)
            put_start(lanes, lane, start, ball, per_density * densities[0, ball])
            lanes[BRAKED + lane] = 1.0
        _fly(lanes, method, nearest, paths, points, reach)
        for lane in range(min(LANES, balls - first)):
            if reach[lane] > nearest:
                far[count] = first + lane
                count += 1
            else:
                chance[first + lane, :] = 0.0
                margin[first + lane, :] = np.nan
    for first in range(0, count, BALLS):
        for lane in range(LANES):
            ball, path = far[min(first + lane // PATHS, count - 1)], lane % PATHS
            density = densities[path if path < AIRS else MIDDLE, ball]
            put_start(lanes, lane, start, ball, per_density * density)
            lanes[BRAKED + lane] = 1 + MORE_DRAG if path == AIRS else 1.0
        _fly(lanes, method, farthest, paths, points, reach)
        for place in range(min(BALLS, count - first)):
            ball, lane = far[first + place], PATHS * place
            last = points[lane : lane + PATHS].min()
            begin, end = _seen_from_home(paths, lane, last, step, nearest - NEAR, farthest, seen, lost)
            hint = begin + 1
            for park in range(len(weights)):
                height, fall, hint = _over(seen, lost, begin, end, step, weights, fences, park, hint)
                margin[ball, park] = height
                thick = 0.0
                for air in range(AIRS):
                    thick += weights[park, air] * densities[air, ball]
                fall *= math.sqrt(thick / densities[MIDDLE, ball])
                height -= fall * drags[park] / MORE_DRAG
                spread = max(abs(fall) * scatters[park] / MORE_DRAG, 1e-9)
                off = height / spread
                if abs(off) < SETTLED:
                    chance[ball, park] = 0.5 * math.erfc(-off / math.sqrt(2.0))
                else:
                    chance[ball, park] = 1.0 if off > 0 else 0.0


@inner(error_model="numpy", fastmath={"contract", "nsz"})
def _advance(lanes: Array, law: FlightLaw, power: float | None, profile: float | None, step: float) -> None:
    """Move every lane by one step."""
    for lane in range(LANES):
        more = lanes[BRAKED + lane]
        braked = FlightLaw(
            law.radius,
            law.drag * more,
            law.drag_per_spin * more,
            law.drag_per_active_spin * more,
            law.drag_per_spin_factor * more,
            law.viscous * more,
            law.lift_scale,
            law.lift_offset,
            law.lift_slope,
            law.decay,
            law.reference,
        )
        flown = flown_in(lanes, lane, 1.0)
        put_state(lanes, lane, stepped(state_of(lanes, lane), step, flown, braked, power, profile))


@inner(error_model="numpy")
def _fly(lanes: Array, method: FlightMethod, enough: float, paths: Array, points: IntArray, reach: Array) -> None:
    """Fill positions and velocities at every step, how many there are down to `DEPTH`, and the greatest distance.

    ``enough``: m, when all have been farther than that they are followed no more. ``paths``: (points, 6, lanes).
    """
    law, _, power, profile, _, step = method
    over = np.zeros(LANES, np.bool_)
    reach[:] = 0.0
    for point in range(MOST_POINTS):
        flying = 0
        for row in range(6):
            for lane in range(LANES):
                paths[point, row, lane] = lanes[row * LANES + lane]
        for lane in range(LANES):
            if over[lane]:
                continue
            points[lane] = point + 1
            far = math.sqrt(lanes[X + lane] ** 2 + lanes[Y + lane] ** 2)
            reach[lane] = far if far > reach[lane] else reach[lane]
            if lanes[Z + lane] < -DEPTH or not math.isfinite(lanes[Z + lane]):
                over[lane] = True
            elif reach[lane] <= enough:
                flying += 1
        if flying == 0:
            return
        _advance(lanes, law, power, profile, step)


@inner(error_model="numpy")
def _seen_from_home(
    paths: Array, lane: int, last: int, step: float, near: float, farthest: float, seen: Array, lost: Array
) -> tuple[int, int]:
    """Fill what is known of a ball's paths from home plate; return the first and the last step but one that matter.

    Parameters
    ----------
    lane : of its first path; the one with more drag follows the last air's.
    near, farthest : m; steps between these distances matter.
    seen : (points, 6, airs).
    lost : (points, 4), what more drag takes of distance and height, and of what they gain in a step.
    """
    middle, braked = lane + MIDDLE, lane + AIRS
    begin = 0
    while begin < last - 2 and paths[begin + 1, 0, middle] ** 2 + paths[begin + 1, 1, middle] ** 2 < near * near:
        begin += 1
    for point in range(begin, last):
        least = math.inf
        x_middle, y_middle = paths[point, 0, middle], paths[point, 1, middle]
        way = math.atan2(x_middle, y_middle)
        for node in range(AIRS):
            x, y, z = paths[point, 0, lane + node], paths[point, 1, lane + node], paths[point, 2, lane + node]
            right, out, up = paths[point, 3, lane + node], paths[point, 4, lane + node], paths[point, 5, lane + node]
            far = max(math.sqrt(x * x + y * y), 1e-9)
            seen[point, FAR, node], seen[point, WAY, node], seen[point, HIGH, node] = far, way, z
            aside = (x * y_middle - y * x_middle) / max(x * x_middle + y * y_middle, 1e-9)
            if abs(aside) < SMALL:
                square = aside * aside
                seen[point, WAY, node] += aside * (1 - square * (1 / 3 - square * (1 / 5 - square * (1 / 7))))
            else:
                seen[point, WAY, node] = math.atan2(x, y)
            seen[point, FARTHER, node] = step * (x * right + y * out) / far
            seen[point, TURNED, node] = step * (right * y - out * x) / (far * far)
            seen[point, HIGHER, node] = step * up
            least = min(least, far)
        x, y, z = paths[point, 0, middle], paths[point, 1, middle], paths[point, 2, middle]
        over = step / max(math.sqrt(x * x + y * y), 1e-9)
        right, out, up = paths[point, 3, middle], paths[point, 4, middle], paths[point, 5, middle]
        shorter = x * (paths[point, 0, braked] - x) + y * (paths[point, 1, braked] - y)
        lost[point, 0], lost[point, 1] = over / step * shorter, paths[point, 2, braked] - z
        lost[point, 2] = over * (x * (paths[point, 3, braked] - right) + y * (paths[point, 4, braked] - out))
        lost[point, 3] = step * (paths[point, 5, braked] - up)
        if least > farthest:
            return begin, point + 1
    return begin, last


@inner(forceinline=True, error_model="numpy")
def _beyond(seen: Array, point: int, weights: Array, fences: Array, park: int) -> tuple[float, float]:
    """Return the distance of a path beyond a fence at a step, m, and its direction from home plate."""
    far, way = 0.0, 0.0
    for node in range(AIRS):
        far += weights[park, node] * seen[point, FAR, node]
        way += weights[park, node] * seen[point, WAY, node]
    return far - _at(fences, 0, park, way), way


@inner(forceinline=True, error_model="numpy")
def _over(
    seen: Array, lost: Array, begin: int, end: int, step: float, weights: Array, fences: Array, park: int, hint: int
) -> tuple[float, float, int]:
    """Return the height of a ball over a fence's top, m, and its loss of height by `MORE_DRAG`; NaN where foul.

    Also the step in which it passes, or the last one: ``hint`` for the next fence, which is not far from this one.
    """
    point = min(max(hint, begin + 1), end - 1)
    if point <= begin:
        return math.nan, 0.0, hint
    beyond, way = _beyond(seen, point, weights, fences, park)
    before = beyond
    while beyond < 0:
        before, point = beyond, point + 1
        if point >= end:
            return math.nan, 0.0, end - 1
        beyond, way = _beyond(seen, point, weights, fences, park)
    while before >= 0 and point > begin + 1:
        before, earlier = _beyond(seen, point - 1, weights, fences, park)
        if before >= 0:
            beyond, way, point = before, earlier, point - 1
    if abs(way) > BEHIND:
        return math.nan, 0.0, point
    before = -1.0 if before >= 0 else before  # beyond already at the first step
    part = before / (before - beyond)
    low, high = 0.0, 1.0
    turning, going = _step_of(seen, weights, park, point, WAY), _step_of(seen, weights, park, point, FAR)
    rate = going[3]
    for _ in range(TURNS):
        way = _within(turning, part)
        miss = _within(going, part) - _at(fences, 0, park, way)
        if abs(miss) < NO_MISS:
            break
        if miss > 0:
            high = part
        else:
            low = part
        part = part - miss / rate
        if not low <= part <= high:
            part = (low + high) / 2
    if abs(way) > FOUL:
        return math.nan, 0.0, point
    height = _within(_step_of(seen, weights, park, point, HIGH), part) - _at(fences, 1, park, way)
    outwards = (1 - part) * seen[point - 1, FARTHER, MIDDLE] + part * seen[point, FARTHER, MIDDLE]
    climbing = (1 - part) * seen[point - 1, HIGHER, MIDDLE] + part * seen[point, HIGHER, MIDDLE]
    shorter = _within((lost[point - 1, 0], lost[point, 0], lost[point - 1, 2], lost[point, 2]), part)
    lower = _within((lost[point - 1, 1], lost[point, 1], lost[point - 1, 3], lost[point, 3]), part)
    return height, climbing / max(outwards, step) * shorter - lower, point


@inner(forceinline=True, error_model="numpy")
def _step_of(seen: Array, weights: Array, park: int, point: int, what: int) -> tuple[float, float, float, float]:
    """Return a quantity of a path at both ends of a step, and its slopes there per step."""
    first, last, rise, fall = 0.0, 0.0, 0.0, 0.0
    for node in range(AIRS):
        weight = weights[park, node]
        first += weight * seen[point - 1, what, node]
        last += weight * seen[point, what, node]
        rise += weight * seen[point - 1, what + 3, node]
        fall += weight * seen[point, what + 3, node]
    return first, last, rise, fall


@inner(forceinline=True, error_model="numpy")
def _within(step: tuple[float, float, float, float], part: float) -> float:
    """Return a quantity of a path within a step, on the cubic through its ends."""
    first, last, rise, fall = step
    rest = 1 - part
    return (
        rest * rest * (1 + 2 * part) * first
        + part * part * (3 - 2 * part) * last
        + part * rest * (rest * rise - part * fall)
    )


@inner(forceinline=True, error_model="numpy")
def _at(fences: Array, what: int, park: int, direction: float) -> float:
    """Return distance (0) or height (1) of a park's fence in a direction; beyond a foul line that of the line."""
    place = min(max((direction + FOUL) / TABLE_STEP, 0.0), fences.shape[2] - 1.0)
    left = min(int(place), fences.shape[2] - 2)
    low, high = fences[what, park, left], fences[what, park, left + 1]
    return float(low + (place - left) * (high - low))

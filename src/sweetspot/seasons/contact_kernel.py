"""The compiled posterior of where on the bat a ball was hit; see `contact`."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ENDS
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.vector_math import sine_and_cosine
from sweetspot.seasons.place_kernel import FARTHEST, weigh
from sweetspot.seasons.plane_hits import PLACES, STEEPEST, USUAL_TURN, PlaneTable, hit_at, hit_towards

STRIDE = 4
"""Every fourth place of the table is looked up; between them lies the cubic through the nearest four, right to 0.04 mph
for 99 of 100 places (0.02 on the barrel; a straight line through every second one: 0.12)."""
BETWEEN = tuple(
    tuple(
        tuple(
            float(math.prod((at - other) / (node - other) for other in range(4) if other != node)) for node in range(4)
        )
        for at in (first + part / STRIDE for part in range(1, STRIDE))
    )
    for first in range(3)
)
"""Lagrange's weights of four looked-up places, for places after the first, second and third of them."""
TURN = 0.05
"""rad by which the direction is changed to learn what it does."""
LEVELS = (ENDS[0], 0.25, 0.5, 0.75, ENDS[1])
PLACE, DISTANCE = 0, 5
"""First rows of the quantiles of the place and of the distance from the best one."""
OFFSET, OFFSET_SPREAD, TIP_SIDE, RANK, KEPT, EXPECTED, EVIDENCE, SENSITIVE, MEAN_PLACE = range(10, 19)
DRAWN = 19
BESIDE = 0.05
"""m beyond the best place that is looked up at least; a ball's places end `FARTHEST` from where it is thought met."""
ROWS = 20


@inner(error_model="numpy")
def predict(table: PlaneTable, asked: Array, fast: Array, above: Array) -> tuple[float, float]:
    """Fill exit speed and offset at all places of the table; return what a radian changes of both at the fastest.

    ``fast``, ``above``: shape (places,), NaN where no line of centres does it. Change of the logarithm of exit speed
    and of offset per rad; NaN where the ball was only grazed.
    """
    query, turned = (asked[0], asked[1], asked[2], asked[3]), asked[4]
    cos, sin = math.cos(turned), math.sin(turned)
    guess, slope = turned / USUAL_TURN, USUAL_TURN
    best, top, best_guess, best_slope = -1, 0.0, 0.0, slope
    count, before = len(fast), guess
    for place in range(0, count, STRIDE):
        size, offset, solution, slope = hit_towards(table, place, query, cos, sin, guess, slope)
        fast[place], above[place] = size, offset
        if math.isfinite(size):
            guess, before = (2 * solution - before if place else solution), solution
            if size > top:
                best, top, best_guess, best_slope = place, size, solution, slope
    if best < 0:
        return math.nan, math.nan
    for low in range(0, count - 1, STRIDE):
        first = min(max(low - STRIDE, 0), count - 1 - 3 * STRIDE)
        whole = 0.0
        for node in range(first, first + 4 * STRIDE, STRIDE):
            whole += fast[node]
        if math.isfinite(whole):
            weights = BETWEEN[(low - first) // STRIDE]
            for part in range(1, STRIDE):
                _mix(fast, first, low + part, weights[part - 1])
                _mix(above, first, low + part, weights[part - 1])
        elif math.isfinite(fast[low]) or math.isfinite(fast[low + STRIDE]):  # beside places that no such hit is made at
            for place in range(low + 1, low + STRIDE):
                fast[place], above[place], _, _ = hit_towards(table, place, query, cos, sin, best_guess, best_slope)
        else:
            fast[low + 1 : low + STRIDE] = math.nan
            above[low + 1 : low + STRIDE] = math.nan
    step = -TURN if turned > 0 else TURN
    cos, sin = math.cos(turned + step), math.sin(turned + step)
    size, offset, _, _ = hit_towards(table, best, query, cos, sin, best_guess + step / best_slope, best_slope)
    return (size / top - 1) / step, (offset - above[best]) / step


@inner(error_model="numpy")
def _mix(values: Array, first: int, place: int, weights: tuple[float, ...]) -> None:
    """Fill a place from the four looked-up ones that begin with the first."""
    values[place] = (
        weights[0] * values[first]
        + weights[1] * values[first + STRIDE]
        + weights[2] * values[first + 2 * STRIDE]
        + weights[3] * values[first + 3 * STRIDE]
    )


@compiled(nogil=True, error_model="numpy")
def fill_predictions(table: PlaneTable, asked: Array, fast: Array, spread: Array, errors: Array) -> None:
    """Fill exit speeds at all places of n balls, shape (n, places), and the errors they are compared with.

    ``asked``: (n, 7), as `predict` takes it, the angle's error (rad) and the exit speed's for want of a pitch speed
    (m/s). ``errors``: measuring errors of exit speed and bat speed, m/s.
    """
    above = np.empty(fast.shape[1])
    for i in range(len(fast)):
        sensitive, _ = predict(table, asked[i], fast[i], above)
        top = 0.0
        for place in range(fast.shape[1]):
            top = max(top, fast[i, place])
        spread[i] = _spread(asked[i], top, sensitive, errors)


@inner(error_model="numpy")
def _spread(asked: Array, top: float, sensitive: float, errors: Array) -> float:
    """Return the error of a predicted exit speed that the errors of its inputs cause."""
    coming = math.sqrt(asked[1] * asked[1] + asked[2] * asked[2])
    per_speed = (top + coming) / (asked[0] + coming)
    turning = 0.0 if math.isnan(sensitive) else sensitive * top * asked[5]
    return math.sqrt(errors[0] ** 2 + asked[6] ** 2 + (per_speed * errors[1]) ** 2 + turning**2)


@compiled(nogil=True, error_model="numpy")
def fill_posteriors(
    table: PlaneTable, asked: Array, measured: Array, prior: Array, best: Array, errors: Array, level: Array,
    noise: Array, results: Array, weights: Array,
) -> None:  # fmt: skip
    """Fill what is known of each ball's contact.

    ``asked``, ``errors``: as `fill_predictions` takes them. ``measured``: (n,) m/s, exit speed in the plane. ``prior``:
    (n, 2) mean and standard deviation of the place, m from the tip. ``best``: (n, 2) m from the tip, the place of the
    greatest exit speed; and a number between 0 and 1, which part of the posterior the drawn place lies above.
    ``level``, ``noise``: (n,), exit speeds are 1 + level times the table's, and scatter by noise m/s beside measuring
    errors. ``results``: (n, ROWS). ``weights``: (n, places) of zeros, for the posterior; or (0, places) where it is not
    wanted.
    """
    longest, step = len(PLACES), PLACES[1] - PLACES[0]
    every_fast, every_above, every_part = np.empty((3, longest))
    work = np.empty((4, longest))
    for i in range(len(measured)):
        results[i] = math.nan
        farthest = max(prior[i, 0] + FARTHEST * prior[i, 1], best[i, 0] + BESIDE)
        count = min(STRIDE * (int(farthest / (STRIDE * step)) + 1) + 1, longest)
        fast, above, part, places = every_fast[:count], every_above[:count], every_part[:count], PLACES[:count]
        sensitive, per_turn = predict(table, asked[i], fast, above)
        if math.isnan(per_turn):
            continue
        top = 0.0
        for place in range(count):
            top = max(top, fast[place]) if math.isfinite(fast[place]) else top
        spread = math.sqrt(_spread(asked[i], top * (1 + level[i]), sensitive, errors) ** 2 + noise[i] ** 2)
        total, before, rank, mean = weigh(
            places, fast, measured[i], spread, prior[i, 0], prior[i, 1], level[i], part, work
        )
        if not (total > 0 and before > 0):
            continue
        for place in range(count):
            part[place] /= total
        if len(weights):
            weights[i, :count] = part
        _summarise(places, part, above, best[i, 0], best[i, 1], results[i])
        turning = per_turn * asked[i, 5]
        results[i, OFFSET_SPREAD] = math.sqrt(results[i, OFFSET_SPREAD] + turning * turning)
        results[i, RANK], results[i, EXPECTED] = rank / before, (1 + level[i]) * mean / before
        results[i, KEPT], results[i, SENSITIVE] = top, sensitive
        results[i, EVIDENCE] = math.log(total / before)


@inner(error_model="numpy")
def _summarise(places: Array, part: Array, above: Array, best: float, draw: float, result: Array) -> None:
    """Fill quantiles of place and distance, chance of the tip side, and the mean offset and place."""
    step = places[1] - places[0]
    passed, level = 0.0, 0
    offset, tip, mean, square = 0.0, 0.0, 0.0, 0.0
    for place in range(len(part)):
        if part[place] == 0:
            continue
        offset += part[place] * above[place]
        square += part[place] * above[place] * above[place]
        mean += part[place] * places[place]
        share = min(max((best - places[place]) / step + 0.5, 0.0), 1.0)
        tip += part[place] * share
        while level < len(LEVELS) and passed + part[place] >= LEVELS[level]:
            result[PLACE + level] = places[place] + step * ((LEVELS[level] - passed) / part[place] - 0.5)
            level += 1
        if passed <= draw < passed + part[place]:
            result[DRAWN] = places[place] + step * ((draw - passed) / part[place] - 0.5)
        passed += part[place]
    result[OFFSET_SPREAD] = max(square - offset * offset, 0.0)  # of the places alone, squared
    result[OFFSET], result[TIP_SIDE], result[MEAN_PLACE] = offset, tip, mean
    passed = 0.0
    for place in range(len(part)):  # from here on: the part below the upper edge of each cell
        passed += part[place]
        part[place] = passed
    level, inside, reached = 0, 0.0, 0.0
    middle = (best - places[0]) / step + 0.5  # in cells from the lower edge of the first
    edge = middle - math.floor(middle)  # between two edges, to either side, what is inside grows as a straight line
    near, far = min(edge, 1 - edge), max(edge, 1 - edge)
    for turn in range(2 * len(part)):
        before, start = inside, reached
        reached = turn // 2 + (far if turn % 2 else near)
        inside = _below(part, middle + reached) - _below(part, middle - reached)
        while level < len(LEVELS) and inside >= LEVELS[level]:
            result[DISTANCE + level] = step * (
                reached - (reached - start) * (inside - LEVELS[level]) / max(inside - before, 1e-12)
            )
            level += 1
        if level == len(LEVELS):
            return


@inner(forceinline=True, error_model="numpy")
def _below(passed: Array, at: float) -> float:
    """Return the distribution function at a place in cells, from its values at the upper edges of cells."""
    if at <= 0:
        return 0.0
    if at >= len(passed):
        return 1.0
    low = int(at)
    under = passed[low - 1] if low > 0 else 0.0
    return float(under + (at - low) * (passed[low] - under))


@compiled(nogil=True, error_model="numpy")
def fill_other_bat(
    table: PlaneTable, asked: Array, offset: Array, weights: Array, ratio: float, mean: Array, spread: Array
) -> None:
    """Fill mean and standard deviation, over where a ball was met, of its exit speed with another bat.

    The other bat meets it equally far from the tip, with the same offset, turning so that its speed where bat speed is
    measured is ``ratio`` times the own.
    """
    for i in range(len(mean)):
        total, square, counted = 0.0, 0.0, 0.0
        for place in range(weights.shape[1]):
            weight = weights[i, place]
            if weight < 1e-4:
                continue
            there = ratio * asked[i, 0] * table.arm[place]
            way, across = there - asked[i, 1], -asked[i, 2]
            closing = math.sqrt(way * way + across * across)
            way, across = way / closing, across / closing
            rise = math.asin(min(max(offset[i] / table.reach[place], -0.99), 0.99))
            angle = min(max(rise - math.atan2(across, way), -STEEPEST), STEEPEST)
            sine, cosine = sine_and_cosine(angle)
            turning = ratio * asked[i, 0] * table.turning[place] * (way * cosine - across * sine)
            back, lift = hit_at(table, place, closing, asked[i, 3], turning, sine, cosine)
            out = there + closing * (way * back - across * lift)
            high = closing * (across * back + way * lift)
            size = math.sqrt(out * out + high * high)
            if math.isfinite(size):
                total += weight * size
                square += weight * size * size
                counted += weight
        if counted > 0.5:
            mean[i] = total / counted
            spread[i] = math.sqrt(max(square / counted - mean[i] ** 2, 0.0))
        else:
            mean[i] = spread[i] = math.nan

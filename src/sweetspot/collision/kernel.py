"""The coupled collision, many hits at once: arrays in, arrays out, the same time step as `coupled`.

`LANES` hits advance side by side; every loop over lanes is straight-line arithmetic, which the compiler turns into
vector instructions. The kernel is serial and releases the GIL, so threads, processes or a cluster work outside it.
"""

from __future__ import annotations

import math
import os
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from llvmlite import ir
from numba import njit, types
from numba.extending import intrinsic
from numpy.typing import ArrayLike

from sweetspot.ball import COR_FLOOR, Ball
from sweetspot.collision.coupled import TIME_LIMIT, check_step
from sweetspot.collision.impact import CONTACT_FORCE, Array, Impacts, Outcome
from sweetspot.collision.propagator import propagator
from sweetspot.vibration.modes import Modes

LANES = 64
"""Most hits side by side; fewer hits than that take only the lanes they need, in fours."""
STEP = 14e-6
"""s; exit speeds are within 1e-4 of the converged ones for hits at game speed (`make bench` prints the curve)."""
CHUNK = 8192
"""Hits per task handed to a thread."""

SEPARATED, STILL_IN_CONTACT, NO_CONTACT = (
    int(Outcome.SEPARATED), int(Outcome.STILL_IN_CONTACT), int(Outcome.NO_CONTACT),
)  # fmt: skip


def hits(
    modes: Modes,
    *,
    ball: Ball,
    position: ArrayLike,
    closing_speed: ArrayLike,
    step: float = STEP,
    keep_motion: bool = True,
    threads: int | None = None,
) -> Impacts:
    """Return many collisions with one bat; every row ends with its own outcome.

    Parameters
    ----------
    position, closing_speed : m from the knob end and m/s, broadcast together to shape (hits,).
    step : s, > 0.
    keep_motion : whether to return the bat's modal motion at release (224 bytes per hit).
    threads : workers; None: one per core, and one only for small batches.
    """
    check_step(step)
    places, speeds = np.broadcast_arrays(np.asarray(position, float), np.asarray(closing_speed, float))
    places, speeds = places.ravel(), np.ascontiguousarray(speeds.ravel())
    count, size = len(speeds), len(modes)
    outcome = np.empty(count, np.int64)
    results = np.empty((5, count))
    motion = np.empty((2, count if keep_motion else 0, size))
    drift = propagator(modes, step)
    law = ball.restitution
    constants = np.array(
        [ball.mass, ball.stiffness, ball.exponent, law.reference, law.slope, law.reference_speed, COR_FLOOR]
    )

    def work(part: slice) -> None:
        shapes = np.ascontiguousarray(modes.shape_at(places[part]))
        kept = motion[:, part] if keep_motion else motion
        lanes = min(LANES, 4 * math.ceil(len(shapes) / 4))
        _solve(
            lanes, speeds[part], shapes, drift, constants, step, float(round(TIME_LIMIT / step)),
            outcome[part], results[:, part], kept,
        )  # fmt: skip

    parts = list(_slices(count))
    workers = min(threads or os.cpu_count() or 1, len(parts))
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(work, parts))
    else:
        for part in parts:
            work(part)
    return Impacts(outcome, *results, *motion)


def _slices(count: int) -> Iterator[slice]:
    for start in range(0, count, CHUNK):
        yield slice(start, min(start + CHUNK, count))


@intrinsic  # type: ignore[untyped-decorator]
def _bits_of(typing_context: Any, value: Any) -> Any:
    """Return the 64 bits of a float as an integer."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], ir.IntType(64))

    return types.int64(types.float64), generate


@intrinsic  # type: ignore[untyped-decorator]
def _float_of(typing_context: Any, bits: Any) -> Any:
    """Return the float that has these 64 bits."""

    def generate(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        return builder.bitcast(arguments[0], ir.DoubleType())

    return types.float64(types.int64), generate


ROOT_HALF_BITS = 0x3FE6A09E667F3BCD
MAGIC = 6755399441055744.0  # 1.5 * 2^52: adding it leaves the nearest integer in the low bits
MAGIC_BITS = 0x4338000000000000
LN2_HIGH, LN2_LOW = 6.93147180369123816490e-01, 1.90821492927058770002e-10
@njit(inline="always", cache=True)  # type: ignore[untyped-decorator]
def _log(value: float) -> float:
    """Natural logarithm of a positive normal number without branches; relative error below 1e-15.

    value = 2^e m with m in [sqrt(1/2), sqrt(2)), log m = 2 atanh((m - 1) / (m + 1)).
    """
    bits = _bits_of(value)
    exponent = (bits - ROOT_HALF_BITS) >> 52
    mantissa = _float_of(bits - (exponent << 52))
    number = _float_of(exponent + MAGIC_BITS) - MAGIC
    ratio = (mantissa - 1.0) / (mantissa + 1.0)
    square = ratio * ratio
    fourth = square * square
    eighth = fourth * fourth
    low = (2.0 + square * (2 / 3)) + fourth * (2 / 5 + square * (2 / 7))
    middle = (2 / 9 + square * (2 / 11)) + fourth * (2 / 13 + square * (2 / 15))
    high = (2 / 17 + square * (2 / 19)) + fourth * (2 / 21)
    total = low + eighth * (middle + eighth * high)
    return number * LN2_HIGH + (number * LN2_LOW + ratio * total)


@njit(inline="always", cache=True)  # type: ignore[untyped-decorator]
def _exp(value: float) -> float:
    """Exponential without branches for -700 < value < 700; below that it is cut off at exp(-700)."""
    value = max(value, -700.0)
    shifted = value * 1.4426950408889634 + MAGIC
    number = shifted - MAGIC
    rest = (value - number * LN2_HIGH) - number * LN2_LOW
    square = rest * rest
    fourth = square * square
    low = (1.0 + rest) + square * (1 / 2 + rest * (1 / 6))
    middle = (1 / 24 + rest * (1 / 120)) + square * (1 / 720 + rest * (1 / 5040))
    high = (1 / 40320 + rest * (1 / 362880)) + square * (1 / 3628800 + rest * (1 / 39916800))
    top = 1 / 479001600 + rest * (1 / 6227020800)
    total = (low + fourth * middle) + (fourth * fourth) * (high + fourth * top)
    return total * _float_of((_bits_of(shifted) - MAGIC_BITS + 1023) << 52)


@njit(cache=True)  # type: ignore[untyped-decorator]
def _unloading(peak: float, constants: Array) -> tuple[float, float]:
    """Return (a, b) of the unloading curve F = exp(a + b log u) from a peak compression."""
    mass, stiffness, exponent, reference, slope, reference_speed, floor = constants
    stored = stiffness * peak ** (exponent + 1) / (exponent + 1)
    wall_speed = math.sqrt(2 * stored / mass)
    restitution = min(1.0, max(floor, reference - slope * (wall_speed - reference_speed)))
    power = (exponent + 1) / restitution**2 - 1
    return math.log(stiffness) + (exponent - power) * math.log(peak), power


@njit(inline="always", cache=True)  # type: ignore[untyped-decorator]
def _crossing(start: float, start_rate: float, end: float, end_rate: float, step: float) -> float:
    """Return when the cubic through both ends of a step crosses zero, s after its start, by Newton's method."""
    fraction = start / (start - end)
    for _ in range(6):
        rest = 1.0 - fraction
        left = start * (1 + 2 * fraction) + start_rate * step * fraction
        right = end * (3 - 2 * fraction) - end_rate * step * rest
        value = rest * rest * left + fraction * fraction * right
        slope = 6 * fraction * rest * (end - start) + step * (
            start_rate * rest * (1 - 3 * fraction) + end_rate * fraction * (3 * fraction - 2)
        )
        fraction = min(1.0, max(0.0, fraction - value / slope))
    return step * fraction


# rows of the lanes' state
CLOSING, BALL_POSITION, BALL_SPEED, SURFACE, COMPRESSION, BEFORE, EARLIER = range(7)
PEAK, RISING, OFFSET, POWER, IMPULSE, LARGEST, KICKS, INVERSE_MASS, FORCE, CONTACT = range(7, 17)
STATE_ROWS = 17


@njit(nogil=True, cache=True, fastmath={"contract", "nsz"}, error_model="numpy")  # type: ignore[untyped-decorator]
def _solve(lanes, closing_speed, shapes, drift, constants, step, limit, outcome, results, motion):  # type: ignore[no-untyped-def]
    """Fill outcome (n,), results (5, n) and motion (2, n, modes) for n hits.

    Every lane carries one hit; when it ends, the lane takes the next hit, so that no lane waits for another.
    """
    count, size = shapes.shape
    mass = constants[0]
    state = np.zeros((STATE_ROWS, lanes))
    shape, displacement, velocity = np.empty((size, lanes)), np.empty((size, lanes)), np.empty((size, lanes))
    hit_of = np.empty(lanes, np.int64)
    following, busy = 0, 0
    for lane in range(lanes):
        following = _start(lane, following, closing_speed, shapes, constants, step,
                           state, shape, displacement, velocity, hit_of, outcome, results, motion)  # fmt: skip
        busy += hit_of[lane] >= 0
    ball_position, ball_speed, surface = state[BALL_POSITION], state[BALL_SPEED], state[SURFACE]
    compression, before, earlier = state[COMPRESSION], state[BEFORE], state[EARLIER]
    peak, rising, kicks = state[PEAK], state[RISING], state[KICKS]
    offset, power, impulse, largest = state[OFFSET], state[POWER], state[IMPULSE], state[LARGEST]
    force, contact = state[FORCE], state[CONTACT]
    inverse_mass, event = state[INVERSE_MASS], np.zeros(lanes)

    # Many short loops: the compiler turns a loop into vector instructions only when it touches few arrays.
    while busy > 0:
        any_event = 0.0
        for lane in range(lanes):
            earlier[lane] = before[lane]
            before[lane] = compression[lane]
        for lane in range(lanes):
            compression[lane] = ball_position[lane] - surface[lane]
            surface[lane] = 0.0
            kicks[lane] += 1.0
        for lane in range(lanes):
            up = 1.0 if compression[lane] >= peak[lane] else 0.0
            gone = 1.0 if compression[lane] <= 0.0 else 0.0
            late = 1.0 if kicks[lane] > limit else 0.0
            event[lane] = max(abs(up - rising[lane]), max(gone, late))
        for lane in range(lanes):
            any_event = max(any_event, event[lane])
            peak[lane] = max(peak[lane], compression[lane])
        if any_event > 0.0:
            for lane in range(lanes):
                if event[lane] == 0.0:
                    continue
                if compression[lane] <= 0 or kicks[lane] > limit:
                    _finish(lane, drift, step, state, shape, displacement, velocity, hit_of, outcome, results, motion)
                    following = _start(lane, following, closing_speed, shapes, constants, step,
                                       state, shape, displacement, velocity, hit_of, outcome, results, motion)  # fmt: skip
                    kicks[lane] += 1.0
                    busy -= hit_of[lane] < 0
                else:
                    _turn(lane, constants, step, state)
        for lane in range(lanes):
            impulse[lane] = _exp(offset[lane] + power[lane] * _log(compression[lane]))
        for lane in range(lanes):
            largest[lane] = max(largest[lane], impulse[lane])
        for lane in range(lanes):
            ebbing = (force[lane] >= CONTACT_FORCE * largest[lane]) & (impulse[lane] < CONTACT_FORCE * largest[lane])
            part = (force[lane] - CONTACT_FORCE * largest[lane]) / (force[lane] - impulse[lane])
            contact[lane] = kicks[lane] + part if ebbing else contact[lane]
        for lane in range(lanes):
            force[lane] = impulse[lane]
        for lane in range(lanes):
            slope = power[lane] * impulse[lane] / compression[lane]
            impulse[lane] *= step * (1.0 - step**2 / 12 * inverse_mass[lane] * slope)
        for lane in range(lanes):
            ball_speed[lane] -= impulse[lane] / mass
            ball_position[lane] += ball_speed[lane] * step
        for i in range(size):
            a, b, c, d = drift[i, 0, 0], drift[i, 0, 1], drift[i, 1, 0], drift[i, 1, 1]
            modal_shape, q, p = shape[i], displacement[i], velocity[i]
            for lane in range(lanes):
                start = p[lane] + modal_shape[lane] * impulse[lane]
                moved = a * q[lane] + b * start
                p[lane] = c * q[lane] + d * start
                q[lane] = moved
                surface[lane] += modal_shape[lane] * moved


@njit(cache=True)  # type: ignore[untyped-decorator]
def _start(lane, following, closing_speed, shapes, constants, step, state, shape, displacement, velocity,
           hit_of, outcome, results, motion):  # type: ignore[no-untyped-def]  # fmt: skip
    """Put the next hit that makes contact into a lane, or leave the lane idle; return the hit after it."""
    count, size = shapes.shape
    while following < count and not closing_speed[following] > 0:
        outcome[following] = NO_CONTACT
        results[:, following] = np.nan
        if motion.shape[1]:
            motion[:, following] = 0.0
        following += 1
    mass, stiffness, exponent = constants[0], constants[1], constants[2]
    idle = following >= count
    hit_of[lane] = -1 if idle else following
    speed = 0.0 if idle else closing_speed[following]
    inverse_mass = 1 / mass
    for i in range(size):
        shape[i, lane] = 0.0 if idle else shapes[following, i]
        inverse_mass += shape[i, lane] ** 2
        displacement[i, lane] = 0.0
        velocity[i, lane] = 0.0
    state[CLOSING, lane] = speed
    state[BALL_SPEED, lane] = speed
    state[BALL_POSITION, lane] = 1.0 if idle else speed * step / 2
    state[SURFACE, lane] = 0.0
    state[COMPRESSION, lane] = state[BALL_POSITION, lane]
    state[BEFORE, lane] = 0.0
    state[EARLIER, lane] = 0.0
    state[PEAK, lane] = 2.0 if idle else state[BALL_POSITION, lane]
    state[RISING, lane] = 0.0 if idle else 1.0
    state[OFFSET, lane] = -1e9 if idle else math.log(stiffness)
    state[POWER, lane] = exponent
    state[LARGEST, lane] = 0.0
    state[KICKS, lane] = -np.inf if idle else 0.0
    state[INVERSE_MASS, lane] = inverse_mass
    state[FORCE, lane] = 0.0
    state[CONTACT, lane] = 0.0
    return following + 1


@njit(cache=True)  # type: ignore[untyped-decorator]
def _turn(lane, constants, step, state):  # type: ignore[no-untyped-def]
    """Change a lane from loading to unloading, at the top of the parabola through three kicks, or back."""
    latest, peak = state[COMPRESSION, lane], state[PEAK, lane]
    if latest >= peak and state[RISING, lane] == 0.0:
        state[RISING, lane] = 1.0
        state[OFFSET, lane], state[POWER, lane] = math.log(constants[1]), constants[2]
    elif latest < peak and state[RISING, lane] == 1.0:
        state[RISING, lane] = 0.0
        if state[KICKS, lane] > 2:
            first, middle = state[EARLIER, lane], state[BEFORE, lane]
            peak = max(peak, middle - (latest - first) ** 2 / (8 * (first - 2 * middle + latest)))
            peak -= step**2 / 12 * state[INVERSE_MASS, lane] * constants[1] * peak ** constants[2]
        state[PEAK, lane] = peak
        state[OFFSET, lane], state[POWER, lane] = _unloading(peak, constants)


@njit(cache=True)  # type: ignore[untyped-decorator]
def _finish(lane, drift, step, state, shape, displacement, velocity, hit_of, outcome, results, motion):  # type: ignore[no-untyped-def]
    """Write the results of a lane whose ball has left, or whose time is up."""
    row = hit_of[lane]
    size = len(drift)
    separated = state[COMPRESSION, lane] <= 0
    outcome[row] = SEPARATED if separated else STILL_IN_CONTACT
    results[3, row] = state[LARGEST, lane]
    results[4, row] = state[PEAK, lane]
    results[0, row] = results[1, row] = results[2, row] = np.nan
    if separated:
        rate, rate_before = state[BALL_SPEED, lane], state[BALL_SPEED, lane]
        for i in range(size):
            a, b, c, d = drift[i, 0, 0], drift[i, 0, 1], drift[i, 1, 0], drift[i, 1, 1]
            start = (a * velocity[i, lane] - c * displacement[i, lane]) / (a * d - b * c)  # undo the drift
            rate -= shape[i, lane] * velocity[i, lane]
            rate_before -= shape[i, lane] * start
        crossing = _crossing(state[BEFORE, lane], rate_before, state[COMPRESSION, lane], rate, step)
        results[0, row] = -state[BALL_SPEED, lane] / state[CLOSING, lane]
        results[1, row] = (state[CONTACT, lane] - 1.5) * step
        results[2, row] = (state[KICKS, lane] - 1.5) * step + crossing
    if motion.shape[1]:
        motion[0, row] = displacement[:, lane]
        motion[1, row] = velocity[:, lane]

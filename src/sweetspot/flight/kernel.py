"""Many flights at once: arrays in, arrays out, the same method as `trajectory`.

The kernel is serial and releases the GIL, so threads, processes or a cluster work outside it.
"""

from __future__ import annotations

import math
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import ArrayLike, NDArray

from sweetspot.aerodynamics import SMALLEST_SPIN_FACTOR, Aerodynamics
from sweetspot.air import CALM, Air, Wind
from sweetspot.ball import Ball
from sweetspot.collision.vector_math import exp, log
from sweetspot.errors import InputError
from sweetspot.flight import cubic
from sweetspot.flight.forces import SLOWEST
from sweetspot.flight.trajectory import MOST_STEPS, SLOW, TIME_LIMIT, FlightOutcome, check_step
from sweetspot.rigid import STANDARD_GRAVITY

Array = NDArray[np.float64]
IntArray = NDArray[np.int64]
State = tuple[float, float, float, float, float, float, float]
"""Position, velocity and the part of the spin that is left."""
Flown = tuple[tuple[float, float, float, float], float]
"""Of one flight: spin with its size, and drag acceleration per Cd and square of the speed."""

STEP = 0.4
"""s; carries of baseballs are within 0.01 ft of the converged ones (`make bench` prints the curve)."""
CHUNK = 4096
"""Flights per task handed to a thread."""
MOST_PATH_POINTS = 10_000

LANDED, STILL_FLYING, UNDERGROUND, UNUSABLE = (
    int(FlightOutcome.LANDED), int(FlightOutcome.STILL_FLYING), int(FlightOutcome.UNDERGROUND),
    int(FlightOutcome.UNUSABLE),
)  # fmt: skip


@dataclass(frozen=True)
class Flights:
    """Many flights; every array has one row per flight, and rows that did not land have nan.

    Parameters
    ----------
    outcome : `FlightOutcome` of every row, shape (n,).
    carry : m over the ground from the tip of home plate, shape (n,).
    hang_time : s, shape (n,).
    apex_height, apex_time : m above the ground and s, shape (n,).
    landing_position, landing_velocity : m and m/s, shape (n, 3).
    spin_left : part of the spin that is left at landing, shape (n,).
    times : s, shape (n, k), evenly from launch to landing, where a path was asked for, otherwise (n, 0).
    positions : m, shape (n, k, 3), the ball at these times.
    """

    outcome: IntArray
    carry: Array
    hang_time: Array
    apex_height: Array
    apex_time: Array
    landing_position: Array
    landing_velocity: Array
    spin_left: Array
    times: Array
    positions: Array

    def __len__(self) -> int:
        return len(self.outcome)

    @property
    def landed(self) -> NDArray[np.bool_]:
        """Which flights came down, shape (n,)."""
        return np.asarray(self.outcome == LANDED)

    @property
    def landing_angle(self) -> Array:
        """How steeply each ball comes down, rad below the level, shape (n,)."""
        level = np.hypot(self.landing_velocity[:, 0], self.landing_velocity[:, 1])
        return np.arctan2(-self.landing_velocity[:, 2], level)


def flights(
    position: ArrayLike,
    velocity: ArrayLike,
    spin: ArrayLike,
    *,
    ball: Ball,
    aerodynamics: Aerodynamics,
    air: Air | ArrayLike,
    wind: Wind | ArrayLike = CALM,
    path_points: int = 0,
    step: float = STEP,
    threads: int | None = None,
) -> Flights:
    """Return many flights of one kind of ball; every row ends with its own outcome.

    Parameters
    ----------
    position, velocity, spin : m, m/s and rad/s in the frame of the field, shape (3,) or (n, 3), broadcast together.
    air : one air for all, or the density for every row, kg/m^3, shape (n,).
    wind : one wind for all, or a wind alike at every height for every row, m/s, shape (n, 2): to the right and out.
    path_points : how many points of each path to return, evenly in time; 0: none (24 bytes each).
    step : s, > 0; the error falls with its fourth power.
    threads : workers; None: one per core, and one only for small batches.
    """
    check_step(step)
    if not 0 <= path_points <= MOST_PATH_POINTS or path_points == 1:
        raise InputError(f"path_points is {path_points}; allowed is 0 (no path) or 2 to {MOST_PATH_POINTS}")
    start = _rows(position, velocity, spin, air, wind)
    count = start.shape[1]
    outcome = np.empty(count, np.int64)
    results = np.empty((RESULT_ROWS, count))
    paths = np.empty((count, path_points, 3))
    constants = _constants(ball, aerodynamics, wind)
    power = None if aerodynamics.lift_exponent == 1 else aerodynamics.lift_exponent
    profile = wind.exponent if isinstance(wind, Wind) and wind.exponent and wind.speed else None

    def work(part: slice) -> None:
        solve(
            np.ascontiguousarray(start[:, part]), constants, power, profile, step,
            outcome[part], results[:, part], paths[part],
        )  # fmt: skip

    parts = [slice(first, min(first + CHUNK, count)) for first in range(0, count, CHUNK)]
    workers = min(threads or os.cpu_count() or 1, len(parts))
    if workers > 1:
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(work, parts))
    else:
        for part in parts:
            work(part)
    hang = results[HANG]
    return Flights(
        outcome=outcome,
        carry=np.hypot(results[0], results[1]),
        hang_time=hang,
        apex_height=results[APEX_HEIGHT],
        apex_time=results[APEX_TIME],
        landing_position=results[0:3].T,
        landing_velocity=results[3:6].T,
        spin_left=results[6],
        times=hang[:, None] * np.linspace(0, 1, path_points)[None, :],
        positions=paths,
    )


def _rows(
    position: ArrayLike, velocity: ArrayLike, spin: ArrayLike, air: Air | ArrayLike, wind: Wind | ArrayLike
) -> Array:  # fmt: skip
    """Return what differs between flights, shape (12, n): position, velocity, spin, density, wind right and out."""
    density = np.asarray(air.density) if isinstance(air, Air) else np.atleast_1d(np.asarray(air, float))
    blowing = np.asarray(wind.velocity[:2]) if isinstance(wind, Wind) else np.asarray(wind, float)
    columns = [np.asarray(values, float) for values in (position, velocity, spin)]
    for values, size, what in (*zip(columns, (3, 3, 3), ("position", "velocity", "spin"), strict=True),
                               (blowing, 2, "wind")):  # fmt: skip
        if values.ndim not in {1, 2} or values.shape[-1] != size:
            raise InputError(f"{what} has the shape {values.shape}; allowed is ({size},) or (flights, {size})")
    try:
        (count,) = np.broadcast_shapes(
            *(values.shape[:-1] for values in columns), blowing.shape[:-1], density.shape
        ) or (1,)
    except ValueError:
        shapes = ", ".join(str(values.shape) for values in (*columns, blowing, density))
        raise InputError(
            f"position, velocity, spin, wind and air have the shapes {shapes}; give each one row, or the same number"
        ) from None
    start = np.empty((INPUT_ROWS, count))
    for first, values in zip((0, 3, 6, 10), (*columns, blowing), strict=True):
        start[first : first + values.shape[-1]] = np.broadcast_to(values, (count, values.shape[-1])).T
    start[9] = density
    return start


def _constants(ball: Ball, aerodynamics: Aerodynamics, wind: Wind | ArrayLike) -> Array:
    """Return the numbers that every flight shares, in the order `_push` and `solve` take them."""
    edge, height = (wind.calm_below, wind.reference_height) if isinstance(wind, Wind) else (0.0, 1.0)
    return np.array(
        [
            math.pi * ball.radius**2 / (2 * ball.mass), ball.radius, aerodynamics.drag, aerodynamics.drag_per_spin,
            aerodynamics.drag_per_spin_factor, aerodynamics.lift_scale, aerodynamics.lift_offset,
            aerodynamics.lift_slope, aerodynamics.spin_decay_rate, edge, height,
        ]
    )  # fmt: skip


INPUT_ROWS = 12
HANG, APEX_HEIGHT, APEX_TIME = 7, 8, 9
RESULT_ROWS = 10

_on_cubic = njit(cache=True)(cubic.on_cubic)
_turn_on_cubic = njit(cache=True)(cubic.turn_on_cubic)
_root_on_cubic = njit(cache=True)(cubic.root_on_cubic)


@njit(forceinline=True, error_model="numpy")
def _rates(
    height: float, right: float, out: float, up: float, left: float, spin: tuple[float, float, float, float],
    strength: float, wind: tuple[float, float], shared: tuple[float, ...], power: float | None, profile: float | None,
) -> tuple[float, float, float, float, float]:  # fmt: skip
    """Return (acceleration right, out, up; change of the spin left; how fast the air changes the velocity)."""
    radius, drag, per_spin, per_factor, scale, offset, slope, decay, reference = shared
    blowing = 1.0
    if profile is not None:
        blowing = exp(profile * log(max(height, 1e-300) / reference))
    right -= blowing * wind[0]
    out -= blowing * wind[1]
    square = max(right * right + out * out + up * up, SLOWEST**2)
    speed = math.sqrt(square)
    across_right = left * (spin[1] * up - spin[2] * out)
    across_out = left * (spin[2] * right - spin[0] * up)
    across_up = left * (spin[0] * out - spin[1] * right)
    across = math.sqrt(across_right * across_right + across_out * across_out + across_up * across_up)
    factor = radius * across / square
    lift = radius * scale / (offset + slope * factor)
    if power is not None:
        floored = max(factor, SMALLEST_SPIN_FACTOR)
        raised = exp(power * log(floored))
        lift = radius * scale * raised / floored / (offset + slope * raised)
    braking = strength * speed * (drag + per_spin * left * spin[3] + per_factor * factor)
    lift *= strength
    return (
        lift * across_right - braking * right,
        lift * across_out - braking * out,
        lift * across_up - braking * up - STANDARD_GRAVITY,
        -decay * speed * left,
        braking + lift * across / speed,
    )


@njit(cache=True, error_model="numpy", fastmath={"contract", "nsz"})
def _stepped(
    state: State, step: float, row: Flown, wind: tuple[float, float], shared: tuple[float, ...], power: float | None,
    profile: float | None,
) -> State:  # fmt: skip
    """Return a state one step later, by Runge's and Kutta's classical method."""
    x, y, z, vx, vy, vz, left = state
    spin, strength = row
    half, sixth = step / 2, step / 6
    ax, ay, az, worn, _ = _rates(z, vx, vy, vz, left, spin, strength, wind, shared, power, profile)
    bx, by, bz = vx + half * ax, vy + half * ay, vz + half * az
    cx, cy, cz, worn_2, _ = _rates(
        z + half * vz, bx, by, bz, left + half * worn, spin, strength, wind, shared, power, profile
    )
    dx, dy, dz = vx + half * cx, vy + half * cy, vz + half * cz
    ex, ey, ez, worn_3, _ = _rates(
        z + half * bz, dx, dy, dz, left + half * worn_2, spin, strength, wind, shared, power, profile
    )
    fx, fy, fz = vx + step * ex, vy + step * ey, vz + step * ez
    gx, gy, gz, worn_4, _ = _rates(
        z + step * dz, fx, fy, fz, left + step * worn_3, spin, strength, wind, shared, power, profile
    )
    return (
        x + sixth * (vx + 2 * (bx + dx) + fx), y + sixth * (vy + 2 * (by + dy) + fy),
        z + sixth * (vz + 2 * (bz + dz) + fz), vx + sixth * (ax + 2 * (cx + ex) + gx),
        vy + sixth * (ay + 2 * (cy + ey) + gy), vz + sixth * (az + 2 * (cz + ez) + gz),
        left + sixth * (worn + 2 * (worn_2 + worn_3) + worn_4),
    )  # fmt: skip


@njit(nogil=True, cache=True, error_model="numpy", fastmath={"contract", "nsz"})
def solve(
    start: Array, constants: Array, power: float | None, profile: float | None, step: float,
    outcome: IntArray, results: Array, paths: Array,
) -> None:  # fmt: skip
    """Fill outcome, results and paths for n flights; see `trajectory._Solver.advanced` for the readable form.

    Parameters
    ----------
    start : (12, n), see `_rows`.
    constants : see `_constants`.
    power, profile : exponents of the lift law and of the wind, None for 1 and for a wind alike at every height.
    """
    edge = constants[9]
    shared = (
        constants[1], constants[2], constants[3], constants[4], constants[5], constants[6], constants[7], constants[8],
        constants[10],
    )  # fmt: skip
    for i in range(start.shape[1]):
        outcome[i] = _flown(i, start, constants[0], shared, edge, power, profile, step, results, paths[i, :0])
        if outcome[i] == LANDED and paths.shape[1]:
            _flown(i, start, constants[0], shared, edge, power, profile, step, results, paths[i])
        if outcome[i] != LANDED:
            results[:, i] = np.nan
            paths[i] = np.nan


@njit(cache=True, error_model="numpy", fastmath={"contract", "nsz"})
def _flown(
    i: int, start: Array, per_density: float, shared: tuple[float, ...], edge: float, power: float | None,
    profile: float | None, step: float, results: Array, path: Array,
) -> int:  # fmt: skip
    """Fly one row and fill its results, or its path at even times once the results hold its hang time."""
    sound = start[9, i] >= 0
    for value in range(INPUT_ROWS):
        sound = sound and math.isfinite(start[value, i])
    if not sound:
        return UNUSABLE
    if start[2, i] < 0:
        return UNDERGROUND
    spin = (
        start[6, i], start[7, i], start[8, i], math.sqrt(start[6, i] ** 2 + start[7, i] ** 2 + start[8, i] ** 2)
    )  # fmt: skip
    row = (spin, per_density * start[9, i])
    state = (start[0, i], start[1, i], start[2, i], start[3, i], start[4, i], start[5, i], 1.0)
    time, highest, highest_time, filled = 0.0, state[2], 0.0, 0
    landed = state[2] <= 0 and state[5] <= 0
    between = results[HANG, i] / max(len(path) - 1, 1) if len(path) else 0.0
    steps = 0
    while not landed and time < TIME_LIMIT and steps < MOST_STEPS:
        steps += 1
        height, climb = state[2], state[5]
        sheltered = height < edge or (height == edge and climb < 0)
        wind = (0.0, 0.0) if sheltered else (start[10, i], start[11, i])
        response = _rates(height, state[3], state[4], climb, state[6], spin, row[1], wind, shared, power, profile)[4]
        length = step / max(1.0, SLOW * response)
        after = _stepped(state, length, row, wind, shared, power, profile)
        if height < edge < after[2] or after[2] < edge < height:
            length *= _root_on_cubic(height - edge, after[2] - edge, length * climb, length * after[5], 0.0, 1.0)
            after = _stepped(state, length, row, wind, shared, power, profile)
            after = (after[0], after[1], edge, after[3], after[4], after[5], after[6])
        rise, fall = length * climb, length * after[5]
        low, high = 0.0, 1.0
        if climb * after[5] < 0:
            turn = _turn_on_cubic(height, after[2], rise, fall)
            top = _on_cubic(turn, height, after[2], rise, fall)
            if climb > 0:
                low = turn
                if top > highest:
                    highest, highest_time = top, time + turn * length
            else:
                high = turn
        if _on_cubic(high, height, after[2], rise, fall) <= 0:
            length *= _root_on_cubic(height, after[2], rise, fall, low, high)
            after = _stepped(state, length, row, wind, shared, power, profile)
            after = (after[0], after[1], 0.0, after[3], after[4], after[5], after[6])
            landed = True
        while filled < len(path) and (filled * between <= time + length or landed):
            part = min(1.0, (filled * between - time) / length)
            for axis in range(3):
                path[filled, axis] = _on_cubic(
                    part, state[axis], after[axis], length * state[3 + axis], length * after[3 + axis]
                )
            filled += 1
        state, time = after, time + length
    if len(path):
        for point in range(filled, len(path)):
            path[point, 0], path[point, 1], path[point, 2] = state[0], state[1], state[2]
        return LANDED
    for value in range(7):
        results[value, i] = state[value]
    results[HANG, i], results[APEX_HEIGHT, i], results[APEX_TIME, i] = time, highest, highest_time
    return LANDED if landed else STILL_FLYING

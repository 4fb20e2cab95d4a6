"""Many flights at once: arrays in, arrays out, the same method as `trajectory`.

The compiled part (`lanes`) is serial and releases the GIL, so threads, processes or a cluster work outside it.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.flight.compiled import (
    APEX_HEIGHT,
    APEX_TIME,
    DENSITY,
    HANG,
    INPUT_ROWS,
    LANDED,
    RESULT_ROWS,
    SPIN_LEFT,
    FlightLaw,
    FlightMethod,
    FlightOutput,
    solve,
)
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import check_step
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.notebook_display import ShownInNotebooks
from sweetspot.numerics.threads import in_parts

STEP = 0.2
"""s; carries of baseballs are within 0.001 ft of the converged ones (`make bench` prints the curve)."""
CHUNK = 4096
"""Flights per task handed to a thread."""
MOST_PATH_POINTS = 10_000


@dataclass(frozen=True)
class Flights(ShownInNotebooks):
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

    def __repr__(self) -> str:
        """Return the number of flights and of those that landed."""
        return f"<{len(self)} flights, {int(self.landed.sum())} landed>"

    @property
    def landed(self) -> NDArray[np.bool_]:
        """Which flights came down, shape (n,)."""
        return np.asarray(self.outcome == LANDED)

    @property
    def bearing(self) -> Array:
        """Direction in which each ball comes down, rad from centre field, positive to right field, shape (n,)."""
        return np.arctan2(self.landing_position[:, 0], self.landing_position[:, 1])

    @property
    def landing_angle(self) -> Array:
        """Descent angle of each ball, rad below horizontal, shape (n,)."""
        level = np.hypot(self.landing_velocity[:, 0], self.landing_velocity[:, 1])
        return np.arctan2(-self.landing_velocity[:, 2], level)


def flights(
    motions: BallMotion | BallMotions,
    conditions: FlightConditions,
    *,
    path_points: int = 0,
    step: float = STEP,
    threads: int | None = None,
) -> Flights:
    """Return many flights of one kind of ball; every row ends with its own outcome.

    Parameters
    ----------
    motions : the balls as they leave the bat, in the frame of the field; shapes are broadcast together.
    conditions : ball and drag law; air and wind, for all or one for each flight.
    path_points : how many points of each path to return, evenly in time; 0: none (24 bytes each).
    step : s, > 0; the error falls with its fourth power.
    threads : workers; None: one per core, and one only for small batches.

    >>> import numpy as np
    >>> from sweetspot import batted_ball, standard_flight
    >>> from sweetspot.flight.kernel import flights
    >>> balls = batted_ball(speed=[40.0, 46.0], launch_angle=np.radians(28), backspin=240.0)
    >>> flights(balls, standard_flight()).carry.round()  # m
    array([102., 122.])
    """
    check_step(step)
    if not 0 <= path_points <= MOST_PATH_POINTS or path_points == 1:
        raise InputError(f"path_points is {path_points}; allowed is 0 (no path) or 2 to {MOST_PATH_POINTS}")
    start = flight_rows(motions, conditions)
    count = start.shape[1]
    outcome = np.empty(count, np.int64)
    results = np.empty((RESULT_ROWS, count))
    paths = np.empty((count, path_points, 3))
    method = flight_method(conditions, step)

    def work(part: slice) -> None:
        mine = np.ascontiguousarray(start[:, part])
        part_results = np.empty((RESULT_ROWS, mine.shape[1]))  # not a part of all: each form is compiled anew
        for points in (0, path_points) if path_points else (0,):
            output = FlightOutput(outcome[part], part_results, paths[part, :points])
            solve(mine, method, output)
        results[:, part] = part_results

    in_parts(work, count, size=CHUNK, threads=threads)
    hang = results[HANG]
    return Flights(
        outcome=outcome,
        carry=np.hypot(results[0], results[1]),
        hang_time=hang,
        apex_height=results[APEX_HEIGHT],
        apex_time=results[APEX_TIME],
        landing_position=results[0:3].T,
        landing_velocity=results[3:6].T,
        spin_left=results[SPIN_LEFT],
        times=hang[:, None] * np.linspace(0, 1, path_points)[None, :],
        positions=paths,
    )


def flight_rows(motions: BallMotion | BallMotions, conditions: FlightConditions) -> Array:
    """Return the inputs by flight, shape (12, n): position, velocity, spin, density, wind right and out."""
    density, blowing = conditions.density, conditions.blowing
    columns = [np.asarray(values, float) for values in (motions.position, motions.velocity, motions.spin)]
    names = ("position", "velocity", "spin", "wind")
    for values, size, what in zip((*columns, blowing), (3, 3, 3, 2), names, strict=True):
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
    start[DENSITY] = density
    return start


def flight_method(conditions: FlightConditions, step: float) -> FlightMethod:
    """Return the constants of a batch as the compiled flight has them; ``step`` in s."""
    ball, law = conditions.ball, conditions.aerodynamics
    edge, reference = conditions.shelter
    forces = FlightLaw(
        radius=ball.radius,
        drag=law.drag - law.drag_per_inverse_reynolds,
        drag_per_spin=law.drag_per_spin,
        drag_per_active_spin=law.drag_per_active_spin,
        drag_per_spin_factor=law.drag_per_spin_factor,
        viscous=law.viscous_rate(radius=ball.radius, mass=ball.mass),
        lift_scale=law.lift_scale,
        lift_offset=law.lift_offset,
        lift_slope=law.lift_slope,
        decay=law.spin_decay_rate,
        reference=reference,
    )
    per_density = math.pi * ball.radius**2 / (2 * ball.mass)
    return FlightMethod(forces, per_density, law.lift_power, conditions.profile, edge, step)

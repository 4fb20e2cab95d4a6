"""Flights: many at once, one to read, and the same hits by the ball-flight code people install today."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest

from benchmarks import cases
from benchmarks.cases import QUICK, best, measured
from sweetspot import catalog
from sweetspot.flight import kernel
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions, batted_ball
from sweetspot.units import DEGREE, FOOT, MPH, RPM

Record = Callable[..., None]
Array = cases.Array
STEPS = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
AIR = Air(temperature=38 / 1.8, pressure=29.92 * 3386.389, elevation=15 * FOOT)
START = (0.0, 2 * FOOT, 3 * FOOT)
RIVALS = 3 if QUICK else 12


@cache
def game_flights(count: int) -> tuple[Array, Array]:
    """Return velocities and spins of fly balls and line drives: 85 to 115 mph, 10 to 40 deg, to all fields."""
    generator = np.random.default_rng(21)
    speed, angle = generator.uniform(85, 115, count) * MPH, generator.uniform(10, 40, count) * DEGREE
    spray = generator.uniform(-40, 40, count) * DEGREE
    back, side = generator.uniform(1000, 3500, count) * RPM, generator.uniform(-1500, 1500, count) * RPM
    up, level, right, out = np.sin(angle), np.cos(angle), np.sin(spray), np.cos(spray)
    ahead = np.stack([level * right, level * out, up], axis=-1)
    across = np.stack([out, -right, np.zeros(count)], axis=-1)
    standing = np.stack([-up * right, -up * out, level], axis=-1)
    return speed[:, None] * ahead, back[:, None] * across + side[:, None] * standing


def flown(count: int, step: float = kernel.STEP, threads: int = 2) -> Flights:
    velocity, spin = game_flights(count)
    return flights(
        BallMotions(velocity=velocity, spin=spin, position=START),
        FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics("baseball"), air=AIR),
        step=step,
        threads=threads,
    )


def test_many_flights(benchmark: Any, record: Record) -> None:
    both = measured(benchmark, lambda: flown(cases.MANY), 3 if QUICK else 5)
    one = best(lambda: flown(cases.MANY, threads=1), 2 if QUICK else 3)
    record(f"{cases.MANY:,} flights, 2 threads", f"{cases.MANY / both:,.0f} flights/s", goal="500,000 flights/s")
    record(f"{cases.MANY:,} flights, 1 thread", f"{cases.MANY / one:,.0f} flights/s")


def test_error_against_rate_of_flights(record: Record, record_table: Callable[[list[str]], None]) -> None:
    count = 2_000 if QUICK else 100_000
    exact = flown(count, 0.01).carry
    lines = ["flights: error of carry against rate, 2 threads (goal: 0.05 ft)"]
    lines.append(f"{'step s':>8}  {'median ft':>10}  {'worst ft':>10}  {'flights/s':>12}")
    for step in STEPS:
        apart = np.abs(flown(count, step).carry - exact) / FOOT
        seconds = best(lambda step=step: flown(count, step), 3)  # type: ignore[misc]
        lines.append(f"{step:8.2f}  {np.median(apart):10.1e}  {apart.max():10.1e}  {count / seconds:12,.0f}")
        if step == kernel.STEP:
            assert apart.max() < 0.05
            record("worst error of carry, usual step", f"{apart.max():.1e} ft", goal="0.05 ft")
    record_table(lines)


def test_one_flight(benchmark: Any, record: Record) -> None:
    velocity, spin = (column[0] for column in game_flights(1))
    motion = BallMotion(position=np.array(START), velocity=velocity, spin=spin)
    law, ball = catalog.aerodynamics("baseball"), catalog.ball()
    seconds = measured(benchmark, lambda: fly(motion, FlightConditions(ball=ball, aerodynamics=law, air=AIR)))
    in_kernel = best(lambda: flown(1), 50)
    record("one flight, readable", f"{1e3 * seconds:.1f} ms")
    record("one flight, kernel", f"{1e6 * in_kernel:.0f} us")


def test_beside_pybaseball(benchmark: Any, record: Record) -> None:
    """The same law of drag and lift in the same air, backspin only, which both treat alike.

    The rival decays no spin, does not know wind, needs some spin and stops at its first step below the ground.
    """
    rival = pytest.importorskip("pybaseball.analysis.trajectories").BattedBallTrajectory()
    generator = np.random.default_rng(22)
    asked = np.stack([generator.uniform(*ends, RIVALS) for ends in ((85, 115), (10, 40), (-40, 40), (1000, 3500))]).T

    def theirs(step: float) -> Array:
        ends = [rival.get_trajectory(*hit, 0.0, delta_time=step).iloc[-1] for hit in asked.tolist()]
        return np.array([math.hypot(end["x"], end["y"]) for end in ends])

    hits = [
        batted_ball(
            speed=speed * MPH, launch_angle=angle * DEGREE, spray=spray * DEGREE, backspin=spin * RPM,
            position=(0.0, 2 * FOOT, 3 * FOOT),
        )
        for speed, angle, spray, spin in asked.tolist()
    ]  # fmt: skip
    ours = flights(
        BallMotions(
            velocity=np.array([hit.velocity for hit in hits]),
            spin=np.array([hit.spin for hit in hits]),
            position=np.array([hit.position for hit in hits]),
        ),
        FlightConditions(
            ball=catalog.ball(),
            aerodynamics=catalog.aerodynamics("trajectory-calculator").replaced(spin_decay_time=None),
            air=AIR,
        ),
    )
    assert np.abs(ours.carry / FOOT - theirs(0.01)).max() < 1.0
    many = measured(benchmark, lambda: flown(20_000), 5) / 20_000
    for step, name in ((0.01, "its usual step"), (0.5, "its step 0.5 s")):
        seconds = best(lambda step=step: theirs(step), 1 if QUICK else 2) / RIVALS  # type: ignore[misc]
        record(
            f"flights beside pybaseball, {name}", f"{1 / many:,.0f} flights/s",
            rival=f"{1 / seconds:,.0f} flights/s", ratio=f"{seconds / many:,.0f}",
        )  # fmt: skip

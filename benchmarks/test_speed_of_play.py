"""From contact to the fence: one play and many, by the compiled kernels."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np

from benchmarks.cases import QUICK, ball, duration, measured
from sweetspot import catalog
from sweetspot.analysis.full_play import Plays, plays
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import ReducedBat, reduced_bat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.units import DEGREE, INCH, MPH, RPM

COUNT = 2_000 if QUICK else 100_000
PITCH = batted_ball(
    speed=82 * MPH, launch_angle=-6 * DEGREE, spray=math.pi, backspin=2200 * RPM, position=(0.0, 0.6, 0.9)
)


@cache
def model() -> ReducedBat[Bat]:
    """Return the bat that everybody hits with."""
    return reduced_bat(catalog.bat("r161-ash"), ball=ball())


def played(count: int) -> Plays:
    """Return so many random swings at a fastball, met and flown."""
    draw = np.random.default_rng(7)
    attack, tilt = draw.normal(9, 8, count) * DEGREE, draw.normal(32, 7, count) * DEGREE
    axes = path_axes(attack, 0.0, tilt=steep_enough(tilt, attack), left=False)
    return plays(
        model(),
        FlightConditions(ball=ball(), aerodynamics=catalog.aerodynamics("baseball"), air=Air()),
        swings=Swings(draw.normal(71, 5, count) * MPH, axes),
        pitches=PITCH,
        contact=Contact(model().bat.length - draw.uniform(4, 9, count) * INCH, draw.normal(0.2, 0.9, count) * INCH),
    )


def test_one_play(benchmark: Any, record: Callable[..., None]) -> None:
    seconds = measured(benchmark, lambda: played(1))
    record("one play: contact in space and flight, in the kernels", duration(seconds), goal="1 ms")


def test_many_plays(benchmark: Any, record: Callable[..., None]) -> None:
    seconds = measured(benchmark, lambda: played(COUNT), rounds=2)
    record(f"{COUNT:,} plays", f"{COUNT / seconds:,.0f} plays/s")

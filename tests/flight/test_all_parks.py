"""The same hit in thirty parks: the kernel's paths against the readable flight, and what thin air does."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import fly_all_parks, landing
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotions, batted_ball
from sweetspot.units import FOOT, MPH

BALL, LAW, AIR = catalog.ball(), aerodynamics(), Air(temperature=22.0)
PARKS = catalog.parks()


def test_as_the_readable_flight_has_it() -> None:
    """2 cm of clearance: chords of two samplings of a path, and steep fences seen from slightly different points."""
    motion = batted_ball(
        speed=103 * MPH, launch_angle=math.radians(28), spray=-0.5, backspin=240.0, position=(0.0, 0.6, 1.0)
    )
    same = fly_all_parks(
        motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), parks=PARKS, own_elevation=False
    )
    path = fly(motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), step=0.01).positions
    outcomes = set()
    for park, found in zip(PARKS, same, strict=True):
        alone = landing(path, park)
        outcomes.add(alone.outcome)
        assert found.outcome.shape == (1,) and found.outcome[0] == alone.outcome
        clearance = math.nan if alone.clearance is None else alone.clearance
        assert found.clearance[0] == pytest.approx(clearance, abs=0.02, nan_ok=True)
    assert "home run" in outcomes


def test_thin_air_carries_further_and_never_takes_a_home_run_away() -> None:
    generator = np.random.default_rng(11)
    angle, turn = generator.uniform(0.35, 0.65, 200), generator.uniform(-0.7, 0.7, 200)
    ahead = np.stack([np.cos(angle) * np.sin(turn), np.cos(angle) * np.cos(turn), np.sin(angle)], axis=-1)
    spin = 230 * np.stack([np.cos(turn), -np.sin(turn), np.zeros(200)], axis=-1)
    high = [park for park in PARKS if park.elevation > 300 * FOOT]
    own, sea = (
        fly_all_parks(
            BallMotions(velocity=102 * MPH * ahead, spin=spin, position=[0.0, 0.6, 1.0]),
            FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
            parks=high,
            own_elevation=own,
        )
        for own in (True, False)
    )
    assert sum(int(found.out.sum()) for found in own) > sum(int(found.out.sum()) for found in sea) > 0
    for thin, thick in zip(own, sea, strict=True):
        assert not (thick.out & ~thin.out).any()

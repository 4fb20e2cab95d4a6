"""From pitch to ground: one call is its parts, one and many agree, a miss has no flight."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.full_play import Play, play, plays
from sweetspot.collision.hit_in_space import Contact
from sweetspot.collision.impact import Outcome
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import VACUUM, Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions, batted_ball
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.units import DEGREE, FOOT, INCH, MPH, RPM

BALL = catalog.ball()
PITCH = batted_ball(
    speed=82 * MPH, launch_angle=-6.5 * DEGREE, spray=math.pi, backspin=2300 * RPM, position=(0.0, 0.6, 0.9)
)
PATH = SwingPath(attack_angle=9 * DEGREE, tilt=32 * DEGREE)
AERODYNAMICS = catalog.aerodynamics("baseball")


@pytest.fixture(scope="module")
def model(analysis: Analysis) -> ReducedBat[Bat]:
    return analysis.reduced


def played(model: ReducedBat[Bat], *, offset: float = 0.6 * INCH, air: Air = Air(), pitch: BallMotion = PITCH) -> Play:  # noqa: B008
    place = model.bat.length - 6 * INCH
    return play(
        model,
        FlightConditions(ball=BALL, aerodynamics=AERODYNAMICS, air=air),
        swing=Swing(bat_speed=72 * MPH, measured_at=place),
        path=PATH,
        pitch=pitch,
        contact=Contact(place, offset),
    )


def test_the_whole_is_its_parts(model: ReducedBat[Bat]) -> None:
    found = played(model)
    assert found.strike.launched is not None and found.flight is not None
    alone = fly(found.strike.launched, FlightConditions(ball=BALL, aerodynamics=AERODYNAMICS, air=Air()))
    assert found.flight.carry == alone.carry
    assert found.flight.launch.position == pytest.approx(PITCH.position)


def test_a_well_hit_fastball_is_a_long_fly(model: ReducedBat[Bat]) -> None:
    """[nathan_calculator]: about 102 mph at 21 degrees carries 380 to 400 ft."""
    flight = played(model).flight
    assert flight is not None
    assert 370 < flight.carry / FOOT < 410


def test_without_air_it_is_a_parabola(model: ReducedBat[Bat]) -> None:
    found = played(model, air=VACUUM)
    assert found.flight is not None and found.strike.launched is not None
    up, height = found.strike.launched.velocity[2], PITCH.position[2]
    expected = (up + math.sqrt(up**2 + 2 * 9.80665 * height)) / 9.80665
    assert found.flight.hang_time == pytest.approx(expected, rel=1e-9)


def test_a_miss_does_not_fly(model: ReducedBat[Bat]) -> None:
    found = played(model, offset=0.1)
    assert found.strike.outcome is Outcome.MISS and found.flight is None


def test_one_and_many_agree(model: ReducedBat[Bat]) -> None:
    place = model.bat.length - 6 * INCH
    offsets = np.array([0.2, 0.6, 1.0, 9.0]) * INCH
    many = plays(
        model,
        FlightConditions(ball=BALL, aerodynamics=AERODYNAMICS, air=Air()),
        swings=Swings(np.full(4, 72 * MPH), PATH.axes),
        pitches=BallMotions(velocity=PITCH.velocity, spin=PITCH.spin, position=PITCH.position),
        contact=Contact(np.full(4, place), offsets),
    )
    for row, offset in enumerate(offsets[:3]):
        one = played(model, offset=offset).flight
        assert one is not None
        assert many.flights.carry[row] == pytest.approx(one.carry, abs=0.1)  # m; exit speeds agree to 1e-4
    assert many.strikes.outcome[3] == Outcome.MISS and np.isnan(many.flights.carry[3])

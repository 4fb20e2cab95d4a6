"""One play as every consumer asks for it."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from sweetspot import catalog
from sweetspot.answers.play import PlayQuestion, play_answer, play_sources
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.motion.swing_path import SwingPath
from sweetspot.numerics.interval import Interval
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import DEGREE


@pytest.fixture(scope="module")
def asked() -> PlayQuestion:
    bat = catalog.bat("r161-ash")
    conditions = standard_conditions(bat)
    return PlayQuestion(
        reduced_bat(bat, ball=conditions.ball).held(conditions.hands),
        conditions,
        FlightConditions(ball=conditions.ball, aerodynamics=catalog.aerodynamics(), air=Air()),
        path=SwingPath(attack_angle=9 * DEGREE),
        pitch=batted_ball(speed=38.0, launch_angle=-6 * DEGREE, spray=math.pi, position=(0.0, 0.6, 0.9)),
        contact=Contact(bat.length - 0.15, 0.015),
        park=catalog.park("fenway"),
    )


def test_a_play_goes_from_the_pitch_to_the_fence(asked: PlayQuestion) -> None:
    answer = play_answer(asked)
    assert answer.pitch_speed == pytest.approx(38.0) and answer.flight is not None and answer.fence is not None
    assert answer.launch is not None and answer.launch.exit_speed == answer.exit_speed
    assert answer.exit_speed_half_by_ball is not None and answer.uncertainty is None
    data = answer.to_dict()
    assert data["flight"]["carry_m"] == float(answer.flight.carry) and data["fence"]["park"] == "Fenway Park"
    assert 0 <= data["home_run_chance"] <= 1 and data["carry_half_m"] > data["carry_spread_m"]


def test_intervals_hold_their_numbers(asked: PlayQuestion) -> None:
    bat = asked.reduced.bat
    sources = play_sources(sources_of(bat, asked.conditions), asked.flying.aerodynamics, offset_error=0.005)
    answer = play_answer(replace(asked, sources=sources, draws=256))
    assert answer.flight is not None and answer.launch is not None and answer.uncertainty is not None
    for number in (answer.offset, answer.exit_speed, answer.backspin, answer.flight.carry, answer.launch.launch_angle):
        assert isinstance(number, Interval)
        assert number.low <= number.value <= number.high
    assert next(iter(answer.uncertainty.shares)) == "bat under the ball"
    assert answer.exit_speed_half_by_ball is None, "it is part of the interval"


def test_what_a_miss_does_not_have_is_none(asked: PlayQuestion) -> None:
    answer = play_answer(replace(asked, contact=Contact(asked.contact.position, 0.09)))
    data = answer.to_dict()
    assert answer.launch is None and data["flight"] is None and data["exit_speed_m_s"] is None
    assert "home_run_chance" not in data and "uncertainty" not in data

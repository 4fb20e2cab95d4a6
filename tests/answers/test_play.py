"""One play as every consumer asks for it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ndtri

from sweetspot import catalog
from sweetspot.answers.play import PlayQuestion, play_answer, play_sources
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import home_run_chances
from sweetspot.motion.ball_motion import BallMotions, batted_ball
from sweetspot.motion.swing_path import SwingPath
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import DEGREE, MPH


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


def test_a_home_run_chance_holds_single_balls_and_the_mean_ball(asked: PlayQuestion) -> None:
    """The chance against many balls that are drawn and flown one by one; its ends against all of them moved."""
    swung = asked.conditions.replaced(swing=asked.conditions.swing.replaced(bat_speed=74 * MPH))
    question = replace(asked, conditions=swung)
    answer = play_answer(question)
    chance, flight = answer.home_run_chance, answer.play.flight
    park = question.park
    assert isinstance(chance, Interval) and flight is not None and park is not None
    scatter, common = (
        float(half) for half in (answer.exit_speed_half_by_ball or 0.0, answer.exit_speed_half_by_kind or 0.0)
    )
    normal = ndtri((np.arange(400) + 0.5) / 400)

    def mean_chance(shift: float) -> float:
        faster = 1 + (shift + scatter / REACH * normal) / flight.launch.speed
        balls = BallMotions(
            velocity=faster[:, None] * np.asarray(flight.launch.velocity),
            spin=np.asarray(flight.launch.spin),
            position=np.asarray(flight.launch.position),
        )
        chances = home_run_chances(balls, question.flying, parks=(park,), own_elevation=False).chance
        return float(chances.mean())

    assert chance.value == pytest.approx(mean_chance(0.0), abs=0.005)
    assert (chance.low, chance.high) == pytest.approx((mean_chance(-common), mean_chance(common)), abs=0.005)
    assert 0.02 < chance.low < chance.value - 0.02 < chance.high - 0.04


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

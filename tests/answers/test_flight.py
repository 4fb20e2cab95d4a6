"""One flight and one batted ball as every consumer asks for them."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from sweetspot import catalog
from sweetspot.answers.flight import FlightQuestion, flight_answer, flight_sources
from sweetspot.answers.fly import FlyQuestion, fly_answer
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.sweep import BattedBall
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.units import DEGREE, FOOT, MPH, RPM

LAW = catalog.aerodynamics()
FLYING = FlightConditions(ball=catalog.ball(), aerodynamics=LAW, air=Air())
DRIVE = batted_ball(speed=100 * MPH, launch_angle=28 * DEGREE, backspin=2200 * RPM, position=(0.0, 0.6, 0.9))
HIT = BattedBall(exit_speed=100 * MPH, launch_angle=28 * DEGREE)


def test_a_flight_has_its_keys_in_both_systems() -> None:
    answer = flight_answer(FlightQuestion(DRIVE, FLYING))
    si, us = answer.to_dict(), answer.to_dict("us")
    assert {"carry_m", "hang_time_s", "apex_m", "landing_speed_m_s", "landing_angle_rad", "path", "launch"} <= si.keys()
    assert us["carry_ft"] * FOOT == pytest.approx(si["carry_m"]) and "uncertainty" not in si
    assert si["path"]["up_m"][-1] == pytest.approx(0, abs=1e-9) and answer.to_frame().height == 1


def test_only_what_is_open_has_an_interval() -> None:
    """Drag alone leaves the launch as it is; an error of the exit speed moves it by as much as was written."""
    exact = flight_answer(FlightQuestion(DRIVE, FLYING, flight_sources(LAW), 64))
    assert isinstance(exact.carry, Interval) and not isinstance(exact.launch.exit_speed, Interval)
    rough = flight_answer(FlightQuestion(DRIVE, FLYING, flight_sources(LAW, speed_error=1.0), 64))
    speed = rough.launch.exit_speed
    assert isinstance(speed, Interval) and isinstance(rough.carry, Interval)
    assert speed.high - speed.value == pytest.approx(REACH, rel=0.1)
    assert rough.carry.high - rough.carry.low > exact.carry.high - exact.carry.low
    assert rough.uncertainty is not None and sum(rough.uncertainty.shares.values()) == pytest.approx(1)


def test_under_a_roof_intervals_are_those_of_the_law_that_holds_there() -> None:
    """Exact: a roof's law in the open air draws the same carries."""
    park = catalog.park("tropicana")
    indoors = catalog.aerodynamics_in(park, LAW)
    sources = flight_sources(indoors)
    asked = FlyQuestion(HIT, catalog.ball(), catalog.sport("baseball"), LAW, park, sources=sources, draws=64)
    roofed = fly_answer(asked)
    bare = flight_answer(FlightQuestion(HIT.motion, replace(FLYING, aerodynamics=indoors, air=HIT.air), sources, 64))
    assert isinstance(roofed.carry, Interval) and isinstance(bare.carry, Interval)
    assert (roofed.carry.low, roofed.carry.high) == pytest.approx((bare.carry.low, bare.carry.high))


def test_a_park_adds_its_fence_and_a_court_its_marks() -> None:
    at_home = fly_answer(FlyQuestion(HIT, catalog.ball(), catalog.sport("baseball"), LAW))
    assert at_home.fence is None and at_home.court is None and at_home.carry_half is not None
    assert "fence" not in at_home.to_dict() and "court" not in at_home.to_dict()
    tennis = catalog.sport("tennis")
    serve = BattedBall(exit_speed=30.0, launch_angle=8 * DEGREE, backspin=0.0, sidespin=0.0, height=1.0, forward=2.0)
    ball = catalog.ball("tennis")
    over = fly_answer(FlyQuestion(serve, ball, tennis, catalog.aerodynamics_of_ball("tennis")))
    assert over.court is not None and over.court.marks[0].name == "net" and over.carry_spread is None
    end = over.flight.landing.position
    assert over.carry == pytest.approx(math.hypot(end[0], end[1] - 2.0)), "from the hit, where there is no home plate"

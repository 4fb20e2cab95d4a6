"""One flight: exact limits, order of convergence, events and odd starts."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight import trajectory
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import CALM, VACUUM, Air, Wind
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.trajectory import TIME_LIMIT, Flight, FlightOutcome, fly
from sweetspot.motion.ball_motion import BallMotion, batted_ball
from sweetspot.numerics.interpolants import first_crossing, on_cubic, root_on_cubic, turn_on_cubic
from sweetspot.units import FOOT, MPH, RPM

BALL, LAW = catalog.ball(), catalog.aerodynamics("baseball")
AIR = Air(temperature=38 / 1.8, elevation=15 * FOOT)
G = 9.80665


def flown(motion: BallMotion, **changes: object) -> Flight:
    options = {"ball": BALL, "aerodynamics": LAW, "air": AIR, "wind": CALM} | changes
    conditions = FlightConditions(**{name: options.pop(name) for name in ("ball", "aerodynamics", "air", "wind")})  # type: ignore[arg-type]
    return fly(motion, conditions, **options)  # type: ignore[arg-type]


def hit(angle: float = 27.5, **changes: float) -> BallMotion:
    options = {"speed": 103 * MPH, "backspin": 2500 * RPM} | changes
    return batted_ball(launch_angle=math.radians(angle), **options, position=(0.0, 2 * FOOT, 3 * FOOT))


@given(st.floats(1, 80), st.floats(-1.5, 1.5, allow_subnormal=False), st.floats(0, 5), st.floats(0, 500))
@example(speed=30.0, angle=-1e-9, height=2e-312, spin=0.0)
@example(speed=1.0, angle=2e-311, height=0.0, spin=0.0)
@settings(max_examples=40)
def test_without_air_it_is_a_parabola(speed: float, angle: float, height: float, spin: float) -> None:
    """Exact: t = (v sin + sqrt(v^2 sin^2 + 2 g h)) / g, x = v cos t, top = h + v^2 sin^2 / (2 g)."""
    found = flown(batted_ball(speed=speed, launch_angle=angle, backspin=spin, position=(0.0, 0.0, height)), air=VACUUM)
    climb = speed * math.sin(angle)
    time = 0.0 if height == 0 and climb <= 0 else (climb + math.sqrt(climb**2 + 2 * G * height)) / G
    assert found.outcome is FlightOutcome.LANDED
    assert found.hang_time == pytest.approx(time, abs=1e-9)
    assert found.carry == pytest.approx(abs(speed * math.cos(angle)) * time, abs=1e-8)
    assert found.apex_height == pytest.approx(height + max(climb, 0.0) ** 2 / (2 * G), abs=1e-9)
    assert found.landing.speed == pytest.approx(math.sqrt(speed**2 + 2 * G * height * (time > 0)), rel=1e-9)


def test_a_long_fall_ends_at_terminal_speed() -> None:
    """Exact: y = (V^2 / g) ln cosh(g t / V) for a ball let go at rest in still air."""
    terminal, height = 20.0, 60.0
    drag = 2 * BALL.mass * G / (AIR.density * math.pi * BALL.radius**2 * terminal**2)
    found = flown(
        batted_ball(speed=0.0, launch_angle=0.0, position=(0.0, 0.0, height)),
        aerodynamics=Aerodynamics(drag=drag),
        step=0.01,
    )
    exact = terminal / G * math.acosh(math.exp(height * G / terminal**2))
    assert found.hang_time == pytest.approx(exact, abs=1e-8)
    assert found.landing.speed == pytest.approx(terminal * math.tanh(G * exact / terminal), abs=1e-7)


@pytest.mark.parametrize("wind", [Wind(), Wind(speed=9.0, direction=2.0), Wind(speed=9.0, calm_below=8.0)])
def test_fourth_order(wind: Wind) -> None:
    """Errors of carry, hang time and apex fall with the fourth power of the step, jumps of the wind or not."""
    start = hit(spray=0.3, sidespin=-800 * RPM, gyrospin=1000 * RPM)
    exact = flown(start, wind=wind, step=0.005)
    errors = []
    for step in (0.4, 0.2, 0.1):
        found = flown(start, wind=wind, step=step)
        errors.append(abs(np.array([found.carry - exact.carry, found.apex_height - exact.apex_height])).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert (orders > 3.3).all() and (orders < 5.5).all(), orders


def test_the_usual_step_is_far_finer_than_asked() -> None:
    """Asked: 0.05 ft of carry."""
    assert flown(hit()).carry == pytest.approx(flown(hit(), step=0.005).carry, abs=0.001 * FOOT)


def test_a_flight_goes_on_from_any_of_its_moments() -> None:
    """Spin, wind and air are states of the ball and the field, not of the clock: the rest of a flight is a flight."""
    wind = Wind(speed=6.0, direction=1.0, exponent=0.2)
    whole = flown(hit(sidespin=500 * RPM), wind=wind, step=0.01)
    for time in (0.5, 2.0, 4.4):
        rest = flown(whole.at(time), wind=wind, step=0.01)
        assert rest.hang_time + time == pytest.approx(whole.hang_time, abs=1e-4)
        assert rest.landing.position == pytest.approx(whole.landing.position, abs=3e-3)
        assert np.linalg.norm(rest.landing.spin) == pytest.approx(np.linalg.norm(whole.landing.spin), rel=1e-5)


def test_spin_keeps_its_axis_and_tires() -> None:
    """Published: nathan_calculator, exp(-t / 30 s) at 100 mph; the ball is slower, so more is left."""
    found = flown(hit(sidespin=900 * RPM))
    start, end = found.launch.spin, found.landing.spin
    assert np.linalg.norm(np.cross(start, end)) < 1e-9 * np.linalg.norm(start) ** 2
    assert math.exp(-found.hang_time / 30) < np.linalg.norm(end) / np.linalg.norm(start) < 1.0
    assert flown(hit(), aerodynamics=LAW.replaced(spin_decay_time=None)).spin_left[-1] == 1.0


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_mirror(side: float) -> None:
    """Turned about the line to centre field, spin and wind with it, the flight is its mirror image."""
    found = flown(
        hit(spray=0.4 * side, sidespin=700 * RPM * side), wind=Wind(speed=5.0, direction=1.2 * side), step=0.02
    )
    other = flown(
        hit(spray=-0.4 * side, sidespin=-700 * RPM * side), wind=Wind(speed=5.0, direction=-1.2 * side), step=0.02
    )
    assert found.landing.position * [-1, 1, 1] == pytest.approx(other.landing.position, abs=1e-9)


def test_zero_spin_lands() -> None:
    found = flown(hit(backspin=0.0))
    assert found.outcome is FlightOutcome.LANDED and 340 < found.carry / FOOT < 370


def test_a_gale_brings_it_back() -> None:
    found = flown(hit(60.0), wind=Wind(speed=40.0, direction=math.pi))
    assert found.outcome is FlightOutcome.LANDED
    assert found.landing.position[1] < -50 and found.carry == pytest.approx(-found.landing.position[1])


def test_straight_up_comes_down_where_it_went_up() -> None:
    found = flown(batted_ball(speed=40.0, launch_angle=math.pi / 2, position=(0.0, 0.5, 1.0)))
    assert found.carry == pytest.approx(0.5, abs=1e-9)
    assert found.landing_angle == pytest.approx(math.pi / 2)
    assert found.apex_height < 1 + 40**2 / (2 * G)


def test_a_ground_ball_is_short_and_its_apex_is_its_start() -> None:
    found = flown(hit(-10.0))
    assert found.apex_time == 0.0 and found.apex_height == pytest.approx(3 * FOOT)
    assert 0.05 < found.hang_time < 0.2 and found.carry > 2 * FOOT


def test_a_ball_on_the_ground_that_does_not_rise_lies_there() -> None:
    found = flown(batted_ball(speed=30.0, launch_angle=-0.1))
    assert found.outcome is FlightOutcome.LANDED and (found.hang_time, found.carry) == (0.0, 0.0)
    assert found.at(0.0) is found.launch


def test_a_small_hop_is_a_flight() -> None:
    """Exact to the drag of 2 cm: the first step passes start, top and landing at once."""
    found = flown(batted_ball(speed=0.5, launch_angle=math.pi / 2))
    assert found.hang_time == pytest.approx(2 * 0.5 / G, rel=2e-3)
    assert found.apex_height == pytest.approx(0.25 / (2 * G), rel=2e-3)


def test_a_start_below_the_ground_is_refused() -> None:
    with pytest.raises(InputError, match=r"0.5 m below the ground; give a height of 0 m or more"):
        flown(batted_ball(speed=40.0, launch_angle=0.5, position=(0.0, 0.0, -0.5)))


@pytest.mark.parametrize("step", [0.0, -1.0, math.nan, 2.0])
def test_a_step_that_cannot_be_is_refused(step: float) -> None:
    with pytest.raises(InputError, match="step is"):
        flown(hit(), step=step)


def test_a_time_outside_the_flight_is_refused() -> None:
    with pytest.raises(InputError, match="the ball is in the air from 0 to"):
        flown(hit()).at(60.0)


HANGING = batted_ball(speed=0.0, launch_angle=0.0, position=(0.0, 0.0, 100.0))


def test_a_balloon_is_still_flying() -> None:
    found = flown(HANGING, ball=BALL.replaced(mass=0.001, radius=0.15), step=0.5)
    assert found.outcome is FlightOutcome.STILL_FLYING and math.isnan(found.carry)
    assert str(round(TIME_LIMIT)) in found.outcome.sentence


def test_what_would_take_too_many_steps_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    """Air moves a ball of 0.1 g so fast that the steps must be a thousandth of a second."""
    monkeypatch.setattr(trajectory, "MOST_STEPS", 200)
    found = flown(HANGING, ball=BALL.replaced(mass=0.0001, radius=0.15), step=0.5)
    assert found.outcome is FlightOutcome.STILL_FLYING and math.isnan(found.carry)


def test_the_wind_above_the_stands_counts_above_them() -> None:
    low, high = hit(8.0), hit(35.0)
    above = Wind(speed=8.0, calm_below=12.0)
    assert flown(low, wind=above).carry == flown(low).carry
    assert flown(high).carry < flown(high, wind=above).carry < flown(high, wind=Wind(speed=8.0)).carry


def test_a_ball_that_just_looks_over_the_stands_feels_the_wind_no_more_below_them() -> None:
    """Whether the edge is crossed twice within one step or in many makes no difference."""
    start = hit(11.0)
    top = flown(start).apex_height
    wind = Wind(speed=20.0, direction=math.pi, calm_below=top - 0.02)
    coarse, fine = flown(start, wind=wind, step=0.2), flown(start, wind=wind, step=0.01)
    assert coarse.carry == pytest.approx(fine.carry, abs=0.005)
    assert 0.01 < flown(start).carry - fine.carry < 5.0


@given(st.floats(0.01, 5), st.floats(-5, -0.01), st.floats(-9, 9), st.floats(-9, 9))
def test_the_first_crossing_is_one(before: float, after: float, first: float, last: float) -> None:
    place = first_crossing(before, after, first, last)
    assert 0 <= place <= 1
    assert on_cubic(place, before, after, first, last) == pytest.approx(0.0, abs=1e-9)
    assert place <= root_on_cubic(before, after, first, last, 0.0, 1.0) + 1e-9


def test_turning_points() -> None:
    """Exact: part^2 - part has its lowest point in the middle."""
    assert turn_on_cubic(0.0, 0.0, -1.0, 1.0) == pytest.approx(0.5)
    assert first_crossing(0.1, 0.1, -1.0, 1.0) == pytest.approx((1 - math.sqrt(0.6)) / 2)
    assert first_crossing(0.3, 0.3, -1.0, 1.0) == -1.0

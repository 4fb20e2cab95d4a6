"""The best launch angle and the easiest way out of a park, against limits and brute force."""

from __future__ import annotations

import math

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.analysis.optimum import best_launch, easiest_home_run
from sweetspot.errors import InputError
from sweetspot.flight.air import VACUUM, Air, Wind
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import USUAL_CONTACT, batted_ball
from sweetspot.units import DEGREE, MPH, RPM

_, FORWARD, HEIGHT = USUAL_CONTACT
BALL, LAW, AIR = catalog.ball(), catalog.aerodynamics(), Air()
SPIN = 2200 * RPM


@pytest.mark.parametrize(("speed", "angle"), [(90, 31.0), (100, 29.5), (110, 28.0)])
def test_best_angles_of_the_calculator(speed: float, angle: float) -> None:
    """[nathan_calculator] with 2200 rpm, by another integration of the same model, to half a degree."""
    found = best_launch(
        speed * MPH,
        FlightConditions(ball=BALL, aerodynamics=catalog.aerodynamics("trajectory-calculator"), air=AIR),
        backspin=SPIN,
    )
    assert found.launch_angle / DEGREE == pytest.approx(angle, abs=0.3)


def test_in_a_vacuum_it_is_the_parabolas() -> None:
    """Exact: from height h, tan(best) = v / sqrt(v^2 + 2 g h) and R = v sqrt(v^2 + 2 g h) / g."""
    speed, gravity = 40.0, 9.80665
    found = best_launch(speed, FlightConditions(ball=BALL, aerodynamics=LAW, air=VACUUM), backspin=SPIN)
    root = math.sqrt(speed**2 + 2 * gravity * HEIGHT)
    assert found.launch_angle == pytest.approx(math.atan(speed / root), abs=2e-5)
    assert found.carry == pytest.approx(FORWARD + speed * root / gravity, abs=1e-5)


def test_harder_hits_want_lower_launches() -> None:
    angles = [
        best_launch(v * MPH, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), backspin=SPIN).launch_angle
        for v in (80, 120)
    ]
    assert angles[0] > angles[1] + 3 * DEGREE


def test_no_speed_is_refused() -> None:
    with pytest.raises(InputError, match="exit_speed is 0"):
        best_launch(0.0, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), backspin=SPIN)


@pytest.mark.parametrize("name", ["fenway", "wrigley", "oracle-park"])
def test_the_slowest_home_run_just_clears_and_a_slower_one_does_not(name: str) -> None:
    """By the readable flight: 0.05 mph more goes out, 0.15 mph less stays in at every launch angle to 1 deg."""
    park = catalog.park(name)
    there = catalog.conditions_in(park, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR))
    found = easiest_home_run(park, there, backspin=SPIN)

    def outcome(speed: float, angle: float, direction: float) -> str:
        motion = batted_ball(
            speed=speed, launch_angle=angle, spray=direction, backspin=SPIN, position=(0.0, 0.0, HEIGHT)
        )
        start = FORWARD * np.array([math.sin(direction), math.cos(direction), 0.0])
        path = fly(motion, there).positions + start
        return landing(path, park).outcome

    inside = (1 - 1e-7) * found.direction  # a hair off the foul line, where rounding may call it foul
    assert outcome(found.exit_speed + 0.05 * MPH, found.launch_angle, inside) == "home run"
    for angle in found.launch_angle + np.arange(-3, 4) * DEGREE:
        assert outcome(found.exit_speed - 0.15 * MPH, float(angle), inside) == "off the wall"


def test_a_higher_wall_asks_for_more_speed_and_a_higher_launch() -> None:
    parks = [
        Park(name="round", fence=tuple((math.radians(a), 110.0, wall) for a in range(-45, 46))) for wall in (1.0, 12.0)
    ]
    usual = FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR)
    found = [easiest_home_run(park, usual, backspin=SPIN) for park in parks]
    assert found[1].exit_speed > found[0].exit_speed + 0.5
    assert found[1].launch_angle > found[0].launch_angle


def test_directions_may_be_limited() -> None:
    park = catalog.park("fenway")
    free = easiest_home_run(park, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), backspin=SPIN)
    centre = easiest_home_run(
        park, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), backspin=SPIN, directions=[0.0]
    )
    assert centre.direction == 0.0 and centre.exit_speed > free.exit_speed + 5 * MPH


def test_a_wall_too_high_is_refused() -> None:
    tower = Park(name="tower", fence=((-math.pi / 4, 120.0, 200.0), (math.pi / 4, 120.0, 200.0)))
    with pytest.raises(InputError, match="clears the fence of tower"):
        easiest_home_run(tower, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR), backspin=SPIN)


def test_the_easiest_home_run_is_searched_without_wind() -> None:
    """With wind the directions differ by more than their fences, which one family of flights does not show."""
    windy = FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR, wind=Wind(speed=3.0))
    with pytest.raises(InputError, match="without wind"):
        easiest_home_run(catalog.park("fenway"), windy, backspin=SPIN)

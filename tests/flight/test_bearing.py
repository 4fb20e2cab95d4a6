"""Launch directions solved for from where balls came down."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.air import Air, Wind
from sweetspot.flight.bearing import bearing_of_place, launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import landing
from sweetspot.flight.kernel import flights
from sweetspot.flight.sweep import BattedBall, directed
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import batted_ball
from sweetspot.units import DEGREE, MPH, RPM

BALL, LAW, AIR = catalog.ball(), catalog.aerodynamics(), Air()


@settings(max_examples=30)
@given(st.floats(-45, 45), st.floats(60, 115), st.floats(8, 50), st.sampled_from(["right", "left"]), st.floats(-8, 8))
def test_the_ball_comes_down_where_it_was_seen(
    bearing: float, speed: float, up: float, bats: str, across: float
) -> None:
    """Exact: flown again with the direction that was found, by the readable solver, it lands at the bearing."""
    wind = Wind(speed=abs(across), direction=math.copysign(math.pi / 2, across))
    spray, _ = launched_to(
        bearing * DEGREE,
        exit_speed=speed * MPH,
        launch_angle=up * DEGREE,
        bats=bats,
        conditions=FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR, wind=wind),
    )
    hit = BattedBall(exit_speed=speed * MPH, launch_angle=up * DEGREE, spray=float(spray[0]), bats=bats)  # type: ignore[arg-type]
    flight = fly(hit.motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR, wind=wind))
    assert flight.bearing == pytest.approx(bearing * DEGREE, abs=2e-5)


def test_without_side_forces_both_are_one() -> None:
    """Symmetry: pure backspin and no wind bend nothing."""
    bearing = np.radians([-40.0, 0.0, 25.0])
    spray, _ = launched_to(
        bearing,
        exit_speed=45.0,
        launch_angle=0.5,
        conditions=FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        spins=(200.0, 0.0),
        position=(0.0, 0.0, 0.0),
    )
    assert spray == pytest.approx(bearing, abs=1e-6)


def test_left_handed_hits_are_mirror_images() -> None:
    right, left = (
        launched_to(
            sign * 0.3,
            exit_speed=44.0,
            launch_angle=0.5,
            bats=bats,
            conditions=FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        )[0]
        for sign, bats in ((1, "right"), (-1, "left"))
    )
    assert right == pytest.approx(-left, abs=1e-9)


def test_fair_balls_near_the_line_are_no_fouls() -> None:
    """A home run seen to come down 3 deg inside the left-field pole: as a launch direction it would be foul."""
    park = catalog.park("fenway")
    hit = BattedBall(exit_speed=105 * MPH, launch_angle=27 * DEGREE, sidespin=1500 * RPM, backspin=2000 * RPM)
    seen = -42 * DEGREE

    def outcome(one: BattedBall) -> str:
        return landing(fly(one.motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR)).positions, park).outcome

    assert outcome(BattedBall(**{**vars(hit), "spray": seen})) == "foul"
    assert outcome(directed(BattedBall(**{**vars(hit), "bearing": seen}), ball=BALL, aerodynamics=LAW)) == "home run"


def test_what_comes_down_nowhere_is_refused_alone_and_nan_among_many() -> None:
    with pytest.raises(InputError, match="no launch direction brings this ball down"):
        directed(
            BattedBall(exit_speed=10.0, launch_angle=0.5, bearing=math.pi, wind_speed=30.0), ball=BALL, aerodynamics=LAW
        )
    spray, result = launched_to(
        [0.1, math.nan],
        exit_speed=40.0,
        launch_angle=0.4,
        conditions=FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
    )
    assert np.isfinite(spray[0]) and np.isnan(spray[1]) and result.landed[0]


def test_a_hit_with_a_bearing_alone_has_no_motion_yet() -> None:
    with pytest.raises(InputError, match="only the bearing of this hit is known"):
        _ = BattedBall(exit_speed=40.0, launch_angle=0.4, bearing=0.1).motion


def test_places_on_the_map() -> None:
    """Published: poulsen_hr_rdd; the lines lie at 45 deg, the map's y falls towards centre field."""
    assert np.degrees(bearing_of_place([125.42, 225.42, 25.42], [98.27, 98.27, 98.27])) == pytest.approx([0, 45, -45])


def test_one_flight_and_many_say_the_same_bearing() -> None:
    ball = batted_ball(
        speed=45.0, launch_angle=0.5, spray=0.2, backspin=200.0, sidespin=-120.0, position=(0.0, 0.0, 1.0)
    )
    one = fly(ball, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR))
    many = flights(ball, FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR))
    assert many.bearing[0] == pytest.approx(one.bearing, abs=1e-5)
    assert one.bearing > ball.spray  # negative side spin bends to the right

"""Flights that must be each other's: mirrored, turned, moved along with the wind, heavier, cut in two, reordered."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import sweetspot
from sweetspot import catalog
from sweetspot.flight.air import VACUUM, Air, Wind, air_density
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing_path import Side
from sweetspot.numerics.arrays import Array
from sweetspot.units import DEGREE, MPH, RPM
from tests.random_bats import examples

BALL, LAW = catalog.ball(), catalog.aerodynamics()
MIRROR = np.array([-1.0, 1.0, 1.0])
"""Of a place or a velocity; spins are turned by it and by the sign of a mirror."""
STEP = 0.01
"""s; both of a pair err alike."""


@st.composite
def motions(draw: st.DrawFn) -> BallMotion:
    """Return a batted ball with any spin, from a place near the plate."""
    return sweetspot.batted_ball(
        speed=draw(st.floats(50, 118)) * MPH,
        launch_angle=draw(st.floats(-5, 60)) * DEGREE,
        spray=draw(st.floats(-44, 44)) * DEGREE,
        backspin=draw(st.floats(-1000, 4000)) * RPM,
        sidespin=draw(st.floats(-2500, 2500)) * RPM,
        gyrospin=draw(st.floats(-1000, 1000)) * RPM,
        position=(draw(st.floats(-0.3, 0.3)), 0.5, draw(st.floats(0.5, 1.3))),
    )


AIRS = st.builds(
    Air, temperature=st.floats(-5, 40), elevation=st.floats(0, 1700), humidity=st.floats(0, 1),
    pressure=st.floats(98000, 103500),
)  # fmt: skip
WINDS = st.builds(Wind, speed=st.floats(0, 12), direction=st.floats(-3.1, 3.1), exponent=st.sampled_from([0.0, 1 / 7]))
UNIFORM = st.builds(Wind, speed=st.floats(0, 12), direction=st.floats(-3.1, 3.1))


def through(air: Air, wind: Wind) -> FlightConditions:
    return FlightConditions(ball=BALL, aerodynamics=LAW, air=air, wind=wind)


def flown(motion: BallMotion, conditions: FlightConditions) -> Flights:
    return flights(motion, conditions, step=STEP)


def numbers(found: Flights) -> Array:
    """Return where, when and how fast it lands, and its apex, of the first row."""
    return np.array(
        [
            *found.landing_position[0],
            *found.landing_velocity[0],
            found.hang_time[0],
            found.apex_height[0],
            found.carry[0],
        ]
    )


def mirrored(motion: BallMotion) -> BallMotion:
    return BallMotion(
        position=MIRROR * motion.position, velocity=MIRROR * motion.velocity, spin=-MIRROR * np.asarray(motion.spin)
    )


def turned(values: Array, angle: float) -> Array:
    """Return a vector turned about the vertical toward right field."""
    right, out, up = values
    sine, cosine = math.sin(angle), math.cos(angle)
    return np.array([right * cosine + out * sine, out * cosine - right * sine, up])


@examples(20)
@given(motion=motions(), air=AIRS, wind=WINDS)
def test_mirrored(motion: BallMotion, air: Air, wind: Wind) -> None:
    """Exact: a mirrored ball in a mirrored wind lands at the mirrored place."""
    here = numbers(flown(motion, through(air, wind)))
    there = numbers(flown(mirrored(motion), through(air, wind.replaced(direction=-wind.direction))))
    sign = np.array([-1.0, 1, 1, -1, 1, 1, 1, 1, 1])
    assert there == pytest.approx(sign * here, rel=1e-11, abs=1e-11)


@examples(20)
@given(motion=motions(), air=AIRS, wind=WINDS, angle=st.floats(-1.5, 1.5))
def test_turned(motion: BallMotion, air: Air, wind: Wind, angle: float) -> None:
    """Exact: turned about the vertical with its wind, it lands at the turned place."""
    here = flown(motion, through(air, wind))
    around = BallMotion(*(turned(np.asarray(each), angle) for each in (motion.position, motion.velocity, motion.spin)))
    direction = (wind.direction + angle + math.pi) % (2 * math.pi) - math.pi
    there = flown(around, through(air, wind.replaced(direction=direction)))
    assert there.landing_position[0] == pytest.approx(turned(here.landing_position[0], angle), abs=1e-9)
    assert there.hang_time == pytest.approx(here.hang_time, rel=1e-10)


@examples(20)
@given(motion=motions(), air=AIRS, wind=UNIFORM)
def test_moving_along_with_the_wind(motion: BallMotion, air: Air, wind: Wind) -> None:
    """Exact (Galilei): in a wind alike everywhere it flies as in still air seen by someone who drifts along."""
    blown = flown(motion, through(air, wind))
    drifting = BallMotion(position=motion.position, velocity=motion.velocity - wind.velocity, spin=motion.spin)
    calm = flown(drifting, through(air, Wind()))
    assert blown.hang_time == pytest.approx(calm.hang_time, rel=1e-7)
    moved = calm.landing_position[0] + wind.velocity * calm.hang_time[0]
    assert blown.landing_position[0] == pytest.approx(moved, rel=1e-7, abs=1e-5)


@examples(15)
@given(motion=motions(), air=AIRS, wind=WINDS, factor=st.floats(0.5, 2.0))
def test_a_heavier_ball_in_denser_air(motion: BallMotion, air: Air, wind: Wind, factor: float) -> None:
    """Exact: what the air does goes as its density over the ball's mass (the law asks speed and spin alone)."""
    here = flown(motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=[air.density], wind=wind))
    heavy = FlightConditions(
        ball=BALL.replaced(mass=factor * BALL.mass), aerodynamics=LAW, air=[factor * air.density], wind=wind
    )
    assert numbers(flown(motion, heavy)) == pytest.approx(numbers(here), rel=1e-10, abs=1e-10)


@examples(15)
@given(motion=motions(), air=AIRS)
def test_air_counts_by_its_density_alone(motion: BallMotion, air: Air) -> None:
    """Exact: warm air at sea level and cold air up a mountain of one density are one air."""
    dense = air_density(air.temperature, pressure=air.pressure, humidity=air.humidity, elevation=air.elevation)
    assert float(dense) == pytest.approx(air.density, rel=1e-12)
    by_number = flown(motion, FlightConditions(ball=BALL, aerodynamics=LAW, air=[float(dense)]))
    assert numbers(by_number) == pytest.approx(numbers(flown(motion, through(air, Wind()))), rel=1e-10, abs=1e-10)


@examples(15)
@given(motion=motions(), wind=WINDS)
def test_in_a_vacuum_neither_wind_nor_spin_counts(motion: BallMotion, wind: Wind) -> None:
    """Exact: a parabola."""
    here = flown(motion, through(VACUUM, wind))
    still = flown(replace(motion, spin=np.zeros(3)), through(VACUUM, Wind()))
    assert numbers(here) == pytest.approx(numbers(still), rel=1e-12, abs=1e-12)
    right, out, up = motion.velocity
    fall = (up + math.sqrt(up**2 + 2 * 9.80665 * motion.position[2])) / 9.80665
    assert here.hang_time[0] == pytest.approx(fall, rel=1e-9)
    assert here.landing_position[0][:2] == pytest.approx(
        [motion.position[0] + right * fall, motion.position[1] + out * fall], rel=1e-9, abs=1e-9
    )


@examples(8)
@given(motion=motions(), air=AIRS, wind=UNIFORM, part=st.floats(0.1, 0.9))
def test_a_flight_cut_in_two(motion: BallMotion, air: Air, wind: Wind, part: float) -> None:
    """Exact, but for the steps and the cubic between them: what is left of a flight is a flight."""
    conditions = through(air, wind)
    whole = fly(motion, conditions, step=0.002)
    moment = whole.times[round(part * (len(whole.times) - 2))]
    rest = fly(whole.at(float(moment)), conditions, step=0.002)
    assert moment + rest.hang_time == pytest.approx(whole.hang_time, rel=1e-6, abs=1e-6)
    assert rest.landing.position == pytest.approx(whole.landing.position, rel=1e-5, abs=1e-4)


@examples(6)
@given(several=st.lists(motions(), min_size=3, max_size=9), air=AIRS, wind=WINDS, order=st.randoms())
def test_flights_do_not_know_of_each_other(several: list[BallMotion], air: Air, wind: Wind, order: st.DrawFn) -> None:
    """Exact: together, one by one, in another order, on other threads."""

    def carries(which: list[BallMotion], threads: int) -> Array:
        velocity, spin, position = (
            np.array([getattr(each, name) for each in which]) for name in ("velocity", "spin", "position")
        )
        rows = BallMotions(velocity=velocity, spin=spin, position=position)
        return flights(rows, through(air, wind), step=STEP, threads=threads).carry

    mixed = list(several)
    order.shuffle(mixed)  # type: ignore[attr-defined]
    together = carries(several, 1)
    assert np.concatenate([carries([each], 1) for each in several]) == pytest.approx(together, rel=1e-12)
    assert sorted(carries(mixed, 2)) == pytest.approx(sorted(together), rel=1e-12)


@examples(10)
@given(motion=motions(), air=AIRS)
def test_more_drag_is_never_farther(motion: BallMotion, air: Air) -> None:
    """Derived for balls without lift: more drag shortens way and height."""
    smooth = replace(motion, spin=np.zeros(3))
    less, more = (
        flown(smooth, FlightConditions(ball=BALL, aerodynamics=LAW.with_drag(size), air=air)) for size in (0.95, 1.05)
    )
    assert more.carry[0] <= less.carry[0] + 1e-9 and more.apex_height[0] <= less.apex_height[0] + 1e-9


@pytest.mark.parametrize("side", [15.0, -32.0])
@pytest.mark.parametrize("wind", ["left-to-right", "right-to-left", "out", "in"])
def test_the_scatter_of_a_mirrored_carry(side: float, wind: str) -> None:
    """Exact: once a cross wind from the left scattered a carry by 3 % more than the mirrored one from the right."""
    swapped = {"left-to-right": "right-to-left", "right-to-left": "left-to-right"}

    def hit(sign: float, hand: Side, blows: str) -> tuple[object, ...]:
        told = sweetspot.fly(
            exit_speed="100mph", launch_angle="25deg", backspin="2000rpm", spray=f"{sign * side}deg",
            sidespin=f"{sign * 600}rpm", bats=hand, wind_speed="10mph", wind_direction=blows,
        )  # fmt: skip
        return told.carry, told.carry_spread, told.carry_half

    assert hit(-1, "left", swapped.get(wind, wind)) == pytest.approx(hit(1, "right", wind), rel=1e-9)

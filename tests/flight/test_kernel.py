"""Many flights: the same as the readable one, and every odd row an outcome of its own."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.air import CALM, Air, Wind
from sweetspot.flight.compiled import LANES
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import FlightOutcome, fly
from sweetspot.motion.ball_motion import BallMotion, BallMotions, batted_ball
from sweetspot.units import FOOT, MPH, RPM

BALL, LAW, AIR = catalog.ball(), catalog.aerodynamics("baseball"), Air(temperature=21.0)


MOTION, CONDITIONS = ("position", "velocity", "spin"), ("ball", "aerodynamics", "air", "wind")


def random_hits(count: int, seed: int = 3) -> list[BallMotion]:
    generator = np.random.default_rng(seed)
    return [
        batted_ball(
            speed=generator.uniform(60, 115) * MPH,
            launch_angle=generator.uniform(-0.2, 1.5),
            spray=generator.uniform(-0.8, 0.8),
            backspin=generator.uniform(-500, 4000) * RPM,
            sidespin=generator.uniform(-2000, 2000) * RPM,
            gyrospin=generator.uniform(-500, 500) * RPM,
            position=(0.0, 0.6, generator.uniform(0.0, 1.5)),
        )
        for _ in range(count)
    ]


def many(motions: list[BallMotion], **changes: object) -> Flights:
    return asked({name: [getattr(one, name) for one in motions] for name in MOTION} | changes)


def asked(changes: dict[str, object]) -> Flights:
    usual = {"position": [0, 0, 1], "velocity": [0, 30, 10], "spin": [0, 0, 0],
             "ball": BALL, "aerodynamics": LAW, "air": AIR, "wind": CALM}  # fmt: skip
    options = usual | changes
    motions = BallMotions(**{name: options.pop(name) for name in MOTION})  # type: ignore[arg-type]
    conditions = FlightConditions(**{name: options.pop(name) for name in CONDITIONS})  # type: ignore[arg-type]
    return flights(motions, conditions, **options)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "wind",
    [CALM, Wind(speed=7.0, direction=1.0), Wind(speed=7.0, direction=2.5, exponent=0.2), Wind(speed=9.0, calm_below=6)],
)
@pytest.mark.parametrize("law", ["baseball", "golf", "tennis", "table-tennis"])
def test_like_the_readable_flight(wind: Wind, law: str) -> None:
    """The same arithmetic in another order: only rounding apart."""
    hits, rules = random_hits(5), catalog.aerodynamics(law)
    ball = BALL if law == "baseball" else catalog.ball(law)
    found = many(hits, wind=wind, aerodynamics=rules, ball=ball, step=0.1, path_points=4)
    for row, motion in enumerate(hits):
        one = fly(motion, FlightConditions(ball=ball, aerodynamics=rules, air=AIR, wind=wind), step=0.1)
        assert found.outcome[row] == one.outcome
        for field in ("carry", "hang_time", "apex_height", "apex_time"):
            assert getattr(found, field)[row] == pytest.approx(getattr(one, field), abs=1e-8), field
        assert found.landing_position[row] == pytest.approx(one.landing.position, abs=1e-8)
        assert found.landing_velocity[row] == pytest.approx(one.landing.velocity, abs=1e-8)
        assert found.spin_left[row] == pytest.approx(one.spin_left[-1], abs=1e-10)
        assert found.landing_angle[row] == pytest.approx(one.landing_angle, abs=1e-8)
        for point in range(4):
            there = one.at(min(found.times[row, point], one.hang_time))
            assert found.positions[row, point] == pytest.approx(there.position, abs=1e-6)


def test_error_of_the_usual_step() -> None:
    """Asked: 0.05 ft of carry; hits of 60 to 115 mph from ground balls to pop-ups, with any spin."""
    hits = random_hits(500)
    usual, fine = many(hits), many(hits, step=0.005)
    assert np.abs(usual.carry - fine.carry).max() < 0.02 * FOOT
    assert np.median(np.abs(usual.carry - fine.carry)) < 0.0005 * FOOT
    assert np.abs(usual.hang_time - fine.hang_time).max() < 0.001


@given(st.integers(0, 3 * LANES), st.integers(0, 2**31))
@settings(max_examples=15)
def test_rows_do_not_know_of_each_other(count: int, seed: int) -> None:
    hits = random_hits(3 * LANES, seed)
    together, alone = many(hits), many(hits[count : count + 1] or hits[:1])
    row = count if count < len(hits) else 0
    assert together.carry[row] == alone.carry[0] and together.apex_time[row] == alone.apex_time[0]


def test_threads_change_nothing() -> None:
    hits = random_hits(200) * 50
    one, two = many(hits, threads=1), many(hits, threads=2)
    assert np.array_equal(one.carry, two.carry) and np.array_equal(one.landing_velocity, two.landing_velocity)


def test_odd_rows_have_outcomes_and_the_others_go_on() -> None:
    nan = math.nan
    position = np.array([[0, 0.6, 1], [0, 0, -0.1], [0, 0, 1], [0, 0, 0], [0, 0, 1], [0, 0, 1], [nan, 0, 1]])
    velocity = np.array([[0, 40, 20], [0, 40, 20], [0, nan, 20], [0, 40, -5], [0, 0, 35], [0, 30, -10], [0, 40, 20.0]])
    found = flights(
        BallMotions(velocity=velocity, spin=[250.0, 0.0, 0.0], position=position),
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
        path_points=3,
    )
    assert [FlightOutcome(value).name for value in found.outcome] == [
        "LANDED", "UNDERGROUND", "UNUSABLE", "LANDED", "LANDED", "LANDED", "UNUSABLE",
    ]  # fmt: skip
    for row in (1, 2, 6):
        assert np.isnan([found.carry[row], found.hang_time[row], found.apex_height[row]]).all()
        assert np.isnan(found.positions[row]).all() and np.isnan(found.times[row]).all()
    assert (found.hang_time[3], found.carry[3]) == (0.0, 0.0)
    assert np.array_equal(found.positions[3], position[[3, 3, 3]])
    assert found.landed.sum() == 4 and len(found) == 7


def test_no_flights_at_all() -> None:
    empty = np.empty((0, 3))
    assert (
        len(
            flights(
                BallMotions(velocity=empty, spin=empty, position=empty),
                FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
            )
        )
        == 0
    )


def test_a_density_and_a_wind_for_every_row() -> None:
    hit = random_hits(1)[0]
    airs, winds = (AIR, AIR.replaced(elevation=1600.0)), (CALM, Wind(speed=6.0, direction=2.0))
    found = flights(
        hit,
        FlightConditions(
            ball=BALL, aerodynamics=LAW, air=[air.density for air in airs], wind=[wind.velocity[:2] for wind in winds]
        ),
    )
    for row, (air, wind) in enumerate(zip(airs, winds, strict=True)):
        alone = fly(hit, FlightConditions(ball=BALL, aerodynamics=LAW, air=air, wind=wind), step=0.2)
        assert found.carry[row] == pytest.approx(alone.carry, abs=1e-8)


def test_an_impossible_density_is_an_outcome() -> None:
    found = flights(
        BallMotions(velocity=[0, 30, 10], spin=[0, 0, 0], position=[0, 0, 1]),
        FlightConditions(ball=BALL, aerodynamics=LAW, air=[1.2, -1.0, math.nan]),
    )
    assert list(found.outcome) == [FlightOutcome.LANDED, FlightOutcome.UNUSABLE, FlightOutcome.UNUSABLE]


def test_absurd_numbers_end_too() -> None:
    """Faster than a meteor, and spinning faster than anything can: steps shorten, and the ball comes down."""
    found = flights(
        BallMotions(
            velocity=[[0.0, 1e6, 1e4], [0.0, 40.0, 20.0]], spin=[[0.0, 0.0, 0.0], [1e6, 0.0, 0.0]], position=[0, 0, 1]
        ),
        FlightConditions(ball=BALL, aerodynamics=LAW, air=AIR),
    )
    assert set(found.outcome) <= {FlightOutcome.LANDED, FlightOutcome.STILL_FLYING}
    assert found.outcome[0] == FlightOutcome.LANDED


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"position": [0.0, 1.0]}, r"position has the shape \(2,\)"),
        ({"wind": [1.0, 2.0, 3.0]}, r"wind has the shape \(3,\)"),
        ({"velocity": np.ones((3, 3)), "spin": np.ones((2, 3))}, "give each one row, or the same number"),
        ({"step": 0.0}, "step is 0 s"),
        ({"path_points": 1}, "path_points is 1"),
    ],
)
def test_inputs_that_do_not_fit_are_refused(changes: dict[str, object], words: str) -> None:
    with pytest.raises(InputError, match=words):
        asked(changes)

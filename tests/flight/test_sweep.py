"""What if: a hit with its numbers varied is the same hit asked one by one, and what cannot be is refused."""

from __future__ import annotations

from dataclasses import replace

import pytest

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.flying import trajectory as fly
from sweetspot.flight.sweep import BattedBall, Variation, flight_table
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.units import DEGREE, MPH

BALL, LAW = catalog.ball(), catalog.aerodynamics("baseball")
HIT = BattedBall(exit_speed=100 * MPH, launch_angle=28 * DEGREE)


def alone(hit: BattedBall) -> float:
    """Return the carry of one hit, m."""
    conditions = FlightConditions(ball=BALL, aerodynamics=LAW, air=hit.air, wind=hit.wind)
    return fly(hit.motion, conditions).carry


def test_every_cell_is_the_hit_with_those_two_numbers() -> None:
    angles, winds = (20 * DEGREE, 30 * DEGREE, 40 * DEGREE), (0.0, 5.0)
    table = flight_table(HIT, rows=("launch_angle", angles), columns=("wind_speed", winds), ball=BALL, aerodynamics=LAW)
    carry = table.values(table.flights.carry)
    assert carry.shape == (3, 2)
    for i, angle in enumerate(angles):
        for j, speed in enumerate(winds):
            cell = replace(HIT, launch_angle=angle, wind_speed=speed)
            assert carry[i, j] == pytest.approx(alone(cell), abs=0.02)
    assert (carry[:, 1] > carry[:, 0]).all()  # towards centre field
    column = flight_table(HIT, rows=("temperature", (0.0, 35.0)), ball=BALL, aerodynamics=LAW)
    assert column.values(column.flights.carry).shape == (2, 1)
    assert column.flights.carry[1] > column.flights.carry[0]  # thinner air


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        (("height", (1.0, -0.1)), "below the ground"),
        (("beauty", (1.0,)), "cannot be varied; allowed is exit_speed"),
        (("launch_angle", ()), "0 values"),
        (("exit_speed", (-1.0,)), "zero or more"),
        (("humidity", (7.0,)), "humidity"),
    ],
)
def test_what_no_cell_can_be_is_refused(rows: tuple[Variation, tuple[float, ...]], message: str) -> None:
    with pytest.raises(InputError, match=message):
        flight_table(HIT, rows=rows, ball=BALL, aerodynamics=LAW)


def test_one_ball_and_many_by_the_same_door() -> None:
    conditions = FlightConditions(ball=BALL, aerodynamics=LAW, air=HIT.air)
    motion = HIT.motion
    assert isinstance(motion, BallMotion)
    single = fly(motion, conditions)
    both = BallMotions(velocity=[motion.velocity] * 2, spin=[motion.spin] * 2, position=[motion.position] * 2)
    many = fly(both, conditions)
    assert many.carry == pytest.approx([single.carry] * 2, abs=0.02)
    fine = fly(both, conditions, step=0.002), fly(motion, conditions, step=0.002)
    assert fine[0].carry[0] == pytest.approx(fine[1].carry, abs=1e-4)

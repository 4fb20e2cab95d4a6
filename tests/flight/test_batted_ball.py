"""Balls that leave a bat, from Python: what is no number, no speed or no array that fits is refused."""

from __future__ import annotations

import math
from typing import Any

import pytest

from sweetspot import InputError, Wind, batted_ball, standard_flight, trajectory
from sweetspot.flight.trajectory import FlightOutcome


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"speed": math.nan}, "speed is not a finite number; leave out"),
        ({"speed": [40.0, math.inf]}, "speed is not a finite number; leave"),
        ({"backspin": math.inf}, "backspin is not a finite number"),
        ({"speed": "100in"}, "speed was given as .100in., which is not a speed"),
        ({"launch_angle": math.nan}, "launch_angle is not a finite number; leave out"),
        ({"position": (0.0, math.nan, 1.0)}, "position is not a finite number; leave"),
    ],
)
def test_what_is_no_number_starts_no_ball(wrong: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        batted_ball(**{"speed": 40.0, "launch_angle": 0.4, **wrong})


@pytest.mark.parametrize("wrong", ["speed", "launch_angle"])
def test_a_row_that_was_not_measured_has_no_flight_and_the_others_do(wrong: str) -> None:
    measured: dict[str, Any] = {"speed": [40.0, 41.0], "launch_angle": [0.4, 0.4]}
    whole = trajectory(batted_ball(**measured), standard_flight())
    found = trajectory(batted_ball(**{**measured, wrong: [math.nan, measured[wrong][1]]}), standard_flight())
    assert found.outcome.tolist() == [FlightOutcome.UNUSABLE, FlightOutcome.LANDED]
    assert math.isnan(found.carry[0]) and found.carry[1] == whole.carry[1]


def test_a_wind_in_degrees_is_refused() -> None:
    with pytest.raises(InputError, match=r"direction: it is 90 rad; angles are in radians: write math.radians\(90\)"):
        Wind(speed=5.0, direction=90)
    assert Wind(speed=5.0, direction=-math.pi).velocity[1] == pytest.approx(-5.0)


@pytest.mark.parametrize(
    "wrong",
    [
        {"speed": [40.0, 45.0, 30.0], "launch_angle": [0.4, 0.5]},
        {"speed": ["100mph", "90mph"], "spray": [0.1, 0.2, 0.3]},
    ],
)
def test_arrays_that_do_not_fit_are_refused(wrong: dict[str, Any]) -> None:
    with pytest.raises(InputError, match="do not fit together"):
        batted_ball(**{"launch_angle": 0.4, **wrong})

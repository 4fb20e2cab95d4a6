"""One ball or many flown to the ground by one call."""

from __future__ import annotations

from typing import overload

from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import STEP as STEP_OF_MANY
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.trajectory import STEP, Flight
from sweetspot.flight.trajectory import fly as fly_one
from sweetspot.motion.ball_motion import BallMotion, BallMotions


@overload
def trajectory(motion: BallMotion, conditions: FlightConditions, *, step: float | None = None) -> Flight: ...
@overload
def trajectory(motion: BallMotions, conditions: FlightConditions, *, step: float | None = None) -> Flights: ...


def trajectory(
    motion: BallMotion | BallMotions, conditions: FlightConditions, *, step: float | None = None
) -> Flight | Flights:
    """Return the flight of a ball to the ground, or those of many balls, each with its own outcome.

    Parameters
    ----------
    motion : one ball as it leaves the bat, or many of them, as `batted_ball` gives either.
    conditions : ball, drag law, air and wind.
    step : s, > 0; None: the usual one of a single flight or of many.

    Raises
    ------
    InputError
        for a start below the ground.

    See Also
    --------
    sweetspot.flight.trajectory.fly : the method.
    sweetspot.flight.kernel.flights : many flights, with their paths where they are wanted.

    >>> from math import radians
    >>> from sweetspot import trajectory, batted_ball, standard_flight
    >>> flight = trajectory(batted_ball(speed=46.0, launch_angle=radians(28), backspin=240.0), standard_flight())
    >>> round(flight.carry), round(flight.hang_time, 1)  # m, s
    (122, 5.3)
    """
    if isinstance(motion, BallMotions):
        return flights(motion, conditions, step=STEP_OF_MANY if step is None else step)
    return fly_one(motion, conditions, step=STEP if step is None else step)

"""The same hit in many parks, each with its own fence and, where wanted, its own thin or thick air."""

from __future__ import annotations

from collections.abc import Iterable

from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import Landings, landings
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotion, BallMotions

PATH_POINTS = 161
"""Points of a path; over a flight of 6 s the chords between them cut off less than 2 mm of its height."""


def fly_all_parks(
    motions: BallMotion | BallMotions,
    conditions: FlightConditions,
    *,
    parks: Iterable[Park],
    own_elevation: bool = True,
) -> tuple[Landings, ...]:
    """Return where hits end in each park, in the order of the parks.

    Parameters
    ----------
    motions : the balls as they leave the bat; shapes are broadcast together.
    conditions : the air's temperature, humidity and pressure at sea level hold everywhere, its elevation where
        ``own_elevation`` is off; the wind is in every park the same against the line to centre field.
    own_elevation : whether each park lies at its own elevation, or all where ``air`` says.

    Returns
    -------
    Each park's `Landings`, of shape (n,); one for the shape (3,).

    >>> from math import radians
    >>> from sweetspot import catalog, fly_all_parks, batted_ball, standard_flight
    >>> ball = batted_ball(speed=46.0, launch_angle=radians(28), backspin=240.0)
    >>> everywhere = fly_all_parks(ball, standard_flight(), parks=catalog.parks())
    >>> len(everywhere), sum(bool(one.out.all()) for one in everywhere)  # parks, and where it is a home run
    (30, 2)
    """
    ends = []
    for park in parks:
        air = conditions.one_air.replaced(elevation=park.elevation) if own_elevation else conditions.one_air
        flown = flights(motions, conditions.in_air(air), path_points=PATH_POINTS)
        ends.append(landings(flown.positions, park))
    return tuple(ends)

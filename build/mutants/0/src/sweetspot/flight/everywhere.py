"""The same hit in many parks, each with its own fence and, where wanted, its own thin or thick air."""

from __future__ import annotations

from collections.abc import Iterable

from numpy.typing import ArrayLike

from sweetspot.aerodynamics import Aerodynamics
from sweetspot.air import CALM, Air, Wind
from sweetspot.ball import Ball
from sweetspot.flight.fence import Landings, landings
from sweetspot.flight.kernel import flights
from sweetspot.park import Park

PATH_POINTS = 161
"""Points of a path; over a flight of 6 s the chords between them cut off less than 2 mm of its height."""


def landings_everywhere(
    position: ArrayLike,
    velocity: ArrayLike,
    spin: ArrayLike,
    *,
    parks: Iterable[Park],
    ball: Ball,
    aerodynamics: Aerodynamics,
    air: Air,
    wind: Wind = CALM,
    own_elevation: bool = True,
) -> tuple[Landings, ...]:
    """Return where hits end in each park, in the order of the parks.

    Parameters
    ----------
    position, velocity, spin : m, m/s and rad/s as the ball leaves the bat, shape (3,) or (n, 3), broadcast together.
    air : temperature, humidity and the pressure at sea level everywhere; its elevation where ``own_elevation`` is off.
    wind : over the field, in every park the same against the line to centre field.
    own_elevation : whether each park lies at its own elevation, or all where ``air`` says.

    Returns
    -------
    Each park's `Landings`, of shape (n,); one for the shape (3,).
    """
    found = []
    for park in parks:
        here = air.replaced(elevation=park.elevation) if own_elevation else air
        flown = flights(
            position, velocity, spin, ball=ball, aerodynamics=aerodynamics, air=here, wind=wind, path_points=PATH_POINTS
        )
        found.append(landings(flown.positions, park))
    return tuple(found)

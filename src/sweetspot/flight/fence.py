"""Does it go out? Where a flight meets the fence of a park, and how far above or below its top.

A path is an array of positions of the ball's centre in m, shape (..., points, 3): right, out, up, from the tip of home
plate. After the ball has come down the rest may be NaN. Any number of flights can be judged at once.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at, nearest_fence
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.numerics.arrays import Array

Outcome = Literal["home run", "off the wall", "in play", "foul"]
OUTCOMES: tuple[Outcome, ...] = ("home run", "off the wall", "in play", "foul")


@dataclass(frozen=True)
class Landings:
    """Landings of many flights in one park, each field of the shape of the flights.

    Parameters
    ----------
    outcome : the words of `OUTCOMES`.
    direction : rad from centre field where it passes the fence, or comes down.
    distance : m over the ground from home plate to there.
    height : m of the ball's centre there.
    clearance : m from the fence's top up to the ball's centre; negative: it hits the wall; NaN: it comes down before.
    """

    outcome: NDArray[np.str_]
    direction: Array
    distance: Array
    height: Array
    clearance: Array

    @property
    def out(self) -> NDArray[np.bool_]:
        """Whether it is a home run."""
        return np.asarray(self.outcome == "home run")


@dataclass(frozen=True)
class Landing:
    """Landing of one flight in one park; the fields are those of `Landings`, ``clearance`` None before the fence."""

    outcome: Outcome
    direction: float
    distance: float
    height: float
    clearance: float | None


def landing(path: Array, park: Park) -> Landing:
    """Return the landing of one path of shape (points, 3) in a park.

    >>> park = Park(name="round", fence=((-FOUL_LINE, 100.0, 3.0), (0.0, 100.0, 3.0), (FOUL_LINE, 100.0, 3.0)))
    >>> landing(np.array([[0.0, 0.0, 1.0], [0.0, 90.0, 10.0], [0.0, 110.0, 2.0]]), park)
    Landing(outcome='home run', direction=0.0, distance=100.0, height=6.0, clearance=3.0)
    """
    if np.ndim(path) != 2:
        raise InputError(f"path has the shape {np.shape(path)}; give one flight, (points, 3), or use `landings`")
    landed = landings(path, park)
    clearance = float(landed.clearance)
    return Landing(
        outcome=next(word for word in OUTCOMES if word == str(landed.outcome)),
        direction=float(landed.direction),
        distance=float(landed.distance),
        height=float(landed.height),
        clearance=None if np.isnan(clearance) else clearance,
    )


def landings(path: Array, park: Park) -> Landings:
    """Return the landings of flights in a park.

    A ball leaves where its distance over the ground first exceeds the fence's in its direction; between two points of
    the path it goes straight. It is out when its centre is above the top there. A ball that passes the distance of a
    foul pole on the wrong side of it, or comes down outside the foul lines before it, is foul.

    ``path``: m, shape (..., points, 3), at least two points that are no NaN in each flight.

    Raises
    ------
    InputError
        for an array of another shape.
    """
    path = np.asarray(path, float)
    if path.ndim < 2 or path.shape[-1] != 3 or path.shape[-2] < 2:
        raise InputError(
            f"path has the shape {path.shape}; allowed is (points, 3) or (flights, points, 3), two points up"
        )
    end, passed = _end(path, park)
    direction, distance = np.arctan2(end[..., 0], end[..., 1]), np.hypot(end[..., 0], end[..., 1])
    foul = np.abs(direction) > FOUL_LINE
    clearance = np.where(passed & ~foul, end[..., 2] - fence_at(park, direction)[1], np.nan)
    outcome = np.select([foul, clearance > 0, passed], ["foul", "home run", "off the wall"], "in play")
    return Landings(outcome, direction, distance, end[..., 2], clearance)


def _end(path: Array, park: Park) -> tuple[Array, NDArray[np.bool_]]:
    """Return each flight's point at the fence's distance, or else its last, (..., 3), and whether it gets there."""
    far = np.hypot(path[..., 0], path[..., 1]) > nearest_fence(park)
    outside = np.zeros(far.shape, bool)
    outside[far] = _beyond(path[far], park) > 0
    passed = np.asarray(outside.any(axis=-1))
    last = np.sum(~np.isnan(path[..., 0]), axis=-1) - 1
    after = np.where(passed, outside.argmax(axis=-1), last)
    ends = [
        np.take_along_axis(path, at[..., None, None], axis=-2)[..., 0, :] for at in (np.maximum(after - 1, 0), after)
    ]
    short, long = (_beyond(end, park) for end in ends)
    share = np.divide(-short, long - short, out=np.ones(passed.shape), where=passed & (short < 0))
    return np.asarray(ends[0] + share[..., None] * (ends[1] - ends[0])), passed


def _beyond(place: Array, park: Park) -> Array:
    """Return by how much in m places of shape (..., 3) lie beyond the fence."""
    right, out = place[..., 0], place[..., 1]
    return np.hypot(right, out) - fence_at(park, np.arctan2(right, out))[0]


def out_in(path: Array, parks: Iterable[Park]) -> NDArray[np.int64]:
    """Return in how many parks each flight is a home run, flown in the same air everywhere."""
    return np.asarray(np.sum([landings(path, park).out for park in parks], axis=0))


PATH_POINTS = 161
"""Points of a path; over a flight of 6 s the chords between them cut off less than 2 mm of its height."""


def fly_all_parks(
    motions: BallMotion | BallMotions,
    conditions: FlightConditions,
    *,
    parks: Iterable[Park],
    own_elevation: bool = True,
) -> tuple[Landings, ...]:
    """Return the landings of hits in each park, in the order of the parks.

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
    (30, 1)
    """
    ends = []
    for park in parks:
        air = conditions.one_air.replaced(elevation=park.elevation) if own_elevation else conditions.one_air
        flown = flights(motions, conditions.in_air(air), path_points=PATH_POINTS)
        ends.append(landings(flown.positions, park))
    return tuple(ends)

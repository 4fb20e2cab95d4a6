"""Passage of a flight over the marks of a court or field: over the net, before the line, beyond the boundary."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import CourtMark
from sweetspot.flight.trajectory import Flight, FlightOutcome


@dataclass(frozen=True)
class Passage:
    """A flight at one mark.

    Parameters
    ----------
    mark : which.
    ball_height : m, of the ball's lowest point as it passes over the mark; nan when it landed before.
    margin : m; for a mark to be passed, how far above its top the ball flies (or how far short of it it landed, then
        negative); for a line to land before, how far before it the ball lands.
    good : whether the flight does what it must.
    """

    mark: CourtMark
    ball_height: float
    margin: float
    good: bool


def passages(flight: Flight, marks: Sequence[CourtMark], *, ball: Ball) -> tuple[Passage, ...]:
    """Return a flight at every mark, in their order; distances count from where the ball starts, along its way.

    ``flight``: one that landed.

    >>> passages.__module__
    'sweetspot.flight.court_marks'
    """
    start = flight.positions[0, :2]
    along = np.hypot(*(flight.positions[:, :2] - start).T)
    return tuple(_passage(flight, along, mark, ball) for mark in marks)


def _passage(flight: Flight, along: np.ndarray, mark: CourtMark, ball: Ball) -> Passage:
    distance, needed = mark.distance.value, mark.height.value if mark.height else 0.0
    reached = float(along[-1])
    short = reached < distance
    height = math.nan if short else _height_at(flight, along, distance) - ball.radius
    landed = flight.outcome is FlightOutcome.LANDED
    if mark.side == "before":
        return Passage(mark, height, distance - reached, landed and short)
    margin = reached - distance if short else height - needed
    return Passage(mark, height, margin, not short and margin >= 0)


def _height_at(flight: Flight, along: np.ndarray, distance: float) -> float:
    """Return the height of the ball's centre where it passes a distance, on the smooth path between the steps."""
    time = float(np.interp(distance, along, flight.times))
    start = flight.positions[0, :2]
    for _ in range(3):  # the steps are fine: three corrections leave nothing to see
        ball = flight.at(time)
        away = float(np.hypot(*(ball.position[:2] - start)))
        speed = float(np.hypot(*ball.velocity[:2]))
        time = min(max(time + (distance - away) / speed, float(flight.times[0])), float(flight.times[-1]))
    return float(flight.at(time).position[2])

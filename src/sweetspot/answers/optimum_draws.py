"""The best way to hit, for bats, balls and speeds that may be meant.

What is searched, place, undercut, attack and launch angle, is a choice and stays as it is best for everything as
described. At a maximum the height does not change with the place to first order, so the carry of what would be best for
each draw differs from that carry in the second order only.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from sweetspot.analysis.optimum import EasiestHomeRun, easiest_home_run
from sweetspot.answers.flight_draws import DRAG, dragged, draws_of_sources, flight_columns
from sweetspot.answers.play_draws import drawn_play
from sweetspot.answers.play_question import PlayQuestion
from sweetspot.answers.records import Columns
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.sources import Sources

OF_PLAY = ("exit_speed", "launch_angle", "spray", "backspin", "sidespin", "pitch_speed", "carry", "hang_time")
"""Fields of a best swing that draws of its play answer."""


@dataclass(frozen=True)
class DrawnOptimum:
    """What draws answer to what was asked about the best way to hit.

    Parameters
    ----------
    normal : standard normal numbers behind every draw, shape (draws, n).
    columns : by the fields of `OptimumAnswer`.
    main, main_name : the first number that was asked for, shape (draws,), and where it stands.
    """

    normal: Array
    columns: Columns
    main: Array
    main_name: str


@dataclass(frozen=True)
class AskedPark:
    """The slowest home run of a park as described, and what it flies through."""

    best: EasiestHomeRun
    conditions: FlightConditions


def drawn_optimum(
    sources: Sources,
    *,
    swings: Sequence[PlayQuestion] = (),
    launches: Sequence[tuple[BallMotion, FlightConditions]] = (),
    parks: Sequence[AskedPark] = (),
    backspin: float = 0.0,
    count: int,
) -> DrawnOptimum:
    """Return the sampled answers to a question about the best way to hit.

    Parameters
    ----------
    sources : of the hit, and `drag_source`.
    swings : the best contact with every pitch.
    launches : balls as they leave best, and what they fly through.
    parks, backspin : slowest home runs, and with which spin they fly, rad/s.
    """
    normal, off = draws_of_sources(sources, count)
    drag = sources.of(DRAG, off)
    plays = [drawn_play(replace(asked, draws=count), sources) for asked in swings]
    of_swings = [{name: {**play.contact, **play.flight}[name] for name in OF_PLAY} for play in plays]
    flown = [flight_columns(_alike(left, len(off)), flying, drag) for left, flying in launches]
    of_launches = [{"carry": flight["carry"]} for flight in flown]
    of_parks = [{"exit_speed": _slowest(park, drag, backspin)} for park in parks]
    rows = {"swings": of_swings, "launches": of_launches, "parks": of_parks}
    columns = {name: row for name, row in rows.items() if row}
    first, name = next((row[0], name) for name, row in columns.items())
    number = "carry" if "carry" in first else "exit_speed"
    return DrawnOptimum(normal, columns, first[number], f"{name}.0.{number}")


def _alike(left: BallMotion, count: int) -> BallMotions:
    """Return a ball many times."""
    velocity = np.tile(np.asarray(left.velocity), (count, 1))
    return BallMotions(velocity=velocity, spin=np.asarray(left.spin), position=np.asarray(left.position))


def _slowest(park: AskedPark, drag: Array, backspin: float) -> Array:
    """Return the exit speed of the slowest home run over the fence that asks least, for every drag."""
    size, where = float(np.std(drag)), [park.best.direction]
    up, down = (
        easiest_home_run(
            park.best.park, dragged(park.conditions, sign * size), backspin=backspin, directions=where
        ).exit_speed
        for sign in (1.0, -1.0)
    )
    return np.asarray(park.best.exit_speed + drag / size * (up - down) / 2)

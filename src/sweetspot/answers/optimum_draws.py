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
from sweetspot.flight.conditions import FlightConditions
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.numerics.arrays import Array
from sweetspot.uncertainty.intervals import DrawnAnswers
from sweetspot.uncertainty.sources import DRAWS, Sources

TOLD = {
    "exit_speed": "exit_speed_m_s",
    "launch_angle": "launch_angle_rad",
    "spray": "spray_rad",
    "backspin": "backspin_rad_s",
    "sidespin": "sidespin_rad_s",
    "pitch_speed": "pitch_speed_m_s",
    "carry": "carry_m",
    "hang_time": "hang_time_s",
}
"""Fields of a play and of its flight, with their names in the data of a best swing."""


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
    count: int = DRAWS,
) -> DrawnAnswers:
    """Return the answers of draws to what was asked about the best way to hit, by their names in its data.

    Parameters
    ----------
    sources : of the hit, and `drag_source`.
    swings : the best contact with every pitch.
    launches : balls as they leave best, and what they fly through.
    parks, backspin : slowest home runs, and with which spin they fly, rad/s.
    """
    normal, off = draws_of_sources(sources, count)
    drag = sources.of(DRAG, off)
    values: dict[str, Array] = {}
    for index, asked in enumerate(swings):
        drawn = drawn_play(replace(asked, draws=count), sources)
        answers = {**drawn.contact, **drawn.flight}
        values |= {f"swings.{index}.{told}": answers[name] for name, told in TOLD.items()}
    for index, (left, flying) in enumerate(launches):
        balls = BallMotions(
            velocity=np.tile(np.asarray(left.velocity), (len(off), 1)), spin=np.asarray(left.spin),
            position=np.asarray(left.position),
        )  # fmt: skip
        values[f"launches.{index}.carry_m"] = flight_columns(balls, flying, drag)["carry"]
    size = float(np.std(drag))
    for index, park in enumerate(parks):
        where = [park.best.direction]  # the fence that asks least
        up, down = (
            easiest_home_run(
                park.best.park, dragged(park.conditions, sign * size), backspin=backspin, directions=where
            ).exit_speed
            for sign in (1.0, -1.0)
        )
        values[f"parks.{index}.exit_speed_m_s"] = park.best.exit_speed + drag / size * (up - down) / 2
    return DrawnAnswers(normal, sources.names, values)

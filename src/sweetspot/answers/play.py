"""One pitch hit: how the bat meets it, how the ball leaves, how far it flies, and whether it is out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from sweetspot.analysis.full_play import Play, play
from sweetspot.answers.answer import Answer, Uncertainty, uncertainty_of
from sweetspot.answers.flight import BallLeaving, FlightEnd, FlightNumbers, ball_leaving, flight_end, flight_numbers
from sweetspot.answers.play_draws import drawn_play
from sweetspot.answers.play_question import PlayQuestion
from sweetspot.answers.records import (
    INTERNAL,
    Angle,
    Columns,
    Distance,
    Force,
    Length,
    Ratio,
    Speed,
    Spin,
    Time,
    with_intervals,
)
from sweetspot.answers.setups import SwungWith
from sweetspot.flight.carry_scatter import carry_spread
from sweetspot.flight.home_runs import USUAL, home_run_chances
from sweetspot.flight.trajectory import FlightOutcome
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.intervals import reach_of_draws
from sweetspot.uncertainty.sources import error_by_ball


@dataclass(frozen=True, kw_only=True)
class PlayAnswer(Answer):
    """One play; what a miss does not have is None.

    Parameters
    ----------
    offset : by which the ball's centre lies above the bat's axis, square to the bat's path.
    travel_along, travel_around, gripped : see `Strike`.
    fence : where the flight ends in the park; None: no park was named.
    unrecovered_gain : see `Collision`.
    carry_spread, carry_half : standard deviation of the carry of balls that leave alike, and half of its interval.
    exit_speed_half_by_ball : half of the interval that the ball alone leaves to the exit speed; None: not known, or
        part of the interval that stands there.
    home_run_chance : in the park, with the scatter of balls and weather.
    uncertainty : what the intervals come from; None: there are none.
    """

    question: Annotated[PlayQuestion, INTERNAL]
    play: Annotated[Play, INTERNAL]
    bat: str
    outcome: str
    position: Length
    offset: Length
    pitch_speed: Speed
    bat_speed: Speed
    closing_speed: Speed | None
    collision_efficiency: Ratio | None
    contact_time: Time | None
    peak_force: Force | None
    exit_speed: Speed | None
    launch_angle: Angle | None
    spray: Angle | None
    backspin: Spin | None
    sidespin: Spin | None
    gyrospin: Spin | None
    travel_along: Length | None
    travel_around: Length | None
    gripped: bool | None
    flight: FlightNumbers | None
    fence: FlightEnd | None
    unrecovered_gain: Speed | None = None
    carry_spread: Distance | None = None
    carry_half: Distance | None = None
    exit_speed_half_by_ball: Speed | None = None
    home_run_chance: float | None = None
    uncertainty: Uncertainty | None = None
    swung_with: SwungWith | None = None

    @property
    def launch(self) -> BallLeaving | None:
        """How the ball leaves, with its intervals; None after a miss."""
        left = self.play.strike.launched
        if left is None:
            return None
        drawn = {name: getattr(self, name) for name in LEAVING}
        return replace(ball_leaving(left), **drawn)


LEAVING = ("exit_speed", "launch_angle", "spray", "backspin", "sidespin", "gyrospin")
"""Fields of both `PlayAnswer` and `BallLeaving`."""


def play_answer(question: PlayQuestion) -> PlayAnswer:
    """Return one play.

    Raises
    ------
    InputError
        for a place that is not on the bat, or a contact below the ground.
    """
    conditions, sources = question.hit_conditions, question.sources
    played = play(
        question.reduced,
        question.flying,
        swing=conditions.swing,
        path=question.path,
        pitch=question.pitch,
        contact=question.contact,
    )
    plain = _described(question, played)
    if played.flight is None:
        return plain
    plain = _with_ending(plain)
    if sources is None:  # which have the ball among them
        error = error_by_ball(question.reduced, conditions, float(plain.position))
        return plain if error is None else replace(plain, exit_speed_half_by_ball=REACH * error)
    drawn = drawn_play(question, sources)
    sampled = uncertainty_of(
        drawn.flight["carry"],
        of="flight.carry",
        normal=drawn.normal,
        names=sources.names,
        sources=sources.described,
    )
    columns: Columns = {**drawn.contact, "flight": drawn.flight}
    return with_intervals(replace(plain, uncertainty=sampled), columns, reach_of_draws)


def _described(question: PlayQuestion, played: Play) -> PlayAnswer:
    """Return a play as it is described, without what other balls hit alike do."""
    struck, impact, left = played.strike, played.strike.impact, played.strike.launched
    position, offset = (float(np.asarray(value)) for value in question.contact)
    return PlayAnswer(
        question=question,
        play=played,
        bat=question.reduced.bat.name,
        outcome=struck.outcome.name.lower(),
        position=position,
        offset=offset,
        pitch_speed=question.pitch.speed,
        bat_speed=struck.bat_speed,
        closing_speed=None if impact is None else impact.closing_speed,
        collision_efficiency=None if impact is None else impact.collision_efficiency,
        contact_time=None if impact is None else impact.contact_time,
        peak_force=None if impact is None else impact.peak_force,
        exit_speed=None if left is None else left.speed,
        launch_angle=None if left is None else left.launch_angle,
        spray=None if left is None else left.spray,
        backspin=None if left is None else left.backspin,
        sidespin=None if left is None else left.sidespin,
        gyrospin=None if left is None else left.gyrospin,
        travel_along=struck.travel_along,
        travel_around=struck.travel_around,
        gripped=struck.gripped,
        flight=None if played.flight is None else flight_numbers(played.flight),
        fence=None if question.park is None or played.flight is None else flight_end(played.flight, question.park),
        unrecovered_gain=None if impact is None or impact.unrecovered is None else impact.unrecovered_gain,
    )


def _with_ending(plain: PlayAnswer) -> PlayAnswer:
    """Return a play with how far apart balls that leave alike come down, and the chance of a home run in its park."""
    question, flight = plain.question, plain.play.flight
    if flight is None or flight.outcome is not FlightOutcome.LANDED or question.reduced.bat.sport != "baseball":
        return plain  # the scatter of other balls has not been measured
    flying, park = question.flying, question.park
    # its spin follows from the hit
    spread = carry_spread(flight.launch, flying, drag_scatter=USUAL.drag(park), spin_scatter=0.0)
    if spread:
        plain = replace(plain, carry_spread=spread, carry_half=REACH * spread)
    if park is None:
        return plain
    through = replace(flying, aerodynamics=question.outdoors or flying.aerodynamics)
    chances = home_run_chances(flight.launch, through, parks=(park,), own_elevation=False).chance
    return replace(plain, home_run_chance=float(chances[0, 0]))

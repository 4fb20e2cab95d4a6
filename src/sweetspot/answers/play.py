"""One pitch hit: how the bat meets it, how the ball leaves, how far it flies, and whether it is out."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated

import numpy as np

from sweetspot.analysis.full_play import Play, play
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.flight import (
    DRAG,
    BallLeaving,
    FlightEnd,
    FlightNumbers,
    ball_leaving,
    drag_source,
    flight_columns,
    flight_end,
    flight_numbers,
    launch_columns,
    spin_columns,
    written_errors,
)
from sweetspot.answers.records import (
    INTERNAL,
    Angle,
    Distance,
    Force,
    Length,
    Ratio,
    Speed,
    Spin,
    Time,
)
from sweetspot.answers.setups import SwungWith
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.collision.oblique_contact import contact_frame
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.carry_scatter import carry_spread
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import SPIN_MEASURED, USUAL, home_run_chances
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import FlightOutcome
from sweetspot.motion.ball_motion import BallMotion, BallMotions
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath, Swings
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.uncertainty.drawn_hits import draws_of
from sweetspot.uncertainty.sources import DRAWS, BallErrors, Sources, errors_by_ball


@dataclass(frozen=True)
class PlayQuestion:
    """One play that is asked for; see `sweetspot.analysis.full_play.play`.

    Parameters
    ----------
    reduced : the bat, with what the hands do to it.
    conditions : of the hit; the pitch is as fast as ``pitch`` says.
    flying : what the ball flies through.
    pitch : the ball where the bat meets it.
    contact : where they meet.
    park : whose fence counts; None: none does.
    outdoors : the ball's law in the open, from which the scatter of chances goes on; None: that of ``flying``.
    sources : what is not known, see `play_sources`; None: only what the ball leaves to the exit speed.
    draws : how many answers the intervals come from, a power of two.
    """

    reduced: ReducedBat[Bat]
    conditions: Conditions
    flying: FlightConditions
    path: SwingPath
    pitch: BallMotion
    contact: Contact
    park: Park | None = None
    outdoors: Aerodynamics | None = None
    sources: Sources | None = None
    draws: int = DRAWS

    @property
    def hit_conditions(self) -> Conditions:
        """The conditions with the pitch as fast as it is where the bat meets it."""
        return self.conditions.replaced(pitch=self.conditions.pitch.replaced(speed=self.pitch.speed))


PLACE, OFFSET = "place along the bat", "bat under the ball"


def play_sources(of_hit: Sources, law: Aerodynamics, *, place_error: float = 0.0, offset_error: float = 0.0) -> Sources:
    """Return the unknowns of a play.

    ``of_hit``: of bat, ball and speeds, see `sources_of`. ``law``: of the ball's drag. ``place_error``,
    ``offset_error``: one standard deviation in m of where bat and ball meet; 0: exactly as given.
    """
    sources = of_hit.with_source(drag_source(law))
    for error in written_errors({PLACE: place_error, OFFSET: offset_error}):
        sources = sources.with_source(error)
    return sources


def drawn_play(asked: PlayQuestion, sources: Sources) -> DrawnAnswer:
    """Return the sampled answers to a play.

    ``sources``: see `play_sources`.
    """
    reduced, conditions, pitch = asked.reduced, asked.hit_conditions, asked.pitch
    draws = draws_of(reduced.beam, conditions, sources, count=asked.draws)
    off = sources.deviations(draws.normal)
    off[0] = 0.0
    place, offset = (
        float(np.asarray(value)) + sources.of(name, off)
        for value, name in zip(asked.contact, (PLACE, OFFSET), strict=True)
    )
    place = np.clip(place, conditions.hands.position, reduced.bat.length)
    faster = draws.pitch_speed / draws.pitch_speed[0] if draws.pitch_speed[0] > 0 else np.ones(len(draws))
    swing, thrown = conditions.swing, faster[:, None] * np.asarray(pitch.velocity)
    speed = draws.bat_speed * (place - swing.pivot) / (swing.measured_at - swing.pivot)
    axes = asked.path.axes
    rebound = strikes(
        reduced,
        ball=conditions.ball,
        swings=Swings(speed, axes, swing.pivot),
        pitches=BallMotions(velocity=thrown, spin=np.asarray(pitch.spin), position=np.asarray(pitch.position)),
        contact=Contact(place, offset),
    )
    closing = np.nan_to_num(rebound.closing_speed, nan=1.0)[:, None]
    efficiency = draws.struck(place[:, None], closing).collision_efficiency[:, 0]
    reach = conditions.ball.radius + reduced.bat.diameter_at(place) / 2
    normal = contact_frame(*axes, lift=np.arcsin(np.clip(offset / reach, -1.0, 1.0))).normal
    more = (efficiency - rebound.collision_efficiency) * rebound.closing_speed
    velocity = rebound.velocity + more[:, None] * np.asarray(normal)
    left = BallMotions(velocity=velocity, spin=rebound.spin, position=np.asarray(pitch.position))
    contact = {
        "position": place,
        "offset": offset,
        "bat_speed": speed,
        "pitch_speed": draws.pitch_speed,
        "closing_speed": rebound.closing_speed,
        "collision_efficiency": efficiency,
        **launch_columns(velocity),
        **spin_columns(velocity, rebound.spin),
    }
    return DrawnAnswer(draws.normal, {**contact, "flight": flight_columns(left, asked.flying, sources.of(DRAG, off))})


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
    exit_speed_half_by_ball : half of the interval in which the exit speeds of single balls of a kind scatter; None: not
        known, or part of the interval that stands there.
    exit_speed_half_by_kind : the same for what is not known of all of them alike, their mean and their law.
    home_run_chance : in the park, with the scatter of balls and weather; its interval by what is not known of all balls
        alike.
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
    exit_speed_half_by_kind: Speed | None = None
    home_run_chance: Ratio | None = None
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
    errors = errors_by_ball(question.reduced, conditions, float(plain.position))
    plain = _with_ending(plain, errors)
    if sources is None:  # which have the ball among them
        return plain if errors is None else _with_halves(plain, errors)
    drawn = drawn_play(question, sources)
    return with_draws(plain, drawn, sources, of="flight.carry")


def _with_halves(plain: PlayAnswer, errors: BallErrors) -> PlayAnswer:
    """Return a play with what the ball alone leaves to its exit speed."""
    return replace(plain, exit_speed_half_by_ball=REACH * errors.scatter, exit_speed_half_by_kind=REACH * errors.common)


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


def _with_ending(plain: PlayAnswer, errors: BallErrors | None) -> PlayAnswer:
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
    return replace(plain, home_run_chance=_home_run_chance(flight.launch, through, park, errors))


BALLS = 7
"""Nodes of the quadrature over the exit speeds of single balls."""


def _home_run_chance(launch: BallMotion, through: FlightConditions, park: Park, errors: BallErrors | None) -> Ratio:
    """Return the chance of a home run in a park of balls that are hit alike, each with its own exit speed.

    Its interval is that chance with all balls at either end of what is not known of their kind (90 %).
    """
    chances_of = partial(
        home_run_chances, conditions=through, parks=(park,), own_elevation=False, scatter=SPIN_MEASURED
    )
    if errors is None:
        return float(chances_of(launch).chance[0, 0])
    nodes, weights = np.polynomial.hermite_e.hermegauss(BALLS)
    common = REACH * errors.common * np.array([0.0, -1.0, 1.0])
    faster = 1 + (common[:, None] + errors.scatter * nodes) / launch.speed
    balls = BallMotions(
        velocity=faster.reshape(-1, 1) * np.asarray(launch.velocity),
        spin=np.asarray(launch.spin),
        position=np.asarray(launch.position),
    )
    chances = chances_of(balls).chance.reshape(faster.shape)
    value, *ends = (chances @ weights / weights.sum()).tolist()
    return Interval(value, min(value, *ends), max(value, *ends))

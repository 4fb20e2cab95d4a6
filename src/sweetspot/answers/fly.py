"""One batted ball: its flight in a park's air, its fence, the nets and lines of other sports, and other parks."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

from sweetspot import catalog
from sweetspot.answers.flight import (
    FlightAnswer,
    FlightEnd,
    FlightQuestion,
    ball_leaving,
    carry_from_the_hit,
    flight_end,
    flight_numbers,
    flight_with_intervals,
)
from sweetspot.answers.records import INTERNAL, Distance, Length
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import Sport
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.carry_scatter import carry_spread
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.court_marks import passages
from sweetspot.flight.home_runs import SPIN_MEASURED, USUAL, home_run_chances, is_likely
from sweetspot.flight.park import Park
from sweetspot.flight.sweep import BattedBall, directed
from sweetspot.flight.trajectory import Flight, FlightOutcome, fly
from sweetspot.numerics.interval import REACH
from sweetspot.uncertainty.sources import DRAWS, Sources
from sweetspot.units.dimensions import DENSITY

BALLPARKS = ("baseball", "softball", "slow-pitch", "youth-baseball")
"""Sports whose field has a home plate and a centre field."""


@dataclass(frozen=True)
class FlyQuestion:
    """A batted ball that is asked for.

    Parameters
    ----------
    aerodynamics : of the ball in the open; under a roof that never opens `catalog.aerodynamics_in` holds.
    park : where it is hit; its fence counts, and the hit is tried in every other park too.
    own_elevation : whether the other parks lie at their own elevation, or all where the hit says.
    sources : what is not known, see `flight_sources`; None: no intervals are asked for.
    draws : how many answers the intervals come from, a power of two.
    """

    hit: BattedBall
    ball: Ball
    sport: Sport
    aerodynamics: Aerodynamics
    park: Park | None = None
    own_elevation: bool = True
    sources: Sources | None = None
    draws: int = DRAWS


@dataclass(frozen=True)
class PassedMark:
    """A flight at a net, line or boundary; see `Passage` and `sweetspot.equipment.sport.Mark`.

    ``height``: of the mark; None: a line. ``ball_height``: nan where the ball landed before.
    """

    name: str
    side: str
    distance: Distance
    height: Length | None
    ball_height: Length
    margin: Distance
    good: bool


@dataclass(frozen=True)
class Court:
    """A flight at every mark of its sport; at none where it did not land."""

    sport: str
    marks: tuple[PassedMark, ...]


@dataclass(frozen=True, kw_only=True)
class FlyAnswer(FlightAnswer):
    """A batted ball's flight; where there is no home plate the carry counts from where it was hit.

    Parameters
    ----------
    hit : with the direction in which it leaves.
    carry_spread, carry_half : standard deviation of the carry of balls hit alike, and half of its interval.
    out_in, parks : in how many of how many parks it is likelier a home run than not.
    home_run_chance, expected_out_in : in the park, and in how many parks on average, with the scatter of balls, spin
        and weather.
    court : None: baseball.
    """

    question: Annotated[FlyQuestion, INTERNAL]
    hit: Annotated[BattedBall, INTERNAL]
    air_density: Annotated[float, DENSITY]
    carry_spread: Distance | None = None
    carry_half: Distance | None = None
    fence: FlightEnd | None = None
    out_in: int | None = None
    parks: int | None = None
    home_run_chance: float | None = None
    expected_out_in: float | None = None
    court: Court | None = None


def fly_answer(question: FlyQuestion) -> FlyAnswer:
    """Return the flight of a batted ball.

    Raises
    ------
    InputError
        for a hit or air that cannot be, or one that no launch direction brings down at its bearing.
    """
    ball, sport, law = question.ball, question.sport, catalog.aerodynamics_in(question.park, question.aerodynamics)
    hit = directed(question.hit, ball=ball, aerodynamics=law)
    conditions = FlightConditions(ball=ball, aerodynamics=law, air=hit.air, wind=hit.wind)
    flight = fly(hit.motion, conditions)
    landed, numbers = flight.outcome is FlightOutcome.LANDED, flight_numbers(flight)
    if landed and sport.key not in BALLPARKS:
        numbers = replace(numbers, carry=carry_from_the_hit(flight))
    spread = _spread(hit, conditions, question.park) if landed and sport.key == "baseball" else 0.0
    plain = FlyAnswer(
        **vars(numbers),
        question=question,
        hit=hit,
        launch=replace(ball_leaving(hit.motion), launch_angle=hit.launch_angle, spray=hit.spray),
        air_density=hit.air.density,
        carry_spread=spread or None,
        carry_half=REACH * spread or None,
        court=None if sport.key == "baseball" else court_of(flight, sport, ball=ball),
    )
    if landed and question.park is not None:
        plain = _in_parks(plain, question.park)
    asked = FlightQuestion(flight.launch, conditions, question.sources, question.draws)
    return flight_with_intervals(plain, asked)


def _spread(hit: BattedBall, conditions: FlightConditions, park: Park | None) -> float:
    """Return the scatter in carry of balls hit alike: m, one standard deviation; 0 where it is unknown."""
    scatter = {} if hit.backspin is None else {"spin_scatter": 0.0}  # a measured spin is no other than it is
    return carry_spread(hit.motion, conditions, drag_scatter=USUAL.drag(park), **scatter)


def _in_parks(plain: FlyAnswer, park: Park) -> FlyAnswer:
    """Return an answer with where the flight ends in its park, and the same ball's chances there and everywhere."""
    question, hit, parks = plain.question, plain.hit, catalog.parks()
    # the scatter of chances knows of roofs
    outdoors = FlightConditions(ball=question.ball, aerodynamics=question.aerodynamics, air=hit.air, wind=hit.wind)
    elevation, scatter = question.own_elevation, USUAL if hit.backspin is None else SPIN_MEASURED
    found = (
        home_run_chances(hit.motion, outdoors, parks=(each,), own_elevation=elevation, scatter=scatter)
        for each in (park, *parks)
    )
    here, *everywhere = [float(chances.chance[0, 0]) for chances in found]
    return replace(
        plain,
        fence=flight_end(plain.flight, park),
        out_in=sum(map(is_likely, everywhere)),
        parks=len(parks),
        home_run_chance=here,
        expected_out_in=sum(everywhere),
    )


def court_of(flight: Flight, sport: Sport, *, ball: Ball) -> Court:
    """Return a flight at every mark of its sport."""
    passed = passages(flight, sport.marks, ball=ball) if flight.outcome is FlightOutcome.LANDED else ()
    marks = tuple(
        PassedMark(
            name=each.mark.name,
            side=each.mark.side,
            distance=each.mark.distance.value,
            height=each.mark.height.value if each.mark.height else None,
            ball_height=each.ball_height,
            margin=each.margin,
            good=each.good,
        )
        for each in passed
    )
    return Court(sport.key, marks)

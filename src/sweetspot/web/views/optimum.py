"""The best way to hit: how to swing at a pitch, how high to send a ball, and the slowest home run of every park."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from pydantic import Field

from sweetspot import catalog
from sweetspot.analysis.optimum import best_launch
from sweetspot.answers.optimum import LaunchSearch, OptimumQuestion, ParkSearch, SwingSearch, optimum_answer
from sweetspot.answers.records import Angle, Distance, Speed
from sweetspot.catalog.sports import pitched_aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.pitch import PitchFlight, aimed
from sweetspot.motion.ball_motion import USUAL_CONTACT, batted_ball
from sweetspot.reports.optimum import optimum_document
from sweetspot.reports.page_words import carries_farthest, park_chances
from sweetspot.units import MPH, RPM
from sweetspot.web.bats import ball_of, bought_ball, conditions_of, described, reduced, swung
from sweetspot.web.controls import Name, SwungState, Tilt, within
from sweetspot.web.documents import ReadDocument, Sentences, in_both_systems, page_document
from sweetspot.web.drawings import BallPicture, BatPicture, ball_picture, bat_picture
from sweetspot.web.errors import about
from sweetspot.web.recipes import Ask, ball_source, bat_source, bat_text, options_of, stroke_options
from sweetspot.web.view import View
from sweetspot.web.views.flight_parks import CarryMap, carries, parks_of


class OptimumState(SwungState):
    """The bat, how fast it is swung, and the pitch it meets."""

    pitch: Name | None = Field(
        None, description="kind of pitch, by name or letters; empty: what is mostly thrown at such a bat"
    )
    tilt_deg: Tilt = Field(32.0, description="of the swing's plane")
    exit_speed_mph: Annotated[float, within("exit_speed", "mph")] = Field(
        100.0, description="for the best launch angle"
    )
    backspin_rpm: Annotated[float, within("backspin", "rpm", least=-1000, most=5000)] = Field(
        2200.0, description="of the ball in the last two questions"
    )
    park: Name | None = Field(None, description="name, team or its letters; empty: where such bats are swung")


@dataclass(frozen=True)
class LaunchThatCarries:
    """The launch angle at which a ball so fast carries farthest."""

    exit_speed: Speed
    launch_angle: Angle
    carry: Distance


@dataclass(frozen=True, kw_only=True)
class LaunchAnswer:
    """The best launch angle of an exit speed, and carries around it."""

    bat: BatPicture
    ball: BallPicture
    launch: LaunchThatCarries
    map: CarryMap
    park: str
    words: Sentences
    chances: Sentences


def answer(state: OptimumState) -> LaunchAnswer:
    """Return the best launch angle of an exit speed, and carries around it."""
    state = swung(state)
    through, spin = _through(state), state.backspin_rpm * RPM
    with about("pitch"):
        catalog.delivery(state.pitch or "")
    speed = state.exit_speed_mph * MPH
    best = best_launch(speed, through, backspin=spin)
    with about("park"):
        park = catalog.park(state.park or "")
    ball = batted_ball(speed=speed, launch_angle=best.launch_angle, backspin=spin, position=USUAL_CONTACT)
    reduced_bat = reduced(state, ball_of(state))
    return LaunchAnswer(
        bat=bat_picture(state, reduced_bat),
        ball=ball_picture(state, through.ball),
        launch=LaunchThatCarries(speed, best.launch_angle, best.carry),
        map=carries(ball, conditions=through, park=park, own_elevation=True),
        park=park.name,
        words=in_both_systems([carries_farthest(speed, best.launch_angle, best.carry)]),
        chances=in_both_systems([park_chances(park.name)]),
    )


def swing(state: OptimumState) -> ReadDocument:
    """Return the swing at a pitch for the longest carry, as a document."""
    state = swung(state)
    reduced_bat = reduced(state, ball_of(state))
    conditions, through = conditions_of(state, reduced_bat.bat), _through(state)
    thrown = _thrown(state, through)
    search = SwingSearch(
        reduced_bat.held(conditions.hands), conditions, through, (thrown,), tilt=math.radians(state.tilt_deg)
    )
    launch = LaunchSearch(through, (state.exit_speed_mph * MPH,), state.backspin_rpm * RPM)
    with about("tilt_deg"):
        found = optimum_answer(OptimumQuestion(reduced_bat.bat, search, launch))
    return page_document(optimum_document(found))


def parks(state: OptimumState) -> ReadDocument:
    """Return the slowest home run of every park, each in its own air, as a document."""
    state = swung(state)
    bat, ball = reduced(state, ball_of(state)).bat, bought_ball(state)
    outdoors = FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics_of_ball(ball), air=Air())
    there = tuple((park, catalog.conditions_in(park, outdoors)) for park in parks_of(bat))
    question = OptimumQuestion(bat, park=ParkSearch(there, state.backspin_rpm * RPM))
    return page_document(optimum_document(optimum_answer(question)))


def _through(state: OptimumState) -> FlightConditions:
    ball = ball_of(state)
    return FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics_of_ball(ball), air=Air())


def _thrown(state: OptimumState, through: FlightConditions) -> PitchFlight:
    with about("pitch"):
        delivery, law = catalog.delivery(state.pitch or ""), pitched_aerodynamics(state.pitch or "")
    return aimed(delivery, ball=through.ball, aerodynamics=law, air=through.one_air, wind=through.one_wind)


def recipe(state: OptimumState) -> dict[str, str]:
    """Return the command line that gives the same answers, one more for each further field, and the bat's file."""
    state = swung(state)
    first, *more = catalog.sport(described(state).sport).fields or ("all",)
    name, sent = (bat_source(state),), options_of(state, "backspin_rpm")
    swing = options_of(state, "pitch", "tilt_deg") | stroke_options(state)
    options = swing | options_of(state, "exit_speed_mph") | sent | {"park": first}
    others = [
        Ask("optimum", name, {"show": "parks", "ball": ball_source(state), **sent, "park": park}) for park in more
    ]
    lines = [ask.command for ask in (Ask("optimum", name, options), *others)]
    return {"command": "\n".join(lines), "toml": bat_text(state)}


VIEW = View("optimum", "Best swing", OptimumState, answer, recipe, asides={"swing": swing, "parks": parks})

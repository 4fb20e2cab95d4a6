"""Questions about a ball in the air as plain functions: what differs from the sport's usual in, a typed answer out.

The command line and the public functions of the same names (`sweetspot.play`, ...) both ask here.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Literal

from sweetspot import catalog
from sweetspot.answers.flight_setups import (
    FAIR_WEATHER,
    LaunchSetup,
    PitchSetup,
    SearchSetup,
    SentSetup,
    Weather,
    thrown,
)
from sweetspot.answers.setups import (
    AS_USUAL,
    ContactSetup,
    HitSetup,
    PathSetup,
    check_beyond_hands,
    error_of,
    round_bat,
    value_of,
)
from sweetspot.catalog.implements import Loaded
from sweetspot.collision.hit_in_space import Contact
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.units import MPH

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from sweetspot.answers.fly import FlyAnswer
    from sweetspot.answers.optimum import OptimumAnswer, ParkSearch, SwingSearch
    from sweetspot.answers.play import PlayAnswer
    from sweetspot.answers.what_if import FlightCell, FlyTableAnswer
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.motion.swing import Conditions

EVERY_PARK = "all"
SPEEDS, SLOWER = (90, 100, 110), (60, 70, 80)
"""mph, exit speeds that are asked for: where bats are swung at 65 mph and more, and where slower."""
FAST_SWING = 29.0
"""m/s."""
Searched = Literal["swing", "launch", "parks"]


def play(
    bat: Loaded,
    *,
    contact: ContactSetup = ContactSetup(),
    setup: HitSetup = AS_USUAL,
    path: PathSetup = PathSetup(),
    arrival: PitchSetup = PitchSetup(),
    weather: Weather = FAIR_WEATHER,
    uncertainty: bool = False,
) -> PlayAnswer:
    """Follow one pitch: how the bat meets it, how the ball leaves, how far it flies and whether it is out.

    Parameters
    ----------
    bat : a round bat, its name in the catalogue, or its file.
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        for a place that is not on the bat, a contact below the ground, or a pitch that was given twice.

    >>> import sweetspot
    >>> round(sweetspot.play("r161-ash", park="fenway").flight.carry)  # m
    114
    """
    from sweetspot.analysis.bat_analysis import check_conditions
    from sweetspot.answers.play import PlayQuestion, play_answer, play_sources
    from sweetspot.dynamics.reduction import reduced_bat

    described = round_bat(bat)
    if arrival.pitch is not None and setup.pitch_speed is not None:
        raise InputError("pitch and pitch_speed were both given; give release_speed for a pitch by name")
    conditions, swung_with = setup.swung(described)
    model = reduced_bat(described, ball=conditions.ball).held(conditions.hands)
    check_conditions(model, conditions)
    place = contact.position(described, conditions)
    check_beyond_hands(place, conditions.hands.position)
    ball = setup.ball or catalog.sport(described.sport).balls[0]
    flying = replace(weather.through(ball), ball=conditions.ball)
    sources = None
    if uncertainty:
        sources = play_sources(
            setup.sources(bat, conditions),
            flying.aerodynamics,
            place_error=0.0 if isinstance(contact.at, str) else error_of(contact.at),
            offset_error=error_of(contact.offset),
        )
    question = PlayQuestion(
        model,
        conditions,
        flying,
        path=path.path,
        pitch=arrival.at_plate(conditions.pitch.speed, flying),
        contact=Contact(place, value_of(contact.offset)),
        park=weather.field,
        outdoors=catalog.aerodynamics_of_ball(ball),
        sources=sources,
    )
    return replace(play_answer(question), swung_with=swung_with)


def fly(
    *, launch: LaunchSetup = LaunchSetup(), weather: Weather = FAIR_WEATHER, uncertainty: bool = False
) -> FlyAnswer:
    """Compute the flight of a hit ball: its carry, the park's fence, and the nets and lines of other sports.

    Parameters
    ----------
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        for a hit or air that cannot be, or one that no launch direction brings down at its bearing.

    >>> import sweetspot
    >>> round(sweetspot.fly(exit_speed="103 mph", launch_angle="28 deg").carry)  # m
    121
    """
    from sweetspot.answers.flight import flight_sources
    from sweetspot.answers.fly import FlyQuestion, fly_answer

    law, park = launch.aerodynamics, weather.field
    sources = None
    if uncertainty:
        sources = flight_sources(
            catalog.aerodynamics_in(park, law),
            speed_error=error_of(launch.exit_speed),
            angle_error=error_of(launch.launch_angle),
        )
    question = FlyQuestion(
        launch.hit(weather),
        ball=catalog.ball(launch.ball),
        sport=catalog.sport(catalog.ball_sport(launch.ball)),
        aerodynamics=law,
        park=park,
        own_elevation=weather.elevation is None,
        sources=sources,
    )
    return fly_answer(question)


def fly_table(
    vary: Mapping[str, ArrayLike],
    *,
    launch: LaunchSetup = LaunchSetup(),
    weather: Weather = FAIR_WEATHER,
    show: FlightCell = "carry",
) -> FlyTableAnswer:
    """Compute a table of flights of a hit ball: one or two of its numbers are varied, every cell has every answer.

    Parameters
    ----------
    vary : values by what they are of, down the table's side and across: exit_speed, launch_angle, spray, bearing,
        backspin, sidespin, gyrospin, height, or temperature, humidity, pressure, elevation, wind_speed, wind_direction.
    show : the answer that is printed: "carry", "hang_time", "apex", "landing_angle" or "landing_speed".

    Raises
    ------
    InputError
        for numbers that no hit or air can have in any cell, or anything else to be varied.

    >>> import sweetspot
    >>> table = sweetspot.fly_table({"exit_speed": ["90 mph", "100 mph"], "launch_angle": ["20 deg", "28 deg"]})
    >>> table.answers.carry.round()  # m
    array([[ 93., 103.],
           [108., 117.]])
    """
    from sweetspot.answers.what_if import FlyTableQuestion, fly_table_answer, two_sides

    rows, *columns = two_sides(vary)
    question = FlyTableQuestion(
        hit=launch.hit(weather),
        rows=rows,
        columns=columns[0] if columns else None,
        ball=catalog.ball(launch.ball),
        aerodynamics=catalog.aerodynamics_in(weather.field, launch.aerodynamics),
        cell=show,
    )
    return fly_table_answer(question)


def optimum(
    bat: Loaded,
    *,
    search: SearchSetup = SearchSetup(),
    sent: SentSetup = SentSetup(),
    setup: HitSetup = AS_USUAL,
    weather: Weather = FAIR_WEATHER,
    show: Sequence[Searched] = ("swing", "launch"),
    uncertainty: bool = False,
) -> OptimumAnswer:
    """Find the swing and the launch angle that carry farthest, and the slowest home run of parks.

    Parameters
    ----------
    bat : a round bat, its name in the catalogue, or its file.
    show : which of the three is searched: "swing", "launch", "parks", the last in the weather's park, or in every one.
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        where no contact makes the ball fly, or no ball leaves a park.

    >>> import sweetspot
    >>> far = sweetspot.optimum("r161-ash", show=["launch"], exit_speed=["100 mph"])
    >>> round(far.launches[0].carry)  # m
    119
    """
    from sweetspot.answers.flight import drag_source
    from sweetspot.answers.optimum import LaunchSearch, OptimumQuestion, optimum_answer
    from sweetspot.uncertainty.sources import NOTHING

    described = round_bat(bat)
    ball = setup.ball or catalog.sport(described.sport).balls[0]
    sources, swing, swung_with = NOTHING, None, None
    in_the_open = replace(weather, park=None) if weather.park == EVERY_PARK else weather
    if "swing" in show:
        conditions, swung_with = setup.swung(described)
        swing = _swing_search(described, search, conditions, replace(in_the_open.through(ball), ball=conditions.ball))
        sources = setup.sources(bat, conditions) if uncertainty else NOTHING
    flying = in_the_open.through(ball)
    question = OptimumQuestion(
        described,
        swing=swing,
        launch=LaunchSearch(flying, _speeds(described, sent), sent.backspin) if "launch" in show else None,
        park=_park_search(weather, flying, sent.backspin) if "parks" in show else None,
        sources=sources.with_source(drag_source(flying.aerodynamics)) if uncertainty else None,
    )
    return replace(optimum_answer(question), swung_with=swung_with)


def _swing_search(bat: Bat, search: SearchSetup, conditions: Conditions, flying: FlightConditions) -> SwingSearch:
    from sweetspot.analysis.optimum import Held
    from sweetspot.answers.optimum import SwingSearch
    from sweetspot.dynamics.reduction import reduced_bat

    if search.at is not None:
        bat.check_position(search.at, "at")
    names = search.pitch or catalog.sport(bat.sport).pitches
    return SwingSearch(
        reduced_bat(bat, ball=conditions.ball).held(conditions.hands),
        conditions,
        flying,
        pitches=tuple(thrown(name, flying, release_speed=search.release_speed) for name in names),
        tilt=search.tilt,
        held=Held(position=search.at, attack_angle=search.attack_angle),
    )


def _speeds(bat: Bat, sent: SentSetup) -> tuple[float, ...]:
    fast = catalog.sport(bat.sport).stroke.swing_speed.value > FAST_SWING
    return sent.exit_speed or tuple(speed * MPH for speed in (SPEEDS if fast else SLOWER))


def _park_search(weather: Weather, flying: FlightConditions, backspin: float) -> ParkSearch:
    """Return every park that is asked for, and what is flown through there."""
    from sweetspot.answers.optimum import ParkSearch

    if flying.one_wind.speed > 0:
        raise InputError(
            "the slowest home run of a park is found in still air only; leave out the wind, or ask for the best swing "
            "or launch alone"
        )
    everywhere = weather.park in (None, EVERY_PARK)
    parks = list(catalog.parks()) if everywhere else [catalog.park(weather.park)]
    at_parks = everywhere and weather.elevation is None
    return ParkSearch(
        tuple((park, catalog.conditions_in(park, flying, own_elevation=at_parks)) for park in parks), backspin
    )

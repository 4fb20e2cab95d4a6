"""One flight with everything that was put in, as a document."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from sweetspot import catalog
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import Sport
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import Landing, landing
from sweetspot.flight.hit_alike import carry_spread
from sweetspot.flight.home_runs import USUAL as SCATTER
from sweetspot.flight.home_runs import home_run_chances, is_likely
from sweetspot.flight.park import Park
from sweetspot.flight.sweep import BattedBall, directed
from sweetspot.flight.trajectory import Flight, FlightOutcome, fly
from sweetspot.report.document import Document, Paragraph, Picture
from sweetspot.report.flight.court import court_json, court_words
from sweetspot.report.flight.words import (
    alike_words,
    direction_words,
    flight_json,
    flight_words,
    from_the_hit,
    landing_json,
    landing_words,
    launch_words,
    path_columns,
    spread_json,
    wind_words,
)
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import Reader, reader
from sweetspot.report.sentences import Sentence, Slot, Words, joined, say
from sweetspot.units import DEGREE

BALLPARKS = ("baseball", "softball", "slow-pitch", "youth-baseball")
"""Sports whose field has a home plate and a centre field."""


@dataclass(frozen=True)
class BattedFlight:
    """A flight, and where it ends in a park if one was named.

    Parameters
    ----------
    out_in, parks : in how many of how many parks it is likelier a home run than not; 0 of 0 without a
        park.
    chance, expected_out_in : of a home run in the park, and in how many parks on average, with the scatter of balls,
        spin and weather.
    spread : m, standard deviation of the carry of balls hit alike; 0 where it is not known.
    """

    hit: BattedBall
    flight: Flight
    ball: Ball
    sport: Sport
    park: Park | None = None
    landing: Landing | None = None
    out_in: int = 0
    parks: int = 0
    chance: float = 0.0
    expected_out_in: float = 0.0
    spread: float = 0.0


def batted_flight(
    hit: BattedBall,
    *,
    ball: Ball,
    sport: Sport,
    aerodynamics: Aerodynamics,
    park: Park | None,
    own_elevation: bool = True,
) -> BattedFlight:
    """Return the flight of a hit.

    Parameters
    ----------
    aerodynamics : of the ball in the open; under a roof that never opens `catalog.aerodynamics_in` holds.
    park : where it is hit; its fence counts, and the hit is tried in every other park too.
    own_elevation : whether the other parks lie at their own elevation, or all where the hit says.
    """
    law = catalog.aerodynamics_in(park, aerodynamics)
    hit = directed(hit, ball=ball, aerodynamics=law)
    outdoors = FlightConditions(ball=ball, aerodynamics=aerodynamics, air=hit.air, wind=hit.wind)
    conditions = replace(outdoors, aerodynamics=law)
    flight = fly(hit.motion, conditions)
    landed = flight.outcome is FlightOutcome.LANDED and sport.key == "baseball"
    spread = 0.0
    if landed:
        measured = hit.backspin is not None  # then it is no other than it is
        known = {"spin_scatter": 0.0} if measured else {}
        spread = carry_spread(hit.motion, conditions, drag_scatter=SCATTER.drag(park), **known)
    flown = BattedFlight(hit, flight, ball, sport, spread=spread)
    if park is None or flight.outcome is not FlightOutcome.LANDED:
        return flown
    motion, parks = hit.motion, catalog.parks()
    chances = [  # each in its own air; their scatter knows of roofs
        float(home_run_chances(motion, outdoors, parks=(one,), own_elevation=own_elevation).chance[0, 0])
        for one in (park, *parks)
    ]
    return replace(
        flown, park=park, landing=landing(flight.positions, park), parks=len(parks),
        out_in=sum(map(is_likely, chances[1:])), chance=chances[0], expected_out_in=sum(chances[1:]),
    )  # fmt: skip


def batted_document(flown: BattedFlight) -> Document:
    """Return a batted ball's flight as a document."""
    picture = _picture(flown.flight, flown.park, ballpark=flown.sport.key in BALLPARKS, note=_note(flown))
    return Document(
        name="fly", title="", kind="Flight",
        blocks=[
            Paragraph(_words(flown)),
            picture,
            Paragraph(_weather(flown), "note"),
        ],
        data=_json(flown), rows=path_columns(flown.flight), reader=reader(None, flown.sport.words),
        drawing=picture,
    )  # fmt: skip


def flight_document(flight: Flight) -> Document:
    """Return any flight as a document."""
    words = say("A ball leaves {launch}.", launch=launch_words(flight.launch))
    return Document(
        name="flight", title="", kind="Flight",
        blocks=[
            Paragraph(joined([words, flight_words(flight, at=""), _bend(flight, windy=True)])), _picture(flight, None),
        ],
        data=flight_json(flight), rows=path_columns(flight), drawing=_picture(flight, None),
    )  # fmt: skip


def _json(flown: BattedFlight) -> dict[str, Any]:
    launch = flown.flight.launch
    answer = {
        "launch": {
            "exit_speed_m_s": launch.speed,
            "launch_angle_rad": flown.hit.launch_angle,
            "spray_rad": flown.hit.spray,
            "backspin_rad_s": launch.backspin,
            "sidespin_rad_s": launch.sidespin,
            "gyrospin_rad_s": launch.gyrospin,
            "height_m": float(launch.position[2]),
        },
        "air_density_kg_m3": flown.hit.air.density,
        **flight_json(flown.flight),
    }
    if flown.sport.key not in BALLPARKS and flown.flight.outcome is FlightOutcome.LANDED:
        answer["carry_m"] = from_the_hit(flown.flight)
    answer |= spread_json(flown.spread)
    if flown.park is not None and flown.landing is not None:
        answer["fence"] = landing_json(flown.landing, flown.park)
        answer["out_in"], answer["parks"] = flown.out_in, flown.parks
        answer["home_run_chance"], answer["expected_out_in"] = flown.chance, flown.expected_out_in
    if flown.sport.key != "baseball":
        answer["court"] = court_json(flown.flight, flown.sport, ball=flown.ball)
    return cleaned(answer)


def _words(flown: BattedFlight) -> Sentence:
    hit = flown.hit
    usual = " (what such hits usually have)" if hit.backspin is None and hit.sidespin is None else ""
    at_plate = flown.sport.key in BALLPARKS
    launch = launch_words(flown.flight.launch, ballpark=at_plate)
    sentences = [say("A {ball} leaves {launch}{usual}.", ball=flown.sport.words.ball, launch=launch, usual=usual)]
    if flown.sport.key != "baseball":
        return joined([*sentences, court_words(flown.flight, flown.sport, ball=flown.ball, from_plate=at_plate)])
    sentences += [flight_words(flown.flight, at=""), _bend(flown.flight, windy=bool(flown.hit.wind_speed))]
    if flown.spread:
        sentences.append(alike_words(flown.spread, spin_known=flown.hit.backspin is not None))
    if flown.park is not None and flown.landing is not None:
        sentences.append(landing_words(flown.landing, flown.park, chance=flown.chance))
        sentences.append(
            say(
                "It is likelier than not a home run in {out} of {all} parks. Of a hundred like it "
                "{chance} are home runs here, and each in {expected} parks on average.",
                out=flown.out_in, all=flown.parks, chance=round(100 * flown.chance),
                expected=f"{flown.expected_out_in:.0f}",
            )
        )  # fmt: skip
    return joined(sentences)


def _bend(flight: Flight, *, windy: bool) -> Sentence:
    """Return where the ball comes down, if the air has bent its path by a degree or more."""
    bent = flight.bearing - flight.launch.spray
    if flight.outcome is not FlightOutcome.LANDED or abs(bent) < DEGREE:
        return Sentence(())
    return say(
        "Its spin {bend} it {angle} to the {side}: it lands {where}.",
        bend="and the wind bend" if windy else "bends",
        angle=Slot(abs(bent), "angle", digits=0), side="right" if bent > 0 else "left",
        where=direction_words(flight.bearing),
    )  # fmt: skip


def _weather(flown: BattedFlight) -> Sentence:
    hit = flown.hit
    roofed = flown.park is not None and flown.park.roof == "fixed"
    wind = say("still, under the roof" if roofed else "no wind")
    if hit.wind_speed:
        blowing = Slot(hit.wind_speed, "speed", digits=0)
        where = wind_words(hit.wind_direction, ballpark=flown.sport.key in BALLPARKS)
        wind = say("wind {speed} {where}", speed=blowing, where=where)
    return say(
        "Air {temperature}, {humidity} humid, {elevation} above the sea: {density}; {wind}.",
        temperature=Slot(hit.temperature, "temperature"), humidity=Slot(hit.humidity, "share"),
        elevation=Slot(hit.elevation, "elevation"), density=Slot(hit.air.density, "air_density", 4), wind=wind,
    )  # fmt: skip


def _note(flown: BattedFlight) -> Sentence:
    """Return the air and what came of the hit, for the head of its picture."""
    if flown.park is None or flown.landing is None:
        return _weather(flown)
    return joined([_weather(flown), landing_words(flown.landing, flown.park, chance=flown.chance)])


def _picture(flight: Flight, park: Park | None, *, ballpark: bool = True, note: Words = "") -> Picture:
    return Picture(
        "path", partial(_drawn, flight, park, ballpark, note),
        label="The path of the ball from the side and from above.",
        caption="A dot every second.",
    )  # fmt: skip


def _drawn(flight: Flight, park: Park | None, ballpark: bool, note: Words, reading: Reader) -> Any:
    from sweetspot.report.flight.picture import flight_figure

    return flight_figure(flight, park, reading, ballpark=ballpark, note=note)

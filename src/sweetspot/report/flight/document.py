"""One flight with everything that was put in, as a document."""

from __future__ import annotations

from functools import partial
from typing import Any

from sweetspot.answers.flight import FlightAnswer, FlightNumbers
from sweetspot.answers.fly import BALLPARKS, FlyAnswer
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.report.document import Block, Document, Paragraph, Picture
from sweetspot.report.flight.court import court_words
from sweetspot.report.flight.words import (
    alike_words,
    direction_words,
    fence_words,
    flight_words,
    launch_words,
    wind_words,
)
from sweetspot.report.quantities import Reader, reader
from sweetspot.report.sentences import Sentence, Slot, Words, joined, say
from sweetspot.report.uncertainty.uncertainty_section import how_sure
from sweetspot.units import DEGREE


def fly_document(answer: FlyAnswer) -> Document:
    """Return a batted ball's flight as a document."""
    question, data = answer.question, answer.to_dict()
    park = None if answer.fence is None else question.park
    picture = _picture(answer.flight, park, ballpark=question.sport.key in BALLPARKS, note=_note(answer))
    return Document(
        name="fly",
        title="",
        kind="Flight",
        blocks=[Paragraph(_words(answer)), picture, Paragraph(_weather(answer), "note"), *_how_sure(answer)],
        data=data,
        rows=data["path"],
        reader=reader(None, question.sport.words),
        drawing=picture,
    )


def flight_document(answer: FlightAnswer) -> Document:
    """Return any flight as a document."""
    words = say("A ball leaves {launch}.", launch=launch_words(answer.launch))
    picture, data = _picture(answer.flight, None), answer.to_dict()
    return Document(
        name="flight",
        title="",
        kind="Flight",
        blocks=[
            Paragraph(joined([words, flight_words(answer), _bend(answer, windy=True)])),
            picture,
            *_how_sure(answer),
        ],
        data=data,
        rows=data["path"],
        drawing=picture,
    )


def _how_sure(answer: FlightAnswer) -> list[Block]:
    return [] if answer.uncertainty is None else [how_sure(answer.uncertainty, "carry")]


def _words(answer: FlyAnswer) -> Sentence:
    hit, sport = answer.question.hit, answer.question.sport
    usual = " (what such hits usually have)" if hit.backspin is None and hit.sidespin is None else ""
    launch = launch_words(answer.launch, ballpark=sport.key in BALLPARKS)
    sentences = [say("A {ball} leaves {launch}{usual}.", ball=sport.words.ball, launch=launch, usual=usual)]
    if answer.court is not None:
        return joined([*sentences, court_words(answer, answer.court)])
    sentences += [flight_words(answer), _bend(answer, windy=bool(hit.wind_speed))]
    if answer.carry_half is not None:
        sentences.append(alike_words(answer.carry_half, spin_known=hit.backspin is not None))
    if answer.fence is not None and answer.home_run_chance is not None:
        sentences += [
            fence_words(answer.fence, chance=answer.home_run_chance),
            say(
                "It is likelier than not a home run in {out} of {all} parks. Of a hundred like it "
                "{chance} are home runs here, and each in {expected} parks on average.",
                out=str(answer.out_in),
                all=str(answer.parks),
                chance=round(100 * answer.home_run_chance),
                expected=f"{answer.expected_out_in:.0f}",
            ),
        ]
    return joined(sentences)


def _bend(flown: FlightNumbers, *, windy: bool) -> Sentence:
    """Return where the ball comes down, if the air has bent its path by a degree or more."""
    flight = flown.flight
    bent = flight.bearing - flight.launch.spray
    if flight.outcome is not FlightOutcome.LANDED or abs(bent) < DEGREE:
        return Sentence(())
    return say(
        "Its spin {bend} it {angle} to the {side}: it lands {where}.",
        bend="and the wind bend" if windy else "bends",
        angle=Slot(abs(bent), "angle", digits=0), side="right" if bent > 0 else "left",
        where=direction_words(flight.bearing),
    )  # fmt: skip


def _weather(answer: FlyAnswer) -> Sentence:
    hit, park = answer.hit, answer.question.park
    roofed = park is not None and park.roof == "fixed"
    wind = say("still, under the roof" if roofed else "no wind")
    if hit.wind_speed:
        blowing = Slot(hit.wind_speed, "speed", digits=0)
        where = wind_words(hit.wind_direction, ballpark=answer.question.sport.key in BALLPARKS)
        wind = say("wind {speed} {where}", speed=blowing, where=where)
    return say(
        "Air {temperature}, {humidity} humid, {elevation} above the sea: {density}; {wind}.",
        temperature=Slot(hit.temperature, "temperature"), humidity=Slot(hit.humidity, "share"),
        elevation=Slot(hit.elevation, "elevation"), density=Slot(hit.air.density, "air_density", 4), wind=wind,
    )  # fmt: skip


def _note(answer: FlyAnswer) -> Sentence:
    """Return the air and what came of the hit, for the head of its picture."""
    weather = _weather(answer)
    if answer.fence is None:
        return weather
    return joined([weather, fence_words(answer.fence, chance=answer.home_run_chance)])


def _picture(flight: Flight, park: Park | None, *, ballpark: bool = True, note: Words = "") -> Picture:
    return Picture(
        "path", partial(_drawn, flight, park, ballpark, note),
        label="The path of the ball from the side and from above.",
        caption="A dot every second.",
    )  # fmt: skip


def _drawn(flight: Flight, park: Park | None, ballpark: bool, note: Words, reading: Reader) -> Any:
    from sweetspot.report.flight.picture import flight_figure

    return flight_figure(flight, park, reading, ballpark=ballpark, note=note)

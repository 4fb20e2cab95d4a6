"""One flight with everything that was put in, as a document."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sweetspot.answers.flight import BallLeaving, FlightAnswer, FlightEnd, FlightNumbers
from sweetspot.answers.fly import BALLPARKS, Court, FlyAnswer
from sweetspot.flight.home_runs import is_likely
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.numerics.interval import Number
from sweetspot.reports.document import Block, Document, Paragraph, Picture, drawn
from sweetspot.reports.quantities import reader
from sweetspot.reports.sentences import Sentence, Slot, Words, joined, say
from sweetspot.reports.uncertainty import how_sure
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
    """Return the bend of a path and its landing direction, if the air bends it by a degree or more."""
    flight = flown.flight
    bent = flight.bearing - flight.launch.spray
    if flight.outcome is not FlightOutcome.LANDED or abs(bent) < DEGREE:
        return Sentence(())
    return say(
        "Its spin {bend} it {angle:angle, 0} to the {side}: it lands {where}.",
        bend="and the wind bend" if windy else "bends",
        angle=abs(bent),
        side="right" if bent > 0 else "left",
        where=direction_words(flight.bearing),
    )


def _weather(answer: FlyAnswer) -> Sentence:
    hit, park = answer.hit, answer.question.park
    roofed = park is not None and park.roof == "fixed"
    wind = say("still, under the roof" if roofed else "no wind")
    if hit.wind_speed:
        blowing = Slot(hit.wind_speed, "speed", digits=0)
        where = wind_words(hit.wind_direction, ballpark=answer.question.sport.key in BALLPARKS)
        wind = say("wind {speed} {where}", speed=blowing, where=where)
    return say(
        "Air {hit.temperature:temperature}, {hit.humidity:share} humid, {hit.elevation:elevation} above the sea: "
        "{hit.air.density:air_density, 4}; {wind}.",
        hit=hit,
        wind=wind,
    )


def _note(answer: FlyAnswer) -> Sentence:
    """Return the air and what came of the hit, for the head of its picture."""
    weather = _weather(answer)
    if answer.fence is None:
        return weather
    return joined([weather, fence_words(answer.fence, chance=answer.home_run_chance)])


def _picture(flight: Flight, park: Park | None, *, ballpark: bool = True, note: Words = "") -> Picture:
    return Picture(
        "path", drawn("sweetspot.reports.flight.picture:flight_figure", flight, park, ballpark=ballpark, note=note),
        label="The path of the ball from the side and from above.",
        caption="A dot every second.",
    )  # fmt: skip


def court_words(flown: FlightNumbers, court: Court) -> Sentence:
    """Return a flight and what it is on this sport's court or field, in sentences."""
    return joined([flight_words(flown), *_at_marks(court)])


def _at_marks(court: Court) -> Iterator[Sentence]:
    for mark in court.marks:
        margin = small_or_far(float(mark.margin))
        if mark.side == "before":
            side = "before" if mark.good else "beyond"
            yield say("It lands {margin} {side} the {name}.", margin=margin, side=side, name=mark.name)
        elif mark.good:
            yield say("It passes {margin} over the {name}.", margin=margin, name=mark.name)
        elif math.isnan(float(mark.ball_height)):
            yield say("It lands {margin} short of the {name}.", margin=margin, name=mark.name)
        else:
            yield say("It meets the {name} {margin} below its top.", margin=margin, name=mark.name)
            return  # beyond it there is another flight


NEAR = 1.0
"""m from a net or fence within which margins are in inches or centimetres: in feet or metres most would be 0."""
STRAIGHT = 0.05 * DEGREE
"""A direction nearer to an axis than this is reported as the axis."""
PLACES_OF_BALLPARKS = ("to centre field", "to home plate", "to right field", "to left field")
PLACES_OF_FIELDS = ("straight ahead", "straight back", "to the right", "to the left")
"""What is ahead, behind, to the right and to the left, in words."""


def flight_words(flown: FlightNumbers) -> Sentence:
    """Return a flight in a sentence."""
    outcome = flown.flight.outcome
    if outcome is not FlightOutcome.LANDED:
        return say(outcome.sentence[0].upper() + outcome.sentence[1:] + ".")
    return say(
        "It carries {flown.carry:distance} in {flown.hang_time:time}, at most {flown.apex:distance} high, and comes "
        "down {flown.landing_angle:angle, 0} steep at {flown.landing_speed:speed, 0}.",
        flown=flown,
    )


def small_or_far(margin: float) -> Slot:
    """Return the size of a margin (m) in a suitable unit: below `NEAR` that of places."""
    return Slot(abs(margin), "place" if abs(margin) < NEAR else "distance")


def fence_words(end: FlightEnd, *, chance: float | None = None) -> Sentence:
    """Return in a sentence what a flight is in a park.

    Parameters
    ----------
    chance : of a home run there, with which the words agree; None: the scatter of such balls is unknown.
    """
    if end.outcome == "foul":
        return say("At {park} it is foul.", park=end.park)
    if end.clearance is None:
        return say("At {park} it stays in the field of play.", park=end.park)
    outcome, clearance = end.outcome, float(end.clearance)
    if chance is not None and (outcome == "home run") != is_likely(chance):
        outcome = f"such balls {'go out' if is_likely(chance) else 'stay in'} more often than not"
    return say(
        "At {end.park} it reaches the fence {end.distance:distance} away {clearance} {side} its top: {outcome}.",
        end=end,
        clearance=small_or_far(clearance),
        side="over" if clearance > 0 else "below",
        outcome=outcome,
    )


def alike_words(half: Number, *, spin_known: bool) -> Sentence:
    """Return by how much the carries of balls hit alike differ, at the level of every interval.

    Parameters
    ----------
    half : of their interval, m.
    """
    return say(
        "{what} differ: nine in ten that leave like it come down within {reach:distance, 0} of that.",
        what="Balls and weather" if spin_known else "Balls, spin and weather",
        reach=half,
    )


def launch_words(ball: BallLeaving, *, ballpark: bool = True) -> Sentence:
    """Return how a ball leaves: "at 105.8 mph, 24.8° up and 11.7° to right field, with 3249 rpm of backspin ..."."""
    return say(
        "at {speed:speed}, {up} and {aside}, with {spin}",
        speed=ball.exit_speed,
        up=signed(ball.launch_angle, "angle", "up", "down"),
        aside=direction_words(ball.spray, ballpark=ballpark),
        spin=spin_words(ball),
    )


def direction_words(angle: Number, *, ballpark: bool = True) -> Sentence:
    """Return a direction over the field in words.

    Parameters
    ----------
    angle : rad, positive to right field.
    ballpark : whether the field has a home plate and a centre field.
    """
    ahead, back, right, left = PLACES_OF_BALLPARKS if ballpark else PLACES_OF_FIELDS
    if abs(float(angle)) < STRAIGHT:
        return say(ahead)
    if abs(abs(float(angle)) - 180 * DEGREE) < STRAIGHT:
        return say(back)
    return signed(angle, "angle", right, left)


def wind_words(angle: float, *, ballpark: bool) -> Sentence:
    """Return the direction that a wind blows to, over the full circle; parameters as of `direction_words`."""
    if min(abs(angle), abs(abs(angle) - 180 * DEGREE)) < STRAIGHT:
        return direction_words(angle, ballpark=ballpark)
    side, ahead = "right" if angle > 0 else "left", "centre field" if ballpark else "straight ahead"
    return say("{angle:angle, 0} to the {side} of {ahead}", angle=abs(angle), side=side, ahead=ahead)


def spin_words(ball: BallLeaving) -> Sentence:
    """Return a ball's spin, as "2200 rpm of backspin and 849 rpm that bend it right"; no spin is said to be none."""
    parts = [
        (ball.backspin, "of backspin", "of topspin"),
        (ball.sidespin, "that bend it left", "that bend it right"),
    ]
    turning = [signed(value, "spin", right, left) for value, right, left in parts if abs(float(value)) >= DEGREE]
    if not turning:
        return say("no spin")
    return turning[0] if len(turning) == 1 else say("{back} and {side}", back=turning[0], side=turning[1])


def signed(value: Number, scale: str, positive: str, negative: str) -> Sentence:
    """Return a number's size with the words that say its sign."""
    upwards = float(value) >= 0
    return say(
        "{size} {words}", size=Slot(value if upwards else -value, scale), words=positive if upwards else negative
    )

"""A flight in words, with the fence it met."""

from __future__ import annotations

from sweetspot.answers.flight import BallLeaving, FlightEnd, FlightNumbers
from sweetspot.flight.home_runs import is_likely
from sweetspot.flight.trajectory import FlightOutcome
from sweetspot.numerics.interval import Number
from sweetspot.report.sentences import Sentence, Slot, say
from sweetspot.units import DEGREE

NEAR = 1.0
"""m from a net or a fence within which inches or centimetres are told: in feet or metres most would be none."""
STRAIGHT = 0.05 * DEGREE
"""A direction nearer to an axis than this is told as the axis."""
PLACES_OF_BALLPARKS = ("to centre field", "to home plate", "to right field", "to left field")
PLACES_OF_FIELDS = ("straight ahead", "straight back", "to the right", "to the left")
"""What is ahead, behind, to the right and to the left, in words."""


def flight_words(flown: FlightNumbers) -> Sentence:
    """Return a flight in a sentence."""
    outcome = flown.flight.outcome
    if outcome is not FlightOutcome.LANDED:
        return say(outcome.sentence[0].upper() + outcome.sentence[1:] + ".")
    return say(
        "It carries {carry} in {time}, at most {apex} high, and comes down {angle} steep at {speed}.",
        carry=Slot(flown.carry, "distance"),
        time=Slot(flown.hang_time, "time"),
        apex=Slot(flown.apex, "distance"),
        angle=Slot(flown.landing_angle, "angle", digits=0),
        speed=Slot(flown.landing_speed, "speed", digits=0),
    )


def small_or_far(margin: float) -> Slot:
    """Return the size of a margin (m) in the unit in which it says something: less than `NEAR` as a place is told."""
    return Slot(abs(margin), "place" if abs(margin) < NEAR else "distance")


def fence_words(end: FlightEnd, *, chance: float | None = None) -> Sentence:
    """Return in a sentence what a flight is in a park.

    Parameters
    ----------
    chance : of a home run there, with which the words agree; None: nobody knows how such balls scatter.
    """
    if end.outcome == "foul":
        return say("At {park} it is foul.", park=end.park)
    if end.clearance is None:
        return say("At {park} it stays in the field of play.", park=end.park)
    outcome, clearance = end.outcome, float(end.clearance)
    if chance is not None and (outcome == "home run") != is_likely(chance):
        outcome = f"such balls {'go out' if is_likely(chance) else 'stay in'} more often than not"
    return say(
        "At {park} it reaches the fence {distance} away {clearance} {side} its top: {outcome}.",
        park=end.park,
        distance=Slot(end.distance, "distance"),
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
        "{what} differ: nine in ten that leave like it come down within {reach} of that.",
        what="Balls and weather" if spin_known else "Balls, spin and weather",
        reach=Slot(half, "distance", digits=0),
    )


def launch_words(ball: BallLeaving, *, ballpark: bool = True) -> Sentence:
    """Return how a ball leaves: "at 105.8 mph, 24.8° up and 11.7° to right field, with 3249 rpm of backspin ...".

    Parameters
    ----------
    ballpark : as in `direction_words`.
    """
    return say(
        "at {speed}, {up} and {aside}, with {spin}",
        speed=Slot(ball.exit_speed, "speed"),
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
    """Return where a wind blows to, all the way round; parameters as of `direction_words`."""
    if min(abs(angle), abs(abs(angle) - 180 * DEGREE)) < STRAIGHT:
        return direction_words(angle, ballpark=ballpark)
    side, ahead = "right" if angle > 0 else "left", "centre field" if ballpark else "straight ahead"
    return say("{angle} to the {side} of {ahead}", angle=Slot(abs(angle), "angle", 0), side=side, ahead=ahead)


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

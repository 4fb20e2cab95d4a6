"""A flight as JSON and in words, with the fence it met."""

from __future__ import annotations

import math
from typing import Any

from sweetspot.flight.fence import Landing
from sweetspot.flight.home_runs import is_likely
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.numerics.confidence import REACH
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, Slot, say
from sweetspot.units import DEGREE

NEAR = 1.0
"""m from a net or a fence within which inches or centimetres are told: in feet or metres most would be none."""
STRAIGHT = 0.05 * DEGREE
"""A direction nearer to an axis than this is told as the axis."""
PLACES_OF_BALLPARKS = ("to centre field", "to home plate", "to right field", "to left field")
PLACES_OF_FIELDS = ("straight ahead", "straight back", "to the right", "to the left")
"""What is ahead, behind, to the right and to the left, in words."""


def flight_json(flight: Flight, *, path: bool = True) -> dict[str, Any]:
    """Return a flight with a unit in every name; ``path`` adds where the ball was at every step."""
    answer: dict[str, Any] = {
        "outcome": flight.outcome.name.lower(),
        "carry_m": flight.carry,
        "bearing_rad": flight.bearing,
        "hang_time_s": flight.hang_time,
        "apex_m": flight.apex_height,
        "apex_time_s": flight.apex_time,
        "landing_speed_m_s": flight.landing.speed,
        "landing_angle_rad": flight.landing_angle,
    }
    return cleaned(answer | ({"path": path_columns(flight)} if path else {}))


def path_columns(flight: Flight | None) -> dict[str, list[float]]:
    """Return where the ball was at every step, as columns; empty where nothing flew."""
    if flight is None:
        return {"time_s": [], "right_m": [], "out_m": [], "up_m": []}
    right, out, up = flight.positions.T.tolist()
    return {"time_s": flight.times.tolist(), "right_m": right, "out_m": out, "up_m": up}


def landing_json(landing: Landing, park: Park) -> dict[str, Any]:
    """Return where a flight ends in a park."""
    return cleaned(
        {
            "park": park.name,
            "outcome": landing.outcome,
            "direction_rad": landing.direction,
            "distance_m": landing.distance,
            "height_m": landing.height,
            "clearance_m": landing.clearance,
        }
    )


def from_the_hit(flight: Flight) -> float:
    """Return m over the ground from where the ball was hit to where it lands, for sports without a home plate."""
    start, end = flight.launch.position, flight.landing.position
    return math.hypot(end[0] - start[0], end[1] - start[1])


def flight_words(flight: Flight, carry: float | None = None, *, at: str = "flight.") -> Sentence:
    """Return a flight in a sentence.

    Parameters
    ----------
    carry : m over the ground where it counts from another place than home plate.
    at : what its numbers' names begin with in the document's data.
    """
    if flight.outcome is not FlightOutcome.LANDED:
        return say(flight.outcome.sentence[0].upper() + flight.outcome.sentence[1:] + ".")
    return say(
        "It carries {carry} in {time}, at most {apex} high, and comes down {angle} steep at {speed}.",
        carry=Slot(flight.carry if carry is None else carry, "distance", of=f"{at}carry_m"),
        time=Slot(flight.hang_time, "time", of=f"{at}hang_time_s"),
        apex=Slot(flight.apex_height, "distance", of=f"{at}apex_m"),
        angle=Slot(flight.landing_angle, "angle", digits=0, of=f"{at}landing_angle_rad"),
        speed=Slot(flight.landing.speed, "speed", digits=0, of=f"{at}landing_speed_m_s"),
    )  # fmt: skip


def small_or_far(margin: float) -> Slot:
    """Return the size of a margin (m) in the unit in which it says something: less than `NEAR` as a place is told."""
    return Slot(abs(margin), "place" if abs(margin) < NEAR else "distance")


def landing_words(landing: Landing, park: Park, *, chance: float | None = None) -> Sentence:
    """Return in a sentence what that is in a park.

    Parameters
    ----------
    chance : of a home run there, with which the words agree; None: nobody knows how such balls scatter.
    """
    if landing.outcome == "foul":
        return say("At {park} it is foul.", park=park.name)
    if landing.clearance is None:
        return say("At {park} it stays in the field of play.", park=park.name)
    outcome: str = landing.outcome
    if chance is not None and (outcome == "home run") != is_likely(chance):
        outcome = f"such balls {'go out' if is_likely(chance) else 'stay in'} more often than not"
    return say(
        "At {park} it reaches the fence {distance} away {clearance} {side} its top: {outcome}.",
        park=park.name, distance=Slot(landing.distance, "distance"),
        clearance=small_or_far(landing.clearance), side="over" if landing.clearance > 0 else "below",
        outcome=outcome,
    )  # fmt: skip


def spread_json(spread: float) -> dict[str, float]:
    """Return how far carries of balls hit alike scatter, and half of their interval; nothing where it is not known.

    Parameters
    ----------
    spread : m, standard deviation; 0: not known.
    """
    return {"carry_spread_m": spread, "carry_half_m": REACH * spread} if spread else {}


def alike_words(spread: float, *, spin_known: bool) -> Sentence:
    """Return by how much the carries of balls hit alike differ, at the level of every interval.

    Parameters
    ----------
    spread : m, standard deviation.
    """
    return say(
        "{what} differ: nine in ten that leave like it come down within {reach} of that.",
        what="Balls and weather" if spin_known else "Balls, spin and weather",
        reach=Slot(REACH * spread, "distance", digits=0),
    )


def launch_words(ball: BallMotion, *, ballpark: bool = True) -> Sentence:
    """Return how a ball leaves: "at 105.8 mph, 24.8° up and 11.7° to right field, with 3249 rpm of backspin ...".

    Parameters
    ----------
    ballpark : as in `direction_words`.
    """
    return say(
        "at {speed}, {up} and {aside}, with {spin}",
        speed=Slot(ball.speed, "speed", of="exit_speed_m_s"),
        up=signed(ball.launch_angle, "angle", "up", "down", of="launch_angle_rad"),
        aside=direction_words(ball.spray, ballpark=ballpark, of="spray_rad"), spin=spin_words(ball),
    )  # fmt: skip


def direction_words(angle: float, *, ballpark: bool = True, of: str = "") -> Sentence:
    """Return a direction over the field in words.

    Parameters
    ----------
    angle : rad, positive to right field.
    ballpark : whether the field has a home plate and a centre field.
    of : see `Slot`.
    """
    ahead, back, right, left = PLACES_OF_BALLPARKS if ballpark else PLACES_OF_FIELDS
    if abs(angle) < STRAIGHT:
        return say(ahead)
    if abs(abs(angle) - 180 * DEGREE) < STRAIGHT:
        return say(back)
    return signed(angle, "angle", right, left, of=of)


def wind_words(angle: float, *, ballpark: bool) -> Sentence:
    """Return where a wind blows to, all the way round; parameters as of `direction_words`."""
    if min(abs(angle), abs(abs(angle) - 180 * DEGREE)) < STRAIGHT:
        return direction_words(angle, ballpark=ballpark)
    side, ahead = "right" if angle > 0 else "left", "centre field" if ballpark else "straight ahead"
    return say("{angle} to the {side} of {ahead}", angle=Slot(abs(angle), "angle", 0), side=side, ahead=ahead)


def spin_words(ball: BallMotion) -> Sentence:
    """Return a ball's spin, as "2200 rpm of backspin and 849 rpm that bend it right"; no spin is said to be none."""
    parts = [
        (ball.backspin, "of backspin", "of topspin", "backspin_rad_s"),
        (ball.sidespin, "that bend it left", "that bend it right", "sidespin_rad_s"),
    ]
    turning = [signed(value, "spin", right, left, of=of) for value, right, left, of in parts if abs(value) >= DEGREE]
    if not turning:
        return say("no spin")
    return turning[0] if len(turning) == 1 else say("{back} and {side}", back=turning[0], side=turning[1])


def signed(value: float, scale: str, positive: str, negative: str, *, of: str = "") -> Sentence:
    """Return a number's size with the words that say its sign; ``of`` as in `Slot`."""
    at = f"-{of}" if of and value < 0 else of
    return say("{size} {words}", size=Slot(abs(value), scale, of=at), words=positive if value >= 0 else negative)

"""Flights of other sports in words: with the net, lines and boundaries of the sport instead of fences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sweetspot.equipment.ball import Ball
from sweetspot.equipment.sport import Sport
from sweetspot.flight.court_marks import Passage, passages
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.report.flight.words import flight_words, from_the_hit, small_or_far
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, joined, say


def court_json(flight: Flight, sport: Sport, *, ball: Ball) -> dict[str, Any]:
    """Return a flight at every mark of its sport."""
    landed = flight.outcome is FlightOutcome.LANDED
    passed = passages(flight, sport.marks, ball=ball) if landed else ()
    return {"sport": sport.key, "marks": [cleaned(_mark_json(passage)) for passage in passed]}


def _mark_json(passage: Passage) -> dict[str, Any]:
    mark = passage.mark
    return {
        "name": mark.name,
        "side": mark.side,
        "distance_m": mark.distance.value,
        "height_m": mark.height.value if mark.height else None,
        "ball_height_m": passage.ball_height,
        "margin_m": passage.margin,
        "good": passage.good,
    }


def court_words(flight: Flight, sport: Sport, *, ball: Ball, from_plate: bool = False) -> Sentence:
    """Return a flight and what it is on this sport's court or field, in sentences.

    Parameters
    ----------
    from_plate : whether the carry counts from home plate, or from where the ball was hit.
    """
    if flight.outcome is not FlightOutcome.LANDED:
        return flight_words(flight, at="")
    told = flight_words(flight, carry=None if from_plate else from_the_hit(flight), at="")
    return joined([told, *_sentences(passages(flight, sport.marks, ball=ball))])


def _sentences(passed: Sequence[Passage]) -> list[Sentence]:
    texts = []
    for passage in passed:
        name, margin = passage.mark.name, small_or_far(passage.margin)
        if passage.mark.side == "before":
            side = "before" if passage.good else "beyond"
            texts.append(say("It lands {margin} {side} the {name}.", margin=margin, side=side, name=name))
        elif passage.good:
            texts.append(say("It passes {margin} over the {name}.", margin=margin, name=name))
        elif math.isnan(passage.ball_height):
            texts.append(say("It lands {margin} short of the {name}.", margin=margin, name=name))
        else:
            texts.append(say("It meets the {name} {margin} below its top.", margin=margin, name=name))
            break  # beyond it there is another flight
    return texts

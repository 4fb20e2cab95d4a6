"""Flights of other sports in words: in the sport's units, with its net, lines and boundaries instead of fences."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from sweetspot.ball import Ball
from sweetspot.flight.court import Passage, passages
from sweetspot.flight.trajectory import Flight, FlightOutcome
from sweetspot.report.border import cleaned
from sweetspot.report.speech import Speech
from sweetspot.units import DEGREE


def court_json(flight: Flight, said: Speech, *, ball: Ball) -> dict[str, Any]:
    """Return a flight at every mark of its sport."""
    landed = flight.outcome is FlightOutcome.LANDED
    found = passages(flight, said.sport.marks, ball=ball) if landed else ()
    return {"sport": said.sport.key, "marks": [cleaned(_mark_json(passage)) for passage in found]}


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


def court_words(flight: Flight, said: Speech, *, ball: Ball) -> str:
    """Return a flight and what it is on this sport's court or field, in sentences."""
    if flight.outcome is not FlightOutcome.LANDED:
        return flight.outcome.sentence[0].upper() + flight.outcome.sentence[1:] + "."
    start = flight.positions[0]
    reached = math.hypot(flight.landing.position[0] - start[0], flight.landing.position[1] - start[1])
    height, speed = said.distance(flight.apex_height), said.speed(flight.landing.speed)
    text = (
        f"It carries {said.distance(reached)} in {flight.hang_time:.2f} s, at most {height} high, and comes down "
        f"{flight.landing_angle / DEGREE:.0f} deg steep at {speed}."
    )
    return " ".join([text, *_sentences(passages(flight, said.sport.marks, ball=ball), said)])


def _sentences(found: Sequence[Passage], said: Speech) -> list[str]:
    texts = []
    for passage in found:
        name, margin = passage.mark.name, said.distance(abs(passage.margin))
        if passage.mark.side == "before":
            texts.append(f"It lands {margin} {'before' if passage.good else 'beyond'} the {name}.")
        elif passage.good:
            texts.append(f"It passes {margin} over the {name}.")
        elif math.isnan(passage.ball_height):
            texts.append(f"It lands {margin} short of the {name}.")
        else:
            texts.append(f"It meets the {name} {margin} below its top.")
    return texts

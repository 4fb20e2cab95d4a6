"""Flights of other sports in words: with the net, lines and boundaries of the sport instead of fences."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sweetspot.answers.flight import FlightNumbers
from sweetspot.answers.fly import Court
from sweetspot.report.flight.words import flight_words, small_or_far
from sweetspot.report.sentences import Sentence, joined, say


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

"""A hit in space and a play as Python returns them, without bat and park, as documents."""

from __future__ import annotations

from sweetspot.analysis.full_play import Play, Plays
from sweetspot.answers.flight import flight_of
from sweetspot.collision.hit_in_space import Strike
from sweetspot.report.document import Document, Paragraph
from sweetspot.report.flight.document import flight_document
from sweetspot.report.flight.many_flights import flights_document
from sweetspot.report.hit.document import impact_document


def bare_play_document(play: Play | Plays) -> Document:
    """Return the flights of plays as a document; of one that missed, how it ended."""
    if isinstance(play, Plays):
        return flights_document(play.flights)
    return strike_document(play.strike) if play.flight is None else flight_document(flight_of(play.flight))


def strike_document(strike: Strike) -> Document:
    """Return the collision of a hit in space as a document; of one that missed, how it ended."""
    if strike.impact is not None:
        return impact_document(strike.impact)
    data = {"outcome": strike.outcome.name.lower(), "bat_speed_m_s": strike.bat_speed}
    return Document(
        name="hit", title="", kind="Hit", blocks=[Paragraph(f"{strike.outcome.sentence.capitalize()}.")], data=data,
        rows={name: [value] for name, value in data.items()},
    )  # fmt: skip

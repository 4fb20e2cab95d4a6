"""Many hits as a document: each by its number, in the order in which they were asked for."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.answers.records import plain_data
from sweetspot.collision.hit_in_space import Strikes
from sweetspot.collision.impact import Impacts, Outcome
from sweetspot.reports.document import Document, Paragraph, Picture, drawn
from sweetspot.reports.quantities import key
from sweetspot.reports.sentences import Sentence, Slot, Span, say
from sweetspot.units import grouped


def impacts_document(hits: Impacts | Strikes) -> Document:
    """Return many collisions as a document, without their bat's name or swing speed."""
    columns = {
        "outcome": [Outcome(int(each)).name.lower() for each in hits.outcome.ravel()],
        **{key(name): getattr(hits, name).ravel().tolist()
           for name in ("collision_efficiency", "contact_time", "peak_force", "peak_compression")},
    }  # fmt: skip
    picture = Picture(
        "hits",
        drawn("sweetspot.reports.hit.picture:impacts_figure", hits),
        "Collision efficiency, contact time and peak force of every hit.",
        "In the order in which they were asked for.",
    )
    lists = plain_data(columns)
    valid = bool(np.isfinite(hits.collision_efficiency).any())
    return Document(
        name="hits", title="", kind="Hits", blocks=[Paragraph(_words(hits)), *([picture] if valid else [])], data=lists,
        rows=lists, drawing=picture if valid else None,
    )  # fmt: skip


def _words(hits: Impacts | Strikes) -> Sentence:
    efficiency, count = hits.collision_efficiency.ravel(), len(hits.outcome.ravel())
    finite = np.isfinite(efficiency)
    noun = "hit" if count == 1 else "hits"
    if not finite.any():
        return say("{count} {noun}, none of which has an answer.", count=grouped(count), noun=noun)
    best = int(np.nanargmax(efficiency))
    return say(
        "{count} {noun}, {known} with an answer: collision efficiency {q}, greatest in number {best}; contact {time}; "
        "peak force {force}.",
        count=grouped(count), noun=noun, known=grouped(int(finite.sum())), best=grouped(best + 1),
        q=Span(float(efficiency[finite].min()), float(efficiency[best]), "ratio"),
        time=_span(hits.contact_time, "contact"), force=_span(hits.peak_force, "blow"),
    )  # fmt: skip


def _span(values: Any, scale: str) -> Span | Slot:
    finite = values[np.isfinite(values)]
    return Span(float(finite.min()), float(finite.max()), scale) if len(finite) else Slot(float("nan"), scale)

"""What a changed bat is swung with, in words: the same effort as before the change, or the same speed."""

from __future__ import annotations

from dataclasses import replace

from sweetspot.answers.setups import SwungWith
from sweetspot.numerics.interval import NO_SPEED
from sweetspot.reports.document import Document, Paragraph
from sweetspot.reports.sentences import Sentence, say


def effort_words(swung: SwungWith) -> Sentence:
    """Say how a changed bat is swung, and what its speed became."""
    name, speed = swung.changed.bat.name, float(swung.bat_speed)
    if swung.same == "speed":
        other = swung.changed.with_same_effort(swung.conditions).swing.bat_speed
        return say(
            "{name}: swung at the same speed as before the change, {speed:speed}; with the same effort it would move "
            "at {other:speed}.",
            name=name,
            speed=speed,
            other=other,
        )
    before = float(swung.bat_speed_before)
    if abs(speed - before) < NO_SPEED:
        return say(
            "{name}: swung with the same effort as before the change, which leaves its speed at {speed:speed}.",
            name=name,
            speed=speed,
        )
    return say(
        "{name}: swung with the same effort as before the change, at {speed:speed} in place of {before:speed}.",
        name=name,
        speed=speed,
        before=before,
    )


def with_effort(document: Document, swung: SwungWith | None) -> Document:
    """Return an answer about a changed bat with the sentence that says how it is swung; of another as it is."""
    if swung is None:
        return document
    blocks = [*document.blocks]
    place = next((at for at, block in enumerate(blocks[:2], start=1) if isinstance(block, Paragraph)), 0)
    blocks.insert(place, Paragraph(effort_words(swung)))
    return replace(document, blocks=blocks)

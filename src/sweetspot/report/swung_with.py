"""What a changed bat is swung with, in words: the same effort as before the change, or the same speed."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sweetspot.analysis.same_effort import Changed
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.confidence import NO_SPEED
from sweetspot.report.document import Document, Paragraph
from sweetspot.report.sentences import Sentence, Slot, say


def effort_words(changed: Changed, conditions: Conditions, *, same_speed: bool) -> Sentence:
    """Return in a sentence how a changed bat is swung, and what its speed became.

    Parameters
    ----------
    conditions : as it is swung.
    same_speed : whether as fast as the bat that it was.
    """
    name, speed = changed.bat.name, conditions.swing.bat_speed
    if same_speed:
        other = changed.with_same_effort(conditions).swing.bat_speed
        return say(
            "{name}: swung at the same speed as before the change, {speed}; with the same effort it would move at "
            "{other}.",
            name=name, speed=Slot(speed, "speed"), other=Slot(other, "speed"),
        )  # fmt: skip
    before = changed.speed_before(conditions)
    if abs(speed - before) < NO_SPEED:
        return say(
            "{name}: swung with the same effort as before the change, which leaves its speed at {speed}.",
            name=name, speed=Slot(speed, "speed"),
        )  # fmt: skip
    return say(
        "{name}: swung with the same effort as before the change, at {speed} in place of {before}.",
        name=name, speed=Slot(speed, "speed"), before=Slot(before, "speed"),
    )  # fmt: skip


def with_effort(document: Document, changed: Changed | None, conditions: Conditions, *, same_speed: bool) -> Document:
    """Return an answer of a changed bat with the sentence that says how it is swung; of another as it is."""
    if changed is None:
        return document
    words = Paragraph(effort_words(changed, conditions, same_speed=same_speed))
    data: dict[str, Any] = {
        "same": "speed" if same_speed else "effort",
        "bat_speed_m_s": conditions.swing.bat_speed,
        "bat_speed_before_m_s": conditions.swing.bat_speed if same_speed else changed.speed_before(conditions),
    }
    blocks = [*document.blocks]
    blocks.insert(next((at for at, one in enumerate(blocks[:2], start=1) if isinstance(one, Paragraph)), 0), words)
    return replace(document, blocks=blocks, data={**document.data, "swung_with": data})

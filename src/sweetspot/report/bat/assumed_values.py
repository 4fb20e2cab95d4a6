"""What of an answer rests on assumed values of speeds and the ball, told in one sentence everywhere alike."""

from __future__ import annotations

from sweetspot.catalog.sports import sport
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Conditions
from sweetspot.report.bat.provenance import assumed_of_ball
from sweetspot.report.document import Block, Paragraph
from sweetspot.report.sentences import Sentence, Slot, joined, say
from sweetspot.report.sport_words import in_words, words_of


def soft_defaults(implement: Implement, ball: Ball, conditions: Conditions | None = None) -> Sentence:
    """Return what was assumed of a ball, and with conditions of the speeds, in a sentence; no words where nothing was.

    >>> from sweetspot.catalog.balls import ball
    >>> from sweetspot.catalog.bats import bat
    >>> from sweetspot.report.sport_words import reader_of
    >>> slow = bat("slow-pitch")
    >>> soft_defaults(slow, ball("softball-12in")).read(reader_of(slow))
    'Assumed, not measured: of the ball, loss of restitution with speed and stiffness.'
    >>> soft_defaults(bat("r161-ash"), ball("baseball")).parts
    ()
    """
    stroke = sport(implement.sport).stroke
    used = (
        ((stroke.swing_speed, conditions.swing.bat_speed), (stroke.ball_speed, conditions.pitch.speed))
        if conditions
        else ()
    )
    soft = [
        say("{name} {speed}", name=one.name, speed=Slot(value, "speed", round=True))
        for one, value in used
        if one.kind == "assumed" and one.value == value
    ]
    if values := assumed_of_ball(ball):
        listed = " and ".join([*filter(None, [", ".join(values[:-1])]), values[-1]])
        soft.append(in_words("of the {ball}, {listed}", words_of(implement), listed=listed))
    return say("Assumed, not measured: {soft}.", soft=joined(soft, "; ")) if soft else Sentence(())


def soft_note(implement: Implement, ball: Ball) -> list[Block]:
    """Return what was assumed of a ball as a note of a document, or nothing."""
    words = soft_defaults(implement, ball)
    return [Paragraph(words, "note")] if words.parts else []

"""A paddle's core as a tap has it, in words: sound or crushed, and whether the paddle keeps its rules."""

from __future__ import annotations

from sweetspot.answers.paddle_core import PaddleCore
from sweetspot.numerics.interval import interval_of
from sweetspot.reports.document import Block, Paragraph, Table, table_head
from sweetspot.reports.sentences import Sentence, say

VERDICTS = {
    "crushed": "The core is probably crushed ({core.crushed_probability:share}): about {left:share} of its shear "
    "stiffness is left where balls land.",
    "sound": "The core is probably sound; the probability that it is crushed is {core.crushed_probability:share}.",
    "open": "The tones leave open whether the core is crushed ({core.crushed_probability:share}). Tap the handle's end "
    "and the tip as well, each with its --at, or compare with a tap of the paddle when it was new: calibrate it.",
}
OFF = 0.01
"""Part by which a face tone may be off the described one's without a word."""


def core_blocks(core: PaddleCore) -> list[Block]:
    """Return the verdict on a core, the face's tone, the rules, and what softening does."""
    words = say(VERDICTS[core.verdict], core=core, left=interval_of(core.shear_left).value)
    blocks: list[Block] = [Paragraph(words), Paragraph(_tone(core))]
    if core.pbcor is None:
        return blocks
    blocks.append(
        Paragraph(
            say(
                "Paddle-ball restitution in the test of the rules {pbcor.value:ratio} ({pbcor.low:ratio} to "
                "{pbcor.high:ratio}), limit {core.pbcor_limit:ratio}: above it with a probability of "
                "{core.over_limit_probability:share}.",
                pbcor=interval_of(core.pbcor),
                core=core,
            )
        )
    )
    rows = [
        [interval_of(number).value for number in (each.shear_left, each.face_tone, each.rebound, each.pbcor)]
        for each in core.softening
    ]
    columns = table_head(
        "shear stiffness left: share | face tone: frequency, 0 | rebound / speed: ratio | PBCoR: ratio"
    )
    blocks.append(Table("What a softer core does", columns, rows))
    return blocks


def _tone(core: PaddleCore) -> Sentence:
    heard, described = (interval_of(tone).value for tone in (core.face_tone, core.described_face_tone))
    off = heard / described - 1
    if abs(off) < OFF:
        return say("Its face rings at {heard:frequency, 0}, as described.", heard=heard)
    return say(
        "Its face rings at {heard:frequency, 0}, {off:share} {side} the {described:frequency, 0} of the paddle as "
        "described with a sound core.",
        heard=heard,
        off=abs(off),
        side="above" if off > 0 else "below",
        described=described,
    )

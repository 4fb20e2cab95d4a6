"""How sure the speed of the best hit is, behind the number itself, and by what."""

from __future__ import annotations

from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import REACH
from sweetspot.report.sentences import Sentence, Slot, say
from sweetspot.uncertainty.linear_doubt import SpeedDoubt
from sweetspot.uncertainty.sources import OF_BALL, PATCH, PITCH, SWING

MOSTLY, COUNTS = 0.6, 0.1
"""Parts of the variance from which on one thing is most of it, and from which on a thing is named beside others."""


def doubt_words(doubt: SpeedDoubt, words: Terms) -> Sentence:
    """Return the half width of the interval and what it comes from: ", give or take 6 mph, mostly by the ball"."""
    half = Slot(REACH * doubt.error, "speed")
    parts = _by_thing(doubt, words)
    if len(parts) == 1:
        return say(", give or take {half} by {thing} alone", half=half, thing=next(iter(parts)))
    ranked = sorted(parts, key=lambda thing: -parts[thing])
    if parts[ranked[0]] >= MOSTLY:
        return say(", give or take {half}, mostly by {thing}", half=half, thing=ranked[0])
    *named, last = [thing for thing in ranked if parts[thing] >= COUNTS]
    return say(", give or take {half}, by {things} and {last}", half=half, things=", ".join(named), last=last)


def _by_thing(doubt: SpeedDoubt, words: Terms) -> dict[str, float]:
    """Return which part of the variance the ball, what hits it and the speeds that were given add."""
    parts: dict[str, float] = {}
    for name, share in doubt.shares.items():
        if name.startswith(OF_BALL) or name == PATCH:
            thing = f"the {words.ball}"
        elif name in (SWING, PITCH):
            thing = "the speeds as they were written"
        else:
            thing = f"the {words.implement}"
        parts[thing] = parts.get(thing, 0.0) + share
    return parts

"""A probability that draws tell, in words."""

from __future__ import annotations

from sweetspot.report.sentences import Sentence, Slot, say

LEAST = 0.005
"""That few draws do not tell from none: a probability nearer to 0 or 1 is told as beyond 1 or 99 %."""


def chance_words(chance: float) -> Sentence:
    """Return a probability as a part of 100; never none and never all, of which draws cannot be sure.

    >>> str(chance_words(0.64)), str(chance_words(0.0)), str(chance_words(1.0))
    ('64 %', 'less than 1 %', 'more than 99 %')
    """
    if chance < LEAST:
        return say("less than {share}", share=Slot(0.01, "share"))
    if chance > 1 - LEAST:
        return say("more than {share}", share=Slot(0.99, "share"))
    return say("{share}", share=Slot(chance, "share"))

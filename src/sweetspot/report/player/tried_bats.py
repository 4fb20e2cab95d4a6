"""A bat tried on a player in words, in the reader's units."""

from __future__ import annotations

from sweetspot.player.candidate import Candidate
from sweetspot.report.sentences import Sentence, Slot, say

SCALES = {"weight": "mass", "balance": "mass", "length": "place", "choke": "place"}
"""Of what is changed, by family."""


def option_words(candidate: Candidate) -> Sentence:
    """Return what a bat tried is beside the player's own: "1 in longer, same weight"; another bat's name."""
    scale = SCALES.get(candidate.family)
    if scale is None:
        return say("{name}", name=candidate.label)
    amount = Slot(abs(candidate.amount), scale, round=True)
    if candidate.family == "balance":
        where = "tip" if candidate.key == "end-loaded" else "knob"
        return say("{amount} at the {where}", amount=amount, where=where)
    if candidate.family == "choke":
        return say("choked up {amount}", amount=amount)
    if candidate.family == "length":
        way = "longer" if candidate.amount > 0 else "shorter"
        return say("{amount} {way}, same weight", amount=amount, way=way)
    return say("{amount} {way}", amount=amount, way="heavier" if candidate.amount > 0 else "lighter")

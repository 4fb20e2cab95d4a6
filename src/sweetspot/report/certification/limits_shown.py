"""Values that rules limit, and the limits, as people read them."""

from __future__ import annotations

from sweetspot.analysis.certification.rules import QUANTITIES, Check
from sweetspot.report.sentences import Sentence, Slot, Words, joined, say

SCALES = {"m": ("length", 3), "m/s": ("speed", 1), "kg m^2": ("moi", None), "in - oz": ("ratio", 2)}
"""Scale and digits of what rules limit, by its unit; every other is a ratio with four digits."""


def limit_shown(check: Check) -> Words:
    """Return the limit of a rule with the side it is on."""
    rule = check.rule
    if rule.quantity == "solid_wood":
        return "yes"
    sides = [("at least", rule.least), ("at most", rule.most)]
    return joined(
        say("{side} {limit}", side=side, limit=value_shown(rule.quantity, limit)) for side, limit in sides
        if limit is not None
    )  # fmt: skip


def value_shown(quantity: str, value: float | None, *, sign: bool = False, of: str = "") -> Sentence:
    """Return a value in the unit that people use for it; ``of`` as in `Slot`."""
    if value is None:
        return Sentence(())
    unit = QUANTITIES[quantity][1]
    if unit == "yes or no":
        return say("yes" if value else "no")
    scale, digits = SCALES.get(unit, ("ratio", 4))
    return Sentence((Slot(value, scale, digits, sign, of=of),))

"""Values that rules limit, the limits and the verdicts, as people read them."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.analysis.certification.rules import QUANTITIES, Check, Verdict, title
from sweetspot.answers.certify import RuleCheck
from sweetspot.numerics.interval import Interval, Number
from sweetspot.reports.document import Marked
from sweetspot.reports.sentences import Sentence, Slot, Words, joined, say, within

SCALES = {
    "m": ("length", 3),
    "m/s": ("speed", 1),
    "kg m^2": ("moi", None),
    "in - oz": ("ratio", 2),
    "N": ("tension", 0),
    "s": ("tap_time", 0),
    "head_moi": ("head_moi", 0),
}
"""Scale and digits of what rules limit, by its name or its unit; every other is a ratio with four digits."""

COARSE = frozenset({"bpf", "pbcor"})
"""Ratios whose third digit is their last [bpf_limits]."""
MARKS: dict[Verdict, str] = {Verdict.PASS: "hit", Verdict.FAIL: "missed"}
"""Of verdicts that are sure."""


def marked_verdict(check: Check) -> Marked:
    """Return the verdict of one rule, marked where it is sure."""
    return Marked(check.words, MARKS[check.verdict] if check.sure else "")


BROKEN = {
    "solid_wood": "it is not one piece of solid wood",
    "unaltered": "it is altered (drilled, filled, shaved, rolled or loaded), which no rule allows",
}
"""What is wrong with a bat whose value says nothing beside the rule's name."""


def broken_rules(checks: Sequence[RuleCheck], *, not_sure: str = "") -> Sentence:
    """Return all that is broken, what several leagues forbid alike once; ``not_sure`` stands after what may be kept."""
    leagues: dict[str, list[str]] = {}
    for check in checks:
        leagues.setdefault(check.quantity, []).append(check.league_name)
    faults: list[Sentence] = []
    for check in checks:
        if check.quantity not in BROKEN:
            faults.append(broken_words(check) + say("" if check.sure else not_sure))
        elif check.quantity in leagues:
            faults.append(
                say("{fault} ({leagues})", fault=BROKEN[check.quantity], leagues=", ".join(leagues.pop(check.quantity)))
            )
    return joined(faults, "; ")


def broken_words(check: RuleCheck) -> Sentence:
    """Return a broken rule with its league, since another league's rules may be kept, and by what it is broken."""
    value, limit = value_shown(check.quantity, check.outcome.value), limit_shown(check)
    words = "{check.title} of {check.league_name} ({value}, allowed {limit})"
    return say(words, check=check, value=value, limit=limit)


def unsure_words(checks: Sequence[Check], *, verdict: Verdict = Verdict.PASS) -> str:
    """Return which rules are kept or broken only as far as is known: they are not counted among those that are."""
    names = dict.fromkeys(title(check.rule) for check in checks if check.verdict is verdict and not check.sure)
    if not names:
        return ""
    does = "passes" if verdict is Verdict.PASS else "fails"
    return f" Not sure: {' and '.join(names)}. It just {does}; what is not known reaches across the limit."


def limit_shown(check: RuleCheck) -> Words:
    """Return the limit of a rule with the side it is on."""
    if check.unit == "yes or no":
        return "yes"
    sides = [("at least", check.least), ("at most", check.most)]
    return joined(
        say("{side} {limit}", side=side, limit=value_shown(check.quantity, limit)) for side, limit in sides
        if limit is not None
    )  # fmt: skip


def league_limit(check: RuleCheck) -> Sentence:
    """Return the owner of a rule, and its limit where that is a number."""
    limit = "" if check.unit == "yes or no" else joined([": ", limit_shown(check)], "")
    return say("{league}{limit}", league=check.league_name, limit=limit)


SIGNS = {Verdict.PASS: "✓", Verdict.FAIL: "✗", Verdict.NOT_DECIDABLE: "?", Verdict.NOT_APPLICABLE: "\N{EN DASH}"}


def verdict_words(check: RuleCheck) -> Sentence:
    """Return the sign and the verdict of a rule, whether that is not sure, and the value."""
    verdict, applies = check.outcome.verdict, check.outcome.verdict is not Verdict.NOT_APPLICABLE
    unsure = "" if check.sure or verdict not in MARKS else ", not sure"
    value = value_shown(check.quantity, check.value)
    in_brackets = say(" ({value})", value=value) if applies and value.parts else ""
    return say(
        "{sign} {verdict}{unsure}{value}", sign=SIGNS[verdict], verdict=verdict, unsure=unsure, value=in_brackets
    )


def value_with_ends(quantity: str, value: Interval) -> Sentence:
    """Return a value with the ends of its 90 % interval in brackets."""
    scale, digits = SCALES.get(QUANTITIES[quantity][1], ("ratio", 4))
    digits = 3 if quantity in COARSE else digits
    return within(value, scale, digits=digits)


def value_shown(quantity: str, value: Number | None, *, sign: bool = False) -> Sentence:
    """Return a value in the unit that people use for it, with its interval where it has one."""
    if value is None:
        return Sentence(())
    unit = QUANTITIES[quantity][1]
    if unit == "yes or no":
        return say("yes" if float(value) else "no")
    scale, digits = SCALES.get(quantity) or SCALES.get(unit, ("ratio", 4))
    return Sentence((Slot(value, scale, digits, sign),))

"""Whether the bats of a comparison keep the rules: one row a bat."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.analysis.certification.rules import NOT_SURE, Verdict
from sweetspot.answers.certify import CertifyAnswer, RuleCheck
from sweetspot.answers.records import to_dict
from sweetspot.report.certification.limits_shown import MARKS, broken_words, limit_shown, value_shown
from sweetspot.report.document import Cell, Column, Marked, Table
from sweetspot.report.sentences import Sentence, joined, say

TOLD = ("league", "quantity", "verdict", "sure", "value", "unit")
"""Of a decided rule in the JSON."""


def legality_table(tested: Sequence[tuple[str, CertifyAnswer]]) -> Table:
    """Return the verdict on every bat, and which rules make it or stay open.

    Parameters
    ----------
    tested : label and test of every bat.
    """
    columns = [Column("bat"), Column("rules of"), Column("verdict"), Column("why")]
    rows: list[list[Cell]] = [[label, _leagues(one), verdict(one), reason(one)] for label, one in tested]
    return Table("By the rules, as the model sees it; no certificate", columns, rows, name="compared")


def legality_json(tested: CertifyAnswer) -> dict[str, Any]:
    """Return the verdict on one bat with the rules behind it; `certify` tells their limits and sources."""
    checks = [
        {name: value for name, value in to_dict(one).items() if name in TOLD}
        for one in tested.checks
        if one.outcome.decided
    ]
    return {"passed": tested.passed, "verdict": _word(tested), "sure": tested.sure, "checks": checks}


def verdict(tested: CertifyAnswer) -> Marked:
    """Return pass, fail or not decidable for all rules together, marked where it is sure."""
    word = _word(tested)
    if word is Verdict.NOT_DECIDABLE:
        return Marked(word.value, "")
    return Marked(word.value, MARKS[word]) if tested.sure else Marked(f"{word}{NOT_SURE}", "")


def _word(tested: CertifyAnswer) -> Verdict:
    if tested.failed:
        return Verdict.FAIL
    return Verdict.PASS if tested.passed else Verdict.NOT_DECIDABLE


def reason(tested: CertifyAnswer) -> Sentence:
    """Return the rules that are broken; of a bat that breaks none the limit on its liveliness, and what stays open."""
    if tested.failed:
        return joined([broken_words(one) + say(_doubt(one)) for one in tested.failed], "; ")
    lively = [
        say("{rule} of the test {value}, allowed {limit}{doubt}", rule=one.title,
            value=value_shown(one.quantity, one.value), limit=limit_shown(one), doubt=_doubt(one))
        for one in tested.checks
        if one.outcome.verdict is Verdict.PASS and one.quantity in ("bbcor", "bpf", "besr")
    ]  # fmt: skip
    lively += [
        say("one piece of wood, which {league} do not hold to {rule}", league=one.league_name, rule=one.title)
        for one in tested.checks
        if one.outcome.verdict is Verdict.NOT_APPLICABLE and one.quantity == "bbcor"
    ]
    left = [one.title for one in tested.checks if one.outcome.verdict is Verdict.NOT_DECIDABLE]
    return joined([*lively, *([say("open: {rules}", rules=", ".join(left))] if left else [])], "; ")


def _doubt(check: RuleCheck) -> str:
    return "" if check.sure else NOT_SURE


def _leagues(tested: CertifyAnswer) -> str:
    names = {one.league: one.league_name for one in tested.checks}
    return "; ".join(names.values())

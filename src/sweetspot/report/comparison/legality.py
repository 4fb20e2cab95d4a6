"""Whether the bats of a comparison keep the rules: one row a bat."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.analysis.certification.rules import NOT_SURE, Verdict
from sweetspot.answers.certify import CertifyAnswer, RuleCheck
from sweetspot.answers.compare import ComparedBat
from sweetspot.report.certification.limits_shown import MARKS, broken_words, limit_shown, value_shown
from sweetspot.report.document import Cell, Column, Marked, Table
from sweetspot.report.sentences import Sentence, joined, say


def legality_table(bats: Sequence[ComparedBat]) -> Table:
    """Return the verdict on every bat that was held against rules, and which rules make it or stay open."""
    columns = [Column("bat"), Column("rules of"), Column("verdict"), Column("why")]
    rows: list[list[Cell]] = [
        [one.label, _leagues(tested), _verdict(tested), _reason(tested)]
        for one in bats
        if (tested := one.certificate) is not None
    ]
    return Table("By the rules, as the model sees it; no certificate", columns, rows, name="compared")


def _verdict(tested: CertifyAnswer) -> Marked:
    """Return pass, fail or not decidable for all rules together, marked where it is sure."""
    word = tested.verdict
    if word is Verdict.NOT_DECIDABLE:
        return Marked(word.value, "")
    return Marked(word.value, MARKS[word]) if tested.sure else Marked(f"{word}{NOT_SURE}", "")


def _reason(tested: CertifyAnswer) -> Sentence:
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

"""The cases as rows for the command line and as Markdown for the docs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from math import isfinite
from typing import Any

from sweetspot.validation.cases import EVIDENCE, TAGS, Case, Result
from sweetspot.validation.run import results


def rows(verdicts: Sequence[Result] | None = None) -> list[dict[str, Any]]:
    """Return every case as a flat dictionary with all its fields and its ``status``; computes them unless given.

    A computed value that is no number becomes None, which JSON can say.
    """
    return [
        {
            **asdict(result),
            "computed": result.computed if isfinite(result.computed) else None,
            "status": result.status,
            "passed": result.passed,
        }
        for result in (results() if verdicts is None else verdicts)
    ]


def short_rows(verdicts: Sequence[Result] | None = None) -> list[dict[str, str]]:
    """Return the columns that fit a terminal: source, case, printed, computed, allowed, evidence, status."""
    return [
        {
            "source": result.source,
            "case": f"{result.name}: {result.quantity}",
            "printed": _with_unit(result.printed, result.unit),
            "computed": number_words(result),
            "allowed": result.tolerance,
            "evidence": result.evidence,
            "status": result.status,
        }
        for result in (results() if verdicts is None else verdicts)
    ]


def summary(verdicts: Sequence[Result]) -> list[dict[str, Any]]:
    """Return, for every kind of evidence, how many rows there are, hold, miss as explained, and fail."""
    return [
        {
            "evidence": evidence,
            "rows": len(group),
            "hold": sum(result.passed and not result.expected_miss for result in group),
            "explained_misses": sum(result.passed and bool(result.expected_miss) for result in group),
            "fail": sum(not result.passed for result in group),
        }
        for evidence in EVIDENCE
        for group in [[result for result in verdicts if result.evidence == evidence]]
    ]


def headline(verdicts: Sequence[Result]) -> str:
    """Return the one sentence that says how well the model predicts bats, and what the other rows are."""
    bats, *rest = summary(verdicts)
    others = ", ".join(f"{part['evidence']} {part['rows']}" for part in rest)
    failed = sum(part["fail"] for part in (bats, *rest))
    return (
        f"{bats['rows']} predictions about bats: {bats['hold']} hold, {bats['explained_misses']} miss as explained, "
        f"{bats['fail']} fail. Counted apart: {others}. " + (f"{failed} rows fail." if failed else "No row fails.")
    )


def number_words(result: Result) -> str:
    """Return the computed value with as many digits as a reader can use."""
    digits = 5 if result.kind == "identity" else 4
    return f"{result.computed:.{digits}g}"


def markdown(case: Case, verdicts: Sequence[Result]) -> str:
    """Return one source as a Markdown section: what was measured, the table, reasons, misses, what was left out."""
    chosen = [result for result in verdicts if result.source == case.source]
    lines = [f"## {case.title}", "", f"Source: `{case.source}`. {case.measured}", ""]
    lines += [f"Axes and signs: {case.axes}", ""]
    lines += ["| | case | printed | computed | allowed | kind | read | evidence | verdict |", "|-" * 9 + "|"]
    for number, result in enumerate(chosen, start=1):
        short = short_rows([result])[0]
        cells = [str(number), *(short[key] for key in ("case", "printed", "computed", "allowed"))]
        cells += [result.kind, TAGS[result.tag], result.evidence, result.status]
        lines.append("| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |")
    lines += ["", "Reasons:", ""]
    lines += [f"- {', '.join(numbers)}: {text}" for text, numbers in _shared_texts(chosen).items()]
    if case.left_out:
        lines += ["", "Left out:", "", *(f"- {text}" for text in case.left_out)]
    return "\n".join(lines) + "\n"


def _shared_texts(verdicts: Sequence[Result]) -> dict[str, list[str]]:
    """Return reason, comment and explanation of the rows, each text once with the numbers of its rows."""
    texts: dict[str, list[str]] = {}
    for number, result in enumerate(verdicts, start=1):
        expected = f"Expected of this model: {result.expected_of_us} {result.unit}".strip() + "."
        explained = f"**Why it misses:** {result.expected_miss} {expected}" if result.expected_miss else ""
        text = " ".join(part.strip() for part in (result.reason, result.comment, explained) if part)
        texts.setdefault(" ".join(text.split()), []).append(str(number))
    return texts


def _with_unit(text: str, unit: str) -> str:
    return text if not unit or unit in text else f"{text} {unit}"

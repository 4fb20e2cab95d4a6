"""The rules held against a bat or a paddle, as a table and as reasons."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sweetspot.answers.certify import RuleCheck
from sweetspot.reports.certification.limits_shown import limit_shown, marked_verdict, value_shown
from sweetspot.reports.document import Block, Bullets, Cell, Cited, Column, Table

MANY = 14
"""Rules from which on a printed table is set smaller."""


def applying(checks: Sequence[RuleCheck]) -> list[RuleCheck]:
    """Return the rules that apply to what was tested."""
    return [check for check in checks if check.outcome.applies]


def rules_table(
    checks: Sequence[RuleCheck], value: Callable[[RuleCheck], Cell] | None = None, *, sources: bool = True
) -> Table:
    """Return the rules with their verdicts, values, limits and margins.

    Parameters
    ----------
    value : how the value of a rule is shown; None: as `value_shown`.
    sources : whether the last column says where each rule stands.
    """
    alone = only_league(checks)
    columns = [Column(name) for name in ("league", "rule", "verdict") if name != "league" or alone is None]
    columns += [Column(name, right=True) for name in ("value", "limit", "margin")]
    rows: list[list[Cell]] = [
        [
            *([check.league] if alone is None else []),
            check.title,
            marked_verdict(check.outcome),
            value_shown(check.quantity, check.value) if value is None else value(check),
            limit_shown(check),
            value_shown(check.quantity, check.margin, sign=True),
            *([Cited(check.source, str(check.year or ""), _how_read(check))] if sources else []),
        ]
        for check in checks
    ]
    name = "certified rules" if len(rows) < MANY else "certified rules many"
    heading = "Rules" if alone is None else f"Rules of {alone}"
    return Table(heading, [*columns, *([Column("source")] if sources else [])], rows, name=name)


def _how_read(check: RuleCheck) -> str:
    return "" if check.reading == "primary" else check.reading


def only_league(checks: Sequence[RuleCheck]) -> str | None:
    """Return the league's name, if all rules are of one."""
    names = {check.league_name for check in checks}
    return names.pop() if len(names) == 1 else None


def listed(lines: Sequence[str]) -> list[Block]:
    """Return lines as a list; nothing where there is none."""
    return [Bullets(lines)] if lines else []


def reasons(checks: Sequence[RuleCheck]) -> list[str]:
    """Return why a rule is not a plain pass or fail."""
    alone = only_league(checks)
    return [
        f"{check.title}{'' if alone else f' ({check.league_name})'}: {check.outcome.words}: {check.reason}."
        for check in checks
        if check.reason
    ]

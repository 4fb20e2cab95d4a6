"""How the model does against published measurements: the rows of the printed page."""

from __future__ import annotations

from sweetspot.catalog.bats import DEFAULT_BAT
from sweetspot.references import cite
from sweetspot.report.markup import Html, bullets, section, table, text
from sweetspot.validation import Result, Row, sources
from sweetspot.validation.computations import space
from sweetspot.validation.run import judged
from sweetspot.validation.table import shown

ROWS = 14
SLOW = {function.__name__ for function in space.COMPUTATIONS} | {"turned_contact_time"}
"""Computations that a report does not wait for: the speed of a given hit is searched, a league's hits are drawn."""


def published() -> Html:
    """Return a table of published values beside ours; empty when there is nothing to compare."""
    found = chosen()
    if not found:
        return Html("")
    words = Html(
        f"<p>The same model for the catalogue's {text(DEFAULT_BAT)}, beside published numbers that did not go into "
        "it, with the known and explained misses among them; <code>sweetspot validate</code> lists all cases.</p>"
    )
    columns = ("quantity", "published", "computed", "allowed", "verdict")
    compared = table(columns, [_cells(result) for result in found], numbers=(1, 2), name="published")
    why = [
        Html(f"<b>{text(result.quantity[0].upper() + result.quantity[1:])}:</b> {text(result.expected_miss)}")
        for result in found
        if not result.ok and result.expected_miss
    ]
    reasons = Html(f"<h3>Why these miss</h3>\n{bullets(why)}") if why else Html("")
    return section("Beside published values", words, compared, reasons, name="published")


def _cells(result: Result) -> tuple[str, str, str, str, str]:
    unit = f" {result.unit}" if result.unit else ""
    worded = not any(letter.isdigit() for letter in result.printed)
    printed = result.printed if worded or result.unit in result.printed else result.printed + unit
    source = f'<abbr title="{text(cite(result.source))}">{text(result.source)}</abbr>'
    named = Html(f"{text(result.quantity)} <small>{text(result.name)}, {source}</small>")
    verdict = Html(f'<span class="{"hit" if result.ok else "missed"}">{text(result.status)}</span>')
    return named, printed, shown(result) + unit, result.tolerance, verdict


def chosen() -> list[Result]:
    """Return the known misses, then in turn one row from every source until the table is full."""
    cases = sources()
    missed = [(row, case) for case in cases for row in case.rows if row.expected_miss and _predicts(row)]
    queues = [[(row, case) for row in case.rows if _tells(row)] for case in cases]
    turns = max(map(len, queues), default=0)
    others = [queue[turn] for turn in range(turns) for queue in queues if turn < len(queue)]
    return [judged(row, case) for row, case in [*others[: max(0, ROWS - len(missed))], *missed]]


def _predicts(row: Row) -> bool:
    """Say whether a row predicts something about bats, soon enough for a report."""
    return row.evidence == "prediction about bats" and row.computation not in SLOW


def _tells(row: Row) -> bool:
    """Say whether a row is a measured number of the one bat shown here, not fitted to and not a known miss."""
    number = row.kind in ("quantitative", "band") and any(letter.isdigit() for letter in row.printed)
    return _predicts(row) and number and not row.expected_miss and row.inputs.get("bat") == DEFAULT_BAT

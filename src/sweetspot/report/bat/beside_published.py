"""How the model does against published measurements of the same sport: the rows of the page."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import canonical
from sweetspot.catalog.sports import DEFAULT_SPORT
from sweetspot.report.document import Block, Bullets, Cell, Column, Linked, Marked, Paragraph, Section, Table
from sweetspot.validation import Result, Row, sources
from sweetspot.validation.computations import space
from sweetspot.validation.run import judged
from sweetspot.validation.table import shown

ROWS = 14
SLOW = {function.__name__ for function in space.COMPUTATIONS} | {"turned_contact_time", "restitution_of_share"}
"""Computations that a report does not wait for: the speed of a given hit is searched, a league's hits are drawn, many
walls are tried."""


def published_section(results: Sequence[Result]) -> list[Block]:
    """Return a section of published values beside ours; none when there is nothing to compare."""
    if not results:
        return []
    words = (
        "The same model for implements of this sport in the catalogue, beside published numbers that did not go into "
        "it, known and explained misses among them; `sweetspot validate` lists all cases."
    )
    columns = [Column("quantity"), Column("source"), Column("published", right=True), Column("computed", right=True),
               Column("allowed"), Column("verdict")]  # fmt: skip
    why = [
        f"{result.quantity[0].upper() + result.quantity[1:]}: {result.expected_miss}"
        for result in results
        if not result.ok and result.expected_miss
    ]
    reasons: list[Block] = [Section("why-miss", "Why these miss", [Bullets(why)], level=3)] if why else []
    table = Table("", columns, [_cells(result) for result in results], name="published")
    return [Section("published", "Beside published values", [Paragraph(words), table, *reasons])]


def _cells(result: Result) -> list[Cell]:
    unit = f" {result.unit}" if result.unit else ""
    worded = not any(letter.isdigit() for letter in result.printed)
    printed = result.printed if worded or result.unit in result.printed else result.printed + unit
    return [
        result.quantity, Linked(result.source, f"#source-{result.source}", result.name), printed, shown(result) + unit,
        result.tolerance, Marked(result.status, "hit" if result.ok else "missed"),
    ]  # fmt: skip


def chosen(sport: str) -> list[Result]:
    """Return in turn one row from every source about a sport's implements, and known misses for at most half of it."""
    own = [[(row, case) for row in case.rows if _predicts(row) and sport in _sports(row)] for case in sources()]
    missed = [pair for queue in own for pair in queue if pair[0].expected_miss][: ROWS // 2]
    queues = [[pair for pair in queue if _tells(pair[0])] for queue in own]
    turns = max(map(len, queues), default=0)
    others = [queue[turn] for turn in range(turns) for queue in queues if turn < len(queue)]
    return [judged(row, case) for row, case in [*others[: ROWS - len(missed)], *missed]]


def _sports(row: Row) -> set[str]:
    """Return the sports of the catalogue's implements that a row names."""
    tables = {canonical(key): table for key, table in implement_tables().items()}
    named = [canonical(text) for text in row.inputs.values() if isinstance(text, str)]
    return {canonical(tables[name].get("sport", DEFAULT_SPORT)) for name in named if name in tables}


def _predicts(row: Row) -> bool:
    """Say whether a row predicts something about bats, soon enough for a report."""
    return "prediction" in row.evidence and row.computation not in SLOW


def _tells(row: Row) -> bool:
    """Say whether a row is a measured number, and not a known miss."""
    number = row.kind in ("quantitative", "band") and any(letter.isdigit() for letter in row.printed)
    return number and not row.expected_miss

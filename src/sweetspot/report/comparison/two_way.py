"""A what-if table of one bat as a document."""

from __future__ import annotations

from typing import Any

from sweetspot.analysis.two_way import Answers, TwoWay
from sweetspot.report.document import Bullets, Document
from sweetspot.report.grid.document import grid_document
from sweetspot.report.grid.values import Grid, varied
from sweetspot.report.json_shapes import as_columns, cleaned
from sweetspot.report.quantities import key
from sweetspot.report.sentences import Sentence, say

REASONS_SHOWN = 5


def two_way_document(table: TwoWay, answer: str) -> Document:
    """Return one answer as a table, and below it the reasons of cells that have none.

    Parameters
    ----------
    answer : name of a field of `Answers`.
    """
    down, across = ((axis.variation, axis.values) for axis in (table.rows, table.columns))
    grid = Grid(answer, down, across, table.values(answer))
    return grid_document(
        grid, name="compare", kind="What if", data=_json(table), rows=as_columns(_rows(table)),
        notes=[Bullets(_reasons(table))],
    )  # fmt: skip


def _json(table: TwoWay) -> dict[str, Any]:
    """Return both axes, every answer as a list of rows (None where a cell failed), and why cells failed."""
    return cleaned(
        {
            "rows": {key(table.rows.variation): list(table.rows.values)},
            "columns": {key(table.columns.variation): list(table.columns.values)},
            "answers": {key(name): table.values(name) for name in Answers.__dataclass_fields__},
            "failures": [{"row": cell.row, "column": cell.column, "reason": cell.reason} for cell in table.failures],
        }
    )


def _rows(table: TwoWay) -> list[dict[str, Any]]:
    """Return one row per cell with what was varied, every answer and the reason of a failed one."""
    rows = []
    names = [
        name for name in Answers.__dataclass_fields__ if name not in (table.rows.variation, table.columns.variation)
    ]
    for cells in table.cells:
        for cell in cells:
            row: dict[str, Any] = {
                key(table.rows.variation): table.rows.values[cell.row],
                key(table.columns.variation): table.columns.values[cell.column],
            }
            row |= {key(name): getattr(cell.answers, name, None) for name in names}
            rows.append(row | {"reason": cell.reason})
    return rows


def _reasons(table: TwoWay) -> list[Sentence]:
    failed = table.failures
    lines = [
        say(
            "at {row}, {column}: {reason}", row=varied(table.rows.variation, table.rows.values[cell.row]),
            column=varied(table.columns.variation, table.columns.values[cell.column]), reason=cell.reason,
        )
        for cell in failed[:REASONS_SHOWN]
    ]  # fmt: skip
    more = len(failed) - len(lines)
    return [*lines, say("and {more} more cells; --format json has every reason", more=more)] if more else lines

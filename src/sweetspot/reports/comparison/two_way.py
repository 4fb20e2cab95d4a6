"""A what-if table of one bat as a document."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

from sweetspot.analysis.two_way import Cell as CellOfTable
from sweetspot.analysis.two_way import TableCell, TwoWay
from sweetspot.answers.records import plain_data
from sweetspot.reports.document import Bullets, Cell, Column, Document, Paragraph, Table
from sweetspot.reports.grid.document import grid_document
from sweetspot.reports.grid.grid import Grid, varied
from sweetspot.reports.json_shapes import as_columns
from sweetspot.reports.quantities import QUANTITIES, key
from sweetspot.reports.sentences import Sentence, Slot, joined, say

REASONS_SHOWN = 5
HEADINGS = {"exit_speed": "exit speed", "collision_efficiency": "q", "bbcor": "BBCOR in play", "bat_speed": "bat speed",
            "mass": "mass", "balance_point": "balance", "moi": "MOI", "frequency": "f1"}  # fmt: skip
"""Short names of answers, where each has a column."""
BBCOR_IS = "BBCOR in play is at this swing's closing speed; `sweetspot certify` computes that of the test."


def two_way_document(table: TwoWay, answer: str, bat: str = "") -> Document:
    """Return one answer as a table, and below it the reasons of cells that have none; of rows alone every answer.

    Parameters
    ----------
    answer : name of a field of `TableCell`.
    bat : whose table it is.
    """
    down = (table.rows.variation, table.rows.values)
    across = None if table.columns is None else (table.columns.variation, table.columns.values)
    grid = Grid(answer, down, across, table.values(answer))
    document = grid_document(
        grid, name="compare", kind="What if", data=_json(table), rows=as_columns(_rows(table)),
        notes=[Bullets(_reasons(table))] if table.failures else [], title=bat,
    )  # fmt: skip
    return (
        document
        if across
        else replace(document, blocks=[_every_answer(table), Paragraph(BBCOR_IS, "note"), *document.blocks[1:]])
    )


def _every_answer(table: TwoWay) -> Table:
    """Return every answer of every row: variants of a bat side by side."""
    name = table.rows.variation
    names = [dataclass_field for dataclass_field in TableCell.__dataclass_fields__ if dataclass_field != name]
    columns = [Column(name.replace("_", " "), QUANTITIES[name].scale)]
    columns += [Column(HEADINGS[each], QUANTITIES[each].scale) for each in names]
    rows: list[list[Cell]] = [
        [varied(name, value), *(getattr(cell.answers, each, math.nan) for each in names)]
        for value, (cell,) in zip(table.rows.values, table.cells, strict=True)
    ]
    return Table("", columns, rows)


def _json(table: TwoWay) -> dict[str, Any]:
    """Return both axes, every answer as a list of rows (None where a cell failed), and why cells failed."""
    return dict(
        plain_data(
            {
                "rows": {key(table.rows.variation): list(table.rows.values)},
                "columns": table.columns and {key(table.columns.variation): list(table.columns.values)},
                "answers": {key(name): table.values(name) for name in TableCell.__dataclass_fields__},
                "failures": [
                    {"row": cell.row, "column": cell.column, "reason": cell.reason} for cell in table.failures
                ],
            }
        )
    )


def _rows(table: TwoWay) -> list[dict[str, Any]]:
    """Return one row per cell with what was varied, every answer and the reason of a failed one."""
    rows = []
    sides = [table.rows.variation, *([table.columns.variation] if table.columns else [])]
    names = [name for name in TableCell.__dataclass_fields__ if name not in sides]
    for cells in table.cells:
        for cell in cells:
            row: dict[str, Any] = {key(table.rows.variation): table.rows.values[cell.row]}
            if table.columns is not None:
                row[key(table.columns.variation)] = table.columns.values[cell.column]
            row |= {key(name): getattr(cell.answers, name, None) for name in names}
            rows.append(row | {"reason": cell.reason})
    return rows


def _reasons(table: TwoWay) -> list[Sentence]:
    failed = table.failures
    lines = [
        say("at {where}: {reason}", where=joined(_where(table, cell), ", "), reason=cell.reason)
        for cell in failed[:REASONS_SHOWN]
    ]
    more = len(failed) - len(lines)
    return [*lines, say("and {more} more cells; --format json has every reason", more=more)] if more else lines


def _where(table: TwoWay, cell: CellOfTable) -> list[Slot]:
    where = [varied(table.rows.variation, table.rows.values[cell.row])]
    if table.columns is not None:
        where.append(varied(table.columns.variation, table.columns.values[cell.column]))
    return where

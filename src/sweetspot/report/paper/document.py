"""The paper's chain as a document: each statement, the paper's number, ours, and the full model's."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.answers.paper import PaperAnswer
from sweetspot.paper.formulas import Row, Value
from sweetspot.report.document import Cell, Column, Document, Table
from sweetspot.report.json_shapes import as_columns
from sweetspot.units.text import GROUPED_FROM, grouped


def paper_document(answer: PaperAnswer) -> Document:
    """Return the paper's chain as a document."""
    data = answer.to_dict()
    return Document(
        name="paper",
        title="The paper's chain",
        kind="Paper",
        blocks=[paper_table(answer.rows)],
        data=data,
        rows=as_columns(data["rows"]),
    )


def paper_table(rows: Sequence[Row], title: str = "") -> Table:
    """Return the paper's chain, each statement with its comment below it; units are those of the paper."""
    columns = [Column(name) for name in ("eq.", "statement", "paper", "computed", "full model", "unit")]
    return Table(title, columns, [_cells(row) for row in rows], name="paper")


def _cells(row: Row) -> list[Cell]:
    numbers = [_shown(value) for value in (row.paper, row.computed, row.full_model)]
    return [row.equation, f"{row.quantity}\n{row.comment}\n", *numbers, row.unit]


def _shown(value: Value) -> Cell:
    if value is None or isinstance(value, str):
        return value
    text = f"{value:.5g}"
    return grouped(float(text)) if abs(float(text)) >= GROUPED_FROM else text

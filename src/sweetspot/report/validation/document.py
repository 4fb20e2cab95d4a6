"""Published cases as a document: printed and computed, what is allowed, what each row is worth."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot import validation
from sweetspot.report.document import Cell, Column, Document, Marked, Paragraph, Table
from sweetspot.report.json_shapes import as_columns
from sweetspot.validation import Result


def validation_document(results: Sequence[Result]) -> Document:
    """Return results as a document; it has not passed when a row misses without an explanation."""
    rows, headline = validation.rows(results), validation.headline(results)
    short = validation.short_rows(results)
    columns = [Column(name) for name in short[0]]
    cells: list[list[Cell]] = [
        [*[*row.values()][:-1], Marked(result.status, "hit" if result.ok else "missed")]
        for row, result in zip(short, results, strict=True)
    ]
    return Document(
        name="validate", title="Published cases", kind="Validation",
        blocks=[Table("", columns, cells, name="published"), Paragraph(headline)],
        data={"headline": headline, "summary": validation.summary(results), "rows": rows},
        rows=as_columns(rows), passed=validation.passed(results),
    )  # fmt: skip

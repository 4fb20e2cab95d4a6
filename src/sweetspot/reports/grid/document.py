"""A grid of answers as a document."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sweetspot.reports.document import Block, Document, Picture, drawn
from sweetspot.reports.grid.grid import Grid


def grid_document(
    grid: Grid,
    *,
    name: str,
    kind: str,
    data: Mapping[str, Any],
    rows: Mapping[str, Sequence[Any]],
    notes: Sequence[Block] = (),
    title: str = "",
) -> Document:
    """Return a grid as a document: its table, ``notes``, its picture; ``title`` says what it is about."""
    picture = Picture("grid", drawn("sweetspot.reports.grid.picture:grid_figure", grid, title=title), label=grid.title)
    return Document(
        name=name, title=title, kind=kind, blocks=[grid.table(), *notes, picture], data=data, rows=rows, drawing=picture
    )

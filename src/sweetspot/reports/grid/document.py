"""A grid of answers as a document."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from sweetspot.reports.document import Block, Document, Picture
from sweetspot.reports.grid.grid import Grid
from sweetspot.reports.quantities import Reader


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
    picture = Picture("grid", lambda reading: _drawn(grid, title, reading), label=grid.title)
    return Document(
        name=name, title=title, kind=kind, blocks=[grid.table(), *notes, picture], data=data, rows=rows, drawing=picture
    )


def _drawn(grid: Grid, title: str, reading: Reader) -> Any:
    from sweetspot.reports.grid.picture import grid_figure

    return grid_figure(grid, reading, title)

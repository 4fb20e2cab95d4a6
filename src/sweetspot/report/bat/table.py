"""Any list of equal rows as a table for a terminal."""

from __future__ import annotations

from typing import Any

from rich.table import Table
from rich.text import Text


def names_table(rows: list[dict[str, Any]], title: str) -> Table:
    """Return any list of equal rows as a table."""
    table = Table(title=title, title_justify="left", title_style="bold", header_style="bold", box=None, pad_edge=False)
    for number, column in enumerate(rows[0]):
        table.add_column(column, no_wrap=number == 0 and len(rows[0]) < 7)
    for row in rows:
        table.add_row(*(Text(str(value)) for value in row.values()))
    return table

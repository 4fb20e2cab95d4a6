"""A file of swings as a short CSV text: only the columns that mean something, each under its own heading."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from sweetspot.errors import InputError
from sweetspot.player.columns import columns_of
from sweetspot.player.swing_table import open_swings
from sweetspot.tables.vocabulary import simplified, systems


def narrow_csv(path: Path) -> str:
    """Return a CSV text that is read as the file is.

    Rows stand in the same lines, those of Parquet one line lower, under the headings; too short and too long ones stay
    so. What tells a measuring system's files from others stays as empty columns.

    Raises
    ------
    InputError
        when the file cannot be read, or has no column of swings.
    """
    table = open_swings(path)
    if not table.headings:
        raise InputError(f"{path} is empty; it needs a line of column names, for example bat_speed_mph, exit_speed_mph")
    columns = columns_of(table.headings, file_name=str(path))
    kept = [(one.heading, one.index) for one in table.narrowed(columns).columns.values()]
    marks = {name for system in systems() for marks in system.marks for name in marks}
    known = {heading for heading, _ in kept}
    named = [one for one in table.headings if simplified(one) in marks and one.strip() not in known]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    rows, width = table.rows(columns), table.width(columns)
    first = max(2, rows[0][0]) if rows else 2
    text.write("\n" * (first - 2))
    writer.writerow([heading for heading, _ in kept] + named)
    line = rows[0][0] if rows else first
    for number, cells in rows:
        text.write("\n" * (number - line))
        row = [cells[index] if index < len(cells) else "" for _, index in kept] + [""] * len(named)
        writer.writerow([*row[: max(1, len(row) - max(0, width - len(cells)))], *cells[width:]])
        line = number + 1
    return text.getvalue()

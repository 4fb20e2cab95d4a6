"""Rows of tables handed out a part at a time, and read in longer stretches: a file is unpacked in its own large pieces.

A piece of a Parquet file (a row group, its pages) is unpacked whole for every part of it that is asked for, so parts
that are read one by one cost several times what the file does.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass

import polars as pl

from sweetspot.season.table_file import TableFile

CELLS = 5_000_000
"""Numbers and words that are read together: about 50 MB."""
HELD = 2
"""Stretches held at a time: parts are asked for nearly in order, by a few threads."""


class TableReader:
    """Reads tables for parts that are asked for in order, or nearly so, by any number of threads.

    Parameters
    ----------
    tables : to be read.
    part_rows : rows of the parts that will be asked for; a stretch is a multiple of it.
    """

    def __init__(self, tables: Sequence[TableFile], *, part_rows: int) -> None:
        self._tables, self._part_rows = tables, part_rows
        self._held: list[_Stretch] = []
        self._reading = threading.Lock()

    def part(self, number: int, start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
        """Return some rows of a table, columns as they are.

        Parameters
        ----------
        number : of the table, from 0.
        start, count : first row, from 0, and how many.
        headings : of the columns that are wanted; None: all.
        """
        table = self._tables[number]
        last = min(start + count, table.rows)
        with self._reading:
            held = next((one for one in self._held if one.has(number, start, last, headings)), None)
            if held is None:
                held = self._read(number, start, last, headings)
                self._held = [*self._held, held][-HELD:]
        part = held.rows.slice(start - held.start, count)
        return part if headings is None else part.select(headings)

    def _read(self, number: int, start: int, last: int, headings: Sequence[str] | None) -> _Stretch:
        table = self._tables[number]
        width = len(pl.scan_parquet(table.data).collect_schema() if headings is None else headings)
        rows = max(1, CELLS // max(width, 1) // self._part_rows) * self._part_rows
        begin = start // rows * rows
        end = max(begin + rows, last)
        return _Stretch(number, begin, headings is None, table.part(begin, end - begin, headings=headings))


@dataclass(frozen=True)
class _Stretch:
    """Rows of a table from one on, and whether they have all its columns."""

    number: int
    start: int
    whole: bool
    rows: pl.DataFrame

    def has(self, number: int, start: int, last: int, headings: Sequence[str] | None) -> bool:
        if number != self.number or not self.start <= start <= last <= self.start + len(self.rows):
            return False
        return self.whole or (headings is not None and set(headings) <= set(self.rows.columns))

"""Rows of tables handed out a part at a time, and read in longer stretches: a file is unpacked in its own pieces.

A piece of a Parquet file (a row group) is unpacked whole for every part of it that is asked for, so a stretch is some
whole pieces, each of which is read once.
"""

from __future__ import annotations

import threading
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial
from itertools import pairwise

import numpy as np
import polars as pl

from sweetspot.seasons.rows import rows_of
from sweetspot.seasons.table_copies import rows_together
from sweetspot.seasons.table_file import TableFile

CELLS = 5_000_000
"""Numbers and words that are read together: about 50 MB."""
HELD = 2
"""Stretches held at a time: parts are asked for nearly in order, by a few threads."""


class TableReader:
    """Reads tables for parts that are asked for in order, or nearly so, by any number of threads.

    ``part_rows``: rows of the parts that will be asked for, fewer of wide tables by `rows_together`; a stretch of a
    longer row group is a multiple of it.
    """

    def __init__(self, tables: Sequence[TableFile], *, part_rows: int) -> None:
        self._tables, self._part_rows = tables, part_rows
        self._held: list[_Stretch] = []
        self._reading = threading.Lock()

    def part(self, number: int, start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
        """Return some rows of a table, columns as they are.

        ``number``: of the table, from 0. ``start``, ``count``: first row, from 0, and how many. ``headings``: of the
        columns that are wanted; None: all.
        """
        table = self._tables[number]
        width = table.width if headings is None else len(headings)
        rows = rows_together(width, most=self._part_rows)
        edges = _edges(table.row_groups, most=max(1, CELLS // max(width, 1) // rows) * rows)
        first, last = bisect_right(edges, start) - 1, bisect_left(edges, min(start + count, table.rows))
        with self._reading:
            stretches = [self._stretch(number, *ends, headings) for ends in pairwise(edges[first : last + 1])]
        pieces = [
            stretch.rows.slice(max(start - stretch.start, 0), start + count - max(start, stretch.start))
            for stretch in stretches
        ]
        if headings is not None:  # a stretch may have been read for more of them
            pieces = [piece.select(headings) for piece in pieces]
        return pl.concat(pieces)

    def _stretch(self, number: int, start: int, end: int, headings: Sequence[str] | None) -> _Stretch:
        held = next((stretch for stretch in self._held if stretch.has(number, start, end, headings)), None)
        if held is None:
            rows = self._tables[number].part(start, end - start, headings=headings)
            held = _Stretch(number, start, headings is None, rows)
            self._held = [*self._held, held][-HELD:]
        return held


@lru_cache(maxsize=64)
def _edges(groups: tuple[int, ...], *, most: int) -> list[int]:
    """Return the starts of stretches and the end of the last: whole row groups, as many as fit; longer ones in pieces.

    >>> _edges((100, 100, 100), most=220), _edges((500,), most=220)
    ([0, 200, 300], [0, 220, 440, 500])
    """
    edges, end = [0], 0
    for rows in groups:
        if end > edges[-1] and end + rows - edges[-1] > most:
            edges.append(end)
        end += rows
        edges += range(edges[-1] + most, end, most)
    return [*edges, end]


@dataclass(frozen=True)
class _Stretch:
    """Rows of a table from one on, and whether they have all its columns."""

    number: int
    start: int
    whole: bool
    rows: pl.DataFrame

    def between(self, start: int, end: int) -> pl.DataFrame:
        return self.rows.slice(max(start - self.start, 0), end - max(start, self.start))

    def has(self, number: int, start: int, end: int, headings: Sequence[str] | None) -> bool:
        if (number, start, end) != (self.number, self.start, self.start + len(self.rows)):
            return False
        return self.whole or (headings is not None and set(headings) <= set(self.rows.columns))


PART = 65_536
"""Rows that are read together."""


def parts(table: TableFile, *, quantities: Sequence[str], step: int, starts: Sequence[int]) -> Iterator[pl.DataFrame]:
    """Yield some of a table's rows as `rows_of` gives them, a part at a time; as good as drawn, always the same."""
    headings = table.headings.only("exit_speed", *quantities)
    together = all(after - before == PART for before, after in pairwise(starts))
    read = partial(TableReader([table], part_rows=PART).part, 0) if together else table.part
    for first in range(0, len(starts), step):  # few rows of each part: what they mean is made out together
        frames, numbers = [], []
        for start in starts[first : first + step]:
            frame = read(start, PART, headings=[column.heading for column in headings.columns.values()])
            number = np.arange(start, start + len(frame), dtype=np.uint32)
            number = number[number.astype(np.uint64) * np.uint64(7919) % np.uint64(step) == 0]
            frames.append(frame[number.astype(np.int64) - start])
            numbers.append(number)
        number = np.concatenate(numbers)
        if len(number):
            yield rows_of(pl.concat(frames), headings).with_columns(pl.Series("row", number))


def part_of(asked: tuple[TableReader, TableFile, int, Sequence[str]]) -> pl.DataFrame:
    """Return the rows of a table from one on, `PART` at most: reader, table, first row and quantities are asked."""
    reader, table, start, quantities = asked
    headings = table.headings.only(*quantities)
    frame = reader.part(0, start, PART, headings=[column.heading for column in headings.columns.values()])
    return rows_of(frame, headings, first=start)

"""A table in parts: all rows of one, or some as good as drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from itertools import pairwise

import numpy as np
import polars as pl

from sweetspot.season.rows import rows_of
from sweetspot.season.table_file import TableFile
from sweetspot.season.table_reader import TableReader

PART = 65_536
"""Rows that are read together."""


def parts(
    table: TableFile, *, quantities: Sequence[str], step: int, starts: Sequence[int]
) -> Iterator[pl.DataFrame]:  # fmt: skip
    """Yield some of a table's rows as `rows_of` gives them, a part or so at a time; as good as drawn, always the same.

    Parameters
    ----------
    quantities : that are wanted, beside the exit speed.
    step : one row of so many.
    starts : first rows of the parts.
    """
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

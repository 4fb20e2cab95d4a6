"""How many rows of a table are held together, and Parquet files of which that many cannot be had by themselves.

A piece of a Parquet file (a row group) is fetched whole, though packed, for every part of it that is asked for. Where
one is larger than memory should hold, the table is laid out anew once, some columns at a time: in strips, files of a
few columns and all rows, whose row groups are small.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import polars as pl

from sweetspot.numerics.whole_files import written_whole
from sweetspot.season.parquet_footer import footer_of
from sweetspot.season.table_copy import copying

MOST_CELLS = 8_000_000
"""Numbers and words of whole rows that are held together; a season's export has as many in 65,536 rows."""
MOST_PACKED = 200_000_000
"""Bytes of a row group, packed, that are fetched for a part of it; a season's export has as many in 700,000 rows."""
INSTEAD = "or write it with row groups of a few thousand rows, which are read as they are"


def rows_together(width: int, *, most: int) -> int:
    """Return how many rows of a table are worked on together: fewer of wide ones, so that memory holds them.

    Parameters
    ----------
    width : columns.
    most : rows of a usual table.

    >>> rows_together(118, most=65_536), rows_together(5_000, most=65_536)
    (65536, 1600)
    """
    return min(most, max(1, MOST_CELLS // max(width, 1)))


def strips_of(path: Path, *, rows: int, staging: Path) -> tuple[Path, ...]:
    """Return a Parquet file's columns, in order, in files of a few of them; none where its row groups are small enough.

    Parameters
    ----------
    rows : of the table.
    staging : folder where the files go; made if need be.

    Raises
    ------
    InputError
        when the table cannot be read.
    UnwritableError
        when there is no room for the files.
    """
    sizes = footer_of(path).sizes or (path.stat().st_size,)
    if max(sizes) <= MOST_PACKED:
        return ()
    table = pl.scan_parquet(path)
    names = table.collect_schema().names()
    columns, held = rows_together(rows, most=len(names)), rows_together(len(names), most=65_536)
    strips: list[Path] = []
    for first in range(0, len(names), columns):
        strip = staging / f"{path.name}.{len(strips):04d}"
        with copying(path, staging, instead=INSTEAD), written_whole(strip) as file:
            frame = table.select(names[first : first + columns]).collect()
            frame.write_parquet(file, row_group_size=held, compression="lz4", statistics=False)
        strips.append(strip)
    return tuple(strips)


def joined(
    strips: Sequence[Path], start: int, count: int, *, headings: Sequence[str] | None = None
) -> pl.DataFrame:  # fmt: skip
    """Return some rows of a table that lies in strips.

    Parameters
    ----------
    start, count : first row, from 0, and how many.
    headings : of the columns that are wanted; None: all.
    """
    pieces = []
    for strip in strips:
        frame = pl.scan_parquet(strip)
        names = [name for name in frame.collect_schema().names() if headings is None or name in headings]
        if names:
            pieces.append(frame.select(names).slice(start, count).collect())
    rows = pl.concat(pieces, how="horizontal")
    return rows if headings is None else rows.select(headings)

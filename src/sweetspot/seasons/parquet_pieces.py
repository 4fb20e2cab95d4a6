"""The number of rows held together, and Parquet files whose row groups are too large to be read by themselves.

A piece of a Parquet file (a row group) is fetched whole, though packed, for every part of it that is asked for. Where
one is larger than memory should hold, the table is laid out anew once, some columns at a time: in strips, files of a
few columns and all rows, whose row groups are small.
"""

from __future__ import annotations

import csv
import errno
import math
import os
import struct
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import polars as pl

from sweetspot.errors import InputError, UnwritableError, first_line
from sweetspot.numerics.whole_files import refusal, written_whole

MOST_CELLS = 8_000_000
"""Numbers and words of whole rows that are held together; a season's export has as many in 65,536 rows."""
MOST_PACKED = 200_000_000
"""Bytes of a row group, packed, that are fetched for a part of it; a season's export has as many in 700,000 rows."""
INSTEAD = "or write it with row groups of a few thousand rows, which are read as they are"
GROUPS, CHUNKS, UNPACKED, ROWS, PACKED, ABOUT = 4, 1, 2, 3, 6, 3
"""Fields of a footer: row groups; columns of one, its bytes, its rows, its packed bytes; a column's metadata."""
FORM, PATH, STATISTICS, GREATEST, LEAST = 1, 3, 12, 5, 6
"""Fields of the latter: how numbers are held, the heading, and statistics with the greatest and least value."""
FLOATS = {4: "<f", 5: "<d"}
"""Forms of numbers with a point."""


class Footer(NamedTuple):
    """The row groups in the footer of a Parquet file; none where it is not understood.

    Parameters
    ----------
    row_groups : rows of each row group, in order.
    sizes : bytes of each row group, packed where the file tells so, else unpacked.
    ranges : least and greatest number of columns of numbers with a point, where every row group tells of them.
    """

    row_groups: tuple[int, ...] = ()
    sizes: tuple[int, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = {}


def footer_of(path: Path) -> Footer:
    """Return the sizes and ranges of the row groups in a Parquet file's footer, which polars does not report."""
    with path.open("rb") as file:
        length = file.seek(0, os.SEEK_END)
        file.seek(max(0, length - 8))
        end = file.read()
        size = int.from_bytes(end[:4], "little")
        if end[4:] != b"PAR1" or size > length - 8:
            return Footer()
        file.seek(length - 8 - size)
        content = file.read(size)
    try:
        return _footer(_CompactReader(content).structure()[GROUPS])
    except (LookupError, TypeError, AttributeError, struct.error, UnicodeDecodeError, RecursionError):
        return Footer()  # it stops in the middle, or is none


def _footer(groups: list[dict[int, Any]]) -> Footer:
    ends: dict[str, list[tuple[float, ...]]] = {}
    for group in groups:
        for column in (chunk[ABOUT] for chunk in group[CHUNKS]):
            statistics = column.get(STATISTICS, {})
            least, greatest = statistics.get(LEAST), statistics.get(GREATEST)
            if least and greatest and column[FORM] in FLOATS:
                both = tuple(struct.unpack(FLOATS[column[FORM]], end)[0] for end in (least, greatest))
                if all(map(math.isfinite, both)):
                    ends.setdefault(b".".join(column[PATH]).decode(), []).append(both)
    return Footer(
        tuple(group[ROWS] for group in groups),
        tuple(group.get(PACKED, group[UNPACKED]) for group in groups),
        {
            name: (min(least for least, _ in pairs), max(most for _, most in pairs))
            for name, pairs in ends.items()
            if len(pairs) == len(groups)
        },
    )


class _CompactReader:
    """Values in Thrift's compact protocol, read from the first byte on; structures become dictionaries by field."""

    def __init__(self, content: bytes) -> None:
        self._content, self._at = content, 0

    def _byte(self) -> int:
        self._at += 1
        return self._content[self._at - 1]

    def _bytes(self, count: int) -> bytes:
        self._at += count
        return self._content[self._at - count : self._at]

    def _number(self) -> int:
        value, shift = 0, 0
        while (byte := self._byte()) & 0x80:
            value, shift = value | (byte & 0x7F) << shift, shift + 7
        return value | byte << shift

    def _signed(self) -> int:
        number = self._number()
        return number >> 1 ^ -(number & 1)

    def structure(self) -> dict[int, Any]:
        field, fields = 0, {}
        while head := self._byte():
            field = field + (head >> 4) if head >> 4 else self._signed()
            fields[field] = self._value(head & 15)
        return fields

    def _value(self, kind: int, *, listed: bool = False) -> Any:
        if kind in (9, 10, 11, 12):
            return self._several(kind)
        if kind in (7, 8):  # a number with a point, and bytes
            return self._bytes(8 if kind == 7 else self._number())
        if kind <= 3:  # true and false, whose kind is their value in a field; and one byte
            return self._byte() if listed or kind == 3 else kind
        return self._signed()

    def _several(self, kind: int) -> Any:
        if kind == 12:
            return self.structure()
        if kind == 11:
            count = self._number()
            kinds = self._byte() if count else 0
            return [self._value(half, listed=True) for _ in range(count) for half in (kinds >> 4, kinds & 15)]
        head = self._byte()
        count = head >> 4 if head >> 4 < 15 else self._number()
        return [self._value(head & 15, listed=True) for _ in range(count)]


FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EPERM}
"""Errors of a system that takes no file, or no more of it."""


@contextmanager
def copying(path: Path, staging: Path, *, instead: str = "or give Parquet, which is read as it is") -> Iterator[None]:
    """Say in a line of our own what is wrong with a table, or with the folder that it is copied to.

    Parameters
    ----------
    path : of the table.
    staging : the folder.
    instead : what else than making room would do.

    Raises
    ------
    InputError
        when the table cannot be read.
    UnwritableError
        when there is no room for the copy; no other table would find any.
    """
    try:
        yield
    except (pl.exceptions.PolarsError, csv.Error, OSError, EOFError, zlib.error) as error:
        refused = refusal(error)
        if refused is not None and refused[0] in FULL:
            raise UnwritableError(
                f"{path} is copied to {staging} to be read, and that cannot be written: {refused[1]}; "
                f"make room there, choose another place, {instead}"
            ) from None
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None


def rows_together(width: int, *, most: int) -> int:
    """Return the number of rows of a table that are processed together: fewer of wide ones, so that memory holds them.

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


def joined(strips: Sequence[Path], start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
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

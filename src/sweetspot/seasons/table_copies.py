"""Copies of tables that are read in pieces: CSV turned into Parquet, and Parquet whose row groups are too large.

Of a CSV table every line that is a row is copied, columns with the types that all lines have. A row group of a Parquet
file is fetched whole, though packed, for every part of it that is asked for; where one is larger than memory should
hold, the table is laid out anew once, some columns at a time: in strips, files of a few columns and all rows.
"""

from __future__ import annotations

import csv
import errno
import os
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.errors import InputError, UnwritableError, first_line
from sweetspot.numerics.whole_files import refusal, written_whole
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.rows import ABSENT
from sweetspot.tables.headings import GivenColumns, Headings
from sweetspot.tables.text_encoding import TextEnds, require_no_more_cells, separator_of
from sweetspot.tables.vocabulary import KNOWN_UNITS

MOST_CELLS = 8_000_000
"""Numbers and words of whole rows that are held together; a season's export has as many in 65,536 rows."""
MOST_PACKED = 200_000_000
"""Bytes of a row group, packed, that are fetched for a part of it; a season's export has as many in 700,000 rows."""
INSTEAD = "or write it with row groups of a few thousand rows, which are read as they are"
GROUPS, UNPACKED, ROWS, PACKED = 4, 2, 3, 6
"""Fields of a footer: row groups; bytes of one, its rows, its packed bytes."""
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EPERM}
"""Errors of a system that takes no file, or no more of it."""
PROBE = 1 << 20
"""Bytes written to learn whether the system takes more, where the writer of tables does not say what it refused."""
SUMMARIES = {"total", "totals", "grand total", "average", "averages", "avg", "mean", "median"}
"""Words in the first column, or in place of a day or batter, of lines that spreadsheets put below the balls."""
NOTHING, BESIDE = "nothing", "beside"
LEFT_OUT = {
    NOTHING: "blank lines, and such with nothing in any column that is understood",
    BESIDE: "headings once more, units, totals and means",
}
"""Why a line of a CSV file is no row of its table."""
ALL_LINES = {"infer_schema_length": None}
"""That types are those of."""
BEGUN = 10_000
"""Lines whose types are tried for all lines; to look at all of them first takes twice as long as to read them."""
PIECE = 32_768
"""Rows of a piece of the copy, fewer of wide tables."""
PADDED, PADDED_LINES = r"^[+-]?0\d", 1000
"""How numbers begin that are names, and lines in which they are looked for: 007 stays what it is."""


class RowGroup(NamedTuple):
    """A piece of a Parquet file: its rows, and its bytes, packed where the file tells so."""

    rows: int
    size: int


def row_groups_of(path: Path) -> tuple[RowGroup, ...]:
    """Return the row groups in a Parquet file's footer, which polars does not report; none where it is not read."""
    with path.open("rb") as file:
        length = file.seek(0, os.SEEK_END)
        file.seek(max(0, length - 8))
        end = file.read()
        size = int.from_bytes(end[:4], "little")
        if end[4:] != b"PAR1" or size > length - 8:
            return ()
        file.seek(length - 8 - size)
        content = file.read(size)
    try:
        groups = _structure(iter(content))[GROUPS]
        return tuple(RowGroup(group[ROWS], group.get(PACKED, group[UNPACKED])) for group in groups)
    except (LookupError, TypeError, AttributeError, StopIteration, RuntimeError):
        return ()  # it stops in the middle, or is none


def _structure(content: Iterator[int]) -> dict[int, Any]:
    """Return the values of a structure in Thrift's compact protocol, by field."""
    field, fields = 0, {}
    while head := next(content):
        field = field + (head >> 4) if head >> 4 else _signed(content)
        # true and false are a kind each, and have no byte where they are a field
        fields[field] = head & 15 if head & 15 <= 2 else _value(content, head & 15)
    return fields


def _value(content: Iterator[int], kind: int) -> Any:
    if kind == 12:
        return _structure(content)
    if kind == 11:
        count = _number(content)
        kinds = next(content) if count else 0
        return [_value(content, half) for _ in range(count) for half in (kinds >> 4, kinds & 15)]
    if kind in (9, 10):
        head = next(content)
        return [_value(content, head & 15) for _ in range(head >> 4 if head >> 4 < 15 else _number(content))]
    if kind in (7, 8):  # a number with a point, and bytes: neither is asked for
        return list(islice(content, 8 if kind == 7 else _number(content)))
    return next(content) if kind <= 3 else _signed(content)


def _number(content: Iterator[int]) -> int:
    value, shift = 0, 0
    while (byte := next(content)) & 0x80:
        value, shift = value | (byte & 0x7F) << shift, shift + 7
    return value | byte << shift


def _signed(content: Iterator[int]) -> int:
    number = _number(content)
    return number >> 1 ^ -(number & 1)


@contextmanager
def copying(path: Path, staging: Path, *, instead: str = "or give Parquet, which is read as it is") -> Iterator[None]:
    """Say in a line of our own what is wrong with a table, or with the folder that it is copied to."""
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


def _written(rows: pl.LazyFrame, target: Path, *, pieces: int) -> None:
    """Write rows in row groups of so many; where polars does not name what the system refused, the system does."""
    with written_whole(target) as file:
        try:
            rows.sink_parquet(file, row_group_size=pieces, compression="lz4", statistics=False)
        except pl.exceptions.PolarsError as error:
            if refusal(error) is None:
                file.seek(0, os.SEEK_END)
                file.write(bytes(PROBE))
                file.flush()
            raise


def rows_together(width: int, *, most: int) -> int:
    """Return the number of rows of a table that are processed together: fewer of wide ones, so that memory holds them.

    >>> rows_together(118, most=65_536), rows_together(5_000, most=65_536)
    (65536, 1600)
    """
    return min(most, max(1, MOST_CELLS // max(width, 1)))


def strips_of(path: Path, *, rows: int, staging: Path) -> tuple[Path, ...]:
    """Return a Parquet file's columns, in order, in files of a few each; none where its row groups are small enough."""
    sizes = [group.size for group in row_groups_of(path)] or [path.stat().st_size]
    if max(sizes) <= MOST_PACKED:
        return ()
    table = pl.scan_parquet(path)
    names = table.collect_schema().names()
    columns, pieces = rows_together(rows, most=len(names)), rows_together(len(names), most=65_536)
    strips: list[Path] = []
    for first in range(0, len(names), columns):
        strips.append(staging / f"{path.name}.{len(strips):04d}")
        with copying(path, staging, instead=INSTEAD):
            _written(table.select(names[first : first + columns]), strips[-1], pieces=pieces)
    return tuple(strips)


def joined(strips: Sequence[Path], start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
    """Return some rows of a table that lies in strips: so many from one on, of some columns or all."""
    pieces = []
    for strip in strips:
        frame = pl.scan_parquet(strip)
        names = [name for name in frame.collect_schema().names() if headings is None or name in headings]
        if names:
            pieces.append(frame.select(names).slice(start, count).collect())
    rows = pl.concat(pieces, how="horizontal")
    return rows if headings is None else rows.select(headings)


@dataclass(frozen=True)
class CsvCopy:
    """A copy of a CSV table.

    ``headings``: what its columns mean. ``left_out``: lines that are no rows, by why (`LEFT_OUT`). ``before``: for each
    of them, how many rows stand above it, in order.
    """

    headings: Headings
    rows: int
    left_out: Mapping[str, int]
    before: NDArray[np.int64]


def copied_csv(path: Path, source: Path, ends: TextEnds, target: Path, *, given: GivenColumns) -> CsvCopy:
    """Return the copy of a CSV table with its headings and counts."""
    copy = target.with_name(f"{path.name}.lines")
    begun = _schema(source, ends, lines=BEGUN)
    headings = headings_of(begun.names(), given=given, file_name=str(path))
    pieces = rows_together(len(begun), most=PIECE)
    if not _copied(source, ends, begun, copy, pieces=pieces):
        try:
            _written(_scanned(source, ends, schema=_schema(source, ends)), copy, pieces=pieces)
        except pl.exceptions.ComputeError as error:
            if "more fields" not in str(error):
                raise
            require_no_more_cells(source, ends, named=path)
            _written(_scanned(source, ends, cut=True), copy, pieces=pieces)
    lines = pl.scan_parquet(copy)
    why = _left_out(headings, lines.collect_schema())
    count, *several = lines.select(pl.len(), *(condition.sum() for condition in why.values())).collect().row(0)
    left_out = {name: number for name, number in zip(why, several, strict=True) if number}
    if not left_out:
        copy.replace(target)
        return CsvCopy(headings, count, left_out, np.empty(0, np.int64))
    gaps = np.flatnonzero(lines.select(pl.any_horizontal(*why.values())).collect().to_series().to_numpy())
    _written(lines.filter(~pl.any_horizontal(*why.values())), target, pieces=pieces)
    copy.unlink()
    return CsvCopy(headings, count - len(gaps), left_out, gaps - np.arange(len(gaps)))


def _copied(source: Path, ends: TextEnds, begun: pl.Schema, copy: Path, *, pieces: int) -> bool:
    """Return whether all rows could be written with the types that their first lines have.

    A column that is empty in these may turn out to be of any type.
    """
    rows = _scanned(source, ends, schema=begun)
    texts = [name for name, kind in begun.items() if kind == pl.String]
    try:
        first = rows.select(texts).head(BEGUN // 2).collect()
        empty = [name for name in texts if first[name].null_count() == len(first)]
        _written(rows, copy, pieces=pieces)
    except pl.exceptions.ComputeError as error:
        if refusal(error) is not None:
            raise
        return False
    return all(pl.scan_parquet(copy).select(pl.col(empty).is_null().all()).collect().row(0)) if empty else True


def _schema(source: Path, ends: TextEnds, *, lines: int | None = None) -> pl.Schema:
    """Return the types of the columns; numbers that begin with a 0 are names, and stay text."""
    schema = _scanned(source, ends, infer_schema_length=lines).collect_schema()
    whole = [name for name, kind in schema.items() if kind.is_integer()]
    texts = pl.Schema(dict.fromkeys(schema, pl.String))
    begun = _scanned(source, ends, schema=texts, cut=True, n_rows=PADDED_LINES).select(whole)
    padded = begun.select(pl.all().str.contains(PADDED).any()).collect()
    return pl.Schema({**schema, **{name: pl.String() for name in whole if padded[name].item()}})


def _left_out(headings: Headings, schema: pl.Schema) -> dict[str, pl.Expr]:
    """Return whether a line is no row, by why: a blank one, or one that repeats headings, gives units, or sums up."""
    nothing = pl.all_horizontal(pl.col([column.heading for column in headings.columns.values()]).is_null())
    speed = headings.columns["exit_speed"].heading
    who = [headings.columns[name].heading for name in ("date", "batter", "batter_name") if headings.has(name)]
    words = {
        name: pl.col(name).str.strip_chars(" ()[]").str.to_lowercase()
        for name in (speed, schema.names()[0], *who)
        if schema[name] == pl.String
    }
    sums = [words[name].is_in(SUMMARIES) for name in words if name != speed]
    again = [words[speed].is_in([speed.strip().lower(), *KNOWN_UNITS, "km/h", "m/s"])] if speed in words else []
    beside = pl.any_horizontal(*sums, *again, pl.lit(value=False)).fill_null(value=False)
    return {NOTHING: nothing.alias(NOTHING), BESIDE: (~nothing & beside).alias(BESIDE)}


def _scanned(source: Path, ends: TextEnds, *, cut: bool = False, **asked: Any) -> pl.LazyFrame:
    """Return the rows; a column with anything but numbers in it stays text.

    ``cut``: whether cells beyond the headings are left out. ``asked``: of `polars.scan_csv`.
    """
    separator = separator_of(ends.above[-1])
    above = len(ends.above) - 1
    form = {"encoding": "utf8-lossy", "null_values": list(ABSENT), "decimal_comma": separator == ";"}
    return pl.scan_csv(
        source, separator=separator, truncate_ragged_lines=cut, skip_lines=above, **{**ALL_LINES, **form, **asked}
    )

"""A CSV table copied to Parquet: every line that is a row of it, columns with the types that all lines have."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.whole_files import written_whole
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.parquet_pieces import rows_together
from sweetspot.seasons.rows import ABSENT
from sweetspot.tables.headings import GivenColumns, Headings
from sweetspot.tables.text_encoding import TextEnds, require_no_more_cells, separator_of
from sweetspot.tables.unit_words import KNOWN_UNITS

SUMMARIES = {"total", "totals", "grand total", "average", "averages", "avg", "mean", "median"}
"""Words in the first column, or in place of a day or batter, of lines that spreadsheets put below the balls."""
NOTHING, BESIDE = "nothing", "beside"
LEFT_OUT = {
    NOTHING: "blank lines, and such with nothing in any column that is understood",
    BESIDE: "headings once more, units, totals and means",
}
"""Why a line of a CSV file is no row of its table."""
BEGUN = 10_000
"""Lines whose types are tried for all lines; to look at all of them first takes twice as long as to read them."""
PIECE = 32_768
"""Rows of a piece of the copy, fewer of wide tables."""
PADDED, PADDED_LINES = r"^[+-]?0\d", 1000
"""How numbers begin that are names, and lines in which they are looked for: 007 stays what it is."""


@dataclass(frozen=True)
class CsvCopy:
    """A copy of a CSV table.

    Parameters
    ----------
    headings : what its columns mean.
    rows : how many.
    left_out : lines that are no rows, by why (`LEFT_OUT`).
    before : for each of them, how many rows stand above it, in order.
    """

    headings: Headings
    rows: int
    left_out: Mapping[str, int]
    before: NDArray[np.int64]


def copied_csv(path: Path, source: Path, ends: TextEnds, target: Path, *, given: GivenColumns) -> CsvCopy:
    """Return the copy of a CSV table with its headings and counts.

    Parameters
    ----------
    path : the file that people know, for messages.
    source : the same text in UTF-8.
    target : Parquet file to write.
    given : what a person says of the columns.
    """
    copy = target.with_name(f"{path.name}.lines")
    begun = _schema(source, ends, lines=BEGUN)
    headings = headings_of(begun.names(), given=given, file_name=str(path))
    pieces = rows_together(len(begun), most=PIECE)
    if not _copied_as_begun(source, ends, begun, copy, pieces=pieces):
        _copied_as_told(source, ends, copy, named=path, pieces=pieces)
    copied = pl.scan_parquet(copy)
    why = _left_out(headings, copied.collect_schema())
    lines, *several = copied.select(pl.len(), *(condition.sum() for condition in why.values())).collect().row(0)
    left_out = {name: count for name, count in zip(why, several, strict=True) if count}
    before = np.empty(0, np.int64)
    if left_out:
        gaps = np.flatnonzero(copied.select(pl.any_horizontal(*why.values())).collect().to_series().to_numpy())
        before = gaps - np.arange(len(gaps))
        _copied(copied.filter(~pl.any_horizontal(*why.values())), target, pieces=pieces)
        copy.unlink()
    else:
        copy.replace(target)
    return CsvCopy(headings, lines - sum(left_out.values()), left_out, before)


def _copied_as_begun(source: Path, ends: TextEnds, begun: pl.Schema, copy: Path, *, pieces: int) -> bool:
    """Return whether all rows could be written with the types that their first lines have.

    Parameters
    ----------
    begun : what the columns are by the first lines; one that is empty there may turn out to be of any type.
    """
    rows = _scanned(source, ends, schema=begun)
    texts = [name for name, kind in begun.items() if kind == pl.String]
    try:
        first = rows.select(texts).head(BEGUN // 2).collect()
        empty = [name for name in texts if first[name].null_count() == len(first)]
        _copied(rows, copy, pieces=pieces)
    except pl.exceptions.ComputeError:
        return False
    return all(pl.scan_parquet(copy).select(pl.col(empty).is_null().all()).collect().row(0)) if empty else True


def _copied_as_told(source: Path, ends: TextEnds, copy: Path, *, named: Path, pieces: int) -> None:
    """Write all rows with the types that all lines together have.

    Parameters
    ----------
    named : the file that people know, for messages.
    """
    try:
        _copied(_scanned(source, ends, schema=_schema(source, ends)), copy, pieces=pieces)
    except pl.exceptions.ComputeError as error:
        if "more fields" not in str(error):
            raise
        require_no_more_cells(source, ends, named=named)
        _copied(_scanned(source, ends, cut=True), copy, pieces=pieces)


def _copied(rows: pl.LazyFrame, target: Path, *, pieces: int) -> None:
    with written_whole(target) as file:
        rows.sink_parquet(file, row_group_size=pieces, compression="lz4")


def _schema(source: Path, ends: TextEnds, *, lines: int | None = None) -> pl.Schema:
    """Return the types of the columns; numbers that begin with a 0 are names, and stay text."""
    rows = _scanned(source, ends, lines=lines)
    schema = rows.collect_schema()
    whole = [name for name, kind in schema.items() if kind.is_integer()]
    texts = _scanned(
        source, ends, schema=pl.Schema(dict.fromkeys(schema, pl.String)), cut=True, rows=PADDED_LINES
    ).select(whole)
    padded = texts.select(pl.all().str.contains(PADDED).any()).collect()
    names = [name for name in whole if padded[name].item()]
    return pl.Schema({**schema, **dict.fromkeys(names, pl.String())})


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


def _scanned(
    source: Path, ends: TextEnds, *, cut: bool = False, lines: int | None = None, schema: pl.Schema | None = None,
    rows: int | None = None,
) -> pl.LazyFrame:  # fmt: skip
    """Return the rows; a column with anything but numbers in it stays text.

    Parameters
    ----------
    cut : whether cells beyond the headings are left out; otherwise they are an error.
    lines : that are looked at for what stands in the columns; None: all.
    schema : what the columns are, where that is known.
    rows : that are read; None: all.
    """
    separator = separator_of(ends.above[-1])
    return pl.scan_csv(
        source, separator=separator, schema=schema, infer_schema_length=lines, truncate_ragged_lines=cut,
        encoding="utf8-lossy", null_values=list(ABSENT), decimal_comma=separator == ";", skip_lines=len(ends.above) - 1,
        n_rows=rows,
    )  # fmt: skip

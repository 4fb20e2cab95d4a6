"""A table on disk, made ready to be read in parts: Parquet as it is, CSV (also packed) turned into Parquet first."""

from __future__ import annotations

import errno
import zlib
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import ArrayLike, NDArray

from sweetspot.errors import InputError, UnwritableError, first_line
from sweetspot.numerics.whole_files import refusal, written_whole
from sweetspot.season.day_order import with_days
from sweetspot.season.headings import KNOWN_UNITS, Headings, headings_of
from sweetspot.season.parquet_footer import Footer, footer_of
from sweetspot.season.text_ends import (
    TextEnds,
    cells_of,
    in_utf8,
    is_number,
    require_no_more_cells,
    separator_of,
)
from sweetspot.units import grouped

CSV_ENDINGS = (".csv", ".tsv", ".txt", ".csv.gz", ".tsv.gz", ".txt.gz")
PARQUET_ENDINGS = (".parquet", ".pq")
MISSING = ["", "NA", "N/A", "NaN", "nan", "null", "NULL", "None", "-", "--"]
"""Words that mean that there is nothing. Missing is never zero."""
SUMMARIES = {"total", "totals", "grand total", "average", "averages", "avg", "mean", "median"}
"""Words in the first column, or in place of a day or batter, of lines that spreadsheets put below the balls."""
NOTHING, BESIDE = "nothing", "beside"
LEFT_OUT = {
    NOTHING: "blank lines, and such with nothing in any column that is understood",
    BESIDE: "headings once more, units, totals and means",
}
"""Why a line of a CSV file is no row of its table."""
ENCODINGS = {"utf-16": "UTF-16", "cp1252": "Windows-1252, for it is not UTF-8"}
"""Encodings beside UTF-8 that are read, and how that is said."""
OTHERS = {
    ".xlsx": "save the sheet as CSV", ".xls": "save the sheet as CSV", ".zip": "unpack it", ".bz2": "unpack it",
    ".xz": "unpack it", ".zst": "unpack it", ".7z": "unpack it",
}  # fmt: skip
"""Endings of files that hold tables and are not read, and what to do."""
BEGUN = 10_000
"""Lines whose types are tried for all lines; to look at all of them first takes twice as long as to read them."""
FULL = {errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EROFS, errno.EACCES, errno.EPERM}
"""What a system says that takes no file, or no more of it."""
MOST_CELLS = 8_000_000
"""Numbers and words of whole rows that are held together; a season's export has as many in 65,536 rows."""
CUTS = (25_000, 40_000)
"""Rows at which public exports end."""


@dataclass(frozen=True)
class TableFile:
    """One table.

    Parameters
    ----------
    path : as it was given.
    data : Parquet file that the rows are read from; the same, or a copy made of a CSV file.
    headings : what its columns mean.
    rows : how many.
    left_out : lines below the headings that are no rows, by why (`LEFT_OUT`); none of Parquet.
    torn : whether its last line stops in the middle.
    notes : what was seen in reading it.
    empty : headings of measurements that hold nothing at all.
    first : number of its first row: of CSV as a spreadsheet shows it, lines above and headings counted; else 1.
    before : for each line left out, how many rows stand above it, in order.
    """

    path: Path
    data: Path
    headings: Headings
    rows: int
    torn: bool
    notes: tuple[str, ...]
    empty: tuple[str, ...] = ()
    left_out: Mapping[str, int] = field(default_factory=dict)
    first: int = 1
    before: NDArray[np.int64] = field(default_factory=lambda: np.empty(0, np.int64), compare=False)

    def numbers(self, rows: ArrayLike) -> NDArray[np.int64]:
        """Return by which numbers people find rows in the file, however many lines were left out above them.

        Parameters
        ----------
        rows : from 0.
        """
        rows = np.asarray(rows, np.int64)
        return self.first + rows + np.searchsorted(self.before, rows, side="right")

    @property
    def lines(self) -> int:
        """How many rows it was given with: those that it has, and those left out."""
        return self.rows + sum(self.left_out.values())

    @property
    def width(self) -> int:
        """How many columns it has."""
        return len(self.headings.columns) + len(self.headings.passed)

    @property
    def cut(self) -> bool:
        """Whether it has as many rows as public exports are cut at."""
        return self.rows > 0 and any(self.rows % size == 0 for size in CUTS)

    @cached_property
    def row_groups(self) -> tuple[int, ...]:
        """Rows of the pieces of its data that are unpacked whole; one piece where the file does not tell."""
        told = self.footer.row_groups
        return told if sum(told) == self.rows else (self.rows,)

    @cached_property
    def footer(self) -> Footer:
        """What its data's footer tells."""
        return footer_of(self.data)

    def part(self, start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
        """Return some rows, columns as they are; an empty measurement is a number that is missing.

        Parameters
        ----------
        headings : of the columns that are wanted; None: all.
        """
        frame = pl.scan_parquet(self.data)
        frame = frame if headings is None else frame.select(headings)
        wanted = [name for name in self.empty if headings is None or name in headings]
        numbers = [pl.col(name).cast(pl.Float64, strict=False) for name in wanted]
        return frame.slice(start, count).with_columns(numbers).collect()


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


def open_table(path: Path, *, staging: Path, given: Mapping[str, str] | None = None) -> TableFile:
    """Return a table that can be read in parts.

    Parameters
    ----------
    staging : folder where the Parquet copy of a CSV file goes; made if need be.
    given : heading by quantity, as `headings_of` takes it.

    Raises
    ------
    InputError
        when the file cannot be read, is empty or no table, or lacks what is needed.
    UnwritableError
        when there is no room for the copy of a CSV file; no other table would find any.
    """
    name = path.name.lower()
    if not path.is_file():
        raise InputError(f"{path} is not a file; give CSV (also .csv.gz) or Parquet")
    if path.stat().st_size == 0:
        raise InputError(f"{path} is empty; a table needs a line of column names and a row per ball")
    if name.endswith(PARQUET_ENDINGS):
        return _parquet(path, given)
    if not name.endswith(CSV_ENDINGS):
        do = next((f"{words}, or give" for ending, words in OTHERS.items() if name.endswith(ending)), "allowed:")
        raise InputError(f"{path} has no ending that is understood; {do} {', '.join((*CSV_ENDINGS, '.parquet'))}")
    return _csv(path, staging, given)


def frame_headings(frame: pl.LazyFrame, *, given: Mapping[str, str] | None = None, name: str = "table") -> Headings:
    """Return what the columns of a frame mean, just as those of a file; of its rows only dates are looked at.

    Parameters
    ----------
    given : heading by quantity, as `headings_of` takes it.
    name : for messages.

    Raises
    ------
    InputError
        when `headings_of` refuses the names, or a column holds several things a row.
    """
    schema = frame.collect_schema()
    headings = headings_of(schema.names(), given=given, file_name=name)
    for column in headings.columns.values():
        held = schema[column.heading]
        if held.is_nested() or isinstance(held, pl.Duration | pl.Object):
            raise InputError(f"{name}: column {column.heading} holds {held}; write one number or one word a row")
    headings, notes = with_days(headings, frame)
    return replace(headings, notes=(*headings.notes, *notes))


def text_columns(
    path: Path, quantities: Sequence[str], *, staging: Path, given: Mapping[str, str] | None = None
) -> pl.LazyFrame:
    """Return some columns of a table as they are written, those that it has, called by their quantity.

    Nothing else of the table is read; a damaged one may fail only when the columns are collected.

    Parameters
    ----------
    quantities : that are wanted.
    staging : folder for a copy of a CSV file that is not in UTF-8; it must be there until the columns are collected.
    given : heading by quantity, as `headings_of` takes it.

    Raises
    ------
    InputError
        when the file cannot be read, or lacks what is needed.
    """
    try:
        if path.name.lower().endswith(PARQUET_ENDINGS):
            frame = pl.scan_parquet(path)
        else:
            source, ends = in_utf8(path, staging)
            above = ends.above
            frame = pl.scan_csv(
                source, separator=separator_of(above[-1]), infer_schema=False, truncate_ragged_lines=True,
                encoding="utf8-lossy", null_values=MISSING, skip_lines=len(above) - 1,
            )  # fmt: skip
        headings = headings_of(frame.collect_schema().names(), given=given, file_name=str(path))
    except (pl.exceptions.PolarsError, OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None
    columns = headings.only(*quantities).columns
    return frame.select(pl.col(column.heading).cast(pl.String).alias(name) for name, column in columns.items())


def _parquet(path: Path, given: Mapping[str, str] | None) -> TableFile:
    try:
        frame = pl.scan_parquet(path)
        rows = int(frame.select(pl.len()).collect().item())
        if rows > path.stat().st_size:
            raise InputError(
                f"{path} claims {grouped(rows)} rows in {grouped(path.stat().st_size)} bytes; give a row per ball"
            )
    except (pl.exceptions.PolarsError, OSError) as error:
        raise InputError(f"{path} is no whole Parquet file: {first_line(error)}; write or copy it anew") from None
    headings = frame_headings(frame, given=given, name=str(path))
    if not rows:
        raise InputError(f"{path} has column names and no row; give one row per ball")
    return TableFile(path, path, headings, rows, torn=False, notes=headings.notes)


def _csv(path: Path, staging: Path, given: Mapping[str, str] | None) -> TableFile:
    staging.mkdir(parents=True, exist_ok=True)
    with _copying(path, staging):
        source, ends = in_utf8(path, staging)
    above, last = ends.above, ends.last
    first = above[-1]
    separator = separator_of(first)
    names = cells_of(first, separator)
    if not first.strip() or all(is_number(name) for name in names):
        raise InputError(f"{path} does not begin with a line of column names; give one, for example launch_speed")
    notes = []
    copy, target = staging / f"{path.name}.lines", staging / f"{path.name}.parquet"
    with _copying(path, staging):
        begun = _scanned(source, ends, lines=BEGUN).collect_schema()
        headings = headings_of(begun.names(), given=given, file_name=str(path))
        if not _copied_as_begun(source, ends, begun, copy):
            _copied_as_told(source, ends, copy, named=path)
        told = pl.scan_parquet(copy)
        why = _left_out(headings, told.collect_schema())
        lines, *several = told.select(pl.len(), *(one.sum() for one in why.values())).collect().row(0)
        left_out = {name: count for name, count in zip(why, several, strict=True) if count}
        before = np.empty(0, np.int64)
        if left_out:
            gaps = np.flatnonzero(told.select(pl.any_horizontal(*why.values())).collect().to_series().to_numpy())
            before = gaps - np.arange(len(gaps))
            _copied(told.filter(~pl.any_horizontal(*why.values())), target)
            copy.unlink()
        else:
            copy.replace(target)
        if BESIDE in left_out:
            notes.append(
                f"{left_out[BESIDE]} lines that repeat the headings, give units, or a total or mean, are left out"
            )
        rows = lines - sum(left_out.values())
    if not rows:
        raise InputError(f"{path} has column names and no row; give one row per ball")
    texts = [column.heading for column in headings.columns.values() if column.kind != "text"]
    held = pl.scan_parquet(target).select(pl.col(texts).is_null().all()).collect().row(0, named=True)
    torn = bool(last.strip()) and len(cells_of(last, separator)) < len(names)
    headings, day_notes = with_days(headings, pl.scan_parquet(target))
    notes += day_notes
    if len(above) > 1:
        said = "; ".join(
            ", ".join(filter(None, map(str.strip, cells_of(line, separator_of(line))))) for line in above[:-1]
        )
        notes.append(f"{len(above) - 1} lines above the headings are left out: {said[:120]}")
    if ends.encoding in ENCODINGS:
        notes.append(f"the text is read as {ENCODINGS[ends.encoding]}; look at names, or save it as CSV UTF-8")
    if separator != ",":
        notes.append(f"columns are separated by {separator!r}")
    if len(set(names)) < len(names):
        twice = sorted({name for name in names if names.count(name) > 1})
        notes.append(f"{', '.join(twice)} stands twice in the headings; the first one is used")
    return TableFile(path, target, headings, rows, torn=torn, notes=(*headings.notes, *notes),
                     empty=tuple(name for name, nothing in held.items() if nothing), left_out=left_out,
                     first=len(above) + 1, before=before)  # fmt: skip


@contextmanager
def _copying(path: Path, staging: Path) -> Iterator[None]:
    """Say in a line of our own what is wrong with a CSV file, or with the folder that it is copied to."""
    try:
        yield
    except (pl.exceptions.PolarsError, OSError, EOFError, zlib.error) as error:
        refused = refusal(error)
        if refused is not None and refused[0] in FULL:
            raise UnwritableError(
                f"{path} is copied to {staging} to be read, and that cannot be written: {refused[1]}; "
                "make room there, choose another place, or give Parquet, which is read as it is"
            ) from None
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None


def _copied_as_begun(source: Path, ends: TextEnds, begun: pl.Schema, copy: Path) -> bool:
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
        _copied(rows, copy)
    except pl.exceptions.ComputeError:
        return False
    return all(pl.scan_parquet(copy).select(pl.col(empty).is_null().all()).collect().row(0)) if empty else True


def _copied_as_told(source: Path, ends: TextEnds, copy: Path, *, named: Path) -> None:
    """Write all rows with the types that all lines together have.

    Parameters
    ----------
    named : the file that people know, for messages.
    """
    try:
        told = _scanned(source, ends)
        _copied(_scanned(source, ends, schema=told.collect_schema()), copy)
    except pl.exceptions.ComputeError as error:
        if "more fields" not in str(error):
            raise
        require_no_more_cells(source, ends, named=named)
        _copied(_scanned(source, ends, cut=True), copy)


def _copied(rows: pl.LazyFrame, target: Path) -> None:
    held = rows_together(len(rows.collect_schema()), most=32_768)
    with written_whole(target) as file:
        rows.sink_parquet(file, row_group_size=held, compression="lz4")


def _left_out(headings: Headings, schema: pl.Schema) -> dict[str, pl.Expr]:
    """Return whether a line is no row, by why: a blank one, or one that repeats headings, gives units, or sums up."""
    nothing = pl.all_horizontal(pl.col([column.heading for column in headings.columns.values()]).is_null())
    speed = headings.columns["exit_speed"].heading
    who = [headings.columns[name].heading for name in ("date", "batter", "batter_name") if headings.has(name)]
    words = {name: pl.col(name).str.strip_chars(" ()[]").str.to_lowercase()
             for name in (speed, schema.names()[0], *who) if schema[name] == pl.String}  # fmt: skip
    sums = [words[name].is_in(SUMMARIES) for name in words if name != speed]
    again = [words[speed].is_in([speed.strip().lower(), *KNOWN_UNITS, "km/h", "m/s"])] if speed in words else []
    beside = pl.any_horizontal(*sums, *again, pl.lit(value=False)).fill_null(value=False)
    return {NOTHING: nothing.alias(NOTHING), BESIDE: (~nothing & beside).alias(BESIDE)}


def _scanned(
    source: Path, ends: TextEnds, *, cut: bool = False, lines: int | None = None, schema: pl.Schema | None = None
) -> pl.LazyFrame:
    """Return the rows; a column with anything but numbers in it stays text.

    Parameters
    ----------
    cut : whether cells beyond the headings are left out; otherwise they are an error.
    lines : that are looked at for what stands in the columns; None: all.
    schema : what the columns are, where that is known.
    """
    separator = separator_of(ends.above[-1])
    return pl.scan_csv(
        source, separator=separator, schema=schema, infer_schema_length=lines, truncate_ragged_lines=cut,
        encoding="utf8-lossy", null_values=MISSING, decimal_comma=separator == ";", skip_lines=len(ends.above) - 1,
    )  # fmt: skip

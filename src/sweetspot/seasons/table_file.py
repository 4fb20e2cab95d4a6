"""A table on disk, made ready to be read in parts: Parquet as it is, CSV (also packed) turned into Parquet first."""

from __future__ import annotations

import csv
import tomllib
import zlib
from collections.abc import Mapping, Sequence
from contextlib import nullcontext
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import ArrayLike, NDArray

from sweetspot.errors import InputError, first_line
from sweetspot.numerics.text_files import near_file
from sweetspot.numerics.whole_parquet import reading_parquet, unpack_all
from sweetspot.seasons.headings import headings_of, names_balls, told_by_rows, with_player_name
from sweetspot.seasons.rows import ABSENT
from sweetspot.seasons.table_copies import BESIDE, copied_csv, copying, joined, row_groups_of
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, Headings
from sweetspot.tables.text_encoding import cells_of, in_utf8, is_number, separator_of
from sweetspot.units import grouped

CSV_ENDINGS = (".csv", ".tsv", ".txt", ".csv.gz", ".tsv.gz", ".txt.gz")
PARQUET_ENDINGS = (".parquet", ".pq")
ENCODINGS = {"utf-16": "UTF-16", "cp1252": "Windows-1252, for it is not UTF-8"}
"""Encodings beside UTF-8 that are read, and how that is said."""
OTHERS = {
    **dict.fromkeys((".xlsx", ".xls"), "save the sheet as CSV"),
    **dict.fromkeys((".zip", ".bz2", ".xz", ".zst", ".7z"), "unpack it"),
}
"""Endings of files that hold tables and are not read, and what to do."""
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
    left_out : lines below the headings that are no rows, by why (`LEFT_OUT`); none of Parquet.
    torn : whether its last line stops in the middle.
    notes : what was seen in reading it.
    empty : headings of measurements that hold nothing at all.
    first : number of its first row: of CSV as a spreadsheet shows it, lines above and headings counted; else 1.
    before : for each line left out, how many rows stand above it, in order.
    strips : files of some columns each, read instead of `data` where its row groups are too large (`strips_of`).
    ranges : least and greatest number of columns of numbers with a point; of none that hold nothing, or nothing finite.
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
    strips: tuple[Path, ...] = ()
    ranges: Mapping[str, tuple[float, float]] = field(default_factory=dict, compare=False)

    def numbers(self, rows: ArrayLike) -> NDArray[np.int64]:
        """Return the numbers by which people find rows in the file, however many lines were left out above them.

        ``rows``: from 0.
        """
        rows = np.asarray(rows, np.int64)
        return self.first + rows + np.searchsorted(self.before, rows, side="right")

    @property
    def lines(self) -> int:
        """Number of rows that it was given with: those that it has, and those left out."""
        return self.rows + sum(self.left_out.values())

    @property
    def width(self) -> int:
        """Number of columns."""
        return len(self.headings.columns) + len(self.headings.passed)

    @property
    def cut(self) -> bool:
        """Whether it has as many rows as public exports are cut at."""
        return self.rows > 0 and any(self.rows % size == 0 for size in CUTS)

    @cached_property
    def schema(self) -> pl.Schema:
        """Types of its columns, as `part` gives them."""
        kinds = pl.scan_parquet(self.data).collect_schema()
        return pl.Schema({name: pl.Float64() if name in self.empty else kind for name, kind in kinds.items()})

    def holding_nothing(self, names: Sequence[str]) -> set[str]:
        """Return those of some columns that hold nothing in any row."""
        found = pl.scan_parquet(self.data).select(pl.col(names).is_null().all()).collect().row(0, named=True)
        return {name for name, nothing in found.items() if nothing}

    @cached_property
    def row_groups(self) -> tuple[int, ...]:
        """Rows of the pieces of its data that are unpacked whole; one piece where the file does not tell."""
        groups = tuple(group.rows for group in row_groups_of(self.strips[0] if self.strips else self.data))
        return groups if sum(groups) == self.rows else (self.rows,)

    def part(self, start: int, count: int, *, headings: Sequence[str] | None = None) -> pl.DataFrame:
        """Return some rows, columns as they are; an empty measurement is a number that is missing.

        ``headings``: of the columns that are wanted; None: all.
        """
        if self.strips:
            frame = joined(self.strips, start, count, headings=headings)
        else:
            scanned = pl.scan_parquet(self.data)
            scanned = scanned if headings is None else scanned.select(headings)
            frame = scanned.slice(start, count).collect()
        wanted = [name for name in self.empty if name in frame.columns]
        return frame.with_columns(pl.col(name).cast(pl.Float64, strict=False) for name in wanted)


def is_parquet(path: Path) -> bool:
    """Return whether a file is Parquet, by its name."""
    return path.name.lower().endswith(PARQUET_ENDINGS)


def no_table(path: Path) -> InputError:
    """Return the refusal of a path where nothing lies, with the file beside it that may have been meant."""
    near = near_file(path)
    meant = "" if near is None else f"did you mean {near}? Otherwise "
    return InputError(f"{path} is not a file; {meant}give CSV (also .csv.gz) or Parquet")


def open_table(path: Path, *, staging: Path, given: GivenColumns = NOTHING_GIVEN) -> TableFile:
    """Return a table that can be read in parts."""
    name = path.name.lower()
    if path.is_dir():
        raise InputError(f"{path} is a folder; give the tables in it, for example {path / '*.parquet'}")
    if not path.is_file():
        raise no_table(path)
    if path.stat().st_size == 0:
        raise InputError(f"{path} is empty; a table needs a line of column names and a row per ball")
    if is_parquet(path):
        return _parquet(path, given)
    if not name.endswith(CSV_ENDINGS):
        do = next((f"{words}, or give" for ending, words in OTHERS.items() if name.endswith(ending)), "allowed:")
        raise InputError(f"{path} has no ending that is understood; {do} {', '.join((*CSV_ENDINGS, '.parquet'))}")
    return _csv(path, staging, given)


def frame_headings(frame: pl.LazyFrame, *, given: GivenColumns = NOTHING_GIVEN, name: str = "table") -> Headings:
    """Return the meaning of the columns of a frame; of its rows only dates and names are read."""
    schema = frame.collect_schema()
    headings = headings_of(schema.names(), given=given, file_name=name)
    for column in headings.columns.values():
        held = schema[column.heading]
        if held.is_nested() or isinstance(held, pl.Duration | pl.Object):
            raise InputError(f"{name}: column {column.heading} holds {held}; write one number or one word a row")
    headings, notes = told_by_rows(headings, frame)
    return replace(headings, notes=(*headings.notes, *notes))


def text_columns(
    path: Path, quantities: Sequence[str], *, staging: Path, given: GivenColumns = NOTHING_GIVEN
) -> pl.LazyFrame:
    """Return some columns of a table as they are written, those that it has, called by their quantity.

    Nothing else of the table is read; a damaged one may fail only when the columns are collected.

    ``staging``: folder for a copy of a CSV file that is not in UTF-8; it must be there until the columns are collected.
    """
    try:
        parquet = is_parquet(path)
        with reading_parquet(path) if parquet else nullcontext():
            frame = pl.scan_parquet(path) if parquet else _text_frame(path, staging)
            headings = headings_of(frame.collect_schema().names(), given=given, file_name=str(path))
            headings = with_player_name(headings, frame)
    except (pl.exceptions.PolarsError, csv.Error, OSError, EOFError, zlib.error) as error:
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None
    columns = headings.only(*quantities).columns
    return frame.select(pl.col(column.heading).cast(pl.String).alias(name) for name, column in columns.items())


def _text_frame(path: Path, staging: Path) -> pl.LazyFrame:
    """Return a CSV file of which every cell is text."""
    source, ends = in_utf8(path, staging, is_heading=names_balls)
    above = ends.above
    return pl.scan_csv(
        source,
        separator=separator_of(above[-1]),
        infer_schema=False,
        truncate_ragged_lines=True,
        encoding="utf8-lossy",
        null_values=list(ABSENT),
        skip_lines=len(above) - 1,
    )


def _parquet(path: Path, given: GivenColumns) -> TableFile:
    with reading_parquet(path):
        frame = pl.scan_parquet(path)
        rows = int(frame.select(pl.len()).collect().item())
        if rows > path.stat().st_size:
            raise InputError(
                f"{path} claims {grouped(rows)} rows in {grouped(path.stat().st_size)} bytes; give a row per ball"
            )
        ranges = unpack_all(frame)
        headings = frame_headings(frame, given=given, name=str(path))
    if not rows:
        raise InputError(f"{path} has column names and no row; give one row per ball")
    return TableFile(path, path, headings, rows, torn=False, notes=headings.notes, ranges=ranges)


def _csv(path: Path, staging: Path, given: GivenColumns) -> TableFile:
    staging.mkdir(parents=True, exist_ok=True)
    with copying(path, staging):
        source, ends = in_utf8(path, staging, is_heading=names_balls)
        above, last = ends.above, ends.last
        first = above[-1]
        separator = separator_of(first)
        names = cells_of(first, separator)
        torn = ends.quoting or (bool(last.strip()) and len(cells_of(last, separator)) < len(names))
    if not first.strip() or all(is_number(name) for name in names):
        raise InputError(f"{path} does not begin with a line of column names; give one, for example launch_speed")
    notes = []
    target = staging / f"{path.name}.parquet"
    with copying(path, staging):
        copy = copied_csv(path, source, ends, target, given=given)
    left_out = copy.left_out
    if BESIDE in left_out:
        notes.append(f"{left_out[BESIDE]} lines that repeat the headings, give units, or a total or mean, are left out")
    if not copy.rows:
        raise InputError(f"{path} has column names and no row; give one row per ball")
    texts = [column.heading for column in copy.headings.columns.values() if column.kind != "text"]
    held = pl.scan_parquet(target).select(pl.col(texts).is_null().all()).collect().row(0, named=True)
    ranges = unpack_all(pl.scan_parquet(target))
    headings, more = told_by_rows(copy.headings, pl.scan_parquet(target))
    notes += more
    if len(above) > 1:
        preamble = "; ".join(
            ", ".join(filter(None, map(str.strip, cells_of(line, separator_of(line))))) for line in above[:-1]
        )
        notes.append(f"{len(above) - 1} lines above the headings are left out: {preamble[:120]}")
    if ends.encoding in ENCODINGS:
        notes.append(f"the text is read as {ENCODINGS[ends.encoding]}; look at names, or save it as CSV UTF-8")
    if separator != ",":
        notes.append(f"columns are separated by {separator!r}")
    if len(set(names)) < len(names):
        twice = sorted({name for name in names if names.count(name) > 1})
        notes.append(f"{', '.join(twice)} stands twice in the headings; the first one is used")
    empty = tuple(name for name, nothing in held.items() if nothing)
    return TableFile(
        *(path, target, headings, copy.rows, torn, (*headings.notes, *notes), empty, left_out),
        first=len(above) + 1,
        before=copy.before,
        ranges=ranges,
    )


@dataclass
class TableWarning:
    """Something to beware of.

    ``name``: a key of `WARNINGS`. ``table``: number of the table, from 0. ``rows``: the first of them, by the numbers
    that people find them by (`TableFile.numbers`). ``detail``: what exactly; "" where the name says all.
    """

    name: str
    table: int
    count: int = 0
    rows: list[int] = field(default_factory=list)
    detail: str = ""


with Path(__file__).with_name("warnings.toml").open("rb") as file:
    _TEXTS: Mapping[str, Mapping[str, str]] = tomllib.load(file)
WARNINGS, CANNOT_TELL = _TEXTS["warnings"], _TEXTS["cannot_tell"]
"""Possible faults of a table of batted balls, by name; and the answers that such tables cannot give."""


def cannot_tell(tables: Sequence[TableFile]) -> tuple[str, ...]:
    """Return the answers that tables cannot give; tables with measured places along the bat can give the side."""
    measured = all(table.headings.has("axial_offset") for table in tables)
    return tuple(words for name, words in CANNOT_TELL.items() if name != "side" or not measured)

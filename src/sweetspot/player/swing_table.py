"""A file of swings as lines and cells: a small CSV file as it stands, a large one and Parquet by the columns needed.

CSV files up to `MOST_TABLE_BYTES` are read whole, with whatever stands above their headings. Larger ones and Parquet
are scanned by polars: only the columns that mean something are read, and only the rows of the batter asked for.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING

from sweetspot.errors import InputError, first_line
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, is_larger, read_text
from sweetspot.numerics.whole_parquet import reading_parquet
from sweetspot.player.player_swing import columns_of, is_heading_line
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns, Headings, TableColumn
from sweetspot.tables.text_encoding import heading_lines, pointed, separator_of, table_rows
from sweetspot.tables.vocabulary import simplified, systems

if TYPE_CHECKING:
    import polars as pl

Lines = tuple[tuple[int, list[str]], ...]
PREAMBLE = 20
"""Lines above the column names that a file may have."""
PARQUET = (".parquet", ".pq")
"""Endings of names of Parquet files."""
ADVICE = "give a CSV file with the rows of one batter, or Parquet"


SUMMARIES = {
    *("average", "averages", "avg", "mean", "median", "total", "totals", "sum"),
    *("max", "maximum", "min", "minimum"),
}
"""What spreadsheets and devices call a row below the others that sums them up, in lower case."""


def one_name(name: str) -> str:
    """Return a name as names are compared: small and large letters and the number of blanks make no difference.

    >>> one_name("Jimmy  Smith ") == one_name("jimmy smith")
    True
    """
    return " ".join(name.split()).casefold()


def _sums_up(cells: Sequence[str]) -> bool:
    """Return whether a row sums others up."""
    return any(one_name(cell).rstrip(":.") in SUMMARIES for cell in cells)


class TextTable:
    """A CSV file that is read whole; rows are (line of the file, cells), without those below that sum them up."""

    def __init__(self, lines: Lines) -> None:
        self.headings = tuple(lines[0][1]) if lines else ()
        rows = lines[1:]
        whole = next((end for end in range(len(rows), 0, -1) if not _sums_up(rows[end - 1][1])), 0)
        self._lines, self.summaries = rows[:whole], rows[whole:]
        self._parted: dict[int, dict[str, tuple[str, Lines]]] = {}

    def narrowed(self, columns: Headings) -> Headings:
        """Return the columns as they are: cells stand as in the file."""
        return columns

    def width(self, columns: Headings) -> int:  # noqa: ARG002 - all columns are there
        """Return the number of cells of a whole row."""
        return len(self.headings)

    def rows(self, columns: Headings, batter: str | None = None) -> Lines:
        """Return the rows, of one batter where one is named."""
        return self._lines if batter is None else self._by_batter(columns).get(one_name(batter), ("", ()))[1]

    def batters(self, columns: Headings) -> list[str]:
        """Return the names of the batters, in the order of the alphabet."""
        return sorted(name for name, _ in self._by_batter(columns).values() if name)

    def _by_batter(self, columns: Headings) -> dict[str, tuple[str, Lines]]:
        """Return every batter's name as it is first spelt and his rows, by the name as it is compared."""
        place = columns.columns["batter"].index
        if place not in self._parted:
            parts: dict[str, list[tuple[int, list[str]]]] = {}
            spelt: dict[str, str] = {}
            for line, cells in self._lines:
                name = cells[place].strip().removesuffix(".0") if place < len(cells) else ""
                spelt.setdefault(one_name(name), name)
                parts.setdefault(one_name(name), []).append((line, cells))
            self._parted[place] = {key: (spelt[key], tuple(rows)) for key, rows in parts.items()}
        return self._parted[place]


class ScannedTable:
    """Parquet or a large CSV file, of which only what is needed is read.

    ``frame``: its rows, with the line of each in ``LINE``. ``commas``: whether numbers may have decimal commas.
    """

    LINE = "line of the file"
    summaries: Lines = ()

    def __init__(self, path: Path, frame: pl.LazyFrame, *, commas: bool = False) -> None:
        self.path, self._frame, self._commas = path, frame, commas
        self._schema = frame.collect_schema()
        self.headings = tuple(name for name in self._schema.names() if name != self.LINE)
        self._all: dict[str, pl.DataFrame] | None = None

    def narrowed(self, columns: Headings) -> Headings:
        """Return the columns as they stand in the rows: only those that mean something are there."""
        order = {column.index: place for place, column in enumerate(self._needed(columns))}
        moved = {name: replace(column, index=order[column.index]) for name, column in columns.columns.items()}
        return replace(columns, columns=moved)

    def width(self, columns: Headings) -> int:
        """Return the number of cells of a whole row."""
        return len(columns.columns)

    def rows(self, columns: Headings, batter: str | None = None) -> Lines:
        """Return the rows, of one batter where one is named; others are not read."""
        if batter is not None and self._all is not None:
            named = next((name for name in self._all if one_name(name) == one_name(batter)), None)
            return () if named is None else self._lines(self._all[named])
        frame = self._frame
        if batter is not None:
            frame = frame.filter(self._is(columns, batter))
        return self._lines(self._collected(frame.select(self.LINE, *self._cells(columns))))

    def batters(self, columns: Headings) -> list[str]:
        """Return the names of the batters; the rows of all are kept, for they will be asked for one after another."""
        if self._all is None:
            import polars as pl

            named = self._named(columns).alias("who")
            frame = self._collected(self._frame.select(self.LINE, *self._cells(columns), named))
            spelt: dict[str, str] = {}
            for name in frame["who"].unique(maintain_order=True):
                spelt.setdefault(one_name(name), name)
            frame = frame.with_columns(
                pl.col("who").replace({name: spelt[one_name(name)] for name in frame["who"].unique()})
            )
            parts = frame.partition_by("who", as_dict=True, include_key=False)
            self._all = {
                str(key[0]): part for key, part in parts.items() if key[0] and one_name(key[0]) not in SUMMARIES
            }
        return sorted(self._all)

    def _collected(self, frame: pl.LazyFrame) -> pl.DataFrame:
        import polars as pl

        if self.path.suffix.lower() in PARQUET:
            with reading_parquet(self.path):
                return frame.collect()
        try:
            return frame.collect()
        except (pl.exceptions.PolarsError, OSError) as error:
            raise InputError(f"{self.path} cannot be read as a table: {first_line(error)}") from None

    def _needed(self, columns: Headings) -> list[TableColumn]:
        return sorted(columns.columns.values(), key=lambda column: column.index)

    def _cells(self, columns: Headings) -> list[pl.Expr]:
        import polars as pl

        names = [self.headings[column.index] for column in self._needed(columns)]
        return [pl.col(name).cast(pl.String).fill_null("") for name in names]

    def _named(self, columns: Headings) -> pl.Expr:
        import polars as pl

        name = self.headings[columns.columns["batter"].index]
        return pl.col(name).cast(pl.String).str.strip_chars().str.strip_suffix(".0")

    def _is(self, columns: Headings, batter: str) -> pl.Expr:
        """Return whether a row is a batter's; numbers are compared as such, so that parts of a file are skipped."""
        import polars as pl

        name = self.headings[columns.columns["batter"].index]
        if self._schema[name].is_integer() and batter.lstrip("-").isdigit():
            return pl.col(name) == int(batter)
        return self._named(columns).str.to_lowercase().str.replace_all(r"\s+", " ") == " ".join(batter.split()).lower()

    def _lines(self, frame: pl.DataFrame) -> Lines:
        rows = ((int(line), list(cells)) for line, *cells in frame.iter_rows())
        if self._commas:
            rows = ((line, [pointed(cell) for cell in cells]) for line, cells in rows)
        return tuple((line, cells) for line, cells in rows if any(cell.strip() for cell in cells))


SwingTable = TextTable | ScannedTable
"""A table whose headings are known."""


def open_swings(path: Path, given: GivenColumns = NOTHING_GIVEN) -> SwingTable:
    """Return a file of swings; the last one is kept, for a league is asked for player after player."""
    if path.is_dir():
        raise InputError(f"{path} is not a file; give a CSV or Parquet file with a row per swing")
    return _opened(path, _signature(path), given.told)


def _signature(path: Path) -> tuple[int, int]:
    try:
        status = path.stat()
    except OSError:
        return 0, 0  # reading it says what is wrong
    return status.st_mtime_ns, status.st_size


@lru_cache(maxsize=1)
def _opened(path: Path, signature: tuple[int, int], named: frozenset[str]) -> SwingTable:  # noqa: ARG001 - a changed file is another file
    if path.suffix.lower() in PARQUET:
        return _scanned_parquet(path)
    if is_larger(path, most=MOST_TABLE_BYTES):
        return _scanned_csv(path, named)
    text = read_text(path, most=MOST_TABLE_BYTES, advice=ADVICE)
    is_heading = partial(is_heading_line, named=named)
    lines = list(table_rows(text, path, is_heading=is_heading))
    first = next((place for place, (_, cells) in enumerate(lines) if is_heading(cells)), None)
    return TextTable(tuple(lines[:PREAMBLE] if first is None else lines[first:]))


def _scanned_parquet(path: Path) -> SwingTable:
    import polars as pl

    if not path.is_file():
        raise InputError(f"{path} is not a file; it cannot be read: there is no such file")
    with reading_parquet(path):
        return ScannedTable(path, pl.scan_parquet(path, row_index_name=ScannedTable.LINE, row_index_offset=1))


def _scanned_csv(path: Path, named: frozenset[str]) -> SwingTable:
    """Return a large CSV file: every cell as text, for the same rules as a small one's are to hold."""
    import polars as pl

    above = heading_lines(path, is_heading=partial(is_heading_line, named=named))
    if not above:
        raise InputError(
            f"{path} is larger than {MOST_TABLE_BYTES / 1e6:g} MB and none of its first lines names a column for bat "
            "speed or exit speed; begin it with its column names, for example bat_speed_mph,exit_speed_mph"
        )
    separator = separator_of(above[-1])
    try:
        frame = pl.scan_csv(
            path,
            separator=separator,
            infer_schema=False,
            truncate_ragged_lines=True,
            encoding="utf8-lossy",
            skip_lines=len(above) - 1,
            row_index_name=ScannedTable.LINE,
            row_index_offset=len(above) + 1,
        )
        return ScannedTable(path, frame, commas=separator != ",")
    except (pl.exceptions.PolarsError, OSError) as error:
        raise InputError(f"{path} cannot be read as a table: {first_line(error)}") from None


def narrow_csv(path: Path) -> str:
    """Return a CSV text that is read as the file is.

    Rows stand in the same lines, those of Parquet one line lower, under the headings; too short and too long ones stay
    so. What tells a measuring system's files from others stays as empty columns.
    """
    table = open_swings(path)
    if not table.headings:
        raise InputError(f"{path} is empty; it needs a line of column names, for example bat_speed_mph, exit_speed_mph")
    columns = columns_of(table.headings, file_name=str(path))
    remaining = [(column.heading, column.index) for column in table.narrowed(columns).columns.values()]
    marks = {name for system in systems() for marks in system.marks for name in marks}
    names = {heading for heading, _ in remaining}
    named = [heading for heading in table.headings if simplified(heading) in marks and heading.strip() not in names]
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    rows, width = table.rows(columns), table.width(columns)
    first = max(2, rows[0][0]) if rows else 2
    text.write("\n" * (first - 2))
    writer.writerow([heading for heading, _ in remaining] + named)
    line = rows[0][0] if rows else first
    for number, cells in rows:
        text.write("\n" * (number - line))
        row = [cells[index] if index < len(cells) else "" for _, index in remaining] + [""] * len(named)
        writer.writerow([*row[: max(1, len(row) - max(0, width - len(cells)))], *cells[width:]])
        line = number + 1
    return text.getvalue()

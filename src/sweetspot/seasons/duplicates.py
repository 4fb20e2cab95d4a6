"""Pitches that stand in tables more than once, found by their numbers or all that was measured of them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.threads import in_order
from sweetspot.seasons.rows import Texts, rows_of
from sweetspot.seasons.table_file import TableFile
from sweetspot.seasons.table_reader import PART, TableReader
from sweetspot.tables.headings import Headings

KEYS = (("game", "at_bat", "pitch"), ("pitch_id",))
"""Quantities that identify pitches; the first that a table has is used."""
WHEN, WHO = ("game", "date"), ("batter", "batter_name")
"""One of each must be known; a batter goes by his number, or by his name."""
MEASURED = ("exit_speed", "launch_angle", "map_x", "map_y", "release_speed", "velocity_x", "velocity_z", "plate_side")
MIXED = (0x9E3779B97F4A7C15, 0xBF58476D1CE4E5B9, 0x94D049BB133111EB)
"""Constants of splitmix64, a mixing of 64 bits in which no number gets lost."""
NAMED = 1 << 63
"""Bit of the keys of what is no whole number."""
ENOUGH = 5
"""Measurements and batter, how many of them must agree before two rows without a number are the same pitch."""


def tells_pitches(headings: Headings) -> bool:
    """Return whether a table has quantities that identify pitches."""
    return _numbered(headings) is not None or bool(_measured(headings))


def shared(tables: Sequence[Headings]) -> list[Headings]:
    """Return the columns of tables by which pitches are found that stand in several of them: those that all have.

    Where these do not tell pitches apart, each table keeps its own.

    >>> from sweetspot.seasons.headings import headings_of
    >>> first, second = headings_of(["ExitSpeed", "Angle", "PitchUID"]), headings_of(["launch_speed", "play_id"])
    >>> [list(one.columns) for one in shared([first, second])]
    [['exit_speed', 'pitch_id'], ['exit_speed', 'pitch_id']]
    """
    telling = [set(headings.columns) for headings in tables if tells_pitches(headings)]
    common = set.intersection(*telling) if telling else set[str]()
    together = [headings.only(*(name for name in headings.columns if name in common)) for headings in tables]
    return [new if tells_pitches(new) else old for new, old in zip(together, tables, strict=True)]


def pitch_keys(
    part: Callable[[Sequence[str]], pl.DataFrame], headings: Headings
) -> tuple[NDArray[np.uint64], NDArray[np.bool_]]:
    """Return 64-bit keys that are the same for the same pitch in any table, and for which rows they are known.

    Where pitches are not numbered, rows are the same pitch that agree in everything that is measured.

    >>> frame = pl.DataFrame({"launch_speed": [90.0] * 3, "game_pk": [7, 7, 8], "at_bat_number": [1.0, 1.0, None],
    ...                       "pitch_number": ["2", "2.0", "2"]})
    >>> from sweetspot.seasons.headings import headings_of
    >>> key, known = pitch_keys(frame.select, headings_of(frame.columns))
    >>> bool(key[0] == key[1]), known.tolist()
    (True, [True, True, False])
    """
    names, measured = _numbered(headings) or (), _measured(headings)
    key, numbered = np.zeros(1, np.uint64), np.full(1, bool(names))
    if names:
        frame = part([headings.columns[name].heading for name in names])
        for name in names:
            number, there = _whole(frame[headings.columns[name].heading])
            key, numbered = _mixed(key ^ number), numbered & there
    if measured and not numbered.all():
        asked = headings.only("exit_speed", *measured)
        rows = rows_of(part([column.heading for column in asked.columns.values()]), asked)
        parts = [pl.col(name).cast(pl.String).fill_null("") for name in measured]
        enough = pl.sum_horizontal(pl.col(_measured_names(measured)).is_not_null()) >= ENOUGH
        dated = pl.any_horizontal(pl.col([name for name in WHEN if name in measured]).is_not_null())
        alike = rows.select(key=pl.concat_str(parts, separator="|").hash(seed=1), known=enough & dated)
        key = np.where(numbered, key, alike["key"].to_numpy())
        numbered = numbered | alike["known"].to_numpy()
    return key, numbered


def _numbered(headings: Headings) -> tuple[str, ...] | None:
    return next((names for names in KEYS if headings.has(*names)), None)


def _measured(headings: Headings) -> tuple[str, ...]:
    """Return the quantities that must agree for two rows to be the same pitch; none where they are too few."""
    when, who = ([name for name in names if headings.has(name)] for names in (WHEN, WHO))
    measured = [name for name in MEASURED if headings.has(name)]
    agreeing = (*when, *who[:1], *(name for name in ("pitcher",) if headings.has(name)), *measured)
    return agreeing if when and len(_measured_names(agreeing)) >= ENOUGH else ()


def _measured_names(names: Sequence[str]) -> list[str]:
    """Return those of some quantities of which `ENOUGH` must be known: what was measured, and who batted."""
    return [name for name in names if name in MEASURED or name in WHO]


def _whole(column: pl.Series) -> tuple[NDArray[np.uint64], NDArray[np.bool_]]:
    """Return the whole numbers of a column, a key where a text is none, and where there is anything."""
    if not column.dtype.is_integer():
        column = Texts(column).turned(_whole_or_key)
    elif column.dtype != pl.UInt64:
        column = column.cast(pl.Int64).reinterpret(signed=False)
    return column.fill_null(0).to_numpy(), column.is_not_null().to_numpy()


def _whole_or_key(text: pl.Expr) -> pl.Expr:
    number = pl.when(text.str.contains(r"^(0|[1-9]\d{0,17})$")).then(text).cast(pl.UInt64, strict=False)
    return pl.when(text.is_not_null()).then(pl.coalesce(number, text.hash(seed=1) | NAMED))


def _mixed(key: NDArray[np.uint64]) -> NDArray[np.uint64]:
    add, first, second = (np.uint64(value) for value in MIXED)
    key = key + add
    key = (key ^ (key >> np.uint64(30))) * first
    key = (key ^ (key >> np.uint64(27))) * second
    return key ^ (key >> np.uint64(31))


Keys = tuple[NDArray[np.uint64], NDArray[np.bool_]]
MOST_KEYS = 10_000_000
"""Keys of pitches held at a time; larger tables are gone through several times."""


def duplicate_rows(tables: Sequence[TableFile]) -> list[NDArray[np.uint32]]:
    """Return for each table the rows whose pitch stands earlier, in this table or one before.

    Keys alone are sorted first; rows are asked for only of those that stand there twice, which are few.
    """
    passes = max(1, -(-sum(table.rows for table in tables) // MOST_KEYS))
    hashes: list[list[NDArray[np.uint32]]] = [[] for _ in tables]
    for turn in range(passes):
        keys = [key[keyed] for _, _, key, keyed in _keys(tables, passes, turn)]
        if not keys:
            continue
        every = np.concatenate(keys)
        keys.clear()
        every.sort()
        twice = np.unique(every[1:][every[1:] == every[:-1]])
        del every
        if not len(twice):
            continue
        seen = np.zeros(len(twice), np.bool_)
        for number, start, key, keyed in _keys(tables, passes, turn):
            place = np.minimum(np.searchsorted(twice, key), len(twice) - 1)
            rows = np.flatnonzero(keyed & (twice[place] == key))
            place = place[rows]
            first = np.zeros(len(rows), np.bool_)
            first[np.unique(place, return_index=True)[1]] = True
            hashes[number].append((start + rows[~first | seen[place]]).astype(np.uint32))
            seen[place] = True
    return [np.sort(np.concatenate(rows)) if rows else np.empty(0, np.uint32) for rows in hashes]


def _keys(
    tables: Sequence[TableFile], passes: int, turn: int
) -> Iterator[tuple[int, int, NDArray[np.uint64], NDArray[np.bool_]]]:
    """Yield number of the table, first row, keys of pitches and which of them count in this turn, part by part."""
    headings = shared([table.headings for table in tables])
    for number, (table, telling) in enumerate(zip(tables, headings, strict=True)):
        if not tells_pitches(telling):
            continue
        reader = TableReader([table], part_rows=PART)

        def keys_from(start: int, telling: Headings = telling, reader: TableReader = reader) -> Keys:
            return pitch_keys(lambda names: reader.part(0, start, PART, headings=names), telling)

        starts = range(0, table.rows, PART)
        for start, (key, keyed) in zip(starts, in_order(keys_from, starts), strict=True):
            yield number, start, key, keyed if passes == 1 else keyed & (key % np.uint64(passes) == turn)


def with_duplicates(rows: pl.DataFrame, duplicates: NDArray[np.uint32]) -> pl.DataFrame:
    """Return rows with those marked that are another row's pitch."""
    if not len(duplicates):
        return rows
    first, last = int(rows["row"][0]), int(rows["row"][-1])
    mine = duplicates[np.searchsorted(duplicates, first) : np.searchsorted(duplicates, last, side="right")]
    again = pl.Series(np.isin(rows["row"].to_numpy(), mine))
    return rows.with_columns(reason=pl.when(again).then(pl.lit("duplicate")).otherwise(pl.col("reason")))

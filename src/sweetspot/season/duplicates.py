"""Pitches that stand in tables more than once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.numerics.threads import in_order
from sweetspot.season.same_pitch import pitch_keys, shared, tells_pitches
from sweetspot.season.table_file import TableFile
from sweetspot.season.table_parts import PART
from sweetspot.season.table_reader import TableReader
from sweetspot.tables.headings import Headings

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
        keys = [key[known] for _, _, key, known in _keys(tables, passes, turn)]
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
        for number, start, key, known in _keys(tables, passes, turn):
            place = np.minimum(np.searchsorted(twice, key), len(twice) - 1)
            rows = np.flatnonzero(known & (twice[place] == key))
            place = place[rows]
            first = np.zeros(len(rows), np.bool_)
            first[np.unique(place, return_index=True)[1]] = True
            hashes[number].append((start + rows[~first | seen[place]]).astype(np.uint32))
            seen[place] = True
    return [np.sort(np.concatenate(one)) if one else np.empty(0, np.uint32) for one in hashes]


def _keys(
    tables: Sequence[TableFile], passes: int, turn: int
) -> Iterator[tuple[int, int, NDArray[np.uint64], NDArray[np.bool_]]]:
    """Yield number of the table, first row, keys of pitches and which of them count in this turn, part by part."""
    headings = shared([table.headings for table in tables])
    for number, (table, telling) in enumerate(zip(tables, headings, strict=True)):
        if not tells_pitches(telling):
            continue
        reader = TableReader([table], part_rows=PART)

        def told(start: int, telling: Headings = telling, reader: TableReader = reader) -> Keys:
            return pitch_keys(lambda names: reader.part(0, start, PART, headings=names), telling)

        starts = range(0, table.rows, PART)
        for start, (key, known) in zip(starts, in_order(told, starts), strict=True):
            yield number, start, key, known if passes == 1 else known & (key % np.uint64(passes) == turn)


def with_duplicates(rows: pl.DataFrame, duplicates: NDArray[np.uint32]) -> pl.DataFrame:
    """Return rows with those marked that are another row's pitch."""
    if not len(duplicates):
        return rows
    first, last = int(rows["row"][0]), int(rows["row"][-1])
    mine = duplicates[np.searchsorted(duplicates, first) : np.searchsorted(duplicates, last, side="right")]
    again = pl.Series(np.isin(rows["row"].to_numpy(), mine))
    return rows.with_columns(reason=pl.when(again).then(pl.lit("duplicate")).otherwise(pl.col("reason")))

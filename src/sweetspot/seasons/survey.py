"""A first look at tables: which can be read, what is in them, which pitches stand twice, and what to beware of."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from pathlib import Path
from typing import Annotated

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.flight.bearing import HOME_X, HOME_Y
from sweetspot.numerics.threads import in_order
from sweetspot.seasons.duplicates import duplicate_rows
from sweetspot.seasons.rows import USED
from sweetspot.seasons.table_copies import strips_of
from sweetspot.seasons.table_file import TableFile, TableWarning, open_table
from sweetspot.seasons.table_look import TableLook
from sweetspot.seasons.table_reader import PART, TableReader, part_of
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns
from sweetspot.units.dimensions import SPEED

Ending = tuple[str, int | None]
"""How a ball in play ended, in words, and how far out; None where that is not known."""
APART = 20.0
"""Units of the map, some 50 ft, that separate balls that ended in the same words."""


@dataclass(frozen=True)
class Survey:
    """The content and faults of tables, found before anything is computed.

    Parameters
    ----------
    tables : those that can be read.
    faults : (file, reason) of those that cannot.
    counts : rows by reason, of each table; of lines that are no rows, by why they are left out (`LEFT_OUT`).
    duplicates : rows of each table, from 0, that are another row's pitch.
    warnings : everything to beware of.
    days : first and last day of each table, None where no date is known.
    endings : by how balls in play ended, and how far out on the map (in `APART`): tracked ones, the sum of their exit
        speeds (m/s), and untracked ones.
    """

    tables: tuple[TableFile, ...]
    faults: tuple[tuple[Path, str], ...]
    counts: tuple[dict[str, int], ...]
    duplicates: tuple[NDArray[np.uint32], ...]
    warnings: tuple[TableWarning, ...]
    days: tuple[tuple[date, date] | None, ...]
    endings: Mapping[Ending, tuple[int, float, int]] = field(default_factory=dict)

    @property
    def rows(self) -> int:
        """Rows of all tables together, as they were given."""
        return sum(table.lines for table in self.tables)


def survey_tables(
    paths: Sequence[Path],
    *,
    staging: Path,
    given: GivenColumns = NOTHING_GIVEN,
    progress: Callable[[int, int], None] | None = None,
) -> Survey:
    """Return the survey of some files; one that cannot be read does not keep the others."""
    tables: list[TableFile] = []
    faults: list[tuple[Path, str]] = []
    for path in paths:
        try:
            place = staging / f"{len(tables):04d}"
            table = open_table(path, staging=place, given=given)
            tables.append(replace(table, strips=strips_of(table.data, rows=table.rows, staging=place)))
        except InputError as error:
            faults.append((path, str(error)))
    duplicates = duplicate_rows(tables)
    counts, warnings, days = [], [], []
    endings: dict[Ending, tuple[int, float, int]] = {}
    total, finished = sum(table.rows for table in tables), 0
    for number, table in enumerate(tables):
        look = TableLook(number, table)
        reader = TableReader([table], part_rows=PART)
        asked = ((reader, table, start, look.wanted()) for start in range(0, table.rows, PART))
        for rows in in_order(part_of, asked):
            look.take(rows, duplicates[number])
            _count_endings(rows, endings)
            finished += len(rows)
            if progress is not None:
                progress(finished, total)
        counts.append({**look.counts, **table.left_out})
        warnings += look.warnings()
        days.append((min(look.days), max(look.days)) if look.days else None)
    return Survey(tuple(tables), tuple(faults), tuple(counts), tuple(duplicates), tuple(warnings), tuple(days), endings)


def _count_endings(rows: pl.DataFrame, endings: dict[Ending, tuple[int, float, int]]) -> None:
    """Add balls in play by their ending and kind, and by how far out they were fielded, to those counted."""
    names = [name for name in ("event", "batted_type") if name in rows.columns]
    mapped = {"map_x", "map_y"} <= set(rows.columns)
    if not names and not mapped:
        return
    far = ((pl.col("map_x") - HOME_X) ** 2 + (HOME_Y - pl.col("map_y")) ** 2).sqrt() if mapped else pl.lit(None)
    table = (
        rows.filter(pl.col("reason").is_in([USED, "untracked"]))
        .select(*names, "exit_speed", tracked=pl.col("reason") == USED, far=(far / APART).cast(pl.Int32))
        .group_by(*names, "far")
        .agg(pl.col("tracked").sum(), total=pl.col("exit_speed").sum(), lost=(~pl.col("tracked")).sum())
    )
    for *words, far_out, tracked, total, lost in table.sort(*names, "far").iter_rows():
        ending = " ".join(word or "" for word in words), far_out
        before = endings.get(ending, (0, 0.0, 0))
        endings[ending] = (before[0] + tracked, before[1] + total, before[2] + lost)


@dataclass(frozen=True)
class TrackingBias:
    """The bias of the mean exit speed by balls without one.

    ``share``: part of the balls in play that have no exit speed. ``explained``: part of those for whose ending there
    are tracked ones. ``mean_exit_speed_of_tracked``: m/s. ``mean_exit_speed_of_all``: m/s, if untracked balls are like
    tracked ones that ended alike, as far out.
    """

    share: float
    explained: float
    mean_exit_speed_of_tracked: Annotated[float, SPEED]
    mean_exit_speed_of_all: Annotated[float, SPEED]


def tracking_bias(survey: Survey) -> TrackingBias | None:
    """Return the change of the mean exit speed when untracked balls count as tracked ones that ended alike.

    Alike are event, kind of hit and how far out a ball was fielded; where none came down there, the first two.
    None where no table has endings, or every ball was tracked.
    """
    tracked = sum(count for count, _, _ in survey.endings.values())
    missed = sum(count for _, _, count in survey.endings.values())
    if not tracked or not missed:
        return None
    mean = sum(total for _, total, _ in survey.endings.values()) / tracked
    alike: dict[str, tuple[int, float]] = {}
    for (words, _), (count, total, _) in survey.endings.items():
        before = alike.get(words, (0, 0.0))
        alike[words] = (before[0] + count, before[1] + total)
    untracked, explained = 0.0, 0
    for (words, _), (count, total, lost) in survey.endings.items():
        balls, speeds = (count, total) if count else alike[words]
        untracked += lost * (speeds / balls if balls else mean)
        explained += lost if balls else 0
    balls = tracked + missed
    return TrackingBias(missed / balls, explained / missed, mean, (mean * tracked + untracked) / balls)

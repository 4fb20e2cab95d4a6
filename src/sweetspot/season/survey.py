"""A first look at tables: which can be read, what is in them, which pitches stand twice, and what to beware of."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import date
from itertools import pairwise
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.flight.bearing import bearing_of_place
from sweetspot.season.balls import FIRST_MIDDLE_SEASON
from sweetspot.season.fields import home_park
from sweetspot.season.headings import Headings
from sweetspot.season.rows import (
    DATED,
    REASONED,
    REASONS,
    SIDED,
    USED,
    key_quantities,
    pitch_keys,
    rows_of,
    tells_pitches,
)
from sweetspot.season.table_file import TableFile, open_table
from sweetspot.units import MPH, is_usual

PART = 65_536
"""Rows that are read together."""
LOOKED_AT = ("bat_speed", "velocity_y", "release_speed", "plate_speed", "plate_side", "map_x", "map_y", "home_team",
             *REASONED, *SIDED, *DATED)  # fmt: skip
"""Quantities that the first look asks of every row; of the others only whether they hold anything."""
MOST_KEYS = 10_000_000
"""Keys of pitches held at a time; larger tables are gone through several times."""
SHOWN = 20
"""Rows named with a warning."""
FEW = 50
"""Balls below which their ending alike may be chance."""
LONGEST_GAP = 5
"""Days without a game inside a table before it is said; an all-star break has four."""


ENOUGH_TO_DOUBT = 30
"""Balls of a part of a table from which columns are doubted."""
LEVEL, FAIR = math.radians(1.6), math.radians(50)
"""rad; no launch angle above the first: they are written in radians; bearings beyond the second are foul."""
MOST_FOUL = 0.3
"""Part of the balls in play that may come down foul; caught ones are a tenth at most."""


@dataclass
class TableWarning:
    """Something to beware of.

    Parameters
    ----------
    name : a key of `WARNINGS`.
    table : number of the table, from 0.
    count : rows concerned.
    rows : the first of them, numbers in the table from 1.
    detail : what exactly; "" where the name says all.
    """

    name: str
    table: int
    count: int = 0
    rows: list[int] = field(default_factory=list)
    detail: str = ""


WARNINGS: Mapping[str, str] = {
    "plate reference": "plate_x and plate_z are given at the middle of the plate from 2026 on, at its front before; "
    "pitches were flown to the front edge by their nine parameters",
    "plate not moved": "plate_x and plate_z are given at the middle of the plate from 2026 on, and these pitches lack "
    "the nine parameters to fly them to its front edge",
    "export cut": "a table of exactly so many rows was probably cut by the export; days or slow hitters may be missing",
    "days missing": "days without a ball inside the table",
    "torn": "the last line stops in the middle: the file was cut in copying",
    "untracked": "balls in play without exit speed; they count nowhere, and are not alike those with it",
    "name of the pitcher": "player_name is the pitcher's in this export; hitters go by their number",
    "bunts": "bunts that arrive as balls in play are left out",
    "foul tips": "foul tips stand among the misses, as the league counts them",
    "fouls unmeasured": "public tables have no exit speed of fouls, so nothing per contact or per swing can be told",
    "duplicates": "pitches that stand twice count once",
    "cannot find duplicates": "no column tells pitches apart, so pitches that stand twice count twice",
    "part off": "a column is missing that a part of the answers needs",
    "headings": "headings that needed care",
    "unreadable": "measurements that are no numbers are taken as missing",
    "swapped": "columns seem to stand in each other's place: mend the headings, every answer hangs on it",
    "unit": "numbers that are usual in another unit: check the unit of the column, every answer hangs on it",
    "impossible": "exit speeds or launch angles that cannot be",
    "empty column": "a column that is understood holds nothing",
    "side unknown": "it is not known on which side the batter stood; taken as right-handed",
    "pitch speed unknown": "no pitch speed was measured; the usual one of its kind of pitch stands in, with its error",
    "selected": "all balls of the table ended alike, so it was selected by how they ended; no average of it holds for "
    "others, drag least of all",
    "unknown park": "home teams whose park is not known; no chance of a home run there",
}
"""What can be wrong with a table of batted balls, by name."""


@dataclass(frozen=True)
class Survey:
    """What was found before anything is computed.

    Parameters
    ----------
    tables : those that can be read.
    faults : (file, reason) of those that cannot.
    counts : rows by reason, of each table.
    duplicates : rows of each table, from 0, that are another row's pitch.
    warnings : everything to beware of.
    days : first and last day of each table, None where no date is known.
    endings : by how balls in play ended: tracked ones, the sum of their exit speeds (m/s), and untracked ones.
    """

    tables: tuple[TableFile, ...]
    faults: tuple[tuple[Path, str], ...]
    counts: tuple[dict[str, int], ...]
    duplicates: tuple[NDArray[np.uint32], ...]
    warnings: tuple[TableWarning, ...]
    days: tuple[tuple[date, date] | None, ...]
    endings: Mapping[str, tuple[int, float, int]] = field(default_factory=dict)

    @property
    def rows(self) -> int:
        """Rows of all tables together."""
        return sum(table.rows for table in self.tables)


def survey_tables(
    paths: Sequence[Path],
    *,
    staging: Path,
    given: Mapping[str, str] | None = None,
    progress: Callable[[int, int], None] | None = None,
) -> Survey:
    """Return what some files hold; one that cannot be read does not keep the others.

    Parameters
    ----------
    staging : folder for copies of CSV files.
    given : heading by quantity, as `headings_of` takes it.
    """
    tables: list[TableFile] = []
    faults: list[tuple[Path, str]] = []
    for path in paths:
        try:
            tables.append(open_table(path, staging=staging / f"{len(tables):04d}", given=given))
        except InputError as error:
            faults.append((path, str(error)))
    duplicates = _duplicates(tables)
    counts, warnings, days = [], [], []
    endings: dict[str, tuple[int, float, int]] = {}
    total, done = sum(table.rows for table in tables), 0
    for number, table in enumerate(tables):
        look = _Look(number, table)
        for start in range(0, table.rows, PART):
            rows = _part(table, start, look.wanted())
            look.take(rows, duplicates[number])
            _count_endings(rows, endings)
            done += len(rows)
            if progress is not None:
                progress(done, total)
        counts.append(look.counts)
        warnings += look.warnings()
        days.append((min(look.days), max(look.days)) if look.days else None)
    return Survey(tuple(tables), tuple(faults), tuple(counts), tuple(duplicates), tuple(warnings), tuple(days), endings)


def _count_endings(rows: pl.DataFrame, endings: dict[str, tuple[int, float, int]]) -> None:
    """Add balls in play by their ending and kind to those counted."""
    names = [name for name in ("event", "batted_type") if name in rows.columns]
    if not names:
        return
    table = (
        rows.filter(pl.col("reason").is_in([USED, "untracked"]))
        .group_by(ending=pl.concat_str(*(pl.col(name).fill_null("") for name in names), separator=" "))
        .agg(tracked=(pl.col("reason") == USED).sum(), total=pl.col("exit_speed").sum(),
             lost=(pl.col("reason") != USED).sum())
    )  # fmt: skip
    for ending, tracked, total, lost in table.iter_rows():
        before = endings.get(ending, (0, 0.0, 0))
        endings[ending] = (before[0] + tracked, before[1] + total, before[2] + lost)


def parts(
    table: TableFile, *, quantities: Sequence[str], step: int, starts: Sequence[int]
) -> Iterator[pl.DataFrame]:  # fmt: skip
    """Yield some of a table's rows as `rows_of` gives them, a part at a time; as good as drawn, and always the same.

    Parameters
    ----------
    quantities : that are wanted, beside the exit speed.
    step : one row of so many.
    starts : first rows of the parts.
    """
    headings = table.headings.only("exit_speed", *quantities)
    for start in starts:
        frame = table.part(start, PART, headings=[column.heading for column in headings.columns.values()])
        number = np.arange(start, start + len(frame), dtype=np.uint32)
        number = number[number.astype(np.uint64) * np.uint64(7919) % np.uint64(step) == 0]
        if len(number):
            rows = rows_of(frame[number.astype(np.int64) - start], headings)
            yield rows.with_columns(pl.Series("row", number))


def _part(table: TableFile, start: int, quantities: Sequence[str]) -> pl.DataFrame:
    headings = table.headings.only(*quantities)
    frame = table.part(start, PART, headings=[column.heading for column in headings.columns.values()])
    return rows_of(frame, headings, first=start)


def _duplicates(tables: Sequence[TableFile]) -> list[NDArray[np.uint32]]:
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
    for number, table in enumerate(tables):
        asked = table.headings.only(*key_quantities(table.headings))
        if not asked.columns:
            continue
        names = [column.heading for column in asked.columns.values()]
        for start in range(0, table.rows, PART):
            key, known = pitch_keys(table.part(start, PART, headings=names), table.headings)
            yield number, start, key, known if passes == 1 else known & (key % np.uint64(passes) == turn)


class _Look:
    """One table, looked through part by part."""

    def __init__(self, number: int, table: TableFile) -> None:
        self.number, self.table = number, table
        self.counts = dict.fromkeys(REASONS, 0)
        self.days: set[date] = set()
        self.seen: dict[str, TableWarning] = {}
        self.held: dict[str, int] = {}
        self.endings: set[str] = set()
        self.lost: dict[str, int] = {}
        held = pl.scan_parquet(table.data).collect_schema()
        columns = table.headings.columns.items()
        self.texts = [name for name, one in columns if one.kind != "text" and not held[one.heading].is_numeric()]

    def wanted(self) -> list[str]:
        """Return the quantities to look at next: what is always looked at, and of what nothing was seen yet."""
        unseen = [name for name in self.table.headings.columns if not self.held.get(name)]
        return list(dict.fromkeys((*LOOKED_AT, *self.texts, *unseen)))

    def note(self, name: str, rows: pl.DataFrame, condition: pl.Expr | None = None, detail: str = "") -> None:
        row = pl.col("row")
        where = rows.select(row if condition is None else row.filter(condition))["row"]
        if len(where):
            warning = self.seen.setdefault(name, TableWarning(name, self.number, detail=detail))
            warning.count += len(where)
            warning.rows += (where.head(SHOWN - len(warning.rows)) + 1).to_list()

    def take(self, rows: pl.DataFrame, duplicates: NDArray[np.uint32]) -> None:
        headings = self.table.headings
        rows = with_duplicates(rows, duplicates)
        for reason, count in rows["reason"].value_counts().iter_rows():
            self.counts[reason] += count
        self.days |= set(rows["day"].drop_nulls().unique())
        for name in headings.columns:
            if name in rows.columns:
                self.held[name] = self.held.get(name, 0) + rows[name].len() - rows[name].null_count()
        for reason, name in (("untracked", "untracked"), ("bunt", "bunts"), ("foul", "fouls unmeasured"),
                             ("impossible", "impossible"), ("duplicate", "duplicates")):  # fmt: skip
            self.note(name, rows, pl.col("reason") == reason)
        self.note("unreadable", rows, pl.col("unreadable") > 0)
        used = rows.filter(pl.col("reason") == USED)
        if headings.has("description"):
            self.note("foul tips", rows, pl.col("description").str.to_lowercase().str.contains("foul.?tip"))
        if headings.has("plate_side"):
            late = (pl.col("season") >= FIRST_MIDDLE_SEASON).fill_null(value=False)
            tracked = pl.col("velocity_y").is_not_null() if headings.has("velocity_y") else pl.lit(value=False)
            self.note("plate reference", used, late & tracked)
            self.note("plate not moved", used, late & ~tracked)
        self.note("side unknown", used, pl.col("left").is_null())
        if headings.has("bat_speed") and not headings.has("velocity_y"):
            speeds = [pl.col(name).is_not_null() for name in ("release_speed", "plate_speed") if headings.has(name)]
            told = pl.any_horizontal(speeds) if speeds else pl.lit(value=False)
            self.note("pitch speed unknown", used, pl.col("bat_speed").is_not_null() & ~told)
        if headings.has("home_team"):
            for club, year, count in used.group_by("home_team", "season").len().iter_rows():
                if club is not None and home_park(club, year) is None:
                    self.lost[club] = self.lost.get(club, 0) + count
        self._doubt(used)
        if headings.has("event"):
            self.endings |= set(used["event"].drop_nulls().unique())

    def _doubt(self, used: pl.DataFrame) -> None:
        """Note columns that seem to stand in each other's place, or in another unit."""
        has = self.table.headings.has
        if len(used) < ENOUGH_TO_DOUBT:
            return

        def middle(name: str) -> float:
            return float(used[name].median() or 0.0) if has(name) else 0.0  # type: ignore[arg-type]

        ball, bat = middle("exit_speed"), middle("bat_speed")
        if bat and ball and bat > ball:
            self.note("swapped", used, detail="bats faster than the balls they hit: bat speed and exit speed")
        if ball and not is_usual(ball, "median_exit_speed"):
            self.note("unit", used, detail=f"exit speeds are {ball / MPH:.0f} mph in the median")
        if has("launch_angle") and 0 < float(used["launch_angle"].abs().max() or 0.0) < LEVEL:  # type: ignore[arg-type]
            self.note("unit", used, detail="no launch angle is above 1.6 degrees: are they radians?")
        if has("map_x") and has("map_y"):
            places = used.select("map_x", "map_y").drop_nulls()
            bearing = bearing_of_place(places["map_x"].to_numpy(), places["map_y"].to_numpy())
            if len(places) >= ENOUGH_TO_DOUBT and float((abs(bearing) > FAIR).mean()) > MOST_FOUL:
                self.note("swapped", used, detail="most balls in play came down foul: hc_x and hc_y")

    def warnings(self) -> list[TableWarning]:
        table, number = self.table, self.number
        extra = []
        if table.cut:
            extra.append(TableWarning("export cut", number, table.rows, detail=f"{table.rows:,} rows"))
        if table.torn:
            extra.append(TableWarning("torn", number, 1, [table.rows]))
        if missing := self._missing_days():
            extra.append(TableWarning("days missing", number, len(missing), detail=_days_in_words(missing)))
        columns = table.headings.columns
        extra += [TableWarning("part off", number, table.rows, detail=words) for words in _parts_off(table.headings)]
        if self.lost:
            shown = ", ".join(sorted(self.lost)[:6])
            extra.append(TableWarning("unknown park", number, sum(self.lost.values()), detail=shown))
        if len(self.endings) == 1 and self.counts[USED] >= FEW:
            extra.append(TableWarning("selected", number, self.counts[USED], detail=f"all {next(iter(self.endings))}"))
        if table.headings.has("player_name", "pitcher", "batter"):
            extra.append(TableWarning("name of the pitcher", number, table.rows))
        if not tells_pitches(table.headings):
            extra.append(TableWarning("cannot find duplicates", number, table.rows))
        for name, held in self.held.items():
            if not held and table.rows:
                extra.append(TableWarning("empty column", number, table.rows, detail=columns[name].heading))
        extra += [TableWarning("headings", number, table.rows, detail=note) for note in table.notes]
        return [*self.seen.values(), *extra]

    def _missing_days(self) -> list[tuple[date, date]]:
        """Return the gaps of more than `LONGEST_GAP` days inside one season."""
        days = sorted(self.days)
        return [(a, b) for a, b in pairwise(days) if (b - a).days > LONGEST_GAP and a.year == b.year]


def _parts_off(headings: Headings) -> Iterator[str]:
    """Yield what cannot be told for want of a column, and what would do."""
    here = headings.has
    if not here("launch_angle"):
        yield "no launch angle (launch_angle): no flights and no contacts"
    elif not (here("bearing") or here("launch_direction") or here("map_x", "map_y")):
        yield "no direction (hc_x and hc_y, Direction, bearing_deg): balls fly to centre field, no chances of home runs"
    elif not here("home_team"):
        yield "no home club (home_team): no chance of a home run in the park itself; air as at sea level"
    if not here("bat_speed"):
        yield "no bat speed (bat_speed): nothing of bats"
    elif not here("attack_angle"):
        yield "no attack angle (attack_angle): the usual one stands in, and offsets are three times less sure"
    if here("bat_speed") and not here("plate_side", "plate_height"):
        yield "no place of the pitch (plate_x, plate_z): the side of the bat that was met cannot be told"
    if not (here("batter") or here("batter_name")):
        yield "no batter: no table of players"


def with_duplicates(rows: pl.DataFrame, duplicates: NDArray[np.uint32]) -> pl.DataFrame:
    """Return rows with those marked that are another row's pitch."""
    if not len(duplicates):
        return rows
    first, last = int(rows["row"][0]), int(rows["row"][-1])
    mine = duplicates[np.searchsorted(duplicates, first) : np.searchsorted(duplicates, last, side="right")]
    again = pl.Series(np.isin(rows["row"].to_numpy(), mine))
    return rows.with_columns(reason=pl.when(again).then(pl.lit("duplicate")).otherwise(pl.col("reason")))


def _days_in_words(gaps: list[tuple[date, date]]) -> str:
    shown = "; ".join(f"{first} to {last}" for first, last in gaps[:3])
    return f"between {shown}" + (f" and {len(gaps) - 3} more" if len(gaps) > 3 else "")

"""One table looked through part by part: what is in it, what to beware of, and which columns are doubtful.

Columns are doubted by what is usual of many balls. Bounds are wide enough for the balls of children and of the major
league, and narrow enough that no such table is still inside when it is read in another unit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from datetime import date
from itertools import pairwise

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.flight.bearing import bearing_of_place
from sweetspot.plausibility import PlausibleRange, bounds
from sweetspot.seasons.balls import ELSEWHERE, FIRST_MIDDLE_SEASON, home_park
from sweetspot.seasons.duplicates import tells_pitches, with_duplicates
from sweetspot.seasons.rows import (
    BUNTED,
    DATED,
    POSSIBLE,
    REASONED,
    REASONS,
    SIDED,
    TIP,
    UNSURE,
    USED,
    by_value,
    is_unsure,
)
from sweetspot.seasons.table_file import TableFile, TableWarning
from sweetspot.tables.headings import Headings, TableColumn
from sweetspot.tables.vocabulary import FAHRENHEIT_ZERO, UNITS
from sweetspot.units import DEGREE, MPH, grouped

ENOUGH = 30
"""Balls of a part of a table from which columns are doubted."""


TYPICAL: Mapping[str, tuple[float, str]] = {
    **{
        name: (0.5, f"median_{name}")
        for name in (
            *("exit_speed", "bat_speed", "release_speed", "plate_speed", "plate_height"),
            *("temperature", "pressure", "humidity"),
        )
    },
    "distance": (0.99, "longest_distance"),
}
"""The quantile of a column that is looked at, and its name in the table of bounds."""
ANGLES = ("launch_angle", "attack_angle", "tilt", "attack_direction", "attack_to_right", "launch_direction", "bearing")
DOUBTFUL = (*TYPICAL, *ANGLES, "map_x", "map_y")
"""Quantities whose columns are doubted."""
LEVEL = 1.6 * DEGREE
"""rad; where 99 of 100 are less, a column of degrees is written in radians."""
FASTER = 1.2
"""Least ratio of ball to bat speed in the median: some 88 to 70 mph in the major league."""
STEEP_MEDIAN, NEGATIVE, IMPOSSIBLE = 45 * DEGREE, 0.05, 0.2
"""rad of the median launch angle, the part of exit speeds below 0, above which the two stand in each other's place; and
the part of both that cannot be from which their unit is doubted."""


def unusual(some: pl.DataFrame, columns: Mapping[str, TableColumn]) -> Iterator[tuple[str, str]]:
    """Yield each quantity whose numbers are usual in another unit, with a description of the fault.

    ``some``: balls in play, those that cannot be among them, in SI.
    """
    for name, (quantile, quantity) in TYPICAL.items():
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) < ENOUGH:
            continue
        value, usual = float(held.cast(pl.Float64).quantile(quantile)), bounds(quantity)  # type: ignore[arg-type]
        if usual.verdict(value) != "fine":
            middle = "in the median" if quantile == 0.5 else "for the longest in a hundred"
            yield (
                name,
                (
                    f"{columns[name].heading} is {usual.in_unit(value):.3g} {usual.sign} {middle}; usual is "
                    f"{usual.low:g} to {usual.high:g} {usual.sign}{_as_if_in(columns[name], value, usual)}"
                ),
            )
    for name in ANGLES:
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) >= ENOUGH and 0 < float(held.abs().quantile(0.99)) < LEVEL:  # type: ignore[arg-type]
            yield name, f"no {columns[name].heading} is above 1.6 degrees: are they radians?"


def _as_if_in(column: TableColumn, value: float, usual: PlausibleRange) -> str:
    """Return in words the unit in which the same numbers would be usual."""
    if column.kind == "pressure":
        return ": is it reduced to sea level, as weather reports give it?"
    for unit, _ in _usual_readings(column, value, usual):
        return f": are they {unit}?"
    return ""


def _usual_readings(column: TableColumn, value: float, usual: PlausibleRange) -> Iterator[tuple[str, float]]:
    """Yield each unit in which the same numbers would be usual, and what they would be, SI."""
    written = (value - column.zero) / column.factor
    for unit, factor in UNITS[column.kind].items():
        zero = FAHRENHEIT_ZERO if column.kind == "temperature" and factor != 1 else 0.0
        if usual.verdict(zero + factor * written) == "fine":
            yield unit, zero + factor * written


def _usual_speed(name: str, value: float, columns: Mapping[str, TableColumn]) -> float:
    """Return a median speed as it is if it is usual, or in the unit in which it would be."""
    usual = bounds(f"median_{name}")
    if usual.verdict(value) == "fine":
        return value
    return next((speed for _, speed in _usual_readings(columns[name], value, usual)), value)


def exchanged(some: pl.DataFrame, columns: Mapping[str, TableColumn]) -> str:
    """Return the two columns that seem to be swapped; "": none.

    Bats faster than balls may also be in another unit: then balls are as much faster in it as balls in play are.

    ``some``: balls in play, those that cannot be among them, in SI.
    """
    if {"exit_speed", "launch_angle"} <= set(some.columns) and len(some) >= ENOUGH:
        slow = (some["exit_speed"] < 0).mean() or 0.0
        if float(slow) > NEGATIVE and float(some["launch_angle"].median() or 0.0) > STEEP_MEDIAN:  # type: ignore[arg-type]
            return "speeds below 0 and launch angles near straight up: exit speed and launch angle"
    if {"exit_speed", "bat_speed"} <= set(some.columns):
        ball, bat = (float(some[name].median() or 0.0) for name in ("exit_speed", "bat_speed"))  # type: ignore[arg-type]
        if bat > ball > 0 and _usual_speed("exit_speed", ball, columns) < FASTER * _usual_speed(
            "bat_speed", bat, columns
        ):
            return "bats faster than the balls they hit: bat speed and exit speed"
    return ""


LOOKED_AT = (*POSSIBLE, "home_team", "park", "game_kind", *UNSURE, *REASONED, *SIDED, *DATED)
"""Quantities that the first look asks of every row; of the others only whether they hold anything."""
AGAIN, AGAIN_PART = 5, 0.005
"""Balls of a part of a table that have the very same exit speed and angle, at least, and their part of it: tracked ones
of a season stand a hundred times less often in the densest place."""
PAIRED = 10_000
"""Exit speed in tenths of a mph times this, and the launch angle in tenths of a degree, -900 to 900, are one number."""
SHOWN = 20
"""Rows named with a warning."""
FEW = 50
"""Balls below which their ending alike may be chance."""
LONGEST_GAP = 5
"""Days without a game inside a table before it is said; an all-star break has four."""
ASKED_ALWAYS = (*(name for name in DOUBTFUL if name not in ANGLES), "velocity_y")
"""Quantities of which a first look asks in which rows they are missing, or more."""
SAMPLED = 4096
"""Balls of a part that are looked at for that, evenly drawn."""
FAIR = math.radians(50)
"""rad; bearings beyond are foul."""
MOST_FOUL = 0.3
"""Part of the balls in play that may come down foul; caught ones are a tenth at most."""


NAMED = {
    **{"untracked": "untracked", "bunt": "bunts", "foul": "fouls"},
    **{"impossible": "impossible", "duplicate": "duplicates"},
}
"""Warnings that go with a row's reason."""


class TableLook:
    """One table, looked through part by part."""

    def __init__(self, number: int, table: TableFile) -> None:
        self.number, self.table = number, table
        self.counts, self.rows = dict.fromkeys(REASONS, 0), 0
        self.days: dict[date, int] = {}
        self.seen: dict[str, TableWarning] = {}
        self.endings: set[str] = set()
        self.lost: set[str] = set()
        self.fouls_measured = 0
        held = pl.scan_parquet(table.data).collect_schema()
        columns = table.headings.columns.items()
        self.sure = _surely_possible(table, held)
        self.held = dict.fromkeys(self.sure, table.rows)
        numbers = {name: held[column.heading] for name, column in columns if column.kind != "text"}
        self.texts = [name for name, kind in numbers.items() if not kind.is_numeric()]

    def wanted(self) -> list[str]:
        """Return the quantities to look at next: what is always looked at, and of what nothing was seen yet."""
        unseen = [name for name in self.table.headings.columns if not self.held.get(name)]
        looked_at = [name for name in LOOKED_AT if name not in self.sure]
        return list(dict.fromkeys((*looked_at, *self.texts, *unseen)))

    def _note(
        self, name: str, rows: pl.DataFrame, condition: pl.Expr | None = None, detail: str = "", of: str = ""
    ) -> None:
        row = pl.col("row")
        where = rows.select(row if condition is None else row.filter(condition))["row"]
        if len(where):
            warning = self.seen.setdefault(f"{name} {of}".strip(), TableWarning(name, self.number, detail=detail))
            warning.count += len(where)
            warning.rows += self.table.numbers(where.head(SHOWN - len(warning.rows)).to_numpy()).tolist()

    def take(self, rows: pl.DataFrame, duplicates: NDArray[np.uint32]) -> None:
        headings = self.table.headings
        rows = with_duplicates(rows, duplicates)
        counts = dict(rows["reason"].value_counts().iter_rows())
        for reason, count in counts.items():
            self.counts[reason] += count
        self.rows += len(rows)
        for day, first in rows.group_by("day").agg(pl.col("row").min()).iter_rows():
            if day is not None:
                self.days[day] = min(first, self.days.get(day, first))
        for name in headings.columns:
            if name in rows.columns:
                self.held[name] = self.held.get(name, 0) + rows[name].len() - rows[name].null_count()
        for reason, name in NAMED.items():
            if reason in counts:
                self._note(name, rows, pl.col("reason") == reason)
        if "foul" in counts:
            self.fouls_measured += rows.filter(pl.col("reason") == "foul")["exit_speed"].count()
        self._note("unreadable", rows, pl.col("unreadable") > 0)
        self._note("cannot be", rows, pl.col("beyond") > 0)
        used = rows.filter(pl.col("reason") == USED) if counts.get(USED) != len(rows) else rows
        if headings.has("description"):
            self._note("foul tips", rows, pl.lit(by_value(rows["description"], _is_foul_tip)))
        if headings.has("plate_side"):
            late = (pl.col("season") >= FIRST_MIDDLE_SEASON).fill_null(value=False)
            tracked = pl.col("velocity_y").is_not_null() if headings.has("velocity_y") else pl.lit(value=False)
            self._note("plate reference", used, late & tracked)
            self._note("plate not moved", used, late & ~tracked)
        self._note("side unknown", used, pl.col("left").is_null())
        for confidence in UNSURE:
            if headings.has(confidence):
                among = used if confidence == "landing_confidence" else rows
                self._note("not measured", among, is_unsure(confidence), confidence.replace("_", " "), of=confidence)
        self._note_placeholders(used)
        if headings.has("game_kind"):
            self._note("other games", used, pl.col("game_kind").is_in(ELSEWHERE))
        if headings.has("bat_speed") and not headings.has("velocity_y"):
            speeds = [pl.col(name).is_not_null() for name in ("release_speed", "plate_speed") if headings.has(name)]
            pitched = pl.any_horizontal(speeds) if speeds else pl.lit(value=False)
            self._note("pitch speed unknown", used, pl.col("bat_speed").is_not_null() & ~pitched)
        if headings.has("home_team") or headings.has("park"):
            self._note_parks(used)
        self._doubt(rows.filter(pl.col("reason").is_in([USED, "impossible"])) if "impossible" in counts else used)
        if headings.has("event"):
            self.endings |= set(used["event"].drop_nulls().unique())

    def _note_parks(self, used: pl.DataFrame) -> None:
        """Note balls whose park is not known."""
        names = [name for name in ("park", "home_team") if self.table.headings.has(name)]
        used = used.with_columns(place=pl.coalesce(names))
        for club, year in used.select("place", "season").drop_nulls("place").unique().iter_rows():
            park = home_park(club, year)
            here = (pl.col("place") == club) & pl.col("season").eq_missing(pl.lit(year, pl.Int32))
            if park is None:
                self._note("unknown park", used, here)
                self.lost.add(club)

    def _note_placeholders(self, used: pl.DataFrame) -> None:
        """Note balls with an exit speed and launch angle that stand in the table again and again."""
        if not self.table.headings.has("launch_angle"):
            return
        speed, angle = pl.col("exit_speed") / (0.1 * MPH), pl.col("launch_angle") / (0.1 * DEGREE)
        pair = (speed.round() * PAIRED + angle.round()).cast(pl.Int32)  # sorted as one number, many times as fast
        pairs = used.select("row", pair=pair).drop_nulls()
        found, times = np.unique(pairs["pair"].to_numpy(), return_counts=True)
        often = times >= max(AGAIN, AGAIN_PART * len(used))
        if often.any():
            found, times = found[often], times[often]
            most = found[np.lexsort((found, times))[::-1][:3]]
            speeds = np.rint(most / PAIRED)
            words = "; ".join(
                f"{speed / 10:.1f} mph at {angle / 10:.1f} degrees"
                for speed, angle in zip(speeds, most - PAIRED * speeds, strict=True)
            )
            self._note("placeholders", pairs, pl.col("pair").is_in(found.tolist()), detail=words)

    def _doubt(self, played: pl.DataFrame) -> None:
        """Note columns that seem to stand in each other's place, or in another unit, by some of the balls in play."""
        has, columns = self.table.headings.has, self.table.headings.columns
        some = played.select(name for name in ("reason", *DOUBTFUL) if name in played.columns)
        some = some.gather_every(max(1, len(played) // SAMPLED))
        if len(some) < ENOUGH:
            return
        place, units = exchanged(some, columns), dict(unusual(some, columns))
        if place:
            self._note("swapped", played, detail=place)
            for name in ("exit_speed", "bat_speed" if "bats" in place else "launch_angle"):
                units.pop(name, None)
        if not place and "exit_speed" not in units and (some["reason"] != USED).mean() > IMPOSSIBLE:  # type: ignore[operator]
            units["exit_speed"] = "many exit speeds or launch angles cannot be"
        for name, words in units.items():
            self._note("unit", played, detail=words, of=name)
        if has("map_x") and has("map_y"):
            places = some.select("map_x", "map_y").drop_nulls()
            bearing = bearing_of_place(places["map_x"].to_numpy(), places["map_y"].to_numpy())
            if len(places) >= ENOUGH and float((abs(bearing) > FAIR).mean()) > MOST_FOUL:
                self._note("swapped", played, detail="most balls in play came down foul: hc_x and hc_y", of="map")

    def warnings(self) -> list[TableWarning]:
        table, number = self.table, self.number
        extra = []
        if table.cut:
            extra.append(TableWarning("export cut", number, table.rows, detail=f"{grouped(table.rows)} rows"))
        if table.torn:
            extra.append(TableWarning("torn", number, 1, [int(table.numbers(table.rows - 1))]))
        if gaps := self._gaps():
            after = table.numbers([self.days[end] for _, end in gaps]).tolist()
            extra.append(TableWarning("days missing", number, len(gaps), after[:SHOWN], _days_in_words(gaps)))
        if "fouls" in self.seen:
            some = (
                f"{grouped(self.fouls_measured)} of them have an exit speed" if self.fouls_measured else "none has one"
            )
            self.seen["fouls"].detail = some
        if self.lost:
            self.seen["unknown park"].detail = ", ".join(sorted(self.lost)[:6])
        columns = table.headings.columns
        held = table.headings.only(*(name for name, count in self.held.items() if count))
        extra += [TableWarning("part off", number, table.rows, detail=words) for words in _parts_off(held)]
        if len(self.endings) == 1 and self.counts[USED] >= FEW:
            extra.append(TableWarning("selected", number, self.counts[USED], detail=f"all {next(iter(self.endings))}"))
        if table.headings.has("player_name", "pitcher", "batter"):
            extra.append(TableWarning("name of the pitcher", number, table.rows))
        if table.headings.has("spin_rate"):
            extra.append(TableWarning("spin not used", number, table.rows, detail=columns["spin_rate"].heading))
        if not tells_pitches(table.headings):
            extra.append(TableWarning("cannot find duplicates", number, table.rows))
        for name, count in self.held.items():
            if not count and table.rows:
                extra.append(TableWarning("empty column", number, table.rows, detail=columns[name].heading))
        extra += [TableWarning("headings", number, table.rows, detail=note) for note in table.notes]
        return [*self.seen.values(), *extra]

    def _gaps(self) -> list[tuple[date, date]]:
        """Return the gaps of more than `LONGEST_GAP` days inside one season."""
        days = sorted(self.days)
        return [(a, b) for a, b in pairwise(days) if (b - a).days > LONGEST_GAP and a.year == b.year]


NO_CLUB = (
    "no home club (home_team) and no park (park), nor --park or --fence: no chance of a home run in the park itself; "
    "air as at sea level or --elevation"
)
"""The warning about a table that does not say where its balls were hit."""


def _parts_off(headings: Headings) -> Iterator[str]:
    """Yield the results that are missing for want of a column, and the columns that would give them."""
    here = headings.has
    if not here("launch_angle"):
        yield "no launch angle (launch_angle): no flights and no contacts"
    elif not (here("bearing") or here("launch_direction") or here("map_x", "map_y")):
        yield "no direction (hc_x and hc_y, Direction, bearing_deg): balls fly to centre field, no chances of home runs"
    elif not (here("home_team") or here("park")):
        yield NO_CLUB
    if not here("bat_speed"):
        yield "no bat speed (bat_speed): nothing of bats"
    elif not here("attack_angle"):
        yield "no attack angle (attack_angle): the usual one stands in, and offsets are three times less sure"
    if here("bat_speed") and not (here("axial_offset") or here("plate_side", "plate_height")):
        yield "no place of the pitch (plate_x, plate_z): the side of the bat that was met is not known"
    if not any(map(here, BUNTED)):
        yield "nothing tells bunts (des, events): they count as balls in play"
    elif headings.system == "Statcast" and not here("words"):
        yield "no description in words (des): of bunts only sacrifices are known, the others count as balls in play"
    if not (here("batter") or here("batter_name")):
        yield "no batter: no table of players"


def _surely_possible(table: TableFile, schema: pl.Schema) -> set[str]:
    """Return measurements of which the file itself tells that all are possible and that there are some.

    Of those a first look asks nothing further, and they are not read for it.
    """
    sure = set()
    for name, column in table.headings.columns.items():
        if name in POSSIBLE and name not in ASKED_ALWAYS and column.heading in table.ranges:
            least, most = POSSIBLE[name]
            ends = sorted(column.zero + column.factor * end for end in table.ranges[column.heading])
            in_degrees = name not in ANGLES or max(-ends[0], ends[1]) > LEVEL  # else they may be radians
            if in_degrees and least <= ends[0] <= ends[1] <= most and schema[column.heading].is_float():
                sure.add(name)
    return sure


def _is_foul_tip(text: pl.Expr) -> pl.Expr:
    return text.str.to_lowercase().str.contains(TIP)


def _days_in_words(gaps: list[tuple[date, date]]) -> str:
    words = "; ".join(f"{first} to {last}" for first, last in gaps[:3])
    return f"between {words}" + (f" and {len(gaps) - 3} more" if len(gaps) > 3 else "")

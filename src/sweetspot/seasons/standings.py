"""Tables of players, pitchers, clubs, pitch types, counts and months: sums of groups, every measure partly pooled."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import compress
from typing import Annotated

import numpy as np
import polars as pl

from sweetspot.seasons.ball_columns import ENDINGS, WITH, columns_in, columns_of_other
from sweetspot.seasons.ball_maps import is_home_run
from sweetspot.seasons.pooling import BALLS, MEAN, POSITIVE, SQUARES, Bounds, Spread, pooled_groups
from sweetspot.seasons.rows import by_value
from sweetspot.seasons.season_table import Season
from sweetspot.units import MPH
from sweetspot.units.dimensions import DISTANCE, LENGTH, RATIO, SPEED, Dimension, System

OFTEN = 8
"""Parts after which what was counted is added up."""
BOX = 0.1 * MPH
"""m/s, the step in which exit speeds are recorded."""
TOP = 0.8
"""Quantile from which on balls are a group's hardest: EV20 is their mean."""
NAMES = {"batter": "batter_name", "pitcher": "pitcher_name"}
"""Columns that hold the names of what is grouped by."""
KNOWN_BY = {
    "home_runs_expected": "home_run_here",
    "home_runs": "home_runs",
    "home_runs_average_park": "home_runs_in_30",
    "doubters": "home_runs_in_30",
    "mostly_gone": "home_runs_in_30",
    "no_doubters": "home_runs_in_30",
}
"""What a group's home runs are counted by: where it is known of none of its balls, their number is missing, not 0."""
KNOWN = "known "
ALSO = ("exit_speed", "home_run_here", "home_runs_in_30", "home_run_kind", "event")
COUNTED = (
    pl.len().alias("balls"),
    pl.col("home_run_here").sum().alias("home_runs_expected"),
    (pl.col("home_runs_in_30").sum() / 30).alias("home_runs_average_park"),
    pl.col("home_runs").sum(),
    *(
        (pl.col("home_run_kind") == number).sum().alias(name)
        for number, name in ((1, "doubters"), (2, "mostly_gone"), (3, "no_doubters"))
    ),
    *(pl.col(name).count().alias(KNOWN + name) for name in dict.fromkeys(KNOWN_BY.values())),
)


def group_sums(
    parts: Sequence[pl.LazyFrame], *, keys: Sequence[str], measures: Sequence[str]
) -> dict[str, pl.DataFrame]:
    """Return for each column of groups a row a group, in order: balls, home runs, EV20, and the measures' sums.

    ``measures``: columns that are averaged; of each ``MEASURE balls``, ``MEASURE mean`` and ``MEASURE squares`` about
    it.
    """
    schema: dict[str, pl.DataType] = {}
    for part in parts:
        schema = {**part.collect_schema(), **schema}
    asked = dict.fromkeys((*keys, *measures, *ALSO, *(name for name in NAMES.values() if name in schema)))
    nothing = pl.DataFrame(schema={name: schema[name] for name in asked})
    sums = [_Sums(key, list(schema), measures) for key in keys]
    for number, part in enumerate(parts, start=1):
        held = [name for name in part.collect_schema().names() if name in asked]
        rows = _made_ready(pl.concat([nothing, part.select(held).collect()], how="diagonal"))
        for group in sums:
            group.take(rows)
            if number % OFTEN == 0:
                group.add_up()
    return {group.key: group.table(measures) for group in sums}


def _made_ready(rows: pl.DataFrame) -> pl.DataFrame:
    """Return rows with exact numbers, whether each ball was a home run, and the box of its exit speed."""
    gone = by_value(rows["event"], is_home_run)
    box = (pl.col("exit_speed") / BOX).round().cast(pl.Int32)
    return rows.with_columns(gone.alias("home_runs"), box=box).with_columns(pl.col(pl.Float32).cast(pl.Float64))


class _Sums:
    """Sums over the groups of one column."""

    def __init__(self, key: str, columns: Sequence[str], measures: Sequence[str]) -> None:
        self.key, self.name = key, NAMES.get(key, "")
        self.counts: list[pl.DataFrame] = []
        self.boxes: list[pl.DataFrame] = []
        asked = list(COUNTED)
        for measure in measures:
            value = pl.col(measure)
            asked += [
                value.count().alias(f"{measure} {BALLS}"),
                value.sum().alias(f"{measure} sum"),
                (value * value).sum().alias(f"{measure} square"),
            ]
        if self.name in columns:
            asked.append(pl.col(self.name).drop_nulls().first().alias("name"))
        self.asked = asked

    def take(self, rows: pl.DataFrame) -> None:
        rows = rows.filter(pl.col(self.key).is_not_null())
        if not len(rows):
            return
        self.counts.append(rows.group_by(self.key).agg(self.asked))
        self.boxes.append(
            rows.group_by(self.key, "box").agg(held=pl.col("exit_speed").count(), speeds=pl.col("exit_speed").sum())
        )

    def add_up(self) -> None:
        if len(self.counts) < 2:
            return
        summed = [name for name in self.counts[0].columns if name not in (self.key, "name")]
        named = [pl.col("name").drop_nulls().first()] if "name" in self.counts[0].columns else []
        self.counts = [pl.concat(self.counts).group_by(self.key).agg(pl.col(summed).sum(), *named)]
        self.boxes = [pl.concat(self.boxes).group_by(self.key, "box").agg(pl.col("held", "speeds").sum())]

    def table(self, measures: Sequence[str]) -> pl.DataFrame:
        if not self.counts:
            return pl.DataFrame({self.key: pl.Series([], dtype=pl.String)})
        self.add_up()
        table = self.counts[0].join(self._hardest(), on=self.key, how="left").sort(self.key)
        several = [pl.col(f"{measure} {BALLS}") for measure in measures]
        means = [
            (pl.col(f"{measure} sum") / count).alias(f"{measure} {MEAN}")
            for measure, count in zip(measures, several, strict=True)
        ]
        about = [
            (pl.col(f"{measure} square") - pl.col(f"{measure} sum") ** 2 / count).clip(0).alias(f"{measure} {SQUARES}")
            for measure, count in zip(measures, several, strict=True)
        ]
        counted = [pl.when(pl.col(KNOWN + by) > 0).then(pl.col(name)).alias(name) for name, by in KNOWN_BY.items()]
        gone = [
            *(f"{measure} {what}" for measure in measures for what in ("sum", "square")),
            *(name for name in table.columns if name.startswith(KNOWN)),
        ]
        return table.with_columns(*means, *about, *counted).drop(gone)

    def _hardest(self) -> pl.DataFrame:
        """Return the mean of the hardest fifth of each group; of the box that it begins in, as many as belong to it."""
        held = pl.col("held")
        first = ((held.sum() - 1) * TOP + 0.5).floor().over(self.key)
        boxes = self.boxes[0].drop_nulls("box").sort(self.key, "box")
        boxes = boxes.with_columns(upto=held.cum_sum().over(self.key), first=first)
        mine = (pl.col("upto") - pl.col("first")).clip(0, held)
        return boxes.group_by(self.key).agg(ev20=(pl.col("speeds") / held * mine).sum() / mine.sum())


GROUPS: Mapping[str, str] = {
    **{"batter": "players", "pitcher": "pitchers", "team": "clubs", "pitch_type": "pitch types"},
    **{"count": "counts", "month": "months", "park": "parks"},
}
"""Columns that balls are grouped by, and what their tables are called."""
ABOVE = "squared_up_above"
"""By how much more often a ball is squared up than balls of its bat speed."""
MEASURES: Mapping[str, tuple[str, str]] = columns_in("measures")
"""Measures averaged over balls: scale and meaning."""
BOUNDS: Mapping[str, Bounds] = {
    name: (-1.0, 1.0) if name == ABOVE else (0.0, 1.0) for name, (scale, _) in MEASURES.items() if scale == "share"
} | {"from_best": POSITIVE}
"""Least and greatest value of the measures that come near one: shares, how far a share may be from another, and the
distance from the best place."""
NEAR, RARE = 0.1, 3.0
"""From 0 or 1 a share, and of the rarer kind that a group has on average, below which intervals of 90 % hold 84 to 88 %
where groups differ by about as much as the share itself: in made-up leagues (`docs/theory/season.md`)."""
PLAIN = (
    *("balls", "ev20", "home_runs_expected", "home_runs_average_park", "home_runs"),
    *("doubters", "mostly_gone", "no_doubters", "name"),
)
"""Columns that are counted and not pooled."""


@dataclass(frozen=True)
class Standing:
    """One group column's table.

    ``table``: a row per group: balls, and of every measure pooled, low50 … high90, reliability, percentile, raw mean.
    ``spreads``: how balls and groups scatter, by measure.
    """

    key: str
    table: pl.DataFrame
    spreads: Mapping[str, Spread]

    def with_units(self, units: System) -> pl.DataFrame:
        """Return the table in a system's units, with the unit in every column's name."""
        names = self.table.columns
        scales = {name: scale for name, (scale, _) in MEASURES.items()} | {"ev20": "speed"}
        scales |= {name: "speed" for name in names if name.startswith(WITH) and f"{name}_balls" in names}
        columns = []
        for column in self.table.get_columns():
            stem = max((stem for stem in scales if _is_part(column.name, stem)), key=len, default="")
            label, part = stem, column.name[len(stem) :]
            if stem.startswith(WITH):
                label = f"gain_with_{stem.removeprefix(WITH).replace('-', '_')}"
            dimension = DIMENSIONS.get(scales.get(stem, ""), RATIO)
            if part in IN_UNITS:
                size = 1.0 if units == "si" else dimension.size
                columns.append((column / size if size != 1 else column).alias(dimension.key(label + part, units)))
            else:
                columns.append(column.alias(label + part))
        return pl.DataFrame(columns)


DIMENSIONS: Mapping[str, Dimension] = {"speed": SPEED, "offset": LENGTH, "distance": DISTANCE}
"""Of the scales of measures; the others are ratios."""
IN_UNITS = ("", "_mean", "_spread", "_low50", "_high50", "_low90", "_high90")
"""Ends of a measure's columns that have its unit."""


def _is_part(name: str, stem: str) -> bool:
    return name.startswith(stem) and name[len(stem) :] in (*IN_UNITS, "_balls", "_reliability", "_percentile")


def rare_shares(table: Standing) -> list[str]:
    """Return the shares of a table that rest on so few of a kind that their intervals hold less than they say."""
    rare = []
    for name, spread in table.spreads.items():
        rarer = min(spread.mean, 1 - spread.mean)
        if BOUNDS.get(name) == (0.0, 1.0) and 0 < rarer < NEAR and rarer * spread.balls < RARE * spread.groups:
            rare.append(name)
    return rare


def all_standings(parts: Sequence[pl.LazyFrame], *, keys: Sequence[str] = tuple(GROUPS)) -> dict[str, Standing]:
    """Return the tables of groupings; those are left out that no ball has a group of.

    ``parts``: groups and measures of balls, a part of the table after the other; each is read once, by itself, so that
    memory does not hang on how many balls there are. ``keys``: some of `GROUPS`.
    """
    names = list(dict.fromkeys(name for part in parts for name in part.collect_schema().names()))
    others = [name for name in names if name.startswith(WITH)]
    measures = [*(name for name in MEASURES if name in names), *others]
    summed = group_sums(parts, keys=keys, measures=measures)
    return {key: _standing(table, key, measures, others) for key, table in summed.items() if len(table)}


def _standing(summed: pl.DataFrame, key: str, measures: Sequence[str], others: list[str]) -> Standing:
    table = summed.select(key, *(name for name in PLAIN if name in summed.columns))
    spreads = {}
    for measure in measures:
        moments = summed.select(
            key, *(pl.col(f"{measure} {what}").alias(what) for what in (BALLS, MEAN, SQUARES))
        ).filter(pl.col(BALLS) > 0)
        measured, spreads[measure] = pooled_groups(moments, key=key, bounds=BOUNDS.get(measure))
        if "pooled" not in measured.columns:
            continue
        renamed = measured.rename(
            {"balls": f"{measure}_balls", "mean": f"{measure}_mean", "pooled": measure}
            | {
                name: f"{measure}_{name}"
                for name in ("spread", "low50", "high50", "low90", "high90", "reliability", "percentile")
            }
        )
        table = table.join(renamed, on=key, how="left")
    if others:
        table = table.with_columns(_best_bat(table, others))
    return Standing(key, table, spreads)


def _best_bat(table: pl.DataFrame, others: list[str]) -> pl.Series:
    """Return the bat that would serve each group best in exit speed; its own where every other gives less."""
    gains = np.stack(
        [
            table[name].fill_null(-np.inf).to_numpy() if name in table.columns else np.full(len(table), -np.inf)
            for name in others
        ]
    )
    best = gains.argmax(axis=0)
    names = [others[number].removeprefix(WITH) if gains[number, row] > 0 else "own" for row, number in enumerate(best)]
    return pl.Series("best_bat", names)


def above_expected_parts(parts: Sequence[pl.LazyFrame]) -> list[pl.LazyFrame]:
    """Return counted balls with ``squared_up_above``: the league's flag less what such bat speeds have.

    The expectation is the parabola in bat speed through all balls of the season. Sums are added up part by part, in
    order, so that they are the same to the last digit however many threads there are.
    """
    speed, flag = pl.col("bat_speed").cast(pl.Float64) - 32.0, pl.col("league_squared_up").cast(pl.Float64)
    square, along = np.zeros((3, 3)), np.zeros(3)
    flagged = ["league_squared_up" in part.collect_schema().names() for part in parts]
    for part in compress(parts, flagged):
        rated = part.select(speed=speed, flag=flag).drop_nulls().collect()
        powers = np.stack([rated["speed"].to_numpy() ** power for power in range(3)])
        square += np.einsum("in,jn->ij", powers, powers)
        along += np.einsum("in,n->i", powers, rated["flag"].to_numpy())
    if square[0, 0] < 10:
        return list(parts)
    a, b, c = np.linalg.lstsq(square, along, rcond=None)[0].tolist()
    fresh = (flag - (a + b * speed + c * speed**2)).cast(pl.Float32).alias(ABOVE)
    return [part.with_columns(fresh) if has else part for part, has in zip(parts, flagged, strict=True)]


@dataclass(frozen=True)
class OtherBatGain:
    """The gain of a season's balls with another bat.

    ``balls``: hit with any other bat than this, and solved. ``gain``, ``low``, ``high``: mean change of their exit
    speeds, m/s; 90 % by the swing law, which errs alike for all balls.
    """

    bat: str
    balls: int
    gain: Annotated[float, SPEED]
    low: Annotated[float, SPEED]
    high: Annotated[float, SPEED]


def bat_gains(season: Season) -> list[OtherBatGain]:
    """Return the gains with all bats that were tried; those are left out that no ball could be tried with."""
    contact, system = season.setting.contact, season.setting.system
    gains = []
    for other in () if contact is None else contact.others:
        gain = pl.col(f"{WITH}{other.name}").cast(pl.Float64)
        balls, mean = _mean(season.counted_parts(), gain)
        if not balls:
            continue
        _, low, high = (pl.col(column.heading(system)).cast(pl.Float64) for column in columns_of_other(other.name))
        _, width = _mean(season.balls_parts(), (high - low).filter(high > low))
        reach = width * ENDINGS["speed"][system][1] / 2
        gains.append(OtherBatGain(other.name, balls, mean, mean - reach, mean + reach))
    return gains


def _mean(parts: Sequence[pl.LazyFrame], value: pl.Expr) -> tuple[int, float]:
    """Return the number of values, and their mean, 0 of none; added up part by part, always in the same order."""
    count, total = 0, 0.0
    for part in parts:
        values = part.select(value.drop_nulls()).collect().to_series().to_numpy()
        count, total = count + len(values), total + float(values.sum())
    return count, total / max(count, 1)

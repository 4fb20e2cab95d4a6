"""Counts, sums and squares of groups of balls, added up over a table of any size, read once and a part at a time."""

from __future__ import annotations

from collections.abc import Sequence

import polars as pl

from sweetspot.season.maps import is_home_run
from sweetspot.season.pooling import BALLS, MEAN, SQUARES
from sweetspot.season.rows import by_value
from sweetspot.units import MPH

OFTEN = 8
"""Parts after which what was counted is added up."""
BOX = 0.1 * MPH
"""m/s, the step in which exit speeds are recorded."""
TOP = 0.8
"""Quantile from which on balls are a group's hardest: EV20 is their mean."""
NAMES = {"batter": "batter_name", "pitcher": "pitcher_name"}
"""Columns that hold the names of what is grouped by."""
TOLD_BY = {
    "home_runs_expected": "home_run_here", "home_runs": "home_runs", "home_runs_average_park": "home_runs_in_30",
    "doubters": "home_runs_in_30", "mostly_gone": "home_runs_in_30", "no_doubters": "home_runs_in_30",
}  # fmt: skip
"""What a group's home runs are counted by: where it is known of none of its balls, their number is missing, not 0."""
TOLD = "told "
ALSO = ("exit_speed", "home_run_here", "home_runs_in_30", "home_run_kind", "event")
COUNTED = (
    pl.len().alias("balls"),
    pl.col("home_run_here").sum().alias("home_runs_expected"),
    (pl.col("home_runs_in_30").sum() / 30).alias("home_runs_average_park"),
    pl.col("home_runs").sum(),
    *((pl.col("home_run_kind") == number).sum().alias(name)
      for number, name in ((1, "doubters"), (2, "mostly_gone"), (3, "no_doubters"))),
    *(pl.col(name).count().alias(TOLD + name) for name in dict.fromkeys(TOLD_BY.values())),
)  # fmt: skip


def group_sums(
    parts: Sequence[pl.LazyFrame], *, keys: Sequence[str], measures: Sequence[str]
) -> dict[str, pl.DataFrame]:  # fmt: skip
    """Return for each column of groups a row a group, in order: balls, home runs, EV20, and the measures' sums.

    Parameters
    ----------
    parts : groups and measures of balls, a part of the table after the other; each is read once, by itself.
    keys : columns of the groups; balls without one are left out.
    measures : columns that are averaged; of each ``MEASURE balls``, ``MEASURE mean`` and ``MEASURE squares`` about it.
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
        for one in sums:
            one.take(rows)
            if number % OFTEN == 0:
                one.add_up()
    return {one.key: one.table(measures) for one in sums}


def _made_ready(rows: pl.DataFrame) -> pl.DataFrame:
    """Return rows with exact numbers, whether each ball was a home run, and the box of its exit speed."""
    gone = by_value(rows["event"], is_home_run)
    box = (pl.col("exit_speed") / BOX).round().cast(pl.Int32)
    return rows.with_columns(gone.alias("home_runs"), box=box).with_columns(pl.col(pl.Float32).cast(pl.Float64))


class _Sums:
    """What was counted of one column of groups."""

    def __init__(self, key: str, known: Sequence[str], measures: Sequence[str]) -> None:
        self.key, self.name = key, NAMES.get(key, "")
        self.counts: list[pl.DataFrame] = []
        self.boxes: list[pl.DataFrame] = []
        asked = list(COUNTED)
        for measure in measures:
            value = pl.col(measure)
            asked += [value.count().alias(f"{measure} {BALLS}"), value.sum().alias(f"{measure} sum"),
                      (value * value).sum().alias(f"{measure} square")]  # fmt: skip
        if self.name in known:
            asked.append(pl.col(self.name).drop_nulls().first().alias("name"))
        self.asked = asked

    def take(self, rows: pl.DataFrame) -> None:
        rows = rows.filter(pl.col(self.key).is_not_null())
        if not len(rows):
            return
        self.counts.append(rows.group_by(self.key).agg(self.asked))
        self.boxes.append(
            rows.group_by(self.key, "box").agg(held=pl.col("exit_speed").count(), speeds=pl.col("exit_speed").sum())
        )  # fmt: skip

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
        means = [(pl.col(f"{measure} sum") / count).alias(f"{measure} {MEAN}")
                 for measure, count in zip(measures, several, strict=True)]  # fmt: skip
        about = [(pl.col(f"{measure} square") - pl.col(f"{measure} sum") ** 2 / count).clip(0)
                 .alias(f"{measure} {SQUARES}") for measure, count in zip(measures, several, strict=True)]  # fmt: skip
        told = [pl.when(pl.col(TOLD + by) > 0).then(pl.col(name)).alias(name) for name, by in TOLD_BY.items()]
        gone = [*(f"{measure} {what}" for measure in measures for what in ("sum", "square")),
                *(name for name in table.columns if name.startswith(TOLD))]  # fmt: skip
        return table.with_columns(*means, *about, *told).drop(gone)

    def _hardest(self) -> pl.DataFrame:
        """Return the mean of the hardest fifth of each group; of the box that it begins in, as many as belong to it."""
        held = pl.col("held")
        boxes = self.boxes[0].drop_nulls("box").sort(self.key, "box").with_columns(
            upto=held.cum_sum().over(self.key), first=((held.sum() - 1) * TOP + 0.5).floor().over(self.key)
        )  # fmt: skip
        mine = (pl.col("upto") - pl.col("first")).clip(0, held)
        return boxes.group_by(self.key).agg(ev20=(pl.col("speeds") / held * mine).sum() / mine.sum())

"""Tables of players, pitchers, clubs, pitch types, counts and months: every measure partly pooled."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import compress

import numpy as np
import polars as pl

from sweetspot.season.bounded_pooling import Bounds
from sweetspot.season.counted import WITH
from sweetspot.season.pooling import BALLS, MEAN, POSITIVE, SQUARES, Spread, pooled_groups
from sweetspot.season.sums import group_sums
from sweetspot.units.dimensions import DISTANCE, LENGTH, RATIO, SPEED, Dimension, System

GROUPS: Mapping[str, str] = {
    "batter": "players", "pitcher": "pitchers", "team": "clubs", "pitch_type": "pitch types", "count": "counts",
    "month": "months", "park": "parks",
}  # fmt: skip
"""Columns that balls are grouped by, and what their tables are called."""
ABOVE = "squared_up_above"
"""By how much more often a ball is squared up than balls of its bat speed."""
MEASURES: Mapping[str, tuple[str, str]] = {
    "exit_speed": ("speed", "exit speed"),
    "bat_speed": ("speed", "bat speed"),
    "squared_up_ratio": ("ratio", "exit speed over this bat's ceiling"),
    "squared_up": ("share", "squared up against this bat"),
    "league_ratio": ("ratio", "exit speed over the league's ceiling"),
    "league_squared_up": ("share", "squared up by the league's formula"),
    ABOVE: ("share", "squared up by the league's formula, above expected for the bat speed"),
    "blast": ("share", "blasts"),
    "kept_vertically": ("share", "kept vertically"),
    "from_best": ("offset", "distance from the best place along the bat"),
    "centred": ("share", "centred: within 4 in along the bat"),
    "lined_up": ("share", "lined up: within 2 in over or under"),
    "on_time": ("share", "on time: within 7 ms, where a table has the place of contact before the batter"),
    "perfect": ("share", "met perfectly: centred, lined up and on time"),
    "tip_side": ("share", "met on the tip's side"),
    "offset": ("offset", "ball's centre above the bat's axis"),
    "above_usual": ("speed", "exit speed above what such swings usually give"),
    "carry_above": ("distance", "tracked distance above carry"),
    "home_run_here": ("share", "expected home runs per ball in play"),
}
"""What is averaged over balls: scale and meaning."""
BOUNDS: Mapping[str, Bounds] = {
    name: (-1.0, 1.0) if name == ABOVE else (0.0, 1.0) for name, (scale, _) in MEASURES.items() if scale == "share"
} | {"from_best": POSITIVE}
"""Least and greatest value of the measures that come near one: shares, how far a share may be from another, and the
distance from the best place."""
NEAR, RARE = 0.1, 3.0
"""From 0 or 1 a share, and of the rarer kind that a group has on average, below which intervals of 90 % hold 84 to 88 %
where groups differ by about as much as the share itself: in made-up leagues (`docs/theory/season.md`)."""
PLAIN = ("balls", "ev20", "home_runs_expected", "home_runs_average_park", "home_runs", "doubters", "mostly_gone",
         "no_doubters", "name")  # fmt: skip
"""Columns that are counted and not pooled."""


@dataclass(frozen=True)
class Standing:
    """One group column's table.

    Parameters
    ----------
    key : the column.
    table : a row per group: balls, and of every measure pooled, low50 … high90, reliability, percentile, raw mean.
    spreads : how balls and groups scatter, by measure.
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

    Parameters
    ----------
    parts : groups and measures of balls, a part of the table after the other; each is read once, by itself, so that
        memory does not hang on how many balls there are.
    keys : some of `GROUPS`.
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
        own = summed.select(
            key, *(pl.col(f"{measure} {what}").alias(what) for what in (BALLS, MEAN, SQUARES))
        ).filter(pl.col(BALLS) > 0)  # fmt: skip
        measured, spreads[measure] = pooled_groups(own, key=key, bounds=BOUNDS.get(measure))
        if "pooled" not in measured.columns:
            continue
        renamed = measured.rename({"balls": f"{measure}_balls", "mean": f"{measure}_mean", "pooled": measure} | {
            name: f"{measure}_{name}" for name in ("spread", "low50", "high50", "low90", "high90", "reliability",
                                                   "percentile")})  # fmt: skip
        table = table.join(renamed, on=key, how="left")
    if others:
        table = table.with_columns(_best_bat(table, others))
    return Standing(key, table, spreads)


def _best_bat(table: pl.DataFrame, others: list[str]) -> pl.Series:
    """Return the bat that would serve each group best in exit speed; its own where every other gives less."""
    gains = np.stack([table[name].fill_null(-np.inf).to_numpy() if name in table.columns else
                      np.full(len(table), -np.inf) for name in others])  # fmt: skip
    best = gains.argmax(axis=0)
    names = [others[number].removeprefix(WITH) if gains[number, row] > 0 else "own" for row, number in enumerate(best)]
    return pl.Series("best_bat", names)


def above_expected_parts(parts: Sequence[pl.LazyFrame]) -> list[pl.LazyFrame]:
    """Return counted balls with ``squared_up_above``: the league's flag less what such bat speeds have.

    The expectation is the parabola in bat speed through all balls of the season. Sums are added up part by part, in
    order, so that they are the same to the last digit however many threads there are.

    Parameters
    ----------
    parts : of the counted balls, which make up a season together.
    """
    speed, flag = pl.col("bat_speed").cast(pl.Float64) - 32.0, pl.col("league_squared_up").cast(pl.Float64)
    square, along = np.zeros((3, 3)), np.zeros(3)
    flagged = ["league_squared_up" in part.collect_schema().names() for part in parts]
    for part in compress(parts, flagged):
        known = part.select(speed=speed, flag=flag).drop_nulls().collect()
        powers = np.stack([known["speed"].to_numpy() ** power for power in range(3)])
        square += np.einsum("in,jn->ij", powers, powers)
        along += np.einsum("in,n->i", powers, known["flag"].to_numpy())
    if square[0, 0] < 10:
        return list(parts)
    a, b, c = np.linalg.lstsq(square, along, rcond=None)[0].tolist()
    fresh = (flag - (a + b * speed + c * speed**2)).cast(pl.Float32).alias(ABOVE)
    return [part.with_columns(fresh) if has else part for part, has in zip(parts, flagged, strict=True)]

"""Some of a season's balls: how many, how well they were hit, and where on the barrel and on the field."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import polars as pl

from sweetspot.errors import InputError, nearest_names
from sweetspot.numerics.arrays import Array
from sweetspot.units import FOOT, INCH

PLACES: Array = np.arange(0, 14.01, 0.5) * INCH
OFFSETS: Array = np.arange(-2.4, 2.41, 0.3) * INCH
"""m: edges of the barrel's boxes, from the tip and above the axis."""
ACROSS: Array = np.arange(-330.0, 331, 20) * FOOT
OUT: Array = np.arange(0.0, 481, 20) * FOOT
"""m: edges of the field's boxes, to the right of the line to centre field and along it, from home."""
PARTS = np.arange(0.3, 1.21, 0.02)
"""Edges of the boxes of exit speed over a ceiling."""
CHOICES = ("team", "pitch_type", "count", "month", "park")
"""Columns that balls can be chosen by, beside the batter."""
NEAR = 90 * FOOT
"""m from home within which balls come down that are not drawn on the field: most are hit into the ground."""
HARDEST = 0.8
"""Quantile of exit speed from which on balls are the hardest fifth."""


@dataclass(frozen=True)
class BallMap:
    """Balls in boxes.

    ``across``, ``along``: middles of the boxes, m. ``counts``: balls in each, shape (along, across). ``outside``: balls
    that fell into none of them. ``near``: of a field: balls that came down too near home to be counted.
    """

    across: Array
    along: Array
    counts: Array
    outside: int
    near: int = 0


def chosen_balls(counted: pl.LazyFrame, chosen: Mapping[str, str]) -> pl.LazyFrame:
    """Return some of the counted balls.

    ``chosen``: value by column: ``batter`` or one of `CHOICES`.
    """
    for name, value in chosen.items():
        counted = counted.filter(pl.col(name) == value)
    return counted


def choices_of(counted: pl.LazyFrame) -> dict[str, list[tuple[str, int]]]:
    """Return the filters of balls: (value, balls) of each of `CHOICES`, months in order, others by balls."""
    choices = {}
    for name in CHOICES:
        table = counted.filter(pl.col(name).is_not_null()).group_by(name).len().collect()
        order = table.sort(name) if name in ("month", "count") else table.sort("len", name, descending=[True, False])
        choices[name] = [(str(value), int(balls)) for value, balls in order.iter_rows()]
    return choices


def ball_means(counted: pl.LazyFrame) -> dict[str, float | None]:
    """Return counts and means of balls in SI, of shares from 0 to 1; None where nothing is known."""
    names = counted.collect_schema().names()
    means = [name for name in ("bat_speed", "squared_up", "league_squared_up", "from_best", "carry") if name in names]
    speed = pl.col("exit_speed").cast(pl.Float64)
    found = counted.select(
        *(pl.col(name).cast(pl.Float64).mean() for name in means),
        balls=pl.len(),
        exit_speed=speed.mean(),
        ev20=speed.filter(speed >= speed.quantile(HARDEST)).mean(),
        home_runs=known_sum(is_home_run(pl.col("event"))),
        home_runs_expected=known_sum(pl.col("home_run_here").cast(pl.Float64)),
    )
    row = found.collect().row(0, named=True)
    return {name: None if value is None else float(value) for name, value in row.items()}


def is_home_run(event: pl.Expr) -> pl.Expr:
    """Return whether a ball was a home run, by how the table says that it ended."""
    return event.str.to_lowercase().str.replace_all("[_ ]", "") == "homerun"


def known_sum(values: pl.Expr) -> pl.Expr:
    """Return the sum of the known values of a column, missing where there is none."""
    return pl.when(values.is_not_null().any()).then(values.sum())


def ceiling_counts(counted: pl.LazyFrame) -> dict[str, Array] | None:
    """Return part of the balls by exit speed over this bat's and the league's ceiling; None: no ball has a ceiling.

    Without a pitch's speed there is no league's ceiling, and ``league_ratio`` is left out.
    """
    names = ("squared_up_ratio", "league_ratio")
    if not set(names) <= set(counted.collect_schema().names()):
        return None
    table = counted.select(names).collect()
    columns = {name: table[name].drop_nulls().to_numpy() for name in names}
    if not len(columns["squared_up_ratio"]):
        return None
    shares = {name: np.histogram(values, PARTS)[0] / len(values) for name, values in columns.items() if len(values)}
    return {"ratio": (PARTS[1:] + PARTS[:-1]) / 2, **shares}


def barrel_counts(counted: pl.LazyFrame) -> BallMap | None:
    """Return the counts of contacts on the barrel, m from the tip and above the axis; None if no table names bats.

    Each ball counts at one draw from what is known of it, so that doubt shows as width.
    """
    if "from_tip_drawn" not in counted.collect_schema().names():
        return None
    table = counted.select("from_tip_drawn", "offset").drop_nulls().collect()
    if not len(table):
        return None
    return _boxed(table["from_tip_drawn"].to_numpy(), table["offset"].to_numpy(), PLACES, OFFSETS)


def field_counts(counted: pl.LazyFrame) -> BallMap | None:
    """Return the counts of landing places, m to the right of the line to centre field and along it; None: no flight.

    Balls that come down within `NEAR` of home are counted apart.
    """
    table = counted.select("carry", "bearing").drop_nulls().collect()
    if not len(table):
        return None
    far = table.filter(pl.col("carry") >= NEAR)
    carry, bearing = far["carry"].to_numpy(), far["bearing"].to_numpy()
    counts = _boxed(carry * np.sin(bearing), carry * np.cos(bearing), ACROSS, OUT)
    return replace(counts, near=len(table) - len(far))


def _boxed(across: Array, along: Array, edges: Array, rows: Array) -> BallMap:
    counts, _, _ = np.histogram2d(along, across, bins=[rows, edges])
    middles = (edges[1:] + edges[:-1]) / 2, (rows[1:] + rows[:-1]) / 2
    return BallMap(*middles, counts, len(across) - int(counts.sum()))


HEADS = {"from_tip_in": INCH, "from_tip_m": 1.0}


def contact_places(folder: Path, batter: str) -> Array:
    """Return the medians of the places where a batter's balls were met, m from the tip, shape (balls,).

    Balls without a computed place are left out. Each median is drawn towards the season's mean, and whether a ball
    was met inside or outside of the best place is often not known: the scatter is a rough one.

    ``folder``: that a season was written to, with ``balls`` in it. ``batter``: number or name as in the table's column
    ``batter``.
    """
    parts = sorted((folder / "balls").glob("*.parquet"))
    if not parts:
        raise InputError(f"{folder} holds no balls/*.parquet; give the folder that sweetspot season --out wrote")
    table = pl.scan_parquet(parts)
    heads = table.collect_schema().names()
    head = next((name for name in HEADS if name in heads), None)
    if head is None or "batter" not in heads:
        raise InputError(f"{folder} tells no batters or no places along a bat; run the season without --flight-only")
    who = pl.col("batter").cast(pl.String)
    places = table.filter(who == batter).select(head).drop_nulls().collect()[head].to_numpy()
    if not len(places):
        batters = table.select(who.unique()).collect()["batter"].drop_nulls().to_list()
        raise InputError(f"no place of a ball of the batter {batter!r} is known. {nearest_names(batter, batters)}")
    return np.asarray(places * HEADS[head], float)

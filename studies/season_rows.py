"""Write a table of as many balls in play as wanted, none twice: ``python -m studies.season_rows FILE --rows 1000000``.

Swings, exit speeds and launch angles are drawn from tracked balls (36-SURE 2026), and where they came down and how they
were pitched from tracked balls of 2022 that were hit alike; each number is moved by a little about the one drawn (a
smooth bootstrap), so that tables have the shape of real ones and no row stands there twice. Both files must be there
(`SWEETSPOT_DATA`, or ``--data``); ``--made-up`` draws from a made-up season instead. Rows hang on the
seed and on their own number only.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray
from polars.io.plugins import register_io_source
from scipy.spatial import cKDTree

from sweetspot import catalog
from sweetspot.seasons.made_up import MadeSeason, made_season

Array = NDArray[np.float64]
DATA = Path(os.environ.get("SWEETSPOT_DATA") or Path(__file__).parents[2] / "shared" / "data")
SWINGS, PITCHES = "cmu36sure2026_battedballs_battracking.csv.gz", "savant_2022_contact_sample.csv.gz"
BLOCK = 100_000
"""Rows drawn together; each block has its own random numbers."""
TRACKS = ("release_speed", "vx0", "vy0", "vz0", "ax", "ay", "az", "plate_x", "plate_z")
MOVED = {
    "launch_speed": 1.0, "launch_angle": 1.0, "bat_speed": 0.8, "attack_angle": 1.0, "swing_path_tilt": 0.8,
    "release_speed": 0.5, "vx0": 0.5, "vy0": 0.7, "vz0": 0.4, "ax": 0.8, "ay": 0.6, "az": 0.8, "plate_x": 0.06,
    "plate_z": 0.06, "hc_x": 1.5, "hc_y": 1.5, "hit_distance_sc": 3.0,
}  # fmt: skip
"""By how much drawn numbers are moved, standard deviations in the table's units."""
CLUBS = ("BOS", "NYY", "COL", "TB", "SEA", "SF", "CHC", "HOU", "LAD", "ATL", "PHI", "MIA", "MIN", "DET", "CLE", "TEX")
HITTERS, PITCHERS = 450, 700
WORDS = ("single", "field_out", "double", "home_run", "grounded_into_double_play", "force_out", "sac_fly")
ALIKE = (1.0, 3.0, 6.0)
"""Degrees and mph that count the same in looking for balls hit alike, and what a batter of the other side counts."""


def drawn_from(data: Path) -> pl.DataFrame:
    """Return tracked swings, each with pitch and place of a ball of 2022 that was hit alike.

    Parameters
    ----------
    data : folder of the two files.
    """
    swings = pl.read_csv(data / SWINGS).drop_nulls(
        ["launch_speed", "launch_angle", "bat_speed", "attack_angle", "swing_path_tilt"]
    )
    other = pl.read_csv(data / PITCHES, infer_schema_length=None).drop_nulls(
        ["launch_speed", "launch_angle", "hc_x", "hc_y", *TRACKS]
    )

    def hit(table: pl.DataFrame, left: pl.Expr) -> Array:
        angle, speed, side = ALIKE
        return table.select(pl.col("launch_angle") / angle, pl.col("launch_speed") / speed,
                            left.cast(pl.Float64) * side).to_numpy()  # fmt: skip

    _, found = cKDTree(hit(other, pl.col("stand") == "L")).query(hit(swings, pl.col("is_stand_left") == 1), k=5)
    near = np.asarray(found)
    one = near[np.arange(len(near)), np.arange(len(near)) % near.shape[1]]
    matched = other[one].select(*TRACKS, "hc_x", "hc_y", "hit_distance_sc", "pitch_type", "events", "bb_type")
    own = swings.select(
        "launch_speed", "launch_angle", "bat_speed", "attack_angle", "swing_path_tilt", "balls", "strikes",
        stand=pl.when(pl.col("is_stand_left") == 1).then(pl.lit("L")).otherwise(pl.lit("R")),
        p_throws=pl.when(pl.col("is_throw_left") == 1).then(pl.lit("L")).otherwise(pl.lit("R")),
    )  # fmt: skip
    both: pl.DataFrame = pl.concat([own, matched], how="horizontal")
    return both.with_columns(attack_direction=np.random.default_rng(5).normal(-2, 9, len(own)))


def drawn_from_made_up() -> pl.DataFrame:
    """Return balls of a made-up season to draw from, for where no tracked ones are."""
    made = made_season(catalog.bat("r161-ash"), MadeSeason(players=60, balls=110))
    return made.drop([name for name in made.columns if name.startswith("true_")])


def blocks(base: pl.DataFrame, rows: int, *, seed: int = 1, first: int = 0) -> Iterator[pl.DataFrame]:
    """Yield rows, a block at a time.

    Parameters
    ----------
    base : rows to draw from.
    rows : how many in all.
    seed : of the random numbers.
    first : number of the first block, to go on from.
    """
    for number in range(first, -(-rows // BLOCK)):
        yield _block(base, number, min(BLOCK, rows - number * BLOCK), seed)


def _block(base: pl.DataFrame, number: int, count: int, seed: int) -> pl.DataFrame:
    rng = np.random.default_rng([seed, number])
    table = base[rng.integers(0, len(base), count)]
    moved = {
        name: (table[name].cast(pl.Float64) + pl.Series(rng.normal(0, width, count))).round(4)
        for name, width in MOVED.items()
        if name in table.columns
    }
    row = np.arange(number * BLOCK, number * BLOCK + count)
    day = row // 700 % 180
    dates = pl.Series(np.datetime64("2024-04-01") + day).dt.strftime("%Y-%m-%d")
    return table.with_columns(**moved).with_columns(
        game_date=dates, game_year=pl.lit(2024), game_pk=pl.Series(700_000 + row // 50),
        at_bat_number=pl.Series(row % 50 + 1), pitch_number=pl.lit(1),
        batter=pl.Series(600_000 + rng.integers(0, HITTERS, count)),
        pitcher=pl.Series(500_000 + rng.integers(0, PITCHERS, count)),
        home_team=pl.Series(np.array(CLUBS)[row // 50 % len(CLUBS)]),
        away_team=pl.Series(np.array(CLUBS)[(row // 50 + 3) % len(CLUBS)]),
        inning_topbot=pl.Series(np.array(["Top", "Bot"])[row % 2]), description=pl.lit("hit_into_play"),
        type=pl.lit("X"),
    ).with_columns(
        pl.col("launch_speed").clip(5, 124), pl.col("launch_angle").clip(-89, 89), pl.col("bat_speed").clip(20, 95)
    )  # fmt: skip


def write_rows(path: Path, rows: int, *, base: pl.DataFrame, seed: int = 1) -> None:
    """Write a table as Parquet, made while it is written.

    Parameters
    ----------
    path : of the table.
    base : rows to draw from.
    """
    schema = _block(base, 0, 1, seed).schema

    def made(*_asked: object) -> Iterator[pl.DataFrame]:
        yield from blocks(base, rows, seed=seed)

    register_io_source(made, schema=schema).sink_parquet(path, row_group_size=BLOCK, engine="streaming")


def main(arguments: Sequence[str] | None = None) -> None:
    """Write the table that was asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=Path)
    parser.add_argument("--rows", type=lambda text: int(float(text)), default=1_000_000)
    parser.add_argument("--data", type=Path, default=DATA)
    parser.add_argument("--made-up", action="store_true")
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args(arguments)
    base = drawn_from_made_up() if asked.made_up else drawn_from(asked.data)
    write_rows(asked.file, asked.rows, base=base, seed=asked.seed)


if __name__ == "__main__":
    main()

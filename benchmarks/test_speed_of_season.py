"""A season's table, Parquet to Parquet: carry, thirty parks, everything; beside pandas and pybaseball's flight."""

from __future__ import annotations

import resource
import time
import warnings
from collections.abc import Callable
from dataclasses import replace
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import polars as pl

from benchmarks.cases import QUICK
from sweetspot import catalog
from sweetspot.season.answers import SeasonSetting
from sweetspot.season.made_up import MadeSeason, made_season
from sweetspot.season.season_table import analyse_season, season_setting
from sweetspot.season.standings import standing

BALLS = 4_000 if QUICK else 118_000
RIVAL_BALLS = 5


@cache
def table() -> pl.DataFrame:
    """Return as many balls as a season has: a made-up season over and over, each pitch with its own number."""
    made = made_season(catalog.bat("r161-ash"), MadeSeason(players=60, balls=110))
    many = pl.concat([made] * (BALLS // len(made) + 1)).head(BALLS)
    return many.with_columns(at_bat_number=pl.int_range(pl.len()))


def seconds(setting: SeasonSetting, folder: Path) -> tuple[float, float]:
    """Return wall and processor seconds of one run after a short one that compiles."""
    table().head(300).write_parquet(folder / "few.parquet")
    analyse_season([folder / "few.parquet"], setting=setting, folder=folder / "few")
    table().write_parquet(folder / "all.parquet")
    wall, busy = time.perf_counter(), time.process_time()
    analyse_season([folder / "all.parquet"], setting=setting, folder=folder / "all")
    return time.perf_counter() - wall, time.process_time() - busy


def test_season(benchmark: Any, record: Callable[..., None], tmp_path: Path) -> None:
    whole = season_setting(bats={"": "r161-ash"})
    carry = season_setting(contact=False)
    for name, setting, goal in (
        ("carry columns", replace(carry, flight=replace(carry.flight, parks=False)), 300_000),
        ("carry and thirty parks", carry, 150_000),
        ("everything", whole, 120_000),
    ):
        (tmp_path / name).mkdir()
        wall, busy = seconds(setting, tmp_path / name)
        record(
            f"season, {BALLS:,} balls, {name}",
            f"{BALLS / wall:,.0f} rows/s, {busy / BALLS * 1e6:.1f} µs of a core a row",
            goal=f"{goal:,} rows/s on 2 idle cores",
        )
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
    record("season, most memory held", f"{memory:.2f} GiB", goal="1 GiB")
    benchmark.pedantic(lambda: None, rounds=1)


def test_players_pooled(benchmark: Any, record: Callable[..., None], tmp_path: Path) -> None:
    table().write_parquet(tmp_path / "all.parquet")
    season = analyse_season([tmp_path / "all.parquet"], setting=season_setting(), folder=tmp_path / "out")
    start = time.perf_counter()
    benchmark.pedantic(lambda: standing(season.counted(), key="batter"), rounds=1)
    record("all hitters pooled, every measure", f"{time.perf_counter() - start:.2f} s", goal="60 s")


def test_pandas_and_pybaseball(benchmark: Any, record: Callable[..., None]) -> None:
    """The rival flies one ball a call; a few are enough to know its rate."""
    frame = table().head(RIVAL_BALLS).to_pandas()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rival = import_module("pybaseball.analysis.trajectories").BattedBallTrajectory()
        start = time.perf_counter()
        for row in frame.itertuples():
            rival.get_trajectory(row.launch_speed, max(row.launch_angle, 5.0), 0.0, 2000.0, 0.0)
        rate = len(frame) / (time.perf_counter() - start)
    record("season, carry by pandas and pybaseball, one ball a call", f"{rate:,.0f} rows/s")
    benchmark.pedantic(lambda: None, rounds=1)

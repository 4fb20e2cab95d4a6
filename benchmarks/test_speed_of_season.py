"""A season's table, Parquet to Parquet: carry, thirty parks, everything; beside pandas and pybaseball's flight.

Rows are made by `studies/season_rows.py`: each its own, with the shape of tracked balls where those are at hand
(`SWEETSPOT_DATA`) and of made-up ones where not. A part of the season is run first, so that compiling does not count.
"""

from __future__ import annotations

import subprocess
import sys
import time
import warnings
from collections.abc import Callable
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

from benchmarks.cases import QUICK
from studies import season_rows
from sweetspot.seasons.ball_columns import SeasonSetting
from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.seasons.standings import all_standings

BALLS = 4_000 if QUICK else 118_000
MANY = 8_000 if QUICK else 1_000_000
"""Balls of the longer table, in which what is done once a table counts little."""
RIVAL_BALLS = 5 if QUICK else 100
PEAK = """
import sys
from sweetspot.cli import main
try:
    main()
finally:
    print(next(line for line in open("/proc/self/status") if line.startswith("VmHWM")), file=sys.stderr)
"""


@pytest.fixture(scope="module")
def tables(tmp_path_factory: pytest.TempPathFactory) -> dict[int, Path]:
    """Return tables by their number of balls, and under 0 one that is only there to compile."""
    folder = tmp_path_factory.mktemp("rows")
    tracked = all((season_rows.DATA / name).is_file() for name in (season_rows.SWINGS, season_rows.PITCHES))
    base = season_rows.drawn_from(season_rows.DATA) if tracked else season_rows.drawn_from_made_up()
    paths = {}
    for balls in (0, BALLS, MANY):
        paths[balls] = folder / f"{balls}.parquet"
        season_rows.write_rows(paths[balls], balls or 2_000, base=base)
    return paths


def seconds(table: Path, setting: SeasonSetting, folder: Path) -> tuple[float, float]:
    """Return wall and processor seconds of one run."""
    wall, busy = time.perf_counter(), time.process_time()
    analyse_season([table], setting=setting, folder=folder)
    return time.perf_counter() - wall, time.process_time() - busy


def pandas_and_pybaseball(table: Path) -> float:
    """Return how many rows a second the rival carries: it flies one ball a call, some are enough to know its rate."""
    start = time.perf_counter()
    frame = import_module("pandas").read_parquet(table)
    read = time.perf_counter() - start
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rival = import_module("pybaseball.analysis.trajectories").BattedBallTrajectory()
        start = time.perf_counter()
        for row in frame.head(RIVAL_BALLS).itertuples():
            rival.get_trajectory(row.launch_speed, max(row.launch_angle, 5.0), 0.0, 2000.0, 0.0)
        flown = (time.perf_counter() - start) / RIVAL_BALLS
    return len(frame) / (read + flown * len(frame))


def test_season(benchmark: Any, record: Callable[..., None], tables: dict[int, Path], tmp_path: Path) -> None:
    whole = season_setting(bats={"": "r161-ash"})
    carry = season_setting(contact=False)
    bare = replace(carry, flight=replace(carry.flight, parks=False))
    slow = pandas_and_pybaseball(tables[BALLS])
    for name, setting, goal in (
        ("carry columns", bare, 300_000),
        ("carry and thirty parks", carry, 150_000),
        ("everything", whole, 120_000),
    ):
        seconds(tables[0], setting, tmp_path / name)
        for balls in (BALLS, MANY):
            wall, busy = seconds(tables[balls], setting, tmp_path / name)
            beside = {"rival": f"{slow:,.0f} rows/s", "ratio": f"{slow * wall / balls:.4f}"} if setting is bare else {}
            record(
                f"season, {balls:,} balls, {name}",
                f"{balls / wall:,.0f} rows/s in {wall:.2f} s, {busy / balls * 1e6:.1f} µs of a core a row",
                goal=f"{goal:,} rows/s on 2 idle cores" + (", 3 s" if setting is whole and balls == BALLS else ""),
                **beside,
            )
    benchmark.pedantic(lambda: None, rounds=1)


def test_memory_of_the_whole_command(
    benchmark: Any, record: Callable[..., None], tables: dict[int, Path], tmp_path: Path
) -> None:
    """With the tables of players, pitchers and so on and the picture, in a process of its own."""
    if not Path("/proc/self/status").exists():
        pytest.skip("the system does not tell how much memory was held")
    for balls in (BALLS, MANY):
        command = ["season", tables[balls], "--bat", "r161-ash", "--out", tmp_path / str(balls)]
        done = subprocess.run([sys.executable, "-c", PEAK, *command], capture_output=True, text=True, check=True)
        peak = int(done.stderr.rsplit("VmHWM:", 1)[1].split()[0]) / 2**20
        record(f"season, whole command, {balls:,} balls, most memory held", f"{peak:.2f} GiB", goal="1 GiB")
    benchmark.pedantic(lambda: None, rounds=1)


def test_players_pooled(
    benchmark: Any, record: Callable[..., None], tables: dict[int, Path], tmp_path: Path
) -> None:  # fmt: skip
    season = analyse_season([tables[BALLS]], setting=season_setting(), folder=tmp_path / "out")
    start = time.perf_counter()
    benchmark.pedantic(lambda: all_standings(season.counted_parts()), rounds=1)
    record("all hitters, pitchers, clubs and so on pooled, every measure", f"{time.perf_counter() - start:.2f} s",
           goal="60 s")  # fmt: skip

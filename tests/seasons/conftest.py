"""Made-up seasons: small tables as the world writes them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import polars as pl
import pytest

from sweetspot.seasons.plan import Plan, run_here
from sweetspot.seasons.season_table import Season, analyse_season, season_setting


def made_up(count: int = 60, *, seed: int = 1, year: int = 2024) -> pl.DataFrame:
    """Return a Statcast table of balls in play whose numbers are possible, not tied to any law."""
    rng = np.random.default_rng(seed)
    rows = np.arange(count)
    turn = rng.uniform(-0.7, 0.7, count)
    far = rng.uniform(40, 160, count)
    return pl.DataFrame({
        "game_date": [f"{year}-{4 + number % 5:02d}-{1 + number % 27:02d}" for number in rows],
        "game_pk": 700_000 + rows // 12, "at_bat_number": rows % 12 + 1, "pitch_number": rows % 5 + 1,
        "batter": 600_000 + rows % 6, "pitcher": 500_000 + rows % 4, "player_name": ["Pitcher, Some"] * count,
        "stand": ["L" if number % 3 else "R" for number in rows], "home_team": ["BOS", "COL", "TB"] * (count // 3)
        + ["NYY"] * (count % 3), "away_team": ["NYM"] * count, "inning_topbot": ["Top", "Bot"] * (count // 2)
        + ["Top"] * (count % 2), "pitch_type": ["FF", "SL", "CH"] * (count // 3) + ["FF"] * (count % 3),
        "balls": rows % 4, "strikes": rows % 3, "description": ["hit_into_play"] * count, "type": ["X"] * count,
        "events": ["home_run" if number % 15 == 0 else "field_out" for number in rows],
        "des": ["Somebody flies out."] * count, "bb_type": ["fly_ball"] * count,
        "release_speed": rng.uniform(80, 98, count).round(1), "launch_speed": rng.uniform(60, 110, count).round(1),
        "launch_angle": rng.integers(-20, 45, count), "hc_x": (125.42 + far * np.sin(turn)).round(2),
        "hc_y": (198.27 - far * np.cos(turn)).round(2), "hit_distance_sc": rng.integers(5, 420, count),
        "bat_speed": rng.normal(71, 4, count).round(1), "attack_angle": rng.normal(9, 6, count),
        "attack_direction": rng.normal(0, 10, count), "swing_path_tilt": rng.normal(32, 5, count),
        "plate_x": rng.normal(0, 0.5, count).round(2), "plate_z": rng.normal(2.5, 0.5, count).round(2),
        "vx0": rng.normal(0, 5, count), "vy0": rng.normal(-130, 5, count), "vz0": rng.normal(-5, 2, count),
        "ax": rng.normal(0, 8, count), "ay": rng.normal(27, 2, count), "az": rng.normal(-18, 6, count),
        "umpire": ["nobody"] * count,
    })  # fmt: skip


@pytest.fixture
def table(tmp_path: Path) -> Callable[..., Path]:
    """Return a function that writes a made-up table, changed as wanted, and says where."""

    def write(name: str = "table.csv", frame: pl.DataFrame | None = None) -> Path:
        path = tmp_path / name
        made = made_up() if frame is None else frame
        made.write_parquet(path) if name.endswith(".parquet") else made.write_csv(path)
        return path

    return write


ROWS = 60
"""Of a task: small tables, many tasks."""


def files_of(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*.parquet"))
    }


@pytest.fixture(scope="session")
def tables(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    folder = tmp_path_factory.mktemp("tables")
    paths = [folder / "first.parquet", folder / "second.csv"]
    made_up(300, seed=1).write_parquet(paths[0])
    made_up(200, seed=2).with_columns(game_pk=pl.col("game_pk") + 1000).write_csv(paths[1])
    return paths


@pytest.fixture(scope="session")
def compute(tables: list[Path]) -> Callable[..., Season]:
    setting = season_setting(others=("mlb-a",))

    def run(folder: Path, how: Callable[..., None] = run_here, resume: bool = False) -> Season:
        def small(plan: Plan, progress: object) -> None:
            how(replace(plan, task_rows=ROWS), progress)

        return analyse_season(tables, setting=setting, folder=folder, run=small, resume=resume)

    return run


@pytest.fixture(scope="session")
def alone(compute: Callable[..., Season], tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    folder = tmp_path_factory.mktemp("alone")
    compute(folder)
    return files_of(folder)

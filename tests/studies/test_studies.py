"""Every study whose figures stand in the documentation runs, on a sample so small that it takes seconds."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path

import pytest

from tests.real_data import real_file

ROOT = Path(__file__).parents[2]
SMALL: dict[str, str] = {
    "air_law": "--balls 200 --check",
    "ball_scatter": "{data}",
    "calibrated_bats": "--count 1 --kinds hollow",
    "calibration_coverage": "--count 1",
    "college_residuals": "{data}",
    "held_out": "--balls 400",
    "league_batters": "--swings {data}",
    "league_coverage": "--players 5 --swings 20 --simulator own",
    "measured_bats": "--count 2",
    "measured_spin": "--count 3000",
    "other_sounds": "--count 1 --only scrape",
    "paddle_ball": "--only CRBN1",
    "park_ranking": "--flies 20",
    "photographs": "--count 1 --only transparent --pixel 2",
    "plan_coverage": "--players 1 --find position",
    "player_advice": "--players 3 --swings 20 --bats 2",
    "player_coverage": "--players 1 --swings 20",
    "published_intervals": "--only cricket-bat",
    "ranking_coverage": "--count 1",
    "ranking_tables": "--count 1",
    "recorder_bats": "--only telephone --kinds golf",
    "recorder_taps": "--only telephone",
    "reliability": "--leagues 4 --limits 0",
    "report_coverage": "--count 2 youth-30",
    "season_rows": "{folder}/rows.parquet --rows 100 --made-up",
    "tap_trials": "--count 1 --only clap",
    "tracked_flights": "{data}",
    "unlike_seasons": "--players 10 --balls 30 --truth 60 --seasons 1 --only {unlike}",
}
"""What each is asked for."""
READS = {
    "ball_scatter": ["cmu36sure2026_battedballs_battracking.csv.gz"],
    "held_out": ["cmu36sure2026_battedballs_battracking.csv.gz"],
    "college_residuals": ["trackman_2025_college_hits.csv.gz"],
    "league_batters": ["cmu36sure2026_battedballs_battracking.csv.gz"],
    "park_ranking": [
        "savant_2022_contact_sample.csv.gz",
        "savant_2019_homeruns.csv.gz",
        "mlb_ballparks_elev_wall_minmax.csv",
    ],
    "tracked_flights": ["savant_2020-09-03_allpitches.csv.gz"],
}
"""The public tables that a study needs: where one is missing, the test is skipped and says so."""
HELPERS = {"measured_hang", "struck_beams"}
"""Modules that studies share."""


@pytest.mark.study
@pytest.mark.parametrize("name", SMALL)
def test_a_study_runs(name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = [str(real_file(file)) for file in READS.get(name, [])]
    words = [
        word.format(folder=tmp_path, data=files[0] if files else "", unlike="errors with heavy tails")
        for word in SMALL[name].split()
    ]
    import_module(f"studies.{name}").main(words)
    told = capsys.readouterr().out
    assert re.search(r"\d", told) or list(tmp_path.iterdir()), told
    assert "nan" not in told.lower().split()


def test_every_study_is_run_and_its_figures_stand_somewhere() -> None:
    studies = {path.stem for path in (ROOT / "studies").glob("*.py")}
    assert studies == SMALL.keys() | HELPERS
    pages = [path for folder in ("docs", "src", "benchmarks") for path in (ROOT / folder).rglob("*")]
    texts = "".join(path.read_text("utf-8") for path in pages if path.suffix in {".md", ".py", ".toml"})
    assert not [name for name in SMALL if not re.search(rf"studies[./]{name}\b", texts)]

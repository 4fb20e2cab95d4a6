"""The command lines that the documentation shows, and made-up files for those that read a user's own."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import numpy as np
import polars as pl

from tests.photographs import rendered, saved
from tests.seasons.conftest import made_up

DOCS = Path(__file__).parents[1] / "docs"
PAGES = sorted(path for path in DOCS.rglob("*.md") if not {"_build", "_generated"} & set(path.relative_to(DOCS).parts))
TUTORIALS = Path(__file__).parent / "tutorials"
"""A folder of files for each page of docs/users with a tutorial; `tools/tutorial_files.py` made them."""
WITH_TUTORIAL = sorted(path.name for path in TUTORIALS.iterdir() if path.is_dir())
TUTORIAL = re.compile(r"^## From beginning to end$.*?(?=^## )", re.MULTILINE | re.DOTALL)
LEFT_OUT = "..."
"""Line of a printed answer in whose place others stand."""
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


NEEDS_ONE_S_OWN = {
    "outline drawing.dxf": "a drawing of one's own; tests/calibration/outline reads many",
    "app": "runs until it is stopped; tests/web opens it",
}
"""Beginnings of command lines that only a user can run, and why: they are parsed, not run."""
LONG = {
    "design mlb-a": "seconds of searching; tests/cli/test_design_command.py runs shorter ones",
    "design my-bat.toml": "the same",
    "design cricket-bat": "the same",
    "design tennis-racket": "the same",
    "tap r161.wav": "tests/cli/test_tap_command.py runs the same, and calibrate on the page on one's own bat",
    "tap taps.wav": "the same",
    "tap shaft.wav": "the same",
    "tap mine.wav": "tests/calibration/test_paddle_core.py hears made-up paddles",
    "calibrate pickleball-paddle": "seconds; tests/calibration/test_paddle_calibration.py does the same",
    "tap frame.wav": "the same",
    "report mine.toml --uncertainty": "a thousand draws; tests/uncertainty runs them",
    "compare r161-ash mine.toml --uncertainty": "the same",
    "compare russell-b5 --rows": "36 hollow bats; benchmarks/ runs them, and the page on drawings wooden ones",
}
"""The same of lines that take long."""
EXIT_CODES = {"certify russell-b5 --league all": 1}
"""Of command lines that end otherwise than with 0."""


def name_of(page: Path) -> str:
    """Return a page's name, as in "users/maker"."""
    return page.relative_to(DOCS).with_suffix("").as_posix()


def blocks(page: Path, language: str) -> list[str]:
    """Return the blocks of a page in one language, but for those of its tutorial."""
    text = TUTORIAL.sub("", page.read_text(encoding="utf-8"))
    return [found[2] for found in BLOCK.finditer(text) if found[1] == language]


def tutorial(name: str) -> list[tuple[str, list[str]]]:
    """Return the command lines of a page's tutorial, each with the parts of its answer that are printed below it."""
    found = TUTORIAL.search((DOCS / "users" / f"{name}.md").read_text(encoding="utf-8"))
    assert found is not None, name
    consoles = "".join(block[2] for block in BLOCK.finditer(found[0]) if block[1] == "console")
    steps = [step.partition("\n") for step in consoles.split("$ ") if step.startswith("sweetspot ")]
    return [(line, answer.split(f"\n{LEFT_OUT}\n")) for line, _, answer in steps]


def command_lines(page: Path) -> list[str]:
    """Return the command lines of a page as they are written, without the prompt; but for those of its tutorial."""
    lines = (line for text in blocks(page, "console") for line in text.splitlines())
    return [line.removeprefix("$ ") for line in lines if line.startswith("$ sweetspot ")]


def arguments(line: str) -> list[str]:
    """Return what a command line gives to the program: without a comment or where its answer is sent."""
    return shlex.split(re.sub(r" (>|#).*", "", line))[1:]


def is_parsed_only(line: str) -> bool:
    """Return whether a command line is one of those that are not run."""
    return line.removeprefix("sweetspot ").startswith((*NEEDS_ONE_S_OWN, *LONG))


def write_files(folder: Path, page: Path) -> None:
    """Write the files that a page's commands name, as a user would have them."""
    own, drawing = (blocks(DOCS / one, "toml")[0] for one in ("start.md", "users/maker.md"))
    mine = next(iter(blocks(page, "toml")), own) if page.parent.name == "sports" else own
    for name, text in {"my-bat": own, "drawing-12": drawing, "mine": mine}.items():
        (folder / f"{name}.toml").write_text(text, encoding="utf-8")
    (shots,) = blocks(DOCS / "users" / "laboratory.md", "text")
    head, *rows = shots.strip().splitlines()
    _write(folder / "shots.csv", head, rows * 3)
    stations = ((0.25, 60), (1, 62), (4, 63.5), (8, 60), (14, 44), (20, 30), (26, 25), (33, 25), (33.7, 50))
    _write(folder / "stations.csv", "in_from_tip,diameter_mm", [f"{place},{width}" for place, width in stations])
    _write(
        folder / "dozen.csv",
        "name,mass_oz,balance_point_in,pendulum_s",
        [f"{name},{mass}±0.05,22.05±0.05,1.4545±0.003" for name, mass in (("A", 31.0), ("B", 31.4))],
    )
    if "bat.jpg" in page.read_text(encoding="utf-8"):
        saved(folder / "bat.jpg", rendered(angle=8, ruler=0.3), quality=90)
    _write_swings(folder)
    _write_season(folder)


def _write(path: Path, head: str, rows: list[str]) -> None:
    path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")


def _write_swings(folder: Path) -> None:
    rng = np.random.default_rng(4)
    rows = []
    for player in ("Ann", "Bea"):
        for bat in ("r161-ash", "mlb-a"):
            rows += [
                f"{player},{bat},{speed:.1f},{12 + 1.2 * speed - abs(rng.normal(0, 3)):.1f},60"
                for speed in rng.normal(66, 1.5, 6)
            ]
    head = "bat,bat_speed_mph,exit_speed_mph,pitch_speed_mph"
    _write(folder / "team.csv", f"player,{head}", rows)
    _write(folder / "swings.csv", head, [row.removeprefix("Ann,") for row in rows if row.startswith("Ann")])


def _write_season(folder: Path) -> None:
    first, second = (
        made_up(60, year=year).with_columns(pl.col("batter").replace(600_000, 592_450)) for year in (2024, 2025)
    )
    first.write_csv(folder / "statcast_2024.csv.gz", compression="gzip")
    second.write_parquet(folder / "statcast_2025.parquet")
    first.select(
        Date="game_date", BatterId="batter", Batter="player_name", BatterSide="stand", ExitSpeed="launch_speed",
        Angle="launch_angle", Direction=pl.col("attack_direction"), PitchCall=pl.lit("InPlay"), BatSpeed="bat_speed",
        RelSpeed="release_speed",
    ).write_csv(folder / "trackman.csv")  # fmt: skip
    _write(folder / "bats.csv", "batter,bat", ["592450,mlb-a", ",r161-ash"])

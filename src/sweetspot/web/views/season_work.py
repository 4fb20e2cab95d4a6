"""Season's long work: tables are read in a process of its own; what is told of them lies in files of its folder."""

from __future__ import annotations

import json
import os
import pickle
import shutil
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pydantic_core

from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.whole_files import written_whole
from sweetspot.web.documents import told
from sweetspot.web.jobs import Say
from sweetspot.web.uploads import TAKEN_AWAY

if TYPE_CHECKING:  # tables load slowly, and no other view needs them
    from sweetspot.report.season.document import SeasonReport
    from sweetspot.season.season_table import Season

SUMMARY, REPORT, HANDED_IN = "summary.json", "report.pickle", "handed-in"
LISTED = 3000
"""Players that can be chosen from, those with most balls."""
LONGEST_NAME = 120
"""Bytes of a file's name that is kept."""
MEASURES = ("ev20", "exit_speed", "bat_speed", "squared_up", "from_best", "home_runs", "home_runs_expected")
"""Of each player in the list."""
SETTLED = 1.0
"""s of reading from which on its speed is told: the first parts come together."""
MADE_UP = (16, 90)
"""Players of a made-up season, and balls of each."""

Handed = tuple[tuple[Path, str], ...]
"""Where each file lies, and what it was called."""


def read_season(
    handed: Handed, folder: Path, key: str, bat: Bat, described: str, *, after: Any, say: Say
) -> dict[str, Any]:
    """Read tables of balls in play, or a made-up one where none is handed in: begins work that says how far it is.

    The result's ``season`` is the name by which the view is asked about it.
    """
    from sweetspot.report.season.document import season_report

    say({"phase": "tables"}, True)
    paths = named(handed, folder / HANDED_IN) if handed else [made_up(bat, folder)]
    season = analysed(paths, folder, bat, resume=after is not None, say=say)
    say({"phase": "players"}, True)
    report = season_report(season)
    keep(report, folder, described)
    return {"phase": "done", "season": key}


def named(handed: Handed, folder: Path) -> list[Path]:
    """Return the files under the names that people know, each in a folder of its own."""
    paths = []
    for number, (path, name) in enumerate(handed):
        usual = name.isprintable() and len(name.encode()) <= LONGEST_NAME
        target = folder / f"{number:03d}" / (name if usual else f"table{''.join(path.suffixes)}")
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists():
            try:
                os.link(path, target)
            except OSError:  # a file system without links
                shutil.copyfile(path, target)
        paths.append(target)
    return paths


def made_up(bat: Bat, folder: Path) -> Path:
    """Return the table of a made-up season, made unless it is there."""
    from sweetspot.season.made_up import MadeSeason, made_season

    path = folder / "made-up season.parquet"
    if not path.exists():
        with written_whole(path) as file:
            made_season(bat, MadeSeason(*MADE_UP)).write_parquet(file)
    return path


def analysed(paths: list[Path], folder: Path, bat: Bat, *, resume: bool, say: Say) -> Season:
    """Return the season of some tables; what is wrong with one is said by the name that people know."""
    from sweetspot.season.season_table import analyse_season, season_setting

    setting = season_setting(bats={"": bat}, threads=1)
    try:
        return analyse_season(paths, setting=setting, folder=folder, resume=resume, progress=counting(say))
    except InputError as error:
        raise InputError(without_folders(str(error), paths)) from None


def counting(say: Say) -> Callable[[int, int], None]:
    """Return what tells how many rows are done, how many a second since the first, and how long the rest takes."""
    first: list[tuple[int, float]] = []

    def progress(done: int, rows: int) -> None:
        now = time.monotonic()
        first.append((done, now))
        (before, begun), speed = first[0], None
        if done > before and now - begun > SETTLED:
            speed = (done - before) / (now - begun)
        left = None if speed is None else (rows - done) / speed
        say({"phase": "rows", "done": done, "rows": rows, "rows_per_s": speed, "left_s": left}, True)

    return progress


def without_folders(words: str, paths: list[Path]) -> str:
    """Return words with nothing of the folders that files lie in."""
    for path in paths:
        words = words.replace(f"{path.parent}{os.sep}", "")
    return words


def keep(report: SeasonReport, folder: Path, described: str) -> None:
    """Write what the view tells of a season, the tables that can be taken away, and the summary last of all."""
    from sweetspot.report.season.document import season_document, unread_of
    from sweetspot.report.season.tables import write_tables
    from sweetspot.season.maps import choices_of

    tables = folder / TAKEN_AWAY
    tables.mkdir(exist_ok=True)
    write_tables(report, tables)
    report.season.balls().sink_parquet(tables / "balls.parquet")
    report.season.ledger().sink_parquet(tables / "ledger.parquet")
    named = without_paths(report)
    document = told(season_document(named))
    summary = {
        "bat": described, "html": document["html"], "players": players_of(report),
        "choices": choices_of(report.counted), "rows": report.season.survey.rows,
        "files": [table.path.name for table in report.season.survey.tables],
        "unread": unread_of(named.season),
        "tables": [{"name": path.name, "bytes": path.stat().st_size} for path in sorted(tables.iterdir())],
    }  # fmt: skip
    (folder / REPORT).write_bytes(pickle.dumps(replace(report, counted=report.counted.clear())))
    (folder / SUMMARY).write_bytes(pydantic_core.to_json(summary, inf_nan_mode="null"))


def without_paths(report: SeasonReport) -> SeasonReport:
    """Return a report whose faults name files as people know them."""
    survey = report.season.survey
    faults = tuple((path, without_folders(reason, [path])) for path, reason in survey.faults)
    return replace(report, season=replace(report.season, survey=replace(survey, faults=faults)))


def players_of(report: SeasonReport) -> list[dict[str, Any]]:
    """Return the players of a season, those with most balls first, with a few measures in SI."""
    players = report.standings.get("batter")
    if players is None:
        return []
    table = players.table.sort(["balls", "batter"], descending=[True, False]).head(LISTED)
    known = [name for name in MEASURES if name in table.columns]
    return [
        {"batter": str(row["batter"]), "name": str(row.get("name") or row["batter"]), "balls": row["balls"],
         **{one: row[one] for one in known}}
        for row in table.iter_rows(named=True)
    ]  # fmt: skip


def kept_summary(folder: Path) -> dict[str, Any] | None:
    """Return what was told of a season; None: it has not been read to its end."""
    path = folder / SUMMARY
    return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else None


def kept_report(folder: Path) -> SeasonReport:
    """Return a season's report without its balls; the file is this server's own."""
    report: SeasonReport = pickle.loads((folder / REPORT).read_bytes())
    return report

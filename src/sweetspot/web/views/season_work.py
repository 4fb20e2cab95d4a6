"""Season's long work: tables are read in a process of its own, which writes the results to files of its folder."""

from __future__ import annotations

import math
import os
import pickle
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from sweetspot.answers.records import INTERNAL
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.whole_files import written_whole
from sweetspot.units import grouped
from sweetspot.units.dimensions import System
from sweetspot.web.documents import page_document
from sweetspot.web.jobs import Say
from sweetspot.web.uploads import TAKEN_AWAY

if TYPE_CHECKING:  # tables load slowly, and no other view needs them
    from sweetspot.answers.season import SeasonAnswer

SUMMARY, ANSWER, HANDED_IN = "summary.pickle", "answer.pickle", "handed-in"
LISTED = 3000
"""Players that can be chosen from, those with most balls."""
LONGEST_NAME = 120
"""Bytes of a file's name that is kept."""
SETTLED = 1.0
"""s of reading from which on its speed is reported: the first parts come together."""
MADE_UP = (16, 90)
"""Players of a made-up season, and balls of each."""

Handed = tuple[tuple[Path, str], ...]
"""The path of each file, and its original name."""


@dataclass(frozen=True)
class ListedPlayer:
    """One player in the list; measures in SI, partly pooled, None where no table tells."""

    batter: str
    name: str
    balls: int
    ev20: float | None
    exit_speed: float | None
    bat_speed: float | None
    squared_up: float | None
    from_best: float | None
    home_runs: int | None
    home_runs_expected: float | None


MEASURES = tuple(field.name for field in fields(ListedPlayer)[3:])


@dataclass(frozen=True)
class SavedTable:
    """A table that can be taken away."""

    name: str
    bytes: int


@dataclass(frozen=True)
class SeasonSummary:
    """The summary of a season that was read to its end; ``bat`` is the state of the bat it was read with.

    Balls can be chosen by ``choices``, each with its number of balls; ``words`` say how much of which files was read,
    and ``same_bat`` whether that bat lies on the bench.
    """

    bat: Annotated[str, INTERNAL]
    html: Annotated[Mapping[System, str], INTERNAL]
    players: Annotated[tuple[ListedPlayer, ...], INTERNAL]
    choices: Mapping[str, Sequence[tuple[str, int]]]
    rows: int
    files: tuple[str, ...]
    words: str
    unread: tuple[str, ...]
    tables: tuple[SavedTable, ...]
    same_bat: bool = True


@dataclass(frozen=True, kw_only=True)
class SeasonReading:
    """How far the reading of a season is.

    Parameters
    ----------
    words, reached : what is being done, and after how many rows; "": none is read yet.
    season : the name by which the view is asked about a season that is read.
    """

    phase: Literal["tables", "rows", "players", "done"]
    words: str
    reached: str = ""
    rows_read: int = 0
    rows: int = 0
    season: str | None = None


def read_season(
    handed: Handed, folder: Path, key: str, bat: Bat, described: str, *, after: object, say: Say
) -> SeasonReading:
    """Read tables of balls in play, or a made-up one where none is handed in: begins work that says how far it is."""
    words = "Looking through the tables; a bat that is new here takes some seconds more …"
    say(SeasonReading(phase="tables", words=words), True)
    paths = named(handed, folder / HANDED_IN) if handed else [made_up(bat, folder)]
    keep(analysed(paths, folder, bat, resume=after is not None, say=say), folder, described)
    return SeasonReading(phase="done", words="", season=key)


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
    from sweetspot.seasons.made_up import MadeSeason, made_season

    path = folder / "made-up season.parquet"
    if not path.exists():
        with written_whole(path) as file:
            made_season(bat, MadeSeason(*MADE_UP)).write_parquet(file)
    return path


def analysed(paths: list[Path], folder: Path, bat: Bat, *, resume: bool, say: Say) -> SeasonAnswer:
    """Return the answer about some tables; the faults of one are reported by the name that people know."""
    from sweetspot.answers.season import season_answer
    from sweetspot.answers.season_question import SeasonQuestion

    question = SeasonQuestion(paths=paths, bats={"": bat}, folder=folder, resume=resume, threads=1)
    try:
        answer = season_answer(question, progress=counting(say))
    except InputError as error:
        raise InputError(without_folders(str(error), paths)) from None
    reasons = (replace(unread, reason=without_folders(unread.reason, paths)) for unread in answer.not_read)
    return replace(answer, not_read=tuple(reasons))


def counting(say: Say) -> Callable[[int, int], None]:
    """Return a callback that reports how many rows are read, how many a second since the first, and the time left."""
    first: list[tuple[int, float]] = []

    def progress(finished: int, rows: int) -> None:
        now = time.monotonic()
        first.append((finished, now))
        before, begun = first[0]
        reached = f"{grouped(finished)} of {grouped(rows)} rows"
        words = f"{reached} …"
        if finished > before and now - begun > SETTLED:
            speed = (finished - before) / (now - begun)
            words = f"{reached}, {grouped(speed)} rows/s, {math.ceil((rows - finished) / speed)} s left"
        say(SeasonReading(phase="rows", words=words, reached=reached, rows_read=finished, rows=rows), True)
        if finished >= rows:
            words = "Working out players, clubs and months …"
            say(SeasonReading(phase="players", words=words, reached=reached), True)

    return progress


def without_folders(words: str, paths: list[Path]) -> str:
    """Return words with nothing of the folders that files lie in."""
    for path in paths:
        words = words.replace(f"{path.parent}{os.sep}", "")
    return words


def keep(answer: SeasonAnswer, folder: Path, described: str) -> None:
    """Write what the view tells of a season, the tables that can be taken away, and the summary last of all."""
    from sweetspot.reports.season.document import season_document, unread_of, write_tables
    from sweetspot.reports.season.page_words import read_words
    from sweetspot.seasons.ball_maps import choices_of

    tables = folder / TAKEN_AWAY
    tables.mkdir(exist_ok=True)
    write_tables(answer, tables)
    answer.balls().sink_parquet(tables / "balls.parquet")
    answer.season.ledger().sink_parquet(tables / "ledger.parquet")
    rows, files = sum(table.rows for table in answer.tables), tuple(Path(table.file).name for table in answer.tables)
    summary = SeasonSummary(
        bat=described,
        html=page_document(season_document(answer)).html,
        players=tuple(players_of(answer)),
        choices=choices_of(answer.counted),
        rows=rows,
        files=files,
        words=read_words(rows, files),
        unread=tuple(unread_of(answer)),
        tables=tuple(SavedTable(path.name, path.stat().st_size) for path in sorted(tables.iterdir())),
    )
    (folder / ANSWER).write_bytes(pickle.dumps(replace(answer, counted=answer.counted.clear())))
    with written_whole(folder / SUMMARY) as file:
        pickle.dump(summary, file)


def players_of(answer: SeasonAnswer) -> Iterator[ListedPlayer]:
    """Yield the players of a season, those with most balls first."""
    players = answer.standings.get("batter")
    if players is None:
        return
    table = players.table.sort(["balls", "batter"], descending=[True, False]).head(LISTED)
    for row in table.iter_rows(named=True):
        batter, measures = str(row["batter"]), {name: row.get(name) for name in MEASURES}
        yield ListedPlayer(batter, str(row.get("name") or batter), row["balls"], **measures)


def kept_summary(folder: Path) -> SeasonSummary | None:
    """Return the summary of a season; None: it has not been read to its end. The file is this server's own."""
    path = folder / SUMMARY
    if not path.exists():
        return None
    summary: SeasonSummary = pickle.loads(path.read_bytes())
    return summary


def kept_answer(folder: Path) -> SeasonAnswer:
    """Return the answer about a season without its balls; the file is this server's own."""
    answer: SeasonAnswer = pickle.loads((folder / ANSWER).read_bytes())
    return answer

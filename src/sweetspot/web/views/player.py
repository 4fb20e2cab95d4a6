"""The player: what measured swings say of bat speed and scatter, and which bat and contact point serve."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from sweetspot.answers.player import player_answer
from sweetspot.answers.player_question import (
    FitPlayerQuestion,
    PlayerSwings,
    player_advice,
    player_posterior,
    read_player,
)
from sweetspot.answers.records import GAPS
from sweetspot.errors import SweetspotError, nearest_names
from sweetspot.numerics.arrays import Array
from sweetspot.player.goal import Goal
from sweetspot.player.posterior import PlayerPosterior
from sweetspot.player.swing_table import narrow_csv
from sweetspot.player.swings import batters
from sweetspot.reports.player.document import player_document
from sweetspot.reports.quantities import SYSTEMS
from sweetspot.units import MPH
from sweetspot.units.dimensions import SPEED
from sweetspot.web.bats import described, listed_bat
from sweetspot.web.controls import BatState, within
from sweetspot.web.documents import ReadDocument, Sentences, in_one_system, page_document
from sweetspot.web.drawings import BenchBat, bench_bat
from sweetspot.web.errors import FieldError, about
from sweetspot.web.recipes import bat_name, bat_text, option
from sweetspot.web.uploads import UPLOADS, UploadKey
from sweetspot.web.view import View

LONGEST_TABLE = 40_000
"""Letters of the swings' table, about a thousand rows."""
LARGEST_FILE = 10_000_000
"""Bytes of a file of swings that is handed in."""
BY_FORCE = re.compile(", or add --force [a-z ]+")
"""Further options of the command line."""
NEW_LINE = "\n"
MORE = "more than fit here; hand in the rows of one batter, or take the command fit-player"
EXAMPLE_ROWS, MOST_ROWS = 60, 20
"""Swings of the made-up player, and bad rows that are listed."""


class PlayerState(BatState):
    """The player's swings, the bat they were made with, and what is wanted."""

    swings_csv: Annotated[str, Field(max_length=LONGEST_TABLE)] | None = Field(
        None, description="one row per swing: Blast, HitTrax, Statcast or plain; empty: an example"
    )
    swings_of: Annotated[str, Field(min_length=1, max_length=80)] | None = Field(
        None, description="whose swings count, where the table has several batters; empty: the first in the alphabet"
    )
    upload: UploadKey | None = Field(None, description="a file that was handed in, to be made a table of swings")
    goal: Literal["exit-speed", "carry"] = Field("exit-speed", description="what the player wants more of")
    given_pitch_mph: Annotated[float, within("pitch_speed", "mph")] = Field(
        55.0, description="at the plate, for rows without one; 0: a tee"
    )


@dataclass(frozen=True)
class ReadSwings:
    """The swings of a table as they were read.

    Parameters
    ----------
    bat_speed, exit_speed : shape (swings,); nan where the table has none.
    batters, batter : that the table names, and whose swings these are; None: of all, as the table names none.
    words, notes : what was read, and what is odd about it and why rows could not be used.
    """

    bat: BenchBat
    bat_speed: Annotated[Array, SPEED, GAPS]
    exit_speed: Annotated[Array, SPEED, GAPS]
    batters: tuple[str, ...]
    batter: str | None
    words: str
    notes: Sentences


@dataclass(frozen=True)
class SwingTable:
    """A table of swings as text, None: no file was handed in."""

    csv: str | None = None


def answer(state: PlayerState) -> ReadSwings:
    """Return the swings as they were read: speeds of bat and ball, rows that could not be used and why."""
    swings = _swings(state).file
    batter, bad = _batter(state), len(swings.bad_rows)
    notes = [*swings.notes, *(f"row {row.row}: {row.reason}" for row in swings.bad_rows[:MOST_ROWS])]
    counted = _counted(len(swings.swings), "swing") + (f" of {batter}" if batter else "")
    if state.swings_csv is None:
        counted += " of a made-up player; bring your own table to read yours"
    return ReadSwings(
        bench_bat(state, described(state)),
        np.array([swing.bat_speed for swing in swings.swings], float),
        np.array([swing.exit_speed for swing in swings.swings], float),
        batters_of(state.swings_csv),
        batter,
        f"{counted}; {_counted(bad, 'row')} could not be used." if bad else f"{counted}.",
        {system: [in_one_system(note)[system] for note in notes] for system in SYSTEMS},
    )


def _counted(number: int, thing: str) -> str:
    return f"{number} {thing}{'' if number == 1 else 's'}"


def _batter(state: PlayerState) -> str | None:
    """Return the batter whose swings count: as chosen, or the first of several in the alphabet."""
    names = batters_of(state.swings_csv)
    return state.swings_of or (names[0] if len(names) > 1 else None)


def table(state: PlayerState) -> SwingTable:
    """Return of a file that was handed in only the columns that mean something, short enough for a state."""
    if state.upload is None:
        return SwingTable()
    path, name = UPLOADS.path_of(state.upload)
    if path.stat().st_size > LARGEST_FILE:
        raise FieldError("swings_csv", f"{name} has {path.stat().st_size / 1e6:.0f} MB, {MORE}")
    try:
        text = narrow_csv(path)
    except SweetspotError as error:
        raise FieldError("swings_csv", str(error).replace(str(path), name)) from None
    if len(text) > LONGEST_TABLE:
        raise FieldError("swings_csv", f"{name} has {text.count(NEW_LINE)} lines, {MORE}")
    return SwingTable(text)


def fit(state: PlayerState) -> ReadDocument:
    """Return the training report: what the swings say, and what serves; one second or two."""
    return _fitted(state)


@lru_cache(maxsize=16)
def _fitted(state: PlayerState) -> ReadDocument:
    swings = _swings(state)
    document = player_document(player_answer(swings, player_advice(swings.question, learned(state))))
    return page_document(document, pictured=True)


@lru_cache(maxsize=16)
def learned(state: PlayerState) -> PlayerPosterior:
    """Return the parameters of the player learned from the swings of a state; it takes a second or so."""
    swings = _swings(state)
    with about("swings_csv"):
        return player_posterior(swings)


@contextmanager
def _file(text: str | None) -> Iterator[Path]:
    """Have a table of swings as a file; None: the example."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "swings.csv"
        path.write_text(_example() if text is None else text, encoding="utf-8")
        yield path


@lru_cache(maxsize=16)
def batters_of(text: str | None) -> tuple[str, ...]:
    """Return the batters that a table of swings names, in the order of the alphabet; none where it names none."""
    with _file(text) as path:
        try:
            return batters(path)
        except SweetspotError:  # reading the swings tells what is wrong
            return ()


@lru_cache(maxsize=16)
def _swings(state: PlayerState) -> PlayerSwings:
    names = batters_of(state.swings_csv)
    if state.swings_of is not None and state.swings_of not in names:
        near = nearest_names(state.swings_of, names) if names else "It names no batter; leave this empty."
        raise FieldError("swings_of", f"the table has no swings of {state.swings_of!r}. {near}")
    with _file(state.swings_csv) as path:
        question = FitPlayerQuestion(
            path,
            bat=described(state),
            load_bat=listed_bat,
            stand_ins=False,
            batter=_batter(state),
            pitch_speed=state.given_pitch_mph * MPH,
            goal=Goal(state.goal),
        )
        try:
            swings = read_player(question)
        except SweetspotError as error:
            words = BY_FORCE.sub("", str(error)).replace(str(path), "the table")
            raise FieldError("swings_csv", words) from None
    return swings if state.swings_csv else replace(swings, file=replace(swings.file, system="made-up"))


@lru_cache(maxsize=1)
def _example() -> str:
    """Return a made-up table of swings: no player's, to see what the page does with one."""
    random = np.random.default_rng(7)
    bat = 62 + 2.2 * random.standard_normal(EXAMPLE_ROWS)
    miss = 1.4 * random.standard_normal(EXAMPLE_ROWS)
    ball = 1.21 * bat + 0.2 * 55 - 0.9 * miss**2 + 0.6 * random.standard_normal(EXAMPLE_ROWS)
    rows = [f"{swung:.1f},{hit:.1f},55" for swung, hit in zip(bat, ball, strict=True)]
    return "\n".join(["bat_speed_mph,exit_speed_mph,pitch_speed_mph", *rows]) + "\n"


def recipe(state: PlayerState) -> dict[str, str]:
    """Return the command line that gives the same report, the table and the bat's file."""
    pitch = "tee" if state.given_pitch_mph == 0 else f"{state.given_pitch_mph:.12g}mph"
    batter = _batter(state) if len(batters_of(state.swings_csv)) > 1 else None
    command = f"sweetspot fit-player swings.csv --bat {bat_name(state)} --goal {state.goal} --pitch-speed {pitch}"
    return {"command": command + (f" {option('--batter', batter)}" if batter else ""), "toml": bat_text(state)}


VIEW = View("player", "Player", PlayerState, answer, recipe, asides={"fit": fit, "table": table})

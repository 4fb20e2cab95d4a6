"""Season: tables of balls in play of any size; what was read, who did what, and where on the bat balls were met."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import numpy as np
from pydantic import Field

from sweetspot import catalog
from sweetspot.answers.records import GRID
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.numerics.arrays import Array
from sweetspot.reports.sentences import Sentence
from sweetspot.units import INCH
from sweetspot.units.dimensions import LENGTH, System
from sweetspot.web.bats import PARK, described
from sweetspot.web.controls import BatState, Name
from sweetspot.web.documents import ReadDocument, in_either_system, page_document
from sweetspot.web.drawings import BenchBat, bench_bat
from sweetspot.web.errors import FieldError, about
from sweetspot.web.jobs import LongWork
from sweetspot.web.recipes import bat_name, bat_text, option
from sweetspot.web.uploads import UPLOADS, UploadKey
from sweetspot.web.view import View
from sweetspot.web.views.design_state import BatterControls, batter_controls
from sweetspot.web.views.season_work import (
    Handed,
    ListedPlayer,
    SeasonSummary,
    kept_answer,
    kept_summary,
    read_season,
)

if TYPE_CHECKING:  # tables load slowly, and no other view needs them
    from sweetspot.answers.season import SeasonAnswer
    from sweetspot.seasons.ball_maps import BallMap

MOST_TABLES = 60
PLACES_DOUBT, LEAST_SPREAD = 1.0 * INCH, 0.2 * INCH
"""m: a season's places are known to an inch, since inside and outside of the best one are hard to separate; and the
smallest scatter that Design takes."""
Choice = Annotated[str, Field(min_length=1, max_length=80)] | None
OTHER_BAT = "They were read with another bat than the one on the bench now."
DIRECTIONS = np.linspace(-FOUL_LINE, FOUL_LINE, 46)


class SeasonState(BatState):
    """Tables that were handed in, the bat that all hitters are taken to swing, and which balls are looked at."""

    uploads: Annotated[tuple[UploadKey, ...], Field(max_length=MOST_TABLES)] = Field(
        (), description="tables that are to be read, by the names under which they were handed in; none: a made-up one"
    )
    season: UploadKey | None = Field(None, description="what was read, by the name that reading gave it")
    batter: Choice = Field(None, description="whose balls; empty: everybody's")
    team: Choice = Field(None, description="hit for which club; empty: for any")
    pitch_type: Choice = Field(None, description="off which pitches; empty: off all")
    count: Choice = Field(None, description="at which count, as 3-2; empty: at all")
    month: Choice = Field(None, description="in which month, as 2024-07; empty: in all")
    park: Choice = Field(None, description="hit in which park; empty: in all")
    fence: Name | None = Field(
        None, description="park whose fence is drawn over the field; empty: the one chosen under park, else Fenway Park"
    )


@dataclass(frozen=True)
class FieldFence:
    """A park's fence, to the right of the line to centre field and along it, from home."""

    name: str
    right: Annotated[Array, LENGTH]
    out: Annotated[Array, LENGTH]
    words: str


@dataclass(frozen=True)
class SeasonPicture:
    """The bat, the chosen park's fence, and of a season that was read what can be chosen and taken away."""

    bat: BenchBat
    park: FieldFence
    season: SeasonSummary | None


@dataclass(frozen=True)
class SeasonWords:
    """The summary of the whole season, and its players; nothing where none was read."""

    html: Mapping[System, str] | None = None
    players: tuple[ListedPlayer, ...] | None = None


@dataclass(frozen=True)
class MappedBalls:
    """Balls in boxes; see `BallMap`. ``note`` explains the picture, and ``label`` tells it to who does not see it."""

    across: Annotated[Array, LENGTH]
    along: Annotated[Array, LENGTH]
    balls: Annotated[Array, GRID]
    outside: int
    near: int
    note: Mapping[System, str]
    label: Mapping[System, str]


@dataclass(frozen=True)
class BallMeans:
    """Number of balls, and their means in SI, shares from 0 to 1; None where no table tells."""

    balls: float | None
    exit_speed: float | None = None
    ev20: float | None = None
    bat_speed: float | None = None
    squared_up: float | None = None
    league_squared_up: float | None = None
    from_best: float | None = None
    carry: float | None = None
    home_runs: float | None = None
    home_runs_expected: float | None = None


@dataclass(frozen=True)
class BallCeilings:
    """Part of the balls by exit speed over the greatest possible: with this bat, and by the league's formula."""

    ratio: Array
    squared_up_ratio: Array | None = None
    league_ratio: Array | None = None


@dataclass(frozen=True)
class SeasonMaps:
    """Of the chosen balls how well they were hit, where on the barrel, and where they would come down.

    Parameters
    ----------
    words : whose balls they are, and how well they were hit.
    unmapped : why there is no map of the barrel; None: there is one.
    """

    words: Mapping[System, str] | None = None
    unmapped: str | None = None
    means: BallMeans | None = None
    ceilings: BallCeilings | None = None
    barrel: MappedBalls | None = None
    field: MappedBalls | None = None


def answer(state: SeasonState) -> SeasonPicture:
    """Return the bat, the chosen park's fence, and of a season that was read what can be chosen and taken away."""
    bat = described(state)
    with about("fence"):
        park = fenced(state)
        distance, _ = fence_at(park, DIRECTIONS)
    summary = _summary(state)
    if summary is not None and summary.bat != bat_words(state):
        summary = replace(summary, same_bat=False, words=f"{summary.words} {OTHER_BAT}")
    right, out = distance * np.sin(DIRECTIONS), distance * np.cos(DIRECTIONS)
    fence = FieldFence(park.name, right, out, f"The fence is that of {park.name}.")
    return SeasonPicture(bench_bat(state, bat), fence, summary)


def fenced(state: SeasonState) -> Park:
    """Return the park whose fence is drawn: as chosen by hand, else where the looked-at balls were hit, else Fenway."""
    if state.fence is not None:
        return catalog.park(state.fence)
    try:
        return catalog.park(state.park or PARK)
    except InputError:  # no ball was hit in such a park, and the answer shows none
        return catalog.park(PARK)


def bat_words(state: BatState) -> str:
    """Return the text that identifies a bat."""
    return state.model_dump_json(include=set(BatState.model_fields))


def begun(state: SeasonState) -> tuple[Handed, Path, str, Bat, str]:
    """Return the arguments of reading, with a new folder for what is made of the tables."""
    with renamed("uploads"):
        handed = tuple(UPLOADS.path_of(key) for key in state.uploads)
    bat = described(state)
    key = UPLOADS.begin_folder(state.uploads)
    return handed, UPLOADS.folder_of(key), key, bat, bat_words(state)


@contextmanager
def renamed(field: str) -> Iterator[None]:
    """Assign the error of a missing file to a control."""
    try:
        yield
    except FieldError:
        raise FieldError(field, "these tables are not here any more; hand them in again") from None


def summary(state: SeasonState) -> SeasonWords:
    """Return the summary of the whole season, and its players."""
    found = _summary(state)
    return SeasonWords() if found is None else SeasonWords(found.html, found.players)


def maps(state: SeasonState) -> SeasonMaps:
    """Return of the chosen balls how well they were hit, where on the barrel, and where they would come down."""
    from sweetspot.reports.season.page_words import barrel_words, field_words
    from sweetspot.seasons import ball_maps
    from sweetspot.seasons.season_table import counted_in

    folder = _folder(state)
    if folder is None:
        return SeasonMaps()
    chosen = {name: value for name in ("batter", *ball_maps.CHOICES) if (value := getattr(state, name)) is not None}
    counted = ball_maps.chosen_balls(counted_in(folder), chosen)
    means, ceilings = BallMeans(**ball_maps.ball_means(counted)), ball_maps.ceiling_counts(counted)
    barrel, field = ball_maps.barrel_counts(counted), ball_maps.field_counts(counted)
    unmapped = "These tables have no bat speeds, so nothing is said of bats."
    return SeasonMaps(
        in_either_system(_words(state, means)),
        None if barrel is not None else unmapped if means.balls else "No ball is left by this choice.",
        means,
        None if ceilings is None else BallCeilings(**ceilings),
        None if barrel is None else _mapped(barrel, barrel_words(barrel)),
        None if field is None else _mapped(field, field_words(field)),
    )


def _words(state: SeasonState, means: BallMeans) -> Sentence:
    """Return the player of the chosen balls, and how well they were hit."""
    from sweetspot.reports.season.page_words import balls_words

    summary = _summary(state)
    players = () if summary is None else summary.players
    name = next((listed.name for listed in players if listed.batter == state.batter), state.batter)
    whose = f"player {name}" if name is not None and name == state.batter else name
    return balls_words(
        whose,
        "" if summary is None else described(BatState.model_validate_json(summary.bat)).name,
        balls=means.balls or 0.0,
        exit_speed=means.exit_speed,
        squared_up=means.squared_up,
        from_best=means.from_best,
    )


def _mapped(ball_map: BallMap, words: tuple[Sentence, Sentence]) -> MappedBalls:
    note, label = map(in_either_system, words)
    return MappedBalls(
        ball_map.across, ball_map.along, ball_map.counts, ball_map.outside, ball_map.near, note=note, label=label
    )


def player(state: SeasonState) -> ReadDocument | None:
    """Return one player's page; None where no player is chosen."""
    from sweetspot.reports.season.document import player_page

    folder = _folder(state)
    if folder is None or state.batter is None:
        return None
    with about("batter"):
        return page_document(player_page(_answer(folder).player(state.batter)))


def contacts(state: SeasonState) -> BatterControls:
    """Return the chosen player's contact place and swing speed, as controls of the view Design."""
    from sweetspot.designs.batter import contacts_at
    from sweetspot.seasons.ball_maps import contact_places

    folder = _folder(state)
    if folder is None or state.batter is None:
        return BatterControls()
    with about("batter"):
        contacts = contacts_at(contact_places(folder, state.batter))
    values = {
        "position": contacts.mean,
        "position_spread": max(contacts.spread, LEAST_SPREAD),
        "position_doubt": math.hypot(contacts.mean_doubt, PLACES_DOUBT),
    }
    summary = _summary(state)
    players = () if summary is None else summary.players
    bat_speed = next((listed.bat_speed for listed in players if listed.batter == state.batter), None)
    if bat_speed is not None:
        values["bat_speed"] = bat_speed
    return batter_controls(values)


def _folder(state: SeasonState) -> Path | None:
    if state.season is None:
        return None
    with renamed("season"):
        folder = UPLOADS.folder_of(state.season)
    if kept_summary(folder) is None:
        raise FieldError("season", "these tables have not been read to their end; read them again")
    return folder


def _summary(state: SeasonState) -> SeasonSummary | None:
    folder = _folder(state)
    return None if folder is None else kept_summary(folder)


@lru_cache(maxsize=4)
def _answer(folder: Path) -> SeasonAnswer:
    return kept_answer(folder)


def recipe(state: SeasonState) -> dict[str, str]:
    """Return the command line that reads the same tables, and the bat's file."""
    page = "" if state.batter is None else " " + option("--player", state.batter)
    return {
        "command": f"sweetspot season TABLE.csv --bat {bat_name(state)}{page} --out season",
        "toml": bat_text(state),
    }


ASIDES = {"summary": summary, "maps": maps, "player": player, "contacts": contacts}
READ = {"read": LongWork(read_season, begun)}
VIEW = View("season", "Season", SeasonState, answer, recipe, asides=ASIDES, jobs=READ)

"""Season: tables of balls in play of any size; what was read, who did what, and where on the bat balls were met."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import numpy as np
from pydantic import Field

from sweetspot import catalog
from sweetspot.answers.implement import mass_properties
from sweetspot.answers.records import to_dict
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.errors import InputError
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.units import INCH
from sweetspot.web.bat_bounds import bounds
from sweetspot.web.bats import PARK, described
from sweetspot.web.documents import ReadDocument, told
from sweetspot.web.drawings import outline
from sweetspot.web.errors import FieldError, about
from sweetspot.web.jobs import LongWork
from sweetspot.web.recipes import bat_name, bat_text, option
from sweetspot.web.states import BatState, Name
from sweetspot.web.uploads import UPLOADS, UploadKey
from sweetspot.web.view import View
from sweetspot.web.views.design_state import batter_controls
from sweetspot.web.views.season_work import Handed, kept_answer, kept_summary, read_season

if TYPE_CHECKING:  # tables load slowly, and no other view needs them
    from sweetspot.answers.season import SeasonAnswer
    from sweetspot.season.ball_maps import BallMap

MOST_TABLES = 60
PLACES_DOUBT, LEAST_SPREAD = 1.0 * INCH, 0.2 * INCH
"""m: a season's places are known to an inch, for inside and outside of the best one are told apart badly; and the
smallest scatter that Design takes."""
Choice = Annotated[str, Field(min_length=1, max_length=80)] | None
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


def answer(state: SeasonState) -> dict[str, Any]:
    """Return the bat, the chosen park's fence, and of a season that was read what can be chosen and taken away."""
    bat = described(state)
    with about("fence"):
        park = fenced(state)
        distance, _ = fence_at(park, DIRECTIONS)
    folder = _folder(state)
    summary = None if folder is None else kept_summary(folder)
    return {
        "bat": {
            **to_dict(mass_properties(bat, rigid_body(beam_model(bat)))), **to_dict(outline(bat)),
            "bounds": bounds(state, bat),
        },
        "park": {
            "name": park.name, "right_m": distance * np.sin(DIRECTIONS), "out_m": distance * np.cos(DIRECTIONS),
        },
        "season": None if summary is None else {
            **{name: summary[name] for name in ("choices", "rows", "files", "unread", "tables")},
            "same_bat": summary["bat"] == bat_words(state),
        },
    }  # fmt: skip


def fenced(state: SeasonState) -> Park:
    """Return the park whose fence is drawn: as chosen by hand, else where the looked-at balls were hit, else Fenway."""
    if state.fence is not None:
        return catalog.park(state.fence)
    try:
        return catalog.park(state.park or PARK)
    except InputError:  # no ball was hit in such a park, and the answer shows none
        return catalog.park(PARK)


def bat_words(state: BatState) -> str:
    """Return what tells one bat from another."""
    return state.model_dump_json(include=set(BatState.model_fields))


def begun(state: SeasonState) -> tuple[Handed, Path, str, Any, str]:
    """Return what reading takes, with a new folder for what is made of the tables."""
    with renamed("uploads"):
        handed = tuple(UPLOADS.path_of(key) for key in state.uploads)
    bat = described(state)
    key = UPLOADS.begin_folder(state.uploads)
    return handed, UPLOADS.folder_of(key), key, bat, bat_words(state)


@contextmanager
def renamed(field: str) -> Iterator[None]:
    """Say of a file that has gone that it belongs to a control."""
    try:
        yield
    except FieldError:
        raise FieldError(field, "these tables are not here any more; hand them in again") from None


def summary(state: SeasonState) -> dict[str, Any]:
    """Return what is told of the whole season, and its players."""
    folder = _folder(state)
    found = None if folder is None else kept_summary(folder)
    return {} if found is None else {name: found[name] for name in ("html", "players")}


def maps(state: SeasonState) -> dict[str, Any]:
    """Return of the chosen balls how well they were hit, where on the barrel, and where they would come down."""
    from sweetspot.season import ball_maps
    from sweetspot.season.season_table import counted_in

    folder = _folder(state)
    if folder is None:
        return {}
    chosen = {name: value for name in ("batter", *ball_maps.CHOICES) if (value := getattr(state, name)) is not None}
    counted = ball_maps.chosen_balls(counted_in(folder), chosen)
    return {
        "means": ball_maps.ball_means(counted),
        "ceilings": ball_maps.ceiling_counts(counted),
        "barrel": _map(ball_maps.barrel_counts(counted)),
        "field": _map(ball_maps.field_counts(counted)),
    }


def _map(ball_map: BallMap | None) -> dict[str, Any] | None:
    return None if ball_map is None else {
        "across_m": ball_map.across, "along_m": ball_map.along, "balls": ball_map.counts, "outside": ball_map.outside,
        "near": ball_map.near,
    }  # fmt: skip


def player(state: SeasonState) -> ReadDocument | dict[str, Any]:
    """Return one player's page."""
    from sweetspot.report.season.one_player import player_page

    folder = _folder(state)
    if folder is None or state.batter is None:
        return {}
    with about("batter"):
        return told(player_page(_answer(folder).player(state.batter)))


def contacts(state: SeasonState) -> dict[str, Any]:
    """Return where the chosen player meets the ball and how fast the swing is, as controls of the view Design."""
    from sweetspot.design.contacts import contacts_at
    from sweetspot.season.ball_maps import contact_places

    folder = _folder(state)
    if folder is None or state.batter is None:
        return {}
    with about("batter"):
        contacts = contacts_at(contact_places(folder, state.batter))
    values = {
        "position": contacts.mean,
        "position_spread": max(contacts.spread, LEAST_SPREAD),
        "position_doubt": math.hypot(contacts.mean_doubt, PLACES_DOUBT),
    }
    found = kept_summary(folder)
    players: list[dict[str, Any]] = [] if found is None else found["players"]
    player = next((listed for listed in players if listed["batter"] == state.batter), dict[str, Any]())
    if player.get("bat_speed") is not None:
        values["bat_speed"] = player["bat_speed"]
    return batter_controls(values)


def _folder(state: SeasonState) -> Path | None:
    if state.season is None:
        return None
    with renamed("season"):
        folder = UPLOADS.folder_of(state.season)
    if kept_summary(folder) is None:
        raise FieldError("season", "these tables have not been read to their end; read them again")
    return folder


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


VIEW = View(
    "season", "Season", SeasonState, answer, recipe,
    asides={"summary": summary, "maps": maps, "player": player, "contacts": contacts},
    jobs={"read": LongWork(read_season, begun)},
)  # fmt: skip

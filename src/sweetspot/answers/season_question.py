"""Tables of balls in play that are asked about, and whether they can be worked on."""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from sweetspot.equipment.bat import Bat
from sweetspot.errors import UnusualWarning
from sweetspot.flight.air import Air
from sweetspot.seasons.ball_columns import SeasonSetting
from sweetspot.seasons.batters import require_batter, strangers, tables_of_balls
from sweetspot.seasons.flight_choice import USUAL_FLIGHT, FlightChoice
from sweetspot.seasons.season_table import season_setting
from sweetspot.tables.headings import NOTHING_GIVEN, GivenColumns
from sweetspot.units.dimensions import System


@dataclass(frozen=True, kw_only=True)
class SeasonQuestion:
    """Tables of balls in play that are asked about.

    Parameters
    ----------
    paths : tables, CSV or Parquet.
    bats : of each batter, a name of the catalogue, a file or a bat; "" is all others' bat. None: the catalogue's usual.
    others : bats that every swing is tried with.
    air : of games whose weather the tables do not give; None: the usual.
    flights : ball, law of drag and lift, drag, and the field of balls whose table names none.
    contact : whether contacts are wanted beside flights.
    given : what a person says of columns that are not understood, ``GivenColumns({"exit_speed": "EV:mph"})``.
    system : units of the columns of balls and groups.
    player : number or name of a batter who must be in the tables; None: no particular batter.
    folder : where the answers go, made if need be; None: one that is removed with the last answer that needs it.
    resume : whether answers of the same plan that are in the folder already are kept.
    threads : workers of a task; None: one per core.
    setting : all that hangs on bats and air; None: made of them.
    """

    paths: Sequence[Path | str]
    bats: Mapping[str, str | Bat] | None = None
    others: Sequence[str | Bat] = ()
    air: Air | None = None
    flights: FlightChoice = USUAL_FLIGHT
    contact: bool = True
    given: GivenColumns = NOTHING_GIVEN
    system: System = "us"
    player: str | None = None
    folder: Path | str | None = None
    resume: bool = False
    threads: int | None = None
    setting: SeasonSetting | None = None


def checked_season(question: SeasonQuestion) -> SeasonQuestion:
    """Return a question that can be worked on: without tables that a season wrote itself, with its setting.

    Raises
    ------
    InputError
        for tables that are not there, batters whom no table has, or a bat that is not known.
    """
    folder = None if question.folder is None else Path(question.folder)
    paths, written = tables_of_balls([Path(path) for path in question.paths], out=folder)
    if written:
        _warn(f"left out, as season wrote them itself: {', '.join(path.name for path in written)}")
    if batters := [batter for batter in question.bats or () if batter]:
        for batter in strangers(paths, batters, given=question.given):
            _warn(f"{batter!r} has a bat and is no batter of the tables")
    if question.player is not None:
        require_batter(paths, question.player, given=question.given)
    setting = question.setting or season_setting(
        bats=question.bats,
        others=question.others,
        air=question.air,
        flights=question.flights,
        contact=question.contact,
        system=question.system,
        threads=question.threads,
    )
    return replace(question, paths=tuple(paths), setting=setting)


def _warn(text: str) -> None:
    warnings.warn(text, UnusualWarning, stacklevel=3)

"""The meaning of the columns of a table of batted balls: the required ones, and what depends on the rows."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import polars as pl

from sweetspot.errors import InputError
from sweetspot.tables.headings import (
    NOTHING_GIVEN,
    GivenColumns,
    Headings,
    TableColumn,
    closest,
    names_one_of,
    no_unit,
    read_headings,
    refuse_faults,
)
from sweetspot.tables.vocabulary import quantities_of, simplified

BALLS = quantities_of("balls")
"""Quantities of a table of balls."""
BOARDS = {
    *("avg_hit_speed", "exit_velocity_avg", "swings_competitive", "batted_ball_events", "avg_bat_speed"),
    *("avg_best_speed", "barrels_per_bbe_percent"),
}
"""Headings of the league's leaderboards, which have a row for each player."""
ESSENTIAL = ("exit_speed", "launch_angle", "bat_speed")
"""Without a unit these are refused: whether 98 is a speed in mph or in km/h is not guessed."""
DAY_FIRST = "day first"
"""Unit given to a table's dates where they begin with the day."""


def headings_of(names: Sequence[str], *, given: GivenColumns = NOTHING_GIVEN, file_name: str = "table") -> Headings:
    """Return the meaning of the columns of a table.

    >>> mapped = headings_of(["launch_speed", "launch_angle", "hc_x", "umpire"])
    >>> mapped.system, mapped.columns["exit_speed"].unit, mapped.passed
    ('Statcast', 'mph', ('umpire',))
    """
    found = read_headings(names, wanted=BALLS, given=given, file_name=file_name)
    if "exit_speed" not in given.headings and (board := [name for name in names if simplified(name) in BOARDS]):
        raise InputError(
            f"{file_name}: column {board[0]} is a leaderboard's, with a row for each player; give a row for each ball, "
            "as the search for pitches exports them"
        )
    if "exit_speed" not in found.faults:
        _require_exit_speed(names, found.columns, file_name)
    vague = {name: column for name, column in found.columns.items() if column.has_no_unit}
    essential = no_unit([column for name, column in vague.items() if name in ESSENTIAL])
    refuse_faults(filter(None, (essential, *found.faults.values())), file_name)
    notes = [
        f"{column.heading} has no unit and is left alone; {column.heading_with_unit}, say, would be read"
        for column in vague.values()
    ]
    return replace(
        found,
        columns={name: column for name, column in found.columns.items() if name not in vague},
        passed=tuple(name for name in names if name in {*found.passed, *(column.heading for column in vague.values())}),
        notes=(*found.notes, *notes),
    )


def names_balls(names: Sequence[str]) -> bool:
    """Return whether some words are headings of balls or swings, not what stands above them or beside."""
    return names_one_of(names, ESSENTIAL)


def _require_exit_speed(names: Sequence[str], columns: Mapping[str, TableColumn], file_name: str) -> None:
    """Refuse a table of swings alone, or of anything else than balls."""
    if "exit_speed" in columns:
        return
    if "bat_speed" in columns:
        raise InputError(
            f"{file_name}: swings alone ({columns['bat_speed'].heading}) and no column for exit speed; add what was "
            "measured of the balls, for example as exit_speed_mph and launch_angle_deg"
        )
    raise InputError(
        f"{file_name}: no column for exit speed; launch_speed (Statcast), ExitSpeed (Trackman) or exit_speed_mph would "
        f"do, or --column exit_speed=HEADING:mph. The table has: {closest(names, BALLS)}"
    )


SLASHED = r"^\s*(\d{1,2})[/-](\d{1,2})[/-]\d{2,4}\b"
PEEK = 1000
"""Rows in which a date is looked for that may begin with the day."""


def with_days(headings: Headings, frame: pl.LazyFrame) -> tuple[Headings, list[str]]:
    """Return headings that know whether dates begin with the day, and what to say of dates that do not tell.

    One order holds for a whole table: 25/04/2024 anywhere in it says that 05/04/2024 is in April too.
    """
    column = headings.columns.get("date")
    if column is None or frame.collect_schema()[column.heading] not in (pl.String, pl.Categorical, pl.Enum):
        return headings, []
    text = pl.col(column.heading).cast(pl.String)
    if not frame.head(PEEK).select(text.str.contains(SLASHED).any()).collect().item():
        return headings, []
    numbers = [text.str.extract(SLASHED, group).cast(pl.Int32) for group in (1, 2)]
    ahead, behind = frame.select(text).unique().select(first=numbers[0].max(), second=numbers[1].max()).collect().row(0)
    if ahead > 12 >= behind:
        columns = {**headings.columns, "date": replace(column, unit=DAY_FIRST)}
        return replace(headings, columns=columns), []
    if behind > 12 >= ahead:
        return headings, []
    what = "may begin with month or day" if behind <= 12 else "begin with the month in some rows and the day in others"
    return headings, [f"dates in {column.heading} {what}; they are read as month, day, year"]


SEEN = 20_000
"""Rows in which a player's name is held against the numbers beside it."""


def told_by_rows(headings: Headings, frame: pl.LazyFrame) -> tuple[Headings, list[str]]:
    """Return headings that know what only the rows of a table tell, and what to say of it."""
    return with_days(with_player_name(headings, frame), frame)


def with_player_name(headings: Headings, frame: pl.LazyFrame) -> Headings:
    """Return headings in which ``player_name`` is the batter's where it goes with the batter's number.

    A search for pitchers exports their names, a search for batters theirs, under the same heading. Without pitchers in
    the table the name is the batter's where no batter has two names, and no name two batters.

    >>> from sweetspot.seasons.headings import headings_of
    >>> table = pl.DataFrame({"launch_speed": [90, 91], "player_name": ["A", "A"], "batter": [1, 1], "pitcher": [2, 3]})
    >>> with_player_name(headings_of(table.columns), table.lazy()).has("batter_name")
    True
    """
    if not headings.has("player_name", "batter") or headings.has("batter_name"):
        return headings
    columns = headings.columns
    people = {
        quantity: pl.col(columns[quantity].heading)
        for quantity in ("player_name", "batter", "pitcher")
        if quantity in columns
    }
    name, batter = people["player_name"], people["batter"]
    seen = frame.select(*people.values()).head(SEEN).filter(name.is_not_null() & batter.is_not_null())
    pairs = pl.struct(name, batter).n_unique()
    if "pitcher" in people:
        batters, pitchers = (
            seen.select(pairs, pl.struct(name, people["pitcher"]).n_unique().alias("others")).collect().row(0)
        )
        is_batter = batters < pitchers
    else:
        couples, names, batters, rows = (
            seen.select(pairs, names=name.n_unique(), batters=batter.n_unique(), rows=pl.len()).collect().row(0)
        )
        is_batter = couples == names == batters < rows
    if not is_batter:
        return headings
    others = {quantity: column for quantity, column in columns.items() if quantity != "player_name"}
    return replace(headings, columns=others | {"batter_name": replace(columns["player_name"], quantity="batter_name")})

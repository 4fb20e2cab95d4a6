"""What the columns of a table of batted balls mean: what such a table needs, and what it is not."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

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
    "avg_hit_speed", "exit_velocity_avg", "swings_competitive", "batted_ball_events", "avg_bat_speed",
    "avg_best_speed", "barrels_per_bbe_percent",
}  # fmt: skip
"""Headings of the league's leaderboards, which have a row for each player."""
ESSENTIAL = ("exit_speed", "launch_angle", "bat_speed")
"""Without a unit these are refused; nobody must guess whether 98 is a speed in mph or in km/h."""
DAY_FIRST = "day first"
"""What stands for the unit of a table's dates where they begin with the day."""


def headings_of(names: Sequence[str], *, given: GivenColumns = NOTHING_GIVEN, file_name: str = "table") -> Headings:
    """Return what the columns of a table mean.

    Parameters
    ----------
    names : headings as the table writes them.
    given : what a person says of the columns.
    file_name : for messages.

    Raises
    ------
    InputError
        when there is no exit speed, a measurement has no unit or an unknown one, or ``given`` names no column.

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
        passed=tuple(name for name in names if name in found.passed or name in {one.heading for one in vague.values()}),
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

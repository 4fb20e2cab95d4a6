"""What the rows of a table tell of its columns: how its dates are written, and whose name ``player_name`` is."""

from __future__ import annotations

from dataclasses import replace

import polars as pl

from sweetspot.season.day_order import with_days
from sweetspot.tables.headings import Headings

SEEN = 20_000
"""Rows in which a player's name is held against the numbers beside it."""


def told_by_rows(headings: Headings, frame: pl.LazyFrame) -> tuple[Headings, list[str]]:
    """Return headings that know what only the rows of a table tell, and what to say of it."""
    return with_days(with_player_name(headings, frame), frame)


def with_player_name(headings: Headings, frame: pl.LazyFrame) -> Headings:
    """Return headings in which ``player_name`` is the batter's where it goes with the batter's number.

    A search for pitchers exports their names, a search for batters theirs, under the same heading.

    >>> from sweetspot.season.headings import headings_of
    >>> table = pl.DataFrame({"launch_speed": [90, 91], "player_name": ["A", "A"], "batter": [1, 1], "pitcher": [2, 3]})
    >>> with_player_name(headings_of(table.columns), table.lazy()).has("batter_name")
    True
    """
    if not headings.has("player_name", "batter", "pitcher") or headings.has("batter_name"):
        return headings
    columns = headings.columns
    name, batter, pitcher = (pl.col(columns[one].heading) for one in ("player_name", "batter", "pitcher"))
    seen = frame.select(name, batter, pitcher).head(SEEN).filter(name.is_not_null())
    batters, pitchers = seen.select(pl.struct(name, batter).n_unique().alias("batters"),
                                    pl.struct(name, pitcher).n_unique().alias("pitchers")).collect().row(0)  # fmt: skip
    if batters >= pitchers:
        return headings
    others = {quantity: column for quantity, column in columns.items() if quantity != "player_name"}
    return replace(headings, columns=others | {"batter_name": replace(columns["player_name"], quantity="batter_name")})

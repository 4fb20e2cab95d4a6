"""Rows of a table in our own terms: every quantity in SI, missing where it is missing, and why a row is not used.

A row is used when a ball was put in play, not by a bunt, and its exit speed is known and possible. All others stay in
the ledger under the first reason that holds.
"""

from __future__ import annotations

from collections.abc import Iterator

import polars as pl

from sweetspot.season.headings import UNITS, Headings, TableColumn
from sweetspot.units import MPH

USED = "used"
REASONS = {
    "duplicate": "the same pitch a second time",
    "no contact": "a ball, a called strike or a miss; also a foul tip",
    "foul": "fouled off: public tables hold no exit speed of fouls",
    "bunt": "bunted",
    "untracked": "put in play, and no exit speed was measured",
    "impossible": "an exit speed or launch angle that cannot be",
    USED: "balls in play with an exit speed",
}
"""Why a row is where it is in the ledger, in the order in which they are asked."""
SLOWEST, FASTEST = 1 * MPH, 125 * MPH
"""m/s of balls that were put in play."""
DATES = ("%Y-%m-%d", "%m/%d/%Y", "%m/%d/%y", "%Y/%m/%d", "%d.%m.%Y", "%b %d, %Y")
IN_PLAY = "in ?play|hit_into_play"
FOUL, TIP = "foul", "foul.?tip"
NUMBERS = [kind for kind in UNITS if kind != "text"]
KEYS = (("pitch_id",), ("game", "at_bat", "pitch"))
"""What tells pitches apart, the first that a table has."""
MEASURED = ("exit_speed", "launch_angle", "map_x", "map_y", "release_speed", "velocity_x", "velocity_z", "plate_side")
ENOUGH = 4
"""Measurements that must agree before two rows without a number are the same pitch."""


def rows_of(frame: pl.DataFrame, headings: Headings, *, first: int = 0) -> pl.DataFrame:
    """Return rows with a column per quantity that the table has, in SI, ``row`` in front and ``reason`` behind.

    Parameters
    ----------
    frame : rows of the table as they are.
    first : number of the first of them in the table, from 0.

    Returns
    -------
    DataFrame
        also ``left`` (batter's side), ``day``, ``season`` and ``unreadable`` (how many measurements of the row were
        written so that no number could be read).
    """
    columns = headings.columns
    selected = frame.select(
        *(_number(frame, column).alias(name) for name, column in columns.items() if column.kind != "text"),
        *(_text(column).alias(name) for name, column in columns.items() if column.kind == "text"),
        *(
            _lost(frame, column).alias(f"lost {name}")
            for name, column in columns.items()
            if column.kind != "text" and not frame.schema[column.heading].is_numeric()
        ),
    ).with_row_index("row", offset=first)
    lost = [name for name in selected.columns if name.startswith("lost ")]
    return selected.with_columns(
        left=_left(headings), day=_day(headings),
        unreadable=pl.sum_horizontal(lost) if lost else pl.lit(0, pl.Int32),
    ).with_columns(season=_season(headings)).drop(lost).with_columns(reason=_reason(headings))  # fmt: skip


def _number(frame: pl.DataFrame, column: TableColumn) -> pl.Expr:
    value = _as_float(frame, column)
    return pl.when(value.is_finite()).then(column.zero + column.factor * value)


def _as_float(frame: pl.DataFrame, column: TableColumn) -> pl.Expr:
    held = pl.col(column.heading)
    if frame.schema[column.heading].is_numeric():
        return held.cast(pl.Float64)
    text = held.cast(pl.String).str.strip_chars().str.replace(r"^(-?\d+),(\d+)$", "$1.$2")
    return text.cast(pl.Float64, strict=False)


def _lost(frame: pl.DataFrame, column: TableColumn) -> pl.Expr:
    text = pl.col(column.heading).cast(pl.String).str.strip_chars()
    written = text.is_not_null() & (text != "")
    return (written & _as_float(frame, column).is_null()).cast(pl.Int32)


def _text(column: TableColumn) -> pl.Expr:
    text = pl.col(column.heading).cast(pl.String).str.strip_chars().str.replace(r"^(\d+)\.0$", "$1")
    return pl.when(text != "").then(text)


def _left(headings: Headings) -> pl.Expr:
    if headings.has("bats"):
        return pl.col("bats").str.to_lowercase().str.starts_with("l")
    if headings.has("bats_left"):
        return pl.col("bats_left").str.to_lowercase().is_in(["1", "true", "l", "left", "yes"])
    return pl.lit(None, pl.Boolean)


def _day(headings: Headings) -> pl.Expr:
    if not headings.has("date"):
        return pl.lit(None, pl.Date)
    text = pl.col("date").str.split(" ").list.first().str.split("T").list.first()
    return pl.coalesce(*(text.str.to_date(form, strict=False) for form in DATES[:-1]),
                       pl.col("date").str.to_date(DATES[-1], strict=False))  # fmt: skip


def _season(headings: Headings) -> pl.Expr:
    day = pl.col("day").dt.year()
    if headings.has("year"):
        return pl.coalesce(pl.col("year").cast(pl.Float64, strict=False).cast(pl.Int32, strict=False), day)
    return day


def _reason(headings: Headings) -> pl.Expr:
    """Return the first reason that holds for a row; duplicates are found across files, elsewhere."""
    conditions = list(_conditions(headings))
    chain: pl.Expr = pl.lit(USED)
    for word, condition in reversed(conditions):
        chain = pl.when(condition).then(pl.lit(word)).otherwise(chain)
    return chain


def _conditions(headings: Headings) -> Iterator[tuple[str, pl.Expr]]:
    if headings.has("description"):
        what = pl.col("description").str.to_lowercase().fill_null("")
        played = what.str.contains(IN_PLAY) | (what == "")
        if headings.has("result_type"):
            played = played | (pl.col("result_type").str.to_uppercase() == "X").fill_null(value=False)
        yield "foul", ~played & what.str.contains(FOUL) & ~what.str.contains(TIP)
        yield "no contact", ~played
    elif headings.has("result_type"):
        yield "no contact", (pl.col("result_type").str.to_uppercase() != "X").fill_null(value=False)
    bunted = pl.lit(value=False)
    for name in ("event", "words", "batted_type", "description"):
        if headings.has(name):
            bunted = bunted | pl.col(name).str.to_lowercase().str.contains("bunt").fill_null(value=False)
    yield "bunt", bunted
    yield "untracked", pl.col("exit_speed").is_null()
    steep = (pl.col("launch_angle").abs() > 1.5708).fill_null(value=False) if headings.has("launch_angle") else False
    yield "impossible", ~pl.col("exit_speed").is_between(SLOWEST, FASTEST) | steep


def pitch_key(headings: Headings) -> pl.Expr | None:
    """Return a 64-bit key that is the same for the same pitch in any table; None where a table cannot tell.

    Where pitches are not numbered, rows are the same pitch that agree in everything that is measured.

    Parameters
    ----------
    headings : of a table whose rows went through `rows_of`.
    """
    found: list[pl.Expr] = []
    for names in KEYS:
        if headings.has(*names):
            known = pl.all_horizontal(pl.col(name).is_not_null() for name in names)
            found.append(pl.when(known).then(pl.concat_str(names, separator="|").hash(seed=1)))
    measured = [name for name in MEASURED if headings.has(name)]
    if headings.has("batter") and (headings.has("game") or headings.has("date")) and len(measured) >= ENOUGH:
        who = [name for name in ("game", "date", "batter", "pitcher") if headings.has(name)]
        parts = [*(pl.col(name).fill_null("") for name in who), *(pl.col(name).cast(pl.String).fill_null("")
                 for name in measured)]  # fmt: skip
        found.append(pl.concat_str(parts, separator="|").hash(seed=1))
    return pl.coalesce(found) if found else None

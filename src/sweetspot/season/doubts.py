"""Columns that seem to be in another unit than their heading says, or in each other's place, by what is usual of many.

Bounds are wide enough for the balls of children and of the major league, and narrow enough that no such table is still
inside when it is read in another unit.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import NamedTuple

import polars as pl

from sweetspot.tables.headings import TableColumn
from sweetspot.tables.unit_words import FAHRENHEIT_ZERO, UNITS
from sweetspot.units import DEGREE, FOOT, MPH

ENOUGH = 30
"""Balls of a part of a table from which columns are doubted."""


class UsualQuantile(NamedTuple):
    """What is usual of a column: bounds of one of its quantiles in a unit, its words, its size in SI and its zero."""

    quantile: float
    low: float
    high: float
    unit: str
    size: float
    zero: float = 0.0


USUAL: Mapping[str, UsualQuantile] = {
    "exit_speed": UsualQuantile(0.5, 42, 115, "mph", MPH),
    "bat_speed": UsualQuantile(0.5, 40, 95, "mph", MPH),
    "release_speed": UsualQuantile(0.5, 42, 105, "mph", MPH),
    "plate_speed": UsualQuantile(0.5, 40, 100, "mph", MPH),
    "plate_height": UsualQuantile(0.5, 1.0, 5.0, "ft", FOOT),
    "distance": UsualQuantile(0.99, 150, 550, "ft", FOOT),
    "temperature": UsualQuantile(0.5, 36, 108, "°F", 5 / 9, FAHRENHEIT_ZERO),
    "pressure": UsualQuantile(0.5, 990, 1040, "hPa", 100.0),
    "humidity": UsualQuantile(0.5, 5, 100, "%", 0.01),
}
ANGLES = ("launch_angle", "attack_angle", "tilt", "attack_direction", "attack_to_right", "launch_direction", "bearing")
DOUBTFUL = (*USUAL, *ANGLES, "map_x", "map_y")
"""Quantities whose columns are doubted."""
LEVEL = 1.6 * DEGREE
"""rad; where 99 of 100 are less, a column of degrees is written in radians."""
HIGH, NEGATIVE, IMPOSSIBLE = 45 * DEGREE, 0.05, 0.2
"""rad of the median launch angle, the part of exit speeds below 0, above which the two stand in each other's place; and
the part of both that cannot be from which their unit is doubted."""


def unusual(some: pl.DataFrame, columns: Mapping[str, TableColumn]) -> Iterator[tuple[str, str]]:
    """Yield each quantity whose numbers are usual in another unit, and what is the matter with it.

    Parameters
    ----------
    some : balls in play, those that cannot be among them, in SI.
    columns : of the table.
    """
    for name, usual in USUAL.items():
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) < ENOUGH:
            continue
        value = float(held.cast(pl.Float64).quantile(usual.quantile))  # type: ignore[arg-type]
        told = (value - usual.zero) / usual.size
        if not usual.low <= told <= usual.high:
            middle = "in the median" if usual.quantile == 0.5 else "for the longest in a hundred"
            yield (
                name,
                (
                    f"{columns[name].heading} is {told:.3g} {usual.unit} {middle}; usual is {usual.low:g} to "
                    f"{usual.high:g} {usual.unit}{_as_if_in(columns[name], value, usual)}"
                ),
            )
    for name in ANGLES:
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) >= ENOUGH and 0 < float(held.abs().quantile(0.99)) < LEVEL:  # type: ignore[arg-type]
            yield name, f"no {columns[name].heading} is above 1.6 degrees: are they radians?"


def _as_if_in(column: TableColumn, value: float, usual: UsualQuantile) -> str:
    """Return in which unit the same numbers would be usual, in words."""
    if column.kind == "pressure":
        return ": is it reduced to sea level, as weather reports give it?"
    written = (value - column.zero) / column.factor
    for unit, factor in UNITS[column.kind].items():
        zero = FAHRENHEIT_ZERO if column.kind == "temperature" and factor != 1 else 0.0
        if usual.low <= (zero + factor * written - usual.zero) / usual.size <= usual.high:
            return f": are they {unit}?"
    return ""


def exchanged(some: pl.DataFrame) -> str:
    """Return which two columns seem to stand in each other's place; "": none.

    Parameters
    ----------
    some : balls in play, those that cannot be among them, in SI.
    """
    if {"exit_speed", "launch_angle"} <= set(some.columns) and len(some) >= ENOUGH:
        slow = (some["exit_speed"] < 0).mean() or 0.0
        if float(slow) > NEGATIVE and float(some["launch_angle"].median() or 0.0) > HIGH:  # type: ignore[arg-type]
            return "speeds below 0 and launch angles near straight up: exit speed and launch angle"
    if {"exit_speed", "bat_speed"} <= set(some.columns):
        ball, bat = (float(some[name].median() or 0.0) for name in ("exit_speed", "bat_speed"))  # type: ignore[arg-type]
        if bat > ball > 0:
            return "bats faster than the balls they hit: bat speed and exit speed"
    return ""

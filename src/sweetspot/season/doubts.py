"""Columns that seem to be in another unit than their heading says, or in each other's place, by what is usual of many.

Bounds are wide enough for the balls of children and of the major league, and narrow enough that no such table is still
inside when it is read in another unit.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import polars as pl

from sweetspot.plausibility import PlausibleRange, bounds
from sweetspot.tables.headings import TableColumn
from sweetspot.tables.unit_words import FAHRENHEIT_ZERO, UNITS
from sweetspot.units import DEGREE

ENOUGH = 30
"""Balls of a part of a table from which columns are doubted."""


DOUBTED: Mapping[str, tuple[float, str]] = {
    **{
        name: (0.5, f"median_{name}")
        for name in (
            *("exit_speed", "bat_speed", "release_speed", "plate_speed", "plate_height"),
            *("temperature", "pressure", "humidity"),
        )
    },
    "distance": (0.99, "longest_distance"),
}
"""The quantile of a column that is looked at, and its name in the table of bounds."""
ANGLES = ("launch_angle", "attack_angle", "tilt", "attack_direction", "attack_to_right", "launch_direction", "bearing")
DOUBTFUL = (*DOUBTED, *ANGLES, "map_x", "map_y")
"""Quantities whose columns are doubted."""
LEVEL = 1.6 * DEGREE
"""rad; where 99 of 100 are less, a column of degrees is written in radians."""
FASTER = 1.2
"""How many times as fast as bats balls are at least, in the median: some 88 of 70 mph in the major league."""
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
    for name, (quantile, quantity) in DOUBTED.items():
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) < ENOUGH:
            continue
        value, usual = float(held.cast(pl.Float64).quantile(quantile)), bounds(quantity)  # type: ignore[arg-type]
        if usual.verdict(value) != "fine":
            middle = "in the median" if quantile == 0.5 else "for the longest in a hundred"
            yield (
                name,
                (
                    f"{columns[name].heading} is {usual.in_unit(value):.3g} {usual.sign} {middle}; usual is "
                    f"{usual.low:g} to {usual.high:g} {usual.sign}{_as_if_in(columns[name], value, usual)}"
                ),
            )
    for name in ANGLES:
        held = some[name].drop_nulls() if name in some.columns else pl.Series()
        if len(held) >= ENOUGH and 0 < float(held.abs().quantile(0.99)) < LEVEL:  # type: ignore[arg-type]
            yield name, f"no {columns[name].heading} is above 1.6 degrees: are they radians?"


def _as_if_in(column: TableColumn, value: float, usual: PlausibleRange) -> str:
    """Return in which unit the same numbers would be usual, in words."""
    if column.kind == "pressure":
        return ": is it reduced to sea level, as weather reports give it?"
    for unit, _ in _usual_readings(column, value, usual):
        return f": are they {unit}?"
    return ""


def _usual_readings(column: TableColumn, value: float, usual: PlausibleRange) -> Iterator[tuple[str, float]]:
    """Yield each unit in which the same numbers would be usual, and what they would be, SI."""
    written = (value - column.zero) / column.factor
    for unit, factor in UNITS[column.kind].items():
        zero = FAHRENHEIT_ZERO if column.kind == "temperature" and factor != 1 else 0.0
        if usual.verdict(zero + factor * written) == "fine":
            yield unit, zero + factor * written


def _usual_speed(name: str, value: float, columns: Mapping[str, TableColumn]) -> float:
    """Return a median speed as it is if it is usual, or in the unit in which it would be."""
    usual = bounds(f"median_{name}")
    if usual.verdict(value) == "fine":
        return value
    return next((speed for _, speed in _usual_readings(columns[name], value, usual)), value)


def exchanged(some: pl.DataFrame, columns: Mapping[str, TableColumn]) -> str:
    """Return which two columns seem to stand in each other's place; "": none.

    Bats faster than balls may also be in another unit: then balls are as much faster in it as balls in play are.

    Parameters
    ----------
    some : balls in play, those that cannot be among them, in SI.
    columns : of the table.
    """
    if {"exit_speed", "launch_angle"} <= set(some.columns) and len(some) >= ENOUGH:
        slow = (some["exit_speed"] < 0).mean() or 0.0
        if float(slow) > NEGATIVE and float(some["launch_angle"].median() or 0.0) > HIGH:  # type: ignore[arg-type]
            return "speeds below 0 and launch angles near straight up: exit speed and launch angle"
    if {"exit_speed", "bat_speed"} <= set(some.columns):
        ball, bat = (float(some[name].median() or 0.0) for name in ("exit_speed", "bat_speed"))  # type: ignore[arg-type]
        if bat > ball > 0 and _usual_speed("exit_speed", ball, columns) < FASTER * _usual_speed(
            "bat_speed", bat, columns
        ):
            return "bats faster than the balls they hit: bat speed and exit speed"
    return ""

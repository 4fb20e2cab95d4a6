"""A table of flights as JSON, as rows and for a terminal."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from rich.console import Group
from rich.table import Table
from rich.text import Text

from sweetspot.flight.what_if import FlightTable, Varied, cells_of
from sweetspot.report.border import cleaned
from sweetspot.units import DEGREE, FOOT, MPH, RPM

Array = NDArray[np.float64]

INCH_OF_MERCURY = 3386.389
"""Pa."""
UNITS: dict[str, tuple[str, str, float, float]] = {
    "exit_speed": ("m_s", "mph", MPH, 0.0), "launch_angle": ("rad", "deg", DEGREE, 0.0),
    "spray": ("rad", "deg", DEGREE, 0.0), "backspin": ("rad_s", "rpm", RPM, 0.0),
    "sidespin": ("rad_s", "rpm", RPM, 0.0), "gyrospin": ("rad_s", "rpm", RPM, 0.0),
    "height": ("m", "ft", FOOT, 0.0), "temperature": ("degc", "degF", 1 / 1.8, 32.0),
    "humidity": ("", "%", 0.01, 0.0), "pressure": ("pa", "inHg", INCH_OF_MERCURY, 0.0),
    "elevation": ("m", "ft", FOOT, 0.0), "wind_speed": ("m_s", "mph", MPH, 0.0),
    "wind_direction": ("rad", "deg", DEGREE, 0.0), "carry": ("m", "ft", FOOT, 0.0),
    "hang_time": ("s", "s", 1.0, 0.0), "apex": ("m", "ft", FOOT, 0.0), "landing_angle": ("rad", "deg", DEGREE, 0.0),
    "landing_speed": ("m_s", "mph", MPH, 0.0),
}  # fmt: skip
"""Ending in JSON; and of the table: unit, its size in SI, and what to add."""
DIGITS = {"hang_time": 2}


def key(name: str) -> str:
    """Return a name with its unit, as JSON and CSV have it: ``carry_m``."""
    return f"{name}_{UNITS[name][0]}".removesuffix("_")


def answers(table: FlightTable) -> dict[str, Array]:
    """Return what every cell answers, row after row, SI; nan where a ball did not land."""
    flown = table.flights
    return {
        "carry": flown.carry,
        "hang_time": flown.hang_time,
        "apex": flown.apex_height,
        "landing_angle": flown.landing_angle,
        "landing_speed": np.linalg.norm(flown.landing_velocity, axis=1),
    }


def fly_table_json(table: FlightTable) -> dict[str, Any]:
    """Return both sides and every answer as a list of rows."""
    return cleaned(
        {
            "rows": {key(table.rows[0]): list(table.rows[1])},
            "columns": {} if table.columns is None else {key(table.columns[0]): list(table.columns[1])},
            "answers": {key(name): table.values(values) for name, values in answers(table).items()},
        }
    )


def fly_table_rows(table: FlightTable) -> list[dict[str, Any]]:
    """Return one row per cell."""
    found = answers(table)
    return [
        cleaned({key(name): value for name, value in cell} | {key(name): found[name][place] for name in found})
        for place, cell in enumerate(cells_of(table.rows, table.columns))
    ]


def shown_fly_table(table: FlightTable, answer: str) -> Group:
    """Return one answer as a table for a terminal.

    Parameters
    ----------
    answer : a name of `answers`.
    """
    shown = Table(header_style="bold", box=None, pad_edge=False)
    shown.add_column("")
    for value in (None,) if table.columns is None else table.columns[1]:
        shown.add_column(
            "" if value is None or table.columns is None else _value(table.columns[0], value), justify="right"
        )
    for first, row in zip(table.rows[1], table.values(answers(table)[answer]), strict=True):
        cells = ("-" if np.isnan(value) else _value(answer, value, exact=True) for value in row)
        shown.add_row(Text(_value(table.rows[0], first), style="bold"), *cells)
    across = "" if table.columns is None else f", {_named(table.columns)} across"
    return Group(Text(f"{_words(answer)}: {_named(table.rows)} down{across}", style="bold"), shown)


def _named(side: Varied) -> str:
    return _words(side[0])


def _words(name: str) -> str:
    return f"{name.replace('_', ' ')} in {UNITS[name][1]}"


def _value(name: str, value: float, *, exact: bool = False) -> str:
    _, _, size, zero = UNITS[name]
    number = value / size + zero
    return f"{number:.{DIGITS.get(name, 0)}f}" if exact else f"{round(number, 6):.5g}"

"""A table of flights as a document."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.flight.sweep import FlightTable, cells_of
from sweetspot.numerics.arrays import Array
from sweetspot.report.document import Cell, Column, Document, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import SCALES
from sweetspot.report.sentences import Sentence, Slot, UnitName, say

VARIED: dict[str, str] = {
    "exit_speed": "speed", "launch_angle": "angle", "spray": "angle", "bearing": "angle", "backspin": "spin",
    "sidespin": "spin", "gyrospin": "spin", "height": "distance", "temperature": "temperature", "humidity": "ratio",
    "pressure": "pressure", "elevation": "distance", "wind_speed": "speed", "wind_direction": "angle",
    "carry": "distance", "hang_time": "time", "apex": "distance", "landing_angle": "angle", "landing_speed": "speed",
}  # fmt: skip
"""Scale of everything that a table of flights varies or answers."""
EXACT = {"ratio": 2, "pressure": 2, "angle": 1, "speed": 1}
"""Digits of what is varied, by scale."""
DIGITS = {"hang_time": 2, "landing_angle": 0, "landing_speed": 0}


def key(name: str) -> str:
    """Return a name with its unit, as JSON and CSV have it: ``carry_m``."""
    return f"{name}{SCALES[VARIED[name]].ending}"


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


def sweep_document(table: FlightTable, answer: str) -> Document:
    """Return a table of flights as a document.

    Parameters
    ----------
    answer : what its cells show, a name of `answers`.
    """
    name, down = table.rows
    across = (None,) if table.columns is None else table.columns[1]
    scale, digits = VARIED[answer], DIGITS.get(answer)
    heads = [Column("", right=True)]
    for value in across:
        top = () if value is None or table.columns is None else (_side(table.columns[0], value),)
        heads.append(Column(Sentence(top), right=True))
    rows: list[list[Cell]] = [
        [_side(name, first), *(Slot(float(value), scale, digits).bare for value in row)]
        for first, row in zip(down, table.values(answers(table)[answer]), strict=True)
    ]
    title = say("{answer}: {down} down", answer=_named(answer), down=_named(name))
    if table.columns is not None:
        title += say(", {across} across", across=_named(table.columns[0]))
    return Document(
        name="fly", title="", kind="Table of flights", blocks=[Table(title, heads, rows)], data=_json(table),
        rows=_rows(table),
    )  # fmt: skip


def _json(table: FlightTable) -> dict[str, Any]:
    return cleaned(
        {
            "rows": {key(table.rows[0]): list(table.rows[1])},
            "columns": {} if table.columns is None else {key(table.columns[0]): list(table.columns[1])},
            "answers": {key(name): table.values(values) for name, values in answers(table).items()},
        }
    )


def _rows(table: FlightTable) -> dict[str, list[Any]]:
    """Return one row per cell, as columns."""
    cells = cells_of(table.rows, table.columns)
    sides = {key(name): [dict(cell)[name] for cell in cells] for name, _ in cells[0]}
    return cleaned(sides | {key(name): values for name, values in answers(table).items()})


def _named(name: str) -> Sentence:
    return say("{name} in {unit}", name=name.replace("_", " "), unit=UnitName(VARIED[name]))


def _side(name: str, value: float) -> Slot:
    return Slot(value, VARIED[name], EXACT.get(VARIED[name], 0)).bare

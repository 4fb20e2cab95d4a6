"""A table of flights as a document."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.flight.sweep import FlightTable, cells_of
from sweetspot.numerics.arrays import Array
from sweetspot.report.document import Document
from sweetspot.report.grid.document import grid_document
from sweetspot.report.grid.values import Grid
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import key


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
    values = np.array([list(row) for row in table.values(answers(table)[answer])], dtype=float)
    grid = Grid(answer, table.rows, table.columns, values)
    return grid_document(grid, name="fly", kind="Table of flights", data=_json(table), rows=_rows(table))


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

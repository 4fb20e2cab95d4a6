"""Tables of what one or two changes do: to a bat, or to the flight of a hit ball. Every cell has all answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import chain, product
from typing import TYPE_CHECKING, Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from sweetspot import catalog
from sweetspot.analysis.what_if import Axis, what_if_table
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import GAPS, GRID, INTERNAL
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError, missing_extras_named
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.sweep import BattedBall, Varied, flight_table
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.units.dimensions import (
    ANGLE,
    DISTANCE,
    FREQUENCY,
    LENGTH,
    MASS,
    MOI,
    PRESSURE,
    SPEED,
    SPIN,
    TEMPERATURE,
    TIME,
    System,
)

if TYPE_CHECKING:
    import polars

BatCell = Literal[
    "exit_speed", "collision_efficiency", "bbcor", "bat_speed", "mass", "balance_point", "moi", "frequency"
]
BAT_CELLS: tuple[BatCell, ...] = get_args(BatCell)
FlightCell = Literal["carry", "hang_time", "apex", "landing_angle", "landing_speed"]


def cells_as_columns(table: Mapping[str, Any]) -> dict[str, list[object]]:
    """Return the cells of a table, row after row, as columns: what is varied, then every answer.

    >>> cells_as_columns({"rows": {"mass_kg": [0.8, 0.9]}, "columns": None, "answers": {"bbcor": [[0.4], [0.5]]}})
    {'mass_kg': [0.8, 0.9], 'bbcor': [0.4, 0.5]}
    """
    sides = list((table["rows"] | (table["columns"] or {})).items())
    cells = list(product(*(values for _, values in sides)))
    columns = {name: list(values) for (name, _), values in zip(sides, zip(*cells, strict=True), strict=True)}
    answers = {name: list(chain.from_iterable(rows)) for name, rows in table["answers"].items()}
    return {**columns, **{name: values for name, values in answers.items() if name not in columns}}


class TableAnswer(Answer):
    """A table of what one or two numbers change."""

    def to_frame(self, units: System = "si") -> polars.DataFrame:
        """Return the cells as a frame, row after row: what is varied, then every answer."""
        with missing_extras_named():
            import polars

        return polars.DataFrame(cells_as_columns(self.to_dict(units)))


@dataclass(frozen=True, kw_only=True)
class Side:
    """What is varied along one side of a table: of its fields one has values, shape (n,)."""

    @property
    def varied(self) -> tuple[str, Array] | None:
        """Name of what is varied, and its values; None: nothing is."""
        return next(((name, values) for name, values in vars(self).items() if values is not None), None)


def two_sides(vary: Mapping[str, ArrayLike]) -> tuple[tuple[Any, tuple[float, ...]], ...]:
    """Split the values that are varied into the rows of a table and, where there are two, its columns."""
    if len(vary) not in (1, 2):
        raise InputError(f"vary was given {len(vary)} things; a table has rows and columns, so name one or two")
    return tuple((name, tuple(np.atleast_1d(np.asarray(values, float)).tolist())) for name, values in vary.items())


@dataclass(frozen=True, kw_only=True)
class VariedBat(Side):
    """One thing varied of a bat and its swing; see `sweetspot.analysis.what_if.varied`."""

    mass: Annotated[Array | None, MASS] = None
    bore_diameter: Annotated[Array | None, LENGTH] = None
    bore_depth: Annotated[Array | None, LENGTH] = None
    cup_depth: Annotated[Array | None, LENGTH] = None
    wall_factor: Array | None = None
    bat_speed: Annotated[Array | None, SPEED] = None
    pitch_speed: Annotated[Array | None, SPEED] = None


@dataclass(frozen=True)
class BatCells:
    """Answers of every cell, shape (rows, columns); see `TableCell`. They are nan where no such bat can be."""

    exit_speed: Annotated[Array, SPEED, GRID, GAPS]
    collision_efficiency: Annotated[Array, GRID, GAPS]
    bbcor: Annotated[Array, GRID, GAPS]
    bat_speed: Annotated[Array, SPEED, GRID, GAPS]
    mass: Annotated[Array, MASS, GRID, GAPS]
    balance_point: Annotated[Array, LENGTH, GRID, GAPS]
    moi: Annotated[Array, MOI, GRID, GAPS]
    frequency: Annotated[Array, FREQUENCY, GRID, GAPS]


@dataclass(frozen=True)
class FailedCell:
    """A cell without answers, and why."""

    row: int
    column: int
    reason: str


@dataclass(frozen=True, kw_only=True)
class WhatIfQuestion:
    """A bat of which one or two things are varied.

    ``conditions``: of the bat as it is. ``law``: as which every other bat is swung; None: at the same speed. ``cell``:
    the answer that a printed table shows.
    """

    bat: Bat
    rows: Axis
    columns: Axis | None = None
    conditions: Conditions
    law: SwingLaw | None
    cell: BatCell = "exit_speed"


@dataclass(frozen=True, kw_only=True)
class WhatIfAnswer(TableAnswer):
    """What one or two changes of a bat do to its best hit and to its own numbers."""

    rows: VariedBat
    columns: VariedBat | None
    answers: BatCells
    failures: tuple[FailedCell, ...]
    question: Annotated[WhatIfQuestion, INTERNAL]


def what_if_answer(question: WhatIfQuestion, *, progress: Callable[[int, int], None] | None = None) -> WhatIfAnswer:
    """Return the answers of every cell; ``progress`` is called with the cells done and in all."""
    rows, columns = question.rows, question.columns
    table = what_if_table(
        question.bat,
        rows=rows,
        columns=columns,
        conditions=question.conditions,
        law=question.law,
        fill=catalog.material("cork"),
        progress=progress,
    )
    return WhatIfAnswer(
        rows=VariedBat(**{rows.variation: np.array(rows.values)}),
        columns=None if columns is None else VariedBat(**{columns.variation: np.array(columns.values)}),
        answers=BatCells(*map(table.values, BAT_CELLS)),
        failures=tuple(FailedCell(cell.row, cell.column, cell.reason) for cell in table.failures),
        question=question,
    )


@dataclass(frozen=True, kw_only=True)
class VariedFlight(Side):
    """One thing varied of a hit and its air; see `BattedBall`."""

    exit_speed: Annotated[Array | None, SPEED] = None
    launch_angle: Annotated[Array | None, ANGLE] = None
    spray: Annotated[Array | None, ANGLE] = None
    bearing: Annotated[Array | None, ANGLE] = None
    backspin: Annotated[Array | None, SPIN] = None
    sidespin: Annotated[Array | None, SPIN] = None
    gyrospin: Annotated[Array | None, SPIN] = None
    height: Annotated[Array | None, DISTANCE] = None
    temperature: Annotated[Array | None, TEMPERATURE] = None
    humidity: Array | None = None
    pressure: Annotated[Array | None, PRESSURE] = None
    elevation: Annotated[Array | None, DISTANCE] = None
    wind_speed: Annotated[Array | None, SPEED] = None
    wind_direction: Annotated[Array | None, ANGLE] = None


@dataclass(frozen=True)
class FlightCells:
    """Answers of every cell, shape (rows, columns); nan where a ball did not land."""

    carry: Annotated[Array, DISTANCE, GRID, GAPS]
    hang_time: Annotated[Array, TIME, GRID, GAPS]
    apex: Annotated[Array, DISTANCE, GRID, GAPS]
    landing_angle: Annotated[Array, ANGLE, GRID, GAPS]
    landing_speed: Annotated[Array, SPEED, GRID, GAPS]


@dataclass(frozen=True, kw_only=True)
class FlyTableQuestion:
    """A hit of which one or two numbers are varied; ``cell`` is the answer that a printed table shows."""

    hit: BattedBall
    rows: Varied
    columns: Varied | None = None
    ball: Ball
    aerodynamics: Aerodynamics
    cell: FlightCell = "carry"


@dataclass(frozen=True, kw_only=True)
class FlyTableAnswer(TableAnswer):
    """How a hit ball flies as one or two of its numbers are varied; without ``columns`` it has one column."""

    rows: VariedFlight
    columns: VariedFlight
    answers: FlightCells
    question: Annotated[FlyTableQuestion, INTERNAL]


def fly_table_answer(question: FlyTableQuestion) -> FlyTableAnswer:
    """Return the flights of every cell.

    Raises
    ------
    InputError
        for a start below the ground, or numbers that no hit or air can have, in any cell.
    """
    table = flight_table(
        question.hit,
        rows=question.rows,
        columns=question.columns,
        ball=question.ball,
        aerodynamics=question.aerodynamics,
    )
    sides = table.rows, table.columns
    rows, *columns = (VariedFlight(**{name: np.array(values)}) for name, values in filter(None, sides))
    flown = table.flights
    found = (
        flown.carry,
        flown.hang_time,
        flown.apex_height,
        flown.landing_angle,
        np.linalg.norm(flown.landing_velocity, axis=1),
    )
    return FlyTableAnswer(
        rows=rows,
        columns=columns[0] if columns else VariedFlight(),
        answers=FlightCells(*map(table.values, found)),
        question=question,
    )

"""Cells of a table: numbers in their column's unit, or in the unit that stands behind them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from sweetspot.plausibility import parse_position
from sweetspot.tables.headings import Headings, TableColumn, no_unit, refuse_faults
from sweetspot.tables.vocabulary import UNITS, simplified, zero_of


@dataclass(frozen=True)
class BadRow:
    """A row that cannot be used, and why."""

    row: int
    reason: str


NUMBER_AND_UNIT = re.compile(r"([-+]?(?:\d+\.?\d*|\.\d+))\s*([^\d\s.,+-].*)")
HAS_UNIT = re.compile("[A-Za-zµ%\"'\u2032\u2033]")
DECIMAL_COMMA = re.compile(r"(\d),(\d)")
SPELLED = {"oz_in2": "oz*in^2", "kg_m2": "kg*m^2", "kg_cm2": "kg*cm^2", "hz": "Hz", "percent": "%", "pct": "%"}
"""Units of headings as `parse` reads them, where it reads another spelling."""
EMPTY = ("", "na", "n/a", "nan", "null", "none", "-", "--")
"""Words of a cell in which nothing was measured, in lower case."""


def cell_in_si(cell: str, column: TableColumn) -> float:
    """Return a cell's number in SI, by the unit in the cell where it has one.

    >>> from sweetspot.units import MPH
    >>> round(cell_in_si("66.1 km/h", TableColumn("bat_speed", "Bat Speed", "speed", "mph", MPH)), 2)
    18.36
    """
    try:
        return column.zero + column.factor * float(cell)
    except ValueError:
        match = NUMBER_AND_UNIT.fullmatch(cell)
        unit = simplified(match[2]) if match else ""
        kind = "length" if column.kind == "place" and not column.has_no_unit else column.kind
        if match is None or unit not in UNITS[kind]:
            raise ValueError(f"{column.heading} is {cell!r}, not a number") from None
        return zero_of(kind, unit) + UNITS[kind][unit] * float(match[1])


def with_unit(cell: str, column: TableColumn) -> str:
    """Return a cell as `sweetspot.plausibility.parse` reads it: a number without a unit has its column's.

    >>> with_unit("31,2 ± 0,1", TableColumn("moi", "MOI", "moi", "oz_in2", 1.0)), with_unit(
    ...     "2 9/16", TableColumn("station", "x", "station", "in_from_tip", 1.0))
    ('31.2 oz*in^2±0.1', '2 9/16 in')
    """
    cell = DECIMAL_COMMA.sub(r"\1.\2", cell.strip())
    unit = SPELLED.get(column.unit, column.unit.partition("_from_")[0])
    if not unit or HAS_UNIT.search(cell):
        return cell
    value, sign, error = (part.strip() for part in cell.partition("±"))
    of_error = unit if unit == "%" and sign else ""  # an error of a ratio has its own sign
    return f"{value} {unit}{sign}{error}{of_error}"


def place_in_si(cell: str, column: TableColumn, length: float) -> float:
    """Return a place in m from the knob end, by the end that cell or heading names; a cell alone may: ``6in-from-tip``.

    ``length``: of the implement in m.

    >>> column = TableColumn("position", "Position from tip", "place", "from_tip", math.nan)
    >>> [round(place_in_si(cell, column, 0.84), 3) for cell in ("4 cm", "4cm-from-knob")]
    [0.8, 0.04]
    """
    if not column.has_no_unit:
        place = cell_in_si(cell, column)
        return length - place if column.from_tip else place
    end = "" if "from" in cell or not column.unit else f"-{column.unit.replace('_', '-')}"
    return parse_position(f"{cell.strip()}{end}", length=length)


def require_units(
    rows: Sequence[tuple[int, Sequence[str]]], headings: Headings, file_name: str, *, faults: Iterable[str] = ()
) -> None:
    """Refuse columns of plain numbers without a unit, all of them in one message with what else is wrong."""
    vague = [
        column
        for column in headings.columns.values()
        if column.has_no_unit and any(_is_number(cells[column.index : column.index + 1]) for _, cells in rows)
    ]
    refuse_faults(filter(None, (*faults, no_unit(vague))), file_name)


def _is_number(cell: Sequence[str]) -> bool:
    """Return whether a cell, if there is one, is a number without a unit."""
    try:
        return math.isfinite(float(cell[0]))
    except (IndexError, ValueError):
        return False

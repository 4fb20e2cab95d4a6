"""A what-if table as JSON, as rows and as a table for a terminal."""

from __future__ import annotations

from typing import Any

import numpy as np
from rich.console import Group
from rich.table import Table
from rich.text import Text

from sweetspot.report.border import cleaned
from sweetspot.units import INCH, MPH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.whatif import Answers, Axis, TwoWay

SI_UNITS = {
    "mass": "kg", "bore_diameter": "m", "bore_depth": "m", "wall_factor": "", "bat_speed": "m_s", "pitch_speed": "m_s",
    "exit_speed": "m_s", "collision_efficiency": "", "bbcor": "", "balance_point": "m", "moi": "kg_m2",
    "frequency": "hz",
}  # fmt: skip
"""Ending of the key in JSON and CSV of everything that is varied or answered."""
PEOPLES_UNITS: dict[str, tuple[str, float, str]] = {
    "kg": ("oz", OUNCE, ".4g"), "m": ("in", INCH, ".4g"), "m_s": ("mph", MPH, ".1f"),
    "kg_m2": ("oz in^2", OUNCE_INCH_SQUARED, ".0f"), "hz": ("Hz", 1.0, ".0f"), "": ("", 1.0, ".4g"),
}  # fmt: skip
"""Name, size in SI and format of the unit that a table shows."""
REASONS_SHOWN = 5


def key(name: str) -> str:
    """Return the name of a varied or answered quantity with its unit: ``exit_speed_m_s``."""
    return f"{name}_{SI_UNITS[name]}" if SI_UNITS[name] else name


def two_way_json(table: TwoWay) -> dict[str, Any]:
    """Return both axes, every answer as a list of rows (None where a cell failed), and why cells failed."""
    return cleaned(
        {
            "rows": {key(table.rows.variation): list(table.rows.values)},
            "columns": {key(table.columns.variation): list(table.columns.values)},
            "answers": {key(name): table.values(name) for name in Answers.__dataclass_fields__},
            "failures": [{"row": cell.row, "column": cell.column, "reason": cell.reason} for cell in table.failures],
        }
    )


def two_way_rows(table: TwoWay) -> list[dict[str, Any]]:
    """Return one row per cell with what was varied, every answer and the reason of a failed one."""
    rows = []
    names = [
        name for name in Answers.__dataclass_fields__ if name not in (table.rows.variation, table.columns.variation)
    ]
    for cells in table.cells:
        for cell in cells:
            row: dict[str, Any] = {
                key(table.rows.variation): table.rows.values[cell.row],
                key(table.columns.variation): table.columns.values[cell.column],
            }
            row |= {key(name): getattr(cell.answers, name, None) for name in names}
            rows.append(row | {"reason": cell.reason})
    return rows


def two_way_table(table: TwoWay, answer: str) -> Group:
    """Return one answer as a table, and below it the reasons of cells that have none.

    Parameters
    ----------
    answer : name of a field of `Answers`.
    """
    values, (unit, size, digits) = table.values(answer), PEOPLES_UNITS[SI_UNITS[answer]]
    title = f"{_words(answer, unit)}: {_named(table.rows)} down, {_named(table.columns)} across"
    shown = Table(header_style="bold", box=None, pad_edge=False)
    shown.add_column("")
    for value in table.columns.values:
        shown.add_column(_value(table.columns, value), justify="right")
    for first, row in zip(table.rows.values, values, strict=True):
        cells = ("-" if np.isnan(value) else f"{value / size:{digits}}" for value in row)
        shown.add_row(Text(_value(table.rows, first), style="bold"), *cells)
    return Group(Text(title, style="bold"), shown, *(Text(line, style="dim") for line in _reasons(table)))


def _reasons(table: TwoWay) -> list[str]:
    failed = table.failures
    lines = [
        f"- at {_value(table.rows, table.rows.values[cell.row])}, "
        f"{_value(table.columns, table.columns.values[cell.column])}: {cell.reason}"
        for cell in failed[:REASONS_SHOWN]
    ]
    more = len(failed) - len(lines)
    return [*lines, f"- and {more} more cells; --format json has every reason"] if more else lines


def _named(axis: Axis) -> str:
    return _words(axis.variation, PEOPLES_UNITS[SI_UNITS[axis.variation]][0])


def _words(name: str, unit: str) -> str:
    return name.replace("_", " ") + (f" in {unit}" if unit else "")


def _value(axis: Axis, value: float) -> str:
    _, size, _ = PEOPLES_UNITS[SI_UNITS[axis.variation]]
    return f"{value / size:.4g}"

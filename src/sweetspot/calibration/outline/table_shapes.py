"""Tables of stations in other shapes than a line for each station: lying down, a lathe's, closed at the axis."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sweetspot.calibration.outline.measured_outline import knob_first
from sweetspot.plausibility import verdict
from sweetspot.tables.headings import GivenColumns, names_one_of
from sweetspot.tables.vocabulary import UNITS, simplified

Rows = list[tuple[int, list[str]]]
FEWEST_ACROSS = 5
"""Stations in a line at least, for a table that lies down."""
POINT = 1e-3
"""m, the diameter of an end that goes down to the axis: its end face weighs nothing."""


def upright(rows: Rows, given: GivenColumns) -> Rows:
    """Return a table whose headings stand in its first column turned, so that they stand in its first line.

    A table without such lines is returned as it is.
    """
    lines = [cells for _, cells in rows if len(cells) > FEWEST_ACROSS]
    named = [cells for cells in lines if _is_named(cells[0], given)]
    if len(named) < 2:
        return rows
    count = max(map(len, named))
    columns = [cells + [""] * (count - len(cells)) for cells in lines if len(cells) <= count]
    return [(number, [cells[number - 1] for cells in columns]) for number in range(1, count + 1)]


def _is_named(cell: str, given: GivenColumns) -> bool:
    stations = ("station", "diameter", "circumference", "radius")
    return cell.strip() in given.told or names_one_of([cell], stations)


def is_lathe_axis(heading: str) -> bool:
    """Return whether places are a lathe's Z: from any origin, either way."""
    return simplified(heading).split("_")[0] == "z"


def of_lathe(rows: Rows, given: GivenColumns) -> GivenColumns:
    """Return the given meanings of columns, with X as the diameter, or the radius, of a table of Z and X."""
    heads = {simplified(name).split("_")[0]: index for index, name in enumerate(rows[0][1])} if rows else {}
    if not {"z", "x"} <= heads.keys() or given.headings:
        return given
    along, across = (rows[0][1][heads[axis]].strip() for axis in ("z", "x"))
    sizes = [abs(number) for _, cells in rows[1:] if (number := _number(cells[heads["x"] :])) is not None]
    unit = UNITS["length"].get(simplified(across).rpartition("_")[2], 1e-3)
    is_diameter = verdict("greatest_diameter", unit * max(sizes, default=0.0)) == "fine"
    named = next((name for name in ("diameter", "radius") if name in simplified(across)), None)
    return replace(given, headings={"station": along, named or ("diameter" if is_diameter else "radius"): across})


def _number(cells: Sequence[str]) -> float | None:
    try:
        return float(cells[0])
    except (IndexError, ValueError):
        return None


def from_the_knob(stations: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return a lathe's stations, sorted by place, as counted from the knob end: the thicker half is the barrel."""
    places, sizes = knob_first(*np.array(stations).T)
    return list(zip((places - places[0]).tolist(), sizes.tolist(), strict=True))


def without_end_faces(stations: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Return sorted stations without the points on the axis that close an outline at its ends.

    Where the end face is flat, the place has another station; where it is not, its point is given `POINT`.
    """
    sized = {place for place, size in stations if size > 0}
    left = [(place, size) for place, size in stations if size > 0 or place not in sized]
    ends = {0, len(left) - 1}
    return [(place, POINT if not size and index in ends else size) for index, (place, size) in enumerate(left)]

"""A bat's outline from a table of stations: caliper or tape at every inch, in any unit, from either end."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

from sweetspot.calibration.outline.measured_outline import Outline, closed
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text, table_rows
from sweetspot.units import INCH, shown
from sweetspot.units.usual import USUAL, insisted

UNITS = {"in": INCH, "inch": INCH, "inches": INCH, "mm": 1e-3, "cm": 1e-2, "m": 1.0}
SIZES = {"diameter": 1.0, "dia": 1.0, "circumference": 1 / math.pi, "girth": 1 / math.pi, "radius": 2.0}
"""What is measured across, and the diameter per unit of it."""
PLACES = ("position", "station", "place", "x", "from", "tip", "knob")
MOST_STATIONS = 2000
FEWEST_STATIONS = 5


@dataclass(frozen=True)
class _Column:
    index: int
    size: float
    from_tip: bool = False


def read_stations(path: Path, *, length: float | None = None) -> Outline:
    """Return the outline that a CSV file of stations describes.

    One column says where: its heading has a unit, and ``tip`` where it counts from the tip (``in_from_tip``,
    ``position_mm``). Another says how thick: ``diameter``, ``circumference`` or ``radius`` with its unit. Where no
    station is at an end, the tip is rounded as turned bats usually are, and the knob goes on as thick as it was.

    Parameters
    ----------
    length : m; needed where the places count from the tip, or where the last station is not the tip.

    Raises
    ------
    InputError
        when the file has no such columns, a value that is no number, or stations off the bat.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice="give a CSV file of a heading and a line for each station")
    rows = [cells for _, cells in table_rows(text, path, is_heading=_is_heading)]
    if len(rows) < FEWEST_STATIONS + 1 or len(rows) > MOST_STATIONS:
        raise InputError(
            f"{path} has {len(rows)} line{'s' if len(rows) != 1 else ''}; allowed are a heading and "
            f"{FEWEST_STATIONS} to {MOST_STATIONS} stations"
        )
    where, across = _columns(rows[0], path)
    stations = sorted((_number(row, where, number, path), _number(row, across, number, path))
                      for number, row in enumerate(rows[1:], start=2))  # fmt: skip
    _check_not_swapped(stations, rows[0], path)
    _check_each_once(stations, where, path)
    _check_not_girths(stations, rows[0][across.index], path)
    if where.from_tip:
        if length is None:
            raise InputError(f"{path} counts from the tip; say how long the bat is with --length")
        stations = sorted((length - place, size) for place, size in stations)
    return closed(stations, length or stations[-1][0], str(path))


def _check_not_swapped(stations: Sequence[tuple[float, float]], heading: Sequence[str], path: Path) -> None:
    """Refuse a bat that is thicker than it is long: then each column holds what the other's heading says."""
    reach, thickest = stations[-1][0], max(size for _, size in stations)
    if thickest > reach:
        raise InputError(
            f"{path} goes {shown(reach)} along the bat and is {shown(thickest)} thick: the columns "
            f"{' and '.join(heading)} are swapped; put each heading over its own numbers"
        )


def _check_each_once(stations: Sequence[tuple[float, float]], where: _Column, path: Path) -> None:
    for (place, size), (following, other) in pairwise(stations):
        if place == following:
            end = " from the tip" if where.from_tip else ""
            raise InputError(
                f"{path} has two stations {shown(place)}{end}, of {shown(size)} and {shown(other)}; "
                "give each place once"
            )


def _check_not_girths(stations: Sequence[tuple[float, float]], heading: str, path: Path) -> None:
    """Refuse a bat too thick to be one that is not when its sizes are taken for circumferences."""
    thickest = max(size for _, size in stations)
    usual = USUAL["greatest_diameter"]
    if not insisted() and thickest > usual.high * usual.size and usual.holds(thickest / math.pi):
        raise InputError(
            f"{path} says under {heading} that the bat is {shown(thickest)} thick; usual is {usual.low:g} to "
            f"{usual.high:g} {usual.unit}. A tape laid around it tells circumferences: call the column so, or mend the "
            "unit, or add --force if it is meant"
        )


def _is_heading(cells: Sequence[str]) -> bool:
    return sum(any(word in UNITS for word in re.findall(r"[a-z]+", cell.lower())) for cell in cells) > 1


def _columns(heading: list[str], path: Path) -> tuple[_Column, _Column]:
    """Return the columns that say where and how thick."""
    where = across = None
    for index, text in enumerate(heading):
        words = re.findall(r"[a-z]+", text.lower())
        unit = next((UNITS[word] for word in words if word in UNITS), None)
        size = next((SIZES[word] for word in words if word in SIZES), None)
        if size is not None and unit is not None:
            across = across or _Column(index, size * unit)
        elif unit is not None and any(word in PLACES for word in words):
            where = where or _Column(index, unit, "tip" in words)
    if where is None or across is None:
        raise InputError(
            f"{path} begins with {', '.join(heading)!r}; name one column like in_from_tip or position_mm and one like "
            "diameter_mm, circumference_in or radius_cm"
        )
    return where, across


def _number(row: list[str], column: _Column, line: int, path: Path) -> float:
    text = row[column.index].strip() if column.index < len(row) else ""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value) or value < 0:
        raise InputError(f"{path}, line {line}: {text!r} was given; allowed is a number from 0 up, without its unit")
    return value * column.size

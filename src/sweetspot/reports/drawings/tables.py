"""Stations of a bat as tables: those that it is made of, and points close together for a lathe."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.meridian import radius_at, smooth_outline
from sweetspot.reports.quantities import Reader

FEWEST = 9
"""Stations of a table."""
EVERY = 1e-3
"""m between the points of a lathe's table."""


def _stations(bat: Bat) -> Array:
    """Return position and diameter of every station from knob end to tip, m, shape (n, 2)."""
    if bat.profile is not None:
        return np.array(bat.profile)
    places = np.linspace(0.0, bat.length, 101)
    return np.column_stack([places, bat.diameter_at(places)])


def stations_csv(bat: Bat, reading: Reader) -> bytes:
    """Return the stations as a table that `sweetspot outline` reads, to the micrometre or less."""
    unit, size = ("in", reading.units["length"].size) if reading.unit("length") == "in" else ("mm", 1e-3)
    stations = _stations(bat)
    if len(stations) < FEWEST:
        places = np.linspace(0, bat.length, FEWEST)
        stations = np.column_stack([places, bat.diameter_at(places)])
    return _table([f"position_{unit}", f"diameter_{unit}"], stations / size, 6)


def lathe_csv(bat: Bat) -> bytes:
    """Return the smooth outline at every millimetre as a lathe counts it, in mm.

    Z is 0 at the tip and negative towards the knob end, which the headstock holds; X is a diameter.
    """
    outside = smooth_outline(bat)
    ends = [0.0, bat.length, *(curve.end[0] for curve in outside)]
    places = np.unique(np.concatenate([np.arange(0.0, bat.length, EVERY), ends]).round(9))[::-1]
    return _table(
        ["Z_mm", "X_diameter_mm"], 1e3 * np.column_stack([places - bat.length, 2 * radius_at(outside, places)]), 4
    )


def _table(head: Iterable[str], rows: Array, digits: int) -> bytes:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(head)
    writer.writerows([f"{number:.{digits}f}" for number in row] for row in rows.tolist())
    return text.getvalue().encode()

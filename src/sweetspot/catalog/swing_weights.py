"""The swing-weight convention of each sport."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import entry, read_table
from sweetspot.dynamics.rigid import SwingWeight
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FILE = "swing_weights.toml"
MOMENTS: dict[int, Kind] = {1: "first moment", 2: "moi"}
"""Kind of quantity of a moment by its order."""


@cache
def swing_weight(sport: str) -> SwingWeight:
    """Return how a sport weighs a swing; raises `InputError` with the nearest names for an unknown one.

    >>> swing_weight("tennis").axis
    0.1
    """
    _, table = entry(read_table(FILE), sport, "sport")
    axis = parse(table["axis"], "length", f"{sport} axis")
    size = parse(table["size"], MOMENTS[table["order"]], f"{sport} size")
    return SwingWeight(**{**table, "axis": axis, "size": size})

"""Published laws of bat speed against moment of inertia by name, and each sport's convention of a swing weight."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, read_table
from sweetspot.dynamics.swing_weight import SwingWeight
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.units import Kind

FILE = "swing_laws.toml"
DEFAULT_SWING_LAW = "baseball"


def swing_law_names() -> list[str]:
    """Return the names of all swing laws in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def swing_law(name: str = DEFAULT_SWING_LAW) -> SwingLaw:
    """Return a swing law of the catalogue; raises `InputError` with the nearest names for an unknown one.

    >>> swing_law("baseball").exponent
    0.29
    """
    _, table = entry(read_table(FILE), name, "swing law")
    exponent, spread = table.quantity("exponent", "ratio"), table.spread("exponent", "ratio")
    axis, lightest = table.quantity("axis", "length"), table.quantity("lightest_moi", "moi")
    assert spread is not None, f"{FILE}: {name} has no spread"
    return SwingLaw(table.name, exponent, spread, axis, lightest)


MOMENTS: dict[int, Kind] = {1: "first moment", 2: "moi"}
"""Kind of quantity of a moment by its order."""


@cache
def swing_weight(sport: str) -> SwingWeight:
    """Return how a sport weighs a swing; raises `InputError` with the nearest names for an unknown one.

    >>> swing_weight("tennis").axis
    0.1
    """
    _, table = entry(read_table("swing_weights.toml"), sport, "sport")
    axis, size = table.quantity("axis", "length"), table.quantity("size", MOMENTS[int(table.number("order"))])
    return SwingWeight(**{**table, "axis": axis, "size": size})

"""Published laws of bat speed against moment of inertia by name, and each sport's convention of a swing weight."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, quantity, read_table, unwrapped
from sweetspot.dynamics.rigid import SwingWeight
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.plausibility import parse
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
    what = table["name"]
    exponent, axis = quantity(table, "exponent", "ratio", what), quantity(table, "axis", "length", what)
    lightest = quantity(table, "lightest_moi", "moi", what)
    assert exponent is not None and axis is not None and lightest is not None, f"{FILE}: {name} is not complete"
    spread = parse(unwrapped(table["exponent"]["spread"]), "ratio", f"{what} spread")
    return SwingLaw(what, exponent, spread, axis, lightest)


MOMENTS: dict[int, Kind] = {1: "first moment", 2: "moi"}
"""Kind of quantity of a moment by its order."""


@cache
def swing_weight(sport: str) -> SwingWeight:
    """Return how a sport weighs a swing; raises `InputError` with the nearest names for an unknown one.

    >>> swing_weight("tennis").axis
    0.1
    """
    _, table = entry(read_table("swing_weights.toml"), sport, "sport")
    axis = parse(table["axis"], "length", f"{sport} axis")
    size = parse(table["size"], MOMENTS[table["order"]], f"{sport} size")
    return SwingWeight(**{**table, "axis": axis, "size": size})

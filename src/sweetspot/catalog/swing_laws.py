"""Published laws of bat speed against moment of inertia, by name."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, quantity, read_table, unwrapped
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.plausibility import parse

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

"""Pitches by name or by Statcast's two letters: how an average right-hander lets them go."""

from __future__ import annotations

from functools import cache
from typing import Any

from sweetspot.catalog.records import canonical, quantity, read_table
from sweetspot.errors import InputError, nearest_names
from sweetspot.flight.pitch import Delivery
from sweetspot.units import Kind

FILE = "pitches.toml"
FIELDS: dict[str, Kind] = {
    "speed": "speed",
    "spin_rate": "angular speed",
    "spin_axis": "angle",
    "efficiency": "ratio",
    "side": "length",
    "height": "length",
    "extension": "length",
}
"""What an entry says of a delivery, and the kind of quantity."""


def delivery_names() -> list[str]:
    """Return the names of all pitches in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def delivery(name: str = "fastball") -> Delivery:
    """Return a pitch as it leaves the hand; raises `InputError` with the nearest names for an unknown one.

    >>> delivery("CU").name, round(delivery("CU").speed / 0.44704, 1)
    ('curve ball', 78.0)
    """
    found = _entry(name)
    return Delivery(name=found["name"], **{field: quantity(found, field, kind, name) for field, kind in FIELDS.items()})


def usual_height(name: str) -> float:
    """Return how high in m a pitch of the catalogue passes the plate on average."""
    height = quantity(_entry(name), "plate_height", "length", name)
    assert height is not None, f"pitches.toml: {name} lacks plate_height"
    return height


def _entry(name: str) -> dict[str, Any]:
    table = read_table(FILE)
    known = {canonical(word): key for key, entry in table.items() for word in (key, *entry["also"])}
    if canonical(name) not in known:
        raise InputError(f"pitch {name!r} is not in the catalogue. {nearest_names(canonical(name), list(known))}")
    return table[known[canonical(name)]]

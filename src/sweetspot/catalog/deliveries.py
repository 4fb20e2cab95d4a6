"""Pitches by name or by Statcast's two letters: how an average right-hander lets them go."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import Entry, canonical, known_names, read_table
from sweetspot.errors import InputError, nearest_names
from sweetspot.flight.pitch import Delivery
from sweetspot.units import Kind

FILE, OTHERS = "pitches.toml", "other_pitches.toml"
FIELDS: dict[str, Kind] = {
    "speed": "speed",
    "spin_rate": "angular speed",
    "spin_axis": "angle",
    "efficiency": "ratio",
    "side": "length",
    "height": "length",
    "extension": "length",
    "distance": "length",
}
"""Keys of an entry, and the kind of quantity."""


def delivery_names() -> list[str]:
    """Return the names of the tracked pitches of the major leagues."""
    return [canonical(name) for name in read_table(FILE)]


def other_delivery_names() -> list[str]:
    """Return the names of the pitches of other leagues: youth baseball and softball."""
    return [canonical(name) for name in read_table(OTHERS)]


def delivery_sport(name: str) -> str:
    """Return the sport that a pitch is thrown in.

    >>> delivery_sport("fast-pitch"), delivery_sport("FF")
    ('softball', 'baseball')
    """
    return _entry(name).text("sport", "baseball")


@cache
def delivery(name: str = "fastball") -> Delivery:
    """Return a pitch as it leaves the hand; raises `InputError` with the nearest names for an unknown one.

    >>> delivery("CU").name, round(delivery("CU").speed / 0.44704, 1)
    ('curve ball', 78.0)
    """
    pitch = _entry(name)
    return Delivery(name=pitch.name, **pitch.quantities(FIELDS))


def usual_height(name: str) -> float:
    """Return the average height in m of a pitch of the catalogue over the plate."""
    return _entry(name).quantity("plate_height", "length")


def _entry(name: str) -> Entry:
    table = {**read_table(FILE), **read_table(OTHERS)}
    names = known_names(table)
    if canonical(name) not in names:
        raise InputError(f"pitch {name!r} is not in the catalogue. {nearest_names(canonical(name), list(names))}")
    return table[names[canonical(name)]]

"""Rubbers of table-tennis rackets by name."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, quantity, read_table
from sweetspot.equipment.face import Rubber
from sweetspot.errors import InputError
from sweetspot.units import Kind

FILE = "rubbers.toml"
KINDS: dict[str, Kind] = {
    "thickness": "length", "areal_density": "areal density", "stiffness": "stiffness", "moving_mass": "mass",
    "restitution": "ratio", "friction": "ratio", "tangential_restitution": "ratio",
}  # fmt: skip


def rubber_names() -> list[str]:
    """Return the names of all rubbers in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def rubber(name: str) -> Rubber:
    """Return a rubber of the catalogue; raises `InputError` with the nearest names for an unknown one.

    >>> rubber("anti-spin").friction < rubber("inverted").friction
    True
    """
    _, table = entry(read_table(FILE), name, "rubber")
    values = {field: quantity(table, field, kind, table["name"]) for field, kind in KINDS.items()}
    return Rubber(name=table["name"], **values)


def rubber_key(own: Rubber) -> str:
    """Return the catalogue's name of a rubber; raises `InputError` when it is none of the catalogue's."""
    for name in rubber_names():
        if rubber(name) == own:
            return name
    raise InputError(f"{own.name} differs from the catalogue's rubbers; a file can only name one")

"""The names that columns of tables have: quantities that anybody may name, and measuring systems with their own."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

SIGNS = {"²": "2", "\u2033": "in", '"': "in", "ø": "diameter", "\u2300": "diameter"}
"""Signs of headings as words."""
METRES = re.compile(r"\b(milli|centi)?met(?:er|re)s?\b")
FILE = Path(__file__).with_name("headings.toml")


@dataclass(frozen=True)
class TableQuantity:
    """A quantity of tables: what kind it is (`unit_words.UNITS`), and its names that anybody may use."""

    kind: str
    names: tuple[str, ...]


@dataclass(frozen=True)
class MeasuringSystem:
    """A system whose headings mean its own units.

    Parameters
    ----------
    name : as messages write it.
    marks : sets of headings, each of which gives a table of the system away.
    columns : quantity and unit by heading, most preferred first; "" for what is no quantity here.
    fixed : whether its units are never metric.
    """

    name: str
    marks: tuple[frozenset[str], ...]
    columns: Mapping[str, tuple[str, str]]
    fixed: bool


@cache
def _table() -> Mapping[str, Mapping[str, Any]]:
    with FILE.open("rb") as file:
        return tomllib.load(file)


@cache
def quantities() -> Mapping[str, TableQuantity]:
    """Return every quantity of tables by its name."""
    groups = (group.items() for name, group in _table().items() if name != "systems")
    return {
        name: TableQuantity(entry["kind"], tuple(entry.get("names", ()))) for group in groups for name, entry in group
    }


def quantities_of(*groups: str) -> tuple[str, ...]:
    """Return the quantities of tables of some sorts: balls, swings."""
    return tuple(name for group in groups for name in _table()[group])


@cache
def systems() -> tuple[MeasuringSystem, ...]:
    """Return the measuring systems, the most particular first."""
    entries = _table()["systems"]

    def columns(key: str) -> dict[str, tuple[str, str]]:
        meanings = {heading: text.partition(" ") for heading, text in entries[key]["columns"].items()}
        by_heading = {heading: (quantity, simplified(unit)) for heading, (quantity, _, unit) in meanings.items()}
        also = entries[key].get("also")
        return by_heading | (columns(also) if also else {})

    return tuple(
        MeasuringSystem(entry["name"], tuple(map(frozenset, entry["marks"])), columns(key), entry.get("fixed", False))
        for key, entry in entries.items()
    )


def simplified(heading: str) -> str:
    """Return a heading in lower case, words and unit joined by single underscores.

    >>> simplified("Exit Velocity [km/h]"), simplified("ExitSpeed"), simplified("ax (ft/s²)")
    ('exit_velocity_km_h', 'exitspeed', 'ax_ft_s2')
    """
    plain = heading.replace("\ufeff", "").strip().strip('"').lower()
    for sign, word in SIGNS.items():
        plain = plain.replace(sign, word)
    plain = METRES.sub(lambda match: f"{(match[1] or '')[:1]}m", plain)
    return re.sub(r"[^0-9a-z%°]+", "_", plain).strip("_")


@cache
def quantity_by_name(wanted: tuple[str, ...]) -> Mapping[str, str]:
    """Return the quantity of each name that anybody may use, written without underscores."""
    found: dict[str, str] = {}
    for quantity in wanted:
        for name in quantities()[quantity].names:
            found.setdefault(joined(name), quantity)
    return found


def joined(name: str) -> str:
    """Return a simplified name without its underscores."""
    return name.replace("_", "")


def spelled_names(wanted: Collection[str]) -> list[str]:
    """Return all names that anybody may use for some quantities, as they are spelled."""
    return [name for quantity in wanted for name in quantities()[quantity].names]

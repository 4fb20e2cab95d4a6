"""Catalogue records: a value with its unit, spread, source, place and kind."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal, TypeVar

from sweetspot.errors import InputError, nearest_names
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FOLDER = Path(__file__).parent
Entry = TypeVar("Entry")
RecordKind = Literal["measured", "specified", "derived", "fitted", "assumed"]


@dataclass(frozen=True)
class Record:
    """Source of a catalogue value.

    Parameters
    ----------
    name : of the value, for example "white_ash.density".
    value, spread : as written, with units.
    source : key of the bibliography.
    where : place in the source, or the reasoning.
    kind : measured, specified, derived, fitted or assumed.
    """

    name: str
    value: Any
    spread: Any
    source: str
    where: str
    kind: RecordKind


LISTED = {"bat": "`sweetspot bats`", "sport": "`sweetspot sports`"}
"""Which command lists what has many names."""


@cache
def read_table(file_name: str) -> dict[str, dict[str, Any]]:
    """Return a catalogue file; an entry with ``like`` starts from a copy of the named entry."""
    with (FOLDER / file_name).open("rb") as file:
        entries = tomllib.load(file)
    return {name: {**entries[entry["like"]], **entry} if "like" in entry else entry for name, entry in entries.items()}


def entry(table: Mapping[str, Entry], name: str, what: str) -> tuple[str, Entry]:
    """Return the key and entry of a name, however its words are joined, or refuse it with the nearest names.

    An entry is known by its key, and by what else it has under ``also``.
    """
    key = canonical(name)
    names = known_names(table)
    if key not in names:
        listed = f" {LISTED[what]} lists all." if what in LISTED else ""
        hint = nearest_names(key[:60], sorted(names), listed=sorted(map(_also_called, table.items())))
        raise InputError(f"{what} {name[:60]!r} is not in the catalogue. {hint}{'' if hint.endswith('?') else listed}")
    return names[key], table[names[key]]


def _also_called(described: tuple[str, Any]) -> str:
    """Return the name of an entry with the others that it is known by behind it."""
    key, content = described
    also = content.get("also", ()) if isinstance(content, dict) else ()
    return f"{canonical(key)} ({', '.join(also)})" if also else canonical(key)


def known_names(table: Mapping[str, Any]) -> dict[str, str]:
    """Return the key of every entry by each of the names that people know it by."""
    also = {
        canonical(name): key
        for key, described in table.items()
        if isinstance(described, dict)
        for name in described.get("also", ())
    }
    return also | {canonical(key): key for key in table}


def canonical(name: str) -> str:
    """Return a catalogue name as people type it: lower case, words joined by hyphens."""
    return name.strip().lower().replace("_", "-").replace(" ", "-")


def quantity(entry: dict[str, Any], field: str, kind: Kind, what: str) -> float | None:
    """Return one field of an entry in SI, or None where the entry has no such field."""
    if field not in entry:
        return None
    return parse(unwrapped(entry[field]), kind, f"{what} {field}")


def unwrapped(value: Any) -> Any:
    """Return a value without its provenance: the ``value`` of a record, also inside tables; anything else as it is."""
    if not isinstance(value, dict):
        return value
    if "value" in value and "source" in value:
        return value["value"]
    return {name: unwrapped(part) for name, part in value.items()}


def all_records(entry: dict[str, Any], name: str) -> list[Record]:
    """Return the provenance of every value in an entry that has one."""
    records = []
    for field, value in entry.items():
        if isinstance(value, dict) and "value" in value and "source" in value:
            records.append(
                Record(
                    f"{name}.{field}", value["value"], value.get("spread"), value["source"], value.get("where", ""),
                    value["kind"],
                )
            )  # fmt: skip
    return records

"""Catalogue records: a value with its unit, spread, source, place and kind."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, time
from functools import cache
from pathlib import Path
from typing import NoReturn, TypeAlias, TypeVar

from sweetspot.equipment.sport import CERTAINTIES, Certainty
from sweetspot.errors import InputError, nearest_names
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FOLDER = Path(__file__).parent
TomlValue: TypeAlias = "str | float | date | time | Sequence[TomlValue] | Mapping[str, TomlValue]"
TomlTable: TypeAlias = Mapping[str, TomlValue]
Content = TypeVar("Content")
Choice = TypeVar("Choice")


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
    value: TomlValue
    spread: TomlValue | None
    source: str
    where: str
    kind: Certainty


@dataclass(frozen=True, eq=False)
class Entry(Mapping[str, TomlValue]):
    """An entry of the catalogue: ``entry[field]`` is a field as it is written, the methods give it as what it is."""

    key: str
    fields: TomlTable

    def __getitem__(self, field: str) -> TomlValue:
        return self.fields[field]

    def __iter__(self) -> Iterator[str]:
        return iter(self.fields)

    def __len__(self) -> int:
        return len(self.fields)

    @property
    def name(self) -> str:
        """What people call it."""
        return self.text("name")

    def text(self, field: str, absent: str | None = None) -> str:
        """Return a text."""
        value = unwrapped(self.fields.get(field, absent)) if absent is not None else unwrapped(self._has(field))
        return value if isinstance(value, str) else self._refuse(field, "text")

    def texts(self, field: str) -> tuple[str, ...]:
        """Return a list of texts; empty where there is no such field."""
        values = unwrapped(self.fields.get(field, ()))
        if not isinstance(values, (list, tuple)):
            return self._refuse(field, "list")
        return tuple(str(value) for value in values)

    def number(self, field: str) -> float:
        """Return a number without a unit."""
        value = unwrapped(self._has(field))
        return value if isinstance(value, (int, float)) else self._refuse(field, "number")

    def numbers(self, field: str) -> list[float]:
        """Return a list of numbers."""
        values = unwrapped(self._has(field))
        if not isinstance(values, list):
            return self._refuse(field, "list")
        return [value if isinstance(value, (int, float)) else self._refuse(field, "number") for value in values]

    def quantity(self, field: str, kind: Kind) -> float:
        """Return a quantity in SI."""
        value = unwrapped(self._has(field))
        if not isinstance(value, (str, int, float)):
            return self._refuse(field, "quantity")
        return parse(value, kind, f"{self.fields.get('name', self.key)} {field}")

    def quantity_or_none(self, field: str, kind: Kind) -> float | None:
        """Return a quantity in SI; None where there is no such field."""
        return self.quantity(field, kind) if field in self.fields else None

    def quantities(self, kinds: Mapping[str, Kind]) -> dict[str, float]:
        """Return those of some quantities that there are, in SI."""
        return {field: self.quantity(field, kind) for field, kind in kinds.items() if field in self.fields}

    def spread(self, field: str, kind: Kind) -> float | None:
        """Return the half width of what is plausible of a quantity, SI; None where the catalogue does not know it."""
        record = self.fields.get(field)
        spread = unwrapped(record["spread"]) if isinstance(record, Mapping) and "spread" in record else None
        what = f"{self.fields.get('name', self.key)} {field} spread"
        return parse(spread, kind, what) if isinstance(spread, (str, int, float)) else None

    def table(self, field: str) -> Entry:
        """Return a table inside this one; empty where there is none."""
        value = self.fields.get(field, {})
        return Entry(f"{self.key}.{field}", value) if isinstance(value, Mapping) else self._refuse(field, "table")

    def tables(self, field: str) -> tuple[Entry, ...]:
        """Return the tables of a list; empty where there is none."""
        values = self.fields.get(field, ())
        if not isinstance(values, (list, tuple)):
            return self._refuse(field, "list")
        return tuple(Entry(self.key, value) for value in values if isinstance(value, Mapping))

    def choice(self, field: str, choices: Sequence[Choice], absent: str | None = None) -> Choice:
        """Return the one of several texts that stands there."""
        text = self.text(field, absent)
        return next((choice for choice in choices if choice == text), None) or self._refuse(field, text)

    def _has(self, field: str) -> TomlValue:
        return self.fields[field] if field in self.fields else self._refuse(field, "value")

    def _refuse(self, field: str, what: str) -> NoReturn:
        """Raise `LookupError`: the catalogue itself is wrong."""
        raise LookupError(f"{self.key} has no {what} {field}")


LISTED = {"bat": "`sweetspot bats`", "sport": "`sweetspot sports`"}
"""Which command lists what has many names."""


@cache
def read_table(file_name: str) -> Mapping[str, Entry]:
    """Return the entries of a catalogue file; one with ``like`` starts from a copy of the entry that it names."""
    with (FOLDER / file_name).open("rb") as file:
        tables = tomllib.load(file)
    return {
        key: Entry(key, {**tables[table["like"]], **table} if "like" in table else table)
        for key, table in tables.items()
    }


def entry(table: Mapping[str, Content], name: str, what: str) -> tuple[str, Content]:
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


def _also_called(described: tuple[str, object]) -> str:
    """Return the name of an entry with the others that it is known by behind it."""
    key, content = described
    also = content.texts("also") if isinstance(content, Entry) else ()
    return f"{canonical(key)} ({', '.join(also)})" if also else canonical(key)


def known_names(table: Mapping[str, object]) -> dict[str, str]:
    """Return the key of every entry by each of the names that people know it by."""
    also = {
        canonical(name): key
        for key, content in table.items()
        if isinstance(content, Entry)
        for name in content.texts("also")
    }
    return also | {canonical(key): key for key in table}


def canonical(name: str) -> str:
    """Return a catalogue name as people type it: lower case, words joined by hyphens."""
    return name.strip().lower().replace("_", "-").replace(" ", "-")


def is_file(name_or_path: str) -> bool:
    """Return whether a text denotes a file: it ends in ``.toml``, holds a path separator or names an existing one."""
    path = Path(name_or_path)
    if path.suffix.lower() == ".toml" or "/" in name_or_path or "\\" in name_or_path:
        return True
    try:
        return path.is_file()
    except (OSError, ValueError):  # longer than any file's name, or with a sign that none may have
        return False


def unwrapped(value: TomlValue) -> TomlValue:
    """Return a value without its provenance: the ``value`` of a record, also inside tables and lists."""
    match value:
        case Mapping() if "value" in value and "source" in value:
            return unwrapped(value["value"])
        case Mapping():
            return unwrapped_table(value)
        case list():
            return [unwrapped(part) for part in value]
    return value


def unwrapped_table(table: TomlTable) -> dict[str, TomlValue]:
    """Return a table without the provenance of its values."""
    return {name: unwrapped(part) for name, part in table.items()}


def all_records(entry: TomlTable, name: str) -> list[Record]:
    """Return the provenance of every value in an entry that has one."""
    found = ((field, Entry(name, value)) for field, value in entry.items() if isinstance(value, Mapping))
    return [
        Record(
            f"{name}.{field}",
            record["value"],
            record.get("spread"),
            record.text("source"),
            record.text("where", ""),
            record.choice("kind", CERTAINTIES),
        )
        for field, record in found
        if "value" in record and "source" in record
    ]

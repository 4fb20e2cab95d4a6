"""Files that start from an entry of the catalogue: ``like = "tennis-racket"`` and what is different."""

from __future__ import annotations

import tomllib
from typing import Any

from sweetspot.catalog.records import FOLDER, canonical, entry, unwrapped

FOLDERS = ("bats", "implements")
OUTLINES = frozenset({"profile", "turned", "linear_density"})
"""Of these a bat has one: another in the file takes the place of the entry's."""


def resolved(table: dict[str, Any]) -> dict[str, Any]:
    """Return a file's table with what it leaves out taken from the catalogue's entry that ``like`` names.

    Tables inside it are completed the same way; lists are replaced whole.

    Raises
    ------
    InputError
        for a name that is not in the catalogue, with the nearest ones.

    >>> resolved({"like": "tennis-racket", "mass": "330 g"})["mass"]
    '330 g'
    """
    name = table.get("like")
    if not isinstance(name, str):
        return table
    known = {canonical(path.stem): path for folder in FOLDERS for path in (FOLDER / folder).glob("*.toml")}
    key, _ = entry({key: {} for key in known}, name, "bat")
    with known[key].open("rb") as file:
        base = _plain(tomllib.load(file))
    changes = {field: value for field, value in table.items() if field != "like"}
    if OUTLINES & changes.keys():
        base = {field: value for field, value in base.items() if field not in OUTLINES}
    base.pop("note", None)
    if {"ra", "first_frequency"} & changes.keys():  # one of them is enough
        base = {field: value for field, value in base.items() if field not in ("ra", "first_frequency")}
    return _completed({**base, "name": f"{base['name']}, changed"[:100]}, changes)


def _plain(value: Any) -> Any:
    """Return a value without provenance, tables inside it included."""
    plain = unwrapped(value)
    return {key: _plain(item) for key, item in plain.items()} if isinstance(plain, dict) else plain


def _completed(base: dict[str, Any], changes: dict[str, Any]) -> dict[str, Any]:
    table = dict(base)
    for key, value in changes.items():
        own = table.get(key)
        table[key] = _completed(own, value) if isinstance(own, dict) and isinstance(value, dict) else value
    return table

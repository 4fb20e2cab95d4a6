"""What people of rackets write without units: ``swing_weight = 325``, ``twist_weight = 14``, ``pattern = "16x19"``."""

from __future__ import annotations

import re
from collections.abc import Mapping

from sweetspot.catalog.records import TomlTable, TomlValue, unwrapped
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.errors import InputError

WEIGHTS = {"swing_weight": "moi", "twist_weight": "twist_moi"}
"""Moments of inertia by the words of people, and their names in a file."""


def in_file_names(table: TomlTable, sport: str) -> TomlTable:
    """Return a racket's table with the names and units that files have, for what its people write without.

    Plain numbers are kg cm^2; the swing weight is about the axis of the sport.

    Raises `InputError` for a quantity that is written both ways, or is not understood.

    >>> in_file_names({"swing_weight": 325}, "tennis")
    {'moi': '325 kg*cm^2', 'moi_axis': '0.1 m'}
    >>> in_file_names({"strings": {"pattern": "16x19"}}, "tennis")
    {'strings': {'mains': 16, 'crosses': 19}}
    """
    changed: dict[str, TomlValue] = {name: value for name, value in table.items() if name not in WEIGHTS}
    for word, name in WEIGHTS.items():
        if word not in table:
            continue
        if name in table:
            raise InputError(f"{word} and {name} say the same; give one of them")
        changed[name] = _with_unit(unwrapped(table[word]), word)
        if name == "moi":
            if "moi_axis" in table:
                raise InputError("swing_weight is about the axis of its sport; with moi_axis write moi")
            changed["moi_axis"] = f"{swing_weight(sport).axis:g} m"
    strings = table.get("strings")
    if isinstance(strings, Mapping) and "pattern" in strings:
        changed["strings"] = _counted(strings)
    return changed


def _with_unit(value: object, word: str) -> str:
    """Return a moment of inertia as files have it; a number without a unit is in kg cm^2."""
    if isinstance(value, str) and not re.fullmatch(r"\s*\d+(\.\d+)?\s*", value):
        return value
    if not isinstance(value, (int, float, str)) or isinstance(value, bool):
        raise InputError(f"{word} is {str(value)[:40]!r}; write a number in kg cm^2, such as 325")
    return f"{str(value).strip()} kg*cm^2"


def _counted(strings: Mapping[str, TomlValue]) -> dict[str, TomlValue]:
    """Return a table of strings with the numbers of mains and crosses of its pattern."""
    pattern = str(unwrapped(strings["pattern"]))
    found = re.fullmatch(r"\s*(\d+)\s*[x×/]\s*(\d+)\s*", pattern)
    if found is None:
        raise InputError(f"strings.pattern is {pattern[:40]!r}; write mains and crosses, such as 16x19")
    if {"mains", "crosses"} & strings.keys():
        raise InputError("strings.pattern tells mains and crosses; leave those out")
    others = {name: value for name, value in strings.items() if name != "pattern"}
    return {**others, "mains": int(found[1]), "crosses": int(found[2])}

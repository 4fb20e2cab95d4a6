"""Differences of an implement from one of the catalogue, as the text of a file that is ``like`` it."""

from __future__ import annotations

from typing import Any

from sweetspot.catalog.files.bat import MEASURED
from sweetspot.catalog.files.write import implement_table
from sweetspot.catalog.implements import implement as catalogue_implement
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError


def changes_table(implement: Implement, *, like: str) -> dict[str, Any]:
    """Return the content of a file that names an entry of the catalogue and says only what is different.

    Parameters
    ----------
    like : name in the catalogue of an implement of the same kind.

    Raises
    ------
    InputError
        see `implement_toml`.

    >>> from sweetspot import catalog
    >>> changes = changes_table(catalog.implement("tennis-racket").replaced(mass=0.305), like="tennis-racket")
    >>> changes["mass"], changes["balance_point"]  # written again: measurements hold for one weight
    ('0.305 kg', '0.325 m')
    """
    if implement.added:
        raise InputError(f"{implement.name} has weights on it; describe it without them, and add [[point_mass]]")
    table = implement_table(implement)
    changed = _different(table, implement_table(catalogue_implement(like)))
    measured = {name: table[name] for name in (*MEASURED, "moi_axis") if name in table} if changed else {}
    return {"like": like, **changed, **measured}


def _different(table: dict[str, Any], pattern: dict[str, Any]) -> dict[str, Any]:
    """Return the entries of a table that differ from the pattern's, recursively."""
    changed: dict[str, Any] = {}
    for name, value in table.items():
        before = pattern.get(name)
        if isinstance(value, dict) and isinstance(before, dict) and value != before:
            changed[name] = _different(value, before)
        elif value != before:
            changed[name] = value
    return changed

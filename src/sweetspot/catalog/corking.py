"""Bats as people cork them: drilled, and filled with what is put into bats."""

from __future__ import annotations

from collections.abc import Mapping

from sweetspot.catalog.materials import material
from sweetspot.equipment.bat import Bat

FILLS: Mapping[str, str] = {"cork": "cork", "rubber": "rubber", "foam": "polyurethane-foam"}
"""What a corked bat is filled with: label and material of the catalogue."""
LABELS = ("unmodified", "drilled", *FILLS)


def corkings(bat: Bat, *, diameter: float, depth: float, plug: float) -> tuple[Bat, ...]:
    """Return a bat unmodified, drilled, and with every filling, in the order of `LABELS`.

    Parameters
    ----------
    diameter, depth : m, of the hole from the tip.
    plug : m of wood that closes a filled hole.
    """
    filled = (bat.corked(diameter=diameter, depth=depth, fill=material(name), plug=plug) for name in FILLS.values())
    return (bat, bat.drilled(diameter=diameter, depth=depth), *filled)

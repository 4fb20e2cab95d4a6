"""Rings in bat files: read, written and read again."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.catalog.files.read import bat_from_table
from sweetspot.catalog.files.write import bat_table
from sweetspot.catalog.records import Entry
from sweetspot.units import INCH


def test_rings_come_back_from_a_file() -> None:
    table = bat_table(catalog.bat("single-wall"))
    ring = {"position": "26.5 in", "width": "8 mm", "depth": "10 mm"}
    disc = {"position": "28 in", "width": "3 mm", "material": "carbon laminate"}
    shell = Entry("shell", table).table("shell")
    bat = bat_from_table({**table, "shell": {**shell, "ring": [ring, disc]}}, "here")
    assert bat.shell is not None
    first, second = bat.shell.rings
    assert abs(first.position - 26.5 * INCH) < 1e-12 and first.depth == 0.01 and first.material == bat.material
    assert second.depth is None and second.material.name == catalog.material("carbon laminate").name
    assert bat_from_table(bat_table(bat), "again") == bat
    alone = bat_from_table({**table, "shell": {**shell, "ring": ring}}, "here").shell  # one table is a list of one
    assert alone is not None and len(alone.rings) == 1

"""Whose bat is which, from a small table."""

from __future__ import annotations

import csv
import io
from pathlib import Path

from sweetspot.catalog.bats import load_bat
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import MOST_TABLE_BYTES, read_text
from sweetspot.season.answers import UNKNOWN_BAT
from sweetspot.season.text_ends import separator_of

BATTER = ("batter", "batter_id", "player", "hitter", "batter_name")


def read_bats(path: Path) -> dict[str, str]:
    """Return the bat of each batter, a name of the catalogue or a file; "" is the bat of all others.

    Batters who are not in the table and have no row for all others count as batters with an unknown bat.

    Raises
    ------
    InputError
        when the file cannot be read, lacks a column, names a batter twice, or a bat that is not known.
    """
    text = read_text(path, most=MOST_TABLE_BYTES, advice="give a CSV table of bats")
    try:
        rows = list(csv.reader(io.StringIO(text), delimiter=separator_of(text.partition("\n")[0])))
    except csv.Error as error:
        raise InputError(f"{path} cannot be read as CSV text: {error}") from None
    if not rows:
        raise InputError(f"{path} is empty; give a table with the columns batter and bat")
    names = [cell.strip().lower() for cell in rows[0]]
    who = next((names.index(name) for name in BATTER if name in names), None)
    if who is None or "bat" not in names:
        missing = "bat" if who is not None else "batter"
        raise InputError(f"{path} has no column {missing}; it has: {', '.join(rows[0])}; give batter and bat")
    what = names.index("bat")
    bats: dict[str, str] = {}
    for number, row in enumerate(rows[1:], start=2):
        if not any(cell.strip() for cell in row):
            continue
        if len(row) <= max(who, what) or not row[what].strip():
            raise InputError(f"{path}, line {number}: no bat is given; give a name of the catalogue or a file")
        batter, bat = row[who].strip(), row[what].strip()
        batter = (
            batter.removesuffix(".0") if batter.removesuffix(".0").isdigit() else batter
        )  # as spreadsheets write it
        if bats.get(batter, bat) != bat:
            raise InputError(f"{path}, line {number}: {batter or 'all others'} has two bats, {bats[batter]} and {bat}")
        try:
            load_bat(bat)
        except InputError as error:
            raise InputError(f"{path}, line {number}: {error}") from None
        bats[batter] = bat
    if not bats:
        raise InputError(f"{path} names no bat; give a row per batter")
    bats.setdefault("", UNKNOWN_BAT)
    return bats

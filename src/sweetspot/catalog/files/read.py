"""Files of bats, rackets, clubs and sticks, whole or like others, as the things that they describe."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sweetspot.catalog.files.bat import bat_of_table, read_toml
from sweetspot.catalog.files.implement import implement_of_table
from sweetspot.catalog.files.like import resolved
from sweetspot.catalog.implement_doubts import warn_of_doubts
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement

STANDARD_INPUT = Path("/dev/stdin")


def read_bat(path: Path) -> Bat:
    """Return the bat that a TOML file describes; raises `InputError` that says what is wrong in it."""
    bat = bat_of_table(whole_table(path), str(path))
    warn_of_doubts(bat)
    return bat


def read_implement(path: Path) -> Implement:
    """Return the implement that a TOML file describes; raises `InputError` that says what is wrong in it."""
    implement = implement_of_table(whole_table(path), str(path))
    warn_of_doubts(implement)
    return implement


def whole_table(path: Path) -> dict[str, Any]:
    """Return a TOML file's content with what it takes from the one that it is ``like``."""
    here = path.resolve()
    folder = Path() if path == STANDARD_INPUT else here.parent
    return resolved(read_toml(path), str(path), folder, (here,))


def bat_from_table(table: dict[str, Any], where: str) -> Bat:
    """Return the bat that a table describes, perhaps like one of the catalogue; no file of the reader's is opened.

    Parameters
    ----------
    where : names the table in messages.
    """
    return bat_of_table(resolved(table, where), where)


def implement_from_table(table: dict[str, Any], where: str) -> Implement:
    """Return the implement that a table describes by its ``kind``; see `bat_from_table`."""
    return implement_of_table(resolved(table, where), where)

"""Whatever one hits a ball with, by name or from a file: the bats, and the rackets, clubs and sticks."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

from sweetspot.catalog.bats import bat_files, bat_tables, is_file, other_files, other_tables, refuse_slip
from sweetspot.catalog.files.bat import read_toml
from sweetspot.catalog.files.read import implement_from_table, read_implement
from sweetspot.catalog.records import entry
from sweetspot.equipment.implement import Implement


@cache
def implement_tables() -> dict[str, dict[str, Any]]:
    """Return every bat, racket, club and stick of the catalogue as written, by name."""
    return {**bat_tables(), **other_tables()}


def implement_names() -> list[str]:
    """Return the names of everything in the catalogue that one hits a ball with."""
    return sorted({**bat_files(), **other_files()})


def implement(name: str | Path) -> Implement:
    """Return a bat, racket, club or stick by its name in the catalogue, or the one that a TOML file describes.

    Parameters
    ----------
    name : of the catalogue, as `sweetspot bats` lists them, or the path of a TOML file.

    Raises
    ------
    InputError
        for an unknown name, with the nearest ones, and for a file that describes none, with what is wrong in it.

    >>> implement("tennis-racket").sport
    'tennis'
    """
    return load_implement(str(name))


@cache
def _catalogue_implement(name: str) -> Implement:
    key, path = entry({**bat_files(), **other_files()}, name, "bat")
    return implement_from_table(read_toml(path), f"catalogue {key}")


def load_implement(name_or_path: str) -> Implement:
    """Return the implement of a TOML file, or the catalogue's of that name; see `load_bat` for what is a file."""
    if is_file(name_or_path):
        return read_implement(Path(name_or_path))
    refuse_slip(name_or_path, {**bat_files(), **other_files()})
    return _catalogue_implement(name_or_path)

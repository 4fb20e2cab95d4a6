"""Whatever one hits a ball with, by name or from a file: the bats, and the rackets, clubs and sticks."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

from sweetspot.catalog.bats import bat_files, bat_tables, load_bat, other_files, other_tables, refuse_slip
from sweetspot.catalog.files.bat import bat_of_table, read_toml
from sweetspot.catalog.files.implement import implement_of_table
from sweetspot.catalog.files.read import implement_from_table, warn_of_doubts, whole_table
from sweetspot.catalog.records import Entry, TomlTable, entry, is_file
from sweetspot.equipment.implement import Implement


@cache
def implement_tables() -> dict[str, Entry]:
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


@dataclass(frozen=True)
class Loaded:
    """An implement and the content of its file.

    Parameters
    ----------
    table : the file with what it takes from those that it is ``like``; empty: the implement has no file of its own.
    """

    implement: Implement
    table: TomlTable = field(default_factory=dict, compare=False, repr=False)


def load_implement(name_or_path: str) -> Implement:
    """Return the implement of a TOML file, or the catalogue's of that name; see `load_bat` for what is a file."""
    return loaded_implement(name_or_path).implement


def loaded_implement(name_or_path: str) -> Loaded:
    """Load an implement by its name or file; see `load_implement`."""
    if is_file(name_or_path):
        table = whole_table(Path(name_or_path))
        implement = implement_of_table(table, name_or_path)
        warn_of_doubts(implement)
        return Loaded(implement, table)
    refuse_slip(name_or_path, {**bat_files(), **other_files()})
    return Loaded(_catalogue_implement(name_or_path))


def loaded_bat(name_or_path: str) -> Loaded:
    """Load a round bat by its name or file and refuse any other implement; see `load_bat`."""
    if not is_file(name_or_path):
        return Loaded(load_bat(name_or_path))
    table = whole_table(Path(name_or_path))
    described = bat_of_table(table, name_or_path)
    warn_of_doubts(described)
    return Loaded(described, table)

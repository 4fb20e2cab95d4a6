"""Bats by name or from a file."""

from __future__ import annotations

from collections.abc import Container
from functools import cache
from pathlib import Path

from sweetspot.catalog.files.bat import read_toml
from sweetspot.catalog.files.read import bat_from_table, read_bat
from sweetspot.catalog.records import FOLDER, Entry, canonical, entry, is_file
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.shell import Stations
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import LONGEST_NAME, near_file

BAT_FOLDER, IMPLEMENT_FOLDER = FOLDER / "bats", FOLDER / "implements"
DEFAULT_BAT = "r161-ash"
WALL_DOUBT = 0.10
"""Part by which a barrel's wall may be thinner or thicker than the catalogue's: no maker publishes one [our choice]."""


@cache
def bat_files() -> dict[str, Path]:
    """Return every bat file of the catalogue by name."""
    return _files(BAT_FOLDER)


@cache
def other_files() -> dict[str, Path]:
    """Return every file of a racket, club or stick in the catalogue by name."""
    return _files(IMPLEMENT_FOLDER)


def _files(folder: Path) -> dict[str, Path]:
    return {canonical(path.stem): path for path in sorted(folder.glob("*.toml"))}


@cache
def bat_tables() -> dict[str, Entry]:
    """Return every bat file of the catalogue as written, by name."""
    return {name: Entry(name, read_toml(path)) for name, path in bat_files().items()}


@cache
def other_tables() -> dict[str, Entry]:
    """Return every file of a racket, club or stick in the catalogue as written, by name."""
    return {name: Entry(name, read_toml(path)) for name, path in other_files().items()}


def bat_names() -> list[str]:
    """Return the names of all bats in the catalogue."""
    return sorted(bat_files())


def bat(name: str | Path = DEFAULT_BAT) -> Bat:
    """Return a bat of the catalogue by its name, or the bat of a TOML file; see `is_file` for what is a file.

    Parameters
    ----------
    name : of the catalogue, as `sweetspot bats` lists them, or the path of a TOML file.

    Raises
    ------
    InputError
        for an unknown name, with the nearest ones, and for a file that describes no bat, with what is wrong in it.

    >>> bat("r161-ash").name
    'R161, white ash'
    """
    return read_bat(Path(name)) if is_file(str(name)) else _catalogue_bat(str(name))


@cache
def _catalogue_bat(name: str) -> Bat:
    key, path = entry(bat_files(), name, "bat")
    return bat_from_table(read_toml(path), f"catalogue bat {key}")


def load_bat(name_or_path: str) -> Bat:
    """Return the bat of a TOML file, or the catalogue's bat of that name; see `is_file` for what is a file.

    A racket, club or stick is refused.
    """
    other = other_files().get(canonical(name_or_path))
    if other is None or is_file(name_or_path):
        refuse_slip(name_or_path, bat_files())
        return bat(name_or_path)
    return bat_from_table(read_toml(other), name_or_path)


def refuse_slip(name_or_path: str, entries: Container[str]) -> None:
    """Refuse a file's name that no file has and no bat of the catalogue; name the file that is spelled almost so."""
    if is_file(name_or_path) or canonical(name_or_path) in entries:
        return
    path = Path(name_or_path)
    near = near_file(path)
    neither = f"{name_or_path[:LONGEST_NAME]!r} is neither a file nor in the catalogue"
    if near is not None and near.suffix.lower() == ".toml":
        raise InputError(f"{neither}. Did you mean the file {near}?")
    if path.suffix[1:].isalpha():  # no name of the catalogue ends like a file's
        raise InputError(
            f"{neither}: there is no such file here. Bat files end in .toml; `sweetspot bats` lists the catalogue"
        )


def wall_pattern(bat: Bat) -> str | None:
    """Return the name of the catalogue's bat whose wall a hollow bat has; None: it is solid, or has one of its own.

    Such a wall was not measured on this bat, however its weight and its balance point were.

    >>> wall_pattern(bat("college-alloy").replaced(mass=0.85)), wall_pattern(bat())
    ('college-alloy', None)
    """
    shell = bat.drawn_shell or bat.shell
    return None if shell is None else _names_by_wall().get(shell.wall)


def wall_doubt(bat: Bat) -> float:
    """Return the part by which a bat's wall may be thinner or thicker, being the catalogue's; 0: it is its own."""
    return WALL_DOUBT if wall_pattern(bat) else 0.0


@cache
def _names_by_wall() -> dict[Stations, str]:
    drawn = {name: (each.drawn_shell or each.shell) for name in bat_names() for each in (bat(name),)}
    return {shell.wall: name for name, shell in drawn.items() if shell is not None}

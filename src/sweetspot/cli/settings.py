"""What somebody wants whenever nothing else is said: a small file of units and of the own bat."""

from __future__ import annotations

import os
import sys
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from sweetspot.errors import InputError, nearest_names

PLACE = "SWEETSPOT_CONFIG"
"""Environment variable with the file's name; set and empty: there is none."""
KEYS = ("units", "bat")
SYSTEMS: dict[object, Literal["us", "si"]] = {"us": "us", "imperial": "us", "si": "si", "metric": "si"}


@dataclass(frozen=True)
class Settings:
    """Defaults of a person; ``bat`` is a name of the catalogue or a file, seen from the folder of the settings."""

    units: Literal["us", "si"] | None = None
    bat: str | None = None


USUAL = Settings()
SETTINGS: ContextVar[Settings] = ContextVar("SETTINGS", default=USUAL)


def settings_file() -> Path | None:
    """Return the path of the settings; None: there are none."""
    if PLACE in os.environ:
        return Path(os.environ[PLACE]) if os.environ[PLACE] else None
    if sys.platform == "win32":
        folder = os.environ.get("APPDATA", "")
    else:
        folder = os.environ.get("XDG_CONFIG_HOME", "") or f"{os.environ.get('HOME', '')}/.config"
    return Path(folder) / "sweetspot" / "config.toml" if Path(folder).is_absolute() else None


def read_settings() -> Settings:
    """Return a person's settings; the usual ones where there is no such file.

    Raises
    ------
    InputError
        for a file that cannot be read, and a key or value that means nothing.
    """
    path = settings_file()
    if path is None or not path.is_file():
        return Settings()
    from sweetspot.catalog.files.bat import read_toml

    table = read_toml(path)
    for key in table:
        if key not in KEYS:
            raise InputError(f"settings {path}: {key!r} is not known. {nearest_names(key, KEYS)}")
    units, bat = table.get("units"), table.get("bat")
    if units is not None and units not in SYSTEMS:
        raise InputError(f'settings {path}: units was given as {units!r}; allowed is "metric" or "imperial"')
    if bat is not None and not isinstance(bat, str):
        raise InputError(
            f"settings {path}: bat was given as {bat!r}; write a name of the catalogue or a file in quotes"
        )
    beside = bat is not None and (path.parent / bat).is_file()
    return Settings(None if units is None else SYSTEMS[units], str(path.parent / bat) if beside and bat else bat)

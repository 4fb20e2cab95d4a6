"""Parks by name, by an old name, or by the team that plays there."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

from sweetspot.catalog.records import canonical, quantity, read_table, unwrapped
from sweetspot.errors import InputError, nearest_names
from sweetspot.flight.park import Park
from sweetspot.units import FOOT

FILE, FORMER = "parks.toml", "former_parks.toml"


def park_names() -> list[str]:
    """Return the names of the parks of today."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def park(name: str, year: int | None = None) -> Park:
    """Return a park by its name or the beginning of it, an older name, its team or the team's letters.

    Parameters
    ----------
    year : season; a team's name or letters then mean the park it played in. None: the park of today, or the last one
        of a club that has moved.

    Raises
    ------
    InputError
        for an unknown one, with the nearest names.

    >>> park("wrigley").name, park("Minute Maid Park").name, park("yankees").team
    ('Wrigley Field', 'Daikin Park', 'New York Yankees')
    >>> park("OAK").name, park("TB").name, park("TB", 2025).name
    ('Oakland Coliseum', 'Tropicana Field', 'George M. Steinbrenner Field')
    """
    wanted = canonical(name)
    left = [
        entry
        for entry in read_table(FORMER).values()
        if year is not None and entry["from"] <= year <= entry["until"]
        if wanted in {canonical(word) for word in (entry["team"], *entry["also"], *entry["club"])}
    ]
    if left:
        return _park(left[0])
    known = _keys()
    begun = {key for word, key in known.items() if word == wanted or word.startswith(f"{wanted}-")}
    if wanted not in known and len(begun) != 1:
        raise InputError(
            f"park {name!r} is not in the catalogue. {nearest_names(wanted, list(known))} "
            "A team's name or letters do too; `sweetspot parks` lists all."
        )
    return _park((read_table(FILE) | read_table(FORMER))[known.get(wanted) or begun.pop()])


@cache
def parks() -> tuple[Park, ...]:
    """Return the parks of today, one for each club, in the order of their names."""
    return tuple(park(name) for name in park_names())


@cache
def _keys() -> dict[str, str]:
    """Return the catalogue's key by every name that is understood."""
    found: dict[str, str] = {}
    for key, entry in read_table(FILE).items():
        for name in (key, entry["name"], entry["team"], *entry["also"]):
            assert found.setdefault(canonical(name), key) == key, f"parks.toml: {name} means two parks"
    for key, entry in read_table(FORMER).items():  # a club that is still there means its park of today
        for name in (key, entry["name"], *entry["also"]):
            assert found.setdefault(canonical(name), key) == key, f"former_parks.toml: {name} means two parks"
    return found


def former_park_names() -> list[str]:
    """Return the names of the parks that clubs have left."""
    return [canonical(name) for name in read_table(FORMER)]


def _park(entry: dict[str, Any]) -> Park:
    fence = entry["fence"]
    vertices = zip(
        np.radians(fence["direction_deg"]),
        FOOT * np.array(fence["distance_ft"], float),
        FOOT * np.array(fence["height_ft"], float),
        strict=True,
    )
    elevation = quantity(entry, "elevation", "length", entry["name"])
    assert elevation is not None, f"parks.toml: {entry['name']} lacks elevation"
    return Park(
        name=entry["name"],
        team=entry["team"],
        city=entry["city"],
        elevation=elevation,
        roof=unwrapped(entry["roof"]),
        fence=tuple((float(direction), float(far), float(high)) for direction, far, high in vertices),
    )

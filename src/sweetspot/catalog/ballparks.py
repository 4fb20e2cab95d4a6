"""Parks by name, by an old name, or by the team that plays there."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import cache

import numpy as np

from sweetspot.catalog.records import Entry, canonical, read_table
from sweetspot.errors import InputError, nearest_names
from sweetspot.flight.park import Park
from sweetspot.units import FOOT

FILE, FORMER, FIELDS = "parks.toml", "former_parks.toml", "fields.toml"
ARC_STEP = 5
"""Degrees between the vertices of a field's fence."""


def park_names() -> list[str]:
    """Return the names of the parks of today."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def park(name: str, year: int | None = None) -> Park:
    """Return a park by its name or the beginning of it, an older name, its team or the team's letters.

    Raises `InputError` for an unknown one, with the nearest names.

    Parameters
    ----------
    year : season; a team's name or letters then mean the park it played in. None: the park of today, or the last one
        of a club that has moved.

    >>> park("wrigley").name, park("Minute Maid Park").name, park("yankees").team
    ('Wrigley Field', 'Daikin Park', 'New York Yankees')
    >>> park("little league").name, round(park("little league").distance_at(0.3) / FOOT)
    ('Little League field', 200)
    >>> park("OAK").name, park("TB").name, park("TB", 2025).name
    ('Oakland Coliseum', 'Tropicana Field', 'George M. Steinbrenner Field')
    >>> park("OAK", 2024).name, park("OAK", 2025).name
    ('Oakland Coliseum', 'Sutter Health Park')
    """
    wanted = canonical(name)
    fields = read_table(FIELDS).items()
    field = next((key for key, table in fields if wanted in {key, *map(canonical, table.texts("also"))}), None)
    if field is not None:
        return _field(field)
    left = [
        entry
        for entry in read_table(FORMER).values()
        if year is not None and entry.number("from") <= year <= entry.number("until")
        if wanted in {canonical(word) for word in (entry.text("team"), *entry.texts("also"), *entry.texts("club"))}
    ]
    if left:
        return _park(left[0])
    moved = [
        entry.text("moved_to")
        for entry in read_table(FORMER).values()
        if year is not None and "moved_to" in entry and year > entry.number("until")
        if wanted in {canonical(word) for word in (entry.text("team"), entry.texts("also")[0])}
    ]
    if moved:
        return _park(read_table(FILE)[moved[0]])
    keys = _keys()
    begun = {key for word, key in keys.items() if word == wanted or word.startswith(f"{wanted}-")}
    if wanted not in keys and len(begun) != 1:
        names = sorted({*keys, *read_table(FIELDS), *(word.partition("-")[0] for word in keys)})  # coors does too
        raise InputError(
            f"park {name!r} is not in the catalogue. {nearest_names(wanted, names)} "
            "A team's name or letters do too; `sweetspot parks` lists all."
        )
    return _park({**read_table(FILE), **read_table(FORMER)}[keys.get(wanted) or begun.pop()])


@cache
def parks() -> tuple[Park, ...]:
    """Return the parks of today, one for each club, in the order of their names."""
    return tuple(park(name) for name in park_names())


@cache
def parks_of_season(year: int | None) -> tuple[Park, ...]:
    """Return the parks where the thirty clubs of today played in a season, in the order of `parks`; None: today.

    >>> [one.name for one in parks_of_season(2025) if one.team == "Tampa Bay Rays"]
    ['George M. Steinbrenner Field']
    """
    return tuple(park(entry.texts("also")[0], year) for entry in read_table(FILE).values())


@cache
def _keys() -> dict[str, str]:
    """Return the catalogue's key by every name that is understood."""
    keys: dict[str, str] = {}
    for key, entry in read_table(FILE).items():
        for name in (key, entry.name, entry.text("team"), *entry.texts("also")):
            assert keys.setdefault(canonical(name), key) == key, f"parks.toml: {name} means two parks"
    for key, entry in read_table(FORMER).items():  # a club that is still there means its park of today
        for name in (key, entry.name, *entry.texts("also")):
            assert keys.setdefault(canonical(name), key) == key, f"former_parks.toml: {name} means two parks"
    return keys


def field_names() -> list[str]:
    """Return the names of the fields of other leagues, whose fences have recommended or usual distances."""
    return [canonical(name) for name in read_table(FIELDS)]


def _field(key: str) -> Park:
    """Return a field whose fence is an arc of a circle through both foul poles and centre field."""
    field = read_table(FIELDS)[key]
    line, centre, high = (field.quantity(name, "length") for name in ("foul_lines", "centre", "height"))
    # a circle about (0, c) of radius centre - c passes the pole at line / sqrt(2) (1, 1)
    along = line / math.sqrt(2)
    middle = (centre**2 - line**2) / (2 * (centre - along))
    turns = [math.radians(turn) for turn in range(-45, 46, ARC_STEP)]
    far = [
        middle * math.cos(turn) + math.sqrt((centre - middle) ** 2 - (middle * math.sin(turn)) ** 2) for turn in turns
    ]
    return Park(
        name=field.name,
        team=field.text("league"),
        city="",
        elevation=0.0,
        fence=tuple((turn, distance, high) for turn, distance in zip(turns, far, strict=True)),
    )


def fenced_field(distances: Sequence[float], *, height: float, elevation: float = 0.0) -> Park:
    """Return a field that is known by some distances of its fence.

    ``distances``: m from home plate, at even angles from the left foul pole to the right one, at least two; between
    them the fence curves smoothly and is nowhere farther or nearer than those beside it. ``height``: m, the same all
    along. ``elevation``: m above the sea.

    >>> field = fenced_field([100.6, 121.9, 100.6], height=2.4)
    >>> [round(field.distance_at(math.radians(turn)), 1) for turn in (-45, 0, 20)]
    [100.6, 121.9, 117.7]
    """
    if len(distances) < 2:
        raise InputError("a fence needs two distances or more, from the left foul pole to the right one")
    from scipy.interpolate import PchipInterpolator

    turns = np.radians(np.arange(-45, 46, ARC_STEP))
    far = PchipInterpolator(np.linspace(turns[0], turns[-1], len(distances)), distances)(turns)
    fence = tuple((float(turn), float(distance), height) for turn, distance in zip(turns, far, strict=True))
    return Park(name="own field", elevation=elevation, fence=fence)


def _park(entry: Entry) -> Park:
    fence = entry.table("fence")
    direction = np.radians(fence.numbers("direction_deg"))
    far, high = (FOOT * np.array(fence.numbers(column), float) for column in ("distance_ft", "height_ft"))
    return Park(
        name=entry.name,
        team=entry.text("team"),
        city=entry.text("city"),
        elevation=entry.quantity("elevation", "length"),
        covered=entry.number("covered"),
        fence=tuple(zip(direction.tolist(), far.tolist(), high.tolist(), strict=True)),
    )

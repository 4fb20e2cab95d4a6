"""A first file for an implement of one's own, from what its owner knows without tools."""

from __future__ import annotations

import tomllib
from dataclasses import dataclass

from sweetspot.catalog.bats import bat
from sweetspot.catalog.files.implement import implement_of_table
from sweetspot.catalog.files.like import resolved
from sweetspot.catalog.materials import material
from sweetspot.catalog.sports import sport as sport_of
from sweetspot.catalog.sports import sport_implements
from sweetspot.errors import InputError, nearest_names
from sweetspot.plausibility import parse

PARENTS: dict[str, dict[str, tuple[str, ...]]] = {
    "baseball": {
        "wood": ("r161-ash", "youth-30"),
        "metal": ("college-alloy", "youth-alloy"),
        "composite": ("composite",),
        "two-piece": ("two-piece",),
    },
    "softball": {"composite": ("fast-pitch",)},
    "slow-pitch": {"composite": ("slow-pitch",)},
}
"""Bats of the catalogue that stand for others of their sport and make; the nearest in length is taken."""
WORDS = {
    "alloy": "metal", "aluminum": "metal", "aluminium": "metal", "wooden": "wood", "ash": "white-ash", "maple":
    "sugar-maple", "birch": "yellow-birch", "carbon": "composite", "fastpitch": "softball", "slowpitch": "slow-pitch",
}  # fmt: skip
"""What people say, and how the catalogue calls it."""


@dataclass(frozen=True)
class Facts:
    """What somebody knows of an own implement: texts with units; "": not facts."""

    sport: str = "baseball"
    built: str = "wood"
    length: str = ""
    mass: str = ""
    balance_point: str = ""
    barrel: str = ""
    name: str = ""


def new_file(facts: Facts, file: str = "my-bat.toml") -> str:
    """Return a file for an implement, like the catalogue's that is nearest to it; ``file``: its name.

    Raises
    ------
    InputError
        for a sport or make that the catalogue has nothing for, and for sizes that cannot be.

    >>> print(new_file(Facts(built="maple", length="34 in", mass="31.5 oz")), end="")
    # sweetspot report my-bat.toml
    like = "r161-ash"            # of the catalogue: what stands here is this bat's own, the rest is taken from it
    name = "my bat"
    length = "34 in"
    mass = "31.5 oz"
    material = "sugar-maple"
    """
    sport = _word(facts.sport)
    lines, made = _parent_lines(sport, _word(facts.built), facts)
    lines.insert(0, f"# sweetspot report {file}")
    sizes = {"length": facts.length, "mass": facts.mass, "balance_point": facts.balance_point}
    for name, text in sizes.items():
        if text.strip():
            parse(text, "mass" if name == "mass" else "length", name.replace("_", " "))
            lines.append(f'{name} = "{text.strip()}"')
    text = "\n".join([*lines, *made]) + "\n"
    _check(text)
    return text


def _word(text: str) -> str:
    word = text.strip().lower().replace(" ", "-")
    return WORDS.get(word, word)


def _parent_lines(sport: str, built: str, facts: Facts) -> tuple[list[str], list[str]]:
    """Return the first lines of a file, and those on its material and outline."""
    if sport not in PARENTS:
        return _first_lines(sport_implements(sport)[0], facts, sport_of(sport).words.implement), []
    makes, wood = PARENTS[sport], ""
    if built not in makes:
        if "wood" not in makes or material(built).family != "wood":
            raise InputError(f"built of {built!r} is not known in {sport}. {nearest_names(built, [*makes])}")
        built, wood = "wood", built
    length = parse(facts.length, "length", "length") if facts.length.strip() else bat(makes[built][0]).length
    parent = min(makes[built], key=lambda name: abs(bat(name).length - length))
    made = [f'material = "{wood}"'] if wood and wood != "white-ash" else []
    if facts.barrel.strip():
        parse(facts.barrel, "length", "barrel")
        if built != "wood":
            raise InputError("a barrel's diameter shapes a bat of wood; a hollow bat keeps the catalogue's outline")
        made.append(_turned(facts.barrel.strip(), length))
    return _first_lines(parent, facts, "bat"), made


def _turned(barrel: str, length: float) -> str:
    """Return an outline by its greatest diameter; the other sizes are those of most bats (assumed)."""
    start, end = (f"{part * length / 0.0254:.1f} in" for part in (0.36, 0.76))
    return f'turned = {{ handle = "0.95 in", barrel = "{barrel}", taper_start = "{start}", taper_end = "{end}" }}'


def _first_lines(parent: str, facts: Facts, thing: str) -> list[str]:
    note = f"# of the catalogue: what stands here is this {thing}'s own, the rest is taken from it"
    name = facts.name.strip() or f"my {thing}"
    return [f'like = "{parent}"'.ljust(29) + note, f'name = "{name}"']


def _check(text: str) -> None:
    """Refuse what makes no implement."""
    where = "this answer"
    implement_of_table(resolved(tomllib.loads(text), where), where)

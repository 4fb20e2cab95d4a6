"""Any implement at another length, as makers offer a model in several: it stretches along itself, not across."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Shell, Stations
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError


def stretched(implement: Implement, length: float) -> Implement:
    """Return an implement of another length (m); what was measured of it is gone, but for a racket's.

    A racket keeps its head and its handle; its frame between them is longer. A club keeps its head and its grip.

    Raises
    ------
    InputError
        for a bat without an outline, or a kind that is not known.
    """
    places = KINDS.get(type(implement))
    if places is None:
        raise InputError(f"{implement.name} is of a kind that cannot be stretched; describe it in a file")
    return implement.replaced(length=length, **places(implement, length))


def _moved(stations: Stations, part: float) -> Stations:
    return tuple((place * part, size) for place, size in stations)


def _bat(bat: Bat, length: float) -> dict[str, Any]:
    if bat.profile is None:
        raise InputError(f"{bat.name} has no outline to stretch; give the profile of the longer or shorter one")
    part = length / bat.length
    places: dict[str, Any] = {
        "profile": _moved(bat.profile, part),
        "point_masses": tuple(mass.replaced(position=mass.position * part) for mass in bat.point_masses),
        "mass": None, "balance_point": None, "moi": None, "original": None,
        "drawn_shell": None,
    }  # fmt: skip
    return places if bat.shell is None else {**places, "shell": _shell(bat.shell, part)}


def _shell(shell: Shell, part: float) -> Shell:
    sleeve = shell.inner_wall
    return shell.replaced(
        wall=_moved(shell.wall, part),
        inner_wall=None if sleeve is None else sleeve.replaced(wall=_moved(sleeve.wall, part)),
        joint=None if shell.joint is None else shell.joint * part,
        rings=tuple(ring.replaced(position=ring.position * part) for ring in shell.rings),
    )


def _cricket_bat(bat: CricketBat, length: float) -> dict[str, Any]:
    part = length / bat.length
    stations = {name: _moved(getattr(bat, name), part) for name in ("handle", "width", "spine", "edge")}
    return {**stations, "splice": bat.splice * part, "mass": None, "balance_point": None, "moi": None}


def _hockey_stick(stick: HockeyStick, length: float) -> dict[str, Any]:
    part = length / stick.length
    stations = {name: _moved(getattr(stick, name), part) for name in ("width", "depth", "wall")}
    return {**stations, "face_start": stick.face_start * part, "mass": None, "balance_point": None, "moi": None}


def _table_tennis_racket(racket: TableTennisRacket, length: float) -> dict[str, Any]:
    blade = racket.blade_length * length / racket.length
    return {"blade_length": blade, "mass": None, "balance_point": None, "moi": None}


def _golf_club(club: GolfClub, length: float) -> dict[str, Any]:
    part = (length - club.head.height) / club.shaft_end
    return {name: _moved(getattr(club, name), part) for name in ("diameter", "wall")}


def _racket(racket: Racket, length: float) -> dict[str, Any]:
    longer, part = length - racket.length, length / racket.length
    head, stiffness = racket.head, racket.relative_stiffness
    assert racket.mass is not None and racket.balance_point is not None and racket.moi is not None
    balance = racket.balance_point * part
    about_centre = racket.moi - racket.mass * (racket.balance_point - racket.moi_axis) ** 2
    return {
        "head": head.replaced(start=head.start + longer, end=head.end + longer),
        "relative_stiffness": None if stiffness is None else _moved(stiffness, part),
        "balance_point": balance,
        "moi": about_centre * part**2 + racket.mass * (balance - racket.moi_axis) ** 2,
    }


KINDS: dict[type[Implement], Callable[[Any, float], dict[str, Any]]] = {
    Bat: _bat,
    CricketBat: _cricket_bat,
    HockeyStick: _hockey_stick,
    TableTennisRacket: _table_tennis_racket,
    GolfClub: _golf_club,
    Racket: _racket,
}
"""Stretching of every kind of implement to another length."""

"""Any implement as the text of its file, in SI and to the last digit."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from sweetspot.catalog.files.write import bat_table, length_text, material_key, pairs_text, plies_text
from sweetspot.catalog.rubbers import rubber_key
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError


def implement_toml(implement: Implement) -> str:
    """Return the text of the file that describes an implement.

    Raises
    ------
    InputError
        for a kind that is not written, or a material that no file can name.
    """
    import tomli_w

    return tomli_w.dumps(implement_table(implement))


def implement_table(implement: Implement) -> dict[str, Any]:
    """Return the file's content as `sweetspot.catalog.files.read.implement_from_table` takes it.

    Raises
    ------
    InputError
        see `implement_toml`.
    """
    if isinstance(implement, Bat):
        return bat_table(implement)
    for kind, (made, table) in KINDS.items():
        if isinstance(implement, made):
            return {"kind": kind, **_common(implement), **table(implement)}
    raise InputError(f"{implement.name} is of a kind whose file is not written; write it by hand")


def _common(implement: Implement) -> dict[str, Any]:
    weights = [
        {"position": length_text(one.position), "mass": f"{one.mass!r} kg", "beside": length_text(one.lateral)}
        for one in implement.added
    ]
    return {
        "name": implement.name,
        "sport": implement.sport,
        "length": length_text(implement.length),
        **_given(mass=(implement.mass, "kg"), balance_point=(implement.balance_point, "m")),
        **_given(moi=(implement.moi, "kg*m^2")),
        "moi_axis": length_text(implement.moi_axis),
        **({"fitted": list(implement.fitted)} if implement.fitted else {}),
        "choke": length_text(implement.choke),
        **({"point_mass": weights} if weights else {}),
        **({} if implement.original is None else {"original": implement_table(implement.original)}),
    }


def _cricket_bat(bat: CricketBat) -> dict[str, Any]:
    return {
        "material": material_key(bat.material),
        "handle_material": material_key(bat.handle_material),
        **{name: pairs_text(getattr(bat, name)) for name in ("handle", "width", "spine", "edge")},
        "concavity": bat.concavity,
        "splice": length_text(bat.splice),
        "grip_mass": f"{bat.grip_mass!r} kg",
        **_given(first_frequency=(bat.first_frequency, "Hz")),
    }


def _hockey_stick(stick: HockeyStick) -> dict[str, Any]:
    return {
        "material": material_key(stick.material),
        **{name: pairs_text(getattr(stick, name)) for name in ("width", "depth", "wall")},
        **{name: length_text(getattr(stick, name)) for name in ("face_start", "grip_length", "hook_reach")},
        **{name: f"{getattr(stick, name)!r} kg" for name in ("grip_mass", "hook_mass")},
        **_given(first_frequency=(stick.first_frequency, "Hz")),
    }


def _racket(racket: Racket) -> dict[str, Any]:
    head, bed = racket.head, racket.bed
    stiffness = racket.relative_stiffness
    return {
        "head": {
            "length": length_text(head.end - head.start),
            "width": length_text(head.width),
            "rim": length_text(racket.length - head.end),
        },
        "strings": {
            "tension": f"{bed.tension!r} N",
            "mains": bed.mains,
            "crosses": bed.crosses,
            "linear_density": f"{bed.linear_density!r} kg/m",
            "restitution": bed.restitution,
            "patch": length_text(bed.patch),
        },
        "first_frequency": f"{racket.first_frequency!r} Hz",
        "damping": racket.damping,
        "handle_length": length_text(racket.handle_length),
        **({} if stiffness is None else {"relative_stiffness": [[length_text(at), size] for at, size in stiffness]}),
        **_given(twist_moi=(racket.twist_moi, "kg*m^2"), greatest_tension=(racket.greatest_tension, "N")),
        "frame": racket.frame,
    }


def _table_tennis_racket(racket: TableTennisRacket) -> dict[str, Any]:
    sides = {"front": racket.front, "back": racket.back}
    return {
        "blade": plies_text(racket.blade),
        **{name: length_text(getattr(racket, name))
           for name in ("blade_length", "blade_width", "handle_width", "handle_thickness")},
        "handle_material": material_key(racket.handle_material),
        **{side: rubber_key(one) for side, one in sides.items() if one is not None},
        "damping": racket.damping,
    }  # fmt: skip


def _golf_club(club: GolfClub) -> dict[str, Any]:
    head, face = club.head, club.head.face
    return {
        "material": material_key(club.material),
        "diameter": pairs_text(club.diameter),
        "wall": pairs_text(club.wall),
        "grip_mass": f"{club.grip_mass!r} kg",
        "grip_length": length_text(club.grip_length),
        **_given(first_frequency=(club.first_frequency, "Hz")),
        "head": {
            "mass": f"{head.mass!r} kg",
            "height": length_text(head.height),
            "face_width": length_text(head.face_width),
            "moi": f"{head.moi!r} kg*m^2",
            "roll_moi": f"{head.roll_moi!r} kg*m^2",
            **_given(face_stiffness=(face.stiffness, "N/m"), face_mass=(face.moving_mass, "kg")),
            "face_restitution": face.restitution,
        },
    }


def _given(**values: tuple[float | None, str]) -> dict[str, str]:
    return {name: f"{value!r} {unit}" for name, (value, unit) in values.items() if value is not None}


KINDS: dict[str, tuple[type[Implement], Callable[[Any], dict[str, Any]]]] = {
    "racket": (Racket, _racket),
    "cricket-bat": (CricketBat, _cricket_bat),
    "golf-club": (GolfClub, _golf_club),
    "hockey-stick": (HockeyStick, _hockey_stick),
    "table-tennis-racket": (TableTennisRacket, _table_tennis_racket),
}
"""What is written, by what its file calls it."""

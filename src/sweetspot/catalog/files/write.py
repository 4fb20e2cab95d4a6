"""A bat as the text of a bat file, in SI and to the last digit: reading it gives the same bat."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from sweetspot.catalog.materials import keys_by_name, material, rubber_key
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.laminate import Laminate
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Shell, Stations
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError

OWN_VALUES = {
    "density": "kg/m^3",
    "longitudinal_modulus": "Pa",
    "shear_modulus": "Pa",
    "transverse_modulus": "Pa",
    "poisson_ratio": "",
    "damping_ratio": "",
    "laminated": "",
}
"""What a [material] table may set on its own, with the unit it is written in."""


def bat_toml(bat: Bat) -> str:
    """Return the bat file's text."""
    import tomli_w

    return tomli_w.dumps(bat_table(bat))


def bat_table(bat: Bat) -> dict[str, Any]:
    """Return the bat file's content as `sweetspot.catalog.files.read.bat_from_table` takes it.

    Raises
    ------
    InputError
        when the bat holds a material that no bat file can describe.
    """
    table: dict[str, Any] = {"name": bat.name, "length": length_text(bat.length), "material": _material(bat.material)}
    if bat.profile is not None:
        table["profile"] = pairs_text(bat.profile)
    if bat.linear_density is not None:
        table["linear_density"] = list(bat.linear_density)
    if bat.density_gradient:
        table["density_gradient"] = bat.density_gradient
    measured = {
        "mass": _with(bat.mass, "kg"),
        "balance_point": _with(bat.balance_point, "m"),
        "moi": _with(bat.moi, "kg*m^2"),
        "moi_axis": None if bat.moi is None else length_text(bat.moi_axis),
        "fitted": list(bat.fitted) or None,
        "choke": length_text(bat.choke) if bat.choke else None,
        "sport": None if bat.sport == Bat.model_fields["sport"].default else bat.sport,
    }
    table |= {name: value for name, value in measured.items() if value is not None}
    if bat.cup is not None:
        table["cup"] = {"diameter": length_text(bat.cup.diameter), "depth": length_text(bat.cup.depth)}
    if bat.shell is not None:
        table["shell"] = _shell(bat.shell)
    if bat.bores:
        table["bore"] = [
            {
                "diameter": length_text(bore.diameter),
                "depth": length_text(bore.depth),
                **({"fill": material_key(bore.fill)} if bore.fill is not None else {}),
                "plug": length_text(bore.plug),
            }
            for bore in bat.bores
        ]
    if bat.point_masses:
        table["point_mass"] = [
            {
                "position": length_text(weight.position),
                "mass": f"{weight.mass!r} kg",
                **({"on_surface": True} if weight.on_surface else {}),
            }
            for weight in bat.point_masses
        ]
    if bat.original is not None:
        table["original"] = bat_table(bat.original)
    return table


def legible(text: str, *, digits: int = 9) -> str:
    r"""Return a bat file with its lengths in m and masses in kg to so many decimals, for people who go on in it.

    Nine are a nanometre and a microgram. A place and what is there stand on one line.

    >>> legible('length = "0.8635999999999999 m"')
    'length = "0.8636 m"'
    >>> print(legible('profile = [\n    [\n        "0.0 m",\n        "0.042 m",\n    ],\n]'))
    profile = [
        ["0 m", "0.042 m"],
    ]
    """
    short = re.sub(
        r'"(\d+\.\d+) (m|kg)"',
        lambda found: f'"{float(found[1]):.{digits}f}'.rstrip("0").rstrip(".") + f' {found[2]}"',
        text,
    )
    return re.sub(r'\[\s*("[^"\n]*"),\s*("[^"\n]*"),\s*\]', r"[\1, \2]", short)


def _shell(shell: Shell) -> dict[str, Any]:
    table: dict[str, Any] = {"wall": pairs_text(shell.wall)}
    if shell.laminate is not None:
        table["laminate"] = plies_text(shell.laminate)
    if shell.handle_material is not None:
        table["handle_material"] = material_key(shell.handle_material)
    if shell.joint is not None:
        table["joint"] = length_text(shell.joint)
    masses = {"joint_mass": shell.joint_mass, "end_cap_mass": shell.end_cap_mass, "knob_mass": shell.knob_mass}
    table |= {name: f"{mass!r} kg" for name, mass in masses.items() if mass}
    sleeve = shell.inner_wall
    if sleeve is not None:
        table["inner_wall"] = {
            "wall": pairs_text(sleeve.wall),
            "material": material_key(sleeve.material),
            **({"laminate": plies_text(sleeve.laminate)} if sleeve.laminate is not None else {}),
            "gap": length_text(sleeve.gap),
            "bonded": sleeve.bonded,
        }
    if shell.rings:
        table["ring"] = [
            {
                "position": length_text(ring.position),
                "width": length_text(ring.width),
                **({"depth": length_text(ring.depth)} if ring.depth is not None else {}),
                "material": material_key(ring.material),
            }
            for ring in shell.rings
        ]
    return table


def plies_text(laminate: Laminate) -> list[dict[str, str]]:
    """Return the plies of a laminate as a file has them."""
    return [
        {"material": material_key(ply.material), "angle": f"{ply.angle!r} rad", "thickness": length_text(ply.thickness)}
        for ply in laminate.plies
    ]


def _material(own: Material) -> str | dict[str, Any]:
    """Return a material's name, or a table of what it has of its own where the catalogue's values were changed."""
    key = _key(own)
    known = material(key)
    if own == known:
        return key
    changed = {name: getattr(own, name) for name in OWN_VALUES if getattr(own, name) != getattr(known, name)}
    if known.of_density(own.density).replaced(**changed) != own or None in changed.values():
        raise InputError(f"{own.name} differs from the catalogue's in ways that a bat file cannot describe")
    values = {name: f"{value!r} {unit}" if (unit := OWN_VALUES[name]) else value for name, value in changed.items()}
    return {"like": key, **values}


def material_key(own: Material) -> str:
    """Return the catalogue's name of a material; raises `InputError` when it differs from the catalogue's."""
    key = _key(own)
    if own != material(key):
        raise InputError(f"{own.name} differs from the catalogue's; a bat file can only name a fill, a ply or a handle")
    return key


def _key(own: Material) -> str:
    """Return the catalogue's key of a material, which its own name need not be."""
    key = keys_by_name().get(own.name)
    if key is None:
        raise InputError(f"{own.name} is not in the catalogue, so that no bat file can name it")
    return key


def pairs_text(stations: Stations) -> list[list[str]]:
    """Return pairs of positions and sizes in m as a file has them."""
    return [[length_text(position), length_text(size)] for position, size in stations]


def _with(value: float | None, unit: str) -> str | None:
    return None if value is None else f"{value!r} {unit}"


def length_text(length: float) -> str:
    """Return a length in m as a file has it, to the last digit."""
    return f"{length!r} m"


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

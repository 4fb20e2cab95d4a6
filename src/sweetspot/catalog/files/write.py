"""Any implement as the text of its file, in SI and to the last digit: reading it gives the same implement."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from sweetspot.catalog.files.bat import (
    BatFile,
    BoreTable,
    CupTable,
    InnerWallTable,
    MaterialTable,
    PlyTable,
    PointMassTable,
    RingTable,
    ShellTable,
)
from sweetspot.catalog.files.implement import KINDS, AddedTable, ClubHeadTable, HeadTable, StringsTable
from sweetspot.catalog.files.tables import FileTable, Of, PairsOf
from sweetspot.catalog.materials import keys_by_name, material, rubber_key
from sweetspot.equipment.bat import Bat, Bore, Cup, PointMass
from sweetspot.equipment.face import Rubber, StringBed
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.laminate import Laminate, Ply
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import InnerWall, Ring, Shell
from sweetspot.errors import InputError
from sweetspot.units import Kind

UNITS: Mapping[Kind, str] = {
    "length": "m",
    "mass": "kg",
    "moi": "kg*m^2",
    "force": "N",
    "frequency": "Hz",
    "stiffness": "N/m",
    "linear density": "kg/m",
    "angle": "rad",
    "density": "kg/m^3",
    "pressure": "Pa",
}
TABLES: Mapping[type, type[FileTable]] = {
    Bore: BoreTable,
    Cup: CupTable,
    Shell: ShellTable,
    InnerWall: InnerWallTable,
    Ring: RingTable,
    Ply: PlyTable,
    PointMass: PointMassTable,
    StringBed: StringsTable,
}
"""What a part is written as."""


def bat_toml(bat: Bat) -> str:
    """Return the bat file's text."""
    return implement_toml(bat)


def implement_toml(implement: Implement) -> str:
    """Return the text of the file that describes an implement.

    Raises
    ------
    InputError
        for a kind that is not written, or a material that no file can name.
    """
    import tomli_w

    return tomli_w.dumps(implement_table(implement))


def bat_table(bat: Bat) -> dict[str, Any]:
    """Return the bat file's content as `sweetspot.catalog.files.read.bat_from_table` takes it.

    Raises
    ------
    InputError
        when the bat holds a material that no bat file can describe.
    """
    values = {**_values(bat), "bore": bat.bores, "point_mass": bat.point_masses, "material": _material(bat.material)}
    if bat.moi is None:
        values["moi_axis"] = None
    if bat.sport == Bat.model_fields["sport"].default:
        values["sport"] = None
    return written(BatFile, values)


def implement_table(implement: Implement) -> dict[str, Any]:
    """Return the file's content as `sweetspot.catalog.files.read.implement_from_table` takes it.

    Raises
    ------
    InputError
        see `implement_toml`.
    """
    if isinstance(implement, Bat):
        return bat_table(implement)
    kind = re.sub("(?<=[a-z])(?=[A-Z])", "-", type(implement).__name__).lower()
    if kind not in KINDS:
        raise InputError(f"{implement.name} is of a kind whose file is not written; write it by hand")
    values = {**_values(implement), "kind": kind}
    values["point_mass"] = [
        written(AddedTable, {**_values(weight), "beside": weight.lateral}) for weight in implement.added
    ]
    if isinstance(implement, Racket):
        head = implement.head
        sizes = {"length": head.end - head.start, "width": head.width, "rim": implement.length - head.end}
        values |= {"head": written(HeadTable, sizes), "strings": implement.bed}
    elif isinstance(implement, GolfClub):
        face = implement.head.face
        plate = {"face_stiffness": face.stiffness, "face_mass": face.moving_mass, "face_restitution": face.restitution}
        values["head"] = written(ClubHeadTable, {**_values(implement.head), **plate})
    return written(KINDS[kind][0], values)


def _values(part: Any) -> dict[str, Any]:
    return {name: getattr(part, name) for name in type(part).model_fields}


def written(table: type[FileTable], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return the fields of a file's table as they are written, from values in SI; what is not there is left out.

    Parameters
    ----------
    table : whose fields say what quantity each is; see `in_si`, which reads them.
    values : by the names of its fields.
    """
    texts = {}
    for name, field in table.model_fields.items():
        value = values.get(name)
        nothing = not field.is_required() and (not field.default or str(field.default).startswith("0 "))
        if value is not None and (value or not nothing):
            texts[name] = _text(value, next(iter(field.metadata), None))
    return texts


def _text(value: Any, meaning: Any = None) -> Any:
    match value:
        case Material():
            value = material_key(value)
        case Rubber():
            value = rubber_key(value)
        case Implement():
            value = implement_table(value)
        case Laminate():
            value = _text(value.plies)
        case _ if isinstance(meaning, Of):
            value = f"{value!r} {UNITS[meaning.kind]}"
        case _ if isinstance(meaning, PairsOf):
            kinds = Of(meaning.first), None if meaning.second == "ratio" else Of(meaning.second)
            value = [[_text(part, kind) for part, kind in zip(pair, kinds, strict=True)] for pair in value]
        case tuple() | list():
            value = [_text(part) for part in value]
        case _ if type(value) in TABLES:
            value = written(TABLES[type(value)], {**_values(value), "ring": getattr(value, "rings", None)})
    return value


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


def _material(made_of: Material) -> str | dict[str, Any]:
    """Return a material's name, or a table of what it has of its own where the catalogue's values were changed."""
    key = _key(made_of)
    standard = material(key)
    if made_of == standard:
        return key
    names = MaterialTable.model_fields.keys() - {"like"}
    changed = {name: getattr(made_of, name) for name in names if getattr(made_of, name) != getattr(standard, name)}
    if standard.of_density(made_of.density).replaced(**changed) != made_of or None in changed.values():
        raise InputError(f"{made_of.name} differs from the catalogue's in ways that a bat file cannot describe")
    return written(MaterialTable, {"like": key, **changed})


def material_key(made_of: Material) -> str:
    """Return the catalogue's name of a material; raises `InputError` when it differs from the catalogue's."""
    key = _key(made_of)
    if made_of != material(key):
        raise InputError(
            f"{made_of.name} differs from the catalogue's; a bat file can only name a fill, a ply or a handle"
        )
    return key


def _key(made_of: Material) -> str:
    """Return the catalogue's key of a material, which its own name need not be."""
    key = keys_by_name().get(made_of.name)
    if key is None:
        raise InputError(f"{made_of.name} is not in the catalogue, so that no bat file can name it")
    return key

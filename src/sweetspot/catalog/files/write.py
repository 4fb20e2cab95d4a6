"""Any implement as the text of its file, in SI and to the last digit: reading it gives the same implement."""

from __future__ import annotations

import re
from collections.abc import Mapping

from sweetspot.catalog.files.bat import MEASURED, BatFile, MaterialTable
from sweetspot.catalog.files.implement import KINDS, ClubHeadTable, HeadTable
from sweetspot.catalog.files.tables import FileTable, Made, Meaning, Of, PairsOf, called, meaning_of
from sweetspot.catalog.materials import keys_by_name, material, rubber_key
from sweetspot.catalog.records import TomlValue
from sweetspot.equipment.base import Validated
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.laminate import Laminate
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.table_tennis_racket import Rubber
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
    "areal density": "kg/m^2",
}
Written = dict[str, TomlValue]


def bat_toml(bat: Bat) -> str:
    """Return the bat file's text."""
    return implement_toml(bat)


def implement_toml(implement: Implement) -> str:
    """Return the text of the file that describes an implement.

    Raises `InputError` for a kind that is not written, or a material that no file can name.
    """
    import tomli_w

    return tomli_w.dumps(implement_table(implement))


def bat_table(bat: Bat) -> Written:
    """Return the content of a bat's file; see `implement_table`."""
    left_out: dict[str, object] = {} if bat.sport != Bat.model_fields["sport"].default else {"sport": None}
    if bat.moi is None:
        left_out["moi_axis"] = None
    return written(BatFile, bat, material=_material(bat.material), **left_out)


def implement_table(implement: Implement) -> Written:
    """Return the file's content as `sweetspot.catalog.files.read.implement_from_table` takes it.

    Raises `InputError`: see `implement_toml`.
    """
    if isinstance(implement, Bat):
        return bat_table(implement)
    kind = re.sub("(?<=[a-z])(?=[A-Z])", "-", type(implement).__name__).lower()
    if kind not in KINDS:
        raise InputError(f"{implement.name} is of a kind whose file is not written; write it by hand")
    head: object = None
    if isinstance(implement, Racket):
        outline = implement.head
        size, rim = outline.end - outline.start, implement.length - outline.end
        head = written(HeadTable, outline, length=size, rim=rim)
    elif isinstance(implement, GolfClub):
        head = written(ClubHeadTable, implement.head, implement.head.face)
    return written(KINDS[kind][0], implement, kind=kind, head=head)


def written(table: type[FileTable], *parts: Validated, **given: object) -> Written:
    """Return the fields of a file's table as they are written; what is not there is left out.

    Parameters
    ----------
    parts : what is written, in SI.
    """
    texts = {}
    for name, field in table.model_fields.items():
        key = called(name, field)
        value = next((getattr(part, key) for part in parts if key in type(part).model_fields), None)
        value = given.get(name, value)
        nothing = not field.is_required() and (not field.default or str(field.default).startswith("0 "))
        if value is not None and (value or not nothing):
            texts[name] = _text(value, meaning_of(field))
    return texts


def _text(value: object, meaning: Meaning | None = None) -> TomlValue:
    match value:
        case Material():
            text: TomlValue = material_key(value)
        case Rubber():
            text = rubber_key(value)
        case Implement():
            text = implement_table(value)
        case Laminate():
            text = _text(value.plies, meaning)
        case Validated() if isinstance(meaning, Made):
            text = written(meaning.table, value)
        case tuple() if isinstance(meaning, PairsOf):
            kinds = Of(meaning.first), None if meaning.second == "ratio" else Of(meaning.second)
            text = [[_text(part, kind) for part, kind in zip(pair, kinds, strict=True)] for pair in value]
        case tuple():
            text = [_text(part, meaning) for part in value]
        case float() if isinstance(meaning, Of):
            text = f"{value!r} {UNITS[meaning.kind]}"
        case dict() | str() | int() | float():
            text = value
        case _:
            raise TypeError(f"no file holds a {type(value).__name__}")
    return text


def changes_table(implement: Implement, pattern: Implement, *, like: str) -> Written:
    """Return the content of a file that names an entry of the catalogue and says only what is different.

    Raises `InputError`: see `implement_toml`.

    >>> from sweetspot import catalog
    >>> racket = catalog.implement("tennis-racket")
    >>> changes = changes_table(racket.replaced(mass=0.305), racket, like="tennis-racket")
    >>> changes["mass"], changes["balance_point"]  # written again: measurements hold for one weight
    ('0.305 kg', '0.325 m')
    """
    if implement.added:
        raise InputError(f"{implement.name} has weights on it; describe it without them, and add [[point_mass]]")
    table = implement_table(implement)
    changed = _different(table, implement_table(pattern))
    measured = {name: table[name] for name in (*MEASURED, "moi_axis") if name in table} if changed else {}
    return {"like": like, **changed, **measured}


def _different(table: Mapping[str, TomlValue], pattern: Mapping[str, TomlValue]) -> Written:
    """Return the entries of a table that differ from the pattern's, recursively."""
    changed: Written = {}
    for name, value in table.items():
        before = pattern.get(name)
        if isinstance(value, Mapping) and isinstance(before, Mapping) and value != before:
            changed[name] = _different(value, before)
        elif value != before:
            changed[name] = value
    return changed


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


def _material(made_of: Material) -> str | Written:
    """Return a material's name, or a table of what it has of its own where the catalogue's values were changed."""
    key = _key(made_of)
    standard = material(key)
    if made_of == standard:
        return key
    names = MaterialTable.model_fields.keys() - {"like"}
    changed = {name: getattr(made_of, name) for name in names if getattr(made_of, name) != getattr(standard, name)}
    if standard.of_density(made_of.density).replaced(**changed) != made_of or None in changed.values():
        raise InputError(f"{made_of.name} differs from the catalogue's in ways that a bat file cannot describe")
    return written(MaterialTable, like=key, **changed)


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

"""Files that start from another one: ``like = "tennis-racket"`` or ``like = "own.toml"``, and what is different.

What such a file adds or changes is done to its parent, as a workshop does it: what was measured on the parent tells
what it is made of, and the weight follows. What the file itself says was measured was measured on the changed one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from sweetspot.catalog.files.bat import MEASURED, OUTLINES, read_toml, with_fitted
from sweetspot.catalog.files.implement import IN_WORDS, AddedTable, implement_of_table
from sweetspot.catalog.files.racket_words import in_file_names
from sweetspot.catalog.files.tables import made
from sweetspot.catalog.files.write import implement_table
from sweetspot.catalog.records import FOLDER, TomlTable, TomlValue, canonical, entry, unwrapped_table
from sweetspot.catalog.scaled_implements import Measures, scaled_to
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import AddedMass
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.stretch import stretched
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FOLDERS = ("bats", "implements")
ADDED_TO = ("point_mass", "bore", "ring")
"""Lists that a file adds to; an empty one takes away what the parent has."""
OF_THE_PARENT = ("note", "original", "fitted")
"""Keys of a parent's file that hold for the parent alone."""
KNOWN_BY_MEASURES = ("racket", "golf-club", "paddle")
"""Kinds that cannot be without what was measured, or its parts: what their files leave out keeps the parent's."""
OF_PLATE = "head_width corner_radius throat handle_length handle_width skin core_thickness core_density glue rim_at_tip"
"""Fields of a paddle with which its twist weight changes."""
CHANGED = ", changed"
"""Ending of the default name, where a file gives none."""
UNITS: dict[str, tuple[Kind, str]] = {
    "mass": ("mass", "kg"),
    "balance_point": ("length", "m"),
    "moi": ("moi", "kg*m^2"),
}


def resolved(table: TomlTable, where: str, folder: Path | None = None, before: tuple[Path, ...] = ()) -> TomlTable:
    """Return a file's table with all that it leaves out taken from the parent that ``like`` names.

    Tables inside it are completed the same way. Holes, rings and weights are added to the parent's; other lists are
    replaced whole. The parent as it was measured is the ``original`` of the changed one, unless that is of another
    material.

    Raises `InputError` for a parent that is not there, or that is like this file.

    Parameters
    ----------
    folder : of the file, which its ``like`` may name another file from; None: it may name none.

    >>> resolved({"like": "tennis-racket", "ra": 66}, "mine.toml")["mass"]
    '318 g'
    """
    name = table.get("like")
    if not isinstance(name, str):
        return in_file_names(table, str(table.get("sport", ""))) if table.get("kind") in IN_WORDS else table
    changes = unwrapped_table(with_fitted({field: value for field, value in table.items() if field != "like"}))
    try:
        parent = _parent(name, folder, before)
        if parent.get("kind") not in IN_WORDS:
            return _changed(parent, changes)
        return _changed(parent, in_file_names(changes, str(changes.get("sport", parent.get("sport", "")))))
    except InputError as error:
        raise InputError(f"{where}: {error}") from None


def names_file(like: str) -> bool:
    """Return whether a value of ``like`` denotes another file: it ends in ``.toml`` or holds a path separator."""
    return like.lower().endswith(".toml") or "/" in like or "\\" in like


def _parent(name: str, folder: Path | None, before: tuple[Path, ...]) -> TomlTable:
    """Return the whole table of a parent, without provenance."""
    if names_file(name):
        if folder is None:
            raise InputError(
                f"like = {name[:60]!r} names another file, and no file is opened from here. Name an entry of the "
                "catalogue, or use the command line, where both files are"
            )
        path = folder / name
        if not path.is_file():
            raise InputError(f"like = {name[:60]!r}: there is no file {path}; it is looked for beside the file itself")
    else:
        entries = {canonical(path.stem): path for folder in FOLDERS for path in (FOLDER / folder).glob("*.toml")}
        path = entries[entry({key: {} for key in entries}, name, "bat")[0]]
    path = path.resolve()
    if path in before:
        ring = " is like ".join(file.name for file in (*before[before.index(path) :], path))
        raise InputError(f"{ring}: that has no beginning. Let one of them describe its bat without like")
    table = unwrapped_table(with_fitted(read_toml(path)))
    whole = resolved(table, str(path), path.parent, (*before, path))
    if names_file(name):
        implement_of_table(whole, str(path))  # it says itself what is wrong in it
        return whole
    return whole if "kind" in whole else {**whole, "outline_assumed": True}


def _changed(parent: TomlTable, changes: TomlTable) -> TomlTable:
    """Return the whole table of what was changed from a parent."""
    was_measured = any(name in parent for name in MEASURED) or "original" not in parent
    measured_on = parent if was_measured else parent["original"]
    before, after = parent.get("material"), changes.get("material")
    changes = {**changes, **_whole_material(before, after)}
    base: TomlTable = {**_base(_without(parent, *OF_THE_PARENT), changes), "name": _name(str(parent.get("name", "")))}
    if changes.keys() & OUTLINES:  # another one takes the place of the parent's
        base = _without(base, *OUTLINES, "outline_assumed")
    if {"ra", "first_frequency"} & changes.keys():  # one of them is enough
        base = _without(base, "ra", "first_frequency")
    if parent.get("kind") in KNOWN_BY_MEASURES:
        table = _completed(base, _without(changes, *MEASURED, "moi_axis"))
        return {**table, **_bare_twist(table, changes), "original": measured_on}
    base = _without(base, *MEASURED)
    if _is_other_material(before, after):
        return _completed(_without(base, "calibration", "density_gradient"), changes)
    table = {**_completed(base, changes), "original": measured_on}
    return table if parent.get("kind", "bat") == "bat" else {**table, **_before_added(table)}


def _base(parent: TomlTable, changes: TomlTable) -> TomlTable:
    """Return the parent's table, at the length of the changed one, and measured as that where its kind needs it."""
    length = _quantity(changes, "length", "length")
    if length == _quantity(parent, "length", "length"):
        length = None
    if parent.get("kind") == "paddle" and "twist_moi" not in changes and changes.keys() & set(OF_PLATE.split()):
        paddle = implement_of_table(parent, "its parent")
        assert isinstance(paddle, Paddle)  # its twist weight will follow
        parent = {**_kept(parent), **_without(implement_table(paddle.with_its_rim()), "original")}
    if parent.get("kind") in KNOWN_BY_MEASURES and (length is not None or set(MEASURED) & changes.keys()):
        return _scaled_to(parent, changes, length)
    if length is None or (changes.keys() & OUTLINES and "shell" not in parent):  # a new outline has its own length
        return parent
    longer = implement_table(stretched(implement_of_table(parent, "its parent"), length))
    return {**_kept(parent), **_without(longer, "original")}


def _scaled_to(parent: TomlTable, changes: TomlTable, length: float | None) -> TomlTable:
    """Return the table of a racket or club like its parent that has, with all its weights on it, what was measured."""
    tool = implement_of_table(parent, "its parent")
    more = _weights(changes, str(parent["kind"]))
    weights = more if changes.get("point_mass") == [] else (*tool.added, *more)
    whole = rigid_body(beam_model(tool)).mass + sum(weight.mass for weight in more)
    bare = _bare(weights, changes, whole, tool.moi_axis)
    plain = tool.replaced(added=())
    made, _ = scaled_to(plain, replace(bare, length=length))
    follows = [name for name in MEASURED if name not in changes and getattr(made, name) != getattr(plain, name)]
    fitted = [name for name in MEASURED if name in follows or (name in tool.fitted and name not in changes)]
    return {**_kept(parent), **implement_table(made.replaced(fitted=tuple(fitted)))}


def _bare_twist(table: TomlTable, changes: TomlTable) -> TomlTable:
    """Return the twist weight that a file gives, converted to that without the added weights, which lie beside it."""
    twist = _quantity(changes, "twist_moi", "moi")
    if twist is None:
        return {}
    weights = _weights(table, str(table["kind"]))
    return {"twist_moi": f"{twist - sum(weight.mass * weight.lateral**2 for weight in weights)!r} kg*m^2"}


def _before_added(table: TomlTable) -> TomlTable:
    """Return the measured quantities of an implement with added weights, converted to those without them."""
    given, weights = set(MEASURED) & table.keys(), _weights(table, str(table["kind"]))
    if not given or not weights:
        return {}
    whole = rigid_body(beam_model(implement_of_table(_without(table, *MEASURED), "its parent"))).mass
    bare = _bare(weights, table, whole, 0.0)
    return {name: f"{getattr(bare, name)!r} {UNITS[name][1]}" for name in given}


def _bare(weights: Sequence[AddedMass], table: TomlTable, whole: float, axis: float) -> Measures:
    """Return the measures that a file gives for an implement, reduced to those without its added weights.

    Parameters
    ----------
    whole : kg, with the weights, where the file does not say it.
    axis : m from the butt end, of a moment of inertia, where the file does not say it.
    """
    mass, balance, moi = (_quantity(table, name, kind) for name, (kind, _) in UNITS.items())
    given_axis = _quantity(table, "moi_axis", "length")
    axis = axis if given_axis is None else given_axis
    added = sum(weight.mass for weight in weights)
    bare_mass = (whole if mass is None else mass) - added
    if balance is not None:
        balance = (balance * (bare_mass + added) - sum(weight.mass * weight.position for weight in weights)) / bare_mass
    if moi is not None:
        moi -= sum(weight.mass * (weight.position - axis) ** 2 for weight in weights)
    return Measures(mass=None if mass is None else bare_mass, balance_point=balance, moi=moi, moi_axis=axis)


def _weights(table: TomlTable, kind: str) -> tuple[AddedMass, ...]:
    tables = (AddedTable(**weight) for weight in _listed(table.get("point_mass", [])) if isinstance(weight, Mapping))
    return tuple(made(AddedMass, each, "point_mass", implement=kind) for each in tables)


def _quantity(table: TomlTable, name: str, kind: Kind) -> float | None:
    """Return a quantity of a table in SI; None where there is none."""
    value = table.get(name)
    return None if value is None else parse(value if isinstance(value, (str, int, float)) else str(value), kind, name)


def _is_other_material(parent: TomlValue | None, child: TomlValue | None) -> bool:
    """Return whether a material's name or density differs from the parent's; stiffer wood is still the same piece."""
    if child is None or parent is None:
        return False
    before, after = (part if isinstance(part, Mapping) else {"like": part} for part in (parent, child))
    name = after.get("like", before.get("like"))
    return canonical(str(name)) != canonical(str(before.get("like"))) or "density" in after


def _whole_material(parent: TomlValue | None, child: TomlValue | None) -> TomlTable:
    """Return a file's [material] with the parent's name where it gives values alone."""
    if not isinstance(child, Mapping) or "like" in child or parent is None:
        return {}
    return {"material": {**(parent if isinstance(parent, Mapping) else {"like": parent}), **child}}


def _completed(base: TomlTable, changes: TomlTable) -> TomlTable:
    table = dict(base)
    for key, value in changes.items():
        of_base = table.get(key)
        like = of_base.get("like") if isinstance(of_base, Mapping) else None
        if isinstance(of_base, Mapping) and isinstance(value, Mapping) and value.get("like", like) == like:
            table[key] = _completed(of_base, value)
        elif key in ADDED_TO and value and of_base:
            table[key] = [*_listed(of_base), *_listed(value)]
        else:
            table[key] = value
    return table


def _name(parent: str) -> str:
    return parent if parent.endswith(CHANGED) else f"{parent}{CHANGED}"[:100]


def _kept(parent: TomlTable) -> TomlTable:
    """Return the tables of a parent's file that the text of its implement lacks: calibration and added weights."""
    return {name: parent[name] for name in ("calibration", "point_mass") if name in parent}


def _without(table: TomlTable, *names: str) -> TomlTable:
    return {field: value for field, value in table.items() if field not in names}


def _listed(value: TomlValue) -> list[TomlValue]:
    """Return one table as a list of one, as files may have it."""
    return list(value) if isinstance(value, (list, tuple)) else [value]

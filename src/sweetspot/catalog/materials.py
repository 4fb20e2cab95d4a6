"""Materials by name: woods, metal, fillers, laminate; rubbers of rackets, and a frame's stiffness as RA."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, quantity, read_table, unwrapped
from sweetspot.equipment.face import Rubber
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FILE = "materials.toml"
CALLED = {
    "ash": "white-ash", "maple": "sugar-maple", "hard-maple": "sugar-maple", "rock-maple": "sugar-maple",
    "birch": "yellow-birch", "willow": "english-willow", "aluminium": "aluminium-7xxx", "aluminum": "aluminium-7xxx",
}  # fmt: skip
"""Trade names of materials, with the catalogue's name of the usual one for bats."""


def material_names() -> list[str]:
    """Return the names of all materials in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def material(name: str) -> Material:
    """Return a material of the catalogue; raises `InputError` with the nearest names for an unknown one.

    >>> material("white ash").family
    'wood'
    """
    _, material_entry = entry(read_table(FILE), CALLED.get(canonical(name), name), "material")
    what = material_entry["name"]
    limits = unwrapped(material_entry["density_range"]) if "density_range" in material_entry else None
    return Material(
        name=what,
        family=material_entry["family"],
        laminated=material_entry.get("laminated", False),
        density=quantity(material_entry, "density", "density", what),
        longitudinal_modulus=quantity(material_entry, "longitudinal_modulus", "pressure", what),
        shear_modulus=quantity(material_entry, "shear_modulus", "pressure", what),
        transverse_modulus=quantity(material_entry, "transverse_modulus", "pressure", what),
        poisson_ratio=quantity(material_entry, "poisson_ratio", "ratio", what),
        damping_ratio=quantity(material_entry, "damping_ratio", "ratio", what) or 0.0,
        density_range=tuple(parse(limit, "density", f"{what} density_range") for limit in limits) if limits else None,
        strength=quantity(material_entry, "strength", "pressure", what),
    )


@cache
def keys_by_name() -> dict[str, str]:
    """Return the catalogue's key of every material by its name; the name need not be the key."""
    return {material(key).name: key for key in material_names()}


@cache
def material_spreads(name: str) -> dict[str, float]:
    """Return the spread of a material's values as a part of them, by field; `name` is what people call it or its key.

    >>> round(material_spreads("white ash")["density"], 3)  # 45 of 672 kg/m^3
    0.067
    """
    table = read_table(FILE)
    key = next((key for key, material_entry in table.items() if material_entry["name"] == name), name)
    _, material_entry = entry(table, key, "material")
    standard = material(key)
    kinds: dict[str, Kind] = {"density": "density", "longitudinal_modulus": "pressure", "shear_modulus": "pressure"}
    spreads = {}
    for field, kind in kinds.items():
        record = material_entry.get(field)
        if isinstance(record, dict) and "spread" in record:
            spreads[field] = parse(record["spread"], kind, f"{name} {field} spread") / getattr(standard, field)
    return spreads


RUBBERS = "rubbers.toml"
KINDS_OF_RUBBER: dict[str, Kind] = {
    "thickness": "length", "areal_density": "areal density", "stiffness": "stiffness", "moving_mass": "mass",
    "restitution": "ratio", "friction": "ratio", "tangential_restitution": "ratio",
}  # fmt: skip


def rubber_names() -> list[str]:
    """Return the names of all rubbers in the catalogue."""
    return [canonical(name) for name in read_table(RUBBERS)]


@cache
def rubber(name: str) -> Rubber:
    """Return a rubber of the catalogue; raises `InputError` with the nearest names for an unknown one.

    >>> rubber("anti-spin").friction < rubber("inverted").friction
    True
    """
    _, table = entry(read_table(RUBBERS), name, "rubber")
    values = {field: quantity(table, field, kind, table["name"]) for field, kind in KINDS_OF_RUBBER.items()}
    return Rubber(name=table["name"], **values)


def rubber_key(sheet: Rubber) -> str:
    """Return the catalogue's name of a rubber; raises `InputError` when it is none of the catalogue's."""
    for name in rubber_names():
        if rubber(name) == sheet:
            return name
    raise InputError(f"{sheet.name} differs from the catalogue's rubbers; a file can only name one")


def frequency_of_ra(ra: float) -> float:
    """Return the first bending frequency in Hz of a racket hung freely, from its RA.

    f = f_0 + s (RA - RA_0); the numbers are recalled, good to some 10 Hz.

    Parameters
    ----------
    ra : 45 to 80.

    >>> round(frequency_of_ra(70))
    151
    """
    table = read_table("racket_stiffness.toml")["ra"]
    low, high = unwrapped(table["low"]), unwrapped(table["high"])
    if not low <= ra <= high:
        raise InputError(f"ra was given as {ra:g}; frames have {low:g} to {high:g}. Give first_frequency in Hz instead")
    base, slope = quantity(table, "frequency", "frequency", "ra"), quantity(table, "slope", "frequency", "ra")
    assert base is not None and slope is not None
    return base + slope * (ra - float(unwrapped(table["reference"])))

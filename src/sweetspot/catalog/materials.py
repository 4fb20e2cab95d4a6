"""Materials by name: woods, metal, fillers, laminate; rubbers of rackets, and a frame's stiffness as RA."""

from __future__ import annotations

from functools import cache

from sweetspot.catalog.records import canonical, entry, read_table
from sweetspot.equipment.material import Material
from sweetspot.equipment.table_tennis_racket import Rubber
from sweetspot.errors import InputError
from sweetspot.plausibility import parse
from sweetspot.units import Kind

FILE = "materials.toml"
CALLED = {
    "ash": "white-ash",
    "maple": "sugar-maple",
    "hard-maple": "sugar-maple",
    "rock-maple": "sugar-maple",
    "birch": "yellow-birch",
    "willow": "english-willow",
    "aluminium": "aluminium-7xxx",
    "aluminum": "aluminium-7xxx",
}
"""Trade names of materials, with the catalogue's name of the usual one for bats."""
FIELDS: dict[str, Kind] = {
    "density": "density",
    "longitudinal_modulus": "pressure",
    "shear_modulus": "pressure",
    "transverse_modulus": "pressure",
    "poisson_ratio": "ratio",
    "damping_ratio": "ratio",
    "strength": "pressure",
}
"""Keys of an entry, and the kind of quantity."""


def material_names() -> list[str]:
    """Return the names of all materials in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def material(name: str) -> Material:
    """Return a material of the catalogue; raises `InputError` with the nearest names for an unknown one.

    >>> material("white ash").family
    'wood'
    """
    _, record = entry(read_table(FILE), CALLED.get(canonical(name), name), "material")
    limits = [parse(limit, "density", f"{record.name} density_range") for limit in record.texts("density_range")]
    values: dict[str, float | None] = {**dict.fromkeys(FIELDS), "damping_ratio": 0.0, **record.quantities(FIELDS)}
    return Material(
        name=record.name,
        family=record.text("family"),
        laminated="laminated" in record and bool(record["laminated"]),
        density_range=tuple(limits) or None,
        **values,
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
    key = next((key for key, record in table.items() if record.name == name), name)
    _, record = entry(table, key, "material")
    standard, spreads = material(key), {}
    for field in ("density", "longitudinal_modulus", "shear_modulus"):
        spread = record.spread(field, FIELDS[field])
        if spread is not None:
            spreads[field] = spread / getattr(standard, field)
    return spreads


RUBBERS, RACKETS = "rubbers.toml", "racket_stiffness.toml"
KINDS_OF_RUBBER: dict[str, Kind] = {
    "thickness": "length",
    "areal_density": "areal density",
    "stiffness": "stiffness",
    "moving_mass": "mass",
    "restitution": "ratio",
    "friction": "ratio",
    "tangential_restitution": "ratio",
}


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
    return Rubber(name=table.name, **table.quantities(KINDS_OF_RUBBER))


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
    low, high = bounds_of_ra()
    if not low <= ra <= high:
        raise InputError(f"ra was given as {ra:g}; frames have {low:g} to {high:g}. Give first_frequency in Hz instead")
    table = read_table(RACKETS)["ra"]
    base, slope = (table.quantity(field, "frequency") for field in ("frequency", "slope"))
    return base + slope * (ra - table.number("reference"))


def bounds_of_ra() -> tuple[float, float]:
    """Return the RA of the softest and of the stiffest frames."""
    table = read_table(RACKETS)["ra"]
    return table.number("low"), table.number("high")

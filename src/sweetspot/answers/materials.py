"""What the catalogue holds of materials: every one in a line, or one as a card with spreads and sources."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated

from sweetspot.analysis.strain import grain_factor
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL, OF_RECORD
from sweetspot.catalog.materials import CALLED, FIELDS, FILE, material, material_names
from sweetspot.catalog.records import Record, all_records, canonical, entry, read_table
from sweetspot.equipment.material import Material
from sweetspot.numerics.interval import REACH, Interval, Number
from sweetspot.references import cite
from sweetspot.units.dimensions import ANGLE, DENSITY, MODULUS, RATIO, Dimension

GRAIN_DEGREES = (1.0, 2.0, 3.0, 5.0)
"""Slopes of grain of which a card of wood says what strength is left; bats of the major leagues may have 3."""
DIMENSIONS: dict[str, Dimension] = {
    "density": DENSITY,
    **dict.fromkeys(("longitudinal_modulus", "transverse_modulus", "shear_modulus", "strength"), MODULUS),
    **dict.fromkeys(("poisson_ratio", "damping_ratio"), RATIO),
}


@dataclass(frozen=True)
class MaterialFacts:
    """A material in a line; nan where the catalogue does not know a value.

    ``stiffness_for_weight``: E over density, m^2/s^2, which decides how high a bat of given shape rings.
    """

    key: str
    name: str
    family: str
    density: Annotated[float, DENSITY]
    longitudinal_modulus: Annotated[float, MODULUS]
    shear_modulus: Annotated[float, MODULUS]
    strength: Annotated[float, MODULUS]
    stiffness_for_weight: float


@dataclass(frozen=True)
class MaterialValue:
    """One value of a material with the 90 % interval that the catalogue's spread means, and what it rests on."""

    quantity: str
    value: Annotated[Number, OF_RECORD]
    kind: str
    source: str
    where: str

    @property
    def dimension(self) -> Dimension:
        """Of the value."""
        return DIMENSIONS[self.quantity]


@dataclass(frozen=True)
class GrainStrength:
    """The part of its strength in bending that wood keeps where its grain slopes by an angle to the bat's axis."""

    slope: Annotated[float, ANGLE]
    strength_left: float


@dataclass(frozen=True, kw_only=True)
class MaterialAnswer(Answer):
    """One material with every value, its spread and its source; ``grain`` is of wood."""

    key: str
    name: str
    family: str
    values: tuple[MaterialValue, ...]
    grain: tuple[GrainStrength, ...]
    material: Annotated[Material, INTERNAL]


@dataclass(frozen=True, kw_only=True)
class MaterialsAnswer(Answer):
    """Every material of the catalogue."""

    materials: tuple[MaterialFacts, ...]


def materials_answer() -> MaterialsAnswer:
    """Return every material in a line."""
    return MaterialsAnswer(materials=tuple(_facts(name, material(name)) for name in material_names()))


def material_answer(name: str) -> MaterialAnswer:
    """Return one material by its name in the catalogue or in the trade: "ash", "hard maple"."""
    key, table = entry(read_table(FILE), CALLED.get(canonical(name), name), "material")
    made = material(key)
    records = {record.name.rpartition(".")[2]: record for record in all_records(table, key)}
    values = [
        _value(float(getattr(made, field)), table.spread(field, FIELDS[field]), records[field])
        for field in DIMENSIONS
        if field in records
    ]
    wood = made.family == "wood"
    return MaterialAnswer(
        key=canonical(key),
        name=made.name,
        family=made.family,
        values=tuple(values),
        grain=tuple(_grain(degrees) for degrees in GRAIN_DEGREES) if wood else (),
        material=made,
    )


def _value(value: float, spread: float | None, record: Record) -> MaterialValue:
    half = 0.0 if spread is None else REACH * spread
    number: Number = Interval(value, max(0.0, value - half), value + half) if half else value
    return MaterialValue(record.name.rpartition(".")[2], number, record.kind, cite(record.source), record.where)


def _grain(degrees: float) -> GrainStrength:
    slope = math.radians(degrees)
    return GrainStrength(slope, grain_factor(slope))


def _facts(key: str, made: Material) -> MaterialFacts:
    return MaterialFacts(
        key=key,
        name=made.name,
        family=made.family,
        density=made.density,
        longitudinal_modulus=made.longitudinal_modulus,
        shear_modulus=made.shear,
        strength=float("nan") if made.strength is None else made.strength,
        stiffness_for_weight=made.longitudinal_modulus / made.density,
    )

"""Balls by name."""

from __future__ import annotations

import math
from functools import cache

from sweetspot.ball import Ball, RestitutionLaw, stiffness_from_peak_force
from sweetspot.catalog.records import canonical, entry, quantity, read_table
from sweetspot.units import Kind

FILE = "balls.toml"
DEFAULT_BALL = "baseball"


def ball_names() -> list[str]:
    """Return the names of all balls in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


@cache
def ball(name: str = DEFAULT_BALL) -> Ball:
    """Return a ball of the catalogue; raises `InputError` with the nearest names for an unknown one.

    The stiffness k of F = k u^n follows from the record's peak force on a rigid wall.

    >>> round(ball("baseball").mass, 4)
    0.1453
    """
    _, found = entry(read_table(FILE), name, "ball")

    def value(field: str, kind: Kind) -> float:
        number = quantity(found, field, kind, found["name"])
        assert number is not None, f"balls.toml: {name} lacks {field}"
        return number

    mass, exponent = value("mass", "mass"), value("force_exponent", "ratio")
    return Ball(
        name=found["name"],
        mass=mass,
        radius=value("circumference", "length") / (2 * math.pi),
        restitution=RestitutionLaw(
            reference=value("cor_reference", "ratio"),
            reference_speed=value("cor_reference_speed", "speed"),
            slope=value("cor_slope", "slope per speed"),
        ),
        stiffness=stiffness_from_peak_force(
            value("peak_force", "force"), speed=value("peak_force_speed", "speed"), mass=mass, exponent=exponent
        ),
        exponent=exponent,
        cor_humidity_slope=value("cor_humidity_slope", "ratio"),
        cor_temperature_slope=value("cor_temperature_slope", "slope per temperature"),
        reference_humidity=value("reference_humidity", "ratio"),
        reference_temperature=value("reference_temperature", "temperature"),
    )

"""Balls by name."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

from sweetspot.catalog.records import canonical, entry, quantity, read_table
from sweetspot.equipment.ball import (
    Ball,
    RestitutionLaw,
    stiffness_from_contact_time,
    stiffness_from_load,
    stiffness_from_peak_force,
)
from sweetspot.units import Kind

FILE = "balls.toml"
DEFAULT_BALL = "baseball"


def ball_names() -> list[str]:
    """Return the names of all balls in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


def ball_sport(name: str) -> str:
    """Return the sport that a ball of the catalogue belongs to.

    >>> ball_sport("shuttle")
    'badminton'
    """
    return str(entry(read_table(FILE), name, "ball")[1]["sport"])


@cache
def ball(name: str = DEFAULT_BALL) -> Ball:
    """Return a ball of the catalogue; raises `InputError` with the nearest names for an unknown one.

    The stiffness k of F = k u^n follows from what the record gives: the peak force on a rigid wall, a slow load, or
    the time of contact with a rigid wall.

    >>> round(ball("baseball").mass, 4)
    0.1453
    """
    key, found = entry(read_table(FILE), name, "ball")

    def value(field: str, kind: Kind) -> float:
        number = quantity(found, field, kind, found["name"])
        assert number is not None, f"balls.toml: {key} lacks {field}"
        return number

    mass, exponent = value("mass", "mass"), value("force_exponent", "ratio")
    law = RestitutionLaw(
        reference=value("cor_reference", "ratio"),
        reference_speed=value("cor_reference_speed", "speed"),
        slope=value("cor_slope", "slope per speed"),
    )
    return Ball(
        name=found["name"],
        mass=mass,
        radius=value("diameter", "length") / 2 if "diameter" in found else value("circumference", "length") / math.tau,
        restitution=law,
        stiffness=_stiffness(found, value, mass=mass, exponent=exponent, law=law),
        exponent=exponent,
        cor_humidity_slope=value("cor_humidity_slope", "ratio"),
        cor_temperature_slope=value("cor_temperature_slope", "slope per temperature"),
        reference_humidity=value("reference_humidity", "ratio"),
        reference_temperature=value("reference_temperature", "temperature"),
    )


def _stiffness(found: dict[str, Any], value: Any, *, mass: float, exponent: float, law: RestitutionLaw) -> float:
    """Return k from the one kind of test that the entry describes."""
    if "peak_force" in found:
        force, speed = value("peak_force", "force"), value("peak_force_speed", "speed")
        return stiffness_from_peak_force(force, speed=speed, mass=mass, exponent=exponent)
    if "load" in found:
        pressed = value("load_compression", "length")
        return stiffness_from_load(value("load", "force"), compression=pressed, exponent=exponent)
    speed = value("contact_time_speed", "speed")
    return stiffness_from_contact_time(
        value("contact_time", "time"), speed=speed, mass=mass, exponent=exponent, restitution=law.at(speed)
    )

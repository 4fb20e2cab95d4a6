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
from sweetspot.plausibility import parse
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
    key, ball_entry = entry(read_table(FILE), name, "ball")

    def value(field: str, kind: Kind) -> float:
        number = quantity(ball_entry, field, kind, ball_entry["name"])
        assert number is not None, f"balls.toml: {key} lacks {field}"
        return number

    mass, exponent = value("mass", "mass"), value("force_exponent", "ratio")
    diameter = value("diameter", "length") if "diameter" in ball_entry else value("circumference", "length") / math.pi
    law = RestitutionLaw(
        reference=value("cor_reference", "ratio"),
        reference_speed=value("cor_reference_speed", "speed"),
        slope=value("cor_slope", "slope per speed"),
    )
    return Ball(
        name=ball_entry["name"],
        mass=mass,
        radius=diameter / 2,
        restitution=law,
        stiffness=_stiffness(ball_entry, value, mass=mass, exponent=exponent, law=law),
        exponent=exponent,
        cor_humidity_slope=value("cor_humidity_slope", "ratio"),
        cor_temperature_slope=value("cor_temperature_slope", "slope per temperature"),
        reference_humidity=value("reference_humidity", "ratio"),
        reference_temperature=value("reference_temperature", "temperature"),
    )


def _stiffness(ball_entry: dict[str, Any], value: Any, *, mass: float, exponent: float, law: RestitutionLaw) -> float:
    """Return k from the one kind of test that the entry describes."""
    if "peak_force" in ball_entry:
        force, speed = value("peak_force", "force"), value("peak_force_speed", "speed")
        return stiffness_from_peak_force(force, speed=speed, mass=mass, exponent=exponent)
    if "load" in ball_entry:
        pressed = value("load_compression", "length")
        return stiffness_from_load(value("load", "force"), compression=pressed, exponent=exponent)
    speed = value("contact_time_speed", "speed")
    return stiffness_from_contact_time(
        value("contact_time", "time"), speed=speed, mass=mass, exponent=exponent, restitution=law.at(speed)
    )


def ball_spreads(ball: Ball) -> dict[str, float]:
    """Return the half widths of what is plausible of a ball of the catalogue, whatever was changed on it.

    Returns
    -------
    dict
        "restitution" and "restitution_slope" (s/m) as they are, "mass" and "stiffness" as parts of themselves; without
        those that the catalogue does not know, and empty for a ball that it does not have.

    >>> round(ball_spreads(ball("baseball"))["restitution"], 3)
    0.032
    """
    record = next((ball_entry for ball_entry in read_table(FILE).values() if ball_entry["name"] == ball.name), {})

    def spread(field: str, kind: Kind) -> float | None:
        if not isinstance(record.get(field), dict) or "spread" not in record[field]:
            return None
        return parse(record[field]["spread"], kind, f"{ball.name} {field} spread")

    def part(field: str, kind: Kind) -> float | None:
        size, value = spread(field, kind), quantity(record, field, kind, ball.name)
        return None if size is None or not value else size / value

    forces = {"peak_force": part("peak_force", "force"), "contact_time": part("contact_time", "time")}
    steep = next((size for size in forces.values() if size is not None), None)
    slow = part("load", "force")
    spreads = {
        "restitution": spread("cor_reference", "ratio"),
        "restitution_slope": spread("cor_slope", "slope per speed"),
        "mass": part("mass", "mass"),
        # k goes as the (n + 1)th power of a peak force or of one over the time of contact
        "stiffness": (ball.exponent + 1) * steep if steep is not None else slow,
    }
    return {name: size for name, size in spreads.items() if size}

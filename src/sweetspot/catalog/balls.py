"""Balls by name."""

from __future__ import annotations

import math
from functools import cache

from sweetspot.catalog.records import Entry, canonical, entry, read_table
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
OF_WEATHER: dict[str, Kind] = {
    "cor_humidity_slope": "ratio",
    "cor_temperature_slope": "slope per temperature",
    "reference_humidity": "ratio",
    "reference_temperature": "temperature",
}
"""What every entry says of the weather that its restitution was measured in, and how that changes."""


def ball_names() -> list[str]:
    """Return the names of all balls in the catalogue."""
    return [canonical(name) for name in read_table(FILE)]


def ball_sport(name: str) -> str:
    """Return the sport that a ball of the catalogue belongs to.

    >>> ball_sport("shuttle")
    'badminton'
    """
    return entry(read_table(FILE), name, "ball")[1].text("sport")


@cache
def ball(name: str = DEFAULT_BALL) -> Ball:
    """Return a ball of the catalogue; raises `InputError` with the nearest names for an unknown one.

    The stiffness k of F = k u^n follows from what the record gives: the peak force on a rigid wall, a slow load, or
    the time of contact with a rigid wall.

    >>> round(ball("baseball").mass, 4)
    0.1453
    """
    _, record = entry(read_table(FILE), name, "ball")
    mass, exponent = record.quantity("mass", "mass"), record.quantity("force_exponent", "ratio")
    diameter = record.quantity_or_none("diameter", "length")
    law = RestitutionLaw(
        reference=record.quantity("cor_reference", "ratio"),
        reference_speed=record.quantity("cor_reference_speed", "speed"),
        slope=record.quantity("cor_slope", "slope per speed"),
    )
    return Ball(
        name=record.name,
        mass=mass,
        radius=(record.quantity("circumference", "length") / math.pi if diameter is None else diameter) / 2,
        restitution=law,
        stiffness=_stiffness(record, mass=mass, exponent=exponent, law=law),
        exponent=exponent,
        **record.quantities(OF_WEATHER),
    )


def _stiffness(record: Entry, *, mass: float, exponent: float, law: RestitutionLaw) -> float:
    """Return k from the one kind of test that the entry describes."""
    if "peak_force" in record:
        force, speed = record.quantity("peak_force", "force"), record.quantity("peak_force_speed", "speed")
        return stiffness_from_peak_force(force, speed=speed, mass=mass, exponent=exponent)
    if "load" in record:
        pressed = record.quantity("load_compression", "length")
        return stiffness_from_load(record.quantity("load", "force"), compression=pressed, exponent=exponent)
    speed, time = record.quantity("contact_time_speed", "speed"), record.quantity("contact_time", "time")
    return stiffness_from_contact_time(time, speed=speed, mass=mass, exponent=exponent, restitution=law.at(speed))


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
    record = next((each for each in read_table(FILE).values() if each.name == ball.name), None)
    if record is None:
        return {}

    def part(field: str, kind: Kind) -> float | None:
        size = record.spread(field, kind)
        return None if size is None else size / record.quantity(field, kind)

    forces = {"peak_force": part("peak_force", "force"), "contact_time": part("contact_time", "time")}
    steep = next((size for size in forces.values() if size is not None), None)
    slow = part("load", "force")
    spreads = {
        "restitution": record.spread("cor_reference", "ratio"),
        "restitution_slope": record.spread("cor_slope", "slope per speed"),
        "mass": part("mass", "mass"),
        # k goes as the (n + 1)th power of a peak force or of one over the time of contact
        "stiffness": (ball.exponent + 1) * steep if steep is not None else slow,
    }
    return {name: size for name, size in spreads.items() if size}

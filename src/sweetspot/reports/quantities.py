"""Every quantity that people are shown: its name, the ending of its key, its units and how many digits it deserves.

Nothing else in the package puts a unit behind a number. A `Scale` is a way of showing numbers of one kind; a
`Quantity` is one thing that is shown, with its label and colour. A `Reader` is who reads: he has one unit per scale.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from sweetspot.equipment.sport import Terms
from sweetspot.units import (
    DEGREE,
    FOOT,
    INCH,
    INCH_OF_MERCURY,
    MPH,
    OUNCE,
    OUNCE_INCH_SQUARED,
    POUND_FORCE,
    RPM,
    grouped,
)

System = Literal["us", "si"]
NOTHING = "-"
"""Stands where there is no number."""
MINUS = re.compile(r"(?<![^\s(])-(?=\d)")


@dataclass(frozen=True)
class Unit:
    """A unit of people: its name behind the number, its size in SI, usual digits, and where its zero lies in SI."""

    name: str
    size: float
    digits: int
    zero: float = 0.0

    def number(self, value: float, *, digits: int | None = None, sign: bool = False) -> str:
        """Return a value in SI as a number in this unit, never as minus zero.

        >>> Unit("mph", 0.44704, 1).number(40.2336), Unit("mph", 0.44704, 1).number(-0.001, sign=True)
        ('90.0', '+0.0')
        """
        if not math.isfinite(value):
            return NOTHING
        places = self.digits if digits is None else digits
        return grouped((value - self.zero) / self.size, places, sign=sign)


@dataclass(frozen=True)
class Scale:
    """A way of showing numbers: ending of JSON keys and columns, and its unit in either system."""

    ending: str
    us: Unit
    si: Unit


def _same(ending: str, name: str, size: float, digits: int) -> Scale:
    unit = Unit(name, size, digits)
    return Scale(ending, unit, unit)


SCALES: Mapping[str, Scale] = {
    "speed": Scale("_m_s", Unit("mph", MPH, 1), Unit("m/s", 1.0, 1)),
    "speed_change": Scale("_m_s", Unit("mph", MPH, 1), Unit("m/s", 1.0, 2)),
    "place": Scale("_m", Unit("in", INCH, 1), Unit("cm", 0.01, 1)),
    "offset": Scale("_m", Unit("in", INCH, 2), Unit("cm", 0.01, 1)),
    "length": Scale("_m", Unit("in", INCH, 2), Unit("cm", 0.01, 1)),
    "distance": Scale("_m", Unit("ft", FOOT, 0), Unit("m", 1.0, 1)),
    "elevation": Scale("_m", Unit("ft", FOOT, 0), Unit("m", 1.0, 0)),
    "compression": _same("_m", "mm", 1e-3, 1),
    "pressed": Scale("_m", Unit("in", INCH, 2), Unit("mm", 1e-3, 1)),
    "curvature": Scale("_per_m", Unit("per ft", 1 / FOOT, 2), Unit("per m", 1.0, 2)),
    "mass": Scale("_kg", Unit("oz", OUNCE, 1), Unit("g", 1e-3, 0)),
    "moi": Scale("_kg_m2", Unit("oz in²", OUNCE_INCH_SQUARED, 0), Unit("kg cm²", 1e-4, 0)),
    "twist_weight": _same("_kg_m2", "kg cm²", 1e-4, 1),
    "head_moi": _same("_kg_m2", "g cm²", 1e-7, 0),
    "density": Scale("_kg_m3", Unit("lb/ft³", 16 * OUNCE / FOOT**3, 1), Unit("kg/m³", 1.0, 0)),
    "air_density": Scale("_kg_m3", Unit("lb/ft³", 16 * OUNCE / FOOT**3, 4), Unit("kg/m³", 1.0, 3)),
    "modulus": _same("_pa", "GPa", 1e9, 2),
    "pressure": Scale("_pa", Unit("inHg", INCH_OF_MERCURY, 2), Unit("hPa", 100.0, 0)),
    "temperature": Scale("_degc", Unit("°F", 5 / 9, 0, zero=-160 / 9), Unit("°C", 1.0, 0)),
    "time": _same("_s", "s", 1.0, 1),
    "contact": _same("_s", "ms", 1e-3, 3),
    "tap_time": _same("_s", "µs", 1e-6, 0),
    "acceleration": Scale("_m_s2", Unit("ft/s²", FOOT, 0), Unit("m/s²", 1.0, 0)),
    "force": _same("_n", "kN", 1e3, 1),
    "stiffness": _same("_n_m", "kN/m", 1e3, 0),
    "core_shear": _same("_pa", "MPa", 1e6, 1),
    "blow": Scale("_n", Unit("lbf", POUND_FORCE, 0), Unit("kN", 1e3, 1)),
    "weight": Scale("_n", Unit("lbf", POUND_FORCE, 0), Unit("kN", 1e3, 2)),
    "tension": Scale("_n", Unit("lb", POUND_FORCE, 0), Unit("N", 1.0, 0)),
    "impulse": _same("_n_s", "N s", 1.0, 2),
    "energy": _same("_j", "J", 1.0, 1),
    "angle": _same("_rad", "°", DEGREE, 1),
    "spin": _same("_rad_s", "rpm", RPM, 0),
    "frequency": _same("_hz", "Hz", 1.0, 0),
    "vibration": _same("_m_s", "m/s", 1.0, 1),
    "share": _same("", "%", 0.01, 0),
    "strain": _same("", "%", 0.01, 2),
    "ratio": _same("", "", 1.0, 3),
    "count": _same("", "", 1.0, 0),
}


@dataclass(frozen=True)
class Quantity:
    """One thing that is shown: what it is called, its scale, and its colour in pictures ("" where it has none)."""

    label: str
    scale: str
    colour: str = ""


GREY = "#59636e"
BLUE, SKY, GREEN, ORANGE, RED, PURPLE = "#0072b2", "#56b4e9", "#009e73", "#e69f00", "#d55e00", "#cc79a7"
PALETTE = {"blue": BLUE, "sky": SKY, "green": GREEN, "orange": ORANGE, "red": RED, "purple": PURPLE}
"""Okabe and Ito's palette, which colour-blind people can tell apart."""

QUANTITIES: Mapping[str, Quantity] = {
    "exit_speed": Quantity("exit speed", "speed", BLUE),
    "rigid_exit_speed": Quantity("exit speed if rigid", "speed", SKY),
    "bat_speed": Quantity("bat speed", "speed"),
    "pitch_speed": Quantity("pitch speed", "speed"),
    "collision_efficiency": Quantity("collision efficiency q", "ratio", GREEN),
    "bbcor": Quantity("BBCOR in play", "ratio"),
    "contact_time": Quantity("contact time", "contact"),
    "peak_force": Quantity("peak force", "force"),
    "peak_compression": Quantity("peak compression", "pressed"),
    "hand_impulse": Quantity("jolt at the top hand", "impulse", ORANGE),
    "sting": Quantity("vibration at the hands", "vibration", RED),
    "mass": Quantity("mass", "mass"),
    "balance_point": Quantity("balance point", "length"),
    "moi": Quantity("moment of inertia", "moi"),
    "frequency": Quantity("frequency", "frequency"),
    "launch_angle": Quantity("launch angle", "angle"),
    "spray": Quantity("spray", "angle"),
    "backspin": Quantity("backspin", "spin"),
    "sidespin": Quantity("sidespin", "spin"),
    "carry": Quantity("carry", "distance"),
    "hang_time": Quantity("hang time", "time"),
    "apex_height": Quantity("apex", "distance"),
    "landing_angle": Quantity("landing angle", "angle"),
    "landing_speed": Quantity("landing speed", "speed"),
    "apex": Quantity("apex", "distance"),
    "bearing": Quantity("bearing of the landing", "angle"),
    "gyrospin": Quantity("gyrospin", "spin"),
    "height": Quantity("height of contact", "distance"),
    "temperature": Quantity("temperature", "temperature"),
    "humidity": Quantity("humidity", "ratio"),
    "pressure": Quantity("barometer", "pressure"),
    "elevation": Quantity("elevation", "distance"),
    "wind_speed": Quantity("wind", "speed"),
    "wind_direction": Quantity("direction of the wind", "angle"),
    "bore_diameter": Quantity("width of the hole", "length"),
    "bore_depth": Quantity("depth of the hole", "length"),
    "cup_depth": Quantity("depth of the cup", "length"),
    "wall_factor": Quantity("wall, times its own", "ratio"),
}


def key(name: str) -> str:
    """Return the name of a quantity with its unit, as JSON and CSV have it.

    >>> key("carry"), key("bbcor")
    ('carry_m', 'bbcor')
    """
    return f"{name}{SCALES[QUANTITIES[name].scale].ending}"


@dataclass(frozen=True)
class Reader:
    """Who reads: the unit of every scale."""

    units: Mapping[str, Unit]

    def number(self, value: float, scale: str, *, digits: int | None = None, sign: bool = False) -> str:
        """Return a value in SI as a number without its unit."""
        return self.units[scale].number(value, digits=digits, sign=sign)

    def shown(self, value: float, scale: str, *, digits: int | None = None, sign: bool = False) -> str:
        """Return a value in SI with its unit.

        >>> US.shown(40.2336, "speed"), SI.shown(0.1524, "place"), US.shown(0.25, "ratio")
        ('90.0 mph', '15.2 cm', '0.250')
        """
        number = self.number(value, scale, digits=digits, sign=sign)
        return number if number == NOTHING else f"{number}{self.behind(scale)}"

    def behind(self, scale: str) -> str:
        """Return the suffix of a number of a scale: a typographic space and the unit."""
        name = self.units[scale].name
        return name if name in ("", "°") else f" {name}"

    def unit(self, scale: str) -> str:
        """Return the name of a scale's unit, for the head of a column."""
        return self.units[scale].name


US = Reader({name: scale.us for name, scale in SCALES.items()})
SI = Reader({name: scale.si for name, scale in SCALES.items()})

SYSTEMS: Mapping[System, Reader] = {"us": US, "si": SI}

SPEEDS = {"mph": SCALES["speed"].us, "m/s": SCALES["speed"].si}
SPEED_CHANGES = {"mph": SCALES["speed_change"].us, "m/s": SCALES["speed_change"].si}
PLACES = {"in": US, "cm": SI}
WEIGHTS = {"oz": US, "g": SI}
DISTANCES = {"ft": SCALES["distance"].us, "yd": Unit("yd", 3 * FOOT, 1), "m": SCALES["distance"].si}


def reader(system: System | None, words: Terms) -> Reader:
    """Return who reads an answer: of the system that was asked for, or as the sport's people read.

    >>> golf = Terms(speed_unit="mph", place_unit="in", distance_unit="yd", mass_unit="g")
    >>> reader(None, golf).shown(91.44, "distance"), reader("si", golf).shown(91.44, "distance")
    ('100.0 yd', '91.4 m')
    """
    if system is not None:
        return SYSTEMS[system]
    usual = PLACES[words.place_unit]
    speeds = {"speed": SPEEDS[words.speed_unit], "speed_change": SPEED_CHANGES[words.speed_unit]}
    weights = {scale: WEIGHTS[words.weighed_in].units[scale] for scale in ("mass", "moi")}
    return Reader({**usual.units, **speeds, **weights, "distance": DISTANCES[words.distance_unit]})


def with_minus_signs(text: str) -> str:
    """Return a text with minus signs before its negative numbers, as people print them.

    >>> with_minus_signs("2-piece: -0.4 mph (-1.4 to +0.2)").count("-")
    1
    """
    return MINUS.sub("\N{MINUS SIGN}", text)


ENERGY_NAMES: Mapping[str, tuple[str, str]] = {
    "ball": ("{ball}, flying back", RED),
    "heat": ("heat in the {ball}", GREY),
    "translation": ("{implement}, pushed back", BLUE),
    "rotation": ("{implement}, turned", SKY),
    "bending": ("{implement}, bending vibration", PURPLE),
    "hoop": ("{implement}, barrel vibration", ORANGE),
    "face": ("face, vibration", ORANGE),
    "damping": ("heat in {implement} and {hands}", GREEN),
}
"""Field of `EnergyLedger`: (what it is called, with a sport's words; colour)."""
FILM_NAMES = {name: words for name, (words, _) in ENERGY_NAMES.items()} | {
    "ball": "{ball}, moving",
    "stored": "{ball}, squeezed",
    "dent": "surface, pressed in",
}
"""Field of `EnergyHistory`: what it is called while the hit lasts."""

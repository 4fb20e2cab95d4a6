"""The table of quantities as plain data, for programs that show numbers themselves: the page has it as a module."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from typing import Literal, TypedDict

from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import REACH
from sweetspot.plausibility import parse
from sweetspot.reports.quantities import PALETTE, QUANTITIES, SCALES, SYSTEMS, Reader, System, Unit
from sweetspot.reports.sentences import Slot
from sweetspot.reports.sweet_spots import SPOTS

Stored = Literal["us", "si", "plain"]


class ShownUnit(TypedDict):
    """How a stored number is shown in a unit."""

    unit: str
    scale: float
    offset: float
    digits: int


BySystem = Mapping[System, ShownUnit]


class Named(TypedDict, total=False):
    """What a quantity or a sweet spot is called, the scale of a quantity, and the name of its colour."""

    label: str
    scale: str
    colour: str


class QuantityData(TypedDict):
    """The table of quantities; see `quantity_data`."""

    scales: Mapping[str, BySystem]
    endings: Mapping[str, BySystem]
    quantities: Mapping[str, Named]
    spots: Mapping[str, Named]
    palette: Mapping[str, str]
    reach: float


ENDINGS: dict[str, tuple[str, Stored]] = {
    "_from_tip_in": ("length", "us"),
    "_mph": ("speed", "us"),
    "_in": ("length", "us"),
    "_ft": ("distance", "us"),
    "_oz_in2": ("moi", "us"),
    "_oz": ("mass", "us"),
    "_degf": ("temperature", "us"),
    "_degc": ("temperature", "si"),
    "_deg": ("angle", "us"),
    "_rpm": ("spin", "us"),
    "_inhg": ("pressure", "us"),
    "_pct": ("share", "us"),
    "_ms": ("contact", "us"),
    "_humidity": ("share", "plain"),
    "_kg_m3": ("air_density", "plain"),
    "_m_s2": ("acceleration", "plain"),
    "_kg_m2": ("moi", "plain"),
    "_m_s": ("speed", "plain"),
    "_rad_s": ("spin", "plain"),
    "_n_s": ("impulse", "plain"),
    "_kg": ("mass", "plain"),
    "_rad": ("angle", "plain"),
    "_hz": ("frequency", "plain"),
    "_j": ("energy", "plain"),
    "_tension_n": ("tension", "plain"),
    "_n": ("weight", "plain"),
    "_s": ("contact", "plain"),
    "_m": ("length", "plain"),
}
"""Endings of names, longer ones first: the scale they are shown on, and whether the number is stored in that scale's
US or SI unit or in the plain unit of the International System."""


def quantity_data() -> QuantityData:
    """Return scales, endings of names, quantities, sweet spots, and the reach of every interval in standard deviations.

    What is shown of a stored value is value * scale + offset, with ``digits`` places and ``unit`` behind it.
    """
    return {
        "scales": {name: _shown(name, "plain") for name in SCALES},
        "endings": {ending: _shown(scale, stored) for ending, (scale, stored) in ENDINGS.items()},
        "quantities": {
            name: {"label": each.label, "scale": each.scale, "colour": _hue(each.colour)}
            for name, each in QUANTITIES.items()
        },
        "spots": {name: {"label": spot.labelled(Terms()), "colour": _hue(spot.colour)} for name, spot in SPOTS.items()},
        "palette": dict(PALETTE),
        "reach": REACH,
    }


IN_WORDS = re.compile(r"\{([^{}]+)\}")
"""A length or a speed in words of the catalogue."""


def words_in_both_systems(words: str) -> dict[System, str]:
    """Return a text in either system of units, its values in braces converted.

    >>> words_in_both_systems("an axis {6 in} from the knob")["si"]
    'an axis 15.2 cm from the knob'
    """

    def converted(found: re.Match[str], reading: Reader) -> str:
        place = found[1].endswith((" in", " cm"))
        value = parse(found[1], "length" if place else "speed")
        return Slot(value, "place" if place else "speed", round=True).read(reading)

    return {system: IN_WORDS.sub(partial(converted, reading=reading), words) for system, reading in SYSTEMS.items()}


def _shown(scale: str, stored: Stored) -> BySystem:
    """Return how a stored number is shown in either system."""
    units: dict[System, Unit] = {"us": SCALES[scale].us, "si": SCALES[scale].si}
    stored_unit = Unit("", 1.0, 0) if stored == "plain" else units[stored]
    return {
        system: {
            "unit": unit.name,
            "scale": stored_unit.size / unit.size,
            "offset": (stored_unit.zero - unit.zero) / unit.size,
            "digits": unit.digits,
        }
        for system, unit in units.items()
    }


def _hue(colour: str) -> str:
    """Return a colour's name in the palette, which the page draws darker or lighter; "" for none."""
    return next((name for name, value in PALETTE.items() if value == colour), "")

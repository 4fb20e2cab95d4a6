"""Words of the library that tell quantities in both systems, for readers of one."""

from __future__ import annotations

import re
from functools import partial

from sweetspot.reports.quantities import SYSTEMS, Reader, System, with_minus_signs
from sweetspot.reports.sentences import Slot
from sweetspot.units.usual_units import WRITTEN

SCALES = {"oz": "mass", "in": "place", "ft": "distance", "mph": "speed", "lb/ft^3": "density", "oz in^2": "moi"}
"""The kind of a quantity beside which one of these stands; the other unit is an SI one."""
SIZES = {unit: size for kind in ("length", "mass", "speed", "density", "moi") for unit, size in WRITTEN[kind].items()}
NUMBER = r"-?\d[\d.]*(?:e[+-]?\d+)?"
METRIC, CUSTOMARY = r"kg m\^2|kg/m\^3|m/s|kg|g|mm|m", "|".join(map(re.escape, SCALES))
BOTH = re.compile(
    rf"(?P<number>{NUMBER}) (?:(?P<metric>{METRIC}) \({NUMBER} (?P<beside>{CUSTOMARY})\)"
    rf"|(?P<customary>{CUSTOMARY}) \({NUMBER} (?:{METRIC})\))"
)
"""As `sweetspot.units.shown` and its like write them: '0.8382 m (33 in)'; or the other way round."""
WALL_DIGITS = 3
"""Decimals of inches or centimetres, of a thickness given in millimetres."""


def in_one_system(words: str) -> dict[System, str]:
    """Return words whose quantities stand there in both systems, for readers of each.

    >>> in_one_system("its knob of 2.0 oz (57 g), 0.8382 m (33 in) from the tip")["us"]
    'its knob of 2.0 oz, 33.0 in from the tip'
    >>> in_one_system("a density of 301 kg/m^3 (18.8 lb/ft^3)")["si"]
    'a density of 301 kg/m³'
    """
    return {system: BOTH.sub(partial(_in_system, reader=reader), words) for system, reader in SYSTEMS.items()}


def _in_system(found: re.Match[str], reader: Reader) -> str:
    unit = found["metric"] or found["customary"]
    value = float(found["number"]) * SIZES[unit.replace(" ", "*")]
    digits = WALL_DIGITS if unit == "mm" else None
    return with_minus_signs(Slot(value, SCALES[found["beside"] or unit], digits=digits).read(reader))

"""Words of the library that tell lengths and weights in both systems, for readers of one."""

from __future__ import annotations

import re
from functools import partial

from sweetspot.report.quantities import SYSTEMS, Reader, System, with_minus_signs
from sweetspot.report.sentences import Slot
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED

NUMBER = r"-?\d[\d.]*(?:e[+-]?\d+)?"
UNIT = r"kg m\^2|oz in\^2|kg|g|mm|m|oz|in"
BOTH = re.compile(rf"({NUMBER}) ({UNIT}) \({NUMBER} (?:{UNIT})\)")
"""As `sweetspot.units.shown` and `shown_mass` write them: '0.8382 m (33 in)'."""
WEIGHTS = {"kg": 1.0, "g": 1e-3, "oz": OUNCE}
LENGTHS = {"m": 1.0, "mm": 1e-3, "in": INCH}
INERTIAS = {"kg m^2": 1.0, "oz in^2": OUNCE_INCH_SQUARED}
WALL_DIGITS = 3
"""Behind the point of inches or centimetres, of what is told in millimetres."""


def in_one_system(words: str) -> dict[System, str]:
    """Return words whose lengths and weights stand there in both systems, for readers of each.

    >>> in_one_system("its knob of 2.0 oz (57 g), 0.8382 m (33 in) from the tip")["us"]
    'its knob of 2.0 oz, 33.0 in from the tip'
    """
    return {system: BOTH.sub(partial(_told, reader=reader), words) for system, reader in SYSTEMS.items()}


def _told(found: re.Match[str], reader: Reader) -> str:
    value, unit = float(found[1]), found[2]
    if unit in INERTIAS:
        return with_minus_signs(Slot(value * INERTIAS[unit], "moi").read(reader))
    if unit in WEIGHTS:
        return with_minus_signs(Slot(value * WEIGHTS[unit], "mass").read(reader))
    digits = WALL_DIGITS if unit == "mm" else None
    return with_minus_signs(Slot(value * LENGTHS[unit], "place", digits=digits).read(reader))

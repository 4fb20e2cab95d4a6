"""Kinds of quantities at the border: how a number's name ends in SI and in US units, and what one US unit is in SI.

A field of an answer has its dimension in its type, ``exit_speed: Annotated[Number, SPEED]``; its key for other programs
is then ``exit_speed_m_s``, or ``exit_speed_mph``.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, TypeVar

from sweetspot.units.factors import (
    DEGREE,
    FOOT,
    INCH,
    INCH_OF_MERCURY,
    MPH,
    OUNCE,
    OUNCE_INCH_SQUARED,
    POUND_FORCE,
    RPM,
)

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

System = Literal["si", "us"]
Value = TypeVar("Value", float, "NDArray[np.float64]")


@dataclass(frozen=True)
class Dimension:
    """How numbers of one kind are named and counted.

    Parameters
    ----------
    si, us : what a key ends with in either system.
    size : of the US unit, SI.
    zero : of the US unit, SI.

    >>> SPEED.key("exit_speed", "us"), SPEED.counted(44.704, "us")
    ('exit_speed_mph', 100.0)
    """

    si: str
    us: str
    size: float = 1.0
    zero: float = 0.0

    def key(self, name: str, system: System) -> str:
        """Return a name with the unit's ending."""
        return name + (self.si if system == "si" else self.us)

    def counted(self, value: Value, system: System) -> Value:
        """Return a value in SI, or an array of them, in units of a system."""
        return value if system == "si" else (value - self.zero) / self.size


def _same(ending: str) -> Dimension:
    return Dimension(ending, ending)


RATIO = _same("")
TIME, IMPULSE, ENERGY, FREQUENCY = _same("_s"), _same("_n_s"), _same("_j"), _same("_hz")
VIBRATION, MODULUS, STIFFNESS = _same("_m_s"), _same("_pa"), _same("_n_m")
PER_SECOND_SQUARED = _same("_per_s2")
SPEED = Dimension("_m_s", "_mph", MPH)
SLOPE_PER_SPEED = Dimension("_s_m", "_per_mph", 1 / MPH)
LENGTH = Dimension("_m", "_in", INCH)
DISTANCE = Dimension("_m", "_ft", FOOT)
CURVATURE = Dimension("_per_m", "_per_ft", 1 / FOOT)
MASS = Dimension("_kg", "_oz", OUNCE)
MOI = Dimension("_kg_m2", "_oz_in2", OUNCE_INCH_SQUARED)
DENSITY = Dimension("_kg_m3", "_lb_ft3", 16 * OUNCE / FOOT**3)
FORCE = Dimension("_n", "_lbf", POUND_FORCE)
PRESSURE = Dimension("_pa", "_inhg", INCH_OF_MERCURY)
TEMPERATURE = Dimension("_degc", "_degf", 5 / 9, -160 / 9)
ACCELERATION = Dimension("_m_s2", "_ft_s2", FOOT)
ANGLE = Dimension("_rad", "_deg", DEGREE)
SPIN = Dimension("_rad_s", "_rpm", RPM)
SYMBOLS = {
    "_m_s": "m/s", "_mph": "mph", "_m_s2": "m/s^2", "_ft_s2": "ft/s^2", "_m": "m", "_in": "in", "_ft": "ft",
    "_kg": "kg", "_oz": "oz", "_kg_m2": "kg m^2", "_oz_in2": "oz in^2", "_n": "N", "_lbf": "lbf", "_pa": "Pa",
    "_inhg": "inHg", "_degc": "degC", "_degf": "degF", "_rad": "rad", "_deg": "deg", "_rad_s": "rad/s", "_rpm": "rpm",
    "_s": "s", "_hz": "Hz", "_j": "J", "_n_s": "N s", "_n_m": "N/m", "_kg_m3": "kg/m^3", "_lb_ft3": "lb/ft^3",
}  # fmt: skip
"""Units by what the name of a number in them ends with."""


def unit_of(key: str) -> str | None:
    """Return the unit of a number by its name; None: the name has none.

    >>> unit_of("exit_speed_low90_mph"), unit_of("moi_6in_kg_m2"), unit_of("home_runs")
    ('mph', 'kg m^2', None)
    """
    ending = max((end for end in SYMBOLS if key.endswith(end)), key=len, default=None)
    return None if ending is None else SYMBOLS[ending]

"""Units at the border: texts with units in, SI out; the sizes of people's units."""

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
from sweetspot.units.text import (
    CLAMPED,
    NUMBER,
    SI,
    Kind,
    format_density,
    format_length,
    format_mass,
    format_speed,
    grouped,
    to_si,
)

__all__ = [
    "CLAMPED",
    "DEGREE",
    "FOOT",
    "INCH",
    "INCH_OF_MERCURY",
    "MPH",
    "NUMBER",
    "OUNCE",
    "OUNCE_INCH_SQUARED",
    "POUND_FORCE",
    "RPM",
    "SI",
    "Kind",
    "format_density",
    "format_length",
    "format_mass",
    "format_speed",
    "grouped",
    "to_si",
]

"""Units at the border: texts with units in, SI out; the sizes of people's units; what is usual for each quantity."""

from sweetspot.units.sizes import (
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
from sweetspot.units.text import NUMBER, SI, Kind, grouped, parse, parse_position, shown, shown_density, shown_mass
from sweetspot.units.usual import (
    USUAL,
    check_angle,
    check_angles,
    check_place,
    check_usual,
    insisted,
    insisting,
    is_usual,
)

__all__ = [
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
    "USUAL",
    "Kind",
    "check_angle",
    "check_angles",
    "check_place",
    "check_usual",
    "grouped",
    "insisted",
    "insisting",
    "is_usual",
    "parse",
    "parse_position",
    "shown",
    "shown_density",
    "shown_mass",
]

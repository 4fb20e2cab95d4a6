"""What the sizes of implements usually are, part by part: a slip of units or of a decimal in a file shows there.

The bounds are wide, and choices; who means what he wrote insists (``--force``). A part that is not there weighs and
measures 0.
"""

from __future__ import annotations

from sweetspot.units import INCH
from sweetspot.units.usual import Usual, refuse_unusual

GRAM, MILLIMETRE, CENTIMETRE = 1e-3, 1e-3, 1e-2


def _grams(low: float, high: float) -> Usual:
    return Usual(low, high, "g", GRAM, above=0)


def _millimetres(low: float, high: float) -> Usual:
    return Usual(low, high, "mm", MILLIMETRE, above=0)


def _centimetres(low: float, high: float) -> Usual:
    return Usual(low, high, "cm", CENTIMETRE, above=0)


def _inches(low: float, high: float) -> Usual:
    return Usual(low, high, "in", INCH, above=0)


USUAL_SIZES: dict[str, dict[str, Usual]] = {
    "bat": {
        "turned.knob": _inches(1.2, 3.5),
        "turned.handle": _inches(0.6, 1.6),
        "turned.barrel": _inches(1.6, 3.5),
        "shell.knob_mass": _grams(10, 200),
        "shell.end_cap_mass": _grams(4, 90),
        "shell.joint_mass": _grams(2, 120),
        "point_mass.mass": _grams(0, 250),
    },
    "racket": {
        "moi_axis": _centimetres(3, 20),
        "first_frequency": Usual(20, 300, "Hz", above=0),
        "handle_length": _centimetres(10, 35),
        "head.length": _centimetres(15, 45),
        "head.width": _centimetres(12, 35),
        "head.rim": _centimetres(0.3, 3),
        "strings.tension": Usual(50, 450, "N", above=0),
        "strings.linear_density": Usual(0.2, 3, "g/m", GRAM, above=0),
        "strings.patch": _centimetres(0.4, 4),
    },
    "cricket-bat": {
        "handle": _millimetres(20, 60),
        "width": _millimetres(30, 140),
        "spine": _millimetres(8, 95),
        "edge": _millimetres(4, 60),
        "splice": _centimetres(5, 30),
        "grip_mass": _grams(10, 200),
    },
    "golf-club": {
        "diameter": _millimetres(4, 30),
        "wall": _millimetres(0.3, 6),
        "grip_mass": _grams(15, 200),
        "grip_length": _centimetres(12, 55),
        "head.mass": _grams(100, 500),
        "head.height": _centimetres(2, 10),
        "head.face_width": _centimetres(4, 16),
    },
    "hockey-stick": {
        "width": _millimetres(15, 90),
        "depth": _millimetres(8, 60),
        "wall": _millimetres(0.5, 15),
        "grip_mass": _grams(10, 200),
        "grip_length": _centimetres(10, 60),
        "hook_mass": _grams(5, 250),
        "hook_reach": _centimetres(1, 20),
    },
    "table-tennis-racket": {
        "blade_length": _centimetres(11, 22),
        "blade_width": _centimetres(11, 20),
        "handle_width": _millimetres(12, 60),
        "handle_thickness": _millimetres(10, 45),
    },
}
"""By kind, then by the field's name in the file. Everything in the catalogue lies within."""


def check_size(kind: str, field: str, value: float, given: object) -> None:
    """Refuse a size far from what is usual for this part of this kind of implement; fields without bounds pass.

    Parameters
    ----------
    value : SI.
    given : as it was written, for the message.

    >>> check_size("racket", "head.width", 0.25, "25 cm")
    >>> check_size("racket", "head.width", 0.025, "2.5 cm")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: head.width was given as 2.5 cm; usual is 12 to 35 cm. Check the unit and the decimal \
point, or add --force if it is meant
    """
    usual = USUAL_SIZES.get(kind, {}).get(field)
    if usual is not None:
        refuse_unusual(usual, value, field, given)

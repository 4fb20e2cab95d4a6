"""Bounds of implements: of single sizes by kind and field of the file, and of whole implements by sport.

Single sizes may each be possible and the whole absurd: a barrel in centimetres that was meant in inches makes a bat of
230 g. Everything in the catalogue lies within both.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from sweetspot.plausibility.bounds import PlausibleRange

ABOVE_NOTHING = (0.0, math.inf)
FROM_KNOB, DIAMETERS = "it counts from the knob end", "a profile has diameters, not radii"
GROWN_UP, WALLS = "the bats of grown-ups are 30 to 34 in long", "walls of metal bats are 2 to 5 mm"
LENGTH = "of the length"


def _part(low: float, high: float, unit: str) -> PlausibleRange:
    """Return bounds of a part's size; a part that is not there weighs and measures 0."""
    return PlausibleRange(low, high, unit, possible=ABOVE_NOTHING, absent=True)


SIZES: Mapping[str, PlausibleRange] = {
    "mass": PlausibleRange(2, 80, "oz"),
    "length": PlausibleRange(5, 60, "in", GROWN_UP),
    "bat_length": PlausibleRange(13.5, 50, "in", GROWN_UP),
    "greatest_diameter": PlausibleRange(1.6, 5, "in", DIAMETERS, possible=(1.1, math.inf)),
    "smallest_diameter": PlausibleRange(0.5, 3, "in", DIAMETERS, possible=ABOVE_NOTHING),
    "middle_of_the_outline": PlausibleRange(0.42, 0.95, "", "positions count from the knob end", per=LENGTH),
    "thinnest_wall": PlausibleRange(0.8, 20, "mm", WALLS),
    "thickest_wall": PlausibleRange(0.8, 12, "mm", WALLS),
    "end_of_the_taper": PlausibleRange(0.55, 1, "", FROM_KNOB, per=LENGTH),
    "joint": PlausibleRange(0.25, 0.75, "", FROM_KNOB, per=LENGTH),
    "blade": PlausibleRange(3, 11, "mm", "plies are 0.2 to 4 mm thick", per="in all"),
    "bore_diameter": PlausibleRange(0, 3, "in"),
    "bore_depth": PlausibleRange(0, 40, "in"),
    "cup_depth": PlausibleRange(0, 2.5, "in", "the cup of an end is about 1 in deep; a deeper hole is a bore"),
    "cup.depth": PlausibleRange(0, 2.5, "in", "the cup of an end is about 1 in deep; deeper holes are a [[bore]]"),
    "bat turned.knob": _part(1.2, 3.5, "in"),
    "bat turned.handle": _part(0.6, 1.6, "in"),
    "bat turned.barrel": _part(1.6, 3.5, "in"),
    "bat shell.knob_mass": _part(10, 200, "g"),
    "bat shell.end_cap_mass": _part(4, 90, "g"),
    "bat shell.knob_depth": _part(0, 60, "mm"),
    "bat shell.end_cap_depth": _part(0, 60, "mm"),
    "bat shell.joint_mass": _part(2, 120, "g"),
    "bat point_mass.mass": _part(0, 250, "g"),
    "racket moi_axis": _part(3, 20, "cm"),
    "racket first_frequency": _part(20, 300, "Hz"),
    "racket handle_length": _part(10, 35, "cm"),
    "racket head.length": _part(15, 45, "cm"),
    "racket head.width": _part(12, 35, "cm"),
    "racket head.rim": _part(0.3, 3, "cm"),
    "racket strings.tension": _part(50, 450, "N"),
    "racket strings.linear_density": _part(0.2, 3, "g/m"),
    "racket strings.patch": _part(0.4, 4, "cm"),
    "cricket-bat handle": _part(20, 60, "mm"),
    "cricket-bat width": _part(30, 140, "mm"),
    "cricket-bat spine": _part(8, 95, "mm"),
    "cricket-bat edge": _part(4, 60, "mm"),
    "cricket-bat splice": _part(5, 30, "cm"),
    "cricket-bat grip_mass": _part(10, 200, "g"),
    "golf-club diameter": _part(4, 30, "mm"),
    "golf-club wall": _part(0.3, 6, "mm"),
    "golf-club grip_mass": _part(15, 200, "g"),
    "golf-club grip_length": _part(12, 55, "cm"),
    "golf-club head.mass": _part(100, 500, "g"),
    "golf-club head.height": _part(2, 10, "cm"),
    "golf-club head.face_width": _part(4, 16, "cm"),
    "golf-club head.characteristic_time": _part(100, 400, "us"),
    "hockey-stick width": _part(15, 90, "mm"),
    "hockey-stick depth": _part(8, 60, "mm"),
    "hockey-stick wall": _part(0.5, 15, "mm"),
    "hockey-stick grip_mass": _part(10, 200, "g"),
    "hockey-stick grip_length": _part(10, 60, "cm"),
    "hockey-stick hook_mass": _part(5, 250, "g"),
    "hockey-stick hook_reach": _part(1, 20, "cm"),
    "table-tennis-racket blade_length": _part(11, 22, "cm"),
    "table-tennis-racket blade_width": _part(11, 20, "cm"),
    "table-tennis-racket handle_width": _part(12, 60, "mm"),
    "table-tennis-racket handle_thickness": _part(10, 45, "mm"),
    "paddle handle_length": _part(7, 20, "cm"),
    "paddle handle_width": _part(20, 50, "mm"),
    "paddle throat": _part(0.5, 15, "cm"),
    "paddle head_width": _part(14, 30, "cm"),
    "paddle corner_radius": _part(1, 13, "cm"),
    "paddle core_thickness": _part(5, 40, "mm"),
    "paddle core_density": _part(20, 400, "kg/m^3"),
    "paddle core_shear": _part(0.1, 100, "MPa"),
    "paddle core_modulus": _part(0.5, 500, "MPa"),
    "paddle patch": _part(4, 30, "mm"),
}
"""By the quantity, or by the implement's kind and the field's name in its file."""


@dataclass(frozen=True)
class WholeImplement:
    """Bounds for the implements of a sport; outside them an implement is computed all the same, and warned about.

    Parameters
    ----------
    mass : kg.
    balance : balance point from the grip's end over the length.
    gyration : radius of gyration about the balance point over the length.
    frequency : Hz, of the first bending mode hung freely.
    """

    mass: tuple[float, float]
    balance: tuple[float, float]
    gyration: tuple[float, float]
    frequency: tuple[float, float]


ROUND_BAT = WholeImplement((0.3, 1.3), (0.48, 0.74), (0.21, 0.35), (90.0, 320.0))
WHOLE: Mapping[str, WholeImplement] = {
    "baseball": ROUND_BAT,
    "softball": ROUND_BAT,
    "slow-pitch": ROUND_BAT,
    "cricket": WholeImplement((0.7, 1.7), (0.5, 0.7), (0.2, 0.33), (60.0, 250.0)),
    "tennis": WholeImplement((0.2, 0.42), (0.4, 0.6), (0.27, 0.38), (80.0, 250.0)),
    "badminton": WholeImplement((0.06, 0.13), (0.33, 0.55), (0.3, 0.43), (25.0, 120.0)),
    "table-tennis": WholeImplement((0.08, 0.3), (0.45, 0.72), (0.17, 0.32), (90.0, 700.0)),
    "squash": WholeImplement((0.11, 0.21), (0.45, 0.6), (0.26, 0.38), (60.0, 220.0)),
    "pickleball": WholeImplement((0.17, 0.3), (0.5, 0.7), (0.2, 0.34), (150.0, 600.0)),
    "golf": WholeImplement((0.25, 0.65), (0.6, 0.85), (0.22, 0.42), (18.0, 120.0)),
    "field-hockey": WholeImplement((0.35, 0.8), (0.45, 0.72), (0.24, 0.37), (60.0, 250.0)),
}
"""By the sport's catalogue name."""
SAME_MODEL: Mapping[str, float] = {"mass": 1.5, "balance_point": 1.2, "moi": 1.7, "period": 1.2, "frequency": 1.7}
"""Factor by which a bat of one model may differ from it, by kind of measurement. Our choice: wood of one profile
differs by half of these; a slip of a unit or of a column by more."""
STROKES = (0.5, 1.7)
"""Of the sport's usual speed, from children to the best: a warning outside, where miles per hour were often m/s."""

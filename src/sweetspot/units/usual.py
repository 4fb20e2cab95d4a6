"""What is usual for every quantity that people give: a slip of units or of a decimal is refused by its size.

The bounds are wide: what players, laboratories and weather do lies well inside them. They are choices, not physics;
who means what he wrote insists (``--force`` on the command line, `insisting` in Python).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import Any

from sweetspot.errors import InputError
from sweetspot.units.factors import DEGREE, FOOT, INCH, INCH_OF_MERCURY, MPH, OUNCE, RPM
from sweetspot.units.usual_units import in_unit_of

LONGEST_IMPLEMENT = 5.0
"""m; nothing that is swung at a ball is nearly as long, and in inches every bat is longer."""

_insisted: ContextVar[bool] = ContextVar("insisted", default=False)


@contextmanager
def insisting(really: bool = True) -> Iterator[None]:
    """Take every number as it is given, within this block."""
    token = _insisted.set(really)
    try:
        yield
    finally:
        _insisted.reset(token)


@dataclass(frozen=True)
class Usual:
    """What is usual for a quantity.

    Parameters
    ----------
    low, high : bounds in ``unit``.
    unit : as people write it.
    size : of that unit in SI.
    hint : what to do, where more is to say than to check the unit.
    above, below : outside these, in ``unit``, a value is impossible; what takes it refuses it in its own words.
    """

    low: float
    high: float
    unit: str
    size: float = 1.0
    hint: str = ""
    above: float = -math.inf
    below: float = math.inf

    def holds(self, value: float) -> bool:
        """Return whether a value in SI is usual, bounds included, or impossible and so not for us to tell."""
        slack = 1e-9 * max(abs(self.low), abs(self.high)) * self.size
        within = self.low * self.size - slack <= value <= self.high * self.size + slack
        return within or not self.above * self.size < value < self.below * self.size


MOST_BAT_SPEED = 70.001 / MPH
"""mph; just above what a swing may have at all, so that 70 m/s, a slip of 70 mph, is not usual."""
FILE_UNITS = "write the unit that the file is in behind the heading: _mph, _m_s or _km_h"
SPIN = "spins of balls stay below 15000 rpm; write rpm, or rad/s for radians"
SEA_LEVEL = (
    "a barometer is reduced to sea level, and the elevation is counted on top; for a pressure that was measured at the "
    "field give it with --elevation 0ft"
)

# How fast a ball leaves differs from sport to sport: `sports.toml` of the catalogue has the bounds of each.
USUAL: dict[str, Usual] = {
    "pitch_speed": Usual(10, 125, "mph", MPH, "pitches come with up to 110mph; for a ball at rest say tee", above=0),
    "release_speed": Usual(15, 125, "mph", MPH, above=15),
    "bat_speed": Usual(5, 150, "mph", MPH, above=0, below=MOST_BAT_SPEED),
    "closing_speed": Usual(0, 275, "mph", MPH, "it is that of ball and bat together", above=0),
    "median_bat_speed": Usual(33, 95, "mph", MPH, FILE_UNITS),
    "launch_angle": Usual(-89, 89, "deg", DEGREE, "0deg is level, 90deg straight up"),
    "spray": Usual(-90, 90, "deg", DEGREE, "0deg is centre field, 45deg the right foul line"),
    "bearing": Usual(-90, 90, "deg", DEGREE, "0deg is centre field, 45deg the right foul line"),
    "attack_angle": Usual(-60, 60, "deg", DEGREE, above=-65, below=65),
    "attack_direction": Usual(-90, 90, "deg", DEGREE),
    "approach_angle": Usual(-60, 30, "deg", DEGREE),
    "tilt": Usual(0, 85, "deg", DEGREE),
    "backspin": Usual(-15000, 15000, "rpm", RPM, SPIN),
    "sidespin": Usual(-15000, 15000, "rpm", RPM, SPIN),
    "gyrospin": Usual(-15000, 15000, "rpm", RPM, SPIN),
    "pitch_backspin": Usual(-4000, 4000, "rpm", RPM),
    "pitch_sidespin": Usual(-4000, 4000, "rpm", RPM),
    "temperature": Usual(-40, 60, "degC"),
    "humidity": Usual(0, 1, "", 1, "a ratio from 0 to 1, or a percentage: 50 % is 0.5"),
    "pressure": Usual(26, 32, "inHg", INCH_OF_MERCURY, SEA_LEVEL),
    "elevation": Usual(-1400, 15000, "ft", FOOT),
    "wind_speed": Usual(0, 60, "mph", MPH, "the direction is given with --wind-direction"),
    "wind_direction": Usual(-360, 360, "deg", DEGREE, "the wind blows to there: 0deg is out to centre field"),
    "calm_below": Usual(0, 300, "ft", FOOT),
    "height": Usual(0, 40, "ft", FOOT, above=0),
    "launch_height": Usual(0, 11, "ft", FOOT, "a ball is hit from the ground up to a smash or a serve", above=0),
    "forward": Usual(-10, 10, "ft", FOOT),
    "offset": Usual(-3, 3, "in", INCH, "ball and barrel touch up to about 2.7 in"),
    "ball_cor": Usual(0.2, 0.9, "", above=0),
    "mass": Usual(2, 80, "oz", OUNCE),
    "length": Usual(5, 60, "in", INCH, "the bats of grown-ups are 30 to 34 in long"),
    "bbcor": Usual(-0.2, 0.8, "", 1, "bats have 0.2 to 0.6: check the speeds and their columns"),
    "bat_length": Usual(13.5, 50, "in", INCH, "the bats of grown-ups are 30 to 34 in long"),
    "balance_point": Usual(4, 60, "in", INCH, "it counts from the knob end", above=0),
    "period": Usual(0.5, 3, "s", 1.0, "one swing is there and back; give the time of one, not of ten", above=0),
    "greatest_diameter": Usual(1.6, 5, "in", INCH, "a profile has diameters, not radii", above=1.1),
    "smallest_diameter": Usual(0.5, 3, "in", INCH, "a profile has diameters, not radii", above=0),
    "middle_of_the_outline": Usual(0.42, 0.95, "of the length", 1, "positions count from the knob end"),
    "thinnest_wall": Usual(0.8, 20, "mm", 1e-3, "walls of metal bats are 2 to 5 mm"),
    "thickest_wall": Usual(0.8, 12, "mm", 1e-3, "walls of metal bats are 2 to 5 mm"),
    "end_of_the_taper": Usual(0.55, 1, "of the length", 1, "it counts from the knob end"),
    "joint": Usual(0.25, 0.75, "of the length", 1, "it counts from the knob end"),
    "blade": Usual(3, 11, "mm in all", 1e-3, "plies are 0.2 to 4 mm thick"),
    "bore_diameter": Usual(0, 3, "in", INCH),
    "bore_depth": Usual(0, 40, "in", INCH),
    "cup_depth": Usual(0, 2.5, "in", INCH, "the cup of an end is about 1 in deep; a deeper hole is a bore"),
    "cup.depth": Usual(0, 2.5, "in", INCH, "the cup of an end is about 1 in deep; deeper holes are a [[bore]]"),
}
"""By the name of the quantity, as options and columns have it. [The widths of these bounds are our choice.]"""


def example_of(what: str) -> str:
    """Return a quantity as it might be written, for messages; "" for one that is not in `USUAL`.

    >>> example_of("--pressure"), example_of("--ball")
    ('30 inHg', '')
    """
    usual = USUAL.get(what.removeprefix("--").replace("-", "_"))
    if usual is None:
        return ""
    middle = usual.low + (usual.high - usual.low) * 0.6
    return f"{float(f'{middle:.1g}' if middle > 1 else f'{middle:.2g}'):g} {usual.unit}".strip()


def check_usual(value: float, what: str, given: object) -> None:
    """Refuse a value outside what is usual for its quantity; what is not in `USUAL` passes.

    Parameters
    ----------
    value : SI.
    what : name of the quantity, or its option: ``--wind-speed``.
    given : as it was written, for the message.

    >>> check_usual(44.7, "--wind-speed", "100mph")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: --wind-speed was given as 100mph; usual is 0 to 60 mph; the direction is given with \
--wind-direction. Check the unit and the decimal point, or add --force if it is meant
    """
    usual = USUAL.get(what.removeprefix("--").replace("-", "_").replace(" ", "_"))
    if usual is not None:
        refuse_unusual(usual, value, what, given)


def refuse_unusual(usual: Usual, value: float, what: str, given: object) -> None:
    """Refuse a value outside what is usual, unless it is insisted on.

    Parameters
    ----------
    value : SI.
    what : name of the quantity, for the message.
    given : as it was written, for the message.
    """
    if _insisted.get() or usual.holds(value):
        return
    hint = f"; {usual.hint}" if usual.hint else ""
    (low, high), unit = in_unit_of(str(given), (usual.low, usual.high), usual.unit)
    usually = f"{float(f'{low:.3g}'):g} to {float(f'{high:.3g}'):g}"
    raise InputError(
        f"{what} was given as {given}; usual is {usually}{f' {unit}' if unit else ''}{hint}. Check the unit and the "
        "decimal point, or add --force if it is meant"
    )


def insisted() -> bool:
    """Return whether every number is to be taken as it is given."""
    return _insisted.get()


def is_usual(value: float, name: str) -> bool:
    """Return whether a value (SI) is usual for a quantity of `USUAL`, or taken as it is because somebody insists.

    >>> is_usual(0.27, "pitch_speed"), is_usual(40.0, "pitch_speed")
    (False, True)
    """
    return _insisted.get() or USUAL[name].holds(value)


def check_place(value: Any, what: str) -> None:
    """Refuse a place on an implement, or one of many, that is no place in metres.

    >>> check_place(27, "position")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: position is 27 m from the knob end; places are in metres, and 27 in are 27 * 0.0254
    """
    farthest = value if isinstance(value, (float, int)) else _farthest(value)
    if not abs(farthest) <= LONGEST_IMPLEMENT:
        raise InputError(
            f"{what} is {farthest:g} m from the knob end; places are in metres, and {farthest:g} in are "
            f"{farthest:g} * 0.0254"
        )


def _farthest(places: Any) -> float:
    """Return the place farthest from the knob end; one that is not known is none."""
    import numpy as np

    known = np.asarray(places, float)
    known = known[np.isfinite(known)]
    return float(known[np.abs(known).argmax()]) if known.size else 0.0


def check_angles(values: Any, what: str) -> None:
    """Refuse an angle, or one of many, that is none in radians.

    >>> check_angles([0.4, 28], "launch_angle")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: launch_angle is 28 rad; angles are in radians: write math.radians(28)
    """
    if isinstance(values, (float, int)):
        check_angle(values, what)
        return
    import numpy as np

    angles = np.ravel(np.asarray(values, float))
    wrong = angles[~(np.abs(angles) <= math.tau)]
    if len(wrong):
        check_angle(float(wrong[0]), what)


def check_angle(value: float, what: str) -> None:
    """Refuse an angle that is none in radians.

    >>> check_angle(28, "launch_angle")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: launch_angle is 28 rad; angles are in radians: write math.radians(28)
    >>> check_angle(7, "wind")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: wind is 7 rad, more than a whole turn; write 0.7168, or math.radians(7) if degrees
    """
    if not math.isfinite(value):
        raise InputError(f"{what} is {value:g}; give a finite number of radians, or leave that row out")
    if math.tau < abs(value) < 2 * math.tau:
        within = math.remainder(value, math.tau)
        raise InputError(
            f"{what} is {value:g} rad, more than a whole turn; write {within:.4g}, "
            f"or math.radians({value:g}) if degrees"
        )
    if abs(value) > math.tau:
        raise InputError(f"{what} is {value:g} rad; angles are in radians: write math.radians({value:g})")

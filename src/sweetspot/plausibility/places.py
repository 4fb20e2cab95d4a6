"""Places and angles that are none in SI: inches given for metres, degrees for radians."""

from __future__ import annotations

import math
from typing import Any

from sweetspot.errors import InputError

LONGEST_IMPLEMENT = 5.0
"""m; nothing that is swung at a ball is nearly as long, and in inches every bat is longer."""


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

    finite = np.asarray(places, float)
    finite = finite[np.isfinite(finite)]
    return float(finite[np.abs(finite).argmax()]) if finite.size else 0.0


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

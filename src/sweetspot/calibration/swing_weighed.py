"""A swing weight as a sport's people tell it, as a measurement: a club's D2, a racket's 316 kg cm^2."""

from __future__ import annotations

import math
import re

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.written import SEPARATOR, parse_measured
from sweetspot.catalog.swing_weights import MOMENTS, swing_weight
from sweetspot.errors import InputError
from sweetspot.plausibility import parse

POINTS = re.compile(r"\s*[A-Za-z]\d(?:\.(\d+))?\s*")


def of_swing_weight(text: str, sport: str, *, mass: Measured | None, what: str = "swing weight") -> Measurement:
    """Return the moment of inertia that a swing weight is, or the balance point that a first moment tells of a weight.

    Parameters
    ----------
    text : a letter with points, ``D2`` or ``D2.5±0.2``, in a sport that has them; else a quantity with its unit.
    sport : name in the catalogue.
    mass : kg, weighed; needed where the sport's swing weight is a first moment, M = m (x - axis).

    Raises
    ------
    InputError
        for a text that is none, or a first moment without a weight.

    >>> found = of_swing_weight("D2", "golf", mass=Measured(0.310, 0.0005))  # (217 in oz / 10.93 oz + 14 in) = 33.84 in
    >>> found.name, round(found.value.value, 4), round(found.value.error, 4)
    ('balance point', 0.8597, 0.0041)
    >>> of_swing_weight("316kg*cm^2±1kg*cm^2", "tennis", mass=None).axis
    0.1
    """
    convention = swing_weight(sport)
    if convention.order == 2:
        return Measurement("moi", parse_measured(text, "moi", what), axis=convention.axis)
    if convention.zero is None or convention.step is None:
        moment = parse_measured(text, MOMENTS[1], what)
    else:
        written, *error = SEPARATOR.split(text.strip(), maxsplit=1)
        value = convention.moment_of(written)
        digits = POINTS.fullmatch(written)
        assert digits is not None  # or it is no swing weight
        points = parse(error[0], "ratio", f"the error of {what}") if error else 10.0 ** -len(digits[1] or "")
        if not points > 0:
            raise InputError(f"the error of {what} was given as {error[0]!r}; allowed is more than 0")
        moment = Measured(value, points * convention.step * convention.size)
    if mass is None:
        raise InputError(f"{what} {text} tells of the balance point only together with the weight; give the mass too")
    arm = moment.value / mass.value
    error_of_arm = math.hypot(moment.error / mass.value, arm * mass.error / mass.value)
    return Measurement("balance_point", Measured(convention.axis + arm, error_of_arm))

"""Texts with units as the numbers of a setup: on the command line, and where Python is given texts."""

from __future__ import annotations

from typing import NamedTuple

from sweetspot.answers.setups import Written
from sweetspot.calibration.measured import SEPARATOR, Measured, parse_measured
from sweetspot.errors import InputError
from sweetspot.plausibility import parse, parse_position
from sweetspot.units import Kind
from sweetspot.units.quantities import KIND_OF

TEE = "tee"
"""A pitch speed of 0, which must be meant."""


class Owner(NamedTuple):
    """What a number belongs to: an implement ``length`` m long, and a ``sport``; "": any."""

    length: float = 0.0
    sport: str = ""


def number_of_text(
    text: str,
    name: str,
    annotation: str,
    *,
    what: str,
    of: Owner = Owner(),
    quantity: str = "",
    errors: bool = True,
) -> Written:
    """Return the number that a text gives, SI.

    Parameters
    ----------
    text : number and unit; what its annotation allows may have its error behind ±, or count from the tip.
    name, annotation : of the field of a setup, or of the parameter.
    what : its name for messages.
    of : the implement on which a place lies, and whose sport's bounds hold.
    quantity : its name in the table of bounds; "": the field's.
    errors : whether errors count; else what is written behind ± is left out.
    """
    kind = KIND_OF[name]
    alone = SEPARATOR.split(text, maxsplit=1)[0]
    if name == "pitch_speed" and text.strip().lower() == TEE:
        return 0.0
    if "Place" in annotation:
        place = parse_position(alone if "Exact" in annotation else text, length=of.length, what=what)
        return _with_error(place, error_behind(text, kind, what) if errors and "Exact" in annotation else 0.0)
    can_err = "Written" in annotation or "Exact" in annotation
    value = parse(alone if can_err else text, kind, what, sport=of.sport, quantity=quantity)
    if name == "pitch_speed" and value <= 0:
        raise InputError(
            f"{what} was given as {text!r}; allowed is a speed above zero towards the bat, or tee for a ball at rest"
        )
    if not errors or not can_err:
        return value
    return _with_error(
        value, error_behind(text, kind, what) if "Exact" in annotation else parse_measured(text, kind, what).error
    )


def _with_error(value: float, error: float) -> Written:
    return Measured(value, error) if error else value


def error_behind(text: str, kind: Kind, what: str) -> float:
    """Return the error behind a quantity's ±, SI; 0 where there is none: a place that was asked about is exact.

    >>> error_behind("6in-from-tip±0.5in", "length", "--at"), error_behind("6in-from-tip", "length", "--at")
    (0.0127, 0.0)
    """
    behind = SEPARATOR.split(text, maxsplit=1)[1:]
    error = parse(behind[0], kind, f"the error of {what}") if behind else 0.0
    if behind and not error > 0:
        raise InputError(f"the error of {what} was given as {behind[0]!r}; allowed is more than 0")
    return error

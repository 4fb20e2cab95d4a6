"""Quantities that are written with an error, 70mph±2mph."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.units import Kind


def error_of(text: str | None, kind: Kind, what: str) -> float:
    """Return the error of a quantity as it was written, SI: behind ±, else one unit of its last digit; 0 for None."""
    from sweetspot.calibration.written import parse_measured

    if text is None or text.strip().lower() == "tee":
        return 0.0
    return parse_measured(text, kind, what).error


def error_behind(text: str, kind: Kind, what: str) -> float:
    """Return the error behind a quantity's ±, SI; 0 where there is none: a place that was asked about is exact.

    >>> error_behind("6in-from-tip±0.5in", "length", "--at"), error_behind("6in-from-tip", "length", "--at")
    (0.0127, 0.0)
    """
    from sweetspot.calibration.written import SEPARATOR
    from sweetspot.plausibility import parse

    behind = SEPARATOR.split(text, maxsplit=1)[1:]
    error = parse(behind[0], kind, f"the error of {what}") if behind else 0.0
    if behind and not error > 0:
        raise InputError(f"the error of {what} was given as {behind[0]!r}; allowed is more than 0")
    return error


def without_error(text: str) -> str:
    """Return a quantity as it was written, without the error behind its ±.

    >>> without_error("70mph±2mph"), without_error("70mph")
    ('70mph', '70mph')
    """
    from sweetspot.calibration.written import SEPARATOR

    return SEPARATOR.split(text, maxsplit=1)[0]

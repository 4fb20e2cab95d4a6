"""Quantities that are written with an error, 70mph±2mph."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sweetspot.units import Kind


def error_of(text: str | None, kind: Kind, what: str) -> float:
    """Return the error of a quantity as it was written, SI: behind ±, else one unit of its last digit; 0 for None."""
    from sweetspot.calibration.written import parse_measured

    if text is None or text.strip().lower() == "tee":
        return 0.0
    return parse_measured(text, kind, what).error


def without_error(text: str) -> str:
    """Return a quantity as it was written, without the error behind its ±.

    >>> without_error("70mph±2mph"), without_error("70mph")
    ('70mph', '70mph')
    """
    from sweetspot.calibration.written import SEPARATOR

    return SEPARATOR.split(text, maxsplit=1)[0]

"""Text of the paper's chain with numbers in it that other documents show in their readers' units."""

from __future__ import annotations

from typing import NamedTuple

from sweetspot.units import INCH, MPH


class Number(NamedTuple):
    """A number in words.

    Parameters
    ----------
    value : SI.
    scale : for other documents, a name of `sweetspot.reports.quantities.SCALES`.
    text : as the chain itself shows it, with its unit.
    digits : in other documents; None: as many as is usual.
    """

    value: float
    scale: str
    text: str
    digits: int | None = None


class Words(str):
    """A text with numbers in it; as plain text, they are in the units of the chain.

    Parameters
    ----------
    template : the text with a pair of braces for each number.
    numbers : in the order of the braces.

    >>> held = Words("held {} from its end", inches(0.1524))
    >>> held, held.template, held.numbers[0].value
    ('held 6 in from its end', 'held {} from its end', 0.1524)
    """

    template: str
    numbers: tuple[Number, ...]

    def __new__(cls, template: str, *numbers: Number) -> Words:
        made = super().__new__(cls, template.format(*(number.text for number in numbers)))
        made.template, made.numbers = template, numbers
        return made


def inches(length: float) -> Number:
    """Return a length in m that the chain shows in inches."""
    return Number(length, "place", f"{length / INCH:.3g} in")


def miles_per_hour(speed: float) -> Number:
    """Return a speed in m/s that the chain shows in miles per hour."""
    return Number(speed, "speed_change", f"{speed / MPH:.1f} mph", 1)


def metres(height: float, text: str) -> Number:
    """Return a height in m that the chain shows in m."""
    return Number(height, "place", f"{text} m", 1)

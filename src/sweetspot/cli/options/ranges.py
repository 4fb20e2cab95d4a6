"""Ranges as they are written on a command line: from, to, and how many values."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.units import Kind

MOST_VALUES = 100
DIGITS = 14
"""Of a value between: enough for any unit, too few for the last bits of a binary number."""


def spread(text: str, kind: Kind, what: str, *, sport: str = "") -> tuple[float, ...]:
    """Return the values of a range written as ``90mph:110mph:5``, SI, evenly spaced.

    >>> spread("0m:2m:3", "length", "--height")
    (0.0, 1.0, 2.0)
    """
    from sweetspot.plausibility import parse

    parts = text.split(":")
    if len(parts) != 3:
        raise InputError(f"{what} was given as {text!r}; a range is from, to and how many values: 90mph:110mph:5")
    first, last, count = parts
    if not count.strip().isdecimal() or not 1 <= int(count) <= MOST_VALUES:
        raise InputError(f"{what} asks for {count!r} values; allowed is 1 to {MOST_VALUES}")
    low, high = (parse(end, kind, what, sport=sport) for end in (first, last))
    steps = max(int(count) - 1, 1)
    # people write few digits: what binary numbers add behind them is not theirs
    return tuple(float(f"{low + (high - low) * step / steps:.{DIGITS}g}") for step in range(int(count)))

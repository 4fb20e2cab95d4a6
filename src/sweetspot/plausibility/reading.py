"""What people type, judged while it is read: text with a unit in, SI out."""

from __future__ import annotations

import re

from sweetspot.errors import InputError
from sweetspot.plausibility.table import LARGEST, SMALLEST, TABLE, check, quantity_named
from sweetspot.units.text import NUMBER, SI, Kind, format_length, to_si, with_points

FROM_END = re.compile(r"[\s-]+from[\s-]+(?:the[\s-]+)?(tip|knob)\s*$", re.IGNORECASE)


def example_of(what: str) -> str:
    """Return a quantity as it might be written, for messages; "" for one without bounds, or with a sport's.

    >>> example_of("--pressure"), example_of("--ball")
    ('30 inHg', '')
    """
    usual = TABLE.get(quantity_named(what), {}).get("")
    if usual is None:
        return ""
    middle = usual.low + (usual.high - usual.low) * 0.6
    return f"{float(f'{middle:.1g}' if middle > 1 else f'{middle:.2g}'):g} {usual.unit} {usual.per}".strip()


def parse(text: str | float, kind: Kind, what: str = "value", *, sport: str = "", quantity: str = "") -> float:
    """Return a text with a unit as a number in SI, and refuse one that its quantity cannot have; see `to_si`, `check`.

    Parameters
    ----------
    text : number and unit; a bare number only for ratios.
    what : its name, for messages; where the table of bounds has a quantity of that name, its bounds hold.
    sport : whose bounds; "": any.
    quantity : its name in the table of bounds; "": what ``what`` names.

    >>> round(parse("33 1/2 in", "length"), 6), round(parse("2 ft 9.5 in", "length"), 6)
    (0.8509, 0.8509)
    """
    example = example_of(quantity or what) or SI[kind][1]
    value = to_si(text, kind, what, example=example)
    if abs(value) > LARGEST[kind] or 0 < abs(value) < SMALLEST:
        raise InputError(f"{what} was given as {str(text)!r}, beyond anything in sport; write for example {example}")
    check(value, what, text, quantity=quantity, sport=sport)
    return value


def parse_position(text: str, *, length: float, what: str = "position") -> float:
    """Return a place on a bat in m from the knob end: ``27in``, ``6in-from-tip`` or ``0.152m-from-tip``.

    >>> [round(parse_position(text, length=0.8382), 4) for text in ("6in-from-tip", "6 in from Tip")]
    [0.6858, 0.6858]
    """
    text = FROM_END.sub(lambda end: f"-from-{end[1].lower()}", text)
    for ending, from_tip in (("-from-tip", True), ("-from-knob", False)):
        if text.strip().endswith(ending):
            distance = parse(text.strip().removesuffix(ending), "length", what)
            if from_tip and distance > length * (1 + 1e-9):
                raise InputError(
                    f"{what} was given as {text.strip()}; that is off the bat, {format_length(length)} long"
                )
            return length - distance if from_tip else distance
    if "-from-" in text or NUMBER.match(with_points(text)):
        missing = "" if "-from-" in text else " without a unit"
        raise InputError(
            f"{what} was given as {text!r}{missing}; places are written 27in, from the knob end, or 6in-from-tip"
        )
    return parse(text, "length", what)

"""Stiffness of a racket's frame as shops tell it, RA, and the first frequency that such a frame has."""

from __future__ import annotations

from sweetspot.catalog.records import quantity, read_table, unwrapped
from sweetspot.errors import InputError

FILE = "racket_stiffness.toml"


def frequency_of_ra(ra: float) -> float:
    """Return the first bending frequency in Hz of a racket hung freely, from its RA.

    f = f_0 + s (RA - RA_0); the numbers are recalled, good to some 10 Hz.

    Parameters
    ----------
    ra : 45 to 80.

    >>> round(frequency_of_ra(70))
    151
    """
    table = read_table(FILE)["ra"]
    low, high = unwrapped(table["low"]), unwrapped(table["high"])
    if not low <= ra <= high:
        raise InputError(f"ra was given as {ra:g}; frames have {low:g} to {high:g}. Give first_frequency in Hz instead")
    base, slope = quantity(table, "frequency", "frequency", "ra"), quantity(table, "slope", "frequency", "ra")
    assert base is not None and slope is not None
    return base + slope * (ra - float(unwrapped(table["reference"])))

"""A root between two bounds, for small functions: SciPy's optimizers take a quarter of a second to import."""

from __future__ import annotations

from collections.abc import Callable

STEPS = 200
"""Most evaluations; every third step at least halves the bounds, so this is never reached."""


def root_between(function: Callable[[float], float], low: float, high: float, *, tolerance: float = 1e-14) -> float:
    """Return the place at which a continuous function changes sign, by the Illinois form of the rule of false position.

    Parameters
    ----------
    low, high : bounds at which the function has different signs, or is zero.
    tolerance : of the root, in its own unit.

    >>> round(root_between(lambda x: x * x - 2, 0.0, 2.0), 12)
    1.414213562373
    """
    at_low, at_high = function(low), function(high)
    if at_low * at_high > 0:
        raise ValueError(f"the function is {at_low:g} at {low:g} and {at_high:g} at {high:g}; no sign changes between")
    for step in range(STEPS):
        if at_high == 0 or abs(high - low) <= tolerance:
            return high
        middle = (low + high) / 2 if step % 3 == 2 else (low * at_high - high * at_low) / (at_high - at_low)
        found = function(middle)
        if found * at_high <= 0:
            low, at_low = high, at_high
        else:
            at_low /= 2
        high, at_high = middle, found
    return high

"""Three verdicts on a value: fine, unusual (refused unless somebody insists), impossible (always refused)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from sweetspot.units.factors import FOOT
from sweetspot.units.usual_units import TEMPERATURES, WRITTEN, in_unit_of

Judged = Literal["fine", "unusual", "impossible"]
SIZES: dict[str, tuple[float, float]] = {
    **{unit: (size, 0.0) for sizes in WRITTEN.values() for unit, size in sizes.items()},
    **TEMPERATURES,
    "%": (0.01, 0.0),
    "ft/s^2": (FOOT, 0.0),
}
"""Size in SI of each unit, and which number stands for 0."""
ANY = (-math.inf, math.inf)
_insisted: ContextVar[bool] = ContextVar("insisted", default=False)


@contextmanager
def insisting(really: bool = True) -> Iterator[None]:
    """Accept unusual values within this block; impossible ones are still refused."""
    token = _insisted.set(really)
    try:
        yield
    finally:
        _insisted.reset(token)


def insisted() -> bool:
    """Return whether unusual values are accepted."""
    return _insisted.get()


@dataclass(frozen=True)
class PlausibleRange:
    """Bounds of a quantity.

    Parameters
    ----------
    low, high : of what is fine, in ``unit``.
    unit : as people write it; "" for ratios.
    hint : what to do, where there is more to say than to check the unit.
    possible : in ``unit``: above the first, up to and with the second.
    absent : whether 0 is fine, for it means that there is none: a ball at rest, a part that is missing.
    per : what the unit counts, behind it in messages: "of the length".
    why : where the bounds come from.

    >>> speed = PlausibleRange(10, 125, "mph", possible=(0, 157), absent=True)
    >>> [speed.verdict(value * 0.44704) for value in (0, 5, 90, 130, 160)]
    ['fine', 'unusual', 'fine', 'unusual', 'impossible']
    """

    low: float
    high: float
    unit: str
    hint: str = ""
    possible: tuple[float, float] = ANY
    absent: bool = False
    per: str = ""
    why: str = ""

    @cached_property
    def fine(self) -> tuple[float, float]:
        """Least and greatest value that is fine, SI; that 0 may stand for nothing does not count."""
        return self._in_si(self.low), self._in_si(self.high)

    def verdict(self, value: float) -> Judged:
        """Judge a value in SI; the ends of what is fine are fine."""
        low, high = self.fine
        least, most = self.can_be
        slack = 1e-9 * max(abs(low), abs(high))
        if low - slack <= value <= high + slack or (self.absent and value == 0):
            return "fine"
        return "unusual" if least < value <= most + slack else "impossible"

    def accepts(self, value: float) -> bool:
        """Return whether a value in SI is fine, or unusual and insisted on."""
        verdict = self.verdict(value)
        return verdict == "fine" or (verdict == "unusual" and insisted())

    @cached_property
    def can_be(self) -> tuple[float, float]:
        """Bounds of what is possible, SI."""
        return self._in_si(self.possible[0]), self._in_si(self.possible[1])

    @property
    def sign(self) -> str:
        """The unit as answers show it."""
        return self.unit.replace("deg", "°") if self.unit in TEMPERATURES else self.unit

    def in_unit(self, value: float) -> float:
        """Return a value in SI in our unit."""
        return in_unit(value, self.unit)

    def objection(self, value: float, what: str, given: object, *, of: str = "", column: bool = False) -> str:
        """Say what was given (SI: ``value``), what is allowed and what to do; "" for a value that is accepted.

        Parameters
        ----------
        column : whether it is a cell of a table, one row of many.
        """
        if self.accepts(value):
            return ""
        unusual = self.verdict(value) == "unusual"
        bounds, word = (self.low, self.high), "usual"
        if not unusual and all(map(math.isfinite, self.possible)):
            bounds, word = self.possible, "possible"
        ends, unit = in_unit_of(str(given), bounds, self.unit)
        low, high = (f"{float(f'{end:.3g}'):g}" for end in ends)
        least = self.can_be[0]
        without_least = word == "possible" and value <= least and self.verdict(least) == "impossible"
        span = f"more than {low}, up to {high}" if without_least else f"{low} to {high}"
        allowed = " ".join(part for part in (f"{word} is {span}", unit, self.per, of) if part)
        if self.hint:
            allowed += f"; {self.hint}"
        if column:
            return f"{what} is {given}; {allowed}; is the column in another unit?"
        insist = ", or add --force if it is intended" if unusual else ""
        return f"{what} was given as {given}; {allowed}. Check the unit and the decimal point{insist}"

    def _in_si(self, value: float) -> float:
        size, zero = SIZES.get(self.unit, (1.0, 0.0))
        return (value - zero) * size


def in_unit(value: float, unit: str) -> float:
    """Return a value in SI in a unit; "" for a ratio.

    >>> in_unit(60.0, "degF"), round(in_unit(44.704, "mph"), 9)
    (140.0, 100.0)
    """
    size, zero = SIZES.get(unit, (1.0, 0.0))
    return value / size + zero

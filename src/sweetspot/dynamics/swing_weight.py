"""How a bat swings: its moment of inertia from a pendulum's period, and the swing weight as each sport states it."""

from __future__ import annotations

import math
import re
from typing import Literal

from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.base import Positive, Validated
from sweetspot.errors import InputError
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.units import format_length, grouped


def moi_from_pendulum(period: float, *, mass: float, balance_point: float, pivot: float) -> float:
    """Return the moment of inertia (kg m^2) about ``pivot`` of a bat that swings from there with ``period`` (s).

    I = M g d T^2 / (4 pi^2), small swings; d from pivot to balance point [astm_f2398].

    >>> round(moi_from_pendulum(1.6, mass=0.88, balance_point=0.57, pivot=0.1524), 4)
    0.2337
    """
    _check_pendulum(period, "period")
    arm = _pendulum_arm(balance_point, pivot)
    return mass * STANDARD_GRAVITY * arm * period**2 / (4 * math.pi**2)


def pendulum_period(moi: float, *, mass: float, balance_point: float, pivot: float) -> float:
    """Return the period (s) of a bat with moment of inertia ``moi`` (kg m^2) about the ``pivot`` it hangs from.

    T = 2 pi sqrt(I / (M g d)), small swings; the inverse of `moi_from_pendulum` [astm_f2398].
    """
    _check_pendulum(moi, "moi")
    arm = _pendulum_arm(balance_point, pivot)
    return 2 * math.pi * math.sqrt(moi / (mass * STANDARD_GRAVITY * arm))


def _check_pendulum(value: float, what: str) -> None:
    if not (math.isfinite(value) and value > 0):
        raise InputError(f"{what} is {value:g}; allowed is a number above zero")


def _pendulum_arm(balance_point: float, pivot: float) -> float:
    arm = balance_point - pivot
    if arm <= 0:
        raise InputError(
            f"the bat hangs from {format_length(pivot)}, beyond its balance point at {format_length(balance_point)}; "
            "hang it from the handle"
        )
    return arm


MOST_POINTS = 70
"""Of a scale of letters: up to G9."""


class SwingWeight(Validated):
    """One sport's convention.

    Parameters
    ----------
    name : what people call it.
    order : 1 for a first moment M (x_c - axis), 2 for a moment of inertia I_cm + M (x_c - axis)^2.
    axis : m from the butt end.
    unit : as people write it.
    size : of the unit in SI, kg m or kg m^2.
    zero, step : of a scale of letters and points, both in the unit: the moment at its first letter, and of one
        point; None: the moment itself is reported.
    first_letter : of the scale, with ten points to a letter.
    source, where, kind : of the convention.
    """

    name: str
    order: Literal[1, 2]
    axis: float
    unit: str
    size: Positive
    zero: float | None = None
    step: Positive | None = None
    first_letter: str = "A"
    source: str
    where: str
    kind: str

    def moment(self, body: RigidBody) -> float:
        """Return the moment in SI: kg m of order 1, kg m^2 of order 2."""
        if self.order == 1:
            return body.mass * (body.balance_point - self.axis)
        return body.moi(self.axis)

    def value(self, body: RigidBody) -> float:
        """Return the moment in the convention's unit."""
        return self.moment(body) / self.size

    def moment_of(self, text: str) -> float:
        """Return the moment in SI of a letter with points, on a scale that has them.

        Raises `InputError` for another convention, or a text that is no letter with points.

        >>> scale = SwingWeight(name="swing weight", order=1, axis=0.3556, unit="in oz", size=0.00072007788733,
        ...     zero=161.0, step=1.75, source="recalled", where="", kind="assumed")
        >>> round(scale.moment_of("D2") / scale.size, 2)  # 161 in oz and 32 points of 1.75 in oz
        217.0
        """
        if self.zero is None or self.step is None:
            raise InputError(f"{self.name} is a number in {self.unit}, not a letter")
        last = chr(ord(self.first_letter) + MOST_POINTS // 10 - 1)
        written = re.fullmatch(rf"([{self.first_letter}-{last}])(\d(\.\d+)?)", text.strip().upper())
        if written is None:
            raise InputError(
                f"{self.name} was given as {text[:20]!r}; it is a letter from {self.first_letter} to {last} and points "
                "below 10, such as D2 or C9.5"
            )
        points = 10 * (ord(written[1]) - ord(self.first_letter)) + float(written[2])
        return (self.zero + points * self.step) * self.size

    def text_of(self, body: RigidBody) -> str:
        """Return the swing weight as people write it: a number with its unit, or a letter with points.

        >>> club = RigidBody(mass=0.31, balance_point=0.85, moi_cm=0.05, roll_moi=0.0)
        >>> scale = SwingWeight(name="swing weight", order=1, axis=0.3556, unit="in oz", size=0.00072007788733,
        ...     zero=161.0, step=1.75, source="recalled", where="", kind="assumed")
        >>> scale.text_of(club)  # (0.31 kg x 0.4944 m) / 1 in oz = 212.8, 29.6 points above A0
        'C9.6'
        """
        value = self.value(body)
        if self.zero is None or self.step is None:
            return f"{grouped(value)} {self.unit}" if value >= 1000 else f"{value:.4g} {self.unit}"
        points = round((value - self.zero) / self.step, 1)
        if not 0 <= points < MOST_POINTS:
            return f"{value:.4g} {self.unit}, off the scale"
        letter, within = divmod(points, 10)
        return f"{chr(ord(self.first_letter) + int(letter))}{within:.1f}"

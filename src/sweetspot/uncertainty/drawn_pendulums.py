"""A pendulum's answer for weights, balance points and periods that may be meant, by the formula of small swings."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.intervals import DrawnAnswers
from sweetspot.uncertainty.sources import DRAWS, Source, Sources
from sweetspot.units import OUNCE_INCH_SQUARED

WEIGHT, BALANCE, PERIOD, MOI, AXIS = "weight", "balance point", "period", "moment of inertia", "axis it hangs from"


@dataclass(frozen=True)
class Hung:
    """A bat that hangs from an axis, as it was measured; SI.

    Parameters
    ----------
    mass, balance_point, pivot : of the bat; places from the knob end.
    swung : its period, or its moment of inertia about the axis.
    timed : whether that is the period.
    """

    mass: Measured
    balance_point: Measured
    pivot: Measured
    swung: Measured
    timed: bool


def pendulum_sources(hung: Hung) -> Sources:
    """Return what is not known of a hanging bat: every value that was written with an error."""
    swung = PERIOD if hung.timed else MOI
    given = {WEIGHT: hung.mass, BALANCE: hung.balance_point, swung: hung.swung, AXIS: hung.pivot}
    others = tuple(Source(name, one.error, "as it was written") for name, one in given.items() if one.error > 0)
    return Sources(NO_DOUBT, others)


def drawn_pendulum(hung: Hung, *, count: int = DRAWS) -> DrawnAnswers:
    """Return the answers of draws to a hanging bat, by their names in its data; see `moi_from_pendulum`."""
    sources = pendulum_sources(hung)
    normal = np.vstack([np.zeros((1, len(sources.names))), sources.normal(count)])
    off = sources.deviations(normal)
    mass, balance, pivot, swung = (
        one.value + sources.of(name, off)
        for name, one in zip(
            (WEIGHT, BALANCE, AXIS, PERIOD if hung.timed else MOI),
            (hung.mass, hung.balance_point, hung.pivot, hung.swung), strict=True,
        )
    )  # fmt: skip
    torque = STANDARD_GRAVITY * mass * _above_zero(balance - pivot)
    if hung.timed:
        period, moi = swung, torque * (swung / (2 * np.pi)) ** 2
    else:
        period, moi = 2 * np.pi * np.sqrt(_above_zero(swung) / torque), swung
    values = {
        "period_s": period, "moi_kg_m2": moi, "moi_oz_in2": moi / OUNCE_INCH_SQUARED,
        "center_of_percussion_m": pivot + moi * STANDARD_GRAVITY / torque,
    }  # fmt: skip
    return DrawnAnswers(normal, sources.names, values)


def _above_zero(values: Array) -> Array:
    """Return values; nan where they are not above zero, as no bat's are that hangs."""
    return np.where(values > 0, values, np.nan)

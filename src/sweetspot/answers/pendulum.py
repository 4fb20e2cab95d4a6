"""A bat that hangs from an axis: its period, its moment of inertia, and its centre of percussion."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.flight import draws_of_sources, written_errors
from sweetspot.answers.records import INTERNAL, Length, MomentOfInertia, Ratio, Time
from sweetspot.calibration.measured import Measured
from sweetspot.dynamics.swing_weight import moi_from_pendulum, pendulum_period
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_GRAVITY
from sweetspot.plausibility import insisted
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.sources import DRAWS, Sources
from sweetspot.units import OUNCE_INCH_SQUARED

WEIGHT, BALANCE, PERIOD, MOI, AXIS = "weight", "balance point", "period", "moment of inertia", "axis it hangs from"
USUAL_GYRATIONS = (0.04, 0.4)
"""m, from table-tennis rackets to golf drivers."""
WIDEST = 0.75
"""Of the balance point: a uniform rod has a radius of gyration of 0.58 of that about it, bats 0.4."""


@dataclass(frozen=True)
class PendulumQuestion:
    """A bat that hangs from an axis, as it was measured; SI.

    Parameters
    ----------
    mass, balance_point, pivot : of the bat; places from the knob end.
    swung : its period, or its moment of inertia about the axis.
    timed : whether that is the period.
    uncertain : whether intervals are asked for, of the errors of what was measured.
    draws : how many answers they come from, a power of two.
    """

    mass: Measured
    balance_point: Measured
    pivot: Measured
    swung: Measured
    timed: bool
    uncertain: bool = False
    draws: int = DRAWS

    @property
    def sources(self) -> Sources:
        """What is not known: every value that was measured with an error."""
        swung = PERIOD if self.timed else MOI
        measured = {WEIGHT: self.mass, BALANCE: self.balance_point, swung: self.swung, AXIS: self.pivot}
        return Sources(NO_DOUBT, written_errors({name: each.error for name, each in measured.items()}))


@dataclass(frozen=True, kw_only=True)
class PendulumAnswer(Answer):
    """A hanging bat; places from the knob end.

    Parameters
    ----------
    moi, moi_oz_in2 : about the axis, and the same in oz in^2 whatever the system of units.
    uncertainty : what the intervals come from; None: there are none.
    """

    question: Annotated[PendulumQuestion, INTERNAL]
    period: Time
    moi: MomentOfInertia
    moi_oz_in2: Ratio
    pivot: Length
    center_of_percussion: Length
    uncertainty: Uncertainty | None = None


def pendulum_answer(question: PendulumQuestion) -> PendulumAnswer:
    """Return period, moment of inertia and centre of percussion of a hanging bat, for small swings.

    Raises
    ------
    InputError
        for a bat that does not swing to and fro about that axis.
    """
    mass, balance, pivot = question.mass.value, question.balance_point.value, question.pivot.value
    if question.timed:
        period = question.swung.value
        moi = moi_from_pendulum(period, mass=mass, balance_point=balance, pivot=pivot)
    else:
        moi = question.swung.value
        period = pendulum_period(moi, mass=mass, balance_point=balance, pivot=pivot)
    plain = PendulumAnswer(
        question=question,
        period=period,
        moi=moi,
        moi_oz_in2=moi / OUNCE_INCH_SQUARED,
        pivot=pivot,
        center_of_percussion=pivot + moi / (mass * (balance - pivot)),
    )
    if not question.uncertain:
        return plain
    normal, columns = drawn_pendulum(question)
    drawn = DrawnAnswer(normal, {**columns})
    return with_draws(plain, drawn, question.sources, of="moi" if question.timed else "period")


def checked_pendulum(question: PendulumQuestion) -> PendulumAnswer:
    """Return the answer about a hanging bat; refuse what no implement is like, unless it is insisted on.

    Raises
    ------
    InputError
        for a moment that its weight cannot have, or a radius of gyration that no implement has.
    """
    answer = pendulum_answer(question)
    mass, balance = question.mass.value, question.balance_point.value
    if not mass > 0:
        raise InputError(f"mass is {mass:g} kg; allowed is a weight above zero")
    if insisted():
        return answer
    moi, least = float(answer.moi), mass * (balance - question.pivot.value) ** 2
    given = f"a period of {question.swung.value:.4g} s" if question.timed else "that moment of inertia"
    if moi <= least:
        raise InputError(
            f"{given} makes {moi / OUNCE_INCH_SQUARED:.0f} oz in^2 about the axis, less than this weight has when "
            f"all of it sits at its balance point, {least / OUNCE_INCH_SQUARED:.0f} oz in^2. A period is there and "
            "back: check that, the weight and the balance point, or add --force if it is intended"
        )
    gyration = ((moi - least) / mass) ** 0.5
    low, high = USUAL_GYRATIONS
    if not low <= gyration <= high:
        raise InputError(
            f"what was given makes a radius of gyration of {100 * gyration:.1f} cm about the balance point; usual is "
            f"{100 * low:g} to {100 * high:g} cm. Check the units, or add --force if it is intended"
        )
    if gyration > WIDEST * balance:
        raise InputError(
            f"a balance point at {100 * balance:.1f} cm and the rest spread the weight by {100 * gyration:.1f} cm "
            "about it, as no implement does. Check the units, or add --force if it is intended"
        )
    return answer


def drawn_pendulum(question: PendulumQuestion) -> tuple[Array, dict[str, Array]]:
    """Return the normal numbers of draws, and what they answer by the fields of `PendulumAnswer`."""
    sources = question.sources
    normal, off = draws_of_sources(sources, question.draws)
    swung_name = PERIOD if question.timed else MOI
    measured = {
        WEIGHT: question.mass,
        BALANCE: question.balance_point,
        AXIS: question.pivot,
        swung_name: question.swung,
    }
    mass, balance, pivot, swung = (each.value + sources.of(name, off) for name, each in measured.items())
    torque = STANDARD_GRAVITY * mass * _above_zero(balance - pivot)
    if question.timed:
        period, moi = swung, torque * (swung / (2 * np.pi)) ** 2
    else:
        period, moi = 2 * np.pi * np.sqrt(_above_zero(swung) / torque), swung
    return normal, {
        "period": period,
        "moi": moi,
        "moi_oz_in2": moi / OUNCE_INCH_SQUARED,
        "center_of_percussion": pivot + moi * STANDARD_GRAVITY / torque,
    }


def _above_zero(values: Array) -> Array:
    """Return values; nan where they are not above zero, as no bat's are that hangs."""
    return np.where(values > 0, values, np.nan)

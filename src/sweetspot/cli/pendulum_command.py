"""`sweetspot pendulum`: a hanging bat's period and its moment of inertia."""

from __future__ import annotations

from typing import Annotated, Literal

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.written_errors import error_behind, error_of, without_error
from sweetspot.errors import InputError

USUAL_GYRATIONS = (0.04, 0.4)
"""m, from table-tennis rackets to golf drivers."""
WIDEST = 0.75
"""Of the balance point: a uniform rod has a radius of gyration of 0.58 of that about it, bats 0.4."""


def pendulum(
    *,
    mass: Annotated[str, Parameter(help="Weight of the bat, for example 31oz.")],
    balance_point: Annotated[str, Parameter(help="Balance point from the knob end, for example 22.4in.")],
    period: Annotated[str | None, Parameter(help="Time of one full swing to and fro, for example 1.57s.")] = None,
    moi: Annotated[str | None, Parameter(help="Moment of inertia about --pivot; gives the period instead.")] = None,
    pivot: Annotated[str, Parameter(help="Where the bat hangs, from the knob end.")] = "6in",
    uncertainty: Annotated[
        bool,
        Parameter(
            negative="",
            help="Put intervals beside the numbers, and say what they come from: of every error that was written, "
            "30.5oz±0.1oz, else of one unit of the last digit; --pivot is exact without one.",
        ),
    ] = False,
    output: OutputOptions = DEFAULT_OUTPUT,
) -> int:
    """Turn the period of a hanging bat into its moment of inertia, or back, as laboratories measure it."""
    from sweetspot.answers.pendulum import PendulumQuestion, pendulum_answer
    from sweetspot.calibration.measured import Measured
    from sweetspot.cli.output import present
    from sweetspot.plausibility import parse
    from sweetspot.report.pendulum.document import pendulum_document

    if (period is None) == (moi is None):
        raise InputError("give either --period or --moi, and only one of them")
    alone = without_error if uncertainty else str  # what no --uncertainty asks for is refused, not dropped
    weight, balance = parse(alone(mass), "mass", "--mass"), parse(alone(balance_point), "length", "--balance-point")
    axis = parse(alone(pivot), "length", "--pivot")
    if not weight > 0:
        raise InputError(f"--mass was given as {mass}; allowed is a weight above zero")
    kind: Literal["moi", "time"] = "moi" if period is None else "time"
    option, swung = ("--moi", moi) if period is None else ("--period", period)
    value = parse(alone(str(swung)), kind, option)
    question = PendulumQuestion(
        mass=Measured(weight, error_of(mass, "mass", "--mass") if uncertainty else 0.0),
        balance_point=Measured(balance, error_of(balance_point, "length", "--balance-point") if uncertainty else 0.0),
        pivot=Measured(axis, error_behind(pivot, "length", "--pivot") if uncertainty else 0.0),
        swung=Measured(value, error_of(swung, kind, option) if uncertainty else 0.0),
        timed=period is not None,
        uncertain=uncertainty,
    )
    answer = pendulum_answer(question)
    _check_body(
        float(answer.moi), weight, balance, axis, given=f"{option} was given as {swung}", balance_given=balance_point
    )
    return present(pendulum_document(answer), output)


def _check_body(inertia: float, weight: float, balance: float, axis: float, *, given: str, balance_given: str) -> None:
    """Raise `InputError` where no implement is like that: a moment of inertia in kg m^2 about an axis, kg and m."""
    from sweetspot.plausibility import insisted
    from sweetspot.units import OUNCE_INCH_SQUARED

    least = weight * (balance - axis) ** 2
    if inertia <= least and not insisted():
        raise InputError(
            f"{given}; that is a moment of {inertia / OUNCE_INCH_SQUARED:.0f} oz in^2, less than this weight has when "
            f"all of it sits at its balance point, {least / OUNCE_INCH_SQUARED:.0f} oz in^2. A period is there and "
            "back: check that, the weight and the balance point, or add --force if it is meant"
        )
    gyration = max(inertia - least, 0.0) ** 0.5 / weight**0.5
    if not USUAL_GYRATIONS[0] <= gyration <= USUAL_GYRATIONS[1] and not insisted():
        raise InputError(
            f"what was given makes a radius of gyration of {100 * gyration:.1f} cm about the balance point; usual is "
            f"{100 * USUAL_GYRATIONS[0]:g} to {100 * USUAL_GYRATIONS[1]:g} cm. Check the units, or add --force if it "
            "is meant"
        )
    if gyration > WIDEST * balance and not insisted():
        raise InputError(
            f"--balance-point was given as {balance_given}; with the rest that spreads the weight by "
            f"{100 * gyration:.1f} cm about a balance point {100 * balance:.1f} cm from the end, as no implement does. "
            "Check the units, or add --force if it is meant"
        )

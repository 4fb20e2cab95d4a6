"""`sweetspot pendulum`: a hanging bat's period and its moment of inertia."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from sweetspot.cli.options.output import DEFAULT_OUTPUT, OutputOptions
from sweetspot.cli.options.reading import option
from sweetspot.errors import InputError

if TYPE_CHECKING:
    from sweetspot.answers.setups import Written


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
    from sweetspot.answers.ask_measured import pendulum as asked
    from sweetspot.answers.setups import number_of_text
    from sweetspot.cli.output import present

    if (period is None) == (moi is None):
        raise InputError("give either --period or --moi, and only one of them")

    def number(text: str, name: str, annotation: str = "Written") -> Written:
        annotation = annotation if uncertainty else "float"  # what no --uncertainty asks for is refused, not dropped
        return number_of_text(text, name, annotation, what=option(name))

    answer = asked(
        mass=number(mass, "mass"),
        balance_point=number(balance_point, "balance_point"),
        period=None if period is None else number(period, "period"),
        moi=None if moi is None else number(moi, "moi"),
        pivot=number(pivot, "pivot", "Exact"),
        uncertainty=uncertainty,
    )
    return present(answer, output)

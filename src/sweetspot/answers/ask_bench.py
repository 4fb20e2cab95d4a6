"""Questions of the laboratory as plain functions: what differs from the sport's usual in, a typed answer out.

The command line and the public functions of the same names (`sweetspot.drop`, ...) both ask here.
"""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.analysis.drop_test import ROOM_AIR
from sweetspot.answers.drop import DropAnswer, DropQuestion, drop_answer
from sweetspot.answers.drop_draws import drop_sources
from sweetspot.answers.pendulum import PendulumAnswer, PendulumQuestion, checked_pendulum
from sweetspot.answers.setups import BlockSetup, Exact, FallSetup, Written, error_of, value_of
from sweetspot.calibration.measured import Measured
from sweetspot.errors import InputError
from sweetspot.units import INCH


def drop(*, block: BlockSetup = BlockSetup(), fall: FallSetup = FallSetup(), uncertainty: bool = False) -> DropAnswer:
    """Drop or fire a ball on a block: rebound height, restitution, contact time and where the energy goes.

    Parameters
    ----------
    uncertainty : whether every number gets its interval, with what that comes from.

    Raises
    ------
    InputError
        for a height or speed that cannot be, or a ball that does not come back in one clean contact.

    >>> import sweetspot
    >>> round(sweetspot.drop(height="1 m").restitution, 2)
    0.58
    """
    if fall.height is not None and fall.speed is not None:
        raise InputError("give either height or speed, and only one of them")
    if fall.speed is not None and fall.in_air:
        raise InputError("in_air slows a ball that falls; one that is fired arrives as fast as its speed says")
    held, ball = block.block, catalog.ball(fall.ball)
    sources = drop_sources(held, ball, speed_error=error_of(fall.speed)) if uncertainty else None
    question = DropQuestion(
        held,
        ball,
        height=None if fall.speed is not None else 1.0 if fall.height is None else fall.height,
        speed=None if fall.speed is None else value_of(fall.speed),
        air_density=ROOM_AIR if fall.in_air else 0.0,
        sources=sources,
    )
    return drop_answer(question)


def pendulum(
    *,
    mass: Written,
    balance_point: Written,
    period: Written | None = None,
    moi: Written | None = None,
    pivot: Exact = 6 * INCH,
    uncertainty: bool = False,
) -> PendulumAnswer:
    """Turn the period of a hanging bat into its moment of inertia, or back, as laboratories measure it.

    Parameters
    ----------
    mass, balance_point : kg, and m from the knob end.
    period : s, of one full swing to and fro.
    moi : kg m^2 about the pivot; gives the period in place of it.
    pivot : m from the knob end, where the bat hangs.
    uncertainty : whether numbers get intervals, of every error that was written.

    Raises
    ------
    InputError
        for a bat that does not swing about that axis, or is like no implement.

    >>> import sweetspot
    >>> hung = sweetspot.pendulum(mass="30.5 oz", balance_point="22.4 in", period="1.38 s")
    >>> round(hung.moi_oz_in2)
    9316
    """
    swung, timed = (moi, False) if period is None else (period, True)
    if swung is None or (period is not None and moi is not None):
        raise InputError("give either period or moi, and only one of them")
    weighed, balanced, hung, swings = (
        Measured(value_of(each), error_of(each) if uncertainty else 0.0) for each in (mass, balance_point, pivot, swung)
    )
    return checked_pendulum(PendulumQuestion(weighed, balanced, hung, swings, timed=timed, uncertain=uncertainty))

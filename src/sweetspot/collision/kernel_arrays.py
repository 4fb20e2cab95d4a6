"""Inputs and outputs of the compiled collision."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sweetspot.numerics.arrays import Array, IntArray

# rows of the results
EFFICIENCY, CONTACT_TIME, RELEASE_TIME, GREATEST_FORCE, GREATEST_COMPRESSION, TOUCHES, LATE = range(7)
RESULT_ROWS = 7


class RestitutionNumbers(NamedTuple):
    """A law of restitution: e at a speed in m/s, and what is lost per m/s and per e-fold of speed."""

    reference: float
    slope: float
    reference_speed: float
    log_slope: float


class BallNumbers(NamedTuple):
    """The kernel's constants of a ball: mass in kg, k, n and c of its force, and its law of restitution."""

    mass: float
    stiffness: float
    exponent: float
    damping: float
    restitution: RestitutionNumbers


class BatNumbers(NamedTuple):
    """The kernel's constants of the struck bats.

    Parameters
    ----------
    shapes, give : (n, modes) 1/sqrt(kg) and (n,) m/N at the point of impact of each hit.
    omega : (modes,) angular frequency in rad/s.
    step_give : (modes,) s^2, what steps leave out of each mode's give; see `give_of_steps`.
    drift : (modes, 2, 2), the free motion over one step.
    dashpots, half_dash : (k, modes) and (k,), dampers that couple modes and what they do in half a step.
    """

    shapes: Array
    give: Array
    omega: Array
    step_give: Array
    drift: Array
    dashpots: Array
    half_dash: Array


class Steps(NamedTuple):
    """The time steps.

    Parameters
    ----------
    step : s.
    first_kick : time of the first kick after touch, in steps; see `first_kick_after_touch`.
    limit : number of steps after which a hit is given up.
    """

    step: float
    first_kick: float
    limit: float


class HitOutput(NamedTuple):
    """Output arrays: outcome (n,), results (7, n), motion (2, n, modes) or (2, 0, modes) to leave it out.

    The motion is that at the first kick after release, by the seconds of the row `LATE` after it.
    """

    outcome: IntArray
    results: Array
    motion: Array


def output_of(count: int, size: int, *, keep_motion: bool) -> HitOutput:
    """Return room for the results of so many hits, and perhaps for so many modes' motion of each."""
    return HitOutput(
        np.empty(count, np.int64), np.empty((RESULT_ROWS, count)), np.empty((2, count if keep_motion else 0, size))
    )

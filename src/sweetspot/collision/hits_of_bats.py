"""The coupled collision for many bats at once: every bat at its own places, by the same kernel as one bat's hits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np

from sweetspot.collision.compiled import LANES, solve
from sweetspot.collision.impact import Impacts
from sweetspot.collision.kernel import STEP, contiguous, numbers_of, steps_of
from sweetspot.collision.kernel_arrays import LATE, RESULT_ROWS, BatNumbers, output_of
from sweetspot.collision.modal_propagator import free_steps, moved_freely
from sweetspot.collision.time_step import give_of_steps, with_quick_modes_as_springs
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.threads import in_parts

BATS = 8
"""Per task handed to a thread."""


class ManyBats(Protocol):
    """Many free bats, as `ReducedBats` are: frequencies and damping of their motions, and what a ball feels of them."""

    @property
    def angular_frequency(self) -> Array:
        """rad/s, shape (bats, n)."""

    @property
    def damping_rate(self) -> Array:
        """2 zeta omega in 1/s, shape (bats, n)."""

    def shapes_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return the shapes at places (bats, places) in m, shape (bats, places, n), 1/sqrt(kg)."""

    def compliance_at(self, position: Array, *, closing_speed: Array | None = None) -> Array:
        """Return how far the surface gives way at once, m/N at places (bats, places) in m."""


def struck(
    bats: ManyBats,
    *,
    ball: Ball | Sequence[Ball],
    position: Array,
    closing_speed: Array,
    step: float = STEP,
    keep_motion: bool = False,
    threads: int | None = None,
) -> Impacts:
    """Return hits with many free bats, every array shaped (bats, places); motions (bats, places, n).

    Parameters
    ----------
    ball : one for all bats, or one for each.
    position, closing_speed : m from the knob end and m/s, shape (bats, places).
    step : s; round bats do not need shorter ones than `STEP` (see `contact_step`).
    keep_motion : whether to return the bats' modal motion at release.
    threads : workers; None: one per core.
    """
    shapes = bats.shapes_at(position, closing_speed=closing_speed)
    give = bats.compliance_at(position, closing_speed=closing_speed)
    omega, drift = bats.angular_frequency, free_steps(bats.angular_frequency, bats.damping_rate, step)
    shapes, give = with_quick_modes_as_springs(shapes, give, omega[:, None, :], step)
    step_give = give_of_steps(omega, step)
    count, places, size = shapes.shape
    outcome = np.empty((count, places), np.int64)
    results = np.empty((RESULT_ROWS, count, places))
    motion = np.empty((2, count, places if keep_motion else 0, size))
    balls = {one: (numbers_of(one), steps_of(one, step)) for one in ({ball} if isinstance(ball, Ball) else {*ball})}
    constants = [balls[one] for one in ([ball] * count if isinstance(ball, Ball) else ball)]
    lanes = min(LANES, 4 * math.ceil(places / 4))
    nothing, none = np.zeros((0, size)), np.zeros(0)
    speeds = contiguous(closing_speed)
    shapes, give, omega, step_give, drift = map(contiguous, (shapes, give, omega, step_give, drift))

    def work(part: slice) -> None:
        for i in range(part.start, part.stop):
            bat = BatNumbers(shapes[i], give[i], omega[i], step_give[i], drift[i], nothing, none)
            output = output_of(places, size, keep_motion=keep_motion)
            solve(lanes, speeds[i], bat, *constants[i], output)
            outcome[i], results[:, i], motion[:, i] = output

    in_parts(work, count, size=BATS, threads=threads)
    if keep_motion:
        late, (displacement, velocity) = np.nan_to_num(results[LATE]), motion
        motion = np.array(moved_freely(omega[:, None], bats.damping_rate[:, None], displacement, velocity, -late))
    return Impacts(outcome, *results[:LATE], *motion)

"""The coupled collision, many hits at once: arrays in, arrays out, the same time step as `coupled`.

The loop itself is `compiled.solve`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.collision.compiled import LANES, solve
from sweetspot.collision.coupled import TIME_LIMIT, check_step
from sweetspot.collision.free_motion import dashpot_factors, free_steps, modal_propagator_of, moved, moved_freely
from sweetspot.collision.impact import Impacts
from sweetspot.collision.kernel_arrays import (
    LATE,
    RESULT_ROWS,
    BallNumbers,
    BatNumbers,
    RestitutionNumbers,
    Steps,
    output_of,
)
from sweetspot.collision.time_step import (
    contact_step,
    first_kick_after_touch,
    give_of_steps,
    with_quick_modes_as_springs,
)
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.threads import in_parts
from sweetspot.plausibility import check_place

STEP = 26e-6
"""s; exit speeds are within 1e-4 of the converged ones for hits at game speed (`make bench` prints the curve)."""
CHUNK = 8192
"""Hits per task handed to a thread."""


def hits(
    modes: Modes,
    *,
    ball: Ball,
    position: ArrayLike,
    closing_speed: ArrayLike,
    lateral: ArrayLike = 0.0,
    step: float | None = None,
    threads: int | None = None,
) -> Impacts:
    """Return many collisions with one bat; every row ends with its own outcome.

    The bat's own motion afterwards is left out; see `hits_with_motion`.

    Parameters
    ----------
    position, closing_speed, lateral : m from the knob end, m/s and m across the face from the bat's line, broadcast
        together to any shape; three numbers are one hit, shape (1,).
    step : s, > 0; None: `STEP`, or less where a light face needs it (`contact_step`).
    threads : workers; None: one per core, and one only for small batches.

    Returns
    -------
    Impacts
        arrays of that shape: ``collision_efficiency``, ``contact_time``, ``peak_force``, ``outcome``, ...

    >>> from sweetspot import all_modes, beam_model, catalog, hits
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> hits(modes, ball=catalog.ball(), position=[0.6, 0.7, 0.8], closing_speed=70.0).collision_efficiency.round(2)
    array([ 0.15,  0.2 , -0.06])
    """
    return _hits(modes, ball, (position, closing_speed, lateral), step, threads, keep_motion=False)


def hits_with_motion(
    modes: Modes,
    *,
    ball: Ball,
    position: ArrayLike,
    closing_speed: ArrayLike,
    lateral: ArrayLike = 0.0,
    step: float | None = None,
    threads: int | None = None,
) -> Impacts:
    """Return the same as `hits` with the bat's modal motion at release (224 bytes per hit).

    Parameters
    ----------
    position, closing_speed, lateral, step, threads : as in `hits`.

    >>> from sweetspot import all_modes, beam_model, catalog
    >>> from sweetspot.collision.kernel import hits_with_motion
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> many = hits_with_motion(modes, ball=catalog.ball(), position=[0.6, 0.7], closing_speed=70.0)
    >>> many.velocity.shape  # sqrt(kg) m/s, of every hit and mode
    (2, 14)
    """
    return _hits(modes, ball, (position, closing_speed, lateral), step, threads, keep_motion=True)


def _hits(
    modes: Modes, ball: Ball, where: Sequence[ArrayLike], step: float | None, threads: int | None, *, keep_motion: bool
) -> Impacts:
    """Return the collisions of (position, closing speed, lateral)."""
    position, closing_speed, lateral = where
    step = contact_step(modes, ball, longest=STEP) if step is None else step
    check_step(step)
    check_place(position, "position")
    given = [np.asarray(values, float) for values in (position, lateral, closing_speed)]
    shape = np.broadcast(*given).shape
    places, across, speeds = (
        (values if values.shape == shape else np.broadcast_to(values, shape)).ravel() for values in given
    )
    speeds = np.array(speeds)  # numpy warns of asking a broadcast array whether it may be written to
    count, size = len(speeds), len(modes)
    outcome = np.empty(count, np.int64)
    results = np.empty((RESULT_ROWS, count))
    motion = np.empty((2, count if keep_motion else 0, size))
    numbers, steps = numbers_of(ball), steps_of(ball, step)
    omega, *of_modes = _of_modes(modes, step)

    def work(part: slice) -> None:
        here, speed = places[part], speeds[part]
        shapes = modes.shape_at(here, across[part], closing_speed=speed)
        give = modes.compliance_at(here, across[part], closing_speed=speed)
        shapes, give = with_quick_modes_as_springs(shapes, give, omega, step)
        lanes = min(LANES, 4 * math.ceil(len(shapes) / 4))
        output = output_of(len(speed), size, keep_motion=keep_motion)
        bat = BatNumbers(contiguous(shapes), contiguous(give), omega, *of_modes)
        solve(lanes, speed, bat, numbers, steps, output)
        outcome[part], results[:, part] = output.outcome, output.results
        if keep_motion:
            (displacement, velocity), late = output.motion, output.results[LATE]
            motion[:, part] = moved(modes, displacement, velocity, -np.where(np.isnan(late), 0.0, late))

    in_parts(work, count, size=CHUNK, threads=threads)
    rows = [values.reshape(shape or (1,)) for values in (outcome, *results[:LATE])]
    return Impacts(*rows, *(motion.reshape(2, *(shape or (1,)), size) if keep_motion else motion))


def _of_modes(modes: Modes, step: float) -> tuple[Array, ...]:
    """Return the kernel's constants of the modes (`BatNumbers` from omega on), cached by step."""
    constants = modes.for_steps.get(step)
    if constants is None:
        omega = modes.angular_frequency
        of_steps = give_of_steps(omega, step), modal_propagator_of(modes, step)
        constants = tuple(map(contiguous, (omega, *of_steps, modes.dashpots, dashpot_factors(modes, step / 2))))
        modes.for_steps.clear()  # one step serves all hits but those that are asked for another
        modes.for_steps[step] = constants
    return constants


def steps_of(ball: Ball, step: float) -> Steps:
    """Return the time steps of a hit, of ``step`` s."""
    return Steps(step, first_kick_after_touch(ball.exponent), float(round(TIME_LIMIT / step)))


def numbers_of(ball: Ball) -> BallNumbers:
    """Return the kernel's constants of a ball."""
    law = ball.restitution
    line = RestitutionNumbers(law.reference, law.slope, law.reference_speed, law.log_slope)
    return BallNumbers(ball.mass, ball.stiffness, ball.exponent, ball.damping, line)


def contiguous(values: Array) -> Array:
    """Return an array whole and open to writing, as all that the kernel takes: for each other form it is compiled anew.

    >>> contiguous(np.broadcast_to(np.arange(2.0), (2, 2)).T).flags.c_contiguous
    True
    """
    return np.require(values, requirements=["C", "W"])


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
        """Return the instantaneous compliance of the surface, m/N at places (bats, places) in m."""


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
    omega, damping = bats.angular_frequency, bats.damping_rate
    drift = free_steps(omega, damping, step)
    shapes, give = with_quick_modes_as_springs(shapes, give, omega[:, None, :], step)
    step_give = give_of_steps(omega, step)
    count, places, size = shapes.shape
    outcome = np.empty((count, places), np.int64)
    results = np.empty((RESULT_ROWS, count, places))
    motion = np.empty((2, count, places if keep_motion else 0, size))
    balls = {kind: (numbers_of(kind), steps_of(kind, step)) for kind in ({ball} if isinstance(ball, Ball) else {*ball})}
    constants = [balls[kind] for kind in ([ball] * count if isinstance(ball, Ball) else ball)]
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
        if keep_motion:
            late = np.nan_to_num(results[LATE, part])
            place, speed = motion[:, part]
            motion[:, part] = moved_freely(omega[part, None], damping[part, None], place, speed, -late)

    in_parts(work, count, size=BATS, threads=threads)
    return Impacts(outcome, *results[:LATE], *motion)

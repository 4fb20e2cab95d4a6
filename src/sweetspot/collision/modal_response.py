"""Motion of the bat during and after a hit: the recorded kicks drive its modes once more."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from sweetspot.collision.coupled import check_step
from sweetspot.collision.free_motion import dashpot_factors, modal_propagator_of
from sweetspot.collision.impact import Impact, bat_energy
from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled


class ModalMotion(NamedTuple):
    """Every mode's motion at a row of times.

    Parameters
    ----------
    times : s after first touch, increasing, shape (times,).
    displacement, velocity : sqrt(kg) m and sqrt(kg) m/s, shape (times, n).
    damping : J lost in bat and hands since the motion began, shape (times,).
    """

    times: Array
    displacement: Array
    velocity: Array
    damping: Array


def replayed(impact: Impact, modes: Modes) -> ModalMotion:
    """Return the modes' motion from first touch to the end of a hit: at every kick, the last one after release.

    The kicks are the ones the collision recorded, so the last row, moved back to the release, is
    `Impact.displacement` and `Impact.velocity` again. A velocity at a kick is the mean of those before and after it.

    Parameters
    ----------
    modes : the same as in that hit, or some of them (`Modes.kept`) where no dashpots couple them.

    Returns
    -------
    Motion
        at rest in the first row; one row alone for a bat that did not reach the ball.
    """
    still = np.zeros(len(modes))
    if not len(impact.times):
        return ModalMotion(np.zeros(1), still[None], still[None], np.zeros(1))
    step = kick_step(impact)
    drift, half_dash = modal_propagator_of(modes, step), dashpot_factors(modes, step / 2)
    shape = modes.shape_at(impact.position, impact.lateral, closing_speed=impact.closing_speed)
    path, incoming, outgoing = np.zeros((3, len(impact.times) + 1, len(modes)))
    _drive(shape, impact.impulse, drift, modes.dashpots, half_dash, path, incoming, outgoing)
    lost = _energy(modes, path[:-1], outgoing[:-1]) - _energy(modes, path[1:], incoming[1:])
    return ModalMotion(
        times=np.append(impact.times, impact.times[-1] + step),
        displacement=path,
        velocity=np.vstack([(incoming + outgoing)[:-1] / 2, incoming[-1]]),
        damping=np.cumsum([0.0, *lost]),
    )


@compiled(error_model="numpy")
def _drive(
    shape: Array,
    impulses: Array,
    drift: Array,
    dashpots: Array,
    half_dash: Array,
    path: Array,
    incoming: Array,
    outgoing: Array,
) -> None:
    """Fill places, and velocities before and after each kick, in rows of one per kick and one at the end."""
    size = len(shape)
    velocity = np.empty(size)
    for row in range(1, len(impulses) + 1):
        if row > 1:
            for i in range(size):
                velocity[i] = outgoing[row - 1, i]
            for half in range(2):
                for k in range(len(half_dash)):
                    rate = 0.0
                    for i in range(size):
                        rate += dashpots[k, i] * velocity[i]
                    for i in range(size):
                        velocity[i] -= half_dash[k] * dashpots[k, i] * rate
                if half == 0:
                    for i in range(size):
                        place, speed = path[row - 1, i], velocity[i]
                        path[row, i] = drift[i, 0, 0] * place + drift[i, 0, 1] * speed
                        velocity[i] = drift[i, 1, 0] * place + drift[i, 1, 1] * speed
            for i in range(size):
                incoming[row, i] = velocity[i]
        if row < len(impulses):
            for i in range(size):
                outgoing[row, i] = incoming[row, i] + shape[i] * impulses[row]


def free_motion(modes: Modes, *, displacement: Array, velocity: Array, step: float, count: int) -> ModalMotion:
    """Return the free motion of the modes, exactly, at 1 to ``count`` steps from now.

    z' = A z with z = (q, q') and A = [[0, 1], [-omega^2, -c - d^T d]]; each row is exp(A step) times the one before.

    Parameters
    ----------
    displacement, velocity : of every mode now, shape (n,).
    step : s, > 0; any size is exact.
    count : rows wanted, >= 0.
    """
    check_step(step)
    flow = _flow(modes, step)
    state = np.concatenate([displacement, velocity])
    rows = np.empty((count, len(state)))
    for row in range(count):
        state = flow @ state
        rows[row] = state
    size = len(modes)
    lost = _energy(modes, displacement, velocity) - _energy(modes, rows[:, :size], rows[:, size:])
    return ModalMotion(step * np.arange(1.0, count + 1), rows[:, :size], rows[:, size:], lost)


def kick_step(impact: Impact) -> float:
    """Return the time step in s between the kicks of a hit that touched."""
    return float(impact.impulse[1] / impact.force[1])


def _energy(modes: Modes, displacement: Array, velocity: Array) -> Array:
    """Return the bat's energy in J at one moment or at many."""
    return sum(bat_energy(modes, displacement, velocity), np.zeros(()))


def _flow(modes: Modes, step: float) -> Array:
    """Return the matrix that takes (q, q') of all modes over ``step`` seconds, shape (2n, 2n)."""
    size = len(modes)
    if not len(modes.dashpots):
        each = modal_propagator_of(modes, step)
        return np.block([[np.diag(each[:, row, column]) for column in (0, 1)] for row in (0, 1)])
    from scipy.linalg import expm

    damping = np.diag(modes.damping_rate) + modes.dashpots.T @ modes.dashpots
    rate = np.block([[np.zeros((size, size)), np.eye(size)], [-np.diag(modes.angular_frequency**2), -damping]])
    return np.asarray(expm(step * rate))

"""The exact free motion of damped oscillators over one time step, and the exact action of dashpots."""

from __future__ import annotations

import numpy as np

from sweetspot.dynamics.modes import Modes
from sweetspot.numerics.arrays import Array


def modal_propagator_of(modes: Modes, step: float) -> Array:
    """Return the matrices that take (q, q') of each mode over ``step`` seconds, shape (n, 2, 2)."""
    return free_steps(modes.angular_frequency, modes.damping_rate, step)


def free_steps(angular_frequency: Array, damping_rate: Array, step: float | Array) -> Array:
    """Return the matrices that take (q, q') of oscillators over ``step`` seconds, shape (..., 2, 2).

    Solves q'' + 2 g q' + omega^2 q = 0 exactly, below, at and above critical damping; rigid motions drift.

    Parameters
    ----------
    angular_frequency, damping_rate : omega in rad/s and 2 g in 1/s, shape (...).
    """
    parts = _free_parts(angular_frequency, damping_rate, step)
    return np.stack([np.stack(row, axis=-1) for row in parts], axis=-2)


def _free_parts(
    angular_frequency: Array, damping_rate: Array, step: float | Array
) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Return the four numbers of those matrices, each of shape (...), row by row."""
    rate = damping_rate / 2
    square = angular_frequency**2 - rate**2
    root = np.sqrt(square if np.all(square >= 0) else square.astype(complex))  # real sines take a third of the time
    turned = root * step
    cosine = np.cos(turned).real
    small = np.abs(turned) < 1e-8
    sine = np.where(small, step, (np.sin(turned) / np.where(small, 1, root)).real)
    decay = np.exp(-rate * step)
    whole, slowed, part = decay * cosine, decay * sine, rate * decay * sine
    return (whole + part, slowed), (-(angular_frequency**2) * slowed, whole - part)


def dashpot_factors(modes: Modes, step: float) -> Array:
    """Return f_k of q' <- q' - f_k d_k (d_k . q'), what each dashpot alone does exactly in ``step`` s, shape (k,).

    exp(-d d^T h) = 1 - d (1 - exp(-|d|^2 h)) / |d|^2 d^T; the rows are orthogonal, so they act independently.
    """
    squares = np.sum(modes.dashpots**2, axis=1)
    return np.asarray(
        np.divide(-np.expm1(-squares * step), squares, out=np.full_like(squares, step), where=squares > 0)
    )


def moved(modes: Modes, displacement: Array, velocity: Array, time: Array | float) -> tuple[Array, Array]:
    """Return modal displacements and velocities of bats that nothing touches, ``time`` s later or, below zero, earlier.

    Dashpots act for half the time before the free motion and half after it, as between two kicks.

    Parameters
    ----------
    displacement, velocity : sqrt(kg) m and sqrt(kg) m/s, shape (..., n).
    time : s, shape (...).
    """
    half = np.asarray(time, float)[..., None] / 2
    displacement, velocity = moved_freely(
        modes.angular_frequency, modes.damping_rate, displacement, _dashed_for(modes, velocity, half), time
    )
    return displacement, _dashed_for(modes, velocity, half)


def moved_freely(
    angular_frequency: Array, damping_rate: Array, displacement: Array, velocity: Array, time: Array | float
) -> tuple[Array, Array]:
    """Return the same for oscillators by their numbers, of shapes that go with (..., n); no dashpots."""
    span = np.asarray(time, float)[..., None]
    place, speed = _free_parts(angular_frequency, damping_rate, span)
    return place[0] * displacement + place[1] * velocity, speed[0] * displacement + speed[1] * velocity


def _dashed_for(modes: Modes, velocity: Array, span: Array) -> Array:
    """Return the modal velocities after the dashpots alone have acted for ``span`` s, shape (..., 1)."""
    if not len(modes.dashpots):
        return velocity
    squares = np.sum(modes.dashpots**2, axis=1)
    parts = np.where(squares > 0, -np.expm1(-squares * span) / np.where(squares > 0, squares, 1.0), span)
    return np.asarray(velocity - (parts * (velocity @ modes.dashpots.T)) @ modes.dashpots)

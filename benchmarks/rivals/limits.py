"""What the machine could do at best: the modal part of a time step alone, and one plain stream of arithmetic."""

from __future__ import annotations

import time

import numpy as np
from numba import njit

from sweetspot.collision.compiled import LANES

MODES = 14
MODAL_FLOPS = 10 * MODES
"""Additions and multiplications per hit and step in the modes alone: kick 2, drift 3 + 3, surface 2 per mode."""


@njit(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def _drift(steps, drift, shape, displacement, velocity, impulse, surface):  # type: ignore[no-untyped-def]
    for _ in range(steps):
        surface[:] = 0.0
        for i in range(len(drift)):
            a, b, c, d = drift[i, 0, 0], drift[i, 0, 1], drift[i, 1, 0], drift[i, 1, 1]
            modal_shape, q, p = shape[i], displacement[i], velocity[i]
            for lane in range(len(impulse)):
                start = p[lane] + modal_shape[lane] * impulse[lane]
                moved = a * q[lane] + b * start
                p[lane] = c * q[lane] + d * start
                q[lane] = moved
                surface[lane] += modal_shape[lane] * moved


@njit(nogil=True, fastmath={"contract", "nsz"}, error_model="numpy")
def _stream(repeats, factor, source, target):  # type: ignore[no-untyped-def]
    for _ in range(repeats):
        for i in range(len(target)):
            target[i] = factor * target[i] + source[i]


def drift_time(rounds: int) -> float:
    """Return the time in s of the modal loop per hit and step, `LANES` hits side by side."""
    steps = 2000
    drift = np.tile(np.array([[0.9, 0.1], [-0.1, 0.9]]), (MODES, 1, 1))
    shape, displacement, velocity = np.ones((3, MODES, LANES))
    impulse, surface = np.full(LANES, 1e-3), np.zeros(LANES)
    _drift(1, drift, shape, displacement, velocity, impulse, surface)
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        _drift(steps, drift, shape, displacement, velocity, impulse, surface)
        times.append(time.perf_counter() - start)
    return min(times) / (steps * LANES)


def stream_rate(rounds: int) -> float:
    """Return flop/s of y = a y + x over arrays that stay in the nearest cache."""
    repeats, size = 5000, 1024
    source, target = np.ones(size), np.ones(size)
    _stream(1, 0.5, source, target)
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        _stream(repeats, 0.5, source, target)
        times.append(time.perf_counter() - start)
    return 2 * repeats * size / min(times)

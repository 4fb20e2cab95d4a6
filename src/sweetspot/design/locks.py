"""One number of a bat is pulled and some measures must stay: the others give way, as little as they can."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.design.limits import Limit, drawn_values
from sweetspot.design.measures import MEASURES, Bench
from sweetspot.numerics.arrays import Array

ROUNDS = 6
STEP = 1e-4
"""Part of a variable's range by which it is moved for a slope."""
PULLED = 1e-3
"""How readily the pulled number itself gives way, beside 1 for the others."""


def locked(bench: Bench, numbers: Array, limits: Sequence[Limit], *, pulled: int | None = None) -> Array:
    """Return numbers near those of a bat that keep some limits, as far as the ranges let them.

    Every round goes to the nearest ends of the limits' bands by the smallest change, counted in parts of the ranges,
    that the slopes ask for (Newton's method with the least norm); numbers that meet the end of their range stay there.

    Parameters
    ----------
    numbers : of the bat as it was pulled, shape (variables,).
    limits : that a drawing decides, such as bands of mass and moment of inertia.
    pulled : which number a hand holds: it gives way last; None: none is held.

    Returns
    -------
    Array
        numbers, shape (variables,); whether every limit is kept is for `Limit.excess` to say.
    """
    low, high = (np.array([getattr(one, end) for one in bench.space.variables]) for end in ("low", "high"))
    width = high - low
    parts = np.clip((np.asarray(numbers, float) - low) / width, 0.0, 1.0)
    ready = np.ones(len(parts))
    if pulled is not None:
        ready[pulled] = PULLED
    for _ in range(ROUNDS):
        every = np.concatenate([parts[None], parts + STEP * np.eye(len(parts)), parts - STEP * np.eye(len(parts))])
        values = drawn_values(bench, low + every * width)
        broken = [limit for limit in limits if float(limit.excess(values[limit.measure][:1])[0]) > 0]
        if not broken:
            break
        miss = np.array([_miss(limit, float(values[limit.measure][0])) for limit in broken])
        count = len(parts)
        slopes = np.array([
            (values[limit.measure][1 : count + 1] - values[limit.measure][count + 1 :]) / (2 * STEP)
            / MEASURES[limit.measure].grain for limit in broken
        ])  # fmt: skip
        parts = _moved(parts, slopes, miss, ready)
    return np.asarray(low + parts * width)


def _miss(limit: Limit, value: float) -> float:
    """Return how far a value is to go to be just inside its limit, in grains."""
    grain = MEASURES[limit.measure].grain
    if limit.least is not None and value < limit.least:
        return (limit.least - value) / grain + 0.01
    assert limit.most is not None
    return (limit.most - value) / grain - 0.01


def _moved(parts: Array, slopes: Array, miss: Array, ready: Array) -> Array:
    """Return parts of the ranges after a step that makes up for what is missed; those at an end are left out of it."""
    free = np.ones(len(parts), bool)
    for _ in range(len(parts)):
        weight = np.where(free, ready, 0.0)
        some = slopes * weight
        step = weight * np.linalg.lstsq(some, miss, rcond=1e-9)[0] if free.any() else np.zeros(len(parts))
        beyond = free & ((parts + step < 0) | (parts + step > 1))
        if not beyond.any():
            return np.asarray(parts + step)
        parts = np.where(beyond, np.clip(parts + step, 0.0, 1.0), parts)
        miss = miss - slopes @ np.where(beyond, np.clip(step, -parts, 1 - parts), 0.0)
        free &= ~beyond
    return parts

"""The compiled expectation step of `place_relation`."""

from __future__ import annotations

import math

from sweetspot.numerics.arrays import Array
from sweetspot.numerics.kernel_cache import compiled

WRONG, WRONG_RANGE = 0.01, 60.0
"""Part of the exit speeds taken as wrong readings, spread evenly over this many m/s, so that one cannot rule."""
MIDDLE, SCATTER, SHARE, PRODUCT, SQUARE, EVIDENCE = range(6)
"""What is kept of a ball: mean and variance of its place; and over the places, times the chance that the reading is
right: that chance, exit speed times the table's, the table's squared; and the logarithm of its likelihood."""


@compiled(nogil=True, error_model="numpy")
def expect(
    places: Array, table: Array, out: Array, spread: Array, prior: Array, level: float, result: Array
) -> None:  # fmt: skip
    """Fill what is expected of every ball under given parameters.

    Parameters
    ----------
    table : (n, places) m/s, NaN where none.
    out, spread : (n,) m/s, exit speeds and what they scatter by.
    prior : (n, 2) mean and standard deviation of the place.
    result : (n, 6).
    """
    for i in range(len(out)):
        total, before, share, product, square, mean, moment = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(len(places)):
            fast = table[i, k]
            beside = (places[k] - prior[i, 0]) / prior[i, 1]
            if not fast > 0 or abs(beside) > 5:
                continue
            here = math.exp(-0.5 * beside * beside)
            off = (out[i] - (1 + level) * fast) / spread[i]
            right = (1 - WRONG) * math.exp(-0.5 * off * off) / (spread[i] * 2.5066282746310002) if abs(off) < 8 else 0.0
            before += here
            both = here * (right + WRONG / WRONG_RANGE)
            total += both
            mean += both * places[k]
            moment += both * places[k] * places[k]
            share += here * right
            product += here * right * fast * out[i]
            square += here * right * fast * fast
        if not total > 0:
            result[i] = 0.0
            continue
        result[i, MIDDLE] = mean / total
        result[i, SCATTER] = max(moment / total - (mean / total) ** 2, 0.0)
        result[i, SHARE], result[i, PRODUCT], result[i, SQUARE] = share / total, product / total, square / total
        result[i, EVIDENCE] = math.log(total / before)

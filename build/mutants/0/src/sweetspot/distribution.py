"""How the mass of an implement lies along it, when only its weight, balance and swing weight were measured.

mu(x) = base(x) exp(a + b z + c z^2), z = 2 x / L - 1: of all distributions that have the three measured values, the one
that departs least from the drawn one (least relative entropy). It is positive everywhere, whatever was measured.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from sweetspot.errors import InputError

Array = NDArray[np.float64]

TRIALS = 60
GREATEST_RATIO = 1e4
"""Between the densest and the lightest place against the drawn one; more means that the measurements are wrong."""


def tilt(base: Callable[[Array], Array], *, places: Array, weights: Array, length: float, targets: Array) -> Array:
    """Return (a, b, c) for which integral mu (1, z, z^2) dx has the given values.

    Parameters
    ----------
    base : drawn mass per length, > 0, at positions in m.
    places, weights : quadrature over the implement, m.
    length : L in m.
    targets : the three integrals, kg.

    Raises
    ------
    InputError
        when no smooth distribution has them.
    """
    powers = np.vander(2 * places / length - 1, 3, increasing=True)
    drawn = weights * base(places)
    unknowns = np.array([np.log(targets[0] / drawn.sum()), 0.0, 0.0])
    for _ in range(TRIALS):
        density = drawn * np.exp(powers @ unknowns)
        miss = targets - powers.T @ density
        if np.abs(miss).max() < 1e-14 * targets[0]:
            return unknowns
        step = np.linalg.solve(powers.T @ (density[:, None] * powers), miss)
        unknowns = unknowns + step / max(1.0, np.abs(step).max())  # Newton, at most a factor e at once
        if np.ptp(powers @ unknowns) > np.log(GREATEST_RATIO):
            break
    else:
        if np.abs(miss).max() < 1e-10 * targets[0]:
            return unknowns
    raise InputError(
        "no plausible distribution of mass has this weight, balance point and swing weight together; check the units, "
        "and about which axis the swing weight was measured"
    )

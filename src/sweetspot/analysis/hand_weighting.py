"""How much hands feel of a vibration, by its frequency: the standard's weighting for hand-transmitted vibration."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from sweetspot.numerics.arrays import Array

LOW, HIGH, BAND_QUALITY = 6.310, 1258.9, 0.71
"""Hz, Hz and resonance quality of the band of Wh [iso5349, annex A]."""
CORNER, CORNER_QUALITY = 15.915, 0.64
"""Hz and quality of its transition from acceleration to velocity [iso5349, annex A]."""


def acceleration_weight(frequency: ArrayLike) -> Array:
    """Return |Wh| of an acceleration at frequencies in Hz [iso5349, annex A].

    Wh = s^2 w2^2 / ((s^2 + w1 s / Q1 + w1^2) (s^2 + w2 s / Q1 + w2^2)) times (s + w3) w3 / (s^2 + w3 s / Q2 + w3^2).

    >>> acceleration_weight([125.9, 501.2]).round(3).tolist()  # the standard's table at 125 and 500 Hz
    [0.127, 0.031]
    """
    s = 2j * np.pi * np.asarray(frequency, float)
    low, high, corner = 2 * np.pi * LOW, 2 * np.pi * HIGH, 2 * np.pi * CORNER
    band = s**2 * high**2 / ((s**2 + low * s / BAND_QUALITY + low**2) * (s**2 + high * s / BAND_QUALITY + high**2))
    slope = (s + corner) * corner / (s**2 + corner * s / CORNER_QUALITY + corner**2)
    return np.asarray(np.abs(band * slope))


def velocity_weight(frequency: ArrayLike) -> Array:
    """Return the same for a velocity, 1 where hands feel velocities alike, from about 30 to 600 Hz.

    |Wh| f / `CORNER`: 0.75 at 1.2 kHz and 0.1 at 4 kHz, without an edge; 0 for rigid motions.
    """
    return np.asarray(acceleration_weight(frequency) * np.asarray(frequency, float) / CORNER)

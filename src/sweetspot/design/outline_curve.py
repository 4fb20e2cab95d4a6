"""An outline as a smooth curve through a few handles that a designer pulls."""

from __future__ import annotations

import numpy as np

from sweetspot.catalog.files.turned import HANDLE_START, KNOB, TIP
from sweetspot.numerics.arrays import Array

REFERENCE_LENGTH = 34.0
"""inches of the bat that the handles' places are told for; on others they are moved in proportion."""
FROM_KNOB = (HANDLE_START, 7.0, 12.0)
FROM_TIP = (17.0, 13.5, 10.5, 8.5, 6.5, 4.5, 2.8, 1.2)
"""inches of a 34 in bat where the handles sit."""
GRIP = 3
"""Handles that lie under the hands, where a flare towards the knob is no waist."""
HANDLES = np.array([*FROM_KNOB, *(REFERENCE_LENGTH - inches for inches in FROM_TIP)]) / REFERENCE_LENGTH
"""Parts of the length, from the knob end."""
_ROUND = [(inches, part / TIP[1][1]) for inches, part in TIP[2:]]
BETWEEN = (HANDLES[1:] + HANDLES[:-1]) / 2
SAMPLES = np.sort(np.concatenate([HANDLES, BETWEEN]))
"""Where the curve is turned into stations of conical pieces: at every handle and halfway between."""
STATIONS = np.concatenate(
    [
        [inches / REFERENCE_LENGTH for inches, _ in KNOB],
        SAMPLES,
        [1 - inches / REFERENCE_LENGTH for inches, _ in _ROUND],
    ]
)
"""Parts of the length of every station: the knob's, the curve's, and those of the rounded end."""
FINE = np.linspace(HANDLES[0], HANDLES[-1], 193)


def stations(diameters: Array, *, knob: Array, length: Array) -> tuple[Array, Array]:
    """Return positions and diameters of many outlines in m, each of shape (n, 27).

    Between the handles the diameter follows piecewise cubics that never overshoot (Fritsch and Carlson's), so a curve
    swells or thins only where its handles do. Knob and rounded end have the shapes of ordinary turned bats, scaled.

    Parameters
    ----------
    diameters : at `HANDLES`, m, shape (n, 11).
    knob, length : diameter of the knob and length of the bat, m, shape (n,).
    """
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(HANDLES, diameters, axis=1)(SAMPLES)
    start = knob[:, None] * np.array([part for _, part in KNOB])
    end = diameters[:, -1:] * np.array([part for _, part in _ROUND])
    return length[:, None] * STATIONS, np.concatenate([start, curve, end], axis=1)


def steepness(diameters: Array, *, length: Array) -> tuple[Array, Array]:
    """Return the steepest slope of the radius and its sharpest bend in 1/m between the handles, each of shape (n,)."""
    from scipy.interpolate import PchipInterpolator

    curve = PchipInterpolator(HANDLES, diameters / 2, axis=1)
    slope = np.abs(curve(FINE, 1)).max(axis=1) / length
    bend = np.abs(curve(FINE, 2)).max(axis=1) / length**2
    return slope, bend


def waist(diameters: Array) -> Array:
    """Return by how much an outline is thinner somewhere than on both sides of it, m, shape (n,); 0: one swelling."""
    before = np.maximum.accumulate(diameters, axis=1)[:, :-2]
    beyond = np.maximum.accumulate(diameters[:, ::-1], axis=1)[:, ::-1][:, 2:]
    inside = diameters[:, 1:-1]
    deep = np.minimum(before, beyond) - inside
    return np.asarray(np.maximum(deep[:, GRIP - 1 :], 0.0).max(axis=1))


def diameters_of(position: Array, diameter: Array, length: float) -> Array:
    """Return the diameters at the handles of an outline given by stations, m, shape (11,)."""
    return np.interp(HANDLES * length, position, diameter)

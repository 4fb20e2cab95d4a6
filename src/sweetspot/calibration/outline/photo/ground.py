"""How much every pixel differs from the plain ground, with shadows and without.

The ground's colour is a surface of second degree in the logarithm of light, fitted to what is alike, beginning at the
picture's border. A shadow takes the same part of every colour: the logarithms of a pixel over the ground have a common
part, the shade, and the rest, the hue. A shade down to `SHADE` counts as shadow and not as difference.
"""

from __future__ import annotations

import numpy as np

from sweetspot.calibration.outline.photo.painted import difference_from_paint
from sweetspot.calibration.outline.photo.picture import DARKEST, SHADE, Picture
from sweetspot.numerics.arrays import Array

BORDER = 0.04
"""Of the picture's sides, where the ground is expected."""
SAMPLES = 20000
"""Pixels that the ground is fitted to, about."""
ALIKE = (0.6, 0.4, 0.3, 0.25, 0.25)
"""Greatest difference of what counts as ground, round after round."""


def differences(picture: Picture) -> tuple[Array, Array]:
    """Return every pixel's difference from the ground, shadows counted and not counted, shape (rows, columns) each."""
    if picture.opacity is not None:
        return picture.opacity, picture.opacity
    covered = difference_from_paint(picture) if picture.painted else None
    if covered is not None:
        return covered, covered
    tint, shade = tint_and_shade(picture)
    hue = np.linalg.norm(tint, axis=2)
    beyond = np.maximum(shade, 0.0) + np.maximum(-shade - SHADE, 0.0)
    return np.hypot(hue, shade), np.hypot(hue, beyond)


def tint_and_shade(picture: Picture) -> tuple[Array, Array]:
    """Return the logarithm of every pixel over the ground, without its common part, and that part, the shade.

    Their shapes are (rows, columns, 3) and (rows, columns).
    """
    logs = np.log(picture.linear + DARKEST)
    off = logs - _ground(logs)
    shade = off.mean(axis=2)
    return off - shade[..., None], shade


def _ground(logs: Array) -> Array:
    """Return the ground's logarithm of light everywhere, shape (rows, columns, 3)."""
    rows, columns = logs.shape[:2]
    y, x = np.linspace(-1, 1, rows), np.linspace(-1, 1, columns)
    step = max(1, int(np.sqrt(rows * columns / SAMPLES)))
    part = logs[::step, ::step]
    yy, xx = np.meshgrid(y[::step], x[::step], indexing="ij")
    surface = _terms(yy.ravel(), xx.ravel())
    given = part.reshape(-1, 3)
    edge = (np.maximum(np.abs(yy), np.abs(xx)) > 1 - 2 * BORDER).ravel()
    fitted = np.broadcast_to(np.median(given[edge], axis=0), given.shape)
    weights = np.zeros((surface.shape[1], 3))
    for alike in ALIKE:
        near = np.sqrt(np.sum((given - fitted) ** 2, axis=1)) < alike
        if near.sum() < 10 * surface.shape[1]:
            weights[0] = np.median(given[edge], axis=0)
            break
        weights = np.linalg.lstsq(surface[near], given[near], rcond=None)[0]
        fitted = surface @ weights
    ones_y, ones_x = np.ones((rows, 1)), np.ones((1, columns))
    yy, xx = y[:, None] * ones_x, x[None, :] * ones_y
    return np.asarray(_terms(yy.ravel(), xx.ravel()) @ weights).reshape(rows, columns, 3)


def _terms(y: Array, x: Array) -> Array:
    return np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)

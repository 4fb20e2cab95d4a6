"""How much every pixel differs from the plain ground, with shadows and without.

The ground's colour is a surface of second degree in the logarithm of light, fitted to what is alike, beginning at the
picture's border. A shadow takes the same part of every colour: the logarithms of a pixel over the ground have a common
part, the shade, and the rest, the hue. A shade down to `SHADE` counts as shadow and not as difference.

On a ground that a program painted in one colour, whatever is not of that colour belongs to what lies on it, and so do
parts of its colour that lie within.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.outline.photo.edges import Edges, sampled
from sweetspot.calibration.outline.photo.picture import CURVE, DARKEST, SHADE, Photograph
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

BORDER = 0.04
"""Of the picture's sides, where the ground is expected."""
SAMPLES = 20000
"""Pixels that the ground is fitted to, about."""
GROUND_ALIKE = (0.6, 0.4, 0.3, 0.25, 0.25)
"""Greatest difference of what counts as ground, round after round."""


def differences(picture: Photograph) -> tuple[Array, Array]:
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


def tint_and_shade(picture: Photograph) -> tuple[Array, Array]:
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
    for alike in GROUND_ALIKE:
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


ALIKE = 0.06
"""Distance of a file's colours up to which they are the ground's: what JPEG makes of a flat ground is less (seen in
made-up pictures, but beside a hard edge), dark tape on black has 0.1."""
INNER, GAP = 0.002, 0.003
"""Of the picture's longer side: how far from its edge the bat's colour is taken, and across which of its parts that are
like the ground it is closed."""
BESIDE = 6
"""Pixels beyond the edge, where the contrast is measured."""
RIM, MOST_UNSEEN = 1.5, 0.05
"""Pixels from the edge on, as far in as its colour is taken, of which at most such a part may be like the ground: 0.03
in made-up pictures that were read right, 0.14 in one that was not."""
OUTER, DEEPER = 2.5, 5.5
"""Pixels from the edge, between which a shadow grows."""
SOFT, FAINT, MOST_SOFT = 0.85, 0.1, 0.1
"""Difference at the outer of these over that at the deeper, and difference at the deeper, below which an edge may be a
shadow's; and the part of the edge that may."""
OF_HUE = 0.2
"""Logarithm of light by which a shadow's hue may be from the ground's (assumed)."""


def difference_from_paint(picture: Photograph) -> Array | None:
    """Return every pixel's difference from a painted ground, from 0 to 1 where a bat is whole, shape (rows, columns).

    None where a shadow may lie on the ground.
    """
    import scipy.ndimage

    off = np.asarray(np.sqrt(np.sum((picture.pixels - picture.ground) ** 2, axis=2)))
    longer = max(picture.shape)
    whole = _closed(off > ALIKE, max(2.0, GAP * longer))
    if _has_shadow(picture, off, whole):
        return None
    inner = max(2.0, INNER * longer)
    depth = scipy.ndimage.distance_transform_edt(whole)
    rim = (depth > RIM) & (depth < RIM + inner)
    if float(np.mean(off[rim] < ALIKE)) > MOST_UNSEEN:
        raise InputError(
            f"{picture.name} shows a bat whose edges are in part of its ground's colour: where it ends is not clear. "
            "Give it another ground"
        )
    core = depth > inner
    if not core.any():
        return np.asarray(np.minimum(off, 1.0))
    apart, (rows, columns) = scipy.ndimage.distance_transform_edt(~core, return_indices=True)
    smoothed = scipy.ndimage.uniform_filter(np.where(core, off, 0.0), 5)
    level = smoothed / np.maximum(scipy.ndimage.uniform_filter(core.astype(float), 5), 1e-3)
    part = np.clip(off / np.maximum(level[rows, columns], ALIKE), 0.0, 1.0)
    return np.asarray(np.where(core, 1.0, np.where(apart < inner + BESIDE, part, 0.0)))


def _has_shadow(picture: Photograph, off: Array, whole: NDArray[np.bool_]) -> bool:
    """Return whether more than a little of the edge of what differs from the ground is soft, and of its hue."""
    import scipy.ndimage

    depth, nearest = scipy.ndimage.distance_transform_edt(whole, return_indices=True)
    there = np.argwhere(np.abs(depth - DEEPER) < 0.5)
    if not len(there):
        return False
    edge = nearest[:, there[:, 0], there[:, 1]].T
    outer = np.rint(edge + (there - edge) * (OUTER / depth[tuple(there.T)])[:, None]).astype(int)
    deep = off[tuple(there.T)]
    soft = (off[tuple(outer.T)] < SOFT * deep) | (deep < FAINT)
    light = np.log(picture.linear[tuple(there.T)] + DARKEST) - np.log(picture.ground**CURVE + DARKEST)
    shade = light.mean(axis=1)
    hue = np.sqrt(np.sum((light - shade[:, None]) ** 2, axis=1))
    return bool(np.mean(soft & (hue < OF_HUE) & (shade < 0) & (shade > -SHADE)) > MOST_SOFT)


def _closed(differs: NDArray[np.bool_], gap: float) -> NDArray[np.bool_]:
    """Return the differing pixels with holes, and inlets narrower than twice a gap, filled, and without specks."""
    import scipy.ndimage

    filled = scipy.ndimage.binary_fill_holes(differs)
    assert filled is not None
    wider = scipy.ndimage.binary_fill_holes(scipy.ndimage.distance_transform_edt(~filled) < gap)
    closed = filled | (scipy.ndimage.distance_transform_edt(wider) > gap)
    return np.asarray(scipy.ndimage.binary_opening(closed))


FLANK_RIMS = (2.0, 3.0, 4.0, 5.0)
"""Pixels within the edge, where a flank's colour is taken."""
COLOURED, OF_GROUND = 0.15, 0.25
"""Hue of the bat's middle from the ground's, at least, and the part of it that a shadow's hue has at most: made-up
shadows have 0.02 to 0.1, flanks of made-up bats 0.8 or more."""
DARKER = -0.2
"""Logarithm of light: a shadow takes at least so much; a glare is brighter than the ground."""
PLAIN, EVEN, LIGHTER = 0.05, 0.3, 1.2
"""Hue of such a shadow at most; logarithms of light: how far nine tenths of it lie from one tenth along the bat, at
most, and how much lighter it is than the other flank, at least (a lamp at one side makes 1.0 of two flanks of one
coat, made-up shadows beside black have 1.8)."""
ALONG, OTHERWISE = 0.3, 0.1
"""Part of the length along which one flank is a shadow's, and of which the other may seem so too."""
FLANK_ENDS = 0.05
"""Of the length, left out at either end."""


def shadow_at_a_flank(edges: Edges, tint: Array, shade: Array) -> bool:
    """Return whether what lies just within one of two edges is the ground in a shadow.

    ``tint``: logarithm of every pixel's colour over the ground's, without its common part, shape (rows, columns, 3).
    ``shade``: that common part, shape (rows, columns).
    """
    along = (edges.end - edges.start) / edges.length
    across = np.array([-along[1], along[0]])
    count = len(edges.place)
    inner = slice(int(FLANK_ENDS * count), int((1 - FLANK_ENDS) * count))
    place = edges.start + edges.place[inner, None] * along
    half = edges.width[inner] / 2

    def seen(image: Array, side: float) -> Array:
        within = [place + (side * np.maximum(half - rim, 0.0))[:, None] * across for rim in FLANK_RIMS]
        return np.asarray(np.median([sampled(image, where) for where in within], axis=0))

    middle = np.linalg.norm(seen(tint, 0.0), axis=1)
    hues = [np.linalg.norm(seen(tint, side), axis=1) for side in (-1.0, 1.0)]
    lights = [seen(shade, side)[:, 0] for side in (-1.0, 1.0)]
    shadowed = [
        float(np.mean((middle > COLOURED) & (hue < OF_GROUND * middle) & (light < DARKER)))
        for hue, light in zip(hues, lights, strict=True)
    ]
    if max(shadowed) > ALONG and min(shadowed) < OTHERWISE:
        return True
    lighter = int(np.median(lights[1]) > np.median(lights[0]))
    light, other = lights[lighter], lights[1 - lighter]
    low, usual, high = np.quantile(light, [0.1, 0.5, 0.9])
    plain = float(np.median(hues[lighter])) < PLAIN and high - low < EVEN
    return bool(plain and usual < DARKER and usual - np.median(other) > LIGHTER)

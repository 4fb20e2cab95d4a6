"""What differs from a ground that a program painted in one colour.

Whatever is not of the ground's colour belongs to what lies on it, however light or dark; so do parts of its colour that
lie within. What counts at an edge is the colour there, so that every pixel's difference is told as a part of that of
the nearest inner one: as the opacity that the program gave it. A shadow that was left on such a ground, or painted, is
darker, of the ground's hue, and grows softly inwards, as the edge of a thing that was cut out does not.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.outline.photo.picture import CURVE, DARKEST, SHADE, Picture
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

ALIKE = 0.06
"""Distance of a file's colours up to which they are the ground's: what JPEG makes of a flat ground is less (seen in
made-up pictures, but beside a hard edge), dark tape on black has 0.1."""
INNER, GAP = 0.002, 0.003
"""Of the picture's longer side: how far from its edge the bat's colour is taken, and across which of its parts that are
like the ground it is closed."""
BESIDE = 6
"""Pixels beyond the edge, where the difference is told."""
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


def difference_from_paint(picture: Picture) -> Array | None:
    """Return every pixel's difference from a painted ground, from 0 to 1 where a bat is whole, shape (rows, columns).

    None where a shadow may lie on the ground.

    Raises
    ------
    InputError
        when much of what lies just within the edges is of the ground's colour.
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
            f"{picture.name} shows a bat whose edges are in part of its ground's colour: where it ends cannot be told. "
            "Give it another ground"
        )
    core = depth > inner
    if not core.any():
        return np.asarray(np.minimum(off, 1.0))
    apart, (rows, columns) = scipy.ndimage.distance_transform_edt(~core, return_indices=True)
    known = scipy.ndimage.uniform_filter(np.where(core, off, 0.0), 5)
    level = known / np.maximum(scipy.ndimage.uniform_filter(core.astype(float), 5), 1e-3)
    part = np.clip(off / np.maximum(level[rows, columns], ALIKE), 0.0, 1.0)
    return np.asarray(np.where(core, 1.0, np.where(apart < inner + BESIDE, part, 0.0)))


def _has_shadow(picture: Picture, off: Array, whole: NDArray[np.bool_]) -> bool:
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
    """Return what differs with its holes, and with inlets narrower than twice a gap, but without specks."""
    import scipy.ndimage

    filled = scipy.ndimage.binary_fill_holes(differs)
    assert filled is not None
    wider = scipy.ndimage.binary_fill_holes(scipy.ndimage.distance_transform_edt(~filled) < gap)
    closed = filled | (scipy.ndimage.distance_transform_edt(wider) > gap)
    return np.asarray(scipy.ndimage.binary_opening(closed))

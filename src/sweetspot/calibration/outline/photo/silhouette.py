"""Which part of a photograph is the bat, and which the ruler: by shape, whatever its colour."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

COARSE = 1100
"""Pixels of the longer side in which shapes are looked for."""
SMALLEST = 1.5e-3
"""Of the picture's area, a shape at least."""
SLENDER, FATTEST = 6.0, 40.0
"""Length over greatest width of a bat, at least and at most."""
SOLID, SYMMETRIC = 0.93, 0.08
"""Part of its silhouette that is filled, and how far its middle may wander over its width."""
BARREL_OVER_HANDLE = 1.25
"""A bat's greatest width over its least, ends left out; what is more even is a ruler."""
RULER_EVEN = 1.12
TRIES = (1.0, 0.6, 0.35, 1.5)
"""Of the threshold between ground and not ground that divides both best."""
INNER = slice(12, 88)
"""Hundredths of the length without the ends."""


@dataclass(frozen=True)
class Shape:
    """A slender thing in a photograph, in its pixels.

    Parameters
    ----------
    start, end : ends of its axis, (column, row).
    width : along the axis at even distances, shape (101,).
    wander : how far its middle leaves the straight line, over its greatest width.
    """

    start: Array
    end: Array
    width: Array
    wander: float

    @property
    def length(self) -> float:
        """From end to end."""
        return float(np.hypot(*(self.end - self.start)))

    @property
    def evenness(self) -> float:
        """Greatest over least width without the ends."""
        inner = self.width[INNER]
        return float(inner.max() / max(inner.min(), 1e-9))

    @property
    def like_a_bat(self) -> bool:
        """Whether it is straight, alike on both sides and thick at one end."""
        return self.evenness > BARREL_OVER_HANDLE and self.wander < SYMMETRIC


def find_shapes(difference: Array) -> Iterator[Shape]:
    """Yield the slender things that differ from the ground, by several thresholds."""
    import scipy.ndimage

    factor = max(1, round(max(difference.shape) / COARSE))
    rows, columns = (size // factor * factor for size in difference.shape)
    coarse = difference[:rows, :columns].reshape(rows // factor, factor, columns // factor, factor).mean(axis=(1, 3))
    best = otsu(coarse)
    for part in TRIES:
        mask = scipy.ndimage.binary_opening(coarse > part * best, iterations=1)
        labels, _ = scipy.ndimage.label(mask, structure=np.ones((3, 3)))
        for index, box in enumerate(scipy.ndimage.find_objects(labels), start=1):
            inside = scipy.ndimage.binary_fill_holes(labels[box] == index)
            touches = any(edge.start == 0 or edge.stop == size for edge, size in zip(box, mask.shape, strict=True))
            if inside is None or inside.sum() < SMALLEST * mask.size or touches:
                continue
            shape = _shape(inside, np.array([box[1].start, box[0].start]), factor)
            if shape is not None:
                yield shape


def otsu(values: Array) -> float:
    """Return the threshold that divides values best into two groups (Otsu's, in 256 steps)."""
    top = float(np.quantile(values, 0.9995))
    counts, edges = np.histogram(np.clip(values, 0, top), bins=256, range=(0, max(top, 1e-9)))
    middles = (edges[1:] + edges[:-1]) / 2
    below = np.cumsum(counts)
    above = below[-1] - below
    sums = np.cumsum(counts * middles)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
    return float(middles[int(np.nanargmax(between[:-1]))])


def _shape(inside: NDArray[np.bool_], corner: Array, factor: int) -> Shape | None:
    """Return a component as a shape along its principal axis; None where it is not slender and solid."""
    y, x = np.nonzero(inside)
    points = np.column_stack([x, y]).astype(float)
    middle = points.mean(axis=0)
    _, axes = np.linalg.eigh(np.cov((points - middle).T))
    along, across = ((points - middle) @ axes[:, 1]), ((points - middle) @ axes[:, 0])
    low, high = along.min(), along.max()
    if high - low < 40:
        return None
    place = np.clip(((along - low) / (high - low) * 100).round().astype(int), 0, 100)
    left, right = np.full(101, np.inf), np.full(101, -np.inf)
    np.minimum.at(left, place, across)
    np.maximum.at(right, place, across)
    if not np.isfinite(left).all():
        return None
    width, centre = right - left + 1, (right + left) / 2
    filled = len(points) / float(width.mean() * (high - low))
    line = np.polyval(np.polyfit(np.arange(5, 96), centre[5:96], 1), np.arange(101))
    wander = float(np.std((centre - line)[5:96]) / width.max())
    if (high - low) / width.max() < SLENDER or (high - low) / width.max() > FATTEST or filled < SOLID:
        return None
    tips = ((low - 0.5, line[0]), (high + 0.5, line[-1]))
    ends = [middle + axes[:, 1] * reach + axes[:, 0] * aside for reach, aside in tips]
    start, end = ((point + corner + 0.5) * factor - 0.5 for point in ends)
    return Shape(start, end, width * factor, wander)


def find_bat(shapes: list[Shape], name: str) -> Shape:
    """Return the shape that is a bat: straight, alike on both sides, thick at one end; of several the largest.

    Raises
    ------
    InputError
        when nothing looks like a bat.
    """
    bats = [one for one in shapes if one.like_a_bat]
    if not bats:
        raise InputError(
            f"{name} shows no bat; lay it alone on a plain ground of another colour, all of it in the picture, from "
            "above and without hard shadows"
        )
    longest = max(one.length for one in bats)
    return min((one for one in bats if one.length > 0.97 * longest), key=lambda one: one.wander)


def find_ruler(shapes: list[Shape], bat: Shape, name: str) -> Shape:
    """Return the longest even shape beside the bat: the ruler.

    Raises
    ------
    InputError
        when there is none.
    """
    middle = (bat.start + bat.end) / 2
    rulers = [
        one
        for one in shapes
        if one.evenness < RULER_EVEN and np.hypot(*((one.start + one.end) / 2 - middle)) > bat.width.max() / 2
    ]
    if not rulers:
        raise InputError(f"{name} shows no ruler; lay a straight one beside the bat, not touching it, or give --length")
    return max(rulers, key=lambda one: one.length)

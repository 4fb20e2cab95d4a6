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
"""A bat's greatest width over its least, ends left out; what is more even is no bat."""
RULER_EVEN = 1.12
"""The same of a ruler, at most (assumed)."""
TRIES = (1.0, 0.6, 0.35, 1.5)
"""Of the threshold between ground and not ground that divides both best."""
FAINTEST = 0.05
"""Least such threshold: what rounding of dark colours and a JPEG's blocks make of the difference is less (measured on
made-up photographs, a black bat on dark grey: 0.01 to 0.03; bats that were separable had above 0.07)."""
CUT = 0.3
"""Of a picture's longer side, at least, of what is reported as cut off at its border."""
NEIGHBOUR = 0.6
"""Of the bat's length, from which on what looks like a bat beside it is another one."""
Box = tuple[slice, ...]
"""The rows and columns of a piece."""
INNER = slice(12, 88)
"""Hundredths of the length without the ends."""


@dataclass(frozen=True)
class Shape:
    """A slender thing in a photograph, in its pixels.

    ``start``, ``end``: of its axis, (column, row). ``width``: along the axis at even distances, shape (101,).
    ``wander``: how far its middle leaves the straight line, over its greatest width.
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
    coarse, factor = _coarse(difference)
    for inside, box in _pieces(coarse):
        if not _borders(box, coarse):
            shape = _shape(inside, np.array([box[1].start, box[0].start]), factor)
            if shape is not None:
                yield shape


def cut_off(difference: Array) -> tuple[str, ...]:
    """Return the picture's borders at which something long and slender ends that differs from the ground."""
    coarse, factor = _coarse(difference)
    cut: tuple[str, ...] = ()
    longest = CUT * max(coarse.shape) * factor
    for inside, box in _pieces(coarse):
        borders = _borders(box, coarse)
        shape = _shape(inside, np.zeros(2), factor) if borders else None
        if shape is not None and shape.length > longest:
            cut, longest = borders, shape.length
    return cut


def _coarse(difference: Array) -> tuple[Array, int]:
    """Return the means of squares of pixels, and how many pixels wide these are."""
    factor = max(1, round(max(difference.shape) / COARSE))
    rows, columns = (size // factor * factor for size in difference.shape)
    squares = difference[:rows, :columns].reshape(rows // factor, factor, columns // factor, factor)
    return np.asarray(squares.mean(axis=(1, 3))), factor


def _pieces(coarse: Array) -> Iterator[tuple[NDArray[np.bool_], Box]]:
    """Yield what hangs together and is not small, without its holes, and where it lies, by several thresholds."""
    import scipy.ndimage

    best = otsu(coarse)
    for level in (part * best for part in TRIES):
        if not level >= FAINTEST:
            continue
        labels, _ = scipy.ndimage.label(
            scipy.ndimage.binary_opening(coarse > level, iterations=1), structure=np.ones((3, 3))
        )
        for index, box in enumerate(scipy.ndimage.find_objects(labels), start=1):
            inside = scipy.ndimage.binary_fill_holes(labels[box] == index)
            if inside is not None and inside.sum() >= SMALLEST * coarse.size:
                yield inside, box


def _borders(box: Box, coarse: Array) -> tuple[str, ...]:
    """Return at which borders of the picture a piece ends."""
    (top, bottom), (left, right) = ((edge.start, edge.stop) for edge in box)
    rows, columns = coarse.shape
    ends = {"left": left == 0, "right": right == columns, "upper": top == 0, "lower": bottom == rows}
    return tuple(name for name, there in ends.items() if there)


def otsu(values: Array) -> float:
    """Return the threshold that divides values best into two groups (Otsu's, in 256 steps); 0 where all are alike."""
    top = float(np.quantile(values, 0.9995))
    counts, edges = np.histogram(np.clip(values, 0, top), bins=256, range=(0, max(top, 1e-9)))
    middles = (edges[1:] + edges[:-1]) / 2
    below = np.cumsum(counts)
    above = below[-1] - below
    sums = np.cumsum(counts * middles)
    with np.errstate(divide="ignore", invalid="ignore"):
        between = below * above * (sums / below - (sums[-1] - sums) / above) ** 2
    parted = between[:-1]
    return float(middles[int(np.nanargmax(parted))]) if np.isfinite(parted).any() else 0.0


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
    """Return the shape that is a bat: straight, alike on both sides, thick at one end."""
    bats = [shape for shape in shapes if shape.like_a_bat]
    if not bats:
        raise InputError(
            f"{name} shows no bat; lay it alone on a plain ground of another colour, all of it in the picture, from "
            "above and without hard shadows"
        )
    longest = max(bat.length for bat in bats)
    bat = min((bat for bat in bats if bat.length > 0.97 * longest), key=lambda entry: entry.wander)
    if any(entry.length > NEIGHBOUR * longest and _beside(entry, bat) for entry in bats):
        raise InputError(f"{name} shows two bats; photograph each alone")
    return bat


def _beside(shape: Shape, bat: Shape) -> bool:
    """Return whether the middle of a shape lies outside the bat, and that of the bat outside the shape."""

    def outside(middle: Array, other: Shape) -> bool:
        along = (other.end - other.start) / other.length
        reach, aside = (middle - other.start) @ along, (middle - other.start) @ np.array([-along[1], along[0]])
        return not 0 < reach < other.length or abs(aside) > other.width.max() / 2

    return outside((shape.start + shape.end) / 2, bat) and outside((bat.start + bat.end) / 2, shape)


def find_ruler(shapes: list[Shape], bat: Shape, name: str) -> Shape:
    """Return the longest even shape beside the bat: the ruler."""
    middle = (bat.start + bat.end) / 2
    rulers = [
        shape
        for shape in shapes
        if shape.evenness < RULER_EVEN and np.hypot(*((shape.start + shape.end) / 2 - middle)) > bat.width.max() / 2
    ]
    if not rulers:
        raise InputError(f"{name} shows no ruler; lay a straight one beside the bat, not touching it, or give --length")
    return max(rulers, key=lambda entry: entry.length)

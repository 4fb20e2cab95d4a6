"""The bat's two edges in a photograph to a part of a pixel: where the colour is half way from ground to bat."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.outline.photo.silhouette import Shape
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import ROBUST_SCALE

STEP = 0.5
"""Pixels between samples across the bat."""
BEYOND = 1.5
"""Of the greatest half width, that is looked at to either side."""
NEAR_IN, NEAR_OUT = (1.5, 3.5), (2.5, 6.0)
"""Pixels from an edge between which the colours of bat and ground are taken."""
ALONG = 20.0
"""Pixels along the bat over which the ground beside it is taken together."""
REFINED = 3.0
"""Pixels by which the colours may move an edge."""
PRINTED = 1.3
"""Of the difference from the ground that three quarters of a bat's places exceed, the most that any counts for."""
LEVELS = (0.35, 0.65)
"""Of the way from ground to bat, where an edge is looked for besides half way: how far apart these lie is how sure it
is."""
APART = 0.77
"""Standard deviations of a blur between these two levels of a step: that of the normal distribution (exact)."""
SHARP = NEAR_IN[0] / 1.28
"""Pixels of blur up to which the band within the bat begins beyond nine tenths of the step; of more the bands widen."""
WIDEST = 0.8
"""Of the half width of a handle, where the inner band ends at most."""
WINDOWS = (0.01, 0.02, 0.03)
"""Of the length, over which edges are smoothed: the longest that agrees with the shorter ones."""
AGREE = 1.5
"""Usual distances between the shortest and the longest smoothing within which two agree."""
FINEST = 0.05
"""Pixels, a usual distance at least: edges are not known better."""
OUTLIER = 4.0
"""Usual distances from the running median, of the edge around it, beyond which an edge is not believed."""
ROUNDS = 3
"""Iterations of the axis through the middle of the edges, at most."""


@dataclass(frozen=True)
class Edges:
    """A bat's edges along its axis, in pixels.

    Parameters
    ----------
    place : from the first end, shape (n,), one pixel apart.
    width : between the edges, smoothed, shape (n,).
    unsettled : half of what the width changes between the `LEVELS` at which edges are taken, shape (n,).
    scatter : rms of the single edges about the smooth ones.
    bend : rms of the middle about a straight line.
    start, end : of the axis, (column, row).
    """

    place: Array
    width: Array
    unsettled: Array
    scatter: float
    bend: float
    start: Array
    end: Array

    @property
    def length(self) -> float:
        """From end to end."""
        return float(np.hypot(*(self.end - self.start)))


def find_edges(pixels: Array, difference: Array, bat: Shape, *, shadows: bool) -> Edges:
    """Return the edges of a bat whose shape is known coarsely.

    ``pixels``: colours, shape (rows, columns, 3). ``difference``: from the ground without shadows, shape (rows,
    columns). ``bat``: its coarse shape. ``shadows``: whether there may be any; a ground that a program painted has
    none.
    """
    start, end = bat.start.astype(float), bat.end.astype(float)
    left = right = unsettled = np.zeros(0)
    for _ in range(ROUNDS):  # the axis is first known from a coarse picture
        start, end = sharp_ends(pixels, difference, start, end, bat.width.max())
        left, right, unsettled = _flanks(pixels, difference, start, end, bat, shadows=shadows)
        count = len(left)
        inner = slice(count // 20, -count // 20)
        middle = (left + right) / 2
        slope, offset = np.polyfit(np.arange(count)[inner], middle[inner], 1)
        across = _directions(start, end)[1]
        start, end = start + across * offset, end + across * (offset + slope * (count - 1))
        if abs(offset) + abs(slope * count) < 0.02:
            break
    smooth_left, smooth_right = smooth(left), smooth(right)
    scatter = float(np.sqrt(np.median((left - smooth_left) ** 2 + (right - smooth_right) ** 2) / 2) * ROBUST_SCALE)
    middle = (smooth_left + smooth_right)[inner] / 2
    straight = np.polyval(np.polyfit(np.arange(len(middle)), middle, 1), np.arange(len(middle)))
    place, width = np.arange(len(left), dtype=np.float64) + 0.5, np.maximum(smooth_right - smooth_left, 0.0)
    return Edges(place, width, unsettled, scatter, float(np.std(middle - straight)), start, end)


def _directions(start: Array, end: Array) -> tuple[Array, Array]:
    along = (end - start) / np.hypot(*(end - start))
    return along, np.array([-along[1], along[0]])


def sampled(image: Array, places: Array) -> Array:
    """Return an image's values at (column, row) places, linear between pixels, shape (..., channels)."""
    import scipy.ndimage

    coordinates = [places[..., 1], places[..., 0]]
    channels = image[..., None] if image.ndim == 2 else image
    values = [
        scipy.ndimage.map_coordinates(channels[..., k], coordinates, order=1, mode="nearest")
        for k in range(channels.shape[-1])
    ]
    return np.stack(values, axis=-1)


def sharp_ends(pixels: Array, difference: Array, start: Array, end: Array, width: float) -> tuple[Array, Array]:
    """Return the ends where, in the middle of the bat, the colour is half way from bat to ground, as at its flanks."""
    along, across = _directions(start, end)
    reach = np.arange(-width, width, STEP)
    ends = []
    for point, outward in ((start, -along), (end, along)):
        side = np.linspace(-0.06, 0.06, 7) * width
        places = point + reach[:, None, None] * outward + side[None, :, None] * across
        values = sampled(difference, places)[..., 0].mean(axis=1)
        inside = np.median(values[(reach < -0.3 * width)])
        outside = np.median(values[reach > 0.4 * width])
        coarse = _crossing(reach, values, (inside + outside) / 2, int(np.argmin(np.abs(reach))))
        colours = sampled(pixels, places).mean(axis=1)
        ends.append(point + outward * _refined(reach, colours[None], np.array([coarse]), shadows=False)[0][0])
    return ends[0], ends[1]


def _crossing(reach: Array, values: Array, level: float, near: int) -> float:
    """Return the places nearest to an index at which values, high first, fall below a level."""
    falls = np.flatnonzero((values[:-1] >= level) & (values[1:] < level))
    if not len(falls):
        return float(reach[near])
    index = int(falls[np.argmin(np.abs(falls - near))])
    part = (values[index] - level) / (values[index] - values[index + 1])
    return float(reach[index] + part * (reach[index + 1] - reach[index]))


def _flanks(
    pixels: Array, difference: Array, start: Array, end: Array, bat: Shape, *, shadows: bool
) -> tuple[Array, Array, Array]:
    """Return the places of both edges across the axis, and how unsettled the width is, for every pixel of length."""
    import scipy.ndimage

    along, across = _directions(start, end)
    place = np.arange(int(np.hypot(*(end - start)))) + 0.5
    half = BEYOND * bat.width.max() / 2 + 2 * NEAR_OUT[1]
    reach = np.arange(-half, half + STEP / 2, STEP)
    points = start + place[:, None, None] * along + reach[None, :, None] * across
    signal = scipy.ndimage.gaussian_filter1d(sampled(difference, points)[..., 0], 1.0 / STEP, axis=1)
    colours = scipy.ndimage.gaussian_filter1d(sampled(pixels, points), 0.5 / STEP, axis=1)
    widths = np.interp(place, np.linspace(0, len(place), len(bat.width)), bat.width)
    half = widths / 2
    most = max(1.0, WIDEST * float(np.median(np.sort(half)[: len(half) // 2])) / NEAR_IN[1])
    sides = [(side * reach[::side], signal[:, ::side], colours[:, ::side]) for side in (-1, 1)]
    edges = [_coarse(outward, seen, half) for outward, seen, _ in sides]
    moved, blurred = [np.zeros(0), np.zeros(0)], most
    for _ in range(2):  # first with bands far from the edge; the blur that is seen so says how near they may be
        refined = [
            _refined(outward, light, edge, shadows=shadows, blurred=blurred)
            for (outward, _, light), edge in zip(sides, edges, strict=True)
        ]
        moved = [apart for _, apart in refined]
        blurred = min(max(1.0, _blur(moved)), most)
        edges = [edge for edge, _ in refined] if blurred > 1.0 else edges
    edges = [edge for edge, _ in refined]
    apart = scipy.ndimage.median_filter(moved[0] + moved[1], size=2 * int(ALONG) + 1, mode="nearest")
    return -edges[0], edges[1], apart / 2


def _blur(moved: list[Array]) -> float:
    """Return the blur of edges from the distance of `LEVELS` in them, over `SHARP`; a shadow blurs only one."""
    return min(float(np.median(side)) for side in moved) / APART / SHARP


def _coarse(reach: Array, signal: Array, expected: Array) -> Array:
    """Return the approximate edge of the bat on the side to which ``reach`` grows, one place per row.

    Print differs more from the ground than the bare wood beside it does, which is to count: so no place counts for much
    more than most of the bat.
    """
    inside = np.abs(reach) < 0.3 * expected[:, None]
    counts = np.maximum(inside.sum(axis=1), 1)
    level_in = (signal * inside).sum(axis=1) / counts
    level_in = np.minimum(level_in, PRINTED * np.quantile(level_in, 0.25))
    outside = reach > (BEYOND - 0.25) * expected.max()
    level = (level_in + np.median(signal[:, outside], axis=1)) / 2
    places = np.empty(len(signal))
    for row, (values, half) in enumerate(zip(signal, expected, strict=True)):
        places[row] = _crossing(reach, values, level[row], int(np.argmin(np.abs(reach - half))))
    return places


def _refined(reach: Array, colours: Array, edge: Array, *, shadows: bool, blurred: float = 1.0) -> tuple[Array, Array]:
    """Return edges moved to where the colour is half way from the ground's to the bat's, and what `LEVELS` lie apart.

    With shadows, what the ground would be at the edge is extended from beside it: the shadow at a bat's foot grows
    towards it, and how changes slowly along the bat.
    """
    import scipy.ndimage

    distance = (reach[None, :] - edge[:, None]) / blurred
    near_in = (-distance > NEAR_IN[0]) & (-distance < NEAR_IN[1])
    near_out = (distance > NEAR_OUT[0]) & (distance < NEAR_OUT[1])
    level_in, _ = _level_and_slope(distance, colours, near_in)
    level_out, slope = _level_and_slope(distance, colours, near_out)
    ground = np.broadcast_to(level_out[:, None, :], colours.shape)
    if shadows:
        level_out, slope = (scipy.ndimage.gaussian_filter1d(entry, ALONG, axis=0) for entry in (level_out, slope))
        outward = np.maximum(distance, 0.0) - sum(NEAR_OUT) / 2
        ground = level_out[:, None, :] + slope[:, None, :] * outward[..., None]
    apart = np.sqrt(np.sum((level_in[:, None, :] - ground) ** 2, axis=2))
    part = np.sqrt(np.sum((colours - ground) ** 2, axis=2)) / np.maximum(apart, 1e-6)
    outer, middle, inner = (_last_fall(part, level, reach, distance) for level in (LEVELS[0], 0.5, LEVELS[1]))
    placed = np.where(np.isnan(middle), edge, middle)
    apart = np.where(np.isnan(outer + inner), 2 * REFINED * blurred, np.abs(outer - inner))
    return placed, apart


def _last_fall(part: Array, level: float, reach: Array, distance: Array) -> Array:
    """Return the last place near its edge at which each row falls below a level, nan where it does not."""
    falls = (part[:, :-1] >= level) & (part[:, 1:] < level) & (np.abs(distance[:, :-1]) < REFINED)
    last = falls.shape[1] - 1 - np.argmax(falls[:, ::-1], axis=1)
    row = np.arange(len(part))
    here, there = part[row, last], part[row, last + 1]
    place = reach[last] + (here - level) / np.where(here > there, here - there, 1.0) * STEP
    return np.asarray(np.where(falls.any(axis=1), place, np.nan))


def _level_and_slope(distance: Array, colours: Array, near: NDArray[np.bool_]) -> tuple[Array, Array]:
    """Return the mean of the colours near each edge and how they change with the distance, shape (n, channels) each."""
    count = np.maximum(near.sum(axis=1), 1)[:, None]
    off = (distance - (distance * near).sum(axis=1)[:, None] / count) * near
    slope = np.einsum("ij,ijk->ik", off, colours) / np.maximum((off**2).sum(axis=1), 1e-9)[:, None]
    return np.einsum("ij,ijk->ik", near, colours) / count, slope


def smooth(edge: Array) -> Array:
    """Return an edge without outliers, smoothed by running parabolas, each as long as the shape allows.

    A cut-out picture's edge is a staircase whose steps are longer the less the edge leans; a long parabola follows the
    bat and not the steps, a short one follows a knob. At every place the longest is taken that agrees with all shorter
    ones, all around it, as usually along the edge (Lepski's choice).
    """
    import scipy.ndimage
    import scipy.signal

    windows = [max(7, 2 * (int(part * len(edge)) // 2) + 1) for part in WINDOWS]
    running = scipy.ndimage.median_filter(edge, size=windows[0], mode="nearest")
    off = np.abs(edge - running)
    around = scipy.ndimage.percentile_filter(off, 80, size=4 * windows[0], mode="nearest") / 1.28  # one sigma there
    believed = np.where(off > OUTLIER * np.maximum(around, 0.1), running, edge)
    curves = [np.asarray(scipy.signal.savgol_filter(believed, window, 2, mode="interp")) for window in windows]
    usual = float(np.quantile(np.abs(curves[0] - curves[-1]), 0.9)) / 1.645  # knob and tip are the tenth left out
    smoothed, agreed = curves[0], np.ones(len(edge), bool)
    for number, window in enumerate(windows[1:], start=1):
        apart = np.max([np.abs(curves[number] - shorter) for shorter in curves[:number]], axis=0)
        agreed &= scipy.ndimage.maximum_filter1d(apart, window // 4) < AGREE * max(usual, FINEST)
        smoothed = np.where(agreed, curves[number], smoothed)
    return smoothed

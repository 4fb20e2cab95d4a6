"""A drawing's curves as an outline: which of them are the bat, where its axis lies, how thick it is along it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from sweetspot.calibration.outline.measured_outline import USUAL_LENGTH, MeasuredOutline, fewest_stations, knob_first
from sweetspot.equipment.bat import DIAMETER_RANGE
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

JOINED = 1e-4
"""Of the drawing's size: ends of curves this near are one point."""
LONG = 0.6
"""Of the longest curve: shorter ones are no flank of the bat."""
STRAIGHT = 2e-3
"""Of its length: a curve no farther from a straight line is an axis, a border or a ruler."""
EVEN = 0.01
"""Of the thickness: a flank that is even to this is the axis of a half profile."""
SLENDER = 6.0
"""Length over thickness from which on a drawing lies along its paper; others are turned upright first."""
PLACES = 1001
"""Along the bat at least, where its thickness is taken."""
ROUND = 0.05
"""Of the length at either end, where a round tip or knob goes down to the axis: it is blunt there by what a bat file
allows at least."""
TOO_BENT = 0.03
"""Of what its widths differ by, the rms of the middle about a straight line: what is turned has none, tracing by hand a
little (assumed)."""
APART = 0.1
"""Of the height of a closed curve, by which another one lies beside it and is another bat."""
MOST_CURVES, MOST_POINTS = 2000, 200_000
"""Of a drawing, and points of all its curves: joining them takes the square of their number."""
REACH = 1e-9, 1e12
"""Units of a drawing that it is large, and that its numbers reach: between them squares of all can be computed with."""
INSIDE = 1e-9
"""Of the length, by which the first and last place lie inside a flat end."""


def outline_of_curves(
    curves: Sequence[Array], what: str, *, unit: float | None, length: float | None = None, axis: bool = False
) -> MeasuredOutline:
    """Return the outline that a drawing shows: both flanks, closed or not, or one flank over its axis.

    Straight lines, frames and what is short are left out. The thicker half is the barrel.

    ``curves``: polylines in the drawing's units, shape (n, 2) each. ``unit``: m per unit of the drawing; None: not
    known. ``length``: m of the bat; None: as drawn. ``axis``: whether y = 0 is the axis of a single flank, as lathes
    have it.
    """
    check_drawn(curves, what)
    curves = [curve for curve in curves if np.ptp(curve, axis=0).max() > 0]  # others are points
    chains = joined_curves(curves)
    flanks, lines = _flanks(chains, what)
    if unit is None and length is None:
        raise InputError(f"{what} has no units; say how long the bat is with --length")
    size = float(np.ptp(np.vstack(flanks)[:, 0]))
    scale = length / size if length is not None else unit or 1.0
    drawn = scale * size
    if not USUAL_LENGTH[0] <= drawn <= USUAL_LENGTH[1]:
        raise InputError(
            f"{what} shows something {drawn:.4g} m long; a bat is {USUAL_LENGTH[0]} m to {USUAL_LENGTH[1]} m. "
            "Say how long it is with --length"
        )
    place, low, high = _envelopes(flanks, what)
    thickness = _thickness(flanks, lines, (low, high), axis, what)
    along, diameter = knob_first(scale * (place - place[0]), scale * thickness)
    round_end = np.minimum(along, along[-1] - along) < ROUND * along[-1]
    diameter = np.where(round_end, np.maximum(diameter, DIAMETER_RANGE[0]), diameter)
    notes = []
    if length is not None and unit is not None and abs(unit * size / length - 1) > STRAIGHT:
        notes.append(f"The drawing's own units make it {1e3 * unit * size:.1f} mm long; it was scaled to --length.")
    along[[0, -1]] = 0.0, drawn
    return MeasuredOutline(fewest_stations(along, diameter), (), tuple(notes))


def check_drawn(curves: Sequence[Array], what: str) -> None:
    """Refuse curves that are too many, or whose places are no numbers that one can compute with."""
    if len(curves) > MOST_CURVES or sum(map(len, curves)) > MOST_POINTS:
        raise InputError(
            f"{what} has {len(curves)} curves of {sum(map(len, curves))} points; an outline has no more than "
            f"{MOST_CURVES} of {MOST_POINTS}. Keep only the bat's outline"
        )
    if not curves:
        return
    points = np.vstack(curves)
    if not np.abs(points).max() < REACH[1] or np.ptp(points, axis=0).max() < REACH[0]:
        raise InputError(
            f"{what} has curves beyond {REACH[1]:g} units, or of less than {REACH[0]:g}; scale it to a bat"
        )


def joined_curves(curves: Sequence[Array]) -> list[Array]:
    """Return curves whose ends meet as one, shape (n, 2) each."""
    left = [np.asarray(curve, float) for curve in curves if len(curve) > 1]
    if not left:
        return []
    near = JOINED * float(np.ptp(np.vstack(left), axis=0).max())
    chains = []
    while left:
        chain = left.pop(0)
        joining = True
        while joining and np.hypot(*(chain[0] - chain[-1])) > near:
            joining = False
            for index, other in enumerate(left):
                pieces = _joined(chain, other, near)
                if pieces is not None:
                    chain = pieces
                    del left[index]
                    joining = True
                    break
        chains.append(chain)
    return chains


def _joined(chain: Array, other: Array, near: float) -> Array | None:
    for first in (chain, chain[::-1]):
        for second in (other, other[::-1]):
            if np.hypot(*(first[-1] - second[0])) <= near:
                return np.vstack([first, second[1:]])
    return None


def _flanks(chains: list[Array], what: str) -> tuple[list[Array], list[Array]]:
    """Return the curves that are the bat, and the straight lines beside them, turned so that the bat lies along x."""
    curved = [chain for chain in chains if not _is_straight(chain)]
    bodies = [chain for chain in curved if not _is_frame(chain)] or [chain for chain in curved if _is_slender(chain)]
    if not bodies:
        raise InputError(f"{what} shows no bat; draw its side view, or one flank over its axis, as lines or curves")
    reach = [float(np.hypot(*np.ptp(chain, axis=0))) for chain in bodies]
    flanks = [chain for chain, size in zip(bodies, reach, strict=True) if size > LONG * max(reach)]
    short = [chain for chain, size in zip(bodies, reach, strict=True) if size <= LONG * max(reach)]
    axes = _axes(flanks)
    flanks = [chain @ axes for chain in flanks]
    low, high = np.vstack(flanks).min(axis=0), np.vstack(flanks).max(axis=0)
    for x, y in (np.mean(chain @ axes, axis=0) for chain in short):
        if abs(y - (low[1] + high[1]) / 2) < high[1] - low[1] and not low[0] <= x <= high[0]:
            raise InputError(f"{what}: the bat's outline has gaps; join its curves from the knob to the tip")
    _check_one(flanks, what)
    return flanks, [chain @ axes for chain in chains if _is_straight(chain)]


def _check_one(flanks: Sequence[Array], what: str) -> None:
    """Refuse closed curves that lie apart, across the bat: they are two."""
    sides = sorted((float(chain[:, 1].min()), float(chain[:, 1].max())) for chain in flanks if _is_closed(chain))
    for (low, high), (following, _) in pairwise(sides):
        if following - high > APART * (high - low):
            raise InputError(f"{what} shows two bats; draw each alone, or call one of them outline (its id or layer)")


def _is_closed(chain: Array) -> bool:
    return bool(np.hypot(*(chain[0] - chain[-1])) < STRAIGHT * float(np.ptp(chain, axis=0).max()))


def _axes(chains: Sequence[Array]) -> Array:
    """Return the directions, columns, along and across a bat: those of the paper, or its own where it lies askew."""
    width, height = np.ptp(np.vstack(chains), axis=0)
    paper = np.eye(2) if width >= height else np.array([[0.0, 1.0], [1.0, 0.0]])
    principal = _principal_axes(chains)
    askew = float(np.abs(principal[:, 0] @ paper[:, 1]))
    if max(width, height) < SLENDER * min(width, height) or (askew > STRAIGHT and _is_alike(chains, principal)):
        return principal
    return paper


def _is_alike(chains: Sequence[Array], axes: Array) -> bool:
    """Return whether curves are alike on both sides of their middle, in some directions along and across."""
    turned = [chain @ axes for chain in chains]
    try:
        _, low, high = _envelopes(turned, "")
    except InputError:
        return False
    return bool(np.ptp(low + high) < EVEN * np.ptp(np.concatenate([low, high])))


def _is_straight(chain: Array) -> bool:
    middle = chain - chain.mean(axis=0)
    _, size, _ = np.linalg.svd(middle, full_matrices=False)
    return bool(size[-1] < STRAIGHT * size[0])


def _is_frame(chain: Array) -> bool:
    """Say whether a curve is a rectangle along the paper."""
    low, high = chain.min(axis=0), chain.max(axis=0)
    near = STRAIGHT * float((high - low).max())
    return bool(np.all(np.any((np.abs(chain - low) < near) | (np.abs(chain - high) < near), axis=1)))


def _is_slender(chain: Array) -> bool:
    """Say whether a rectangle can be a rod and not the paper's border."""
    return bool(np.ptp(chain, axis=0).max() > SLENDER * np.ptp(chain, axis=0).min())


def _principal_axes(chains: Sequence[Array]) -> Array:
    """Return the directions, columns, in which curves as thin wires reach farthest and least: exact integrals."""
    starts, ends = np.vstack([chain[:-1] for chain in chains]), np.vstack([chain[1:] for chain in chains])
    size = np.hypot(*(ends - starts).T)
    centre = (size @ (starts + ends)) / (2 * size.sum())
    first, second, both = starts - centre, ends - centre, starts + ends - 2 * centre
    moments = sum((entry * size[:, None]).T @ entry for entry in (first, second, both))
    _, axes = np.linalg.eigh(moments)
    return np.asarray(axes[:, ::-1])


def _envelopes(flanks: Sequence[Array], what: str) -> tuple[Array, Array, Array]:
    """Return places along the bat with the lowest and highest crossing of its curves."""
    points = np.vstack(flanks)
    start, end = float(points[:, 0].min()), float(points[:, 0].max())
    inside = INSIDE * (end - start)
    corners = np.clip(np.unique(points[:, 0]), start + inside, end - inside)
    even = np.linspace(start + inside, end - inside, PLACES) if len(corners) < PLACES else corners[:0]
    place = np.unique(np.concatenate([corners, even]))
    place = place[np.concatenate([[True], np.diff(place) > inside])]
    low, high = np.full(len(place), np.inf), np.full(len(place), -np.inf)
    for curve in flanks:
        for (x0, y0), (x1, y1) in pairwise(curve):
            first, last = np.searchsorted(place, [min(x0, x1), max(x0, x1)], side="left")
            crossed = slice(int(first), int(np.searchsorted(place, max(x0, x1), side="right")))
            if x0 == x1 or first == len(place) or last < first:
                continue
            height = y0 + (place[crossed] - x0) * (y1 - y0) / (x1 - x0)
            low[crossed], high[crossed] = np.minimum(low[crossed], height), np.maximum(high[crossed], height)
    crossed_at_all = np.isfinite(low)
    if crossed_at_all.mean() < 1 - 3 * JOINED - 2 / len(place):
        raise InputError(f"{what}: the bat's outline has gaps; join its curves from the knob to the tip")
    return place[crossed_at_all], low[crossed_at_all], high[crossed_at_all]


def _thickness(
    flanks: Sequence[Array], lines: Sequence[Array], sides: tuple[Array, Array], axis: bool, what: str
) -> Array:
    """Return the diameters between two envelopes, one of which may be the axis, or which may be one flank."""
    low, high = sides
    size = float(np.ptp(np.concatenate([low, high])))
    inner = slice(len(low) // 50, -max(1, len(low) // 50))
    if np.ptp(low[inner]) < EVEN * size and np.ptp(high[inner]) > EVEN * size and np.all(high[inner] > low[inner]):
        return np.asarray(2 * (high - low[inner].mean()))
    if np.ptp(high[inner]) < EVEN * size and np.ptp(low[inner]) > EVEN * size and np.all(high[inner] > low[inner]):
        return np.asarray(2 * (high[inner].mean() - low))
    if np.max(high[inner] - low[inner]) > EVEN * size:
        middle = (low + high)[inner] / 2
        bent = float(np.std(middle))
        if bent > TOO_BENT * float(np.ptp(high - low)):
            raise InputError(
                f"{what} shows something that is not alike on both sides of a straight axis, as what is turned is: its "
                f"middle bends by {bent / float(np.ptp(high - low)):.0%} (rms) of what its widths differ by. Draw the "
                "side view of a round bat"
            )
        return np.asarray(high - low)
    at = _axis_of_one_flank(flanks, lines, (low, high), axis)
    if at is None:
        raise InputError(f"{what} shows one flank and not its axis; draw both flanks, or close it along the axis")
    return np.asarray(2 * np.maximum(np.abs(low - at), np.abs(high - at)))


def _axis_of_one_flank(
    flanks: Sequence[Array], lines: Sequence[Array], sides: tuple[Array, Array], zero: bool
) -> float | None:
    """Return at which y the axis of a single flank lies; None: nothing tells.

    The flank's own ends lie on it, or a line is drawn along it, or it is at 0 as in a lathe's drawing.
    """
    bottom, top = float(sides[0].min()), float(sides[1].max())
    near = EVEN * max(top - bottom, abs(top), abs(bottom))
    ends = [y for chain in flanks for y in (float(chain[0, 1]), float(chain[-1, 1]))]
    if len(flanks) == 1 and abs(ends[0] - ends[1]) < near and (ends[0] < bottom + near or ends[0] > top - near):
        return ends[0]
    start, end = (float(np.vstack(flanks)[:, 0].min()), float(np.vstack(flanks)[:, 0].max()))
    along = [
        float(line[:, 1].mean())
        for line in lines
        if np.ptp(line[:, 1]) < near
        and line[:, 0].min() < start + LONG * (end - start) / 10
        and line[:, 0].max() > end - LONG * (end - start) / 10
    ]
    beside = [y for y in along if y < bottom or y > top]
    if len(beside) == 1:
        return beside[0]
    return 0.0 if zero and (bottom >= 0 or top <= 0) else None

"""What is turned, as pieces of its meridian: mesh, STEP file and lathe program each give radii along an axis."""

from __future__ import annotations

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.outline.measured_outline import MeasuredOutline, fewest_stations, knob_first
from sweetspot.equipment.bat import DIAMETER_RANGE
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH

UNITS = {"mm": 1e-3, "in": INCH, "cm": 1e-2, "m": 1.0}
"""m; tried in this order where a file names none."""
BAT = (0.58, 1.1)
"""m that bats are long, 24 to 43 in (our choice): by its length alone a file has one unit of these at most."""
ROUND = 0.05
"""Of the length at either end, where a round tip or knob goes down to the axis."""
MOST_PLACES, MOST_CROSSINGS, EVEN_PLACES = 4000, 4_000_000, 1001
"""Places along the axis at most, pieces that cross them all together, and places where they are taken evenly."""
BESIDE = 1e-7
"""Of the length, by which places lie on both sides of every corner, as of a shoulder."""
MOST_GAPS = 0.01
"""Of the places, at which no piece crosses."""
LEVEL = 2e-4
"""Part of a radius by which the outermost tenth may differ where corners lie on what was turned and not scattered."""
Pick = Literal["outermost", "innermost", "surface"]
"""Which radius of several at one place counts; of a surface's the outermost, where corners of flat facets lie on what
was turned, or the middle of what a scan scattered."""


def unit_of(length: float, what: str) -> tuple[float, str]:
    """Return the unit in m, and its name, in which something so long is a bat.

    >>> unit_of(33.5, "bat.stl")[1], unit_of(851.0, "bat.stl")[1]
    ('in', 'mm')
    """
    for name, unit in UNITS.items():
        if BAT[0] <= length * unit <= BAT[1]:
            return unit, name
    raise InputError(
        f"{what} is {length:.4g} long, and names no unit; in {', '.join(UNITS)} that is no bat. Say how long it "
        "is with --length"
    )


def outline_of_pieces(
    pieces: Array, what: str, *, unit: float | None, length: float | None, pick: Pick = "outermost"
) -> MeasuredOutline:
    """Return the outline of what is turned.

    ``pieces``: straight pieces of meridians as (place along the axis, radius) of both ends, shape (n, 2, 2), in the
    file's unit. ``unit``: m; None: not known. ``length``: m of the bat; None: as drawn.
    """
    if not len(pieces) or not np.isfinite(pieces).all():
        raise InputError(f"{what} shows nothing that is turned about an axis")
    place, radius = radii_along(pieces, pick, what)
    size = float(place[-1] - place[0])
    notes = []
    if length is not None:
        scale = length / size
        if unit is not None and abs(unit * size / length - 1) > 2e-3:
            notes.append(f"The file's own units make it {1e3 * unit * size:.1f} mm long; it was scaled to --length.")
    elif unit is None:
        scale, name = unit_of(size, what)
        notes.append(f"The file names no unit: taken as {name}, in which it is as long as a bat, {size:.4g} {name}.")
    else:
        scale = unit
    along, diameter = knob_first(scale * (place - place[0]), 2 * scale * radius)
    along = np.maximum.accumulate(along)
    along[[0, -1]] = 0.0, scale * size
    end = np.minimum(along, along[-1] - along) < ROUND * along[-1]
    diameter = np.where(end, np.maximum(diameter, DIAMETER_RANGE[0]), diameter)
    keep = np.concatenate([[True], np.diff(along) > 0])
    return MeasuredOutline(fewest_stations(along[keep], diameter[keep]), (), tuple(notes))


def radii_along(pieces: Array, pick: Pick, what: str) -> tuple[Array, Array]:
    """Return places along the axis and the radius at each, from pieces of meridians, shape (n, 2, 2)."""
    order = np.argsort(pieces[:, :, 0], axis=1)[:, :, None]
    pieces = np.take_along_axis(pieces, order, axis=1)
    start, end = float(pieces[:, 0, 0].min()), float(pieces[:, 1, 0].max())
    if not end > start:
        raise InputError(f"{what} has no length along its axis")
    beside = BESIDE * (end - start)
    along = pieces[pieces[:, 1, 0] - pieces[:, 0, 0] > beside]
    corners = np.unique(np.round(pieces[:, :, 0].ravel() / beside)) * beside
    even = np.linspace(start + beside, end - beside, EVEN_PLACES)
    corners = corners[:: -(-2 * len(corners) // MOST_PLACES)]  # of too many some, as dense as they lie
    places = np.concatenate([corners - beside, corners + beside, even])
    places = np.unique(np.clip(places, start + beside, end - beside))
    first, last = np.searchsorted(places, along[:, 0, 0]), np.searchsorted(places, along[:, 1, 0], side="right")
    count = last - first
    if count.sum() > MOST_CROSSINGS:
        thinner = int(len(places) * MOST_CROSSINGS / count.sum())
        if thinner < EVEN_PLACES / 2:
            raise InputError(f"{what} has {len(along)} pieces, more than can be measured; keep only the bat's surface")
        places = np.linspace(start + beside, end - beside, thinner)
        first, last = np.searchsorted(places, along[:, 0, 0]), np.searchsorted(places, along[:, 1, 0], side="right")
        count = last - first
    which = np.repeat(np.arange(len(along)), count)
    at = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + np.repeat(first, count)
    (x0, y0), (x1, y1) = along[which, 0].T, along[which, 1].T
    radius = y0 + (places[at] - x0) * (y1 - y0) / (x1 - x0)
    sorting = np.lexsort([radius, at])
    crossings = np.bincount(at, minlength=len(places))
    begins = np.cumsum(crossings) - crossings
    taken = crossings > 0
    if taken.mean() < 1 - MOST_GAPS:
        raise InputError(f"{what} has gaps along its axis; close its surface from the knob to the tip")
    ranked = radius[sorting]

    def at_rank(rank: NDArray[np.intp]) -> Array:
        return np.asarray(ranked[(begins + rank)[taken]])

    outer = at_rank(crossings - 1)
    if pick == "outermost":
        return places[taken], outer
    if pick == "innermost":
        return places[taken], at_rank(0 * crossings)
    level = outer - at_rank((9 * (crossings - 1)) // 10) < LEVEL * outer
    return places[taken], np.where(level, outer, at_rank((crossings - 1) // 2))

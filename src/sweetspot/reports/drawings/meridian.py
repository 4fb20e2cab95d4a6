"""Curves in the plane of a section through the axis: polynomial pieces, exact in every file that can hold them.

A chain of curves that begins and ends on the axis, or that is closed, makes a solid as it turns about the axis. It is
traversed with the material on its right: away from the knob along the outside.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array

CORNER = math.radians(20)
"""Angle at a station between two straight pieces above which it stays a corner [our choice]: knobs and tips have them;
tapers and barrels as makers draw them bend by less than 3 degrees."""
SAMPLES = 101
"""Stations of an outline that is given as mass per length."""
ON_AXIS = 1e-9
"""m of radius that is none."""
GAUSS = np.polynomial.legendre.leggauss(6)
"""Exact for polynomials up to degree 11; that of a volume has degree 8."""


@dataclass(frozen=True)
class MeridianCurve:
    """A smooth curve: one Bézier piece, or several that follow each other in position with equal slopes.

    Parameters
    ----------
    pieces : control points (position, radius) in m of each piece, shape (degree + 1, 2).
    """

    pieces: tuple[Array, ...]

    @property
    def start(self) -> Array:
        """First point, m, shape (2,)."""
        return np.asarray(self.pieces[0][0])

    @property
    def end(self) -> Array:
        """Last point, m, shape (2,)."""
        return np.asarray(self.pieces[-1][-1])

    @property
    def degree(self) -> int:
        """Of the polynomials: 1 for a straight line."""
        return len(self.pieces[0]) - 1

    @property
    def straight(self) -> bool:
        """Whether it is one straight line."""
        return self.degree == 1

    def reversed(self) -> MeridianCurve:
        """Return it traversed from its end."""
        return MeridianCurve(tuple(piece[::-1] for piece in reversed(self.pieces)))

    def spline(self) -> tuple[Array, Array, list[int]]:
        """Return control points (n, 2), distinct knots and their multiplicities of the one B-spline that it is.

        Inner knots of multiplicity 2 hold a cubic with equal slopes on either side; knots are lengths along the axis.
        """
        if len(self.pieces) == 1:
            return self.pieces[0], np.array([0.0, 1.0]), [self.degree + 1] * 2
        inner = [piece[1:3] for piece in self.pieces]
        points = np.vstack([self.start[None], *inner, self.end[None]])
        knots = np.abs(np.array([self.start[0], *(piece[-1, 0] for piece in self.pieces)]) - self.start[0])
        return points, knots, [4, *[2] * (len(self.pieces) - 1), 4]

    def points(self, tolerance: float) -> Array:
        """Return points on it, ends included, between which straight lines are within ``tolerance`` m, shape (n, 2)."""
        found = [self.start[None]]
        for piece in self.pieces:
            degree = len(piece) - 1
            bend = 0.0 if degree < 2 else float(np.linalg.norm(np.diff(piece, 2, axis=0), axis=1).max())
            count = max(1, math.ceil(math.sqrt(degree * (degree - 1) * bend / (8 * tolerance))))
            found.append(bezier(piece, np.arange(1, count + 1) / count))
        return np.vstack(found)


def bezier(control: Array, part: Array) -> Array:
    """Return points of a Bézier curve at parameters 0 to 1 of shape (n,), shape (n, 2); de Casteljau's scheme."""
    points = np.broadcast_to(control[:, None], (len(control), len(part), 2))
    while len(points) > 1:
        points = (1 - part)[:, None] * points[:-1] + part[:, None] * points[1:]
    return np.asarray(points[0])


def line(start: tuple[float, float] | Array, end: tuple[float, float] | Array) -> MeridianCurve:
    """Return a straight line between two points (position, radius) in m."""
    return MeridianCurve((np.array([start, end], float),))


def cut(piece: Array, low: float, high: float) -> Array:
    """Return the part of a Bézier piece between two parameters."""
    after = _halves(piece, low)[1] if low > 0 else piece
    return _halves(after, (high - low) / (1 - low))[0] if high < 1 else after


def _halves(piece: Array, part: float) -> tuple[Array, Array]:
    rows = [piece]
    while len(rows[-1]) > 1:
        rows.append((1 - part) * rows[-1][:-1] + part * rows[-1][1:])
    return np.array([row[0] for row in rows]), np.array([row[-1] for row in rows])[::-1]


def volume(chain: Iterable[MeridianCurve]) -> float:
    """Return the volume that a chain encloses as it turns, m^3: pi times the integral of r^2 dx (exact).

    >>> round(volume([line((0, 0), (0, 1)), line((0, 1), (3, 0))]) / math.pi, 12)  # a cone
    1.0
    """
    nodes, weights = (GAUSS[0] + 1) / 2, GAUSS[1] / 2
    whole = 0.0
    for piece in (piece for curve in chain for piece in curve.pieces):
        slope = bezier((len(piece) - 1) * np.diff(piece, axis=0), nodes)[:, 0]
        whole += float(np.sum(weights * bezier(piece, nodes)[:, 1] ** 2 * slope))
    return math.pi * whole


def flattened(chain: Iterable[MeridianCurve], tolerance: float) -> Array:
    """Return a chain as points, each once, between which straight lines are within ``tolerance`` m, shape (n, 2)."""
    points = [curve.points(tolerance) for curve in chain]
    joined = np.vstack([points[0], *(each[1:] for each in points[1:])])
    apart = np.concatenate([[True], np.any(np.abs(np.diff(joined, axis=0)) > ON_AXIS, axis=1)])
    return np.asarray(joined[apart])


def smooth_outline(bat: Bat) -> list[MeridianCurve]:
    """Return the outside of a bat from knob end to tip: a smooth curve through its stations, corners kept.

    Between stations the radius is a cubic that never overshoots (Fritsch and Carlson's), so no diameter exceeds those
    that were given; at a corner (`CORNER`) its direction changes at once. The analysis takes the chain of cones.

    >>> from sweetspot import catalog
    >>> [curve.degree for curve in smooth_outline(catalog.bat("uniform-rod"))]
    [1]
    """
    from scipy.interpolate import PchipInterpolator

    places, radii = _stations(bat)
    angles = np.arctan(np.diff(radii) / np.diff(places))
    corners = [0, *(np.flatnonzero(np.abs(np.diff(angles)) > CORNER) + 1).tolist(), len(places) - 1]
    curves = []
    for first, last in pairwise(corners):
        if last == first + 1:
            curves.append(line((places[first], radii[first]), (places[last], radii[last])))
            continue
        x, r = places[first : last + 1], radii[first : last + 1]
        slope = PchipInterpolator(x, r).derivative()(x)
        third = np.diff(x) / 3
        inner = zip(x, r, slope, x[1:], r[1:], slope[1:], third, strict=False)
        curves.append(
            MeridianCurve(
                tuple(
                    np.array([[x0, r0], [x0 + h, r0 + h * s0], [x1 - h, r1 - h * s1], [x1, r1]])
                    for x0, r0, s0, x1, r1, s1, h in inner
                )
            )
        )
    return curves


def _stations(bat: Bat) -> tuple[Array, Array]:
    """Return positions and radii of the stations, m."""
    if bat.profile is not None:
        places, diameters = np.array(bat.profile).T
        return places, diameters / 2
    places = np.linspace(0.0, bat.length, SAMPLES)
    return places, bat.diameter_at(places) / 2


def split(curves: Iterable[MeridianCurve], at: Iterable[float]) -> list[MeridianCurve]:
    """Return curves along the axis, cut wherever they cross one of some positions in m."""
    places = sorted(set(at))
    parts = []
    for curve in curves:
        run: list[Array] = []
        for piece in curve.pieces:
            start, whole = piece[0, 0], piece[-1, 0] - piece[0, 0]
            inside = [(place - start) / whole for place in places if ON_AXIS < place - start < whole - ON_AXIS]
            for low, high in pairwise([0.0, *inside, 1.0]):
                run.append(cut(piece, low, high))
                if any(abs(run[-1][-1, 0] - place) <= ON_AXIS for place in places):
                    parts.append(MeridianCurve(tuple(run)))
                    run = []
        if run:
            parts.append(MeridianCurve(tuple(run)))
    return parts


def between_places(curves: Iterable[MeridianCurve], start: float, end: float) -> list[MeridianCurve]:
    """Return the part of curves along the axis between two positions in m."""
    return [
        curve
        for curve in split(curves, (start, end))
        if start - ON_AXIS <= curve.start[0] and curve.end[0] <= end + ON_AXIS
    ]


def lowered(curve: MeridianCurve, start: float, end: float) -> MeridianCurve:
    """Return a curve along the axis with a smaller radius.

    ``start``, ``end``: by how much at its ends, m; in between in proportion to the position.
    """
    low, high = curve.start[0], curve.end[0]

    def moved(piece: Array) -> Array:
        less = start + (end - start) * (piece[:, 0] - low) / (high - low)
        return np.column_stack([piece[:, 0], piece[:, 1] - less])

    return MeridianCurve(tuple(map(moved, curve.pieces)))


def radius_at(curves: Iterable[MeridianCurve], position: Array) -> Array:
    """Return the radius in m of curves along the axis at positions in m, shape of ``position``."""
    pieces = [piece for curve in curves for piece in curve.pieces]
    starts = np.array([piece[0, 0] for piece in pieces])
    place = np.asarray(position, float)
    index = np.clip(np.searchsorted(starts, place, side="right") - 1, 0, len(pieces) - 1)
    radius = np.empty(place.shape)
    for number in np.unique(index):
        piece, here = pieces[number], index == number
        part = np.clip((place[here] - piece[0, 0]) / (piece[-1, 0] - piece[0, 0]), 0, 1)
        radius[here] = bezier(piece, part)[:, 1]
    return radius

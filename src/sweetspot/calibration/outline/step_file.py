"""The outline of a turned solid in a STEP file (ISO 10303-21; AP203, AP214, AP242), from its edges and surfaces.

The meridian of what is turned stands in the file as it was drawn: as edges along the axis (the seams of its faces), or,
between two circles without a seam, in the surface itself. So lines, circles, ellipses and B-splines are all that is
read, and no kernel of 100 MB that would build the solid first.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

import numpy as np

from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.meridian import outline_of_pieces
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import read_text

Value: TypeAlias = "str | float | list[Value] | None"
"""Of an entity: a word, ``#12`` or ``.T.``; a number; nothing; a list."""
LARGEST, MOST_ENTITIES, DEEPEST, MOST_DEGREE, MOST_POLES = 50_000_000, 1_000_000, 50, 25, 20_000
"""Bytes, entities, lists in lists, degree and poles of a B-spline at most."""
PREFIXES = {"MILLI": 1e-3, "CENTI": 1e-2, "DECI": 0.1, "MICRO": 1e-6, "KILO": 1e3}
ENTITY = re.compile(r"#(\d+)\s*=\s*((?:'(?:[^']|'')*'|[^';])*);")
TOKEN = re.compile(
    r"'(?:[^']|'')*'|#\d+|\.[A-Za-z_0-9]+\.|[-+]?\d+\.?\d*(?:[Ee][-+]?\d+)?|[A-Za-z_][A-Za-z_0-9]*|[(),$*]"
)
PIECES, LEAST_PIECES = 256, 32
"""Straight pieces of a curve, and of each span of a B-spline at least."""
NEAR = 1e-6
"""Of the size of the solid: what is this near is on the axis or along it."""
TURNED = ("CYLINDRICAL_SURFACE", "CONICAL_SURFACE", "TOROIDAL_SURFACE", "SURFACE_OF_REVOLUTION")


@dataclass(frozen=True)
class StepFile:
    """The entities of a file: by number, the values of each of its parts by name."""

    name: str
    entities: dict[int, dict[str, list[Value]]]

    def parts(self, reference: Value) -> dict[str, list[Value]]:
        """Return the parts of an entity that is referred to."""
        if not isinstance(reference, str) or not reference.startswith("#") or int(reference[1:]) not in self.entities:
            raise InputError(f"{self.name} refers to {reference!r}, which it does not have; export it anew")
        return self.entities[int(reference[1:])]

    def of(self, reference: Value, kind: str) -> list[Value]:
        """Return the values of an entity that must be of one kind."""
        parts = self.parts(reference)
        if kind not in parts:
            raise InputError(f"{self.name} has {'/'.join(parts)} where {kind} is expected; export it anew")
        return parts[kind]

    def all_of(self, kind: str) -> Iterator[tuple[str, list[Value]]]:
        """Yield the reference and values of all entities of a kind."""
        for number, parts in self.entities.items():
            if kind in parts:
                yield f"#{number}", parts[kind]

    def point(self, reference: Value, kind: str = "CARTESIAN_POINT") -> Array:
        """Return a point or direction, shape (3,)."""
        numbers = self.of(reference, kind)[1]
        if not isinstance(numbers, list) or len(numbers) != 3 or not all(isinstance(each, float) for each in numbers):
            raise InputError(f"{self.name} has a {kind} that is no place in space")
        return np.array(numbers, float)

    @cached_property
    def unit(self) -> float | None:
        """Unit of length in m; None: none is named."""
        for _, (units, *_) in self.all_of("GLOBAL_UNIT_ASSIGNED_CONTEXT"):
            for reference in units if isinstance(units, list) else []:
                if "LENGTH_UNIT" in self.parts(reference):
                    return self._metres(reference, 0)
        return None

    def _metres(self, reference: Value, depth: int) -> float:
        parts = self.parts(reference)
        if "SI_UNIT" in parts:
            prefix = parts["SI_UNIT"][0]
            return PREFIXES.get(prefix.strip("."), 1.0) if isinstance(prefix, str) else 1.0
        measure = self.parts(parts.get("CONVERSION_BASED_UNIT", [None, None])[1])
        values = measure.get("MEASURE_WITH_UNIT") or next(iter(measure.values()))
        size = next((each[0] for each in values if isinstance(each, list) and each), values[0])  # LENGTH_MEASURE(25.4)
        unit = values[-1]
        if not isinstance(size, float) or not 0 < size < 1e6 or depth > 2:
            raise InputError(f"{self.name} has a unit of length that is not understood; export it in mm")
        return size * self._metres(unit, depth + 1)


def step_outline(path: Path, *, length: float | None = None) -> MeasuredOutline:
    """Return the outside of the turned solid that a STEP file holds.

    Raises
    ------
    InputError
        where it holds no surface that is turned about one axis, or is damaged.
    """
    text = read_text(path, most=LARGEST, advice="keep only the bat's solid")
    if "ISO-10303-21" not in text[:2000]:
        raise InputError(f"{path} is not a STEP file: it does not begin with ISO-10303-21")
    try:
        file = StepFile(str(path), _entities(text, str(path)))
        pieces = _meridians(file)
    except InputError:
        raise
    except (TypeError, ValueError, IndexError, KeyError, AttributeError, RecursionError, FloatingPointError):
        raise InputError(f"{path} is a damaged STEP file; export it anew (AP214)") from None
    return outline_of_pieces(pieces, str(path), unit=file.unit, length=length)


def _entities(text: str, what: str) -> dict[int, dict[str, list[Value]]]:
    entities: dict[int, dict[str, list[Value]]] = {}
    for match in ENTITY.finditer(re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)):
        if len(entities) >= MOST_ENTITIES:
            raise InputError(f"{what} has more than {MOST_ENTITIES} entities; keep only the bat's solid")
        entities[int(match[1])] = _parts(match[2], what)
    return entities


def _parts(text: str, what: str) -> dict[str, list[Value]]:
    """Return the values of an entity by the names of its parts: one, or several in brackets."""
    stack: list[list[Value]] = [[]]
    for token in TOKEN.findall(text):
        if token == "(":
            stack.append([])
            if len(stack) > DEEPEST:
                raise InputError(f"{what} has lists in lists in lists; export it anew")
        elif token == ")":
            inner = stack.pop()
            stack[-1].append(inner)
        elif token in "$*":
            stack[-1].append(None)
        elif token[0].isdigit() or token[0] in "+-":
            stack[-1].append(float(token))
        elif token != ",":
            stack[-1].append(token)
    whole = stack[0][0] if len(stack[0]) == 1 and isinstance(stack[0][0], list) else stack[0]
    return {
        str(name): values
        for name, values in itertools.pairwise(whole)
        if isinstance(name, str) and isinstance(values, list)
    }


@dataclass(frozen=True)
class _Axis:
    """The line about which something is turned: a point of it and its direction, both of shape (3,)."""

    point: Array
    direction: Array

    def seen(self, points: Array) -> Array:
        """Return points of shape (n, 3) as places along the axis and radii, shape (n, 2)."""
        along = (points - self.point) @ self.direction
        return np.stack([along, np.linalg.norm(points - self.point - np.outer(along, self.direction), axis=1)], axis=1)

    def is_along(self, point: Array, direction: Array, size: float) -> bool:
        parallel = np.linalg.norm(np.cross(direction, self.direction)) < NEAR * 10
        return bool(parallel and self.seen(point[None])[0, 1] < NEAR * 10 * size)


def _placed(file: StepFile, reference: Value) -> tuple[Array, Array, Array]:
    """Return the place of something, its axis, and the direction from which its angles count."""
    parts = file.parts(reference)
    kind, values = next(iter(parts.items()))
    if kind not in ("AXIS2_PLACEMENT_3D", "AXIS1_PLACEMENT"):
        raise InputError(f"{file.name} has a {kind} where a place in space is expected; export it anew")
    axis = np.array([0.0, 0, 1]) if values[2] is None else file.point(values[2], "DIRECTION")
    axis = axis / np.linalg.norm(axis)
    start = (
        file.point(values[3], "DIRECTION")
        if len(values) > 3 and values[3] is not None
        else np.eye(3)[np.abs(axis).argmin()]
    )
    start = start - (start @ axis) * axis
    return file.point(values[1]), axis, start / np.linalg.norm(start)


def _meridians(file: StepFile) -> Array:
    """Return pieces of meridians, shape (n, 2, 2)."""
    corners = np.array([file.point(values[1]) for _, values in file.all_of("VERTEX_POINT")]).reshape(-1, 3)
    if not len(corners):
        raise InputError(f"{file.name} holds no solid; export the bat as a solid (AP214)")
    size = max(float(np.ptp(corners, axis=0).max()), 1e-9)
    axis = _axis(file, size)
    lines = [
        axis.seen(_edge(file, values))
        for _, values in file.all_of("EDGE_CURVE")
        if not _is_ring(file, values, axis, size)
    ]
    lines += [
        line for _, values in file.all_of("ADVANCED_FACE") if (line := _seamless(file, values, axis, size)) is not None
    ]
    pieces = [np.stack([line[:-1], line[1:]], axis=1) for line in lines if len(line) > 1]
    return np.concatenate(pieces) if pieces else np.empty((0, 2, 2))


def _axis(file: StepFile, size: float) -> _Axis:
    """Return the axis of most surfaces that are turned, or of most circles."""
    for kinds in (TURNED, ("CIRCLE",)):
        axes = [
            _Axis(*_placed(file, values[2 if kind == "SURFACE_OF_REVOLUTION" else 1])[:2])
            for kind in kinds
            for _, values in file.all_of(kind)
        ]
        if axes:
            counts = Counter(
                {
                    index: sum(axis.is_along(other.point, other.direction, size) for other in axes[:200])
                    for index, axis in enumerate(axes[:200])
                }
            )
            return axes[counts.most_common(1)[0][0]]
    raise InputError(f"{file.name} has no surface that is turned about an axis; draw the bat as a revolved solid")


def _curve(file: StepFile, reference: Value) -> tuple[str, list[Value], dict[str, list[Value]]]:
    """Return a curve in space: its kind, its values, and all its parts."""
    for _ in range(DEEPEST):
        parts = file.parts(reference)
        wrapped = next(
            (kind for kind in ("SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE", "TRIMMED_CURVE") if kind in parts),
            None,
        )
        if wrapped is None:
            kind = next(
                (
                    kind
                    for kind in ("LINE", "CIRCLE", "ELLIPSE", "B_SPLINE_CURVE_WITH_KNOTS", "POLYLINE")
                    if kind in parts
                ),
                "/".join(parts),
            )
            return kind, parts.get(kind, []), parts
        reference = parts[wrapped][1]
    raise InputError(f"{file.name} has a curve of a curve of a curve; export it anew")


def _is_ring(file: StepFile, edge: list[Value], axis: _Axis, size: float) -> bool:
    kind, values, _ = _curve(file, edge[3])
    return kind == "CIRCLE" and axis.is_along(*_placed(file, values[1])[:2], size)


def _edge(file: StepFile, edge: list[Value]) -> Array:
    """Return points along an edge from one corner to the other, shape (n, 3)."""
    ends = np.array([file.point(file.of(corner, "VERTEX_POINT")[1]) for corner in edge[1:3]])
    forward = edge[4] != ".F."
    kind, values, parts = _curve(file, edge[3])
    if kind == "LINE":
        return ends
    if kind in ("CIRCLE", "ELLIPSE"):
        centre, normal, start = _placed(file, values[1])
        radii = [float(str(radius)) for radius in values[2:4]] * (1 if kind == "ELLIPSE" else 2)
        other = np.cross(normal, start)
        local = np.stack([(ends - centre) @ start / radii[0], (ends - centre) @ other / radii[1]])
        first, last = np.arctan2(local[1], local[0])
        turn = 1.0 if forward else -1.0
        sweep = turn * ((turn * (last - first)) % (2 * np.pi) or 2 * np.pi)
        angle = first + sweep * np.linspace(0, 1, PIECES + 1)
        return np.asarray(
            centre + radii[0] * np.outer(np.cos(angle), start) + radii[1] * np.outer(np.sin(angle), other)
        )
    points = _free_curve(file, kind, values, parts)
    nearest = [int(np.linalg.norm(points - end, axis=1).argmin()) for end in ends]
    if np.linalg.norm(ends[0] - ends[1]) < NEAR * max(np.ptp(points), 1e-300):
        return points
    inner = points[min(nearest) : max(nearest) + 1][1:-1]
    return np.vstack([ends[:1], inner if nearest[0] < nearest[1] else inner[::-1], ends[1:]])


def _free_curve(file: StepFile, kind: str, values: list[Value], parts: dict[str, list[Value]]) -> Array:
    """Return points of a whole B-spline or polyline, shape (n, 3)."""
    from scipy.interpolate import BSpline

    if kind == "POLYLINE":
        return np.array([file.point(each) for each in _list(values[1])])
    if kind != "B_SPLINE_CURVE_WITH_KNOTS":
        raise InputError(
            f"{file.name} has an edge of the kind {kind}, which is not read; export it as AP214 with B-splines"
        )
    rational = parts.get("RATIONAL_B_SPLINE_CURVE")
    base = parts["B_SPLINE_CURVE"] if "B_SPLINE_CURVE" in parts else values[1:3]
    last = values if "B_SPLINE_CURVE" in parts else values[6:]
    degree, poles = int(float(str(base[0]))), np.array([file.point(each) for each in _list(base[1])])
    times = np.array([float(str(each)) for each in _list(last[0])])
    knots = np.array([float(str(each)) for each in _list(last[1])])
    if not 1 <= degree <= MOST_DEGREE or len(poles) > MOST_POLES or times.sum() != len(poles) + degree + 1:
        raise InputError(f"{file.name} has a B-spline whose knots and poles do not fit; export it anew")
    vector = np.repeat(knots, times.astype(int))
    weights = np.ones(len(poles)) if rational is None else np.array([float(str(each)) for each in _list(rational[0])])
    spline = BSpline(vector, np.column_stack([poles * weights[:, None], weights]), degree)
    spans = np.unique(vector[degree : len(poles) + 1])
    pieces = max(LEAST_PIECES, PIECES // max(len(spans) - 1, 1))
    at = np.unique(np.concatenate([np.linspace(low, high, pieces + 1) for low, high in itertools.pairwise(spans)]))
    whole = spline(at)
    return np.asarray(whole[:, :3] / whole[:, 3:])


def _list(value: Value) -> list[Value]:
    if not isinstance(value, list):
        raise TypeError(value)
    return value


def _seamless(file: StepFile, face: list[Value], axis: _Axis, size: float) -> Array | None:
    """Return the meridian, shape (n, 2), of a face between rings that has no seam; None: its edges tell it."""
    rings: list[Array] = []
    for bound in _list(face[1]):
        loop = file.parts(next(iter(file.parts(bound).values()))[1])
        if "VERTEX_LOOP" in loop:
            rings.append(axis.seen(file.point(file.of(loop["VERTEX_LOOP"][1], "VERTEX_POINT")[1])[None])[0])
        for oriented in _list(loop["EDGE_LOOP"][1]) if "EDGE_LOOP" in loop else []:
            edge = file.of(file.of(oriented, "ORIENTED_EDGE")[3], "EDGE_CURVE")
            if not _is_ring(file, edge, axis, size):
                return None
            rings.append(axis.seen(file.point(file.of(edge[1], "VERTEX_POINT")[1])[None])[0])
    ends = np.array(rings).reshape(-1, 2)
    parts = file.parts(face[2])
    kind, values = next(iter(parts.items()))
    if kind in ("CYLINDRICAL_SURFACE", "CONICAL_SURFACE") and len(ends) > 1:
        return ends[np.argsort(ends[:, 0])][[0, -1]]
    if kind == "SURFACE_OF_REVOLUTION":
        swept_kind, swept, all_parts = _curve(file, values[1])
        points = (
            _free_curve(file, swept_kind, swept, all_parts) if swept_kind not in ("LINE", "CIRCLE", "ELLIPSE") else None
        )
        if points is None:
            return ends[np.argsort(ends[:, 0])] if swept_kind == "LINE" and len(ends) > 1 else None
        line = axis.seen(points)
        low, high = (ends[:, 0].min(), ends[:, 0].max()) if len(ends) > 1 else (-np.inf, np.inf)
        return line[(line[:, 0] >= low - NEAR * size) & (line[:, 0] <= high + NEAR * size)]
    if kind in ("TOROIDAL_SURFACE", "SPHERICAL_SURFACE") and len(ends):
        middle = axis.seen(_placed(file, values[1])[0][None])[0]
        if kind == "TOROIDAL_SURFACE":
            middle = np.array([middle[0], float(str(values[2]))])
        around = float(str(values[-1]))
        angle = np.arctan2(ends[:, 1] - middle[1], ends[:, 0] - middle[0])
        first, last = (angle[0], angle[-1]) if len(ends) > 1 else (angle[0], np.pi if angle[0] > np.pi / 2 else 0.0)
        turn = (last - first + np.pi) % (2 * np.pi) - np.pi
        along = first + turn * np.linspace(0, 1, PIECES + 1)
        return np.stack([middle[0] + around * np.cos(along), middle[1] + around * np.sin(along)], axis=1)
    return None

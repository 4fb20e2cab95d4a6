"""The curves of SVG drawings (paths, lines and polygons with all transformations) and of DXF drawings."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator
from itertools import islice
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
from fontTools.misc.transform import Transform

from sweetspot.calibration.outline.curves import MOST_POINTS, check_drawn
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary, read_bytes
from sweetspot.units import INCH, grouped

UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": INCH, "pt": INCH / 72, "pc": INCH / 6, "px": INCH / 96, "": INCH / 96}
"""m; CSS has 96 px to the inch."""
SIZE = re.compile(r"^\s*([0-9.eE+-]+)\s*([a-z]*)\s*$")
TRANSFORM = re.compile(r"(matrix|translate|scale|rotate|skewX|skewY)\s*\(([^)]*)\)")
NUMBERS = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
UNSEEN = {"defs", "clipPath", "symbol", "mask", "marker", "pattern", "text", "metadata", "style"}
PIECES = 40
"""Straight pieces of a curved segment."""
NAMED = ("outline", "profile", "contour")
"""Of an element that is the bat's outline; where there is one, all others are left out."""
LARGEST_SVG = 20_000_000
"""Bytes of a drawing; a picture may lie in it."""
LONGEST_CURVES = 300_000
"""Letters of all its curves."""


def svg_curves(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves of an SVG file and its unit in m; None where width and height have none."""
    content = read_bytes(path, most=LARGEST_SVG, advice="keep only the bat's outline")
    try:
        root = ElementTree.fromstring(content)
    except (ElementTree.ParseError, ValueError, LookupError) as error:
        raise InputError(f"{path} is not an SVG drawing: {error}") from None
    if _tag(root) != "svg":
        raise InputError(f"{path} is not an SVG drawing: it begins with <{_tag(root)}>")
    try:
        with np.errstate(all="ignore"):  # `check_drawn` refuses what is no number
            elements = list(_shapes(root, Transform()))
        chosen = [entry for entry in elements if str(entry[0].get("id", "")).lower() in NAMED] or elements
        if not chosen and any(_tag(element) == "use" for element in root.iter()):
            raise InputError(
                f"{path} shows only copies of something (clones, symbols); make curves of them (Inkscape: Edit, Clone, "
                "Unlink; Illustrator: Object, Expand) and save it again"
            )
        letters = sum(len(element.get("d", "")) + len(element.get("points", "")) for element, _ in chosen)
        if letters > LONGEST_CURVES:
            raise InputError(f"{path} has {grouped(letters)} letters of curves; keep only the bat's outline")
        with np.errstate(all="ignore"):
            curves = [curve for element, matrix in chosen for curve in _curves(element, matrix)]
        unit = _unit(root)
    except InputError:
        raise
    except RecursionError:
        raise InputError(f"{path} has groups within groups within groups; keep only the bat's outline") from None
    except (ValueError, ArithmeticError, LookupError, TypeError, AssertionError, NotImplementedError) as error:
        raise InputError(f"{path} has a curve that cannot be understood: {error}") from None
    return curves, unit


def _tag(element: ElementTree.Element) -> str:
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def _unit(root: ElementTree.Element) -> float | None:
    """Return m per user unit; None without a width that has a unit of length."""
    sizes = [SIZE.match(root.get(name, "").lower()) for name in ("width", "height")]
    lengths = [None if size is None or size[2] not in UNITS else float(size[1]) * UNITS[size[2]] for size in sizes]
    if lengths[0] is None or sizes[0] is None or sizes[0][2] in ("", "px"):
        return None
    box = [float(number) for number in NUMBERS.findall(root.get("viewBox", ""))][2:]
    if len(box) != 2 or box[0] <= 0:
        return UNITS["px"]
    fits = [entry / user for entry, user in zip(lengths, box, strict=True) if entry and user > 0]
    return fits[0] if root.get("preserveAspectRatio") == "none" else min(fits)


def _shapes(element: ElementTree.Element, matrix: Transform) -> Iterator[tuple[ElementTree.Element, Transform]]:
    """Yield what is drawn, with its transformation."""
    hidden = "display:none" in element.get("style", "").replace(" ", "") or element.get("display") == "none"
    if hidden or _tag(element) in UNSEEN:
        return
    matrix = matrix.transform(_transformation(element.get("transform", "")))
    if _tag(element) in ("path", "line", "polyline", "polygon"):
        yield element, matrix
    for child in element:
        yield from _shapes(child, matrix)


def _transformation(text: str) -> Transform:
    """Return the transformation of an element's attribute, the last part first."""
    whole = Transform()
    for name, inside in TRANSFORM.findall(text):
        given = [float(number) for number in NUMBERS.findall(inside)]
        turn = math.radians(given[0])
        if name == "rotate":
            x, y = given[1:3] or (0.0, 0.0)
            part = Transform().translate(x, y).rotate(turn).translate(-x, -y)
        elif name == "matrix":
            part = Transform(*np.reshape(given, 6))  # or it is no matrix
        elif name in ("translate", "scale"):
            part = getattr(Transform(), name)(*given)
        else:
            part = Transform().skew(**{name[-1].lower(): turn})
        whole = whole.transform(part)
    return whole


def _curves(element: ElementTree.Element, matrix: Transform) -> Iterator[Array]:
    """Yield an element's curves as polylines."""
    if _tag(element) == "path":
        lines = _path(element.get("d", ""))
    elif _tag(element) == "line":
        ends = [float(NUMBERS.findall(element.get(name, "0"))[0]) for name in ("x1", "y1", "x2", "y2")]
        lines = [np.array(ends).reshape(2, 2)]
    else:
        points = np.array([float(number) for number in NUMBERS.findall(element.get("points", ""))]).reshape(-1, 2)
        lines = [np.vstack([points, points[:1]]) if _tag(element) == "polygon" else points]
    for line in lines:
        if len(line) > 1:
            yield np.array(matrix.transformPoints(line.tolist()))


def _path(text: str) -> list[Array]:
    """Return the polylines of a path's commands, its curves in `PIECES` straight pieces."""
    from fontTools.pens.recordingPen import RecordingPen
    from fontTools.svgLib.path import parse_path

    pen = RecordingPen()
    parse_path(text, pen)
    lines: list[list[Any]] = []
    along = np.linspace(0, 1, PIECES + 1)[1:, None]
    for command, given in pen.value:
        points = [np.array(point, float) for point in given if point is not None]
        if command == "moveTo":
            lines.append([points[0]])
        elif command == "lineTo":
            lines[-1].append(points[0])
        elif command in ("curveTo", "qCurveTo"):
            ends, degree = [lines[-1][-1], *points], len(points)
            parts = (math.comb(degree, k) * (1 - along) ** (degree - k) * along**k for k in range(degree + 1))
            lines[-1] += list(sum(part * end for part, end in zip(parts, ends, strict=True)))
        elif command == "closePath":
            lines[-1].append(lines[-1][0])
    return [np.array(line) for line in lines]


DRAWN = {"LINE", "LWPOLYLINE", "POLYLINE", "ARC", "ELLIPSE", "SPLINE"}
LAYERS = ("OUTLINE", "PROFILE", "CONTOUR")
"""Of the bat's outline; where there is one, all others are left out."""
FLATNESS = 2e-5
"""Of the drawing's size, by which straight pieces may miss a curve."""
MOST_PIECES = 20_000
"""Things drawn at most; others may lie on other layers."""
UNDER_WAY = -1
"""Instead of how many things a block shows, while they are counted."""
LARGEST_DXF = 4_000_000
"""Bytes of a drawing."""


def dxf_curves(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves of a DXF file and its unit in m; None where the file names none."""
    from ezdxf.lldxf.const import DXFError

    check_ordinary(path, most=LARGEST_DXF, advice="keep only the bat's outline")
    try:
        return _drawn(path)
    except InputError:
        raise
    except OSError as error:
        if error.strerror is None:  # what ezdxf raises for other files
            raise InputError(f"{path} is not a DXF drawing; save it as DXF (ASCII, any release)") from None
        raise InputError(f"{path} cannot be read: {error.strerror.lower()}") from None
    except (DXFError, UnicodeDecodeError, ValueError) as error:
        raise InputError(f"{path} is not a DXF drawing: {error}") from None
    except Exception:  # ezdxf stumbles over damage in any way: StopIteration, IndexError, AttributeError, ...
        raise InputError(f"{path} is a damaged DXF drawing; keep only the bat's outline and save it as R2000") from None


def _drawn(path: Path) -> tuple[list[Array], float | None]:
    """Return the curves and the unit of a file that may be damaged."""
    from ezdxf import disassemble, units
    from ezdxf import path as paths
    from ezdxf.enums import InsertUnits
    from ezdxf.filemanagement import readfile

    drawing = readfile(path)
    if _pieces(drawing.modelspace(), drawing.blocks, {}) > MOST_PIECES:
        raise InputError(f"{path} shows more than {MOST_PIECES} things; keep only the bat's outline")
    entities = [entity for entity in disassemble.recursive_decompose(drawing.modelspace()) if entity.dxftype() in DRAWN]
    outline = [entity for entity in entities if entity.dxf.layer.upper() in LAYERS]
    chosen = [curve for curve in map(paths.make_path, outline or entities) if len(curve)]
    points = [np.array([(p.x, p.y) for p in curve.control_vertices()]) for curve in chosen]
    check_drawn(points, str(path))
    flatness = FLATNESS * max((float(np.ptp(curve, axis=0).max()) for curve in points), default=1.0)
    curves = [
        np.array([(point.x, point.y) for point in islice(curve.flattening(flatness or 1.0), MOST_POINTS + 1)])
        for curve in chosen
    ]
    if drawing.units == 0:
        return curves, None
    return curves, units.conversion_factor(InsertUnits(drawing.units), InsertUnits.Meters)


def _pieces(things: Iterable[Any], blocks: Any, counts: dict[str, int]) -> int:
    """Return the number of drawn entities, those of blocks as often as they are inserted, before any is drawn."""
    count = 0
    for thing in things:
        name = thing.dxf.get("name", "") if thing.dxftype() == "INSERT" else ""
        if not name or name not in blocks:
            count += 1
            continue
        if counts.get(name) == UNDER_WAY:
            raise InputError(f"the block {name[:60]!r} of the drawing holds itself; keep only the bat's outline")
        if name not in counts:
            counts[name] = UNDER_WAY
            counts[name] = max(1, _pieces(blocks[name], blocks, counts))
        count += max(1, thing.mcount) * counts[name]
    return count

"""A sheet as an SVG drawing."""

from __future__ import annotations

from collections.abc import Mapping
from xml.etree import ElementTree

import numpy as np

from sweetspot.reports.drawings.meridian import ON_AXIS, MeridianCurve
from sweetspot.reports.drawings.sheet import DrawingView, Layer, Sheet
from sweetspot.reports.quantities import Reader
from sweetspot.units import INCH

MARGIN, BELOW, LINE_HEIGHT = 12.0, 22.0, 6.0
"""mm of paper around everything, below a view for its sizes, and from one line of words to the next."""
STEP = {"in": INCH, "cm": 0.02}
"""m between the places whose size is written, by the reader's unit of places."""
TEXT, SMALL = 4.0, 2.6
"""mm, height of words and of sizes."""
STYLE: Mapping[Layer, Mapping[str, str]] = {
    "OUTLINE": {"fill": "none", "stroke": "#000", "stroke-width": "0.25"},
    "HOLLOW": {"fill": "none", "stroke": "#000", "stroke-width": "0.18", "stroke-dasharray": "2 1"},
    "PARTS": {"fill": "none", "stroke": "#06c", "stroke-width": "0.18", "stroke-dasharray": "2 1"},
    "FILL": {"fill": "none", "stroke": "#a50", "stroke-width": "0.18", "stroke-dasharray": "1 1"},
    "CENTRE": {"fill": "none", "stroke": "#000", "stroke-width": "0.13", "stroke-dasharray": "8 1.5 1.5 1.5"},
}
TICKS = {"fill": "none", "stroke": "#888", "stroke-width": "0.1"}
WORDS = {"font-family": "sans-serif", "fill": "#000"}


def svg_bytes(sheet: Sheet, reading: Reader) -> bytes:
    """Return a sheet 1 : 1 in mm, with its sizes at every inch or 2 cm in the reader's units."""
    heights = [2e3 * view.reach + (BELOW if view.sizes else 0.0) + MARGIN for view in sheet.views]
    top = 1e3 * sheet.views[0].reach + MARGIN
    lines = [_head(sheet, reading), *sheet.remarks]
    width = 1e3 * sheet.length + 2 * MARGIN
    height = sum(heights) + LINE_HEIGHT * len(lines) + 2 * MARGIN
    drawing = ElementTree.Element(
        "svg", xmlns="http://www.w3.org/2000/svg", version="1.1", width=f"{width:.3f}mm", height=f"{height:.3f}mm",
        viewBox=f"{-MARGIN:.3f} {-top:.3f} {width:.3f} {height:.3f}",
    )  # fmt: skip
    ElementTree.SubElement(drawing, "title").text = sheet.name
    axis, foot = 0.0, 0.0
    for number, view in enumerate(sheet.views):
        axis = axis if number == 0 else foot + MARGIN + 1e3 * view.reach
        _view(drawing, view, axis, number)
        foot = axis + 1e3 * view.reach
        if view.sizes is not None:
            _sizes(drawing, sheet.length, view, foot + 4.0, reading)
            foot += BELOW
    for row, words in enumerate(lines):
        y = foot + LINE_HEIGHT * (row + 1)
        ElementTree.SubElement(
            drawing, "text", {"x": "0", "y": f"{y:.3f}", "font-size": f"{TEXT}", **WORDS}
        ).text = words
    ElementTree.indent(drawing)
    return bytes(ElementTree.tostring(drawing, encoding="utf-8", xml_declaration=True)) + b"\n"


def _head(sheet: Sheet, reading: Reader) -> str:
    every = reading.shown(STEP[reading.unit("place")], "place", digits=0)
    kinds = " and ".join(view.sizes[0] for view in sheet.views if view.sizes is not None)
    written = f" · {kinds} ({reading.unit('length')}) every {every} from the end in the hand" if kinds else ""
    return f"{sheet.name} · {reading.shown(sheet.length, 'length')} long{written} · 1 : 1"


def _view(drawing: ElementTree.Element, view: DrawingView, axis: float, number: int) -> None:
    """Draw the lines of a view; those of the first one's outside are named so that it is read back."""
    for layer in dict.fromkeys(stroke.layer for stroke in view.strokes):
        path = " ".join(path_of(stroke.curves, axis) for stroke in view.strokes if stroke.layer == layer)
        name = layer.lower() + (f"-{number + 1}" if number else "")
        ElementTree.SubElement(drawing, "path", {"id": name, "d": path, **STYLE[layer]})


COMMANDS = {1: "L", 2: "Q", 3: "C"}


def path_of(curves: tuple[MeridianCurve, ...], axis: float) -> str:
    """Return curves as an SVG path in mm; y grows downwards."""
    path, here = "", np.array([np.nan, np.nan])
    for piece in (piece for curve in curves for piece in curve.pieces):
        if not np.abs(piece[0] - here).max() <= ON_AXIS:
            path += f" M{_point(piece[0], axis)}"
        path += f" {COMMANDS[len(piece) - 1]}{' '.join(_point(each, axis) for each in piece[1:])}"
        here = piece[-1]
    return path.strip() + (" Z" if np.abs(here - curves[0].start).max() <= ON_AXIS else "")


def _point(point: np.ndarray, axis: float) -> str:
    return f"{1e3 * point[0]:.4f},{axis - 1e3 * point[1]:.4f}"


def _sizes(drawing: ElementTree.Element, length: float, view: DrawingView, foot: float, reading: Reader) -> None:
    """Write the sizes of a view below it."""
    assert view.sizes is not None
    places = np.arange(0.0, length + 1e-9, STEP[reading.unit("place")])
    group = ElementTree.SubElement(drawing, "g")
    ticks = " ".join(f"M{1e3 * place:.3f},{foot:.3f} v2" for place in places)
    ElementTree.SubElement(group, "path", {"d": ticks, **TICKS})
    digits = 3 if reading.unit("place") == "in" else 2
    for place, size in zip(places.tolist(), view.sizes[1](places).tolist(), strict=True):
        x, y = 1e3 * place, foot + 3.0
        text = ElementTree.SubElement(
            group, "text",
            {"x": f"{x:.3f}", "y": f"{y:.3f}", "transform": f"rotate(90 {x:.3f} {y:.3f})",
             "font-size": f"{SMALL}", "dominant-baseline": "middle", **WORDS},
        )  # fmt: skip
        text.text = reading.number(size, "length", digits=digits)

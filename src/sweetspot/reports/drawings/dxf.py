"""A sheet as a DXF drawing."""

from __future__ import annotations

import io
from collections.abc import Mapping

import numpy as np

from sweetspot.reports.drawings.meridian import MeridianCurve
from sweetspot.reports.drawings.sheet import Layer, Sheet

COLOURS: Mapping[Layer | str, int] = {"OUTLINE": 7, "HOLLOW": 8, "PARTS": 4, "FILL": 30, "CENTRE": 1, "NOTE": 3}
"""Layers with their colours; NOTE holds words."""
APART, TEXT = 25.0, 4.0
"""mm between views, and height of words."""


def dxf_bytes(sheet: Sheet) -> bytes:
    """Return a sheet 1 : 1 in mm: the first view's axis is y = 0 and x = 0 its butt end; other views lie below."""
    from ezdxf import units
    from ezdxf._options import options
    from ezdxf.filemanagement import new

    options.write_fixed_meta_data_for_testing = True  # no time and no random key: one bat is one file, byte for byte
    drawing = new("R2010", units=units.MM)
    drawing.header["$MEASUREMENT"] = 1
    for name, colour in COLOURS.items():
        drawing.layers.add(name, color=colour)
    space = drawing.modelspace()
    y = 0.0
    for number, view in enumerate(sheet.views):
        y -= 1e3 * view.reach if number else 0.0
        for stroke in view.strokes:
            for curve in stroke.curves:
                _draw(space, curve, stroke.layer, y)
        y -= 1e3 * view.reach + APART
    for row, words in enumerate((f"{sheet.name}, mm, 1:1", *sheet.remarks)):
        text = space.add_text(words, height=TEXT, dxfattribs={"layer": "NOTE"})
        text.set_placement((0.0, y - 2 * TEXT * row))
    text_file = io.StringIO()
    drawing.write(text_file)
    return text_file.getvalue().encode()


def _draw(space: object, curve: MeridianCurve, layer: str, y: float) -> None:
    """Add a curve as a line or as the one spline that it is."""
    from ezdxf.layouts.layout import Modelspace

    assert isinstance(space, Modelspace)
    points, knots, times = curve.spline()
    placed = np.column_stack([1e3 * points[:, 0], 1e3 * points[:, 1] + y, np.zeros(len(points))])
    if curve.straight:
        space.add_line(placed[0].tolist(), placed[-1].tolist(), dxfattribs={"layer": layer})
        return
    spans = np.repeat(knots, times) * (1.0 if len(curve.pieces) == 1 else 1e3)
    space.add_open_spline(placed.tolist(), degree=curve.degree, knots=spans.tolist(), dxfattribs={"layer": layer})

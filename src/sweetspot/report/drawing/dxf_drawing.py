"""A turned bat as a DXF drawing in millimetres, for CAD and for lathes."""

from __future__ import annotations

import io

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.report.drawing.contour import side_view

LAYERS = {"OUTLINE": 7, "HOLLOW": 8, "CENTRE": 1}
"""Layers with their colours: both flanks of the side view, what opens at the tip, the axis."""


def drawn_dxf(bat: Bat, hollow: np.ndarray) -> bytes:
    """Return the side view of a bat, 1 : 1 in mm: the axis is y = 0, the knob end lies at x = 0.

    Parameters
    ----------
    hollow : (position, radius) of the hollow that opens at the tip, m, shape (n, 2).
    """
    from ezdxf import units
    from ezdxf.filemanagement import new

    drawing = new("R2010", units=units.MM)
    drawing.header["$MEASUREMENT"] = 1
    for name, colour in LAYERS.items():
        drawing.layers.add(name, color=colour)
    space = drawing.modelspace()
    space.add_lwpolyline((1e3 * side_view(bat)).tolist(), close=True, dxfattribs={"layer": "OUTLINE"})
    if len(hollow) > 1:
        both = 1e3 * np.vstack([hollow, hollow[::-1] * [1, -1]])
        space.add_lwpolyline(both.tolist(), dxfattribs={"layer": "HOLLOW"})
    space.add_line((-5.0, 0.0), (1e3 * bat.length + 5.0, 0.0), dxfattribs={"layer": "CENTRE"})
    text = io.StringIO()
    drawing.write(text)
    return text.getvalue().encode()

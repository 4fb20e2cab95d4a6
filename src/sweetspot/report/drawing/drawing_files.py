"""A bat's drawing in any of the formats that workshops take, by the ending of the file's name."""

from __future__ import annotations

import csv
import io
from pathlib import Path

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.report.drawing.contour import meridian, open_hollow, outline_stations
from sweetspot.report.drawing.dxf_drawing import drawn_dxf
from sweetspot.report.drawing.stl_solid import stl_bytes
from sweetspot.report.drawing.svg_drawing import drawn_svg
from sweetspot.report.quantities import US, Reader

ENDINGS = (".csv", ".svg", ".dxf", ".stl")
"""Stations; a drawing to scale; the same for CAD; a solid of revolution."""
FEWEST = 9
"""Stations of a table."""


def drawing_bytes(bat: Implement, path: Path, *, reading: Reader = US) -> bytes:
    """Return what a file of this name holds: the bat's outline as CSV, SVG, DXF or STL.

    `sweetspot.calibration.outline.outline_file.read_outline` takes the first three back.

    Parameters
    ----------
    bat : a round bat.
    path : a name with one of `ENDINGS`.
    reading : whose units the stations of a CSV and the sizes on an SVG are in; DXF and STL are in mm.

    Raises
    ------
    InputError
        for another ending, and for what is not turned: a racket, club or stick.
    """
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        raise InputError(f"{path} has no ending of a drawing; write to a name that ends in {', '.join(ENDINGS)}")
    if not isinstance(bat, Bat):
        raise InputError(f"{bat.name} is not turned; only round bats can be drawn for a lathe")
    if ending == ".csv":
        return _stations_csv(bat, reading)
    if ending == ".svg":
        return drawn_svg(bat, open_hollow(bat), reading)
    if ending == ".dxf":
        return drawn_dxf(bat, open_hollow(bat))
    return stl_bytes(meridian(bat), bat.name)


def _stations_csv(bat: Bat, reading: Reader) -> bytes:
    """Return the stations as a table that `sweetspot outline` reads, to the micrometre or less."""
    unit, size = ("in", reading.units["length"].size) if reading.unit("length") == "in" else ("mm", 1e-3)
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"position_{unit}", f"diameter_{unit}"])
    stations = outline_stations(bat)
    if len(stations) < FEWEST:
        places = np.linspace(0, bat.length, FEWEST)
        stations = np.column_stack([places, bat.diameter_at(places)])
    writer.writerows([f"{place / size:.6f}", f"{diameter / size:.6f}"] for place, diameter in stations)
    return text.getvalue().encode()

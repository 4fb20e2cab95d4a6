"""A bat's drawing in any of the formats that workshops take, by the ending of the file's name."""

from __future__ import annotations

import csv
import io
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.quantities import US, Reader
from sweetspot.units import INCH

CURVED = 101
"""Places along an outline that is no chain of cones, and in a cup."""
BESIDE = 1e-9
"""m to either side of a step."""


def outline_stations(bat: Bat) -> Array:
    """Return position and diameter of every station from knob end to tip, m, shape (n, 2)."""
    if bat.profile is not None:
        return np.array(bat.profile)
    places = np.linspace(0.0, bat.length, CURVED)
    return np.column_stack([places, bat.diameter_at(places)])


def side_view(bat: Bat) -> Array:
    """Return the closed contour seen from the side, m, from the knob end along one flank and back, shape (n, 2)."""
    places, diameters = outline_stations(bat).T
    there = np.column_stack([places, diameters / 2])
    back = np.column_stack([places[::-1], -diameters[::-1] / 2])
    return np.vstack([there, back])


def meridian(bat: Bat) -> Array:
    """Return (position, radius) around one half of a section, from the axis at the knob to the axis at the tip, m.

    A cup and empty, unplugged holes are part of it. What is inside a hollow bat, behind a plug or in a fill is not.
    """
    places, diameters = outline_stations(bat).T
    outer = np.column_stack([places, diameters / 2])
    return np.vstack([[0.0, 0.0], outer, open_hollow(bat)])


def open_hollow(bat: Bat) -> Array:
    """Return (position, radius) of the hollow that opens at the tip, from its rim to the axis, m; the axis alone."""
    holes = [bore for bore in bat.bores if bore.fill is None and bore.plug == 0]
    depth = max([bore.depth for bore in holes] + [bat.cup.depth if bat.cup else 0.0])
    if depth == 0:
        return np.array([[bat.length, 0.0]])
    edges = [bat.length - bore.depth for bore in holes]
    places = [*edges, *(edge + sign * BESIDE for edge in edges for sign in (-1, 1)), bat.length]
    if bat.cup is not None:
        places += (bat.length - bat.cup.depth * np.linspace(0, 1, CURVED) ** 2).tolist()
    inside = np.array(sorted({place for place in places if bat.length - depth <= place <= bat.length}, reverse=True))
    radius = np.zeros_like(inside)
    for bore in holes:
        radius = np.maximum(radius, np.where(inside >= bat.length - bore.depth, bore.diameter / 2, 0.0))
    if bat.cup is not None:
        into_cup = 1 - (bat.length - inside) / bat.cup.depth
        radius = np.maximum(radius, bat.cup.diameter / 2 * np.sqrt(np.maximum(into_cup, 0.0)))
    chain = np.column_stack([inside, radius])
    return chain if radius[-1] == 0 else np.vstack([chain, [inside[-1], 0.0]])


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


MARGIN, BELOW = 12.0, 26.0
"""mm of paper around the bat, and below it for its sizes."""
STEP = {"in": INCH, "cm": 0.02}
"""m between the places whose diameter is written, by the reader's unit of places."""
TEXT, SMALL = 4.0, 2.6
"""mm, height of the name and of the sizes."""
STYLE = {
    "outline": {"fill": "none", "stroke": "#000", "stroke-width": "0.25"},
    "hollow": {"fill": "none", "stroke": "#000", "stroke-width": "0.18", "stroke-dasharray": "2 1"},
    "centre": {"fill": "none", "stroke": "#000", "stroke-width": "0.13", "stroke-dasharray": "8 1.5 1.5 1.5"},
    "sizes": {"fill": "none", "stroke": "#888", "stroke-width": "0.1"},
}


def drawn_svg(bat: Bat, hollow: np.ndarray, reading: Reader) -> bytes:
    """Return the side view of a bat, 1 : 1 in mm, with its centre line and its diameter at every inch or 2 cm.

    Parameters
    ----------
    hollow : (position, radius) of the hollow that opens at the tip, m, shape (n, 2).
    reading : in whose units sizes are written.
    """
    contour = 1e3 * side_view(bat)
    reach = float(contour[:, 1].max())
    width, height = 1e3 * bat.length + 2 * MARGIN, 2 * reach + 2 * MARGIN + BELOW
    drawing = ElementTree.Element(
        "svg", xmlns="http://www.w3.org/2000/svg", version="1.1", width=f"{width:.3f}mm", height=f"{height:.3f}mm",
        viewBox=f"{-MARGIN:.3f} {-reach - MARGIN:.3f} {width:.3f} {height:.3f}",
    )  # fmt: skip
    ElementTree.SubElement(drawing, "title").text = bat.name
    _line(drawing, "outline", contour, closed=True)
    if len(hollow) > 1:
        _line(drawing, "hollow", 1e3 * np.vstack([hollow, hollow[::-1] * [1, -1]]))
    _line(drawing, "centre", np.array([[-5.0, 0.0], [1e3 * bat.length + 5, 0.0]]))
    _sizes(drawing, bat, reach, reading)
    ElementTree.indent(drawing)
    return bytes(ElementTree.tostring(drawing, encoding="utf-8", xml_declaration=True)) + b"\n"


def _line(drawing: ElementTree.Element, name: str, points: np.ndarray, *, closed: bool = False) -> None:
    path = "M" + " L".join(f"{x:.4f},{y:.4f}" for x, y in points) + (" Z" if closed else "")
    ElementTree.SubElement(drawing, "path", id=name, d=path, **STYLE[name])  # type: ignore[arg-type]


def _sizes(drawing: ElementTree.Element, bat: Bat, reach: float, reading: Reader) -> None:
    """Write name, length and the diameters along the bat below it."""
    step = STEP[reading.unit("place")]
    places = np.arange(0.0, bat.length + 1e-9, step)
    diameters = np.interp(places, *outline_stations(bat).T)
    foot = reach + 4.0
    ticks = "".join(f"M{1e3 * place:.3f},{foot:.3f} v2" for place in places)
    group = ElementTree.SubElement(drawing, "g", id="sizes")
    ElementTree.SubElement(group, "path", d=ticks, **STYLE["sizes"])  # type: ignore[arg-type]
    style = {"font-family": "sans-serif", "fill": "#000"}
    for place, diameter in zip(places, diameters, strict=True):
        x, y = 1e3 * place, foot + 3.0
        text = ElementTree.SubElement(
            group, "text", x=f"{x:.3f}", y=f"{y:.3f}", transform=f"rotate(90 {x:.3f} {y:.3f})",
            **{"font-size": f"{SMALL}", "dominant-baseline": "middle", **style},  # type: ignore[arg-type]
        )  # fmt: skip
        text.text = reading.number(float(diameter), "length", digits=3 if reading.unit("place") == "in" else 2)
    head = ElementTree.SubElement(group, "text", x="0", y=f"{foot + 20:.3f}", **{"font-size": f"{TEXT}", **style})  # type: ignore[arg-type]
    every = reading.shown(step, "place", digits=0)
    head.text = (
        f"{bat.name} · {reading.shown(bat.length, 'length')} long · diameters in {reading.unit('length')} every "
        f"{every} from the knob end · 1 : 1"
    )


AROUND = 180
"""Corners of every circle; the body then has 0.02 % less volume than the round one."""
MILLIMETRE = 1e3
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def stl_bytes(meridian: Array, name: str) -> bytes:
    """Return the solid that a meridian makes as it turns about the axis.

    Parameters
    ----------
    meridian : (position, radius) in m from the axis at one end to the axis at the other, shape (n, 2).
    name : for the file's head.
    """
    corners = MILLIMETRE * triangles(meridian)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(corners), RECORD)
    records["normal"], records["corners"] = normals / np.maximum(size, 1e-30), corners
    head = f"sweetspot: {name}, mm".encode("ascii", "replace")[:80].ljust(80)
    return head + np.uint32(len(records)).tobytes() + records.tobytes()


def triangles(meridian: Array) -> Array:
    """Return the corners of the triangles in m, counter-clockwise from outside, shape (n, 3, 3)."""
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    place, radius = meridian.T
    x = np.broadcast_to(place[:, None], (len(place), AROUND))
    rings = np.stack([x, np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))], axis=2)
    following = np.roll(rings, -1, axis=1)
    corners = []
    for here, there, turned_here, turned_there in zip(
        rings[:-1], rings[1:], following[:-1], following[1:], strict=True
    ):
        if np.any(here[0, 1:] != 0):
            corners.append(np.stack([here, turned_here, there], axis=1))
        if np.any(there[0, 1:] != 0):
            corners.append(np.stack([turned_here, turned_there, there], axis=1))
    return np.concatenate(corners)


ENDINGS = (".csv", ".svg", ".dxf", ".stl")
"""Stations; a drawing to scale; the same for CAD; a solid of revolution."""
FEWEST = 9
"""Stations of a table."""


def drawing_bytes(bat: Implement, path: Path, *, reading: Reader = US) -> bytes:
    """Return the contents of a file with this name: the bat's outline as CSV, SVG, DXF or STL.

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

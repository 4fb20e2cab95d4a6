"""A turned bat as a drawing to scale in SVG: print it at 100 % and lay the bat on it."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.report.drawing.contour import outline_stations, side_view
from sweetspot.report.quantities import Reader
from sweetspot.units import INCH

MARGIN, BELOW = 12.0, 26.0
"""mm of paper around the bat, and below it for its sizes."""
STEP = {"in": INCH, "cm": 0.02}
"""m between the places whose diameter is written, by the unit in which people tell places."""
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
    reading : whose units the sizes are told in.
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

"""The lines of a turned bat: its side view, and the meridian that turns about its axis."""

from __future__ import annotations

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array

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

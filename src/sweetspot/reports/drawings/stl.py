"""Solids of revolution as triangles, for STL files."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.meridian import flattened
from sweetspot.reports.drawings.solids import BatPart, Chain

AROUND = 180
"""Corners of every circle."""
OUTWARD = math.sqrt(2 * math.pi / AROUND / math.sin(2 * math.pi / AROUND))
"""Factor on the radius that gives the polygon the area of its circle (exact), so that a solid weighs what it should."""
CHORD = 5e-6
"""m that straight lines may be off the curve [our choice]."""
MILLIMETRE = 1e3
RECORD = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


def stl_bytes(parts: Iterable[BatPart], name: str) -> bytes:
    """Return solids in mm as one binary STL; what only fills a hole of another is left out, as STL knows no materials.

    ``name``: for the file's head.
    """
    shells = [shell for part in parts if not part.filler for shell in (part.boundary, *part.cavities)]
    corners = MILLIMETRE * np.concatenate([triangles(shell) for shell in shells])
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    size = np.linalg.norm(normals, axis=1, keepdims=True)
    records = np.zeros(len(corners), RECORD)
    records["normal"], records["corners"] = normals / np.maximum(size, 1e-30), corners
    head = f"sweetspot: {name}, mm".encode("ascii", "replace")[:80].ljust(80)
    return head + np.uint32(len(records)).tobytes() + records.tobytes()


def triangles(chain: Chain) -> Array:
    """Return the corners of the triangles in m, counter-clockwise from outside, shape (n, 3, 3)."""
    angle = 2 * np.pi * np.arange(AROUND) / AROUND
    place, radius = (flattened(chain, CHORD) * [1.0, OUTWARD]).T
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

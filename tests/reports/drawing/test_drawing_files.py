"""Drawings of bats: a solid that is closed and has the bat's volume, and lines that CAD takes."""

from __future__ import annotations

import math
from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from ezdxf import units
from ezdxf.document import Drawing
from ezdxf.filemanagement import readfile

from sweetspot import catalog
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawing import AROUND, RECORD, drawing_bytes, meridian, triangles

ROUND = math.sin(2 * math.pi / AROUND) / (2 * math.pi / AROUND)
"""Area of the polygon over the circle's (exact)."""


def outer_volume(bat: Bat) -> float:
    """Return the volume of the conical pieces, m^3 (exact)."""
    places, sizes = np.array(bat.profile).T
    radius = sizes / 2
    pieces = math.pi / 3 * np.diff(places) * (radius[1:] ** 2 + radius[1:] * radius[:-1] + radius[:-1] ** 2)
    return float(pieces.sum())


def volume(corners: Array) -> float:
    """Return what a closed surface encloses, positive when its corners run counter-clockwise from outside."""
    return float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6)


def test_the_solid_is_closed_and_has_the_bats_volume() -> None:
    bat = catalog.bat("r161-ash")
    corners = triangles(meridian(bat))
    assert volume(corners) == pytest.approx(ROUND * outer_volume(bat), rel=1e-9)
    edges: Counter[tuple[bytes, bytes]] = Counter()
    rounded = np.round(corners * 1e9).astype(np.int64)
    for triangle in rounded:
        for one in range(3):
            edges[triangle[one].tobytes(), triangle[(one + 1) % 3].tobytes()] += 1
    assert set(edges.values()) == {1}
    assert all((there, here) in edges for here, there in edges)


def test_cup_and_hole_are_missing_from_the_solid() -> None:
    """A paraboloid is half its cylinder (exact); a hole through it goes on below; a plugged one does not show."""
    bat = catalog.bat("r161-ash")
    cup = math.pi / 4 * 0.03**2 * 0.02 / 2
    cupped = bat.cupped(diameter=0.03, depth=0.02)
    assert outer_volume(bat) - volume(triangles(meridian(cupped))) / ROUND == pytest.approx(cup, rel=2e-3)
    drilled = bat.drilled(diameter=0.02, depth=0.1)
    hole = math.pi / 4 * 0.02**2 * 0.1
    assert outer_volume(bat) - volume(triangles(meridian(drilled))) / ROUND == pytest.approx(hole, rel=1e-6)
    corked = catalog.bat("corked-r161")
    assert volume(triangles(meridian(corked))) == pytest.approx(ROUND * outer_volume(corked), rel=1e-9)


def test_stl_is_in_millimetres_with_outward_normals() -> None:
    content = drawing_bytes(catalog.bat("mlb-a"), Path("a.STL"))
    records = np.frombuffer(content, RECORD, offset=84)
    assert int(np.frombuffer(content, "<u4", 1, 80)[0]) == len(records)
    assert records["corners"][..., 0].max() == pytest.approx(863.6, abs=0.01)
    middle = records["corners"].mean(axis=1)
    flank = np.abs(records["normal"][:, 0]) < 0.5
    outward = np.einsum("ij,ij->i", middle[flank, 1:], records["normal"][flank, 1:])
    assert outward.min() > 0


def test_dxf_has_layers_and_millimetres(tmp_path: Path) -> None:
    path = tmp_path / "bat.dxf"
    path.write_bytes(drawing_bytes(catalog.bat("r161-ash").cupped(diameter=0.03, depth=0.02), path))
    drawing: Drawing = readfile(path)
    assert not drawing.audit().has_errors
    assert drawing.units == units.MM
    assert {one.dxf.layer for one in drawing.modelspace()} == {"OUTLINE", "HOLLOW", "CENTRE"}


def test_what_cannot_be_drawn() -> None:
    with pytest.raises(InputError, match="ending"):
        drawing_bytes(catalog.bat("r161-ash"), Path("bat.step"))
    with pytest.raises(InputError, match="not turned"):
        drawing_bytes(catalog.load_implement("tennis-racket"), Path("bat.dxf"))

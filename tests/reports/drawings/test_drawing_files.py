"""Drawings of bats: solids that are closed and weigh what the bat weighs, and lines that CAD takes."""

from __future__ import annotations

import math
import re
from collections import Counter
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from ezdxf import units
from ezdxf.document import Drawing
from ezdxf.entities.spline import Spline
from ezdxf.filemanagement import readfile
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.drawing_file import Workshop, drawing_bytes
from sweetspot.reports.drawings.meridian import (
    MeridianCurve,
    bezier,
    cut,
    flattened,
    line,
    radius_at,
    smooth_outline,
    volume,
)
from sweetspot.reports.drawings.solids import BatPart, bat_parts
from sweetspot.reports.drawings.step import step_bytes
from sweetspot.reports.drawings.stl import RECORD, triangles

HOLLOW = ["college-alloy", "double-wall", "two-piece", "composite", "youth-alloy"]
TURNED = ["mlb-a", "corked-r161", "torpedo-designed", "textbook", "uniform-rod"]


def bats() -> list[Bat]:
    """Return bats of every kind of inside: none, cup, hole, both, fill, walls, sleeve, two pieces."""
    plain = catalog.bat("mlb-a")
    cupped = plain.cupped(diameter=0.03, depth=0.02)
    return [
        *map(catalog.bat, [*TURNED, *HOLLOW]),
        cupped,
        plain.drilled(diameter=0.02, depth=0.1),
        cupped.drilled(diameter=0.02, depth=0.1),
    ]


def enclosed(corners: Array) -> float:
    """Return what a closed surface encloses, positive when its corners run counter-clockwise from outside."""
    return float(np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6)


def by_slices(curves: list[MeridianCurve]) -> float:
    """Return the volume of what a chain of curves along the axis turns, m^3, by a sum over thin slices."""
    places = np.linspace(curves[0].start[0], curves[-1].end[0], 400_001)
    return float(math.pi * np.trapezoid(radius_at(curves, places) ** 2, places))


def outside(part: BatPart) -> list[MeridianCurve]:
    return [curve for curve in part.boundary if curve.end[0] > curve.start[0] + 1e-9]


@pytest.mark.parametrize("bat", bats(), ids=lambda bat: bat.name)
def test_solids_are_closed_chains(bat: Bat) -> None:
    for part in bat_parts(bat):
        for chain in (part.boundary, *part.cavities):
            for here, there in pairwise(chain):
                np.testing.assert_allclose(here.end, there.start, atol=2e-9)
            on_axis = max(chain[0].start[1], chain[-1].end[1]) < 1e-9
            assert on_axis or np.abs(chain[0].start - chain[-1].end).max() < 1e-9
        assert volume(part.boundary) > 0 > max([-1.0, *map(volume, part.cavities)])


def test_the_volume_of_curves_is_that_of_thin_slices() -> None:
    curves = smooth_outline(catalog.bat("torpedo"))
    assert volume(curves) == pytest.approx(by_slices(curves), rel=1e-9)


@given(st.lists(st.floats(0.001, 0.05), min_size=4, max_size=4), st.floats(0.1, 0.5), st.floats(0.5, 0.9))
def test_a_cut_of_a_curve_lies_on_it(radii: list[float], low: float, high: float) -> None:
    whole = np.column_stack([np.linspace(0, 0.3, 4), radii])
    part = cut(whole, low, high)
    np.testing.assert_allclose(bezier(part, np.array([0.0, 0.5, 1.0]))[[0, 2]], bezier(whole, np.array([low, high])))
    middle = np.array([(low + high) / 2])
    np.testing.assert_allclose(bezier(part, np.array([0.5])), bezier(whole, middle), atol=1e-12)


@pytest.mark.parametrize("name", ["mlb-a", "torpedo-designed", "college-alloy"])
def test_the_outline_is_smooth_and_keeps_its_stations(name: str) -> None:
    """No kink beside a taper or barrel, nothing thicker than drawn, and every station on the curve."""
    bat = catalog.bat(name)
    curves = smooth_outline(bat)
    places, diameters = np.array(bat.profile).T
    np.testing.assert_allclose(2 * radius_at(curves, places), diameters, atol=1e-12)
    assert max(float(curve.points(1e-6)[:, 1].max()) for curve in curves) <= diameters.max() / 2 + 1e-12
    fine = flattened(curves, 1e-8)
    fine = fine[(fine[:, 0] > 0.05) & (fine[:, 0] < bat.length - 0.03)]
    slopes = np.degrees(np.arctan(np.diff(fine[:, 1]) / np.diff(fine[:, 0])))
    assert np.abs(np.diff(slopes)).max() < 0.2  # its stations alone have kinks of 2.4 degrees


@pytest.mark.parametrize("name", HOLLOW)
def test_a_hollow_bat_weighs_what_it_weighs(name: str) -> None:
    """Walls, knob and cap as drawn, with tape and joint that are not, make the bat's own mass."""
    bat = catalog.bat(name)
    assert bat.shell is not None
    not_drawn = sum(weight.mass for weight in bat.point_masses) + bat.shell.joint_mass
    whole = sum(part.mass for part in bat_parts(bat)) + not_drawn
    assert whole == pytest.approx(rigid_body(beam_model(bat)).mass, rel=2e-3)  # smooth here, conical pieces there


def test_the_file_of_a_hollow_bat_is_hollow() -> None:
    """The alloy bat of 856 g, of which 30 g are tape, weighs 826 g of solid alloy in its STL."""
    bat = catalog.bat("college-alloy")
    records = np.frombuffer(drawing_bytes(bat, Path("a.stl")), RECORD, offset=84)
    mass = enclosed(records["corners"].astype(float)) * 1e-9 * bat.material.density
    tape = sum(weight.mass for weight in bat.point_masses)
    assert mass + tape == pytest.approx(rigid_body(beam_model(bat)).mass, rel=3e-4)
    assert mass == pytest.approx(0.8262, abs=5e-4)


@pytest.mark.parametrize("bat", bats(), ids=lambda bat: bat.name)
def test_triangles_are_closed_and_have_the_parts_volume(bat: Bat) -> None:
    for part in bat_parts(bat):
        shells = [triangles(chain) for chain in (part.boundary, *part.cavities)]
        assert sum(map(enclosed, shells)) == pytest.approx(part.volume, rel=1e-4)
        for corners in shells:
            edges: Counter[tuple[bytes, bytes]] = Counter()
            for triangle in np.round(corners * 1e9).astype(np.int64):
                for one in range(3):
                    edges[triangle[one].tobytes(), triangle[(one + 1) % 3].tobytes()] += 1
            assert set(edges.values()) == {1}
            assert all((there, here) in edges for here, there in edges)


def test_cup_holes_and_fills() -> None:
    """A paraboloid is half its cylinder (exact); a hole goes on below it; what is plugged is a closed hollow."""
    bat = catalog.bat("r161-ash")
    whole = bat_parts(bat)[0].volume
    cup = math.pi / 4 * 0.03**2 * 0.02 / 2
    (cupped,) = bat_parts(bat.cupped(diameter=0.03, depth=0.02))
    assert whole - cupped.volume == pytest.approx(cup, rel=1e-9)
    (drilled,) = bat_parts(bat.drilled(diameter=0.02, depth=0.1))
    assert whole - drilled.volume == pytest.approx(math.pi / 4 * 0.02**2 * 0.1, rel=1e-9)
    body, fill = bat_parts(catalog.bat("corked-r161"))
    assert len(body.cavities) == 1
    assert whole - body.volume == pytest.approx(fill.volume, rel=1e-9)
    assert fill.volume == pytest.approx(math.pi / 4 * 0.0254**2 * 9 * 0.0254, rel=1e-9)  # 1 in wide, 10 in less 1 in
    assert fill.filler


ENTITY = re.compile(r"^(#\d+)=(.*);$", re.MULTILINE)
REFERENCE = re.compile(r"#\d+")


def step_entities(content: bytes) -> dict[str, str]:
    return dict(ENTITY.findall(content.decode("ascii")))


def numbers(entity: str) -> Array:
    return np.array([float(each) for each in re.findall(r"-?\d+\.\d*(?:E[+-]?\d+)?", entity)])


@pytest.mark.parametrize("bat", bats(), ids=lambda bat: bat.name)
def test_step_shells_are_closed_and_enclose_the_parts(bat: Bat) -> None:
    """Every edge is used twice, once each way; and what the faces enclose, read from the file alone, is the volume.

    Half a turn of a curve encloses pi / 2 of the integral of r^2 dx along it (exact); flat faces add nothing.
    """
    parts = bat_parts(bat)
    entities = step_entities(step_bytes(parts, bat.name))
    used: Counter[tuple[str, str]] = Counter()
    for entity in entities.values():
        if entity.startswith("EDGE_LOOP"):
            for edge in REFERENCE.findall(entity):
                oriented = entities[edge]
                used[REFERENCE.findall(oriented)[0], oriented[-3]] += 1
    assert set(used.values()) == {1}
    assert {(edge, {"T": "F", "F": "T"}[way]) for edge, way in used} == set(used)
    whole = sum(math.pi / 2 * squared(entities, entity) for entity in entities.values() if swept(entities, entity))
    assert whole * 1e-9 == pytest.approx(sum(part.volume for part in parts), rel=1e-9)


def swept(entities: dict[str, str], entity: str) -> bool:
    """Return whether an entity is a face that is not flat."""
    return entity.startswith("ADVANCED_FACE") and "PLANE(" not in entities[REFERENCE.findall(entity)[-1]]


def squared(entities: dict[str, str], face: str) -> float:
    """Return the integral of r^2 dx in mm^3 along the curve of half a turn, in the direction of its face."""

    def inside(number: str) -> list[str]:
        return REFERENCE.findall(entities[number])

    (loop,) = inside(REFERENCE.findall(face)[0])
    forward = [inside(edge)[0] for edge in inside(loop) if entities[edge].endswith(".T.)")]
    (edge,) = [each for each in forward if not entities[inside(each)[-1]].startswith("CIRCLE")]
    first, last, curve = inside(edge)
    points = [inside(first)[0], inside(last)[0]] if entities[curve].startswith("LINE") else inside(curve)
    control = np.array([numbers(entities[point])[:2] for point in points])
    return volume([MeridianCurve((control,))]) / math.pi


@pytest.mark.parametrize("bat", bats(), ids=lambda bat: bat.name)
def test_another_program_reads_the_step(bat: Bat, tmp_path: Path) -> None:
    """gmsh, where it is installed, finds as many solids, each of its volume; it is no requirement of the project."""
    gmsh = pytest.importorskip("gmsh", reason="gmsh is not installed")
    path = tmp_path / "bat.step"
    path.write_bytes(drawing_bytes(bat, path))
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        found = [gmsh.model.occ.getMass(3, tag) for dim, tag in gmsh.model.occ.importShapes(str(path)) if dim == 3]
    finally:
        gmsh.finalize()
    assert np.array(found) * 1e-9 == pytest.approx([part.volume for part in bat_parts(bat)], rel=1e-4)


def test_step_of_an_odd_name_is_plain_text() -> None:
    bat = catalog.bat("mlb-a").replaced(name="Bob's µ-bat\\")
    content = drawing_bytes(bat, Path("bat.stp"), workshop=Workshop(("NOT LEGAL: ¾ in too long",))).decode("ascii")
    assert r"'Bob''s \X2\00B5\X0\-bat\\'" in content
    assert r"NOT LEGAL: \X2\00BE\X0\ in too long" in content


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
    path.write_bytes(drawing_bytes(catalog.bat("corked-r161").cupped(diameter=0.03, depth=0.02), path))
    drawing: Drawing = readfile(path)
    assert not drawing.audit().has_errors
    assert drawing.units == units.MM
    assert {each.dxf.layer for each in drawing.modelspace()} == {"OUTLINE", "HOLLOW", "FILL", "CENTRE", "NOTE"}
    kinds = Counter(each.dxftype() for each in drawing.modelspace() if each.dxf.layer == "OUTLINE")
    assert kinds["SPLINE"] == 2  # one on each flank, not a chain of chords


def test_splines_of_the_dxf_are_the_curves_themselves(tmp_path: Path) -> None:
    bat = catalog.bat("torpedo-designed")
    path = tmp_path / "bat.dxf"
    path.write_bytes(drawing_bytes(bat, path))
    splines = [each for each in readfile(path).modelspace() if isinstance(each, Spline)]
    points = np.array([point for each in splines for point in each.construction_tool().approximate(400)])[:, :2] / 1e3
    np.testing.assert_allclose(np.abs(points[:, 1]), radius_at(smooth_outline(bat), points[:, 0]), atol=1e-9)


def test_the_table_of_a_lathe_counts_from_the_tip() -> None:
    bat = catalog.bat("mlb-a")
    head, *rows = drawing_bytes(bat, Path("bat.lathe.csv")).decode().split()
    assert head == "Z_mm,X_diameter_mm"
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    assert table[0].tolist() == pytest.approx([0.0, 1e3 * float(bat.diameter_at(bat.length))])
    assert table[-1, 0] == pytest.approx(-1e3 * bat.length)
    assert np.diff(table[:, 0]).min() >= -1.0000001
    places = bat.length + table[:, 0] / 1e3
    np.testing.assert_allclose(table[:, 1], 2e3 * radius_at(smooth_outline(bat), places), atol=1e-4)


OTHERS = ["cricket-bat", "tennis-racket", "golf-driver", "hockey-stick", "pickleball-paddle", "table-tennis-racket"]


@pytest.mark.parametrize("name", OTHERS)
def test_other_implements_are_drawn_with_what_is_known_of_them(name: str, tmp_path: Path) -> None:
    implement = catalog.load_implement(name)
    svg = drawing_bytes(implement, Path("a.svg")).decode()
    assert 'id="outline"' in svg
    assert "known" in svg  # what is not known of it stands on its drawing
    path = tmp_path / "a.dxf"
    path.write_bytes(drawing_bytes(implement, path))
    drawing = readfile(path)
    assert not drawing.audit().has_errors
    reach = [
        point[0]
        for each in drawing.modelspace().query("LINE[layer=='CENTRE']")
        for point in (each.dxf.start, each.dxf.end)
    ]
    assert max(reach) == pytest.approx(1e3 * implement.length + 5)


def test_a_cricket_blade_has_the_section_of_the_model() -> None:
    """Area under the drawn back against width (edge + (spine - edge) / (concavity + 1)) (exact)."""
    from sweetspot.equipment.cricket_bat import CricketBat
    from sweetspot.equipment.shell import between
    from sweetspot.reports.drawings.sheet import sheet_of

    bat = catalog.load_implement("cricket-bat")
    assert isinstance(bat, CricketBat)
    for stroke in sheet_of(bat).views[2].strokes:
        points = np.array([curve.start for curve in stroke.curves])
        place = points[:, 0].mean()
        x, y = np.append(points, points[:1], axis=0).T
        area = abs(float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))) / 2
        width, spine, edge = (
            float(between(each, (x.min() + x.max()) / 2)) for each in (bat.width, bat.spine, bat.edge)
        )
        assert area == pytest.approx(width * (edge + (spine - edge) / (bat.concavity + 1)), rel=2e-3), place


def test_what_cannot_be_drawn() -> None:
    with pytest.raises(InputError, match="ending"):
        drawing_bytes(catalog.bat("r161-ash"), Path("bat.blend"))
    for ending in ("stl", "step", "csv"):
        with pytest.raises(InputError, match="not round"):
            drawing_bytes(catalog.load_implement("tennis-racket"), Path(f"bat.{ending}"))


def test_a_line_is_a_line() -> None:
    assert line((0, 0), (1, 1)).points(1e-9).tolist() == [[0, 0], [1, 1]]


@pytest.mark.parametrize("ending", ["dxf", "stl", "step", "svg"])
def test_one_bat_is_one_file(ending: str) -> None:
    """Exact: no time and no random key in it, so that a search that was killed and went on leaves the same bytes."""
    bat = catalog.bat("mlb-a")
    assert drawing_bytes(bat, Path(f"a.{ending}")) == drawing_bytes(bat, Path(f"a.{ending}"))

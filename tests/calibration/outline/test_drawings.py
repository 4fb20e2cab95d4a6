"""Outlines from drawings: whatever way a draughtsman draws a bat, it has the same diameters."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from ezdxf import units
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace

from sweetspot import catalog
from sweetspot.calibration.outline.curves import outline_of_curves
from sweetspot.calibration.outline.measured_outline import Outline
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.report.drawing.contour import side_view
from sweetspot.report.drawing.drawing_files import drawing_bytes
from sweetspot.report.quantities import SI, US, Reader

BAT = catalog.bat("mlb-a")
CONTOUR = 1e3 * side_view(BAT)
FLANK = CONTOUR[: len(CONTOUR) // 2]


def worst(outline: Outline) -> float:
    """Return the greatest error of a diameter, m; the length must be right."""
    assert outline.profile[0][0] == 0
    assert outline.profile[-1][0] == pytest.approx(BAT.length, abs=1e-6)
    places = np.linspace(0, BAT.length, 701)
    return float(np.abs(np.interp(places, *np.array(outline.profile).T) - BAT.diameter_at(places)).max())


@pytest.mark.parametrize("ending", [".csv", ".svg", ".dxf"])
@pytest.mark.parametrize("reading", [US, SI])
def test_there_and_back(tmp_path: Path, ending: str, reading: Reader) -> None:
    """What is written is read back within a hundredth of a millimetre; a cup does not show from outside."""
    path = tmp_path / f"bat{ending}"
    cupped = BAT.cupped(diameter=0.03, depth=0.02)
    path.write_bytes(drawing_bytes(cupped, path, reading=reading))
    assert worst(read_outline(path)) < 1.1e-5


def both_flanks_apart(space: Modelspace) -> None:
    space.add_lwpolyline(FLANK.tolist())
    space.add_lwpolyline((FLANK * [1, -1]).tolist())
    space.add_line((-20, 0), (900, 0))


def single_lines_backwards(space: Modelspace) -> None:
    for one, other in zip(CONTOUR, np.roll(CONTOUR, -1, axis=0), strict=True):
        space.add_line(tuple(BAT.length * 1e3 - other), tuple(BAT.length * 1e3 - one))


def half_closed_along_the_axis(space: Modelspace) -> None:
    ends = np.array([[0, 7.0], *(FLANK + np.array([0, 7])), [1e3 * BAT.length, 7.0]])
    space.add_lwpolyline(ends.tolist(), close=True)


def flank_over_the_axis_of_a_lathe(space: Modelspace) -> None:
    space.add_lwpolyline(FLANK.tolist())


def upright_in_a_frame(space: Modelspace) -> None:
    space.add_lwpolyline(CONTOUR[:, ::-1].tolist(), close=True)
    space.add_lwpolyline([(-300, -50), (300, -50), (300, 1000), (-300, 1000)], close=True)
    space.add_text("BAT", height=20)
    space.add_circle((100, 100), radius=30)


def at_an_angle(space: Modelspace) -> None:
    turn = np.array([[0.8, -0.6], [0.6, 0.8]])
    space.add_lwpolyline((CONTOUR @ turn).tolist(), close=True)


@pytest.mark.parametrize(
    "draw",
    [both_flanks_apart, single_lines_backwards, half_closed_along_the_axis, flank_over_the_axis_of_a_lathe,
     upright_in_a_frame, at_an_angle],
)  # fmt: skip
def test_ways_to_draw_a_bat(tmp_path: Path, draw: Callable[[Modelspace], None]) -> None:
    drawing = new(units=units.MM)
    draw(drawing.modelspace())
    drawing.saveas(tmp_path / "bat.dxf")
    assert worst(read_outline(tmp_path / "bat.dxf")) < 3e-5


def test_splines_inside_blocks(tmp_path: Path) -> None:
    """A smooth spline through the flank, in inches, inserted as a block."""
    drawing = new(units=units.IN)
    block = drawing.blocks.new("BAT")
    for side in (1, -1):
        block.add_lwpolyline((FLANK * [1, side] / 25.4).tolist())
    drawing.modelspace().add_blockref("BAT", (3, 4), dxfattribs={"rotation": 90})
    drawing.saveas(tmp_path / "bat.dxf")
    assert worst(read_outline(tmp_path / "bat.dxf")) < 3e-5
    smooth = new(units=units.MM)
    x = np.linspace(0, 800, 30)
    radius = 20 + 10 * np.sin(x / 300)
    smooth.modelspace().add_spline(np.column_stack([x, radius, 0 * x]).tolist())
    smooth.saveas(tmp_path / "spline.dxf")
    stations = np.array(read_outline(tmp_path / "spline.dxf").profile)
    assert np.interp(0.4, *stations.T) == pytest.approx(2e-3 * (20 + 10 * np.sin(400 / 300)), abs=5e-6)


def test_curves_and_transformations_of_svg(tmp_path: Path) -> None:
    """A cubic, a quadratic and an arc; groups that move, turn and scale; inches by the view box."""
    text = """<svg xmlns="http://www.w3.org/2000/svg" width="40in" height="10in" viewBox="0 0 400 100">
    <defs><path d="M0 0 L400 3 L0 9Z"/></defs>
    <g transform="translate(30 50) scale(2)"><g transform="rotate(180 82.5 0)">
    <path d="M0,-7 h0 C40,-7 60,-13 100,-13 Q130,-13 160,-13 a5,13 0 0 1 5,13"/>
    <path d="M0,7 C40,7 60,13 100,13 Q130,13 160,13 a5,13 0 0 0 5,-13"/><path d="M0,-7 V7"/></g></g>
    <path d="M0 50 H400"/></svg>"""
    path = tmp_path / "bat.svg"
    path.write_text(text, encoding="utf-8")
    outline = read_outline(path)
    stations = np.array(outline.profile)
    inch = 0.0254
    assert stations[-1, 0] == pytest.approx(33 * inch)
    assert np.interp(0.01 * inch, *stations.T) == pytest.approx(2.8 * inch, rel=1e-3)
    assert np.interp(10 * inch, *stations.T) == pytest.approx(2 * 2 * 10.0 / 10 * inch, rel=2e-3)  # cubic at its middle
    assert np.interp(32.6 * inch, *stations.T) == pytest.approx(5.2 * np.sqrt(1 - 0.6**2) * inch, rel=2e-3)
    without = text.replace('width="40in" height="10in" ', "")
    path.write_text(without, encoding="utf-8")
    with pytest.raises(InputError, match="--length"):
        read_outline(path)
    assert read_outline(path, length=33 * inch).profile[-1][0] == pytest.approx(33 * inch)


def test_a_wrong_scale_is_told() -> None:
    outline = outline_of_curves([CONTOUR], "bat", unit=1e-3, length=0.84)
    assert outline.profile[-1][0] == pytest.approx(0.84)
    assert "863.6 mm" in outline.notes[0]


@pytest.mark.parametrize(
    ("curves", "unit", "message"),
    [
        ([np.array([[0.0, 0], [800, 0]])], 1e-3, "no bat"),
        ([FLANK + np.array([0, 30])], 1e-3, "one flank"),
        ([CONTOUR], None, "--length"),
        ([CONTOUR], 1.0, "863.6 m long"),
        ([FLANK[:8], FLANK[11:], (FLANK * [1, -1])[11:], (FLANK * [1, -1])[:8]], 1e-3, "gaps"),
    ],
)
def test_refusals(curves: list[Array], unit: float | None, message: str) -> None:
    with pytest.raises(InputError, match=message):
        outline_of_curves(curves, "a drawing", unit=unit)


def test_other_files(tmp_path: Path) -> None:
    for name, content, message in (
        ("bat.svg", b"hello", "not an SVG"),
        ("bat.svg", b"<html></html>", "not an SVG"),
        ("bat.svg", b'<svg><path d="M0 0 L"/></svg>', "cannot be understood"),
        ("bat.dxf", b"hello", "not a DXF"),
        ("bat.stp", b"", "ending"),
    ):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(InputError, match=message):
            read_outline(tmp_path / name)
    for name in ("none.svg", "none.dxf"):
        with pytest.raises(InputError, match="no such file"):
            read_outline(tmp_path / name)


@pytest.mark.parametrize(
    ("transform", "drawn"),
    [
        ("matrix(2 0 0 2 30 50)", ((0.0, 1.0), (0.0, 1.0))),
        ("matrix(0 2 -2 0 30 50)", ((0.0, 1.0), (0.0, 1.0))),  # turned by 90 deg
        ("translate(30 50) scale(2) skewX(45)", ((0.0, 1.0), (-1.0, 1.0))),  # x + y: so the x drawn is x - y
        ("translate(30 50) scale(2) skewY(45)", ((0.0, 1.0), (0.0, 1.0, -1.0))),  # y + x
    ],
)
def test_lines_polygons_and_every_transformation_of_svg(
    tmp_path: Path, transform: str, drawn: tuple[tuple[float, ...], tuple[float, ...]]
) -> None:
    """One bat, a cone from 2 in to 2.6 in, sheared beforehand so that the transformation makes it straight."""
    corners = np.array([(0, 10), (165, 13), (165, -13), (0, -10)], float)
    shear_y, shear_x = (drawn[1][2] if len(drawn[1]) > 2 else 0.0), (drawn[1][0] if len(drawn[1]) == 2 else 0.0)
    before = np.column_stack([corners[:, 0] + shear_x * corners[:, 1], corners[:, 1] + shear_y * corners[:, 0]])
    points = " ".join(f"{x:.9g},{y:.9g}" for x, y in before)
    sides = "".join(
        f'<line x1="{a[0]:.9g}" y1="{a[1]:.9g}" x2="{b[0]:.9g}" y2="{b[1]:.9g}"/>'
        for a, b in zip(before, np.roll(before, -1, axis=0), strict=True)
    )
    for shapes in (f'<polygon points="{points}"/>', sides, f'<polyline points="{points} {points.split()[0]}"/>'):
        path = tmp_path / "bat.svg"
        path.write_text(
            '<svg xmlns="http://www.w3.org/2000/svg" width="40in" height="40in" viewBox="0 0 400 400">'
            f'<g transform="{transform}">{shapes}</g></svg>', encoding="utf-8",
        )  # fmt: skip
        stations = np.array(read_outline(path).profile)
        inch = 0.0254
        assert stations[-1, 0] == pytest.approx(33 * inch, rel=1e-6)
        assert np.interp(16.5 * inch, *stations.T) == pytest.approx(4.6 * inch, rel=1e-4)


def test_a_dxf_without_units_takes_the_length_and_a_drawing_no_ruler(tmp_path: Path) -> None:
    drawing = new(units=0)
    for side in (1, -1):
        drawing.modelspace().add_lwpolyline((FLANK * [7, 7 * side]).tolist())
    path = tmp_path / "bat.dxf"
    drawing.saveas(path)
    with pytest.raises(InputError, match="--length"):
        read_outline(path)
    assert worst(read_outline(path, length=BAT.length)) < 3e-5
    with pytest.raises(InputError, match="are for photographs"):
        read_outline(path, ruler=0.3)

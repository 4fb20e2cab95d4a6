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
from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.catalog.files.bat import checked_drawing
from sweetspot.equipment.bat import Bat
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.drawing_file import drawing_bytes
from sweetspot.reports.drawings.meridian import radius_at, smooth_outline
from sweetspot.reports.quantities import SI, US, Reader

BAT = catalog.bat("mlb-a")
FLANK = 1e3 * np.array(BAT.profile) / [1, 2]
CONTOUR = np.vstack([FLANK, FLANK[::-1] * [1, -1]])


def worst(outline: MeasuredOutline) -> float:
    """Return the greatest error of a diameter, m; the length must be right."""
    assert outline.profile[0][0] == 0
    assert outline.profile[-1][0] == pytest.approx(BAT.length, abs=1e-6)
    places = np.linspace(0, BAT.length, 701)
    return float(np.abs(np.interp(places, *np.array(outline.profile).T) - BAT.diameter_at(places)).max())


@pytest.mark.parametrize("ending", [".csv", ".svg", ".dxf"])
@pytest.mark.parametrize("reading", [US, SI])
def test_there_and_back(tmp_path: Path, ending: str, reading: Reader) -> None:
    """What is written is read back, a table as it is and a drawing smooth; a cup does not show from outside."""
    path = tmp_path / f"bat{ending}"
    cupped = BAT.cupped(diameter=0.03, depth=0.02)
    path.write_bytes(drawing_bytes(cupped, path, reading=reading))
    assert off(path, cupped) < 3.5e-5


def off(path: Path, bat: Bat) -> float:
    """Return by how much the diameters that are read from a file differ from those that it was to hold, m."""
    profile = np.array(read_outline(path).profile)
    places = np.linspace(0, bat.length, 701)
    drawn = bat.diameter_at(places) if path.suffix == ".csv" else 2 * radius_at(smooth_outline(bat), places)
    return float(np.abs(np.interp(places, *profile.T) - drawn).max())


@pytest.mark.parametrize("name", ["russell-b3", "textbook", "college-alloy"])
def test_bats_of_few_stations_and_blunt_ends_come_back_too(tmp_path: Path, name: str) -> None:
    bat = catalog.bat(name)
    for ending in (".csv", ".svg", ".dxf"):
        path = tmp_path / f"bat{ending}"
        path.write_bytes(drawing_bytes(bat, path))
        assert off(path, bat) < 3.5e-5


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
        ("bat.sldprt", b"", "ending"),
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
            f'<g transform="{transform}">{shapes}</g></svg>',
            encoding="utf-8",
        )
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


def path_of(points: Array, *, closed: bool = True) -> str:
    return "M" + " L".join(f"{x:.5f},{y:.5f}" for x, y in points) + ("Z" if closed else "")


TO_THE_AXIS = np.vstack([[0, 0], FLANK, [1e3 * BAT.length, 0]]) + np.array([10, 100])
WHOLE = path_of(CONTOUR + np.array([10, 100]))


@pytest.mark.parametrize(
    ("size", "body"),
    [
        # Inkscape turns what it saves by a group; 5 deg are askew and no way to draw
        (
            'width="900mm" height="200mm" viewBox="0 0 900 200"',
            f'<g transform="rotate(5 450 100)"><path d="{WHOLE}"/></g>',
        ),
        # the page is wider than the view: its height tells the scale
        ('width="1800mm" height="200mm" viewBox="0 0 900 200"', f'<path d="{WHOLE}"/>'),
        ('width="90 CM" height="20 CM" viewBox="0 0 900 200"', f'<path d="{WHOLE}"/>'),
        # one flank over a dashed axis, and one flank whose ends go down to its axis
        (
            'width="900mm" height="200mm" viewBox="0 0 900 200"',
            f'<path d="{path_of(FLANK + np.array([10, 100]), closed=False)}"/><path d="M5 100H890"/>',
        ),
        ('width="900mm" height="200mm" viewBox="0 0 900 200"', f'<path d="{path_of(TO_THE_AXIS, closed=False)}"/>'),
    ],
)
def test_ways_in_which_programs_write_svg(tmp_path: Path, size: str, body: str) -> None:
    path = tmp_path / "bat.svg"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{body}</svg>', encoding="utf-8")
    assert worst(read_outline(path)) < 3e-5


def test_a_round_tip_goes_down_to_the_axis(tmp_path: Path) -> None:
    """Drawn with two bulges, or as lines and an arc, in a file of R12 as text: an allowed bat, and the ball's size."""
    half, lathe = (
        np.tan(np.pi / 8),
        np.array([(0, 12), (400, 12.5), (830, 32), (862, 0), (830, -32), (400, -12.5), (0, -12)]),
    )
    bulged = new(units=units.MM)
    bulged.modelspace().add_lwpolyline(
        [(x, y, bulge) for (x, y), bulge in zip(lathe.tolist(), [0, 0, -half, -half, 0, 0, 0], strict=True)],
        format="xyb",
        close=True,
    )
    bulged.saveas(tmp_path / "bulged.dxf")
    lines = [(lathe[at], lathe[at + 1]) for at in (0, 1, 4, 5)] + [(lathe[-1], lathe[0])]
    numbers: list[object] = ["0", "SECTION", "2", "HEADER", "9", "$ACADVER", "1", "AC1009", "9", "$INSUNITS", "70", 4]
    numbers += ["0", "ENDSEC", "0", "SECTION", "2", "ENTITIES"]
    for (x, y), (u, v) in lines:
        numbers += ["0", "LINE", "8", "0", "10", x, "20", y, "11", u, "21", v]
    numbers += [
        "0",
        "ARC",
        "8",
        "0",
        "10",
        830.0,
        "20",
        0.0,
        "40",
        32.0,
        "50",
        -90.0,
        "51",
        90.0,
        "0",
        "ENDSEC",
        "0",
        "EOF",
    ]
    (tmp_path / "r12.dxf").write_text("\r\n".join(map(str, numbers)) + "\r\n")
    for name in ("bulged", "r12"):
        profile = np.array(read_outline(tmp_path / f"{name}.dxf").profile)
        assert profile[-1] == pytest.approx([0.862, 0.005])
        assert np.interp(0.846, *profile.T) == pytest.approx(2e-3 * np.sqrt(32**2 - 16**2), abs=3e-5)
        bat = BAT.replaced(length=0.862, profile=tuple(map(tuple, profile.tolist())))
        assert checked_drawing(bat) is bat


STICK = np.array([(0, 13), (600, 15), (850, 20), (930, 60), (925, 95), (905, 95), (830, 0), (600, -15), (0, -13.0)])


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (f'<path d="{path_of(STICK + np.array([10, 50]))}"/>', "not alike on both sides"),
        (f'<path d="{WHOLE}"/><path d="{path_of(CONTOUR + np.array([10, 190]))}"/>', "two bats"),
        (f'<defs><path id="b" d="{WHOLE}"/></defs><use href="#b"/>', "only copies"),
    ],
)
def test_what_is_not_one_round_bat_is_refused(tmp_path: Path, body: str, message: str) -> None:
    path = tmp_path / "bat.svg"
    path.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="950mm" height="300mm" viewBox="0 0 950 300">{body}</svg>',
        encoding="utf-8",
    )
    with pytest.raises(InputError, match=message):
        read_outline(path)


def test_a_dxf_that_its_library_stumbles_over(tmp_path: Path) -> None:
    words = "0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 ENTITIES 0 3DSOLID 8 0 0 ENDSEC 0 EOF"
    (tmp_path / "bat.dxf").write_text(words.replace(" ", "\n") + "\n")
    with pytest.raises(InputError, match="damaged DXF"):
        read_outline(tmp_path / "bat.dxf")

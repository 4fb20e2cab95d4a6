"""Solids and lathe programs: ten ways each to write one public profile as STL, OBJ and STEP give it back."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot import catalog
from sweetspot.calibration.outline.measured_outline import MeasuredOutline
from sweetspot.calibration.outline.outline_file import read_outline
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

BAT = catalog.bat("mlb-a")
FLANK = np.array(BAT.profile) / [1e-3, 2e-3]
"""(z, r) in mm."""
WITHIN, OF_MASS = 5e-5, 1e-3
"""m of diameter, and part of the volume, by which what comes back may differ."""


def check(outline: MeasuredOutline, flank: Array = FLANK) -> None:
    places, radii = 1e-3 * flank[:, 0], 1e-3 * flank[:, 1]
    profile = np.array(outline.profile)
    assert profile[-1, 0] == pytest.approx(places[-1] - places[0], abs=1e-5)
    at = np.linspace(0, profile[-1, 0], 2001)[1:-1]
    found, true = np.interp(at, *profile.T), 2 * np.interp(at, places - places[0], radii)
    assert np.abs(found - true).max() < WITHIN
    assert np.sum(found**2) == pytest.approx(np.sum(true**2), rel=OF_MASS)


def reversed_flank(flank: Array) -> Array:
    """Return a flank whose thinner half comes first, as a bat's does."""
    return np.asarray((flank[-1] * [1, 0] - flank * [1, -1])[::-1])


def turned(flank: Array, count: int = 48, shift: float = 0.0, *, caps: bool = True) -> Array:
    """Return the triangles of a turned solid that face outward, shape (n, 3, 3)."""
    angle = 2 * np.pi * np.arange(count + 1) / count
    corners = np.array(
        [[(r * np.cos(a + shift * k), r * np.sin(a + shift * k), z) for a in angle] for k, (z, r) in enumerate(flank)]
    )
    one, other = corners[:-1, :-1], corners[:-1, 1:]
    up, across = corners[1:, :-1], corners[1:, 1:]
    sides = np.concatenate(
        [
            np.stack([one, other, across], axis=2).reshape(-1, 3, 3),
            np.stack([one, across, up], axis=2).reshape(-1, 3, 3),
        ]
    )
    ends = []
    for ring, (z, _), way in ((corners[0], flank[0], -1), (corners[-1], flank[-1], 1)):
        centre = np.broadcast_to([0.0, 0.0, z], (count, 3))
        ends.append(np.stack([centre, ring[:-1], ring[1:]][::1] if way > 0 else [centre, ring[1:], ring[:-1]], axis=1))
    return np.concatenate([sides, *ends]) if caps else sides


def finer_facets(triangles: Array) -> Array:
    """Return each triangle in four, whose new corners lie inside of what was turned."""
    a, b, c = (triangles[:, index] for index in range(3))
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    parts = ([a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca])
    return np.concatenate([np.stack(part, axis=1) for part in parts])


def rotation(seed: int) -> Array:
    return np.asarray(np.linalg.qr(np.random.default_rng(seed).standard_normal((3, 3)))[0])


def inner() -> Array:
    """Return the flank of a wall 3 mm inside."""
    places = np.linspace(60.0, FLANK[-1, 0] - 8, 40)
    return np.column_stack([places, np.interp(places, *FLANK.T) - 3.0])


def finer(count: int = 400) -> Array:
    places = np.union1d(np.linspace(0, FLANK[-1, 0], count), FLANK[:, 0])
    return np.column_stack([places, np.interp(places, *FLANK.T)])


def hollow() -> Array:
    return np.concatenate([turned(FLANK), turned(inner())[:, ::-1]])


MESHES: dict[str, Callable[[], Array]] = {
    "upright": lambda: turned(FLANK),
    "few facets": lambda: turned(FLANK, 12),
    "dense": lambda: turned(finer(), 96),
    "twisted rings": lambda: turned(finer(60), 24, 0.07),
    "turned and moved": lambda: turned(FLANK) @ rotation(1).T * np.sign(np.linalg.det(rotation(1))) + [300, -20, 4000],
    "tip first": lambda: turned(FLANK)[:, ::-1] * [1, 1, -1],
    "inside out": lambda: turned(FLANK)[:, ::-1],
    "inches": lambda: turned(FLANK) / 25.4,
    "metres": lambda: turned(FLANK) / 1000,
    "hollow": hollow,
    "facets in facets": lambda: finer_facets(turned(FLANK, 32)),
    "without ends": lambda: turned(FLANK, caps=False) @ rotation(2).T,
}


def binary_stl(triangles: Array) -> bytes:
    record = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")]))
    record["corners"] = triangles
    return b"solid or not".ljust(80) + len(triangles).to_bytes(4, "little") + record.tobytes()


def text_stl(triangles: Array) -> bytes:
    rows = ["solid bat"]
    for triangle in triangles:
        rows += [
            "facet normal 0 0 0",
            " outer loop",
            *(f"  vertex {x:.7e} {y:.7e} {z:.7e}" for x, y, z in triangle),
            " endloop",
            "endfacet",
        ]
    return "\r\n".join([*rows, "endsolid bat"]).encode()


def obj(triangles: Array, *, style: int) -> bytes:
    """Return an OBJ file: plain, with textures and normals, with numbers counted back, or with shared corners."""
    corners, index = np.unique(triangles.reshape(-1, 3).round(7), axis=0, return_inverse=True)
    faces = index.reshape(-1, 3) + 1
    if style == 2:
        faces = faces - len(corners) - 1
    forms = ["{0}", "{0}/1/1", "{0}", "{0}//1"]
    lines = ["# bat", "o bat", *(f"v {x} {y} {z}" for x, y, z in corners), "vn 0 0 1", "vt 0 0", "usemtl ash", "s off"]
    return "\n".join(
        [*lines, *("f " + " ".join(forms[style].format(number) for number in face) for face in faces)]
    ).encode()


@pytest.mark.parametrize("kind", MESHES)
@pytest.mark.parametrize("ending", [".stl", ".obj"])
def test_ways_to_write_a_mesh(tmp_path: Path, kind: str, ending: str) -> None:
    triangles, number = MESHES[kind](), list(MESHES).index(kind)
    path = tmp_path / f"bat{ending}"
    if ending == ".obj":
        path.write_bytes(obj(triangles, style=number % 4))
    else:
        path.write_bytes(text_stl(triangles) if number % 3 == 1 else binary_stl(triangles))
    check(read_outline(path))


def test_a_scan_with_scatter_gives_the_middle_of_it(tmp_path: Path) -> None:
    """Every corner is 0.1 mm off at random: the diameters are off by less than that, not by the worst corner."""
    triangles = turned(finer(600), 90)
    corners, index = np.unique(triangles.reshape(-1, 3).round(6), axis=0, return_inverse=True)
    corners = corners + 0.1 * np.random.default_rng(3).standard_normal(corners.shape)
    path = tmp_path / "scan.stl"
    path.write_bytes(binary_stl(corners[index].reshape(-1, 3, 3)))
    found = np.array(read_outline(path, length=BAT.length).profile)
    at = np.linspace(0.03, BAT.length - 0.03, 500)
    assert np.sqrt(np.mean((np.interp(at, *found.T) - BAT.diameter_at(at)) ** 2)) < 1.5e-4


class Step:
    """A STEP file of a turned solid that is written entity by entity."""

    def __init__(
        self, *, unit: str = "mm", axis: Array | None = None, origin: tuple[float, float, float] = (0, 0, 0)
    ) -> None:
        self.lines: list[str] = []
        self.axes = np.eye(3) if axis is None else axis
        self.origin = np.array(origin, float)
        if unit == "in":
            millimetre = self.add("( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT(.MILLI.,.METRE.) )")
            size = self.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),{millimetre})")
            length = self.add(f"( CONVERSION_BASED_UNIT('INCH',{size}) LENGTH_UNIT() NAMED_UNIT(*) )")
        else:
            prefix = {"mm": ".MILLI.", "m": "$"}[unit]
            length = self.add(f"( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT({prefix},.METRE.) )")
        self.add(
            f"( GEOMETRIC_REPRESENTATION_CONTEXT(3) GLOBAL_UNIT_ASSIGNED_CONTEXT(({length})) "
            "REPRESENTATION_CONTEXT('a;b','it''s') )"
        )

    def add(self, text: str) -> str:
        self.lines.append(f"#{len(self.lines) + 1} = {text};")
        return f"#{len(self.lines)}"

    def triple(self, kind: str, values: Array) -> str:
        return self.add(
            f"{kind}('',({','.join(f'{value:.12G}' if value % 1 else f'{value:.0f}.' for value in values)}))"
        )

    def point(self, z: float, r: float, angle: float = 0.0) -> str:
        local = np.array([r * np.cos(angle), r * np.sin(angle), z])
        return self.triple("CARTESIAN_POINT", self.origin + self.axes @ local)

    def placement(self, z: float = 0.0) -> str:
        axis, start = (self.triple("DIRECTION", self.axes[:, column]) for column in (2, 0))
        return self.add(f"AXIS2_PLACEMENT_3D('',{self.point(z, 0)},{axis},{start})")

    def vertex(self, z: float, r: float, angle: float = 0.0) -> str:
        return self.add(f"VERTEX_POINT('',{self.point(z, r, angle)})")

    def ring(self, z: float, r: float, corner: str) -> str:
        circle = self.add(f"CIRCLE('',{self.placement(z)},{r:.10f})")
        return self.add(f"EDGE_CURVE('',{corner},{corner},{circle},.T.)")

    def line(self, first: str, last: str, start: str) -> str:
        vector = self.add(f"VECTOR('',{self.triple('DIRECTION', self.axes[:, 2])},1.)")
        return self.add(f"EDGE_CURVE('',{first},{last},{self.add(f'LINE({chr(39) * 2},{start},{vector})')},.T.)")

    def face(self, edges: list[list[str]], surface: str) -> None:
        bounds = []
        for loop in edges:
            oriented = [self.add(f"ORIENTED_EDGE('',*,*,{edge},.T.)") for edge in loop]
            bounds.append(
                self.add(f"FACE_BOUND('',{self.add(f'EDGE_LOOP({chr(39) * 2},({chr(44).join(oriented)}))')},.T.)")
            )
        self.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},.T.)")

    def turn(self, flank: Array, *, seam: bool = True, wrapped: bool = False) -> None:
        """Add cones and cylinders between the corners of a flank."""
        corners = [self.vertex(z, r) for z, r in flank]
        rings = [self.ring(z, r, corner) for (z, r), corner in zip(flank, corners, strict=True)]
        for index, ((z, r), (_, other)) in enumerate(itertools.pairwise(flank)):
            if r == other:
                surface = self.add(f"CYLINDRICAL_SURFACE('',{self.placement(z)},{r:.10f})")
            else:
                surface = self.add(f"CONICAL_SURFACE('',{self.placement(z)},{r:.10f},0.1)")
            if not seam:
                self.face([[rings[index]], [rings[index + 1]]], surface)
                continue
            edge = self.line(corners[index], corners[index + 1], self.point(z, r))
            if wrapped:
                number = int(edge[1:])
                curve = self.add(f"SEAM_CURVE('',#{number - 1},(),.CURVE_3D.)")
                self.lines[number - 1] = self.lines[number - 1].replace(f"#{number - 1},", f"{curve},")
            self.face([[rings[index], edge, rings[index + 1], edge]], surface)

    def spline(self, flank: Array, *, rational: bool = False, edge: bool = True) -> None:
        """Add a surface of revolution of a B-spline of degree 1 through a flank."""
        points = ",".join(self.point(z, r) for z, r in flank)
        count = len(flank)
        times = ",".join(["2", *["1"] * (count - 2), "2"])
        knots = ",".join(f"{number}." for number in range(count))
        if rational:
            curve = self.add(
                f"( BOUNDED_CURVE() B_SPLINE_CURVE(1,({points}),.UNSPECIFIED.,.F.,.F.) "
                f"B_SPLINE_CURVE_WITH_KNOTS(({times}),({knots}),.UNSPECIFIED.) CURVE() GEOMETRIC_REPRESENTATION_ITEM() "
                f"RATIONAL_B_SPLINE_CURVE(({','.join(['2.'] * count)})) "
                "REPRESENTATION_ITEM('') )"
            )
        else:
            curve = self.add(
                f"B_SPLINE_CURVE_WITH_KNOTS('',1,({points}),.UNSPECIFIED.,.F.,.F.,({times}),({knots}),.UNSPECIFIED.)"
            )
        axis = self.add(f"AXIS1_PLACEMENT('',{self.point(0, 0)},{self.triple('DIRECTION', self.axes[:, 2])})")
        surface = self.add(f"SURFACE_OF_REVOLUTION('',{curve},{axis})")
        first, last = (self.vertex(*flank[end]) for end in (0, -1))
        loops = [
            [self.ring(float(flank[index, 0]), float(flank[index, 1]), corner)]
            for index, corner in ((0, first), (-1, last))
        ]
        if edge:
            seam = self.add(f"EDGE_CURVE('',{first},{last},{curve},.T.)")
            loops = [[*loops[0], seam, *loops[1], seam]]
        self.face(loops, surface)

    def text(self, schema: str = "AUTOMOTIVE_DESIGN") -> str:
        head = f"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('{schema}'));\nENDSEC;\nDATA;\n"
        return (
            head
            + "/* made up */\n".join(["\n".join(self.lines[:5]) + "\n", "\n".join(self.lines[5:])])
            + "\nENDSEC;\nEND-ISO-10303-21;\n"
        )


def made(build: Callable[[Step], None], schema: str = "AUTOMOTIVE_DESIGN", **where: object) -> Callable[[], str]:
    def text() -> str:
        step = Step(**where)  # type: ignore[arg-type]
        build(step)
        return step.text(schema)

    return text


def proper(seed: int) -> Array:
    turn = rotation(seed)
    return np.asarray(turn * np.sign(np.linalg.det(turn)))


def two_walls(step: Step) -> None:
    step.turn(FLANK)
    step.turn(inner())


STEPS: dict[str, Callable[[], str]] = {
    "cones with seams": made(lambda step: step.turn(FLANK)),
    "cones without seams": made(lambda step: step.turn(FLANK, seam=False)),
    "seams on surfaces": made(lambda step: step.turn(FLANK, wrapped=True), "CONFIG_CONTROL_DESIGN"),
    "a spline turned": made(lambda step: step.spline(FLANK)),
    "a spline turned, no seam": made(lambda step: step.spline(FLANK, edge=False)),
    "a rational spline": made(
        lambda step: step.spline(FLANK, rational=True), "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING_MIM_LF"
    ),
    "inches": made(lambda step: step.turn(FLANK / 25.4), unit="in"),
    "metres": made(lambda step: step.turn(FLANK / 1000), unit="m"),
    "askew and far off": made(lambda step: step.turn(FLANK), axis=proper(5), origin=(150.0, -40.0, 900.0)),
    "hollow": made(two_walls),
    "tip first": made(lambda step: step.spline(FLANK[::-1] * [-1, 1])),
}


@pytest.mark.parametrize("kind", STEPS)
def test_ways_to_write_a_turned_solid(tmp_path: Path, kind: str) -> None:
    path = tmp_path / "bat.step"
    path.write_text(STEPS[kind]())
    check(read_outline(path))


def test_a_round_tip_is_a_torus_or_a_sphere(tmp_path: Path) -> None:
    """A half sphere on a rod with a seam of a circle, and one that ends in a corner on its axis without a seam."""
    rod, radius = np.array([(0.0, 20.0), (820.0, 20.0)]), 20.0
    angle = np.linspace(0, np.pi / 2, 200)
    true = np.vstack(
        [rod, np.column_stack([820 + radius * np.sin(angle[1:-1]), radius * np.cos(angle[1:-1])]), [(840.0, 0.0)]]
    )
    for seam in (True, False):
        step = Step()
        step.turn(rod)
        rim, apex = step.vertex(820.0, radius), step.vertex(840.0, 0.0)
        surface = step.add(f"SPHERICAL_SURFACE('',{step.placement(820.0)},{radius:.1f})")
        if seam:
            along, start = (
                step.triple("DIRECTION", np.array([0.0, -1, 0])),
                step.triple("DIRECTION", np.array([1.0, 0, 0])),
            )
            placement = step.add(f"AXIS2_PLACEMENT_3D('',{step.point(820.0, 0)},{along},{start})")
            circle = step.add(f"CIRCLE('',{placement},{radius:.1f})")
            step.face([[step.ring(820.0, radius, rim), step.add(f"EDGE_CURVE('',{rim},{apex},{circle},.T.)")]], surface)
        else:
            loop = step.add(f"VERTEX_LOOP('',{apex})")
            ring = step.add(f"ORIENTED_EDGE('',*,*,{step.ring(820.0, radius, rim)},.T.)")
            outer = step.add(f"EDGE_LOOP('',({ring}))")
            bounds = [step.add(f"FACE_BOUND('',{each},.T.)") for each in (outer, loop)]
            step.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},.T.)")
        path = tmp_path / "rod.step"
        path.write_text(step.text())
        profile = np.array(read_outline(path).profile)
        at = np.linspace(1.0, 839.5, 400)
        found = np.interp(0.84 - at / 1e3, *profile.T)
        assert np.abs(found - np.maximum(2e-3 * np.interp(at, *true.T), 5e-3)).max() < WITHIN


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("no step", "is not a STEP file"),
        ("ISO-10303-21;\nDATA;\n#1 = CARTESIAN_POINT('',(0.,0.,0.));\n", "holds no solid"),
        ("ISO-10303-21;\n#1=VERTEX_POINT('',#9);", "refers to '#9'"),
        ("ISO-10303-21;\n#1=" + "(" * 99 + ";", "lists in lists"),
    ],
)
def test_what_is_no_turned_solid(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "bat.stp"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_outline(path)


@given(st.integers(0, 2**31), st.integers(1, 60))
def test_a_damaged_solid_or_mesh_is_refused_in_a_sentence(seed: int, count: int) -> None:
    """Bytes of good files are changed at random: either an outline comes of it or a refusal, never another error."""
    import tempfile

    generator = np.random.default_rng(seed)
    good = {
        ".step": STEPS["cones with seams"]().encode(),
        ".stl": binary_stl(turned(FLANK, 8)),
        ".obj": obj(turned(FLANK, 8), style=1),
    }
    for ending, content in good.items():
        damaged = np.frombuffer(content, np.uint8).copy()
        damaged[generator.integers(0, len(damaged), count)] = generator.integers(0, 256, count)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"bat{ending}"
            path.write_bytes(damaged[: generator.integers(len(damaged) // 2, len(damaged) + 1)].tobytes())
            try:
                read_outline(path)
            except InputError as error:
                assert str(error)


def program(*, diameters: bool, head: str, inches: bool = False) -> str:
    """Return two roughing passes and a finishing pass."""
    across, size = (2.0 if diameters else 1.0), (1 / 25.4 if inches else 1.0)
    lines = ["%", "O1000 (BAT)", head, "G0 X100 Z5"]
    for extra in (12.0, 5.0, 0.0):
        lines.append(f"G0 Z{-FLANK[0, 0] * size:.5f} X{across * 60 * size:.4f}")
        lines += [f"G1 X{across * (r + extra) * size:.5f} Z{-z * size:.5f} F0.2" for z, r in FLANK]
        lines += ["G0 X100", "G28 U0 W0"]
    return "\n".join([*lines, "M30", "%"])


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (program(diameters=True, head="G7 G21 G18 G90"), ""),
        (program(diameters=False, head="G8 G21"), ""),
        (program(diameters=True, head="G18"), "taken as diameters"),
        (program(diameters=False, head="G18"), "taken as radii"),
        (program(diameters=True, head="G7 G20 ; inches", inches=True), ""),
        (program(diameters=True, head="G7", inches=True), "taken as in"),
    ],
)
def test_lathe_programs(tmp_path: Path, text: str, words: str) -> None:
    path = tmp_path / "bat.nc"
    path.write_text(text)
    outline = read_outline(path)
    check(outline)
    assert words in " ".join(outline.notes)


def test_arcs_of_a_lathe_program(tmp_path: Path) -> None:
    """A quarter of a circle of 20 mm by its centre and by its radius, either way round, with words that count on."""
    angle = np.linspace(0, np.pi / 2, 100)
    true = np.vstack(
        [[(0.0, 30.0)], [(800.0, 30.0)], np.column_stack([800 + 20 * np.sin(angle), 10 + 20 * np.cos(angle)])]
    )
    for arc in ("G2 Z820 X10 K0 I-20", "G2 Z820 X10 R20", "G91 G2 Z20 X-20 R20"):
        path = tmp_path / "rod.ngc"
        path.write_text(f"G8 G21\nG0 Z0 X30\nG1 Z800\n{arc}\n")
        check(read_outline(path), reversed_flank(true))
    path.write_text("G7 G21\nG0 Z820 X20\nG3 Z800 X60 I0 K-20 (backwards)\nG1 Z0\n")
    check(read_outline(path), reversed_flank(true))


@pytest.mark.parametrize(
    ("text", "message"),
    [("G0 X1 Z2\n", "no cut"), ("G1 X1 Z1e9\nG1 X1 Z99999999\n", "goes to"), ("G8\nG0 X0 Z0\nG2 X9 Z0 R1\n", "no arc")],
)
def test_what_is_no_lathe_program(tmp_path: Path, text: str, message: str) -> None:
    path = tmp_path / "bat.nc"
    path.write_text(text)
    with pytest.raises(InputError, match=message):
        read_outline(path)

"""Solids of revolution as a STEP file (ISO 10303-21, AP214), with the curves of the section exact."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from sweetspot.reports.drawings.meridian import ON_AXIS, MeridianCurve
from sweetspot.reports.drawings.solids import BatPart, Chain

MILLIMETRE = 1e3
SAME = 1e-6
"""mm within which readers may take points as one."""
SCHEMA = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"
UNDATED = "1970-01-01T00:00:00"
"""A file's time: none, so that equal bats make equal files."""


def step_bytes(parts: Iterable[BatPart], name: str, remark: str = "") -> bytes:
    """Return solids in mm, along the x axis from the knob end at 0, as one product.

    ``name``: of the product. ``remark``: its description, such as a rule that it breaks.
    """
    model = _Entities()
    placement = model.add(
        "AXIS2_PLACEMENT_3D('',{},{},{})", model.point(0, 0), model.direction(0, 0, 1), model.direction(1, 0, 0)
    )
    solids = [_solid(model, part) for part in parts]
    context = _context(model)
    shape = model.add(f"ADVANCED_BREP_SHAPE_REPRESENTATION({_text(name)},({','.join([placement, *solids])}),{context})")
    _product(model, shape, name, remark)
    head = (
        "ISO-10303-21;\nHEADER;\n"
        f"FILE_DESCRIPTION(({_text(remark or 'solid of revolution')}),'2;1');\n"
        f"FILE_NAME({_text(name)},'{UNDATED}',(''),(''),'sweetspot','sweetspot','');\n"
        f"FILE_SCHEMA(('{SCHEMA}'));\nENDSEC;\nDATA;\n"
    )
    return (head + "\n".join(model.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n").encode("ascii")


def _text(words: str) -> str:
    r"""Return a string of ISO 10303-21: quotes doubled, other letters than ASCII as \X2\ code units.

    >>> _text("Bob's"), _text("µ")
    ("'Bob''s'", "'\\X2\\00B5\\X0\\'")
    """
    plain = words.replace("\\", "\\\\").replace("'", "''").replace("\n", " ")
    return "'" + "".join(letter if " " <= letter <= "~" else _coded(letter) for letter in plain) + "'"


def _coded(letter: str) -> str:
    return f"\\X2\\{letter.encode('utf-16-be').hex().upper()}\\X0\\"


def _real(number: float) -> str:
    """Return a real number, which must have a point; a thousandth of a nanometre and less is 0."""
    text = f"{0.0 if abs(number) < 1e-12 else number:.12G}"
    mantissa, _, exponent = text.partition("E")
    return (mantissa if "." in mantissa else mantissa + ".") + (f"E{exponent}" if exponent else "")


class _Entities:
    """The numbered entities of a file; equal ones of one solid are written once, solids share none."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self._numbers: dict[str, str] = {}

    def add(self, pattern: str, *references: str) -> str:
        """Add an entity and return its number; each {} of the pattern is one of the references."""
        entity = pattern.format(*references) if references else pattern
        if entity not in self._numbers:
            self._numbers[entity] = f"#{len(self.lines) + 1}"
            self.lines.append(f"{self._numbers[entity]}={entity};")
        return self._numbers[entity]

    def forget(self) -> None:
        """Let what comes share nothing with what is there."""
        self._numbers.clear()

    def point(self, place: float, across: float) -> str:
        """Add a point of the plane in which the section lies, mm."""
        return self.add(f"CARTESIAN_POINT('',({_real(place)},{_real(across)},0.))")

    def direction(self, x: float, y: float, z: float = 0.0) -> str:
        """Add a direction."""
        return self.add(f"DIRECTION('',({_real(x)},{_real(y)},{_real(z)}))")

    def vertex(self, place: float, across: float) -> str:
        """Add a corner."""
        return self.add("VERTEX_POINT('',{})", self.point(place, across))

    def across(self, place: float, axis: float = 1.0) -> str:
        """Add a frame at a place on the axis, looking along it or, with -1, back."""
        return self.add(
            "AXIS2_PLACEMENT_3D('',{},{},{})", self.point(place, 0), self.direction(axis, 0), self.direction(0, 1)
        )


def _solid(model: _Entities, part: BatPart) -> str:
    model.forget()
    outer = _shell(model, part.boundary)
    name = _text(part.name if part.name == part.material else f"{part.name}, {part.material}")
    if not part.cavities:
        return model.add(f"MANIFOLD_SOLID_BREP({name},{outer})")
    # a cavity's shell looks away from the material, as a void's has to: no need to turn it round
    voids = [model.add(f"ORIENTED_CLOSED_SHELL('',*,{_shell(model, each)},.T.)") for each in part.cavities]
    return model.add(f"BREP_WITH_VOIDS({name},{outer},({','.join(voids)}))")


def _shell(model: _Entities, chain: Chain) -> str:
    """Add the surface that a chain sweeps, every polynomial piece a face of its own.

    A smooth curve of several pieces could be one face, and as exact; but the usual kernel then measures its volume over
    all pieces at once, 0.1 to 10 % wrong.
    """
    pieces = [MeridianCurve((piece,)) for curve in chain for piece in curve.pieces]
    faces = [face for piece in pieces if not _on_axis(piece) for face in _faces(model, piece)]
    return model.add(f"CLOSED_SHELL('',({','.join(faces)}))")


def _on_axis(curve: MeridianCurve) -> bool:
    return bool(max(curve.start[1], curve.end[1]) <= ON_AXIS)


def _faces(model: _Entities, curve: MeridianCurve) -> list[str]:
    """Return the faces that a curve sweeps: a flat one, or two halves."""
    (x0, r0), (x1, r1) = (MILLIMETRE * end for end in (curve.start, curve.end))
    if curve.straight and abs(x1 - x0) <= MILLIMETRE * ON_AXIS:
        return [_disc(model, x0, r0, r1)]
    surface, forward = _surface(model, curve)
    flanks = [_flank(model, curve, side) for side in (1.0, -1.0)]
    faces = []
    for here in (0, 1):
        edges = [
            *_arcs(model, x0, r0, [here], forward=True), (flanks[1 - here], True),
            *_arcs(model, x1, r1, [here], forward=False), (flanks[here], False),
        ]  # fmt: skip
        faces.append(_face(model, surface, [_loop(model, edges)], forward=forward))
    return faces


def _disc(model: _Entities, x: float, inner: float, outer: float) -> str:
    """Return a flat ring or disc; it looks towards the knob where its curve leads outwards."""
    plane = model.add("PLANE('',{})", model.across(x, -1.0 if outer > inner else 1.0))
    bounds = [_arcs(model, x, inner, [0, 1], forward=True), _arcs(model, x, outer, [1, 0], forward=False)]
    loops = [_loop(model, edges) for edges in (bounds if inner > outer else bounds[::-1]) if edges]
    return _face(model, plane, loops, forward=True)


def _face(model: _Entities, surface: str, loops: Sequence[str], *, forward: bool) -> str:
    kinds = ["FACE_OUTER_BOUND", *["FACE_BOUND"] * (len(loops) - 1)]
    bounds = [model.add(f"{kind}('',{loop},.T.)") for kind, loop in zip(kinds, loops, strict=True)]
    return model.add(f"ADVANCED_FACE('',({','.join(bounds)}),{surface},{_logical(forward)})")


def _loop(model: _Entities, edges: Iterable[tuple[str, bool]]) -> str:
    oriented = [model.add(f"ORIENTED_EDGE('',*,*,{edge},{_logical(forward)})") for edge, forward in edges]
    return model.add(f"EDGE_LOOP('',({','.join(oriented)}))")


def _logical(value: bool) -> str:
    return ".T." if value else ".F."


def _arcs(model: _Entities, x: float, radius: float, halves: Sequence[int], *, forward: bool) -> list[tuple[str, bool]]:
    """Return half circles about the axis: 0 from +y over +z to -y, 1 back; none on the axis."""
    if radius <= MILLIMETRE * ON_AXIS:
        return []
    circle = model.add(f"CIRCLE('',{{}},{_real(radius)})", model.across(x))
    ends = [model.vertex(x, radius), model.vertex(x, -radius)]
    return [(model.add("EDGE_CURVE('',{},{},{},.T.)", ends[half], ends[1 - half], circle), forward) for half in halves]


def _flank(model: _Entities, curve: MeridianCurve, side: float) -> str:
    """Return a curve as an edge on one side of the axis."""
    (x0, r0), (x1, r1) = (MILLIMETRE * end for end in (curve.start, curve.end))
    ends = model.vertex(x0, side * r0), model.vertex(x1, side * r1)
    return model.add("EDGE_CURVE('',{},{},{},.T.)", *ends, _curve(model, curve, side))


def _curve(model: _Entities, curve: MeridianCurve, side: float) -> str:
    points = curve.pieces[0]
    if curve.straight:
        (x0, r0), (x1, r1) = (MILLIMETRE * points).tolist()
        length = math.hypot(x1 - x0, r1 - r0)
        way = model.direction((x1 - x0) / length, side * (r1 - r0) / length)
        return model.add("LINE('',{},{})", model.point(x0, side * r0), model.add("VECTOR('',{},1.)", way))
    control = ",".join(model.point(x, side * r) for x, r in (MILLIMETRE * points).tolist())
    return model.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{curve.degree},({control}),.UNSPECIFIED.,.F.,.F.,"
        f"({curve.degree + 1},{curve.degree + 1}),(0.,1.),.UNSPECIFIED.)"
    )


def _surface(model: _Entities, curve: MeridianCurve) -> tuple[str, bool]:
    """Return the surface that a curve sweeps, and whether its own normal points out of the material."""
    (x0, r0), (x1, r1) = (MILLIMETRE * end for end in (curve.start, curve.end))
    if not curve.straight:
        axis = model.add("AXIS1_PLACEMENT('',{},{})", model.point(0, 0), model.direction(1, 0))
        return model.add("SURFACE_OF_REVOLUTION('',{},{})", _curve(model, curve, 1.0), axis), True
    if abs(r1 - r0) <= MILLIMETRE * ON_AXIS:
        return model.add(f"CYLINDRICAL_SURFACE('',{{}},{_real(r0)})", model.across(x0)), x1 > x0
    grows = (r1 - r0) / (x1 - x0)
    small, place = (r0, x0) if r0 < r1 else (r1, x1)
    frame = model.across(place, math.copysign(1.0, grows))
    return model.add(f"CONICAL_SURFACE('',{{}},{_real(small)},{_real(math.atan(abs(grows)))})", frame), x1 > x0


def _context(model: _Entities) -> str:
    length = model.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    angle = model.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid = model.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    near = model.add(
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({_real(SAME)}),{length},'distance_accuracy_value','')"
    )
    return model.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({near}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('',''))"
    )


def _product(model: _Entities, shape: str, name: str, remark: str) -> None:
    application = model.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    model.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    context = model.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = model.add(f"PRODUCT({_text(name)},{_text(name)},{_text(remark)},({context}))")
    model.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    formation = model.add(f"PRODUCT_DEFINITION_FORMATION('',{_text(remark)},{product})")
    design = model.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    definition = model.add(f"PRODUCT_DEFINITION('design','',{formation},{design})")
    place = model.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    model.add(f"SHAPE_DEFINITION_REPRESENTATION({place},{shape})")

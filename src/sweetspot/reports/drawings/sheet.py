"""What a drawing shows: views with their lines, sizes along them, and what the reader must know."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import singledispatch
from itertools import pairwise
from typing import Literal

import numpy as np

from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Stations, between
from sweetspot.equipment.table_tennis_racket import TableTennisRacket
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.reports.drawings.meridian import ON_AXIS, MeridianCurve, line, radius_at, smooth_outline
from sweetspot.reports.drawings.solids import BatPart, bat_parts

Layer = Literal["OUTLINE", "HOLLOW", "PARTS", "FILL", "CENTRE"]
"""What a line shows: the outside; an edge that is hidden from outside; a part inside; a fill; the axis."""
BEYOND_ENDS = 0.005
"""m by which the axis reaches over both ends."""
INSIDE = 1e-6
"""m by which a line lies inside of the outside, if it does."""
ROUND = 0.5519150244935106
"""Handle of a cubic over a quarter of a circle: within 2e-4 of its radius (exact to the digits; least deviation)."""
SECTIONS = 5
"""Cross sections of a blade."""


@dataclass(frozen=True)
class DrawnCurves:
    """Curves that follow each other, (position, across) in m."""

    layer: Layer
    curves: tuple[MeridianCurve, ...]


@dataclass(frozen=True)
class DrawingView:
    """One view; across is 0 on its axis.

    ``sizes``: what is written along it: its name, and size in m by position; None: nothing is.
    """

    name: str
    strokes: tuple[DrawnCurves, ...]
    sizes: tuple[str, Callable[[Array], Array]] | None = None

    @property
    def reach(self) -> float:
        """Greatest distance from the axis, m."""
        return max(
            float(np.abs(piece[:, 1]).max()) for stroke in self.strokes for c in stroke.curves for piece in c.pieces
        )


@dataclass(frozen=True)
class Sheet:
    """A drawing at full size.

    Parameters
    ----------
    name, length : of what is drawn, m.
    views : the first one is that from which an outline is read back.
    remarks : what must stand on it: that it breaks a rule, what is not known of it, its tolerance.
    """

    name: str
    length: float
    views: tuple[DrawingView, ...]
    remarks: tuple[str, ...] = ()

    def with_remarks(self, remarks: Sequence[str]) -> Sheet:
        """Return it with other remarks before its own."""
        return replace(self, remarks=(*remarks, *self.remarks))


@singledispatch
def sheet_of(implement: Implement) -> Sheet:
    """Return the drawing of an implement, of what its description holds and nothing else.

    Raises
    ------
    InputError
        for a kind of implement that no drawing is known of.
    """
    raise InputError(f"{implement.name} has no drawing: its description holds no outline")


@sheet_of.register
def _bat_sheet(bat: Bat) -> Sheet:
    outside, parts = smooth_outline(bat), bat_parts(bat)
    ends = (line((0.0, -outside[0].start[1]), (0.0, outside[0].start[1])),)
    tip = (line((bat.length, outside[-1].end[1]), (bat.length, -outside[-1].end[1])),)
    contour = DrawnCurves(
        "OUTLINE", (*ends, *outside, *tip, *(mirrored(curve).reversed() for curve in reversed(outside)))
    )
    inside = [stroke for part in parts for stroke in _hidden(part, bat, outside)]
    side = DrawingView("side", (contour, *inside, _axis(bat.length)), ("diameters", bat.diameter_at))
    smooth = replace(side, sizes=("diameters", lambda places: 2 * radius_at(outside, places)))
    return Sheet(bat.name, bat.length, (smooth,), _hollow_remarks(bat, parts))


def _hollow_remarks(bat: Bat, parts: Sequence[BatPart]) -> tuple[str, ...]:
    """Return the remarks on what a bat's drawing leaves out or supposes."""
    shell, remarks = bat.shell, []
    if shell is not None and (shell.knob_mass or shell.end_cap_mass):
        remarks.append("Knob and end cap are drawn in the wall's material, as deep as their weight makes them.")
    if bat.point_masses or (shell is not None and shell.joint_mass):
        remarks.append("Grip tape, joint and other small weights are not drawn.")
    if any(part.filler for part in parts):
        remarks.append("The fill is a solid of its own (STEP); an STL shows its hole.")
    return tuple(remarks)


def mirrored(curve: MeridianCurve) -> MeridianCurve:
    """Return a curve on the other side of the axis."""
    return MeridianCurve(tuple(piece * [1.0, -1.0] for piece in curve.pieces))


def _hidden(part: BatPart, bat: Bat, outside: list[MeridianCurve]) -> list[DrawnCurves]:
    """Return the lines of a part that lie inside the bat, on both sides of the axis."""
    layer: Layer = "FILL" if part.filler else "HOLLOW" if part.name in ("body", "handle", "barrel") else "PARTS"
    strokes = []
    for chain in (part.boundary, *part.cavities):
        run: list[MeridianCurve] = []
        for curve in chain:
            middle = curve.points(1e-4).mean(axis=0) if curve.straight else curve.pieces[0].mean(axis=0)
            at_end = min(abs(middle[0]), abs(middle[0] - bat.length)) < INSIDE
            within = float(radius_at(outside, middle[:1])[0]) - middle[1] > INSIDE
            if within and not at_end and max(curve.start[1], curve.end[1]) > ON_AXIS:
                run.append(curve)
            elif run:
                strokes += [DrawnCurves(layer, tuple(run)), DrawnCurves(layer, tuple(map(mirrored, run)))]
                run = []
        if run:
            strokes += [DrawnCurves(layer, tuple(run)), DrawnCurves(layer, tuple(map(mirrored, run)))]
    return strokes


def _axis(length: float) -> DrawnCurves:
    return DrawnCurves("CENTRE", (line((-BEYOND_ENDS, 0.0), (length + BEYOND_ENDS, 0.0)),))


def chain_of(points: Array | Sequence[tuple[float, float]]) -> tuple[MeridianCurve, ...]:
    """Return straight lines through points (position, across) in m."""
    return tuple(line(start, end) for start, end in pairwise(np.asarray(points, float)))


def _both_sides(layer: Layer, stations: Stations | Array) -> DrawnCurves:
    """Return a closed contour that lies evenly about the axis, of (position, width) in m."""
    places, widths = np.asarray(stations, float).T
    there = np.column_stack([places, widths / 2])
    return DrawnCurves(layer, chain_of(np.vstack([there, there[::-1] * [1, -1], there[:1]])))


def _oval(layer: Layer, start: float, end: float, width: float) -> DrawnCurves:
    """Return an ellipse along the axis."""
    middle, along, across = (start + end) / 2, (end - start) / 2, width / 2
    quarter = np.array([[1, 0], [1, ROUND], [ROUND, 1], [0, 1.0]])
    corners = [quarter, quarter[::-1] * [-1, 1], -quarter, quarter[::-1] * [1, -1]]
    return DrawnCurves(
        layer, tuple(MeridianCurve((each * [along, across] + np.array([middle, 0.0]),)) for each in corners)
    )


def _width(implement: Implement) -> tuple[str, Callable[[Array], Array]]:
    return "widths", lambda places: np.asarray(implement.width_at(places))


def _outline_of(implement: Implement) -> DrawnCurves:
    places = np.array(implement.breakpoints())
    return _both_sides("OUTLINE", np.column_stack([places, implement.width_at(places)]))


@sheet_of.register
def _cricket_sheet(bat: CricketBat) -> Sheet:
    """Front, side with the edge's depth hidden, and sections; the back as h(y) of `CricketBat`."""
    top, end, axis = bat.shoulder, bat.length, _axis(bat.length)
    wedge = [(top, bat.handle[-1][1] / 2), (top + bat.splice, 0.0), (top, -bat.handle[-1][1] / 2)]
    front = DrawingView(
        "front",
        (
            _both_sides("OUTLINE", bat.handle),
            _both_sides("OUTLINE", bat.width),
            DrawnCurves("PARTS", chain_of(wedge)),
            axis,
        ),
        _width(bat),
    )
    spine, edge = np.array(bat.spine), np.array(bat.edge)
    handle_middle = float(spine[0, 1]) / 2
    handle = _both_sides("OUTLINE", bat.handle).curves
    raised = tuple(
        MeridianCurve(tuple(piece + np.array([0.0, handle_middle]) for piece in curve.pieces)) for curve in handle
    )
    back = chain_of(np.vstack([[top, 0.0], spine, [end, 0.0], [top, 0.0]]))
    side = DrawingView(
        "side, face below",
        (
            DrawnCurves("OUTLINE", raised),
            DrawnCurves("OUTLINE", back),
            DrawnCurves("HOLLOW", chain_of(edge)),
            _axis(bat.length),
        ),
        ("depths", lambda places: np.where(places < top, between(bat.handle, places), between(bat.spine, places))),
    )
    places = np.linspace(top, end, 2 * SECTIONS + 1)[1::2]
    cuts = DrawingView(
        "sections at their places, face below", tuple(_blade_section(bat, place) for place in places.tolist())
    )
    unknown = "The handle is drawn in the middle of the blade's depth; toe and shoulders are square: no more is known."
    return Sheet(bat.name, bat.length, (front, side, cuts), (unknown,))


def _blade_section(bat: CricketBat, place: float) -> DrawnCurves:
    across = np.linspace(-1, 1, 61)
    half, spine, edge = (float(between(stations, place)) for stations in (bat.width, bat.spine, bat.edge))
    half /= 2
    back = np.column_stack([place + half * across, edge + (spine - edge) * (1 - np.abs(across)) ** bat.concavity])
    return DrawnCurves(
        "OUTLINE", chain_of(np.vstack([[place - half, 0.0], back, [place + half, 0.0], [place - half, 0.0]]))
    )


@sheet_of.register
def _racket_sheet(racket: Racket) -> Sheet:
    head, rim = racket.head, racket.length - racket.head.end
    lines = (
        _oval("OUTLINE", head.start - rim, racket.length, head.width + 2 * rim),
        _oval("HOLLOW", head.start, head.end, head.width),
        DrawnCurves("OUTLINE", (line((0.0, -0.01), (0.0, 0.01)),)),
        DrawnCurves("PARTS", (line((racket.handle_length, -0.01), (racket.handle_length, 0.01)),)),
        _axis(racket.length),
    )
    unknown = (
        f"The head, its string bed ({racket.bed.mains} x {racket.bed.crosses}), the butt and the handle's end: of "
        "the handle, shaft and frame's section nothing is known."
    )
    return Sheet(racket.name, racket.length, (DrawingView("front", lines),), (unknown,))


@sheet_of.register
def _club_sheet(club: GolfClub) -> Sheet:
    places = np.union1d([place for place, _ in club.diameter], [place for place, _ in club.wall])
    outside = between(club.diameter, places)
    bore = np.maximum(outside - 2 * between(club.wall, places), 0.0)
    face = _oval("OUTLINE", club.outline.start, club.outline.end, club.head.face_width)
    lines = (
        _both_sides("OUTLINE", np.column_stack([places, outside])),
        _both_sides("HOLLOW", np.column_stack([places, bore])),
        face,
        DrawnCurves("PARTS", (line((club.grip_length, -0.012), (club.grip_length, 0.012)),)),
        _axis(club.length),
    )
    unknown = (
        "Shaft, its bore, the grip's end, and height and width of the face as an oval: no more of the head is known."
    )
    view = DrawingView("along the shaft", lines, ("diameters", lambda places: between(club.diameter, places)))
    return Sheet(club.name, club.length, (view,), (unknown,))


@sheet_of.register
def _hockey_sheet(stick: HockeyStick) -> Sheet:
    def lines(size: Stations) -> tuple[DrawnCurves, ...]:
        places = np.union1d([place for place, _ in size], [place for place, _ in stick.wall])
        outside = between(size, places)
        bore = np.maximum(outside - 2 * between(stick.wall, places), 0.0)
        return (
            _both_sides("OUTLINE", np.column_stack([places, outside])),
            _both_sides("HOLLOW", np.column_stack([places, bore])),
            _axis(stick.length),
        )

    views = (
        DrawingView("front", lines(stick.width), ("widths", lambda places: between(stick.width, places))),
        DrawingView("side", lines(stick.depth), ("depths", lambda places: between(stick.depth, places))),
    )
    return Sheet(
        stick.name, stick.length, views, ("The stick's tube without its hook and bow, whose shape is not known.",)
    )


@sheet_of.register
def _paddle_sheet(paddle: Paddle) -> Sheet:
    thick, core = paddle.thickness, paddle.core_thickness
    ends = np.array([0.0, paddle.length])
    side = DrawingView(
        "side",
        (
            _both_sides("OUTLINE", np.column_stack([ends, [thick, thick]])),
            _both_sides("HOLLOW", np.column_stack([ends, [core, core]])),
            _axis(paddle.length),
        ),
    )
    front = DrawingView("front", (_outline_of(paddle), _axis(paddle.length)), _width(paddle))
    unknown = "Core and skins; the handle's grip and the shape of the rim are not known."
    return Sheet(paddle.name, paddle.length, (front, side), (unknown,))


@sheet_of.register
def _table_tennis_sheet(racket: TableTennisRacket) -> Sheet:
    blade = racket.blade.thickness
    front_rubber, back_rubber = (0.0 if each is None else each.thickness for each in (racket.front, racket.back))
    neck, end = racket.neck, racket.length
    layers = [(-blade / 2, blade / 2), (blade / 2, blade / 2 + front_rubber), (-blade / 2 - back_rubber, -blade / 2)]
    boxes = [
        DrawnCurves("PARTS", chain_of([(neck, a), (end, a), (end, b), (neck, b), (neck, a)]))
        for a, b in layers
        if b > a
    ]
    handle = _both_sides("OUTLINE", ((0.0, racket.handle_thickness), (neck, racket.handle_thickness)))
    front = DrawingView("front", (_outline_of(racket), _axis(end)), _width(racket))
    side = DrawingView("side, front above", (handle, *boxes, _axis(end)))
    return Sheet(racket.name, end, (front, side), ("The blade is an oval and the handle a box: no more is known.",))

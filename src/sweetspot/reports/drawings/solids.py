"""A round bat as solids of revolution: body or walls with cavities, sleeve, rings, fills, each with its weight."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from sweetspot.dynamics.beam import beam_model
from sweetspot.equipment.bat import Bat, Bore, Cup
from sweetspot.equipment.shell import InnerWall, Ring, Shell, between
from sweetspot.reports.drawings.meridian import (
    ON_AXIS,
    MeridianCurve,
    between_places,
    cut,
    line,
    lowered,
    radius_at,
    smooth_outline,
    split,
    volume,
)

Chain = tuple[MeridianCurve, ...]
"""Curves one after the other, from the axis to the axis or closed, with the material on their right."""
THINNEST = 2e-4
"""m of radius below which a cavity is left out: a wall that reaches the middle."""


@dataclass(frozen=True)
class BatPart:
    """One solid of revolution.

    Parameters
    ----------
    name : as files call it: body, handle, barrel, sleeve, ring 1, fill 1.
    material, density : what it is made of; kg/m^3, as the bat's weight has it.
    boundary : its surface; ``cavities``: those of closed hollows in it.
    filler : whether it only fills a hole of another part.
    """

    name: str
    material: str
    density: float
    boundary: Chain
    cavities: tuple[Chain, ...] = ()
    filler: bool = False

    @property
    def volume(self) -> float:
        """Of the material, m^3."""
        return volume(self.boundary) + sum(map(volume, self.cavities))  # a cavity's is negative

    @property
    def mass(self) -> float:
        """In kg."""
        return self.density * self.volume


def bat_parts(bat: Bat, *, joined: bool = False) -> tuple[BatPart, ...]:
    """Return the solids of a bat, the one that is held first.

    ``joined``: handle and barrel of a two-piece bat as one, for files that know no materials.

    Knob and end cap of a hollow bat are known by their mass alone: they are drawn in the wall's material, from the end
    inwards until they weigh what they do. What sits on the outside, such as grip tape, is not drawn.
    """
    factor = beam_model(bat).density_factor
    outside = smooth_outline(bat)
    return (
        _solid_parts(bat, outside, factor)
        if bat.shell is None
        else _hollow_parts(bat, bat.shell, outside, factor, joined=joined)
    )


def _solid_parts(bat: Bat, outside: list[MeridianCurve], factor: float) -> tuple[BatPart, ...]:
    """Return body and fills of a solid bat."""
    edges = [edge for edge in bat.breakpoints() if edge >= bat.length - max([0.0, *_depths(bat)]) - ON_AXIS]
    runs = _runs([_hole(bat, *ends) for ends in pairwise(edges)])
    opening: Chain = (line((bat.length, outside[-1].end[1]), (bat.length, 0.0)),)
    cavities = []
    for run in runs:
        inside = tuple(curve.reversed() for curve in reversed(run))  # from the tip's side back
        chain = _joined([*inside, line(inside[-1].end, (inside[-1].end[0], 0.0))])
        if abs(run[-1].end[0] - bat.length) > ON_AXIS:
            cavities.append(_joined([line((chain[0].start[0], 0.0), chain[0].start), *chain]))
        else:
            opening = _joined([line((bat.length, outside[-1].end[1]), chain[0].start), *chain])
    boundary = _joined([line((0.0, 0.0), outside[0].start), *outside, *opening])
    body = BatPart("body", bat.material.name, factor * bat.material.density, boundary, tuple(cavities))
    return (body, *(part for number, bore in enumerate(bat.bores, 1) for part in _fill(bat, bore, number)))


def _depths(bat: Bat) -> list[float]:
    return [*(bore.depth for bore in bat.bores), *([] if bat.cup is None else [bat.cup.depth])]


def _bores_at(bat: Bat, middle: float) -> list[Bore]:
    return [bore for bore in bat.bores if bat.length - bore.depth < middle < bat.length - bore.plug]


def _hole(bat: Bat, start: float, end: float) -> MeridianCurve | None:
    """Return the edge of the body's own material between two of its breakpoints; None: there is no hole."""
    widest = max((bore.diameter / 2 for bore in _bores_at(bat, (start + end) / 2)), default=0.0)
    in_cup = None if bat.cup is None else _in_cup(bat.cup, bat.length, start, end)
    if in_cup is not None and in_cup.end[1] > widest + ON_AXIS:
        return in_cup
    return line((start, widest), (end, widest)) if widest else None


def _in_cup(cup: Cup, length: float, start: float, end: float) -> MeridianCurve | None:
    """Return the part of a cup's paraboloid between two positions; exact, of degree 2 in its radius."""
    bottom, radius = length - cup.depth, cup.diameter / 2
    if end <= bottom + ON_AXIS:
        return None
    whole = np.array([[bottom, 0.0], [bottom, radius / 2], [length, radius]])
    low, high = (np.sqrt(max(place - bottom, 0.0) / cup.depth) for place in (start, end))
    return MeridianCurve((cut(whole, float(low), float(high)),))


def _runs(edges: Sequence[MeridianCurve | None]) -> list[list[MeridianCurve]]:
    """Return curves that follow each other without a gap, together."""
    runs: list[list[MeridianCurve]] = [[]]
    for edge in edges:
        if edge is None:
            runs.append([])
        else:
            runs[-1].append(edge)
    return [run for run in runs if run]


def _joined(curves: Sequence[MeridianCurve]) -> Chain:
    """Return curves as one chain: straight pieces across the axis where one ends elsewhere than the next begins."""
    chain: list[MeridianCurve] = []
    for curve in curves:
        if chain and np.abs(chain[-1].end - curve.start).max() > ON_AXIS:
            chain.append(line(chain[-1].end, curve.start))
        if np.abs(curve.end - curve.start).max() > ON_AXIS:
            chain.append(curve)
    return tuple(chain)


def _fill(bat: Bat, bore: Bore, number: int) -> list[BatPart]:
    """Return the fill of a bore, as narrower bores and the cup leave it."""
    if bore.fill is None:
        return []
    edges = [e for e in bat.breakpoints() if bat.length - bore.depth - ON_AXIS <= e <= bat.length - bore.plug + ON_AXIS]
    outer, inner = [], []
    for start, end in pairwise(edges):
        narrower = [each for each in _bores_at(bat, (start + end) / 2) if each.diameter < bore.diameter]
        hole = max((each.diameter / 2 for each in narrower), default=0.0)
        cup = None if bat.cup is None else _in_cup(bat.cup, bat.length, start, end)
        edge = cup if cup is not None and cup.end[1] > hole + ON_AXIS else line((start, hole), (end, hole))
        if edge.end[1] > bore.diameter / 2 - ON_AXIS:
            break  # from here on the cup is wider than the bore
        outer.append(line((start, bore.diameter / 2), (end, bore.diameter / 2)))
        inner.append(edge)
    if not outer:
        return []
    back = [curve.reversed() for curve in reversed(inner) if max(curve.start[1], curve.end[1]) > ON_AXIS]
    return [BatPart(f"fill {number}", bore.fill.name, bore.fill.density, _closed([*outer, *back]), filler=True)]


def _closed(curves: Sequence[MeridianCurve]) -> Chain:
    """Return a chain that begins and ends on the axis, or where it began, if it does not reach the axis."""
    start, end = curves[0].start, curves[-1].end
    if curves[-1].end[0] > curves[0].start[0] + ON_AXIS:  # there and not back: both ends go down to the axis
        return _joined([line((start[0], 0.0), start), *curves, line(end, (end[0], 0.0))])
    return _joined([*curves, line(end, start)])


def _hollow_parts(
    bat: Bat, shell: Shell, outside: list[MeridianCurve], factor: float, *, joined: bool
) -> tuple[BatPart, ...]:
    """Return walls, sleeve and rings of a hollow bat."""
    wall_places = [place for place, _ in shell.wall]
    inside = [_inner(shell, curve) for curve in split(outside, wall_places)]
    usual = bat.material.density if shell.laminate is None else shell.laminate.density
    handle = bat.material if shell.handle_material is None else shell.handle_material
    at_knob = factor * (usual if shell.handle_material is None else handle.density)
    knob = _plug_end(inside, shell.knob_mass / at_knob, backwards=False)
    cap = _plug_end(inside, shell.end_cap_mass / (factor * usual), backwards=True)
    open_ends = _cavity_ends(inside, knob, cap)
    parts: list[BatPart] = []
    if joined or shell.handle_material is None or shell.joint is None:
        parts.append(_walls("body", bat.material.name, factor * usual, outside, inside, open_ends))
    else:
        joint = shell.joint
        ends = (
            ("handle", handle.name, at_knob, 0.0, joint),
            ("barrel", bat.material.name, factor * usual, joint, bat.length),
        )
        for name, material, density, start, end in ends:
            parts.append(
                _walls(
                    name,
                    material,
                    density,
                    between_places(outside, start, end),
                    between_places(inside, start, end),
                    open_ends,
                )
            )
    if shell.inner_wall is not None:
        parts.append(_sleeve(shell.inner_wall, inside, factor))
    return (*parts, *(_ring(bat, shell, ring, number) for number, ring in enumerate(shell.rings, 1)))


def _inner(shell: Shell, curve: MeridianCurve) -> MeridianCurve:
    start, end = shell.wall_at(np.array([curve.start[0], curve.end[0]])).tolist()
    return lowered(curve, start, end)


def _open(curve: MeridianCurve) -> bool:
    """Return whether a cavity is wider than `THINNEST` along a curve of its edge."""
    return min(float(piece[:, 1].min()) for piece in curve.pieces) > THINNEST


def _plug_end(inside: list[MeridianCurve], space: float, *, backwards: bool) -> float:
    """Return the end of a plug of a volume in m^3 that begins at the knob, or backwards at the tip, m."""
    from scipy.optimize import brentq

    start, tip = inside[0].start[0], inside[-1].end[0]

    def excess(place: float) -> float:
        ends = (place, tip) if backwards else (start, place)
        filled = sum(volume([curve]) for curve in between_places(inside, *ends) if _open(curve))
        return filled - space

    if space <= 0:
        return float(tip if backwards else start)
    middle = (start + tip) / 2
    return float(brentq(excess, *((middle, tip) if backwards else (start, middle)), xtol=1e-9))


def _cavity_ends(inside: list[MeridianCurve], knob: float, cap: float) -> tuple[float, float]:
    """Return both ends of the cavity, m: between the plugs, and no nearer the knob than the wall leaves it."""
    wide = [curve for curve in between_places(inside, knob, cap) if _open(curve)]
    return (float(wide[0].start[0]), float(wide[-1].end[0])) if wide else (knob, knob)


def _walls(
    name: str,
    material: str,
    density: float,
    outside: list[MeridianCurve],
    inside: list[MeridianCurve],
    cavity: tuple[float, float],
) -> BatPart:
    """Return one tube with its plugs: a solid with a cavity, or open where it meets another piece."""
    start, end = outside[0].start[0], outside[-1].end[0]
    low, high = max(cavity[0], start), min(cavity[1], end)
    edge = between_places(inside, low, high) if high > low + ON_AXIS else []
    back = [curve.reversed() for curve in reversed(edge)]
    if not back:
        return BatPart(name, material, density, _closed(outside))
    opens_low, opens_high = low <= start + ON_AXIS, high >= end - ON_AXIS
    if not opens_low and not opens_high:
        hollow = _joined([line((high, 0.0), back[0].start), *back, line(back[-1].end, (low, 0.0))])
        return BatPart(name, material, density, _closed(outside), (hollow,))
    if opens_low and opens_high:
        return BatPart(name, material, density, _closed([*outside, *back]))
    if opens_high:
        chain = [line((start, 0.0), outside[0].start), *outside, *back, line(back[-1].end, (low, 0.0))]
    else:
        chain = [line((high, 0.0), back[0].start), *back, *outside, line(outside[-1].end, (end, 0.0))]
    return BatPart(name, material, density, _joined(chain))


def _sleeve(sleeve: InnerWall, inside: list[MeridianCurve], factor: float) -> BatPart:
    places = [place for place, _ in sleeve.wall]
    bore = [
        lowered(curve, sleeve.gap, sleeve.gap) for curve in between_places(split(inside, places), places[0], places[-1])
    ]
    edge = [
        lowered(curve, *(float(between(sleeve.wall, float(end[0]))) for end in (curve.start, curve.end)))
        for curve in bore
    ]
    density = sleeve.material.density if sleeve.laminate is None else sleeve.laminate.density
    back = [curve.reversed() for curve in reversed(edge)]
    return BatPart("sleeve", sleeve.material.name, factor * density, _closed([*bore, *back]))


def _ring(bat: Bat, shell: Shell, ring: Ring, number: int) -> BatPart:
    outer = shell.bore_at(ring.position, float(radius_at(smooth_outline(bat), np.array([ring.position]))[0]))
    hole, (start, end) = ring.hole(outer), ring.ends
    rim = [line((start, outer), (end, outer))]
    back = [line((end, hole), (start, hole))] if hole > ON_AXIS else []
    return BatPart(f"ring {number}", ring.material.name, ring.material.density, _closed([*rim, *back]))

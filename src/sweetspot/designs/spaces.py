"""What a present bat can become: other outlines of wood, other walls of a hollow one, a few numbers of the others."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sweetspot.designs.turned import REFERENCE_LENGTH, turned_space
from sweetspot.designs.variables import DENSITY_SPREAD, MODULUS_SPREAD, ImplementSpace, Space, Variable
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.equipment.racket import Racket
from sweetspot.equipment.shell import Stations, between
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

CLOSE = 1e-6
"""m within which stations of spine and edge are at one place, and move together."""
REACH = 0.05
"""Part by which a racket's weights may change: what lead tape does."""
BLADE_REACH = 0.15
"""Part by which spine and edges of a cricket bat may become thicker or thinner; the width by a third of that."""
SCOOPED = 3.0
"""Greatest concavity of a blade's back that is tried."""
HEAD_REACH = 0.15
"""Part by which the mass and the moments of a club's head may change."""


def _around(name: str, label: str, scale: str, now: float, reach: float) -> Variable:
    return Variable(name, label, scale, (1 - reach) * now, (1 + reach) * now, now)


def racket_space(racket: Racket) -> ImplementSpace:
    """Return the space of rackets like one: mass and swing weight, which lead tape changes."""
    if racket.mass is None or racket.moi is None:
        raise InputError(f"{racket.name} has no measured mass and swing weight; give both")
    variables = (
        _around("mass", "mass", "mass", racket.mass, REACH),
        _around("moi", "swing weight", "moi", racket.moi, REACH),
    )

    def change(implement: Implement, numbers: Array) -> Implement:
        return implement.replaced(mass=float(numbers[0]), moi=float(numbers[1]))

    return ImplementSpace(racket, variables, change)


def cricket_space(bat: CricketBat) -> ImplementSpace:
    """Return the space of cricket bats like one, of the same willow: where the blade swells, and its sizes.

    Length, handle and splice stay. The swell is the station of the thickest spine; it moves between its neighbours.
    """
    inner = range(1, len(bat.spine) - 1)
    if not inner:
        raise InputError(f"{bat.name} has no spine between shoulders and toe; give at least three stations of it")
    swell = max(inner, key=lambda index: bat.spine[index][1])
    before, place, after = (bat.spine[swell + step][0] for step in (-1, 0, 1))
    depth, edge, width = (max(size for _, size in row) for row in (bat.spine, bat.edge, bat.width))

    variables = (
        Variable(
            "swell",
            "swell, from the toe",
            "length",
            bat.length - place - 0.8 * (after - place),
            bat.length - place + 0.8 * (place - before),
            bat.length - place,
        ),
        _around("spine", "depth of the spine at the swell", "length", depth, BLADE_REACH),
        _around("edge", "thickness of the edges", "length", edge, BLADE_REACH),
        _around("width", "width of the blade", "length", width, BLADE_REACH / 3),
        Variable("concavity", "concavity of the back", "ratio", 1.0, max(SCOOPED, bat.concavity), bat.concavity),
    )
    factor = beam_model(bat).density_factor
    willow = bat.material.replaced(density=factor * bat.material.density)

    def change(implement: Implement, numbers: Array) -> Implement:
        swells, spine, edges, wide, concavity = numbers.tolist()
        moved = (bat.length - swells) - place

        def sized(row: Stations, factor: float, *, moves: bool) -> Stations:
            return tuple((at + moved if moves and abs(at - place) < CLOSE else at, size * factor) for at, size in row)

        thick = sized(bat.spine, spine / depth, moves=True)
        thin = tuple(
            (at, min(size, float(between(thick, at)))) for at, size in sized(bat.edge, edges / edge, moves=True)
        )  # an edge is nowhere thicker than the spine
        made = implement.replaced(
            spine=thick,
            edge=thin,
            width=sized(bat.width, wide / width, moves=False),
            concavity=concavity,
            material=willow,
            mass=None,
            balance_point=None,
            moi=None,
        )
        if bat.mass is None and factor == 1:
            return made
        return made.replaced(material=bat.material, mass=rigid_body(beam_model(made)).mass)  # the same willow again

    return ImplementSpace(bat, variables, change)


def willow_variants(bat: Implement) -> list[tuple[Implement, Implement]]:
    """Return a cricket bat of denser and of lighter willow, and of stiffer and of softer, a standard deviation each."""
    assert isinstance(bat, CricketBat)
    willow = bat.material

    def of(**factors: float) -> Implement:
        changed = {name: getattr(willow, name) * factor for name, factor in factors.items()}
        return bat.replaced(material=willow.replaced(**changed), mass=None, balance_point=None, moi=None)

    ends = [(1 + spread, 1 - spread) for spread in (DENSITY_SPREAD, MODULUS_SPREAD)]
    return [
        (of(density=ends[0][0]), of(density=ends[0][1])),
        (of(longitudinal_modulus=ends[1][0]), of(longitudinal_modulus=ends[1][1])),
    ]


def club_space(club: GolfClub) -> ImplementSpace:
    """Return the space of clubs like one: mass of the head, and its moment against twisting up and down."""
    head = club.head
    variables = (
        _around("head_mass", "mass of the head", "mass", head.mass, HEAD_REACH),
        _around("head_moi", "moment of the head", "moi", head.moi, HEAD_REACH),
    )

    def change(implement: Implement, numbers: Array) -> Implement:
        return implement.replaced(head=head.replaced(mass=float(numbers[0]), moi=float(numbers[1])))

    return ImplementSpace(club, variables, change)


WALLS = ("metal", "laminate")
"""Families of materials that walls are built of."""


def hollow_space(bat: Bat, *, material: Material | None = None) -> ImplementSpace:
    """Return the space of hollow bats like one: four thicknesses of the wall along the barrel, and the end cap.

    ``material``: of the wall; None: as it is. A laminate of plies keeps to its own.
    """
    shell, built = bat.shell, bat.material if material is None else material
    if shell is None:
        raise InputError(f"{bat.name} has no wall; give a hollow bat")
    if material is not None and (material.family not in WALLS or shell.laminate is not None):
        raise InputError(
            f"the wall of {bat.name} is not built of {material.name}; give a metal or a laminate of the catalogue, and "
            "a bat whose wall is not laid of single plies"
        )
    places = bat.length - np.array([11.0, 8.0, 5.0, 2.0]) / REFERENCE_LENGTH * bat.length
    now = shell.wall_at(places)
    variables = [
        Variable(
            f"wall_{index + 1}", "wall", "compression", 0.8 * thick, 1.3 * thick, thick, from_tip=bat.length - place
        )
        for index, (place, thick) in enumerate(zip(places.tolist(), now.tolist(), strict=True))
    ]
    cap = shell.end_cap_mass
    variables.append(Variable("end_cap_mass", "mass of the end cap", "mass", 0.3 * cap, max(2 * cap, 0.03), cap))

    def change(implement: Implement, numbers: Array) -> Implement:
        assert isinstance(implement, Bat) and implement.shell is not None
        inner = {place: thick for place, thick in implement.shell.wall if place < places[0] - 1e-9}
        wall = {
            **inner,
            **dict(zip(places.tolist(), numbers[:4].tolist(), strict=True)),
            implement.length: float(numbers[3]),
        }
        changed = implement.shell.replaced(wall=tuple(sorted(wall.items())), end_cap_mass=float(numbers[4]))
        return implement.replaced(
            shell=changed, drawn_shell=None, material=built, mass=None, balance_point=None, moi=None
        )

    return ImplementSpace(bat, tuple(variables), change)


def space_of(
    bat: Implement,
    *,
    deepest_cup: float,
    material: Material | None = None,
    ranges: Mapping[str, tuple[float, float]] | None = None,
) -> Space:
    """Return the design space of a present bat: outlines of wood, walls of a hollow one, a few numbers of others.

    ``deepest_cup``: m, of a turned bat; 0: no cup. ``material``: of a bat's wood or wall; None: the present one's.
    ``ranges``: least and most of what else may change of a turned bat, m; see `turned_space`.
    """
    if ranges and not (isinstance(bat, Bat) and bat.shell is None):
        raise InputError(
            f"{bat.name} is not turned from one piece of wood; its length, knob and cup stay: leave their ranges out"
        )
    if isinstance(bat, Bat):
        if bat.shell is not None:
            return hollow_space(bat, material=material)
        return turned_space(bat, deepest_cup=deepest_cup, wood=material, ranges=ranges)
    if material is not None:
        raise InputError(
            f"{bat.name} is no bat turned from one piece or with one wall, so that it cannot be of {material.name}; "
            "leave its material out"
        )
    if isinstance(bat, CricketBat):
        return cricket_space(bat)
    if isinstance(bat, Racket):
        return racket_space(bat)
    if isinstance(bat, GolfClub):
        return club_space(bat)
    raise InputError(
        f"{bat.name} has nothing here that could be changed; designed are bats, cricket bats, strung rackets and golf "
        "clubs"
    )

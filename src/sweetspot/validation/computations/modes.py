"""Frequencies and nodes of rods, catalogue bats and held bats; hoop modes and the trampoline of hollow bats."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import TYPICAL_HAND
from sweetspot.analysis.trampoline import WallPoint, wall_sweep
from sweetspot.dynamics.beam import beam_model, section
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import centre_of_percussion
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import Shell
from sweetspot.motion.swing import Hands
from sweetspot.units import INCH
from sweetspot.validation.computations import shared

THIN_LENGTH, THIN_DIAMETER = 1.3, 0.005
"""m; the longest and thinnest rod that a bat may be: radius of gyration over length is 1/1040."""


def thin_rod_root(*, mode: int) -> float:
    """Return beta L of a thin aluminium rod hung freely, beta^4 = omega^2 mu / (E I)."""
    modes, ratio = _thin_rod()
    return float((modes.angular_frequency[modes.of_family("bending")[mode - 1]] ** 2 * ratio) ** 0.25 * THIN_LENGTH)


def thin_rod_node(*, mode: int) -> float:
    """Return the outer node of a mode of that rod, distance from the end over length."""
    modes, _ = _thin_rod()
    return float(modes.nodes(modes.of_family("bending")[mode - 1])[0] / THIN_LENGTH)


@cache
def _thin_rod() -> tuple[Modes, float]:
    """Return the rod's modes and its mass per length over bending stiffness."""
    bat = Bat(
        name="thin rod",
        length=THIN_LENGTH,
        material=catalog.material("aluminium_7xxx"),
        profile=((0.0, THIN_DIAMETER), (THIN_LENGTH, THIN_DIAMETER)),
    )
    beam = beam_model(bat)
    at = section(beam, np.array([THIN_LENGTH / 2]))
    return bending_modes(beam, count=3), float(at.mass[0] / at.bending_stiffness[0])


def frequency(*, bat: str, mode: int) -> float:
    """Return the frequency of a free bending mode."""
    modes = shared.free_modes(bat)
    return float(modes.frequency[modes.of_family("bending")[mode - 1]])


def node_from_tip(*, bat: str, mode: int, node: int) -> float:
    """Return the distance of a node from the tip; ``node`` counts from the tip."""
    modes = shared.free_modes(bat)
    return float(shared.length(bat) - modes.nodes(modes.of_family("bending")[mode - 1])[-node])


def node_from_knob(*, bat: str, mode: int, node: int) -> float:
    """Return the distance of a node from the knob end; ``node`` counts from the knob."""
    modes = shared.free_modes(bat)
    return float(modes.nodes(modes.of_family("bending")[mode - 1])[node - 1])


def node_percussion_distance(*, bat: str, pivot: float) -> float:
    """Return the distance from the first mode's node to the center of percussion about ``pivot``, toward the tip."""
    percussion_from_tip = shared.length(bat) - centre_of_percussion(shared.body(bat), pivot=pivot)
    return node_from_tip(bat=bat, mode=1, node=1) - percussion_from_tip


def grip_frequency_change(*, bat: str) -> float:
    """Return the relative change of the first bending frequency in typical hands, 6 in from the knob end.

    Compares the held mode that correlates most with the free one.
    """
    free = shared.free_modes(bat)
    held = held_modes(free, Hands(position=6 * INCH, **TYPICAL_HAND))
    first = free.of_family("bending")[0]
    places = np.linspace(0, shared.length(bat), 200)
    correlation = np.corrcoef(free.shape_at(places)[:, first], held.shape_at(places), rowvar=False)[0, 1:]
    return float(held.frequency[np.abs(correlation).argmax()] / free.frequency[first] - 1)


TUBE_LENGTH = 0.84
WALLS = (1.6, 1.3, 1.0, 0.85)
"""Factors on a bat's own wall, from stiff to lively."""


def tube_hoop_frequency(*, diameter: float, wall: float, modulus: float, density: float, poisson_ratio: float) -> float:
    """Return the lowest hoop frequency of a long open tube."""
    metal = Material(
        name="tube", family="metal", density=density, longitudinal_modulus=modulus, poisson_ratio=poisson_ratio
    )
    ends = (0.0, TUBE_LENGTH)
    tube = Bat(
        name="tube",
        length=TUBE_LENGTH,
        material=metal,
        profile=tuple((end, diameter) for end in ends),
        shell=Shell(wall=tuple((end, wall) for end in ends)),
    )
    return hoop_frequency(beam_model(tube))


def metal_place(*, metal: str, wood: str) -> float:
    """Return the distance by which the metal bat's best place is farther from the tip."""
    places = [shared.length(bat) - shared.standard(bat).sweet_spots.max_exit_speed for bat in (metal, wood)]
    return places[0] - places[1]


def hoop_place(*, bat: str) -> float:
    """Return the distance from the greatest exit speed's place to the lowest hoop mode's maximum, towards the tip."""
    analysis = shared.standard(bat)
    lowest = analysis.modes.of_family("hoop")[0]
    places = analysis.scan.position
    swing = np.abs(analysis.modes.shape_at(places)[:, lowest])
    return float(places[int(np.argmax(swing))] - analysis.sweet_spots.max_exit_speed)


def bbcor_slope_with_hoop(*, bat: str) -> float:
    """Return the least rise of BBCOR per 100 Hz of lower hoop frequency when the wall is thinned step by step."""
    points = _walls(bat)
    slopes = [
        100 * (thin.bbcor - thick.bbcor) / (thick.hoop_frequency - thin.hoop_frequency)
        for thick, thin in pairwise(points)
    ]
    return min(slopes)


def restitution_of_share(*, bat: str, share: float) -> float:
    """Return the restitution of the wall that stores ``share`` of the ball's energy."""
    points = _walls(bat)
    return float(np.interp(share, [p.energy.share for p in points], [p.energy.restitution for p in points]))


@cache
def _walls(bat: str) -> list[WallPoint]:
    return wall_sweep(catalog.bat(bat), shared.standard(bat).conditions, factors=WALLS)

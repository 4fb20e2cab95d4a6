"""Barrels squeezed across a diameter: nested walls of plies as a designer lays them up, and plain tubes."""

from __future__ import annotations

from functools import cache

from sweetspot import catalog
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import squeezing_force
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.laminate import Laminate, Ply
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import Shell
from sweetspot.units import DEGREE
from sweetspot.validation.computations import shared

TUBE_LENGTH = 0.84

CARBON = Material(
    name="carbon, 150 g/m^2",
    family="laminate",
    density=1542.0,
    longitudinal_modulus=123.7e9,
    transverse_modulus=8.55e9,
    shear_modulus=3.04e9,
    poisson_ratio=0.27,
)
GLASS = Material(
    name="glass, 140 g/m^2",
    family="laminate",
    density=1978.0,
    longitudinal_modulus=44.0e9,
    transverse_modulus=13.2e9,
    shear_modulus=4.04e9,
    poisson_ratio=0.25,
)
PLIES = {"c": (CARBON, 0.1412e-3), "l": (CARBON, 0.0706e-3), "g": (GLASS, 0.0934e-3)}
"""By letter: carbon, light carbon, glass. Mixtures of the fibers and the resin in the designer's file, 59 % of fiber:
along the fibers by volume, across and in shear by Halpin and Tsai with 2 and 1 [jones1999]."""
WALLS = {
    "4": "c30 c30 c30 c30",
    "4L": "l30 c30 c30 c30",
    "4f": "c30 c45 c45 c30",
    "4z": "c30 c30 l0 c30 c30",
    "4gz": "c30 c30 g0 c30 c30",
    "5": "c30 c30 c30 c30 c30",
    "5L": "l30 c30 c30 c30 c30",
    "5f": "c30 c45 c30 c45 c30",
    "545i": "g30 c10 c0 c10 g30",
    "545o": "g30 c10 c0 c10 g45 g45",
}
"""The designer's walls: pairs of plies at plus and minus so many degrees, but for the middle ones of 4z and 4gz."""


def squeezed_barrel(*, walls: str, diameter: float) -> float:
    """Return the force that presses walls together, named from the outside in and free to slide on each other.

    Each takes its own force for the same approach; the next one fits into it.
    """
    force = 0.0
    for name in walls.split():
        laminate = _laid_up(name)
        force += _squeezed(CARBON, diameter, laminate.thickness, laminate)
        diameter -= 2 * laminate.thickness
    return force


def squeezed_tube(*, material: str, diameter: float, wall: float) -> float:
    """Return that force of a plain tube of a material of the catalogue."""
    return _squeezed(catalog.material(material), diameter, wall, None)


def squeezed_bat(*, bat: str) -> float:
    """Return that force of a hollow bat of the catalogue."""
    return squeezing_force(shared.beam(bat))


def barrels_in_order(*, barrels: list[str], diameter: float) -> float:
    """Return the rank correlation (Spearman) of the forces of barrels with a list from the stiffest to the softest."""
    from scipy.stats import spearmanr

    forces = [squeezed_barrel(walls=walls, diameter=diameter) for walls in barrels]
    return float(spearmanr(range(len(forces), 0, -1), forces).statistic)


def _laid_up(name: str) -> Laminate:
    plies = []
    for part in WALLS[name].split():
        (material, thickness), angle = PLIES[part[0]], float(part[1:]) * DEGREE
        turns = (angle, -angle) if angle or part[0] == "c" else (0.0,)
        plies += [Ply(material=material, angle=turn, thickness=thickness) for turn in turns]
    return Laminate(plies=tuple(plies))


@cache
def _squeezed(material: Material, diameter: float, wall: float, laminate: Laminate | None) -> float:
    ends = (0.0, TUBE_LENGTH)
    tube = Bat(
        name="tube",
        length=TUBE_LENGTH,
        material=material,
        profile=tuple((end, diameter) for end in ends),
        shell=Shell(wall=tuple((end, wall) for end in ends), laminate=laminate),
    )
    return squeezing_force(beam_model(tube))

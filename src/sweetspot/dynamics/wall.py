"""The wall of a hollow barrel as a thin shell: mass and stiffness per area at each place along the bat.

Coordinates are (axial, hoop, shear), z outwards. Two walls that are bonded act as one laminate through both; a
sleeve that is only pushed in, with or without a gap, shares the load with the outer wall but passes no shear to it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.dynamics.beam import BeamModel, bat_of_beam, density_scale
from sweetspot.equipment.laminate_theory import Plate, laminate_stiffness, sheet
from sweetspot.equipment.shell import WallPart
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array


@dataclass(frozen=True)
class WallSection:
    """A wall at an array of positions of shape S.

    Parameters
    ----------
    mass_per_area : kg/m^2 of the mean surface, shape S.
    mean_radius : m, middle of the wall; of two separate walls, the mean weighted with their thicknesses; shape S.
    thickness : m of material, gaps left out, shape S.
    stretching : A, N/m, shape S + (3, 3).
    coupling : B, N, shape S + (3, 3).
    bending : D, N m, shape S + (3, 3).
    """

    mass_per_area: Array
    mean_radius: Array
    thickness: Array
    stretching: Array
    coupling: Array
    bending: Array


def wall_stiffness(beam: BeamModel, position: Array) -> WallSection:
    """Return mass and stiffness of the wall of a hollow or drilled bat at positions in m.

    Mass per area times the circumference of the mean surface is the mass per length of the walls exactly. Where a
    drilled bat is solid the wall is as thick as the radius; what fills a hole is left out.

    Raises
    ------
    InputError
        when the bat is solid all over.
    """
    places = np.asarray(position, dtype=float)
    parts = _parts(beam, places)
    scale = density_scale(beam, places)
    thickness = sum((part.thickness for part in parts), np.zeros_like(places))
    middle = sum((part.thickness * part.middle for part in parts), np.zeros_like(places)) / thickness
    shell = bat_of_beam(beam).shell
    bonded = shell is not None and shell.bonded
    plate = _nothing(places)
    ring = np.zeros_like(places)  # mass per length over 2 pi
    for part in parts:
        own = _plate(part)
        plate = plate + (own.seen_from(part.middle - middle) if bonded else own)
        ring = ring + part.density * scale * part.thickness * part.middle
    return WallSection(ring / middle, middle, thickness, plate.stretching, plate.coupling, plate.bending)


def _parts(beam: BeamModel, position: Array) -> list[WallPart]:
    bat = bat_of_beam(beam)
    outer = bat.diameter_at(position) / 2
    if bat.shell is not None:
        return bat.shell.parts(position, outer, bat.material)
    if not bat.bores:
        raise InputError(f"{bat.name} is solid and has no wall; give a bat with a shell or a bore")
    void = np.zeros_like(position)
    for bore in bat.bores:
        hollow = (position > bat.length - bore.depth) & (position <= bat.length - bore.plug)
        void = np.where(hollow, np.maximum(void, bore.diameter / 2), void)
    return [WallPart(bat.material, None, outer, outer - void)]


def _plate(part: WallPart) -> Plate:
    if part.laminate is not None:
        return laminate_stiffness(part.laminate, part.thickness)
    return sheet(part.material, part.thickness)


def _nothing(position: Array) -> Plate:
    zero = np.zeros((*position.shape, 3, 3))
    return Plate(zero, zero, zero)

"""Hollow bats: the wall along the barrel, the end cap, and what the wall is built of."""

from __future__ import annotations

import numpy as np

from sweetspot.design.outline_curve import REFERENCE_LENGTH
from sweetspot.design.variables import ImplementSpace, Variable
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array

WALLS = ("metal", "laminate")
"""Families of materials that walls are built of."""


def hollow_space(bat: Bat, *, material: Material | None = None) -> ImplementSpace:
    """Return the space of hollow bats like one: four thicknesses of the wall along the barrel, and the end cap.

    Parameters
    ----------
    material : of the wall; None: as it is. A laminate of plies keeps to its own.

    Raises
    ------
    InputError
        when the bat has no wall, or nobody makes one of that material.
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
        Variable(f"wall_{index + 1}", "wall", "compression", 0.8 * thick, 1.3 * thick, thick,
                 from_tip=bat.length - place)
        for index, (place, thick) in enumerate(zip(places.tolist(), now.tolist(), strict=True))
    ]  # fmt: skip
    cap = shell.end_cap_mass
    variables.append(Variable("end_cap_mass", "mass of the end cap", "mass", 0.3 * cap, max(2 * cap, 0.03), cap))

    def change(implement: Implement, numbers: Array) -> Implement:
        assert isinstance(implement, Bat) and implement.shell is not None
        own = {place: thick for place, thick in implement.shell.wall if place < places[0] - 1e-9}
        wall = {
            **own,
            **dict(zip(places.tolist(), numbers[:4].tolist(), strict=True)),
            implement.length: float(numbers[3]),
        }
        changed = implement.shell.replaced(wall=tuple(sorted(wall.items())), end_cap_mass=float(numbers[4]))
        return implement.replaced(
            shell=changed, drawn_shell=None, material=built, mass=None, balance_point=None, moi=None
        )

    return ImplementSpace(bat, tuple(variables), change)

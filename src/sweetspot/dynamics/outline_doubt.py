"""How far a moment of inertia may be off that was not measured but follows from a bat's outline.

An outline fixes the volume, not how the density changes from handle to barrel, and it is itself read off or assumed.
How much that is was found on the measured bats of [russell2010swing] (wood: B1 and B2; B3 has an uncommon knob): their
moments predicted with the outlines of other ordinary wood bats at their own length and weight. `tests` do it again.
"""

from __future__ import annotations

from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement

OF_CENTRE = 0.14
"""Standard deviation of the moment about the balance point, as a part of it."""
OF_SWING = 0.06
"""Standard deviation of the moment about an axis in the handle where the balance point was not measured either."""


def moi_doubt(bat: Implement, body: RigidBody, axis: float) -> float:
    """Return one standard deviation in kg m^2 of the moment about an axis across the bat at ``axis`` m.

    Zero where a moment was measured, and for other implements, whose outlines were not compared with measured ones. A
    moment that was fitted to weight, balance or taps is known no better than by the outline. With a measured balance
    point only the moment about it is in doubt, I(axis) = I_cm + M (axis - balance)^2.
    """
    if not isinstance(bat, Bat) or is_swung(bat):
        return 0.0
    if is_balanced(bat) or axis == body.balance_point:
        return OF_CENTRE * body.moi_cm
    return OF_SWING * body.moi(axis)


def is_swung(bat: Bat) -> bool:
    """Return whether a bat's moment of inertia was measured, on it or on what it was before it was changed."""
    return any(one.moi is not None and "moi" not in one.fitted for one in bat.lineage())


def is_balanced(bat: Bat) -> bool:
    """Return whether a bat's balance point was measured, on it or on what it was before it was changed."""
    return any(one.balance_point is not None and "balance_point" not in one.fitted for one in bat.lineage())

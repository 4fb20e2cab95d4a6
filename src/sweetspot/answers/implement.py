"""What an implement weighs and how it balances."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.answers.records import Columns, Length, Mass, MomentOfInertia
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.uncertainty.drawn_hits import Draws


@dataclass(frozen=True)
class MassProperties:
    """Name, length and mass properties; positions and axes from the knob end.

    Parameters
    ----------
    moi_cm, moi_knob, moi_6in : about axes across it, through the balance point, the knob end and 6 in from that.
    roll_moi : about its own axis.
    """

    name: str
    length: Length
    mass: Mass
    balance_point: Length
    moi_cm: MomentOfInertia
    moi_knob: MomentOfInertia
    moi_6in: MomentOfInertia
    roll_moi: MomentOfInertia


def mass_properties(implement: Implement, body: RigidBody) -> MassProperties:
    """Return the mass, balance point and moments of inertia of an implement."""
    return MassProperties(
        name=implement.name,
        length=implement.length,
        mass=body.mass,
        balance_point=body.balance_point,
        moi_cm=body.moi_cm,
        moi_knob=body.moi(0.0),
        moi_6in=body.moi(STANDARD_AXIS),
        roll_moi=body.roll_moi,
    )


def mass_columns(draws: Draws) -> Columns:
    """Return the mass properties of every draw, by the fields of `MassProperties`; none where nothing is open."""
    body = draws.bats.bending
    if not isinstance(draws.beam.bat, Bat) and not draws.sources.unknowns:
        return {}
    return {
        "mass": body.mass,
        "balance_point": body.balance_point,
        "moi_cm": body.moi_cm,
        "moi_knob": body.moi(0.0),
        "moi_6in": body.moi(STANDARD_AXIS),
        "roll_moi": body.roll_moi,
    }

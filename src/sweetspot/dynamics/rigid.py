"""The bat as a rigid body: mass, balance point, moments of inertia, centre of percussion, hands.

Positions are metres from the knob end. ``axis`` and ``pivot`` are axes across the bat (the swing's axis).

A moment of inertia that was not measured follows from the bat's outline. An outline fixes the volume, not how the
density changes from handle to barrel, and it is itself read off or assumed. How much that is was found on the measured
bats of [russell2010swing] (wood: B1 and B2; B3 has an uncommon knob): their moments were predicted with the outlines of
other ordinary wood bats at their own length and weight. `tests` do it again. An outline that is the bat's own, by a
caliper, leaves only what its density does along it: drawn as four Legendre terms of 4 % each, together with diameters
off by 1 % at every inch, the moments of weighed ash and maple bats scatter by a sixth of that.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.dynamics.beam import BeamModel, moments_with_roll
from sweetspot.equipment.base import Real
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.plausibility import check_place


@dataclass(frozen=True)
class RigidBody:
    """Inertial properties of a rigid bat.

    Parameters
    ----------
    mass : kg.
    balance_point : m from the knob end.
    moi_cm : kg m^2 about an axis across the bat through its balance point.
    roll_moi : kg m^2 about the bat's own axis.
    """

    mass: float
    balance_point: float
    moi_cm: float
    roll_moi: float

    def moi(self, axis: float) -> float:
        """Return the moment of inertia in kg m^2 about an axis across the bat at ``axis`` m.

        I(axis) = I_cm + M (axis - balance)^2, the parallel-axis theorem.
        """
        return self.moi_cm + self.mass * (axis - self.balance_point) ** 2


def rigid_body(beam: BeamModel) -> RigidBody:
    """Return mass, balance point and moments of inertia of a bat by exact integration of its conical pieces.

    M = int mu dx, x_c = int mu x dx / M, I_cm = int (mu (x - x_c)^2 + rho I) dx, I_roll = int 2 rho I dx.

    Point masses count for mass, balance and I_cm, and for the roll with what they have of their own: that of a club's
    head, nothing of a small weight.

    Parameters
    ----------
    beam : from `beam_model`.

    >>> from sweetspot import beam_model, catalog, rigid_body
    >>> body = rigid_body(beam_model(catalog.bat("r161-ash")))
    >>> round(body.mass, 3), round(body.balance_point, 3), round(body.moi(0.1524), 3)  # kg, m, kg m^2 about 6 in
    (0.879, 0.56, 0.188)
    """
    mass, first, second, roll = moments_with_roll(beam)
    balance_point = first / mass
    return RigidBody(mass, balance_point, second - first * balance_point, roll)


def centre_of_percussion(body: RigidBody, *, pivot: float) -> float:
    """Return the center of percussion, where a blow leaves the pivot at rest, m from the knob end.

    x_cop = pivot + I_pivot / (M d), d from pivot to balance point; the rod of the paper: b = J_D / (m l)
    [paper2014, eq. 10-12; astm_f2398].

    Parameters
    ----------
    pivot : m from the knob end, on the handle side of the balance point.

    Raises
    ------
    InputError
        when the pivot is at or beyond the balance point, where no such place exists ahead of it.

    >>> rod = RigidBody(mass=1.0, balance_point=0.5, moi_cm=1 / 12, roll_moi=0.0)
    >>> round(centre_of_percussion(rod, pivot=0.0), 6)  # two thirds of a uniform rod
    0.666667
    """
    arm = body.balance_point - pivot
    if arm <= 0:
        raise InputError(
            f"pivot is {pivot:.4g} m from the knob end, not on the handle side of the balance point "
            f"at {body.balance_point:.4g} m; give a smaller one"
        )
    return pivot + body.moi(pivot) / (body.mass * arm)


def effective_mass(body: RigidBody, position: Real, *, pivot: float | None = None) -> Real:
    """Return the mass in kg that the ball meets at ``position``.

    Free bat: 1 / M_eff = 1 / M + b^2 / I_cm, b from the balance point [nathan2003].
    Turning about a fixed ``pivot``: M_eff = I_pivot / z^2, z from the pivot (infinite on the pivot itself).

    Parameters
    ----------
    position : m from the knob end, one or an array.
    pivot : m from the knob end of a fixed axis; None: the bat is free.

    >>> rod = RigidBody(mass=1.0, balance_point=0.5, moi_cm=1 / 12, roll_moi=0.0)
    >>> round(effective_mass(rod, 1.0), 6)  # a quarter of a free rod's mass at its end
    0.25
    """
    check_place(position, "position")
    if pivot is None:
        return 1 / (1 / body.mass + (position - body.balance_point) ** 2 / body.moi_cm)
    arm = position - pivot
    with np.errstate(divide="ignore"):
        turning: Real = np.divide(body.moi(pivot), arm**2)
    return turning


def hand_impulse_ratio(body: RigidBody, position: Real, *, hands: float) -> Real:
    """Return the impulse that the hands must give, as a part of the ball's blow at ``position``.

    S = 1 - M d z / I_hands with d from hands to balance point and z from hands to blow: what it takes to
    keep the hands' place from jumping. Positive: the hands push the way the bat was going, against the ball's
    push; zero at the centre of percussion about the hands [paper2014, eq. 9, with its misprint 1 + x read as
    l + x].

    >>> rod = RigidBody(mass=1.0, balance_point=0.5, moi_cm=1 / 12, roll_moi=0.0)
    >>> round(hand_impulse_ratio(rod, 2 / 3, hands=0.0), 12) + 0
    0.0
    """
    return 1 - body.mass * (body.balance_point - hands) * (position - hands) / body.moi(hands)


OF_CENTRE, OF_OWN_CENTRE = 0.14, 0.025
"""Standard deviation of the moment about the balance point, as a part of it: with an assumed outline, and with its own
(2.0 % by those draws, and an eighth of the 3 % that a knob drawn 5 mm too thin takes)."""
OF_SWING, OF_OWN_SWING = 0.06, 0.02
"""The same about an axis in the handle where the balance point was not measured either (1.5 % by those draws)."""


def outline_doubts(bat: Bat) -> tuple[float, float]:
    """Return the standard deviations of the moments about the balance point and an axis in the handle, as parts."""
    return (OF_CENTRE, OF_SWING) if bat.outline_assumed else (OF_OWN_CENTRE, OF_OWN_SWING)


def moi_doubt(bat: Implement, body: RigidBody, axis: float) -> float:
    """Return one standard deviation in kg m^2 of the moment about an axis across the bat at ``axis`` m.

    Zero where a moment was measured, and for other implements, whose outlines were not compared with measured ones. A
    moment that was fitted to weight, balance or taps is known no better than by the outline. With a measured balance
    point only the moment about it is in doubt, I(axis) = I_cm + M (axis - balance)^2.
    """
    if not isinstance(bat, Bat) or bat.is_measured("moi"):
        return 0.0
    of_centre, of_swing = outline_doubts(bat)
    if bat.is_measured("balance_point") or axis == body.balance_point:
        return of_centre * body.moi_cm
    return of_swing * body.moi(axis)

"""What is not known about a racket, cricket bat, club or stick before it is measured, and what follows from a guess.

It is known by what is measured on it: weight, balance point, radius of gyration about that point (from a swing weight
or a pendulum) and the frequency of its first bending mode, to which its stiffness is scaled. A golf club is weighed by
its parts: head and grip take the place of the first three.
"""

from __future__ import annotations

import math
from collections.abc import Mapping

from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.bending import bending_frequencies
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.hockey_stick import HockeyStick
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.racket import Racket
from sweetspot.errors import InputError

SPREADS = {"mass": 0.06, "balance_point": 0.04, "gyration": 0.06, "first_frequency": 0.2}
"""One sigma of the logarithms before anything is measured: implements of one kind differ so (assumed)."""
OF_CLUB = {"end_mass": 0.06, "knob_mass": 0.3, "first_frequency": 0.2}
"""The same of a golf club's head, grip and frequency (assumed)."""


def implement_spreads(implement: Implement) -> dict[str, float]:
    """Return what is not known about an implement that is no bat, and one sigma of the logarithm of each.

    Raises
    ------
    InputError
        for a kind that is known by its plies.
    """
    if not isinstance(implement, (Racket, CricketBat, HockeyStick, GolfClub)):
        raise InputError(
            f"{implement.name} is known by its plies and rubbers; calibrate knows bats, rackets, cricket bats, hockey "
            "sticks and golf clubs"
        )
    return dict(OF_CLUB if isinstance(implement, GolfClub) else SPREADS)


def as_described(implement: Implement) -> BeamModel:
    """Return an implement's beam with all that is measured on it written down, as far as the description says it."""
    beam = beam_model(implement.replaced(added=()))
    body = rigid_body(beam)
    known: dict[str, float] = {}
    if not isinstance(implement, Racket):
        known["first_frequency"] = float(bending_frequencies(beam, count=1)[0])
    if not isinstance(implement, (Racket, GolfClub)):
        known |= {
            "mass": body.mass, "balance_point": body.balance_point, "moi": body.moi(implement.moi_axis),
        }  # fmt: skip
    return beam_model(implement.replaced(calibrated=True, original=None, **known))


def implement_deviated(beam: BeamModel, deviations: Mapping[str, float]) -> BeamModel:
    """Return an implement's beam with these deviations of logarithms from what `as_described` returned."""
    factor = {name: math.exp(off) for name, off in deviations.items()}
    implement = beam.bat
    changes: dict[str, object] = {}
    frequency = implement.frequency
    assert frequency is not None  # written by as_described
    changes["first_frequency"] = frequency * factor.get("first_frequency", 1.0)
    if isinstance(implement, GolfClub):
        head = implement.head
        changes["head"] = head.replaced(mass=head.mass * factor.get("end_mass", 1.0))
        changes["grip_mass"] = implement.grip_mass * factor.get("knob_mass", 1.0)
        return beam_model(implement.replaced(**changes))
    mass, balance, moi, axis = implement.mass, implement.balance_point, implement.moi, implement.moi_axis
    assert mass is not None
    assert balance is not None
    assert moi is not None
    gyration = moi / mass - (balance - axis) ** 2
    new_mass, new_balance = mass * factor.get("mass", 1.0), balance * factor.get("balance_point", 1.0)
    new_gyration = gyration * factor.get("gyration", 1.0) ** 2
    changes |= {
        "mass": new_mass, "balance_point": new_balance, "moi": new_mass * (new_gyration + (new_balance - axis) ** 2),
    }  # fmt: skip
    return beam_model(implement.replaced(**changes))

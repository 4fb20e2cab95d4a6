"""What an implement is before anybody swings it: size, weight, and what its people compare it by."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from sweetspot.answers.conditions import MassProperties, mass_properties
from sweetspot.answers.handling import Handling, handling_of
from sweetspot.answers.paddle_numbers import PaddleFace, paddle_face
from sweetspot.answers.records import INLINE, INTERNAL, Force, Frequency, MomentOfInertia
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.clamped import clamped_frequency
from sweetspot.dynamics.hoop import squeezing_force
from sweetspot.dynamics.rigid import RigidBody, moi_doubt
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.racket import Racket
from sweetspot.numerics.constants import STANDARD_AXIS


@dataclass(frozen=True, kw_only=True)
class DoubtedMass(MassProperties):
    """Mass properties, with the standard deviations that an outline leaves to the moments of inertia."""

    moi_6in_doubt: MomentOfInertia
    moi_knob_doubt: Annotated[MomentOfInertia, INTERNAL]
    moi_cm_doubt: Annotated[MomentOfInertia, INTERNAL]


@dataclass(frozen=True)
class SwingWeightText:
    """How heavy the swing is by the sport's own measure; ``axis`` in m from the butt end."""

    name: str
    text: str
    axis: Annotated[float, INTERNAL]


@dataclass(frozen=True)
class Strings:
    """A racket's strings: how many, their tension in N, and the stiffness of the bed in its middle in N/m."""

    mains: int
    crosses: int
    tension: float
    stiffness: float


@dataclass(frozen=True, kw_only=True)
class Description:
    """Size, weight and handling of an implement.

    Parameters
    ----------
    sport, swing_weight : of what has a face.
    handling : how a racket handles; None for other implements.
    clamped_frequency : of a club whose grip is clamped; None for other implements.
    barrel_compression : load that brings two sides of a hollow barrel 0.050 in nearer; None for other implements.
    paddle : numbers of a paddle; None for other implements.
    strings : of a racket that has them.
    """

    bat: DoubtedMass
    sport: str | None = None
    swing_weight: SwingWeightText | None = None
    handling: Handling | None = None
    clamped_frequency: Frequency | None = None
    barrel_compression: Force | None = None
    paddle: Annotated[PaddleFace | None, INLINE] = None
    strings: Annotated[Strings | None, INTERNAL] = None


def described(beam: BeamModel, body: RigidBody) -> Description:
    """Return the size, weight and handling of an implement."""
    bat = beam.bat
    mass = DoubtedMass(
        **vars(mass_properties(bat, body)),
        moi_6in_doubt=moi_doubt(bat, body, STANDARD_AXIS),
        moi_knob_doubt=moi_doubt(bat, body, 0.0),
        moi_cm_doubt=moi_doubt(bat, body, body.balance_point),
    )
    if isinstance(bat, Bat):
        return Description(bat=mass, barrel_compression=None if bat.shell is None else squeezing_force(beam))
    convention = swing_weight(bat.sport)
    return Description(
        bat=mass,
        sport=bat.sport,
        swing_weight=SwingWeightText(convention.name, convention.text_of(body), convention.axis),
        handling=handling_of(bat, body),
        clamped_frequency=clamped_frequency(beam) if isinstance(bat, GolfClub) else None,
        paddle=paddle_face(bat, body),
        strings=_strings(bat) if isinstance(bat, Racket) else None,
    )


def _strings(racket: Racket) -> Strings | None:
    bed, stiffness = racket.bed, racket.face.stiffness
    return None if stiffness is None else Strings(bed.mains, bed.crosses, bed.tension, stiffness)

"""What people compare paddles by, beyond swing and twist weight: how stiff the face is, and its tone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from sweetspot.answers.certify_paddle import tested_as_by_the_rules
from sweetspot.answers.records import Force, Frequency, Mass, MomentOfInertia, Ratio
from sweetspot.catalog.balls import ball
from sweetspot.catalog.rules import league
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.paddle_modes import DEFLECTED, face_stiffness, face_tone
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.interval import Number
from sweetspot.units.dimensions import STIFFNESS


@dataclass(frozen=True)
class PaddleFace:
    """Numbers of a paddle; see `face_stiffness` and `face_tone`.

    Parameters
    ----------
    swing_weight, twist_weight : about the sport's axis, and about the long axis.
    face_stiffness : of a small tip in the middle of the face, its rim held; ``deflection_force``: for 1/16 in.
    face_tone : the tone of the face that people hear.
    rim_mass, handle_mass : that the measured mass and swing weight leave beside the plate.
    pbcor, pbcor_limit : greatest restitution in the test of the sport's rules, and what they allow; None: they limit
        none.
    """

    swing_weight: MomentOfInertia
    twist_weight: MomentOfInertia
    face_stiffness: Annotated[Number, STIFFNESS]
    deflection_force: Force
    face_tone: Frequency
    rim_mass: Mass
    handle_mass: Mass
    pbcor: Ratio | None = None
    pbcor_limit: Ratio | None = None


def paddle_face(implement: Implement, body: RigidBody) -> PaddleFace | None:
    """Return the numbers of a paddle; None for other implements."""
    if not isinstance(implement, Paddle):
        return None
    stiffness, limit, pbcor = face_stiffness(implement), None, None
    rules = sport(implement.sport).rules
    if rules:
        limited = league(rules)
        limit = next((rule.most for rule in limited.rules if rule.quantity == "pbcor"), None)
        pbcor = None if limit is None else tested_as_by_the_rules(implement, ball(limited.ball)).best_pbcor
    return PaddleFace(
        swing_weight=body.moi(swing_weight(implement.sport).axis),
        twist_weight=body.roll_moi,
        face_stiffness=stiffness,
        deflection_force=stiffness * DEFLECTED,
        face_tone=face_tone(implement),
        rim_mass=implement.rim_mass,
        handle_mass=implement.handle_mass,
        pbcor=pbcor,
        pbcor_limit=limit,
    )

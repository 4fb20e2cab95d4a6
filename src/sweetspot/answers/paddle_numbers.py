"""What people compare paddles by, beyond swing and twist weight: how stiff the face is, and its tone."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from sweetspot.analysis.certification.simulated_paddle_test import PaddleTest
from sweetspot.answers.certify_paddle import restitution_interval, tested_as_by_the_rules
from sweetspot.answers.records import Force, Frequency, Mass, MomentOfInertia, Ratio
from sweetspot.calibration.unknowns import as_described, deviated
from sweetspot.catalog.balls import ball
from sweetspot.catalog.rules import league
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.paddle_modes import DEFLECTED, face_stiffness, face_tone
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH, Interval, Number
from sweetspot.uncertainty.implement_doubt import ImplementDoubt
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
    stiffness, (limit, test) = face_stiffness(implement), _tested(implement)
    return PaddleFace(
        swing_weight=body.moi(swing_weight(implement.sport).axis),
        twist_weight=body.roll_moi,
        face_stiffness=stiffness,
        deflection_force=stiffness * DEFLECTED,
        face_tone=face_tone(implement),
        rim_mass=implement.rim_mass,
        handle_mass=implement.handle_mass,
        pbcor=None if test is None else test.best_pbcor,
        pbcor_limit=limit,
    )


def _tested(paddle: Paddle) -> tuple[float | None, PaddleTest | None]:
    """Return the limit of the sport's rules on the restitution, and their test; None where they limit none."""
    rules = sport(paddle.sport).rules
    limited = league(rules) if rules else None
    limit = next((rule.most for rule in limited.rules if rule.quantity == "pbcor"), None) if limited else None
    return limit, tested_as_by_the_rules(paddle, ball(limited.ball)) if limited and limit is not None else None


def paddle_in_doubt(implement: Implement, body: RigidBody, doubt: ImplementDoubt | None) -> PaddleFace | None:
    """Return the numbers of a paddle with the intervals that are known; None for other implements.

    ``doubt``: what is not known of it, for its swing weight and twist weight; None: nothing. The restitution's interval
    is that of `certify`: what ball and core leave open.
    """
    face = paddle_face(implement, body)
    if face is None or not isinstance(implement, Paddle):
        return None
    _, test = _tested(implement)
    face = face if test is None else replace(face, pbcor=restitution_interval(test))
    if doubt is None or not doubt.unknowns:
        return face
    beam, axis = as_described(implement), swing_weight(implement.sport).axis
    sizes = np.sqrt(np.diag(doubt.covariance))

    def turning(deviations: Array) -> Array:
        moved = rigid_body(deviated(beam, doubt.unknowns, deviations))
        return np.array([moved.moi(axis), moved.roll_moi])

    slopes = np.array([(turning(step) - turning(-step)) / 2 for step in np.diag(sizes)]) / sizes[:, None]
    halves = REACH * np.sqrt(np.einsum("ui,uv,vi->i", slopes, doubt.covariance, slopes))
    about_axis, about_line = (
        Interval(value, value - half, value + half)
        for value, half in zip((float(face.swing_weight), float(face.twist_weight)), halves.tolist(), strict=True)
    )
    return replace(face, swing_weight=about_axis, twist_weight=about_line)

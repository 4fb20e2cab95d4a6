"""The tests of a golf club's face: a ball fired at the bare head, and the steel pendulum that took its place.

Until 2004 a head without shaft was shot at with a ball of 100 mph, and its restitution e follows from the rebound as
of any free body [dlancegolf]. Since then a small steel mass on a pendulum taps the face and its time of contact is
read, brought to the limit of a stiff contact, which leaves the face's own spring [usga_ct]: see `PENDULUM`.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.collision.closed_form import restitution_from_efficiency
from sweetspot.collision.coupled import hit
from sweetspot.dynamics.face_vibration import FAMILIES, face_motion
from sweetspot.dynamics.modes import Modes
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.golf_club import ClubHead
from sweetspot.numerics.piecewise import Piecewise
from sweetspot.units import MPH

TEST_SPEED = 100 * MPH
"""m/s, of the ball fired at a bare head [dlancegolf]."""


def bare_head_modes(head: ClubHead, ball: Ball) -> Modes:
    """Return the motions of a free head under a ball in the middle of its face: as one body, and its face.

    Parameters
    ----------
    ball : whose mass turns the face's restitution into a damper.
    """
    face, motions = head.face, face_motion(head.face, ball)
    shapes = [1 / math.sqrt(mass) for mass in (head.mass, face.moving_mass) if mass is not None]
    count = 1 + len(motions)
    return Modes(
        families=FAMILIES[:count],
        harmonics=(0, 1)[:count],
        frequency=np.array([0.0, *(frequency for frequency, _ in motions)]),
        damping_rate=np.array([0.0, *(rate for _, rate in motions)]),
        shapes=Piecewise(np.array([[shapes]]), np.array([0.0, head.height])),
        rigid_part=np.eye(2, count),
        dashpots=np.zeros((0, count)),
    )


def head_restitution(head: ClubHead, ball: Ball, *, speed: float = TEST_SPEED) -> float:
    """Return the restitution of a ball fired at the middle of a bare head's face at ``speed`` in m/s.

    >>> from sweetspot import catalog
    >>> round(head_restitution(catalog.implement("golf-driver").head, catalog.ball("golf")), 2)
    0.82
    """
    modes = bare_head_modes(head, ball)
    efficiency = hit(modes, ball=ball, position=head.height / 2, closing_speed=speed).collision_efficiency
    return float(restitution_from_efficiency(efficiency, recoil=ball.mass / head.mass))

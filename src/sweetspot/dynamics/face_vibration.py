"""Motions that depend on the place across the face: its own give under the ball, and the roll of the whole implement.

A hit beside the line turns the implement about its long axis: a third rigid motion with the shape y / sqrt(I_roll).
Strings, rubber or a club's thin plate are one more mode that moves under the ball only. It is normalised by the mass
that moves with the ball there, so that a slow push finds the face's stiffness, sum s^2 / omega^2 = g^2 / k, where g
says how much less the face gives beside its middle.
"""

from __future__ import annotations

import math

import numpy as np

from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.modes import Family, Modes, Surface
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.face import MEMBRANE_MEAN, Face, FaceOutline, damping_coefficient
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.piecewise import Piecewise

FAMILIES: tuple[Family, ...] = ("rigid", "face")
"""Of a rigid motion and the face's own, where it deflects."""


def face_modes(beam: BeamModel, ball: Ball) -> Modes:
    """Return the roll of an implement with a face and, where the face deflects, its mode under the ball.

    Parameters
    ----------
    ball : whose mass turns the face's restitution into a damper (`damping_coefficient`).

    Returns
    -------
    Modes
        "rigid" roll, then perhaps "face"; their shapes are zero along the line and depend on the lateral place only.
    """
    face, outline = beam.bat.face, beam.bat.outline
    if face is None or outline is None:
        raise InputError(f"{beam.bat.name} has no face; give one that has, or take its bending modes alone")
    roll_moi = rigid_body(beam).roll_moi
    motions = face_motion(face, ball)
    count = 1 + len(motions)

    def basis(position: Array, lateral: Array, closing_speed: Array | float | None) -> Array:  # noqa: ARG001 - its patch is given
        here = outline.holds(position, lateral)
        shapes = [np.where(here, lateral, 0.0) / math.sqrt(roll_moi)]
        if face.moving_mass is not None:
            shapes.append(softness(face, outline, position, lateral) / math.sqrt(face.moving_mass))
        return np.stack(shapes, axis=-1)

    rigid_part = np.zeros((3, count))
    rigid_part[2, 0] = 1.0
    return Modes(
        families=FAMILIES[:count],
        harmonics=(0, 1)[:count],
        frequency=np.array([0.0, *(frequency for frequency, _ in motions)]),
        damping_rate=np.array([0.0, *(rate for _, rate in motions)]),
        shapes=Piecewise(np.zeros((1, 1, count)), np.array([0.0, beam.bat.length])),
        rigid_part=rigid_part,
        dashpots=np.zeros((0, count)),
        surface=Surface(basis, np.eye(count)),
    )


def face_motion(face: Face, ball: Ball) -> tuple[tuple[float, float], ...]:
    """Return frequency in Hz and damping rate in 1/s of the face's mode under a ball; nothing for a rigid face."""
    if face.stiffness is None or face.moving_mass is None:
        return ()
    lost = damping_coefficient(face.restitution, stiffness=face.stiffness, mass=ball.mass)
    return ((math.sqrt(face.stiffness / face.moving_mass) / (2 * math.pi), lost / face.moving_mass),)


def softness(face: Face, outline: FaceOutline, position: Array, lateral: Array) -> Array:
    """Return g, the square root of the face's compliance at places over that in its middle; 0 off the face.

    For a membrane g^2 = (ln((1 - r^2) R / a) + 1/4) / (ln(R / a) + 1/4): round, stretched, of the same area (radius R),
    pushed evenly over a patch of radius a at distance r R from its middle (image charge). For a plate clamped at its
    round edge g^2 = (1 - r^2)^2, for a layer g = 1.
    """
    square = outline.radius_squared(position, lateral)
    inside = np.maximum(1 - square, 0.0)
    if face.edge == "layer":
        return np.where(square <= 1 + 1e-12, 1.0, 0.0)
    if face.edge == "plate":
        return inside
    ratio = outline.mean_radius / face.patch
    with np.errstate(divide="ignore"):
        soft = (np.log(inside * ratio) + MEMBRANE_MEAN) / (math.log(ratio) + MEMBRANE_MEAN)
    return np.sqrt(np.maximum(soft, 0.0))

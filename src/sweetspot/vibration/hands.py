"""What hands on the handle do to the bat's motions."""

from __future__ import annotations

import numpy as np
import scipy.linalg
from scipy.interpolate import PPoly

from sweetspot.bat import Bat, check_position
from sweetspot.swing import Hands
from sweetspot.vibration.modes import Modes


def gripped(modes: Modes, hands: Hands) -> Modes:
    """Return the motions of the bat held by two hands, each a mass, a spring to rest and a damper.

    In the space of the free motions, M = 1 + m s s^T, K = diag(omega^2) + k s s^T, C = diag(rate) + c s s^T with
    s the shapes at a hand, summed over both hands; the undamped problem K v = omega^2 M v is solved exactly and
    only the diagonal of V^T C V is kept, which neglects the coupling of modes through the dampers.

    The hands move with the undisturbed swing, so springs and dampers act on the disturbance by the ball only.
    """
    inertia = np.eye(len(modes))
    stiffness = np.diag(modes.angular_frequency**2)
    damping = np.diag(modes.damping_rate)
    for place in hands.places:
        shape = modes.shape_at(place)
        inertia += hands.mass * np.outer(shape, shape)
        stiffness += hands.stiffness * np.outer(shape, shape)
        damping += hands.damping * np.outer(shape, shape)
    squares, vectors = scipy.linalg.eigh(stiffness, inertia)
    frequency = np.sqrt(np.maximum(squares, 0.0)) / (2 * np.pi)
    rate = np.einsum("ij,ik,kj->j", vectors, damping, vectors)
    shapes = PPoly.construct_fast(modes.shapes.c @ vectors, modes.shapes.x)
    return Modes(modes.families, modes.harmonics, frequency, rate, shapes, rigid_part=modes.rigid_part @ vectors)


def check_hands(bat: Bat, hands: Hands) -> None:
    """Refuse hands that are not on the handle side of the bat."""
    check_position(bat, hands.position, "hand position")

"""A ball that meets a face beside its line: it turns the face while it is on it, and leaves at an angle."""

from __future__ import annotations

import math

import numpy as np

from sweetspot.collision.impact import Impact
from sweetspot.collision.oblique_contact import SPHERE, TANGENTIAL_RESTITUTION
from sweetspot.equipment.face import Face
from sweetspot.numerics.arrays import Array


def mean_tilt(impact: Impact, *, roll_moi: float) -> float:
    """Return the angle in rad by which a rigid face has turned about its line, averaged with the force of the hit.

    phi'' = F y / I from rest; the mean is int F phi dt / int F dt. Beside the line at y > 0 it is above zero.

    Parameters
    ----------
    roll_moi : I, kg m^2 about the line ("twist weight"), > 0.
    """
    turned = impact.lateral / roll_moi * _running(_running(impact.force, impact.times), impact.times)
    return float(np.trapezoid(impact.force * turned, impact.times) / np.trapezoid(impact.force, impact.times))


def _running(values: Array, times: Array) -> Array:
    """Return the integral up to every time, by trapezia."""
    return np.concatenate([[0.0], np.cumsum(np.diff(times) * (values[1:] + values[:-1]) / 2)])


def aside_angle(impact: Impact, *, roll_moi: float, face: Face, leaves_at: float) -> float:
    """Return the angle in rad by which a ball leaves to the side on which it met the face.

    The hit is one on a face at rest that is tilted by the mean angle phi of `mean_tilt`: along its normal the ball
    leaves with q v, and along it with v phi less what friction takes in one gripping touch of a uniform ball,
    (1 + e_x) (2/7) v phi. Together v_side = phi v (q + 1 - (2/7) (1 + e_x)), and the angle is atan(v_side / v_f).

    Parameters
    ----------
    roll_moi : kg m^2, about the line.
    face : whose tangential restitution counts.
    leaves_at : m/s, v_f, exit speed along the path of the face.

    Assumptions: the frame does not twist in itself, and the ball does not spin; small angles.
    """
    returned = face.tangential_restitution
    grip = SPHERE / (1 + SPHERE) * (1 + (TANGENTIAL_RESTITUTION if returned is None else returned))
    tilt = mean_tilt(impact, roll_moi=roll_moi)
    return math.atan2(tilt * impact.closing_speed * (impact.collision_efficiency + 1 - grip), leaves_at)

"""The face: a striking surface that deflects by itself, such as strings, rubber or a thin plate of metal."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray
from pydantic import Field, model_validator

from sweetspot.equipment.base import Fraction, NonNegative, Positive, Validated
from sweetspot.numerics.arrays import Array

MEMBRANE_MEAN = 0.25
"""Added to ln(R / a): mean give of a stretched membrane of radius R under an even pressure on a patch of radius a."""


class Face(Validated):
    """One spring and damper under the ball.

    Raises `InputError` when only one of ``stiffness`` and ``moving_mass`` is given.

    Parameters
    ----------
    stiffness : N/m that the ball feels in the middle of the face, > 0; None: a rigid face.
    moving_mass : kg that moves with the ball there, small against the ball; None with a rigid face.
    restitution : part of its speed that a hard ball without losses keeps on this face held fast, (0, 1].
    edge : how the give falls off towards the edge: "membrane" (as a stretched one, from ``patch``), "plate" (as a
        clamped one, (1 - r^2)^2), or "layer" (it does not).
    patch : m, radius of the ball's contact, for a membrane.
    friction : coefficient of sliding friction under the ball; None: that of the bat.
    tangential_restitution : e_x of the ball on this face; 0 is rolling, -1 no friction; None: that on a bat.
    """

    stiffness: Positive | None = None
    moving_mass: Positive | None = None
    restitution: Annotated[float, Field(gt=0, le=1)] = 1.0
    edge: Literal["membrane", "plate", "layer"] = "layer"
    patch: Positive = 0.02
    friction: NonNegative | None = None
    tangential_restitution: Annotated[float, Field(ge=-1, le=1)] | None = None

    @model_validator(mode="after")
    def _gives_way_or_not(self) -> Face:
        if (self.stiffness is None) != (self.moving_mass is None):
            raise ValueError("give both stiffness and moving_mass, or neither for a rigid face")
        return self


class FaceOutline(Validated):
    """The hitting area of an implement, as seen from the ball.

    Parameters
    ----------
    start, end : m from the butt end.
    width : m, its greatest width across the line.
    shape : "oval" (an ellipse) or "oblong" (the same width all along).
    """

    start: NonNegative
    end: Positive
    width: Positive
    shape: Literal["oval", "oblong"] = "oval"

    @model_validator(mode="after")
    def _has_a_length(self) -> FaceOutline:
        if self.end <= self.start:
            raise ValueError(f"the face runs from {self.start:.4g} m to {self.end:.4g} m; allowed is an end beyond it")
        return self

    @property
    def middle(self) -> float:
        """Position of the middle of the face in m from the butt end."""
        return (self.start + self.end) / 2

    @property
    def mean_radius(self) -> float:
        """Radius in m of a round face of the same area."""
        area = (self.end - self.start) * self.width
        return math.sqrt(area / 4 if self.shape == "oval" else area / math.pi)

    def radius_squared(self, position: ArrayLike, lateral: ArrayLike) -> Array:
        """Return r^2 of places on the face: 0 in its middle, 1 on its edge.

        An oval has r^2 = u^2 + v^2 and an oblong the larger of u^2 and v^2, u and v the distances from the middle along
        and across over half of length and width.

        Parameters
        ----------
        position, lateral : m from the butt end and across from the line, of shape (...).
        """
        along = ((np.asarray(position, float) - self.middle) / ((self.end - self.start) / 2)) ** 2
        across = (np.asarray(lateral, float) / (self.width / 2)) ** 2
        return np.asarray(along + across if self.shape == "oval" else np.maximum(along, across))

    def holds(self, position: ArrayLike, lateral: ArrayLike) -> NDArray[np.bool_]:
        """Return whether places lie on the face, shape (...)."""
        return np.asarray(self.radius_squared(position, lateral) <= 1 + 1e-12)


def damping_coefficient(restitution: Fraction, *, stiffness: float, mass: float) -> float:
    """Return c in N s/m of the damper beside a spring, so that a hard ball keeps ``restitution`` of its speed.

    Spring and damper without mass let a ball go when k u + c u' = 0, never pulling it back; with
    z = c / (2 sqrt(k m)), e = exp(-z (pi - atan(2 z r / (1 - 2 z^2))) / r), r = sqrt(1 - z^2), below z = 1/sqrt(2).

    Parameters
    ----------
    stiffness, mass : k in N/m and the ball's m in kg.

    >>> damping_coefficient(1.0, stiffness=1.0, mass=1.0)
    0.0
    """
    from scipy.optimize import brentq

    if restitution >= 1:
        return 0.0

    def excess(ratio: float) -> float:
        root = math.sqrt(1 - ratio**2)
        turn = math.pi - math.atan2(2 * ratio * root, 1 - 2 * ratio**2)
        return math.exp(-ratio * turn / root) - restitution

    return 2 * float(brentq(excess, 0.0, 0.999, xtol=1e-15)) * math.sqrt(stiffness * mass)

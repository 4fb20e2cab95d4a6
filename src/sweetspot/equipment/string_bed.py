"""A bed of crossed strings: stiffness and moving mass under the ball, from tension, number and size."""

from __future__ import annotations

import math
from typing import Annotated

from pydantic import Field

from sweetspot.equipment.base import Positive, Validated
from sweetspot.equipment.face import MEMBRANE_MEAN, Face, FaceOutline

MEAN_CHORD = math.pi / 4
"""Mean length of an ellipse's chords over its axis."""


class StringBed(Validated):
    """Strings of a racket.

    Parameters
    ----------
    tension : N in each string as it is now, the mean of mains and crosses.
    mains, crosses : number of strings along and across the racket.
    linear_density : kg/m of one string.
    restitution : part of its speed that a hard ball without losses keeps on the bed of a clamped head.
    patch : m, radius of the round patch through which the ball pushes.
    """

    tension: Positive
    mains: Annotated[int, Field(ge=4, le=60)]
    crosses: Annotated[int, Field(ge=4, le=60)]
    linear_density: Positive
    restitution: Annotated[float, Field(gt=0, le=1)]
    patch: Positive

    def surface_tension(self, outline: FaceOutline) -> float:
        """Return the force per length in N/m of a membrane like the bed: the mean of both directions.

        sqrt((T n_m / w) (T n_c / l)) with n_m mains over the width w and n_c crosses over the length l.
        """
        along, across = self.mains / outline.width, self.crosses / (outline.end - outline.start)
        return self.tension * math.sqrt(along * across)

    def mass(self, outline: FaceOutline) -> float:
        """Return the mass of the bed in kg: every chord of the oval."""
        length = self.mains * (outline.end - outline.start) + self.crosses * outline.width
        return self.linear_density * MEAN_CHORD * length

    def face(self, outline: FaceOutline) -> Face:
        """Return the bed as a face: a stretched membrane of radius R, pushed evenly over a patch of radius a.

        k = 2 pi tau / (ln(R / a) + 1/4), exact for a round membrane with a small patch in its middle; the mass that
        moves with the patch is m_strings / (2 (ln(R / a) + 1/4)^2), from the membrane's slow deflection. Stretching of
        the strings is left out: it stiffens the bed under hard hits.
        """
        softness = math.log(outline.mean_radius / self.patch) + MEMBRANE_MEAN
        return Face(
            stiffness=2 * math.pi * self.surface_tension(outline) / softness,
            moving_mass=self.mass(outline) / (2 * softness**2),
            restitution=self.restitution,
            edge="membrane",
            patch=self.patch,
        )

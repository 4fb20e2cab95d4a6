"""Rubbers of a table-tennis racket: sponge and sheet as one lossy layer under the ball."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from sweetspot.face import Face
from sweetspot.thing import NonNegative, Positive, Thing


class Rubber(Thing):
    """One covering of a blade, sponge and sheet together.

    Parameters
    ----------
    name : what people call its kind.
    thickness : m, with the glue; the rules allow 4.0 mm, 2.0 mm without sponge.
    areal_density : kg/m^2.
    stiffness : N/m under the ball, sponge and sheet pressed in together.
    moving_mass : kg that moves with the ball there.
    restitution : part of its speed that a hard ball without losses keeps on the rubber glued to something rigid.
    friction, tangential_restitution : of the ball on it; what makes spin.
    """

    name: str
    thickness: Annotated[float, Field(gt=0, le=0.006)]
    areal_density: Positive
    stiffness: Positive
    moving_mass: Positive
    restitution: Annotated[float, Field(gt=0, le=1)]
    friction: NonNegative
    tangential_restitution: Annotated[float, Field(ge=-1, le=1)]

    @property
    def face(self) -> Face:
        """The rubber as a face that gives the same everywhere."""
        return Face(
            stiffness=self.stiffness,
            moving_mass=self.moving_mass,
            restitution=self.restitution,
            edge="layer",
            friction=self.friction,
            tangential_restitution=self.tangential_restitution,
        )

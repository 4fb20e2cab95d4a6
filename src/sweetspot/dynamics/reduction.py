"""A bat reduced to what a collision needs of it: line, rigid body and modes, worked out once for every swing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Generic

from typing_extensions import TypeVar

from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.mode_assembly import all_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.motion.swing import Hands

Tool_co = TypeVar("Tool_co", bound=Implement, covariant=True, default=Bat)
"""What was analysed: a bat unless said otherwise."""
Given = TypeVar("Given", bound=Implement)


@dataclass(frozen=True)
class ReducedBat(Generic[Tool_co]):
    """A bat with everything that a collision needs of it, whatever the swing; worked out once, used by many.

    Parameters
    ----------
    modes : of the free bat, until hands hold it.
    """

    bat: Tool_co
    beam: BeamModel
    body: RigidBody
    modes: Modes

    def held(self, hands: Hands) -> ReducedBat[Tool_co]:
        """Return the same bat in these hands; without mass they leave it free."""
        return replace(self, modes=held_modes(self.modes, hands))


def reduced_bat(bat: Given, *, ball: Ball) -> ReducedBat[Given]:
    """Return a bat with its beam, its rigid body and its modes under the patch that this ball presses."""
    beam = beam_model(bat)
    return ReducedBat(bat, beam, rigid_body(beam), all_modes(beam, ball))

"""A bat reduced to what a collision needs of it: line, rigid body and modes, worked out once for every swing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Generic

from typing_extensions import TypeVar

from sweetspot.ball import Ball
from sweetspot.bat import Bat
from sweetspot.implement import Implement
from sweetspot.line import Line, reduce
from sweetspot.rigid import RigidBody, rigid_body
from sweetspot.swing import Hands
from sweetspot.vibration.hands import gripped
from sweetspot.vibration.modes import Modes
from sweetspot.vibration.whole import modes_of

Tool_co = TypeVar("Tool_co", bound=Implement, covariant=True, default=Bat)
"""What was analysed: a bat unless said otherwise."""
Given = TypeVar("Given", bound=Implement)


@dataclass(frozen=True)
class Reduction(Generic[Tool_co]):
    """A bat with everything that a collision needs of it, whatever the swing; worked out once, used by many.

    Parameters
    ----------
    modes : of the free bat, until hands hold it.
    """

    bat: Tool_co
    line: Line
    body: RigidBody
    modes: Modes

    def held(self, hands: Hands) -> Reduction[Tool_co]:
        """Return the same bat in these hands; without mass they leave it free."""
        return replace(self, modes=gripped(self.modes, hands))


def reduction(bat: Given, *, ball: Ball) -> Reduction[Given]:
    """Return a bat with its beam, its rigid body and its modes under the patch that this ball presses."""
    line = reduce(bat)
    return Reduction(bat, line, rigid_body(line), modes_of(line, ball))

"""A bat reduced to what a collision needs of it: line, rigid body and modes, worked out once for every swing."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Generic

import numpy as np
from typing_extensions import TypeVar

from sweetspot.dynamics.batch.beams import BeamRow
from sweetspot.dynamics.batch.bending import bending_batch, frequencies_of
from sweetspot.dynamics.batch.mesh import MODES
from sweetspot.dynamics.batch.reduction import reduced_beams
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.hands import held_modes
from sweetspot.dynamics.modes import Modes
from sweetspot.dynamics.paddle_modes import plate_modes
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.motion.swing import Hands
from sweetspot.numerics.arrays import Array


def bending_modes(beam: BeamModel, *, count: int = MODES, elements: int | None = None) -> Modes:
    """Return the two rigid motions and the lowest ``count`` bending modes of a freely hung bat.

    Parameters
    ----------
    beam : the bat reduced to a beam.
    count : number of bending modes, >= 1.
    elements : number of finite elements at least, None: `least_elements`; more are used where the bat has more
        breakpoints.

    Returns
    -------
    Modes
        translation, rotation, then bending modes 1 to ``count``; mass-normalised shapes, positive at the tip.

    Notes
    -----
    Where the implement has a measured `frequency`, all its stiffness is scaled so that mode 1 has it.
    Damping is the material's free-free ratio, the same for every mode. Holds for transverse waves longer than
    the barrel is thick, that is up to about 10 kHz for a wood bat.

    >>> from sweetspot import beam_model, bending_modes, catalog
    >>> modes = bending_modes(beam_model(catalog.bat("r161-ash")), count=3)
    >>> modes.frequency.round(), modes.nodes(2).round(2)  # Hz; m from the knob end where mode 1 stands still
    (array([   0.,    0.,  172.,  572., 1118.]), array([0.17, 0.67]))
    """
    return bending_batch(BeamRow([beam]), count=count, elements=elements).modes(0)


def bending_frequencies(beam: BeamModel, *, count: int, elements: int | None = None) -> Array:
    """Return the frequencies in Hz of the lowest ``count`` bending modes alone; see `bending_modes`."""
    return np.asarray(frequencies_of(BeamRow([beam]), count=count, elements=elements)[0])


def all_modes(beam: BeamModel, ball: Ball, *, patch_factor: float = 1.0, count: int | None = None) -> Modes:
    """Return rigid motions and bending modes of a bat, and what its striking face or hollow barrel adds.

    A face adds roll and its own mode, damped as it damps this ball; a hollow barrel its hoop modes, which are felt
    through the ball's contact patch. A paddle is a plate, whose motions are its own (`plate_modes`). A
    solid or drilled wood barrel has none that a ball could excite: it is dented, without delay.

    Parameters
    ----------
    beam : from `beam_model`.
    ball : that will hit the bat: hoop modes are felt through its patch, a face is damped by it.
    patch_factor : on the radius of the ball's contact patch, > 0; 1 unless its doubt is asked for (`PATCH_SPREAD`).
    count : of the bending modes; None: a dozen, and beside a face as many dozens as a contact excites.

    >>> from sweetspot import all_modes, beam_model, catalog
    >>> modes = all_modes(beam_model(catalog.bat("r161-ash")), catalog.ball())
    >>> modes, modes.frequency[2:4].round()  # Hz, of the first two bending modes
    (<Modes: 2 rigid, 12 bending>, array([172., 572.]))
    """
    if isinstance(beam.bat, Paddle):
        return plate_modes(beam, patch_factor=patch_factor)
    return reduced_beams([beam], ball=ball, patch_factor=patch_factor, count=count).modes(0)


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

    @classmethod
    def of_beam(cls, beam: BeamModel, ball: Ball, *, patch_factor: float = 1.0) -> ReducedBat[Implement]:
        """Return the bat of a beam; see `all_modes`."""
        return ReducedBat(beam.bat, beam, rigid_body(beam), all_modes(beam, ball, patch_factor=patch_factor))

    def held(self, hands: Hands) -> ReducedBat[Tool_co]:
        """Return the same bat in these hands; without mass they leave it free."""
        return replace(self, modes=held_modes(self.modes, hands))


def reduced_bat(bat: Given, *, ball: Ball) -> ReducedBat[Given]:
    """Return a bat with its beam, its rigid body and its modes under the patch that this ball presses."""
    beam = beam_model(bat)
    return ReducedBat(bat, beam, rigid_body(beam), all_modes(beam, ball))

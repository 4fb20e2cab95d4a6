"""One play that is asked for."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.collision.hit_in_space import Contact
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_path import SwingPath
from sweetspot.uncertainty.sources import DRAWS, Sources


@dataclass(frozen=True)
class PlayQuestion:
    """One play that is asked for; see `sweetspot.analysis.full_play.play`.

    Parameters
    ----------
    reduced : the bat, with what the hands do to it.
    conditions : of the hit; the pitch is as fast as ``pitch`` says.
    flying : what the ball flies through.
    pitch : the ball where the bat meets it.
    contact : where they meet.
    park : whose fence counts; None: none does.
    outdoors : the ball's law in the open, from which the scatter of chances goes on; None: that of ``flying``.
    sources : what is not known, see `play_sources`; None: only what the ball leaves to the exit speed.
    draws : how many answers the intervals come from, a power of two.
    """

    reduced: ReducedBat[Bat]
    conditions: Conditions
    flying: FlightConditions
    path: SwingPath
    pitch: BallMotion
    contact: Contact
    park: Park | None = None
    outdoors: Aerodynamics | None = None
    sources: Sources | None = None
    draws: int = DRAWS

    @property
    def hit_conditions(self) -> Conditions:
        """The conditions with the pitch as fast as it is where the bat meets it."""
        return self.conditions.replaced(pitch=self.conditions.pitch.replaced(speed=self.pitch.speed))

"""What a told play is made of."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.analysis.full_play import Play
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.flight.fence import Landing
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing_path import SwingPath


@dataclass(frozen=True)
class PlayedPitch:
    """A play with everything that was put in.

    Parameters
    ----------
    position, offset : m, where bat and ball met.
    park, landing : where the flight ends, if a park was asked for.
    """

    play: Play
    bat: Bat
    ball: Ball
    position: float
    offset: float
    path: SwingPath
    pitch: BallMotion
    park: Park | None = None
    landing: Landing | None = None

    @property
    def bat_radius(self) -> float:
        """Radius of the barrel where they met, m."""
        return float(self.bat.width_at(self.position)) / 2

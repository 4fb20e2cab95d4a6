"""What a told play is made of."""

from __future__ import annotations

from dataclasses import dataclass, replace

from sweetspot.analysis.full_play import Play
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.fence import Landing, landing
from sweetspot.flight.hit_alike import carry_spread
from sweetspot.flight.home_runs import USUAL as SCATTER
from sweetspot.flight.home_runs import home_run_chances
from sweetspot.flight.park import Park
from sweetspot.flight.trajectory import FlightOutcome
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing_path import SwingPath


@dataclass(frozen=True)
class PlayedPitch:
    """A play with everything that was put in.

    Parameters
    ----------
    position, offset : m, where bat and ball met.
    spread : m, standard deviation of the carry of balls hit alike; 0 where it is not known.
    park, landing : where the flight ends, if a park was asked for.
    chance : of a home run there, with the scatter of balls and weather; None where it is not known.
    error : standard deviation in m/s that the ball alone leaves to the exit speed; None: not known, or told elsewhere.
    """

    play: Play
    bat: Bat
    ball: Ball
    position: float
    offset: float
    path: SwingPath
    pitch: BallMotion
    spread: float = 0.0
    park: Park | None = None
    landing: Landing | None = None
    chance: float | None = None
    error: float | None = None

    @property
    def bat_radius(self) -> float:
        """Radius of the barrel where they met, m."""
        return float(self.bat.width_at(self.position)) / 2


def with_ending(
    played: PlayedPitch, conditions: FlightConditions, *, outdoors: Aerodynamics, park: Park | None
) -> PlayedPitch:
    """Return a play with how far balls hit alike come down apart, and where it ends in a park.

    Parameters
    ----------
    conditions : what it flew through.
    outdoors : the ball's law in the open, from which the chances' scatter goes on; under a roof too.
    """
    flight = played.play.flight
    if flight is None:
        return played
    if park is not None:
        played = replace(played, park=park, landing=landing(flight.positions, park))
    if flight.outcome is not FlightOutcome.LANDED or played.bat.sport != "baseball":
        return played  # nobody measured how other balls scatter
    spread = carry_spread(flight.launch, conditions, drag_scatter=SCATTER.drag(park), spin_scatter=0.0)
    played = replace(played, spread=spread)  # its spin follows from the hit
    if park is None:
        return played
    through = replace(conditions, aerodynamics=outdoors)
    chances = home_run_chances(flight.launch, through, parks=(park,), own_elevation=False).chance
    return replace(played, chance=float(chances[0, 0]))

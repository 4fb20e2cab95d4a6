"""What was asked about the best way to hit, and the answers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sweetspot.analysis.optimum import BestLaunch, BestSwing, EasiestHomeRun
from sweetspot.equipment.bat import Bat
from sweetspot.flight.pitch import PitchFlight


@dataclass(frozen=True)
class AskedLaunch:
    """The best launch angle of one exit speed (m/s) and backspin (rad/s)."""

    exit_speed: float
    backspin: float
    best: BestLaunch


@dataclass(frozen=True)
class Optimum:
    """What was asked for, and the answers; None: not asked for.

    Parameters
    ----------
    swings : the best contact with each pitch.
    parks : the slowest home run of each park.
    """

    bat: Bat
    swings: Sequence[tuple[BestSwing, PitchFlight]] | None = None
    launches: Sequence[AskedLaunch] | None = None
    parks: Sequence[EasiestHomeRun] | None = None

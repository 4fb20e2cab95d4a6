"""The aluminium wall that takes the share of energy which the implemented paper gives for metal."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.trampoline import WallPoint, wall_point
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.papers.formulas import PAPER_METAL_SHARE

METAL_BAT = "russell-b6"
METAL_WALLS = (1.0, 0.95, 0.9, 0.85)
"""Factors on that bat's own wall."""


@dataclass(frozen=True)
class MetalWall:
    """The aluminium wall that takes the paper's share: thickness (m), restitution, BBCOR, exit speed (m/s)."""

    thickness: float
    restitution: float
    bbcor: float
    exit_speed: float


@cache
def metal_wall_point(factor: float) -> WallPoint:
    """Return the best hit of the catalogue's aluminium bat with its wall ``factor`` times as thick."""
    bat = with_wall_factor(catalog.bat(METAL_BAT), factor)
    return wall_point(bat, standard_conditions(bat))


def paper_metal_wall() -> MetalWall:
    """Return that wall, interpolated in a sweep over wall thickness; nothing is fitted."""
    points = [metal_wall_point(factor) for factor in METAL_WALLS]
    shares = [point.energy.share for point in points]

    def at_share(values: list[float]) -> float:
        return float(np.interp(PAPER_METAL_SHARE, shares, values))

    return MetalWall(
        thickness=at_share([point.thickness for point in points]),
        restitution=at_share([point.energy.restitution for point in points]),
        bbcor=at_share([point.bbcor for point in points]),
        exit_speed=at_share([point.exit_speed for point in points]),
    )

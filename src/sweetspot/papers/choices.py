"""What the implemented paper leaves open, and the corked bat and the aluminium wall that follow from it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.analysis.trampoline import WallPoint, wall_point
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.block import Support
from sweetspot.dynamics.weight_match import with_wall_factor
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.motion.swing import Conditions
from sweetspot.papers import formulas as paper
from sweetspot.units import INCH

RATIOS = ("ball_restitution", "wood_restitution", "metal_restitution", "wood_share", "metal_share")
"""Those of `Choices` that are bare numbers: what the formula for W takes."""


@dataclass(frozen=True)
class Choices:
    """What the paper leaves open, or takes from elsewhere; the defaults are its own numbers where it has any.

    Parameters
    ----------
    entry_angle : rad; the paper gives none, 10 degrees show the effect.
    rod_hands : m from the rod's end where it is held; the paper's rod is held at its end.
    hands_moved : m that the hands are moved up.
    bore_diameter, bore_depth, plug : m, of the hole, and the wood that closes at most half of it [nathan_corknote].
    fill : what fills the hole; None: cork.
    drop_height, block_thickness, block_support : of the experiment of Figure 6, for which the paper gives no sizes.
    ball_restitution, wood_restitution, metal_restitution, wood_share, metal_share : k0, k1, k2, z1, z2.
    """

    entry_angle: float = math.radians(10)
    rod_hands: float = 0.0
    hands_moved: float = 2 * INCH
    bore_diameter: float = 1 * INCH
    bore_depth: float = 10 * INCH
    plug: float = 1 * INCH
    fill: Material | None = None
    drop_height: float = 1.0
    block_thickness: float = 0.1
    block_support: Support = "floor"
    ball_restitution: float = paper.PAPER_BALL_RESTITUTION
    wood_restitution: float = paper.PAPER_WOOD_RESTITUTION
    metal_restitution: float = paper.PAPER_METAL_RESTITUTION
    wood_share: float = paper.PAPER_WOOD_SHARE
    metal_share: float = paper.PAPER_METAL_SHARE


def corked(bat: Bat, choices: Choices) -> Bat:
    """Return the bat with the hole of these choices, filled and plugged."""
    return bat.corked(
        diameter=choices.bore_diameter,
        depth=choices.bore_depth,
        plug=min(choices.plug, choices.bore_depth / 2),
        fill=choices.fill or catalog.material("cork"),
    )


@lru_cache(maxsize=8)
def corked_analysis(bat: Bat, choices: Choices, conditions: Conditions) -> Analysis:
    """Return the full analysis of the corked bat under the same swing; the last few are cached."""
    return analyse(corked(bat, choices), conditions)


def can_be_drilled(bat: Bat) -> bool:
    """Return whether the paper's argument can be tried on a bat: solid, not drilled yet, with a known outline."""
    return bat.shell is None and not bat.bores and bat.profile is not None


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
        return float(np.interp(paper.PAPER_METAL_SHARE, shares, values))

    return MetalWall(
        at_share([point.thickness for point in points]),
        at_share([point.energy.restitution for point in points]),
        at_share([point.bbcor for point in points]),
        at_share([point.exit_speed for point in points]),
    )

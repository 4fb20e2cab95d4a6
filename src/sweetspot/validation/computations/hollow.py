"""Hollow bats: their hoop modes, and what the trampoline is worth against wood."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.trampoline import WallPoint, wall_sweep
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import Shell
from sweetspot.validation.computations import shared

TUBE_LENGTH = 0.84
WALLS = (1.6, 1.3, 1.0, 0.85)
"""Factors on a bat's own wall, from stiff to lively."""


def tube_hoop_frequency(*, diameter: float, wall: float, modulus: float, density: float, poisson_ratio: float) -> float:
    """Return the lowest hoop frequency of a long open tube."""
    metal = Material(
        name="tube", family="metal", density=density, longitudinal_modulus=modulus, poisson_ratio=poisson_ratio
    )
    ends = (0.0, TUBE_LENGTH)
    tube = Bat(
        name="tube",
        length=TUBE_LENGTH,
        material=metal,
        profile=tuple((end, diameter) for end in ends),
        shell=Shell(wall=tuple((end, wall) for end in ends)),
    )
    return hoop_frequency(beam_model(tube))


def metal_place(*, metal: str, wood: str) -> float:
    """Return how much further from the tip the metal bat hits best."""
    places = [shared.length(bat) - shared.standard(bat).sweet_spots.max_exit_speed for bat in (metal, wood)]
    return places[0] - places[1]


def hoop_place(*, bat: str) -> float:
    """Return how much nearer the tip than the place of the greatest exit speed the lowest hoop mode swings most."""
    analysis = shared.standard(bat)
    lowest = analysis.modes.of_family("hoop")[0]
    places = analysis.scan.position
    swing = np.abs(analysis.modes.shape_at(places)[:, lowest])
    return float(places[int(np.argmax(swing))] - analysis.sweet_spots.max_exit_speed)


def gain_inside(*, metal: str, wood: str, inward: float) -> float:
    """Return how much more a metal bat gains over wood ``inward`` m nearer the hands than at the wood's best place.

    Places count from the tip; both bats are swung at the same speed.
    """
    best = shared.length(wood) - shared.standard(wood).sweet_spots.max_exit_speed
    there, at_best = (_exit(metal, place) - _exit(wood, place) for place in (best + inward, best))
    return there - at_best


def _exit(bat: str, from_tip: float) -> float:
    scan = shared.standard(bat).scan
    return float(np.interp(shared.length(bat) - from_tip, scan.position, scan.exit_speed))


def bbcor_slope_with_hoop(*, bat: str) -> float:
    """Return the least rise of BBCOR per 100 Hz of lower hoop frequency when the wall is thinned step by step."""
    points = _walls(bat)
    slopes = [
        100 * (thin.bbcor - thick.bbcor) / (thick.hoop_frequency - thin.hoop_frequency)
        for thick, thin in pairwise(points)
    ]
    return min(slopes)


def restitution_of_share(*, bat: str, share: float) -> float:
    """Return the restitution of the wall that stores ``share`` of the ball's energy."""
    points = _walls(bat)
    return float(np.interp(share, [p.energy.share for p in points], [p.energy.restitution for p in points]))


@cache
def _walls(bat: str) -> list[WallPoint]:
    return wall_sweep(catalog.bat(bat), shared.standard(bat).conditions, factors=WALLS)


COMPUTATIONS = (
    tube_hoop_frequency,
    metal_place,
    hoop_place,
    gain_inside,
    bbcor_slope_with_hoop,
    restitution_of_share,
)

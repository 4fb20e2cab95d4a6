"""The pictures of the paper's questions, as numbers."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Annotated

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.analysis.drop_test import bounce
from sweetspot.answers.records import Length, Ratio
from sweetspot.answers.report import SweetSpotPlaces, sweet_spot_places
from sweetspot.dynamics.block import Block, Support
from sweetspot.dynamics.rigid import hand_impulse_ratio
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.papers import formulas
from sweetspot.papers.choices import Choices, can_be_drilled, corked_analysis, metal_wall_point
from sweetspot.papers.formulas import PaperRow
from sweetspot.reports.paper.page_words import percussion_places
from sweetspot.units.dimensions import FORCE, LENGTH, SPEED, TIME
from sweetspot.web.drawings import BatShape, outline
from sweetspot.web.errors import FieldError

PLACES = 121
MATERIALS = {"wood": "white-ash", "metal": "aluminium-7xxx"}
THICKNESSES = np.array([0.002, 0.003, 0.005, 0.008, 0.015, 0.03, 0.1])
"""m, of the blocks in the picture of the drop experiment."""
WALLS = (1.2, 1.0, 0.95, 0.9, 0.85, 0.7)
"""Factors on the wall of the catalogue's aluminium bat in the picture of the energy."""


@dataclass(frozen=True, kw_only=True)
class SpeedsPicture:
    """Exit speeds along the bat with every place that is called sweet.

    Parameters
    ----------
    elastic_travel, travel : the stretch S from the tip that the paper's limits leave, where the question is about it.
    """

    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED]
    rigid_exit_speed: Annotated[Array, SPEED]
    sweet_spots: SweetSpotPlaces
    elastic_travel: Length | None = None
    travel: Length | None = None


@dataclass(frozen=True, kw_only=True)
class PercussionPicture:
    """Equation 9 along the paper's rod and the bat, each held where its control says."""

    position: Annotated[Array, LENGTH]
    rod_ratio: Array
    bat_ratio: Array
    moved_ratio: Array
    rod_percussion: Length
    bat_percussion: Length
    moved_percussion: Length
    best: Length


@dataclass(frozen=True, kw_only=True)
class CorkingPicture:
    """The force of both hits over time, and the exit speeds along both bats at the same bat speed."""

    time: Annotated[Array, TIME]
    force: Annotated[Array, FORCE]
    corked_time: Annotated[Array, TIME]
    corked_force: Annotated[Array, FORCE]
    position: Annotated[Array, LENGTH]
    exit_speed: Annotated[Array, SPEED]
    corked_position: Annotated[Array, LENGTH]
    corked_exit_speed: Annotated[Array, SPEED]
    corked_bat: BatShape


@dataclass(frozen=True)
class DroppedOn:
    """Rebound from a block of one material, None: not in one contact; and rebound over fall by thickness."""

    rebound: Length | None
    limit_rebound: Length
    rebound_ratios: tuple[float, ...]


@dataclass(frozen=True, kw_only=True)
class DropPicture:
    """Rebound heights of both blocks, and rebound over fall of blocks of every thickness held so."""

    drop_height: Length
    thickness: Annotated[Array, LENGTH]
    block_thickness: Length
    wood: DroppedOn
    metal: DroppedOn


@dataclass(frozen=True)
class SpringPair:
    """The bat's share of the energy, and its restitution."""

    share: Ratio
    restitution: Ratio


@dataclass(frozen=True, kw_only=True)
class WallsOfBats:
    """Results of the full model for aluminium bats with other walls."""

    thickness: Annotated[Array, LENGTH]
    share: Array
    returned: Array
    restitution: Array
    exit_speed: Annotated[Array, SPEED]


@dataclass(frozen=True, kw_only=True)
class EnergyPicture:
    """W over z for wood and metal, and what aluminium bats with other walls give."""

    share: Array
    wood_returned: Array
    metal_returned: Array
    wood: SpringPair
    metal: SpringPair
    walls: WallsOfBats


def _verdict(analysis: Analysis[Bat], _: Choices, __: list[PaperRow]) -> SpeedsPicture:
    scan = analysis.scan
    return SpeedsPicture(
        position=scan.position,
        exit_speed=scan.exit_speed,
        rigid_exit_speed=scan.rigid_exit_speed,
        sweet_spots=sweet_spot_places(analysis.sweet_spots),
    )


def _end(analysis: Analysis[Bat], choices: Choices, rows: list[PaperRow]) -> SpeedsPicture:
    elastic = [row for row in rows if row.equation == "S"][-1]
    assert isinstance(elastic.computed, float) and isinstance(elastic.full_model, float)
    speeds = _verdict(analysis, choices, rows)
    return replace(speeds, elastic_travel=elastic.computed / 1e3, travel=elastic.full_model / 1e3)


def _percussion(analysis: Analysis[Bat], choices: Choices, _: list[PaperRow]) -> PercussionPicture:
    bat, body, hands = analysis.bat, analysis.body, analysis.conditions.hands.position
    rod, of_rod, of_bat, of_moved, moved = percussion_places(analysis, choices)
    places = np.linspace(0, bat.length, PLACES)
    return PercussionPicture(
        position=places,
        rod_ratio=np.array([formulas.hand_force_ratio(rod, place, hands=choices.rod_hands) for place in places]),
        bat_ratio=np.array([hand_impulse_ratio(body, place, hands=hands) for place in places]),
        moved_ratio=np.array([hand_impulse_ratio(body, place, hands=moved) for place in places]),
        rod_percussion=of_rod,
        bat_percussion=of_bat,
        moved_percussion=of_moved,
        best=analysis.sweet_spots.max_exit_speed,
    )


def _corking(analysis: Analysis[Bat], choices: Choices, _: list[PaperRow]) -> CorkingPicture:
    if not can_be_drilled(analysis.bat):
        raise FieldError(
            "bat", f"{analysis.bat.name} is hollow, drilled already or without an outline; choose a solid wood bat"
        )
    other = corked_analysis(analysis.bat, choices, analysis.conditions)
    return CorkingPicture(
        time=analysis.best.times,
        force=analysis.best.force,
        corked_time=other.best.times,
        corked_force=other.best.force,
        position=analysis.scan.position,
        exit_speed=analysis.scan.exit_speed,
        corked_position=other.scan.position,
        corked_exit_speed=other.scan.exit_speed,
        corked_bat=outline(other.bat),
    )


def _drop(analysis: Analysis[Bat], choices: Choices, rows: list[PaperRow]) -> DropPicture:
    ball, support = analysis.conditions.ball, choices.block_support
    wood, metal = (
        DroppedOn(_height(row.full_model), _height(row.computed) or 0.0, _rebounds(key, support, ball))
        for key, row in zip(MATERIALS.values(), rows, strict=True)
    )
    return DropPicture(
        drop_height=choices.drop_height,
        thickness=THICKNESSES,
        block_thickness=choices.block_thickness,
        wood=wood,
        metal=metal,
    )


def _height(value: object) -> float | None:
    return value if isinstance(value, float) and np.isfinite(value) else None


@lru_cache(maxsize=64)
def _rebounds(material: str, support: Support, ball: Ball) -> tuple[float, ...]:
    """Return the rebound over the fall, from 1 m, for blocks of every thickness."""
    stuff = catalog.material(material)
    blocks = (Block(material=stuff, thickness=thickness, support=support) for thickness in THICKNESSES.tolist())
    return tuple(bounce(block, ball=ball, height=1.0)[0] for block in blocks)


def _energy(_: Analysis[Bat], choices: Choices, __: list[PaperRow]) -> EnergyPicture:
    shares = np.linspace(0, 0.3, 61)

    def returned(restitution: float) -> Array:
        given = {"bat_restitution": restitution, "ball_restitution": choices.ball_restitution}
        return np.array([formulas.energy_returned(**given, share=share) for share in shares.tolist()])

    walls = [metal_wall_point(factor) for factor in WALLS]
    return EnergyPicture(
        share=shares,
        wood_returned=returned(choices.wood_restitution),
        metal_returned=returned(choices.metal_restitution),
        wood=SpringPair(choices.wood_share, choices.wood_restitution),
        metal=SpringPair(choices.metal_share, choices.metal_restitution),
        walls=WallsOfBats(
            thickness=np.array([wall.thickness for wall in walls]),
            share=np.array([wall.energy.share for wall in walls]),
            returned=np.array([wall.bbcor**2 for wall in walls]),
            restitution=np.array([wall.energy.restitution for wall in walls]),
            exit_speed=np.array([wall.exit_speed for wall in walls]),
        ),
    )


PaperPictures = SpeedsPicture | PercussionPicture | CorkingPicture | DropPicture | EnergyPicture
PICTURES: dict[str, Callable[[Analysis[Bat], Choices, list[PaperRow]], PaperPictures]] = {
    "end": _end,
    "percussion": _percussion,
    "corking": _corking,
    "drop": _drop,
    "energy": _energy,
    "verdict": _verdict,
}

"""A ball dropped or fired on a block: how high it comes back, and where its energy goes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Annotated

from sweetspot.analysis.drop_test import Rebound, drop, fire
from sweetspot.answers.answer import Answer, Uncertainty, uncertainty_of
from sweetspot.answers.drop_draws import block_energies, drawn_drop, rebound_numbers
from sweetspot.answers.records import INTERNAL, Columns, Force, Length, Mass, Ratio, Speed, Time, with_intervals
from sweetspot.dynamics.block import Block
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.interval import Number
from sweetspot.uncertainty.intervals import reach_of_draws
from sweetspot.uncertainty.sources import DRAWS, Sources
from sweetspot.units.dimensions import ENERGY


@dataclass(frozen=True)
class DropQuestion:
    """A drop test that is asked for.

    Parameters
    ----------
    height : m that the ball falls; None: it is fired.
    speed : m/s with which it is fired; None: it falls.
    air_density : kg/m^3, of the air that slows fall and rise; 0: none.
    sources : what is not known, see `drop_sources`; None: no intervals are asked for.
    draws : how many answers the intervals come from, a power of two.
    """

    block: Block
    ball: Ball
    height: float | None = None
    speed: float | None = None
    air_density: float = 0.0
    sources: Sources | None = None
    draws: int = DRAWS

    def rebound(self, block: Block, ball: Ball, faster: float = 0.0) -> Rebound:
        """Return the test of a block and a ball, fired ``faster`` by so many m/s."""
        if self.speed is not None:
            return fire(block, ball=ball, speed=self.speed + faster)
        return drop(block, ball=ball, height=self.height or 0.0, air_density=self.air_density)


@dataclass(frozen=True)
class BlockEnergies:
    """Where the energy of a ball on a block goes; see `EnergyLedger`."""

    incoming: Number
    ball: Number
    heat: Number
    block_translation: Number
    block_vibration: Number
    block_damping: Number


@dataclass(frozen=True, kw_only=True)
class DropAnswer(Answer):
    """A drop test; see `Rebound`.

    Parameters
    ----------
    terminal_speed : in the air; None: no air.
    block_share : part of the energy that the block would hold, pressed slowly.
    uncertainty : what the intervals come from; None: there are none.
    """

    question: Annotated[DropQuestion, INTERNAL]
    material: str
    thickness: Length
    side: Length
    block_mass: Mass
    support: str
    ball: str
    fall_speed: Speed
    fall_height: Length
    terminal_speed: Speed | None
    rebound_speed: Speed
    rebound_height: Length
    restitution: Ratio
    energy_kept: Ratio
    block_share: Ratio
    deflection: Length
    contact_time: Time
    peak_force: Force
    peak_compression: Length
    energy: Annotated[BlockEnergies, ENERGY]
    outcome: str
    uncertainty: Uncertainty | None = None


def drop_answer(question: DropQuestion) -> DropAnswer:
    """Return a drop test.

    Raises
    ------
    InputError
        for a height or speed that cannot be, or a ball that does not come back in one clean contact.
    """
    block, ball, sources = question.block, question.ball, question.sources
    rebound = question.rebound(block, ball)
    plain = DropAnswer(
        question=question,
        material=block.material.name,
        thickness=block.thickness,
        side=block.length,
        support=block.support,
        ball=ball.name,
        fall_height=rebound.fall_height,
        terminal_speed=None if math.isinf(rebound.terminal) else rebound.terminal,
        energy=BlockEnergies(**block_energies(rebound)),
        outcome=rebound.impact.outcome.name.lower(),
        uncertainty=None,
        **rebound_numbers(rebound),
    )
    if sources is None:
        return plain
    drawn = drawn_drop(rebound, sources, question.rebound, count=question.draws)
    sampled = uncertainty_of(
        drawn.drop["restitution"],
        of="restitution",
        normal=drawn.normal,
        names=sources.names,
        sources=sources.described,
    )
    columns: Columns = {**drawn.drop, "energy": drawn.energy}
    return with_intervals(replace(plain, uncertainty=sampled), columns, reach_of_draws)

"""A ball dropped or fired on a block: how high it comes back, and where its energy goes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.analysis.drop_test import Rebound, drop, fire
from sweetspot.answers.answer import Answer, DrawnAnswer, Uncertainty, with_draws
from sweetspot.answers.flight import draws_of_sources
from sweetspot.answers.records import INTERNAL, Force, Length, Mass, Ratio, Speed, Time
from sweetspot.catalog.materials import material_spreads
from sweetspot.dynamics.block import Block
from sweetspot.equipment.ball import Ball
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Number
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.sources import DRAWS, Source, Sources, sources_of_ball
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
    return with_draws(plain, drawn, sources, of="restitution")


STIFFNESS, DENSITY, ARRIVAL = "stiffness of the block", "density of the block", "speed of the ball"
MODULI = ("longitudinal_modulus", "shear_modulus", "transverse_modulus")
"""Scaled together: of one piece all are high or low."""
NEGLIGIBLE = 1e-5
"""Part of the incoming energy below which the block's share is reported without an interval."""


def drop_sources(block: Block, ball: Ball, *, speed_error: float = 0.0) -> Sources:
    """Return the unknowns of a drop test.

    ``speed_error``: one standard deviation of the speed with which the ball comes, m/s; 0: exact.
    """
    name = block.material.name
    spreads, where = material_spreads(name), f"spread of {name} in the catalogue"
    given = ((STIFFNESS, spreads.get("longitudinal_modulus", 0.0)), (DENSITY, spreads.get("density", 0.0)))
    of_block = [Source(source, size, where) for source, size in given if size > 0]
    arrival = [Source(ARRIVAL, speed_error, "as it was written")] if speed_error > 0 else []
    return Sources(NO_DOUBT, (*sources_of_ball(ball), *of_block, *arrival))


def drawn_drop(
    rebound: Rebound, sources: Sources, fired: Callable[[Block, Ball, float], Rebound], *, count: int = DRAWS
) -> DrawnAnswer:
    """Return the sampled answers to a drop test.

    ``rebound``: of block and ball as described. ``sources``: see `drop_sources`. ``fired``: the test of another block
    and ball, with so much more speed of the ball in m/s.
    """
    normal, off = draws_of_sources(sources, count)
    moved: list[tuple[Array, Rebound, Rebound]] = []
    for column, source in enumerate(sources.others):
        assert isinstance(source.spread, float)  # none is even between limits
        up, down = (fired(*_moved(rebound, source, sign * source.spread)) for sign in (1.0, -1.0))
        moved.append((off[:, column] / source.spread, up, down))

    def followed(numbers: Callable[[Rebound], Mapping[str, float]]) -> dict[str, Array]:
        """Return numbers of a test for every draw, by slope and bend."""
        values = {name: np.full(len(off), value) for name, value in numbers(rebound).items()}
        for part, *ends in moved:
            up, down = (numbers(end) for end in ends)
            for name, value in numbers(rebound).items():
                slope, bend = (up[name] - down[name]) / 2, (up[name] + down[name]) / 2 - value
                values[name] = values[name] + part * slope + part**2 * bend
        return values

    centre, energy = block_energies(rebound), followed(block_energies)
    least = NEGLIGIBLE * centre["incoming"]
    energies = {name: value for name, value in energy.items() if centre[name] > least}
    return DrawnAnswer(normal, {**followed(rebound_numbers), "energy": energies})


def _moved(rebound: Rebound, source: Source, off: float) -> tuple[Block, Ball, float]:
    """Return block, ball and more speed, with one deviation."""
    block, ball, name = rebound.block, rebound.ball, source.name
    if name == ARRIVAL:
        return block, ball, off
    if source.ball:
        return block, source.deviated(ball, off), 0.0
    made_of, factor = block.material, float(np.exp(off))
    fields = (
        ("density",)
        if name == DENSITY
        else tuple(modulus for modulus in MODULI if getattr(made_of, modulus) is not None)
    )
    other = made_of.unchecked(**{field: factor * getattr(made_of, field) for field in fields})
    return block.replaced(material=other), ball, 0.0


def rebound_numbers(rebound: Rebound) -> dict[str, float]:
    """Return the results of a drop test except its energies, by the fields of `DropAnswer`."""
    impact = rebound.impact
    return {
        "fall_speed": rebound.fall_speed,
        "rebound_speed": rebound.rebound_speed,
        "rebound_height": rebound.rebound,
        "restitution": rebound.restitution,
        "energy_kept": rebound.energy_kept,
        "block_mass": rebound.block.mass,
        "block_share": rebound.share,
        "deflection": rebound.deflection,
        "contact_time": impact.contact_time,
        "peak_force": impact.peak_force,
        "peak_compression": impact.peak_compression,
    }


def block_energies(rebound: Rebound) -> dict[str, float]:
    """Return the energy balance, by the fields of `BlockEnergies`."""
    energy = rebound.impact.energy
    return {
        "incoming": energy.incoming,
        "ball": energy.ball,
        "heat": energy.heat,
        "block_translation": energy.translation,
        "block_vibration": energy.bending,
        "block_damping": energy.damping,
    }

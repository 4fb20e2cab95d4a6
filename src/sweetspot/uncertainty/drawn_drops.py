"""A drop test with balls and blocks that may be meant.

Few things are not known, and the answer is smooth in them: the test is done for all as described and for each of them
one standard deviation up and down, and every draw follows by slope and bend.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from sweetspot.analysis.drop_test import Rebound
from sweetspot.catalog.materials import material_spreads
from sweetspot.dynamics.block import Block
from sweetspot.equipment.ball import Ball
from sweetspot.uncertainty.implement_doubt import NO_DOUBT
from sweetspot.uncertainty.intervals import DrawnAnswers
from sweetspot.uncertainty.sources import DRAWS, OF_BALL, Source, Sources, sources_of_ball

STIFFNESS, DENSITY, ARRIVAL = "stiffness of the block", "density of the block", "speed of the ball"
MODULI = ("longitudinal_modulus", "shear_modulus", "transverse_modulus")
"""Scaled together: of one piece all are high or low."""
NEGLIGIBLE = 1e-5
"""Part of the energy that comes, below which what a block takes is told without an interval."""


def drop_sources(rebound: Rebound, *, speed_error: float = 0.0) -> Sources:
    """Return what a drop test does not know.

    Parameters
    ----------
    speed_error : one standard deviation of the speed with which the ball comes, m/s; 0: exact.
    """
    name = rebound.block.material.name
    known, where = material_spreads(name), f"spread of {name} in the catalogue"
    given = ((STIFFNESS, known.get("longitudinal_modulus", 0.0)), (DENSITY, known.get("density", 0.0)))
    block = [Source(source, size, where) for source, size in given if size > 0]
    arrival = [Source(ARRIVAL, speed_error, "as it was written")] if speed_error > 0 else []
    return Sources(NO_DOUBT, (*sources_of_ball(rebound.ball), *block, *arrival))


def drawn_drop(
    rebound: Rebound, sources: Sources, fired: Callable[[Block, Ball, float], Rebound], *, count: int = DRAWS
) -> DrawnAnswers:
    """Return the answers of draws to a drop test, by their names in its data.

    Parameters
    ----------
    rebound : of block and ball as described.
    sources : see `drop_sources`.
    fired : the test of another block and ball, with so much more speed of the ball in m/s.
    """
    normal = np.vstack([np.zeros((1, len(sources.names))), sources.normal(count)])
    off = sources.deviations(normal)
    centre = _answers(rebound)
    values = {name: np.full(len(off), value) for name, value in centre.items()}
    for column, one in enumerate(sources.others):
        assert isinstance(one.spread, float)  # none is even between limits
        ends = [_answers(fired(*_moved(rebound, one.name, sign * one.spread))) for sign in (1.0, -1.0)]
        part = off[:, column] / one.spread
        for name, value in centre.items():
            up, down = (end[name] for end in ends)
            values[name] = values[name] + part * (up - down) / 2 + part**2 * ((up + down) / 2 - value)
    least = NEGLIGIBLE * centre["energy_j.incoming"]
    told = {name: value for name, value in values.items() if not name.startswith("energy_j.") or centre[name] > least}
    return DrawnAnswers(normal, sources.names, told)


def _moved(rebound: Rebound, name: str, off: float) -> tuple[Block, Ball, float]:
    """Return block, ball and more speed, with one deviation."""
    block, ball = rebound.block, rebound.ball
    if name == ARRIVAL:
        return block, ball, off
    if name.startswith(OF_BALL):
        return block, ball.deviated({name.removeprefix(OF_BALL).replace(" ", "_"): off}), 0.0
    made_of, factor = block.material, float(np.exp(off))
    fields = ("density",) if name == DENSITY else tuple(one for one in MODULI if getattr(made_of, one) is not None)
    other = made_of.unchecked(**{one: factor * getattr(made_of, one) for one in fields})
    return block.replaced(material=other), ball, 0.0


def _answers(rebound: Rebound) -> Mapping[str, float]:
    """Return what is told of a drop test, by its names in the data."""
    impact = rebound.impact
    energy = impact.energy
    ledger = {
        "ball": energy.ball, "heat": energy.heat, "block_translation": energy.translation,
        "block_vibration": energy.bending, "block_damping": energy.damping,
    }  # fmt: skip
    return {
        "fall_speed_m_s": rebound.fall_speed, "rebound_speed_m_s": rebound.rebound_speed,
        "rebound_height_m": rebound.rebound, "restitution": rebound.restitution, "energy_kept": rebound.energy_kept,
        "block_mass_kg": rebound.block.mass, "block_share": rebound.share, "deflection_m": rebound.deflection,
        "contact_time_s": impact.contact_time, "peak_force_n": impact.peak_force,
        "peak_compression_m": impact.peak_compression, "energy_j.incoming": energy.incoming,
        **{f"energy_j.{name}": joules for name, joules in ledger.items()},
    }  # fmt: skip

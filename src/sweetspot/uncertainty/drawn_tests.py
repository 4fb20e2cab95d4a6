"""The simulated bat test with many bats that may be meant: how sure BBCOR, BPF and the rest are.

A laboratory normalises its shots to one ball, so how lively and how heavy the ball is does not count here. How hard it
is, and through how large a patch it presses, does.
"""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.certification.simulated_test import (
    BPF_SPEED,
    CLAMP,
    FAR,
    NEAR,
    PLACES,
    Certification,
    besr,
    bpf,
)
from sweetspot.collision.closed_form import restitution_from_efficiency
from sweetspot.dynamics.beam import BeamModel
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.parabola import top
from sweetspot.uncertainty.drawn_hits import Draws, draws_of
from sweetspot.uncertainty.intervals import DrawnAnswers
from sweetspot.uncertainty.sources import DRAWS, OF_BALL, PITCH, SWING, Sources

NORMALISED = (f"{OF_BALL}restitution", f"{OF_BALL}restitution slope", f"{OF_BALL}mass")
"""What a test normalises to one ball."""


def sources_of_test(sources: Sources) -> Sources:
    """Return what a bat test does not know: neither a swing nor a pitch, and no ball's liveliness."""
    return sources.without(*NORMALISED, SWING, PITCH)


def drawn_test(
    line: BeamModel, conditions: Conditions, sources: Sources, tested: Certification, *, count: int = DRAWS
) -> DrawnAnswers:
    """Return the answers of draws to a simulated test, by their names in its data, and to the rules' quantities.

    Parameters
    ----------
    conditions : whose ball is fired; its own does not matter otherwise.
    sources : see `sources_of_test`.
    tested : the test of the bat as described; draws are counted from its measures.
    """
    draws = draws_of(line, conditions, sources, count=count)
    efficiency, best, place = _fired(draws, tested.swung.closing_speed)
    _, slow, slow_place = _fired(draws, BPF_SPEED)
    restitution = conditions.ball.restitution.at(BPF_SPEED)
    values = {
        "bbcor": tested.bbcor + best - best[0],
        "besr": besr(tested.fast.best_efficiency) + efficiency - efficiency[0],
        "collision_efficiency": tested.fast.best_efficiency + efficiency - efficiency[0],
        "bpf": tested.bpf + bpf(1.0, ball_restitution=restitution) * (slow - slow[0]),
        "moi": draws.moi(CLAMP),
        "best_position_m": place, "fast.best_position_m": place, "slow.best_position_m": slow_place,
    }  # fmt: skip
    values["batted_ball_speed_m_s"] = tested.swung.batted_ball_speed(values["collision_efficiency"])
    told = {f"test.{name}": value for name, value in values.items() if name != "moi"}
    body = draws.bats.bending
    weight = {"bat.mass_kg": body.mass, "bat.balance_point_m": body.balance_point, "bat.moi_6in_kg_m2": values["moi"]}
    return DrawnAnswers(draws.normal, sources.names, {**told, **weight})


RULED = {
    "bbcor": "test.bbcor", "besr": "test.besr", "bpf": "test.bpf", "batted_ball_speed": "test.batted_ball_speed_m_s",
    "moi": "bat.moi_6in_kg_m2",
}  # fmt: skip
"""Quantities that rules limit, by their names in the answers."""


def _fired(draws: Draws, speed: float) -> tuple[Array, Array, Array]:
    """Return q and BBCOR of every draw at its best place, and that place in m, shapes (draws,)."""
    length = draws.line.bat.length
    places = np.linspace(length - FAR, length - NEAR, PLACES)
    efficiency = draws.struck(places[None, :], np.array([[speed]])).collision_efficiency
    mass = draws.conditions.ball.mass
    recoil = mass * (places - CLAMP) ** 2 / draws.moi(CLAMP)[:, None]
    restitution = restitution_from_efficiency(efficiency, recoil=recoil)
    rows = range(len(draws))
    highest = [top(restitution[row]) for row in rows]
    at = np.array([index for index, _, _ in highest])
    top_place = places[at] + (places[1] - places[0]) * np.array([shift for _, shift, _ in highest])
    return efficiency[np.arange(len(draws)), at], np.array([height for _, _, height in highest]), top_place

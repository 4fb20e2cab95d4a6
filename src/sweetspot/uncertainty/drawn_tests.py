"""The simulated bat test with sampled bats: the uncertainty of BBCOR, BPF and the other measures.

A laboratory normalises its shots to one ball, so how lively and how heavy the ball is does not count here. By which law
it takes and returns energy, how hard it is, and through how large a patch it presses, does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.certification.rules import PERFORMANCE
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
from sweetspot.catalog.balls import MEAN_BALL, THIS_BALL
from sweetspot.collision.closed_form import restitution_from_efficiency
from sweetspot.dynamics.beam import BeamModel
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interpolants import top
from sweetspot.uncertainty.drawn_hits import Draws, draws_of
from sweetspot.uncertainty.sources import DRAWS, PITCH, SWING, Sources

NORMALISED = (THIS_BALL, MEAN_BALL)
"""What a test normalises to one ball."""


def sources_of_test(sources: Sources) -> Sources:
    """Return the unknowns of a bat test: without those of swing, pitch and how lively balls are."""
    return sources.without(*NORMALISED, SWING, PITCH)


@dataclass(frozen=True)
class DrawnTest:
    """What draws answer to a simulated test, arrays of shape (draws,); the first draw is the bat as described.

    ``best_position``, ``slow_best_position``: of the game's closing speed and of 60 mph, m from the knob end.
    """

    draws: Draws
    bbcor: Array
    besr: Array
    bpf: Array
    collision_efficiency: Array
    batted_ball_speed: Array
    best_position: Array
    slow_best_position: Array

    def of_rule(self, quantity: str) -> Array | None:
        """Return the answers to what a rule limits, by its name in `QUANTITIES`; None where draws answer none."""
        if quantity == "moi":
            return self.draws.moi(CLAMP)
        answers: Array | None = getattr(self, quantity) if quantity in PERFORMANCE else None
        return answers


def drawn_test(
    beam: BeamModel, conditions: Conditions, sources: Sources, tested: Certification, *, count: int = DRAWS
) -> DrawnTest:
    """Return the answers of draws to a simulated test (``sources``: see `sources_of_test`)."""
    draws = draws_of(beam, conditions, sources, count=count)
    drawn, best, place = _fired(draws, tested.swung.closing_speed)
    _, slow, slow_place = _fired(draws, BPF_SPEED)
    efficiency = tested.fast.best_efficiency + drawn - drawn[0]
    of_ball = np.array([ball.restitution.at(BPF_SPEED) for ball in draws.balls])
    factors = bpf(slow, ball_restitution=of_ball)
    return DrawnTest(
        draws,
        bbcor=tested.bbcor + best - best[0],
        besr=besr(efficiency),
        bpf=tested.bpf + factors - factors[0],
        collision_efficiency=efficiency,
        batted_ball_speed=tested.swung.batted_ball_speed(efficiency),
        best_position=place,
        slow_best_position=slow_place,
    )


def _fired(draws: Draws, speed: float) -> tuple[Array, Array, Array]:
    """Return q and BBCOR of every draw at its best place, and that place in m, shapes (draws,)."""
    length = draws.beam.bat.length
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

"""From the pitch to where the ball comes down: what a warmer ball or a faster pitch is worth in distance."""

from __future__ import annotations

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import exit_speed_of, hit_at
from sweetspot.validation.computations import shared
from sweetspot.validation.computations.flight import fly_ball


def carry_gain_of_warm_ball(*, bat: str, warmer: float) -> float:
    """Return how much farther the best hit of a bat carries with a ball ``warmer`` K warmer, in the same air."""
    ball = catalog.ball()
    return _carry(bat, temperature=ball.reference_temperature + warmer) - _carry(bat)


def carry_gain_of_pitch(*, bat: str, speed: float) -> float:
    """Return how much farther it carries off a pitch faster by ``speed``."""
    return _carry(bat, faster=speed) - _carry(bat)


def _carry(bat: str, *, temperature: float | None = None, faster: float = 0.0) -> float:
    analysis = shared.standard(bat)
    usual = analysis.conditions
    conditions = usual.replaced(
        ball=usual.ball.conditioned(temperature=temperature),
        pitch=usual.pitch.replaced(speed=usual.pitch.speed + faster),
    )
    impact = hit_at(analysis.sweet_spots.max_exit_speed, modes=analysis.modes, conditions=conditions)
    return fly_ball(answer="carry", exit_speed=exit_speed_of(impact, conditions))


COMPUTATIONS = (carry_gain_of_warm_ball, carry_gain_of_pitch)

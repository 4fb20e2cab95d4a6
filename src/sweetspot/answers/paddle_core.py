"""What a tap says of a paddle's core: sound or crushed, and whether the paddle is still within the rules."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np

from sweetspot.answers.certify_paddle import tested_as_by_the_rules
from sweetspot.answers.records import Frequency, Ratio
from sweetspot.calibration.paddle_core import CRUSHED, CoreState, core_states, with_shear_left
from sweetspot.calibration.taps import Tone
from sweetspot.catalog.balls import ball
from sweetspot.catalog.rules import league
from sweetspot.catalog.sports import sport
from sweetspot.dynamics.paddle_modes import face_tone
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.paddle import Paddle
from sweetspot.numerics.interval import ENDS, REACH, Interval
from sweetspot.units.dimensions import MODULUS

SURE = 0.75
"""Probability from which on the verdict is one [our choice]."""
LEAST_PROBABLE = 0.01
"""Probability of a state of the core below which its test is not computed."""
SHOWN = (1.0, 0.5, 0.25)
"""Parts of the core's shear stiffness left, whose effect is shown."""
STEP = 0.1
"""Part of the shear modulus by which the slope of the restitution is taken."""


@dataclass(frozen=True)
class SofterCore:
    """What a softer core does: so much of its shear stiffness left under the ball.

    ``rebound``: of the ball over its speed, off the paddle at rest, at the best place.
    """

    shear_left: Ratio
    face_tone: Frequency
    rebound: Ratio
    pbcor: Ratio


@dataclass(frozen=True, kw_only=True)
class PaddleCore:
    """The core of a paddle that was tapped.

    Parameters
    ----------
    verdict : "crushed" or "sound" where that is likelier than `SURE`, else "open".
    crushed_probability : that less than `CRUSHED` of its shear stiffness is left under the ball.
    shear_left : its mean, with its interval.
    core_shear : shear modulus away from there.
    face_tone, described_face_tone : as heard and as described with a sound core.
    pbcor, pbcor_limit : in the test of the rules, and what they allow; None: they limit none.
    over_limit_probability : that it is above.
    softening : what a softer core does to this paddle.
    """

    verdict: Literal["crushed", "sound", "open"]
    crushed_probability: Ratio
    shear_left: Ratio
    core_shear: Annotated[Interval, MODULUS]
    face_tone: Frequency
    described_face_tone: Frequency
    pbcor: Ratio | None = None
    pbcor_limit: Ratio | None = None
    over_limit_probability: Ratio | None = None
    softening: tuple[SofterCore, ...] = ()


def core_verdict(states: Sequence[CoreState], described: Paddle) -> PaddleCore:
    """Return the verdict on a core from all its states; see `core_states`."""
    likeliest = max(states, key=lambda state: state.probability)
    crushed = sum(state.probability for state in states if state.shear_left < CRUSHED)
    left = _quantiles([(state.probability, state.shear_left, 0.0) for state in states])
    spread = math.exp(REACH * likeliest.shear_error)
    shear, tone, tones = likeliest.paddle.core_shear, likeliest.face_tone, math.exp(REACH * likeliest.tone_error)
    core = PaddleCore(
        verdict="crushed" if crushed >= SURE else "sound" if crushed <= 1 - SURE else "open",
        crushed_probability=crushed,
        shear_left=left,
        core_shear=Interval(shear, shear / spread, shear * spread),
        face_tone=Interval(tone, tone / tones, tone * tones),
        described_face_tone=face_tone(with_shear_left(described, 1.0)),
    )
    rules = sport(described.sport).rules
    limited = league(rules) if rules else None
    limit = next((rule.most for rule in limited.rules if rule.quantity == "pbcor"), None) if limited else None
    if limited is None or limit is None:
        return core
    tested = ball(limited.ball)
    slope, of_ball = _doubts(likeliest.paddle, tested)
    found = [
        (
            state.probability,
            tested_as_by_the_rules(state.paddle, tested).best_pbcor,
            math.hypot(slope * state.shear_error, of_ball),
        )
        for state in states
        if state.probability > LEAST_PROBABLE
    ]
    over = sum(weight * _above(limit, mean, error) for weight, mean, error in found)
    return replace(
        core,
        pbcor=_quantiles(found),
        pbcor_limit=limit,
        over_limit_probability=over / sum(weight for weight, _, _ in found),
        softening=tuple(_softer(likeliest.paddle, part, tested) for part in SHOWN),
    )


def states_of(tones: Sequence[Tone], paddle: Paddle, positions: Sequence[float]) -> tuple[CoreState, ...]:
    """Return the states of a core by the tones of a paddle, tapped at places in m; none: the middle of its face."""
    return core_states(tones, paddle, positions=positions or [paddle.outline.middle])


def _doubts(paddle: Paddle, tested: Ball) -> tuple[float, float]:
    """Return the restitution's slope by the logarithm of the core's shear, and one sigma of it by the balls."""
    best = tested_as_by_the_rules(paddle, tested).best_pbcor
    harder = tested_as_by_the_rules(paddle.replaced(core_shear=paddle.core_shear * (1 + STEP)), tested).best_pbcor
    half = 0.0 if tested.spread is None else tested.spread.restitution
    livelier = tested_as_by_the_rules(paddle, tested.with_restitution(tested.restitution.reference + half)).best_pbcor
    return (harder - best) / math.log1p(STEP), (livelier - best) / REACH


def _softer(paddle: Paddle, part: float, tested: Ball) -> SofterCore:
    softer = with_shear_left(paddle, part)
    test = tested_as_by_the_rules(softer, tested)
    return SofterCore(part, face_tone(softer), test.best_rebound, test.best_pbcor)


def _above(limit: float, mean: float, error: float) -> float:
    return 0.5 * math.erfc((limit - mean) / max(error, 1e-9) / math.sqrt(2))


def _quantiles(parts: Sequence[tuple[float, float, float]]) -> Interval:
    """Return mean and interval of a mixture of normal laws, each a weight, a mean and a standard deviation."""
    weight, mean, error = np.array(parts).T
    weight = weight / weight.sum()
    reach = 4 * error.max() + 1e-6
    grid = np.linspace(mean.min() - reach, mean.max() + reach, 4001)
    below = np.array(
        [sum(w * (1 - _above(x, m, e)) for w, m, e in zip(weight, mean, error, strict=True)) for x in grid]
    )
    low, high = (float(grid[np.searchsorted(below, end)]) for end in ENDS)
    middle = float(weight @ mean)
    return Interval(middle, min(low, middle), max(high, middle))

"""Bats of one model in order of how fast the same player would hit with each, and whether they really differ.

Every bat is known up to its own covariance; the ball is the same for all. Exit speeds along the barrel are those of
`speed_response` for draws of all bats and the ball: the part of the draws in which a bat is first is its probability of
being best.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from sweetspot.calibration.calibrated_values import properties
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.posterior import Posterior
from sweetspot.calibration.speed_response import SpeedResponse, response_of_speed
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array

DRAWS = 4000
"""A probability of 1/2 is then known to 0.008."""
PLACES = 25
"""Along the barrel or the face."""
REACHED = (0.08, 0.26)
"""m from the tip: the part of the barrel that is looked at (our choice)."""
ON_FACE = 0.1
"""Of a face's length at either end that is not looked at (our choice)."""
BY_CHANCE = 0.05
"""Probability with which bats that are all alike are told to differ: by their scatter, and in any property at all."""


@dataclass(frozen=True)
class RankedBat:
    """One bat among others.

    Parameters
    ----------
    name : what people call it.
    exit_speed : m/s at its best place, for this player and the mean ball; the median, and the ball's doubt is not in
        it.
    best_chance : probability of being the best of all ranked; None: it is not ranked.
    place : m from the knob end, where it hits best.
    properties : mass (kg), balance point (m), moment of inertia about 6 in (kg m^2) and, where it was tapped, modulus
        over the described one; of rackets, clubs and sticks the swing weight, and the square of the first frequency
        over the described one's.
    differs : properties that lie off the mean of the other bats by more than what is not known makes of alike bats.
    contradictions : measurements of it that contradict the others, and expectations of its kind that contradict these,
        with how many sigma.
    """

    name: str
    exit_speed: Measured
    best_chance: float | None
    place: float
    properties: dict[str, Measured]
    differs: tuple[str, ...]
    contradictions: dict[str, float]


@dataclass(frozen=True)
class Ranking:
    """Bats in order, the best first.

    Parameters
    ----------
    bats : ranked.
    unranked : whose measurements contradict each other: what follows from them means nothing, also for the others.
    scatter : standard deviation of their exit speeds, m/s.
    not_known : rms of what is not known of each, m/s.
    wood : standard deviation that bats of this outline in this wood would have, m/s.
    """

    bats: tuple[RankedBat, ...]
    unranked: tuple[RankedBat, ...]
    scatter: float
    not_known: float
    wood: float

    @property
    def by_chance(self) -> float:
        """How much bats that are all alike would seem to differ by what is not known of each, 19 times of 20, m/s."""
        return _greatest_scatter(len(self.bats)) * self.not_known

    @property
    def wood_by_chance(self) -> float:
        """How much so many bats of this wood would differ, 19 times of 20, m/s."""
        return _greatest_scatter(len(self.bats)) * self.wood

    @property
    def beyond_doubt(self) -> bool:
        """Whether the bats differ by more than what is not known of them leaves."""
        return self.scatter > self.by_chance


def _greatest_scatter(count: int) -> float:
    """Return the standard deviation that so few normal values reach by chance, over their true one: chi squared's."""
    from scipy.special import chdtri

    return math.sqrt(float(chdtri(count - 1, BY_CHANCE)) / (count - 1))


def rank_bats(
    posteriors: dict[str, Posterior], *, conditions: Conditions, law: SwingLaw | None, seed: int = 1
) -> Ranking:
    """Return bats of one model in order.

    Parameters
    ----------
    posteriors : what was measured on each, by name; all of one description.
    conditions : of the hits with a bat as described.
    law : of bat speed against moment of inertia; None: all are swung as fast.
    seed : of the draws.

    Raises
    ------
    InputError
        for fewer than two bats whose measurements agree.
    """
    sound = _agreeing(posteriors)
    first = next(iter(posteriors.values()))
    places = barrel_places(first.prior.bat)
    response = response_of_speed(first.prior, conditions, unknowns=first.unknowns, positions=places, law=law)
    generator = np.random.default_rng(seed)
    of_ball = response.efficiency.spreads[len(first.unknowns) :]
    ball = generator.standard_normal((DRAWS, len(of_ball))) * of_ball
    drawn = {name: _drawn(posterior, ball, response, generator) for name, posterior in posteriors.items()}
    won = np.argmax(np.array([drawn[name].with_ball for name in sound]), axis=0)
    chances = dict(zip(sound, (np.bincount(won, minlength=len(sound)) / DRAWS).tolist(), strict=True))
    spreads = np.array([one.spread for one in first.unknowns])
    wood = generator.standard_normal((DRAWS, len(spreads))) * spreads
    by_nature = response.at(np.hstack([wood, 0 * ball])).max(axis=1)
    known = {name: _properties(posterior) for name, posterior in posteriors.items()}
    of_sound = {name: known[name] for name in sound}
    bats = [
        RankedBat(
            name, speeds.exit_speed, chances.get(name), float(places[speeds.best]), known[name],
            _differing(of_sound, name) if name in of_sound else (), posteriors[name].contradictions,
        )
        for name, speeds in sorted(drawn.items(), key=lambda one: -one[1].exit_speed.value)
    ]  # fmt: skip
    ranked, unranked = (tuple(one for one in bats if (one.name in sound) == agrees) for agrees in (True, False))
    values = np.array([one.exit_speed.value for one in ranked])
    errors = np.array([one.exit_speed.error for one in ranked])
    return Ranking(
        ranked, unranked, float(values.std(ddof=1)), float(np.sqrt(np.mean(errors**2))), float(by_nature.std())
    )


@dataclass(frozen=True)
class _DrawnSpeeds:
    """Exit speeds of one bat as it may be, the ball the same for all bats.

    Parameters
    ----------
    with_ball : m/s at the best place of every draw, the ball as it may be too, shape (draws,).
    exit_speed : median and standard deviation of the same with the mean ball, m/s.
    best : index of the place that is best on average.
    """

    with_ball: Array
    exit_speed: Measured
    best: int


def _drawn(posterior: Posterior, ball: Array, response: SpeedResponse, generator: np.random.Generator) -> _DrawnSpeeds:
    own = generator.multivariate_normal(posterior.deviations, posterior.covariance, size=DRAWS, method="cholesky")
    with_ball = response.at(np.hstack([own, ball])).max(axis=1)
    curves = response.at(np.hstack([own, 0 * ball]))
    mean_ball = curves.max(axis=1)
    speed = Measured(float(np.median(mean_ball)), float(mean_ball.std()))
    return _DrawnSpeeds(with_ball, speed, int(np.argmax(curves.mean(axis=0))))


def _agreeing(posteriors: dict[str, Posterior]) -> list[str]:
    """Return the names of the bats whose measurements agree, of which a ranking needs two; see `rank_bats`."""
    if len(posteriors) < 2:
        raise InputError(f"{len(posteriors)} bat was given; a ranking needs two or more")
    sound = [name for name, one in posteriors.items() if not _disagreeing(one)]
    if len(sound) < 2:
        off = "; ".join(
            f"{name}: {which} lies {abs(pull):.1f} sigma off"
            for name, one in posteriors.items()
            for which, pull in _disagreeing(one).items()
        )
        raise InputError(
            f"a ranking needs two bats or more whose measurements agree ({off}). "
            "Measure these again, or write how sure each value is, as in 1.4545±0.003; without ± the last digit counts"
        )
    return sound


def _disagreeing(posterior: Posterior) -> dict[str, float]:
    """Return the measurements that contradict the others, with how many sigma.

    A bat that is only unlike others of its kind, all measurements agreeing on it, is none of these.
    """
    given = {one.name for one in posterior.measurements}
    return {name: pull for name, pull in posterior.contradictions.items() if name in given}


def barrel_places(implement: Implement) -> Array:
    """Return the places in m from the knob end that are looked at: of the barrel, or of the face."""
    face, length = implement.outline, implement.length
    if face is None:
        return np.linspace(length - REACHED[1], length - REACHED[0], PLACES)
    free = ON_FACE * (face.end - face.start)
    return np.linspace(face.start + free, face.end - free, PLACES)


def _properties(posterior: Posterior) -> dict[str, Measured]:
    """Return mass, balance point, moment of inertia and, of a tapped bat, modulus with their errors."""
    known = {name: one.value for name, one in properties(posterior).items()}
    if not any(one.mode for one in posterior.measurements):
        return known
    own = posterior.beam.bat
    off = posterior.deviation("modulus" if isinstance(own, Bat) else "first_frequency")
    power = 1 if isinstance(own, Bat) else 2  # stiffness goes as the frequency squared
    stiffness = math.exp(power * off.value)
    return {**known, "modulus": Measured(stiffness, power * stiffness * off.error)}


def _differing(known: dict[str, dict[str, Measured]], name: str) -> tuple[str, ...]:
    """Return the properties of a bat that lie surely off the mean of the other bats.

    So far off that of alike bats any property of any bat is named in one table of twenty (Bonferroni).
    """
    from scipy.special import ndtri

    reach = -float(ndtri(BY_CHANCE / (2 * len(known) * len(known[name]))))
    names = []
    for which, own in known[name].items():
        others = [values[which] for other, values in known.items() if other != name and which in values]
        if not others:
            continue
        mean = float(np.mean([one.value for one in others]))
        of_mean = float(np.linalg.norm([one.error for one in others])) / len(others)
        if abs(own.value - mean) > reach * max(math.hypot(own.error, of_mean), 1e-12):
            names.append(which)
    return tuple(names)

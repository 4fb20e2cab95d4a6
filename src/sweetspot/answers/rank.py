"""Bats of one model in order of how fast the same player would hit with each, and whether they really differ.

Every bat is known up to its own covariance; the ball is the same for all. Exit speeds along the barrel are those of
`ranking_draws` for draws of all bats and the ball: the part of the draws in which a bat is first is its probability of
being best.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL
from sweetspot.calibration.bat_table import check_same_model
from sweetspot.calibration.calibrated_file import properties
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.posterior import CONTRADICTION, BatPosterior, calibrate
from sweetspot.calibration.unknowns import DIAMETER_SPREAD, described, unknowns_of
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.motion.swing import Conditions
from sweetspot.motion.swing_law import SwingLaw
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import LEVEL
from sweetspot.uncertainty.ranking_draws import drawn_ranking, response_of_speed
from sweetspot.units.dimensions import LENGTH, MASS, MOI, SPEED

PLACES = 25
"""Along the barrel or the face."""
REACHED = (0.08, 0.26)
"""m from the tip: the part of the barrel that is looked at (our choice)."""
ON_FACE = 0.1
"""Of a face's length at either end that is not looked at (our choice)."""
BY_CHANCE = 0.05
"""Probability that identical bats are reported to differ: by their scatter, and in any property at all."""
LOST = 0.01
"""Probability that a table of honest measurements loses a bat [our choice]: errors are not quite normal, and all twelve
bats of a dozen should stay in 95 of 100 tables."""


@dataclass(frozen=True)
class RankQuestion:
    """Bats of one model, as each was measured.

    Parameters
    ----------
    model : as described.
    bats : what was measured on each, by name.
    conditions : of the hits with a bat as described.
    law : of bat speed against moment of inertia; None: all are swung as fast.
    diameter_error : one sigma of each bat's diameters, as a part of them.
    axis : m from the butt end, of the measured moments of inertia and pendulums; None: that of the swing weight.
    """

    model: Implement
    bats: Mapping[str, Sequence[Measurement]]
    conditions: Conditions
    law: SwingLaw | None
    diameter_error: float = DIAMETER_SPREAD
    axis: float | None = None


@dataclass(frozen=True)
class RankedProperties:
    """What is known of a bat.

    ``moi``: about 6 in from the knob; of rackets, clubs and sticks the swing weight. ``modulus``: over the described
    one, of a bat that was tapped; of other implements the square of the first frequency over the described one's.
    """

    mass: Annotated[CalibratedValue, MASS]
    balance_point: Annotated[CalibratedValue, LENGTH]
    moi: Annotated[CalibratedValue, MOI]
    modulus: CalibratedValue | None = None

    @property
    def by_name(self) -> dict[str, Measured]:
        """Those that are known."""
        return {name: value.value for name, value in vars(self).items() if value is not None}


@dataclass(frozen=True, kw_only=True)
class RankedBat:
    """One bat among others.

    Parameters
    ----------
    name : what people call it.
    exit_speed : at its best place, for this player and the mean ball; the median, and the ball's doubt is not in it.
    best_chance : probability of being the best of all ranked; None: it is not ranked.
    best_position : from the knob end, where it hits best.
    mass, moi_6in, swing_weight : the most likely, of wood at 12 % of moisture where a moisture was given; a bat has a
        moment of inertia about 6 in, other implements a swing weight about ``moi_axis``.
    weighed : as it stood on the scale, as moist as it was; None: it was not weighed.
    differs : properties that lie off the mean of the other bats by more than what is not known makes of alike bats.
    contradictions : measurements of it that contradict the others, and expectations of its kind that contradict these,
        with how many sigma.
    far_off : measurements among these that it is ranked in spite of: of so many in the table one lies there by chance.
    """

    name: str
    exit_speed: Annotated[Measured, SPEED]
    best_chance: float | None
    best_position: Annotated[float, LENGTH]
    mass: Annotated[float, MASS]
    weighed: Annotated[float | None, MASS]
    moi_6in: Annotated[float | None, MOI] = None
    swing_weight: Annotated[float | None, MOI] = None
    moi_axis: Annotated[float | None, LENGTH] = None
    properties: RankedProperties
    differs: tuple[str, ...]
    contradictions: Mapping[str, float]
    far_off: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class RankAnswer(Answer):
    """Bats of one model in order.

    Parameters
    ----------
    scatter : standard deviation of the ranked bats' exit speeds.
    not_known : rms of what is not known of each.
    by_chance : how much bats that are all alike would seem to differ by that, 19 times of 20.
    wood : standard deviation that bats of this outline in this wood would have.
    wood_by_chance : how much so many bats of this wood would differ, 19 times of 20.
    beyond_doubt : whether the bats differ by more than what is not known of them leaves.
    bats : the best first, then those whose measurements contradict each other and that are not ranked.
    """

    model: Annotated[Implement, INTERNAL]
    interval_level: float = LEVEL
    scatter: Annotated[float, SPEED]
    not_known: Annotated[float, SPEED]
    by_chance: Annotated[float, SPEED]
    wood: Annotated[float, SPEED]
    wood_by_chance: Annotated[float, SPEED]
    beyond_doubt: bool
    bats: tuple[RankedBat, ...]

    @property
    def ranked(self) -> tuple[RankedBat, ...]:
        """The bats whose measurements agree, the best first."""
        return tuple(bat for bat in self.bats if bat.best_chance is not None)

    @property
    def unranked(self) -> tuple[RankedBat, ...]:
        """The bats whose measurements contradict each other: what follows from them means nothing."""
        return tuple(bat for bat in self.bats if bat.best_chance is None)


def rank_answer(question: RankQuestion, *, step: Callable[[int, int], None] | None = None) -> RankAnswer:
    """Return bats of one model in order of the speeds that they would hit with.

    ``step``: called with the number of bats fitted and of all bats.

    Raises
    ------
    InputError
        for fewer than two bats whose measurements agree, measurements that no bat of the model comes near, and tones
        above the first of rackets, clubs and sticks.
    """
    model = question.model
    check_same_model(question.bats, model, axis=model.swing_axis if question.axis is None else question.axis)
    if not isinstance(model, Bat):
        _check_tones(question)
    beam, unknowns = described(model), unknowns_of(model, diameter_spread=question.diameter_error)
    posteriors = {}
    for count, (name, measurements) in enumerate(question.bats.items(), start=1):
        try:
            posteriors[name] = calibrate(beam, unknowns, measurements)
        except InputError as error:
            raise InputError(f"{name}: {error}") from None
        if step is not None:
            step(count, len(question.bats))
    return rank_bats(posteriors, conditions=question.conditions, law=question.law)


def _check_tones(question: RankQuestion) -> None:
    """Refuse tones above the first of rackets, clubs and sticks: their stiffness is scaled to the first."""
    for name, measurements in question.bats.items():
        for mode in (measurement.mode for measurement in measurements if measurement.mode is not None):
            if mode.family != "bending" or mode.harmonic > 1:
                raise InputError(
                    f"{name}: {mode} was given; of {question.model.name} only bending_1_hz counts, to which its "
                    "stiffness is scaled. Leave the other columns out"
                )


def greatest_scatter(count: int) -> float:
    """Return the standard deviation that so few normal values reach by chance, over their true one: chi squared's."""
    from scipy.special import chdtri

    return math.sqrt(float(chdtri(count - 1, BY_CHANCE)) / (count - 1))


def farthest_by_chance(count: int) -> float:
    """Return the sigma beyond which one of so many honest measurements lies in one table of a hundred (Bonferroni).

    Never less than what contradicts the others of a single bat.

    >>> farthest_by_chance(3), round(farthest_by_chance(60), 2)
    (3.0, 3.76)
    """
    from scipy.special import ndtri

    return max(CONTRADICTION, -float(ndtri(LOST / (2 * count))))


def rank_bats(
    posteriors: Mapping[str, BatPosterior], *, conditions: Conditions, law: SwingLaw | None, seed: int = 1
) -> RankAnswer:
    """Return bats that were fitted already in order; see `rank_answer`.

    ``posteriors``: what is known of each, by name; all of one description. ``seed``: of the draws.
    """
    sound = _agreeing(posteriors)
    first = next(iter(posteriors.values()))
    model = first.prior.bat
    places = barrel_places(model)
    response = response_of_speed(first.prior, conditions, unknowns=first.unknowns, positions=places, law=law)
    drawn = drawn_ranking(posteriors, response, seed=seed)
    chances = drawn.chances(sound)
    found = {name: _properties(posterior) for name, posterior in posteriors.items()}
    compared = {name: found[name].by_name for name in sound}
    fastest_first = sorted(drawn.bats.items(), key=lambda item: -item[1].exit_speed.value)
    bats = [
        RankedBat(
            name=name,
            exit_speed=speeds.exit_speed,
            best_chance=chances.get(name),
            best_position=float(places[speeds.best]),
            mass=found[name].mass.value.value,
            weighed=_weighed(posteriors[name].measurements),
            **_turning(model, found[name].moi.value.value),
            properties=found[name],
            differs=_differing(compared, name) if name in compared else (),
            contradictions=posteriors[name].contradictions,
            far_off=tuple(_disagreeing(posteriors[name])) if name in compared else (),
        )
        for name, speeds in fastest_first
    ]
    ranked = [bat for bat in bats if bat.name in sound]
    scatter = float(np.std([bat.exit_speed.value for bat in ranked], ddof=1))
    not_known = float(np.sqrt(np.mean([bat.exit_speed.error**2 for bat in ranked])))
    by_chance = greatest_scatter(len(ranked)) * not_known
    return RankAnswer(
        model=model,
        scatter=scatter,
        not_known=not_known,
        by_chance=by_chance,
        wood=drawn.by_nature,
        wood_by_chance=greatest_scatter(len(ranked)) * drawn.by_nature,
        beyond_doubt=scatter > by_chance,
        bats=(*ranked, *(bat for bat in bats if bat.name not in sound)),
    )


def _turning(model: Implement, moi: float) -> dict[str, float]:
    if isinstance(model, Bat):
        return {"moi_6in": moi}
    return {"swing_weight": moi, "moi_axis": model.moi_axis}


def _agreeing(posteriors: Mapping[str, BatPosterior]) -> list[str]:
    """Return the names of the bats whose measurements agree, of which a ranking needs two; see `rank_bats`."""
    if len(posteriors) < 2:
        raise InputError(f"{len(posteriors)} bat was given; a ranking needs two or more")
    beyond = farthest_by_chance(sum(len(posterior.measurements) for posterior in posteriors.values()))
    sound = [name for name, posterior in posteriors.items() if not _disagreeing(posterior, beyond)]
    if len(sound) < 2:
        off = "; ".join(
            f"{name}: {which} lies {abs(pull):.1f} sigma off"
            for name, posterior in posteriors.items()
            for which, pull in _disagreeing(posterior).items()
        )
        raise InputError(
            f"a ranking needs two bats or more whose measurements agree ({off}). "
            "Measure these again, or write how sure each value is, as in 1.4545±0.005"
        )
    return sound


def _weighed(measurements: Sequence[Measurement]) -> float | None:
    """Return a weight as it stood on the scale, kg."""
    return next(
        (
            measurement.value.value if measurement.as_read is None else measurement.as_read
            for measurement in measurements
            if measurement.kind == "mass"
        ),
        None,
    )


def _disagreeing(posterior: BatPosterior, beyond: float = CONTRADICTION) -> dict[str, float]:
    """Return the measurements that contradict the others by more than ``beyond`` sigma, with how many.

    A bat that is only unlike others of its kind, all measurements agreeing on it, is none of these.
    """
    given = {measurement.name for measurement in posterior.measurements}
    return {name: pull for name, pull in posterior.contradictions.items() if name in given and abs(pull) > beyond}


def barrel_places(implement: Implement) -> Array:
    """Return the places in m from the knob end that are looked at: of the barrel, or of the face."""
    face, length = implement.outline, implement.length
    if face is None:
        return np.linspace(length - REACHED[1], length - REACHED[0], PLACES)
    free = ON_FACE * (face.end - face.start)
    return np.linspace(face.start + free, face.end - free, PLACES)


def _properties(posterior: BatPosterior) -> RankedProperties:
    """Return mass, balance point, moment of inertia and, of a tapped bat, modulus with their errors."""
    values = properties(posterior)
    modulus = None
    if any(measurement.mode for measurement in posterior.measurements):
        of_bat = isinstance(posterior.beam.bat, Bat)
        off = posterior.deviation("modulus" if of_bat else "first_frequency")
        power = 1 if of_bat else 2  # stiffness goes as the frequency squared
        stiffness = math.exp(power * off.value)
        modulus = CalibratedValue(Measured(stiffness, power * stiffness * off.error), "fitted")
    return RankedProperties(**values, modulus=modulus)


def _differing(properties: Mapping[str, Mapping[str, Measured]], name: str) -> tuple[str, ...]:
    """Return the properties of a bat that lie surely off the mean of the other bats.

    So far off that of alike bats any property of any bat is named in one table of twenty (Bonferroni).
    """
    from scipy.special import ndtri

    reach = -float(ndtri(BY_CHANCE / (2 * len(properties) * len(properties[name]))))
    names = []
    for which, mine in properties[name].items():
        others = [values[which] for other, values in properties.items() if other != name and which in values]
        if not others:
            continue
        mean = float(np.mean([value.value for value in others]))
        of_mean = float(np.linalg.norm([value.error for value in others])) / len(others)
        if abs(mine.value - mean) > reach * max(math.hypot(mine.error, of_mean), 1e-12):
            names.append(which)
    return tuple(names)

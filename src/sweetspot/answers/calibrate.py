"""One calibrated bat: its parameters fitted to scale, string, taps and shots together, with their uncertainty."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

from sweetspot.analysis.certification.shots import Shot
from sweetspot.answers.answer import Answer
from sweetspot.answers.records import INTERNAL, OF_RECORD
from sweetspot.calibration.calibrated_file import calibrated_bat, calibrated_table, material_values, properties
from sweetspot.calibration.contradictions import IntendedReading, intended_readings, suspects
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.calibration.measurements import MeasuredKind, Measurement, of_shots, predicted, shot_ball_unknown
from sweetspot.calibration.posterior import BatPosterior, calibrate
from sweetspot.calibration.unknowns import DIAMETER_SPREAD, described, unknowns_of
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.numerics.interval import LEVEL
from sweetspot.units.dimensions import DENSITY, FREQUENCY, LENGTH, MASS, MODULUS, MOI, RATIO, STIFFNESS, TIME, Dimension

DIMENSIONS: Mapping[MeasuredKind, Dimension] = {
    "mass": MASS,
    "balance_point": LENGTH,
    "moi": MOI,
    "period": TIME,
    "twist_weight": MOI,
    "face_stiffness": STIFFNESS,
    "frequency": FREQUENCY,
    "efficiency": RATIO,
}
"""Of what can be measured."""


@dataclass(frozen=True)
class CalibrateQuestion:
    """A bat, racket, club or stick, and what was measured on it.

    Parameters
    ----------
    bat : as described.
    measurements : by scale, balance, pendulum and tap.
    damping : damping ratio of the bending modes, where it was heard.
    shots, ball : shots at places of a bat, and the kind of their balls; None: the usual one of its sport.
    left_out : names of measurements that are not to count.
    diameter_error : one sigma of the diameters of handle and barrel each, as a part of them.
    """

    bat: Implement
    measurements: Sequence[Measurement] = ()
    damping: Measured | None = None
    shots: Sequence[Shot] = ()
    ball: Ball | None = None
    left_out: Sequence[str] = ()
    diameter_error: float = DIAMETER_SPREAD


@dataclass(frozen=True)
class CalibratedValues:
    """What is known of a calibrated bat; empty where measurements contradict each other.

    ``moi``: about 6 in from the knob end; of rackets, clubs and sticks the swing weight. ``longitudinal_modulus``,
    ``shear_modulus``, ``density``: of a bat's material. ``first_frequency``: of rackets, clubs and sticks.
    ``twist_weight``, ``core_shear``, ``face_stiffness``, ``face_tone``: of paddles.
    """

    mass: Annotated[CalibratedValue | None, MASS] = None
    balance_point: Annotated[CalibratedValue | None, LENGTH] = None
    moi: Annotated[CalibratedValue | None, MOI] = None
    longitudinal_modulus: Annotated[CalibratedValue | None, MODULUS] = None
    shear_modulus: Annotated[CalibratedValue | None, MODULUS] = None
    density: Annotated[CalibratedValue | None, DENSITY] = None
    first_frequency: Annotated[CalibratedValue | None, FREQUENCY] = None
    twist_weight: Annotated[CalibratedValue | None, MOI] = None
    core_shear: Annotated[CalibratedValue | None, MODULUS] = None
    face_stiffness: Annotated[CalibratedValue | None, STIFFNESS] = None
    face_tone: Annotated[CalibratedValue | None, FREQUENCY] = None

    @property
    def by_name(self) -> dict[str, CalibratedValue]:
        """Those that are known."""
        return {name: value for name, value in vars(self).items() if value is not None}


@dataclass(frozen=True)
class CalibratedUnknown:
    """Something that was not known: how far it is off the description.

    ``before_error``: one sigma before anything was measured; of a logarithm, but for the density gradient.
    ``deviation``: from the description, of the same.
    """

    name: str
    before_error: float
    deviation: Measured


@dataclass(frozen=True)
class FittedMeasurement:
    """A measurement, what the fitted bat says to it, and how far it lies from all others together.

    ``fitted``: None where measurements contradict each other. ``off_by_sigma``: one sigma is the measurement's and the
    model's error.
    """

    kind: Annotated[MeasuredKind, INTERNAL]
    name: str
    measured: Annotated[Measured, OF_RECORD]
    fitted: Annotated[float | None, OF_RECORD]
    off_by_sigma: float

    @property
    def dimension(self) -> Dimension:
        """Of the measured value."""
        return DIMENSIONS[self.kind]


@dataclass(frozen=True)
class Suspect:
    """A measurement that alone explains a contradiction.

    ``should``: what it should be by all others, or by the description where it is the only one. ``meant``: as what it
    would agree with them, the nearest first.
    """

    measurement: Annotated[Measurement, INTERNAL]
    name: str
    given: Annotated[float, OF_RECORD]
    should: Annotated[float, OF_RECORD]
    meant: Annotated[tuple[IntendedReading, ...], INTERNAL]

    @property
    def dimension(self) -> Dimension:
        """Of the measured value."""
        return DIMENSIONS[self.measurement.kind]


@dataclass(frozen=True, kw_only=True)
class CalibrateAnswer(Answer):
    """A calibrated bat; without results where measurements contradict each other.

    Parameters
    ----------
    consistent : whether no measurement or expectation lies more than three sigma from all others.
    contradictions : those that do, the farthest first, and by how many sigma.
    suspects : the measurements each of which alone explains that.
    bat : what is known of it.
    damping_ratio : of the bending modes; None where it was not measured.
    unknowns, measurements : what was not known, and what was measured.
    budget : of everything that was not known, the part of its variance that each source causes, the greatest first.
    """

    question: Annotated[CalibrateQuestion, INTERNAL]
    posterior: Annotated[BatPosterior, INTERNAL]
    interval_level: float = LEVEL
    consistent: bool
    contradictions: Mapping[str, float]
    suspects: tuple[Suspect, ...]
    bat: CalibratedValues
    damping_ratio: CalibratedValue | None
    unknowns: tuple[CalibratedUnknown, ...]
    measurements: tuple[FittedMeasurement, ...]
    budget: Mapping[str, Mapping[str, float]]

    @property
    def implement(self) -> Implement:
        """The most likely bat, racket, club or stick; see `calibrated_bat`."""
        fitted = self.posterior.beam.bat
        return calibrated_bat(self.posterior, self.question.damping) if isinstance(fitted, Bat) else fitted

    def to_toml(self) -> str:
        """Return the calibrated bat's file, every value with its interval.

        Raises
        ------
        InputError
            where measurements contradict each other.
        """
        import tomli_w

        if not self.consistent:
            raise InputError("the measurements contradict each other; measure again, or leave one out")
        return tomli_w.dumps(calibrated_table(self.posterior, self.question.damping))


def calibrate_answer(question: CalibrateQuestion) -> CalibrateAnswer:
    """Return the bat that measurements and what is usual of its kind allow, and which measurements contradict it.

    Raises
    ------
    InputError
        where nothing was measured or what is left out was not, no bat comes near the measurements, or other things
        than bats were shot at.
    """
    bat, damping = question.bat, question.damping
    unknowns = unknowns_of(bat, diameter_spread=question.diameter_error)
    measurements = [*question.measurements]
    if question.shots:
        check_takes_shots(bat)
        ball = question.ball or standard_conditions(bat).ball
        measurements += of_shots(question.shots, ball)
        unknowns = (*unknowns, shot_ball_unknown(question.shots, ball))
    names = {measurement.name for measurement in measurements}
    if unknown_names := [name for name in question.left_out if name not in names]:
        raise InputError(f"{unknown_names[0]!r} cannot be left out; measured are {', '.join(sorted(names)) or 'none'}")
    measurements = [measurement for measurement in measurements if measurement.name not in question.left_out]
    posterior = calibrate(described(bat), unknowns, measurements)
    consistent = not posterior.contradictions
    values = {**properties(posterior), **material_values(posterior)} if consistent else {}
    fitted_unknowns = posterior.unknowns if consistent else ()
    return CalibrateAnswer(
        question=question,
        posterior=posterior,
        consistent=consistent,
        contradictions=posterior.contradictions,
        suspects=_suspects(posterior),
        bat=CalibratedValues(**values),
        damping_ratio=None if damping is None else CalibratedValue(damping, "measured"),
        unknowns=tuple(
            CalibratedUnknown(unknown.name, unknown.spread, posterior.deviation(unknown.name))
            for unknown in fitted_unknowns
        ),
        measurements=tuple(
            FittedMeasurement(measurement.kind, measurement.name, measurement.value, fitted, pull)
            for measurement, fitted, pull in zip(
                posterior.measurements,
                posterior.predictions.tolist() if consistent else [None] * len(measurements),
                posterior.pulls.tolist(),
                strict=False,  # behind the measurements' pulls stand those of the expectations
            )
        ),
        budget={unknown.name: posterior.budget(unknown.name) for unknown in fitted_unknowns},
    )


def check_takes_shots(implement: Implement) -> None:
    """Refuse shots at anything but a bat.

    Raises
    ------
    InputError
        for an implement of another kind.
    """
    if not isinstance(implement, Bat):
        raise InputError(
            f"shots tell of bats only; {implement.name} is calibrated by weight, balance, swing weight and tap"
        )


def _suspects(posterior: BatPosterior) -> tuple[Suspect, ...]:
    by_name = {measurement.name: measurement for measurement in posterior.measurements}
    found = []
    for name, others in suspects(posterior).items():
        measurement = by_name[name]
        should = float(predicted(others.beam, [measurement], livelier=others.livelier)[0])
        as_meant = tuple(intended_readings(measurement, others))
        found.append(Suspect(measurement, name, measurement.value.value, should, as_meant))
    return tuple(found)

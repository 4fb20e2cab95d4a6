"""Measurements of one bat with scale, string, telephone and cannon, and their predictions by a beam model.

Shots at known places give the collision efficiency q there. A wrong modulus, wall or weight moves q differently along
the bat; a livelier ball moves it everywhere. The ball's restitution is therefore one more unknown, as wide as the
catalogue allows for its kind, or as the shots tell where every ball was measured on a rigid wall. That is done at
60 mph, as `certify` reads it; what a ball loses from there to the speed of the shots stays as the catalogue has it.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

import numpy as np

from sweetspot.analysis.certification.shots import COR_SPEED, Shot, by_place
from sweetspot.calibration.measured import SEPARATOR, Measured, parse_measured
from sweetspot.calibration.mode_naming import MOST_BENDING, ModeName, NamedTone
from sweetspot.calibration.unknowns import OF_BALL, Unknown
from sweetspot.catalog.balls import slope_doubt
from sweetspot.catalog.swing_laws import MOMENTS, swing_weight
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import BeamModel, beam_model
from sweetspot.dynamics.clamped import PER_MINUTE, clamped_frequency
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.dynamics.paddle_modes import DEFLECTED, bending_tone, face_stiffness, face_tone
from sweetspot.dynamics.reduction import all_modes, bending_frequencies
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.dynamics.swing_weight import pendulum_period
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.golf_club import GolfClub
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.paddle import Paddle
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.plausibility import parse
from sweetspot.units import INCH

MeasuredKind = Literal[
    "mass", "balance_point", "moi", "period", "twist_weight", "frequency", "efficiency", "face_stiffness"
]
CYCLES = re.compile(r"\s*cpm\b", re.IGNORECASE)
"""Cycles per minute, as clubmakers have it."""
OF_BODY = ("mass", "balance_point", "moi", "period", "twist_weight")
"""Kinds that ask for no more than the motion of a rigid body."""
EFFICIENCY_ERROR = 0.01
"""One sigma of q that the model itself deserves (assumed): two makers' tests of one bat differ by as much."""
BENDING_ERROR, HOOP_ERROR = 0.005, 0.03
"""One sigma of a frequency's logarithm that the model itself deserves (assumed): grain, paint and glue; for hoop modes
the course of the wall."""
FACE_ERROR, FACE_TONE_ERROR, PLATE_ERROR = 0.15, 0.03, 0.05
"""The same of a face's stiffness, whose skins and core through the thickness are not known, of its tone, and of a
paddle's bending tone, for which the handle counts (assumed): a handle half or twice as stiff moves it by 6 %."""
MODEL_ERRORS = {"hoop": HOOP_ERROR, "face": FACE_TONE_ERROR}
"""By the family of the mode, where it is not bending."""
FACE_TONE = ModeName("face", 1)
"""The tone of a paddle's face that people hear, however many others there are."""
ELEMENTS = 8
"""Finite elements at least; five modes are then converged to 1e-3 of a bat's damping-free frequency."""


@dataclass(frozen=True)
class Shooting:
    """The conditions of a shot at a bat.

    ``position``: m from the knob end. ``closing_speed``: m/s of ball and bat together.
    """

    position: float
    closing_speed: float
    ball: Ball


@dataclass(frozen=True)
class Measurement:
    """One measured value.

    ``value``: SI. ``axis``: m from the knob end, of a moment of inertia or a pendulum's period. ``as_read``: SI, before
    it was corrected for moisture; None: it was not. ``of_plate``: of a
    paddle's bending, whose model deserves less trust.
    """

    kind: MeasuredKind
    value: Measured
    axis: float = STANDARD_AXIS
    mode: ModeName | None = None
    shooting: Shooting | None = None
    as_read: float | None = None
    of_plate: bool = False

    @property
    def name(self) -> str:
        """Its name in plain words."""
        words = {"balance_point": "balance point", "moi": "moment of inertia", "period": "pendulum"}
        words |= {"twist_weight": "twist weight", "face_stiffness": "face stiffness"}
        if self.mode == FACE_TONE:
            return "face tone"
        if self.shooting is not None:
            return f"q {self.shooting.position / INCH:.1f} in from the knob"
        return str(self.mode) if self.mode else words.get(self.kind, self.kind)

    @property
    def error(self) -> float:
        """One sigma of measurement and model together, SI."""
        if self.shooting is not None:
            return float(np.hypot(self.value.error, EFFICIENCY_ERROR))
        if self.kind == "face_stiffness":
            return float(np.hypot(self.value.error, FACE_ERROR * self.value.value))
        if self.mode is None:
            return self.value.error
        model = PLATE_ERROR if self.of_plate else MODEL_ERRORS.get(self.mode.family, BENDING_ERROR)
        return float(np.hypot(self.value.error, model * self.value.value))


def of_tones(tones: Sequence[NamedTone]) -> list[Measurement]:
    """Return the measurements that a tap test makes: its named bending tones, and the lowest hoop tone.

    Of two tones with one name, a mode in two planes, the mean counts, and half their distance is its error.
    """
    by_name: dict[ModeName, list[Measured]] = {}
    for named in tones:
        if (
            named.name
            and (named.name.family == "bending" or named.name.harmonic == 2)
            and named.name.harmonic <= MOST_BENDING
        ):
            by_name.setdefault(named.name, []).append(named.tone.frequency)
    measurements = []
    for name, frequencies in by_name.items():
        first = frequencies[0]
        if name.family == "bending" and len(frequencies) > 1:
            values = [frequency.value for frequency in frequencies]
            first = Measured(float(np.mean(values)), first.error).widened(float(np.ptp(values)) / 2)
        measurements.append(Measurement("frequency", first, mode=name))
    return measurements


TONES = {
    **{f"bending-{number}": ModeName("bending", number) for number in range(1, MOST_BENDING + 1)},
    "hoop": ModeName("hoop", 2),
    "face": FACE_TONE,
}
"""What tones are called where they are given."""


def of_tone(measurement: Measurement, implement: Implement) -> Measurement:
    """Return the measurement of a tone as this kind of implement has it: a paddle bends as a plate."""
    return replace(measurement, of_plate=isinstance(implement, Paddle) and measurement.mode != FACE_TONE)


def predicted(beam: BeamModel, measurements: Sequence[Measurement], *, livelier: float = 0.0) -> Array:
    """Return the values that a beam model predicts for measurements, SI, shape (n,)."""
    body = rigid_body(beam) if any(measurement.kind in OF_BODY for measurement in measurements) else None
    scaled_to = None if beam.bat.added else beam.bat.frequency
    bending = hoop = None
    count = max(
        (
            measurement.mode.harmonic
            for measurement in measurements
            if measurement.mode and measurement.mode.family == "bending"
        ),
        default=0,
    )
    efficiencies = _efficiencies(
        beam, [measurement.shooting for measurement in measurements if measurement.shooting], livelier
    )
    values = []
    for measurement in measurements:
        if body is not None and measurement.kind in OF_BODY:
            values.append(_of_body(body, measurement))
        elif measurement.shooting is not None:
            values.append(efficiencies[measurement.shooting])
        elif isinstance(beam.bat, Paddle):
            values.append(_of_plate(beam.bat, measurement))
        elif measurement.mode is None:
            raise InputError("a frequency needs the name of its mode")
        elif scaled_to is not None and measurement.mode == ModeName("bending", 1):  # what the stiffness is scaled to
            values.append(scaled_to)
        elif measurement.mode.family == "bending":
            bending = _bending(beam, count) if bending is None else bending
            values.append(float(bending[measurement.mode.harmonic - 1]))
        else:
            hoop = hoop_frequency(beam) if hoop is None else hoop
            values.append(hoop)
    return np.array(values)


def _of_plate(paddle: Paddle, measurement: Measurement) -> float:
    """Predict a quantity of a paddle's plate: the stiffness of its face in N/m, or a tone in Hz."""
    if measurement.kind == "face_stiffness":
        return face_stiffness(paddle)
    return face_tone(paddle) if measurement.mode == FACE_TONE else bending_tone(paddle)


@lru_cache(maxsize=64)
def _bending(beam: BeamModel, count: int) -> Array:
    """Return the lowest bending frequencies; those of the bat as described serve every choice of measurements."""
    return bending_frequencies(beam, count=count, elements=ELEMENTS)


def _of_body(body: RigidBody, measurement: Measurement) -> float:
    """Return the value that a rigid body predicts for a measurement on scale, edge or pendulum, SI."""
    if measurement.kind == "mass":
        return body.mass
    if measurement.kind == "balance_point":
        return body.balance_point
    if measurement.kind == "twist_weight":
        return body.roll_moi
    turning = body.moi(measurement.axis)
    if measurement.kind == "moi":
        return turning
    return pendulum_period(turning, mass=body.mass, balance_point=body.balance_point, pivot=measurement.axis)


def _efficiencies(beam: BeamModel, shootings: Sequence[Shooting], livelier: float) -> dict[Shooting, float]:
    """Return q of shots; a hit that does not end is as bad as none."""
    efficiencies: dict[Shooting, float] = {}
    modes = all_modes(beam, shootings[0].ball) if shootings else None
    for ball in {shooting.ball for shooting in shootings}:
        law = ball.restitution
        shot = ball.replaced(restitution=law.replaced(reference=min(law.reference * float(np.exp(livelier)), 1.0)))
        same = [shooting for shooting in shootings if shooting.ball == ball]
        assert modes is not None  # there is at least one shooting
        struck = hits(
            modes,
            ball=shot,
            position=[shooting.position for shooting in same],
            closing_speed=[shooting.closing_speed for shooting in same],
        )
        values = np.nan_to_num(struck.collision_efficiency, nan=-1.0).tolist()
        efficiencies |= dict(zip(same, values, strict=True))
    return efficiencies


def refuse_twice(measurements: Sequence[Measurement]) -> None:
    """Refuse readings of which two are of one quantity."""
    names = [measurement.name for measurement in measurements]
    if twice := next((name for name in names if names.count(name) > 1), None):
        raise InputError(f"the {twice} was given twice, in a table, as a swing weight or by itself; give it once")


POINTS = re.compile(r"\s*[A-Za-z]\d(?:\.(\d+))?\s*")


def plain_swing_weight(text: str) -> str:
    """Return a racket's swing weight with its unit, which its people leave out: numbers alone are kg cm^2."""
    parts = SEPARATOR.split(text.strip(), maxsplit=1)
    return " ± ".join(f"{part} kg*cm^2" if re.fullmatch(r"\d+(\.\d+)?", part) else part for part in parts)


def of_clamped_tone(text: str, implement: Implement, *, what: str = "tone") -> Measurement:
    """Return the first tone of a club hung freely that cycles per minute with a clamped grip tell.

    Both go as the root of its stiffness, so the measured one is to the drawing's as the free one is to the drawing's
    (`sweetspot.dynamics.clamped`).

    ``text``: ``252cpm`` or ``252cpm±1cpm``; without ± the last digit.
    """
    numbers = [CYCLES.sub("", part) for part in SEPARATOR.split(text, maxsplit=1)]
    if not isinstance(implement, GolfClub) or not CYCLES.search(text):
        raise InputError(f"{what} was given as 'clamped:{text}'; clubs alone are clamped: write it clamped:252cpm±1cpm")
    cycles = parse_measured(" ± ".join(numbers), "ratio", what)
    if not 60 <= cycles.value <= 600:
        raise InputError(f"{what} was given as 'clamped:{text}'; usual is 150 to 350 cycles per minute")
    beam = beam_model(implement)
    free = float(bending_frequencies(beam, count=1)[0]) / (PER_MINUTE * clamped_frequency(beam))
    return Measurement("frequency", Measured(free * cycles.value, free * cycles.error), mode=ModeName("bending", 1))


def of_swing_weight(text: str, sport: str, *, mass: Measured | None, what: str = "swing weight") -> Measurement:
    """Return the moment of inertia that a swing weight is, or the balance point that a first moment tells of a weight.

    ``text``: a letter with points, ``D2`` or ``D2.5±0.2``, in a sport that has them; else a quantity with its unit.
    ``sport``: name in the catalogue. ``mass``: kg, weighed; needed where the sport's swing weight is a first moment, M
    = m (x - axis).

    >>> found = of_swing_weight("D2", "golf", mass=Measured(0.310, 0.0005))  # (217 in oz / 10.93 oz + 14 in) = 33.84 in
    >>> found.name, round(found.value.value, 4), round(found.value.error, 4)
    ('balance point', 0.8597, 0.0041)
    >>> of_swing_weight("316kg*cm^2±1kg*cm^2", "tennis", mass=None).axis
    0.1
    >>> of_swing_weight("316±1", "tennis", mass=None).value  # a racket's has no unit
    Measured(value=0.0316, error=0.0001)
    """
    convention = swing_weight(sport)
    if convention.order == 2:
        written = plain_swing_weight(text) if convention.name == "swing weight" else text
        return Measurement("moi", parse_measured(written, "moi", what), axis=convention.axis)
    if convention.zero is None or convention.step is None:
        moment = parse_measured(text, MOMENTS[1], what)
    else:
        written, *error = SEPARATOR.split(text.strip(), maxsplit=1)
        value = convention.moment_of(written)
        digits = POINTS.fullmatch(written)
        assert digits is not None  # or it is no swing weight
        points = parse(error[0], "ratio", f"the error of {what}") if error else 10.0 ** -len(digits[1] or "")
        if not points > 0:
            raise InputError(f"the error of {what} was given as {error[0]!r}; allowed is more than 0")
        moment = Measured(value, points * convention.step * convention.size)
    if mass is None:
        raise InputError(f"{what} {text} tells of the balance point only together with the weight; give the mass too")
    arm = moment.value / mass.value
    error_of_arm = math.hypot(moment.error / mass.value, arm * mass.error / mass.value)
    return Measurement("balance_point", Measured(convention.axis + arm, error_of_arm))


def of_twist_weight(text: str, *, what: str = "twist weight") -> Measurement:
    """Return the twist weight of a paddle; a number alone is in kg cm^2.

    >>> of_twist_weight("7.2±0.2").value
    Measured(value=0.00072, error=2e-05)
    """
    return Measurement("twist_weight", parse_measured(plain_swing_weight(text), "moi", what))


def of_face_stiffness(text: str, *, what: str = "face stiffness") -> Measurement:
    """Return the stiffness of a paddle's face, given as such or as the force that presses it in by 1/16 in.

    >>> round(of_face_stiffness("45lbf±2lbf").value.value / 1e3, 1)
    126.1
    """
    try:
        return Measurement("face_stiffness", parse_measured(text, "stiffness", what))
    except InputError:
        force = parse_measured(text, "force", what)
        return Measurement("face_stiffness", Measured(force.value / DEFLECTED, force.error / DEFLECTED))


ONE_PLACE = 0.0064
"""m; shots within a quarter of an inch are at one place."""
ONE_SHOT = 0.01
"""One sigma of q of a single shot at least (assumed): each speed to half a per cent."""
MEASURED_BALLS = 0.01
"""One sigma of the restitution's logarithm at 60 mph where every ball was measured (assumed)."""
UNMEASURED_LOT = 0.037
"""The same of a lot that was not measured: a rule allows 0.546 +- 0.032, and nine of ten lots keep it [kagan2004]
(assumed)."""


def of_shots(shots: Sequence[Shot], ball: Ball) -> list[Measurement]:
    """Return the mean q of the shots at each place, with the error of the mean."""
    return [_mean(group, ball) for group in by_place(shots, within=ONE_PLACE)]


def _mean(group: Sequence[Shot], ball: Ball) -> Measurement:
    values = np.array([shot.collision_efficiency for shot in group])
    scatter = max(float(np.std(values, ddof=1)), ONE_SHOT) if len(group) > 2 else ONE_SHOT
    closing = float(np.mean([shot.closing_speed for shot in group]))
    place = float(np.mean([shot.position for shot in group]))
    return Measurement(
        "efficiency",
        Measured(float(values.mean()), scatter / math.sqrt(len(group))),
        shooting=Shooting(place, closing, _as_measured(ball, group)),
    )


def _as_measured(ball: Ball, group: Sequence[Shot]) -> Ball:
    """Return the ball with the mean restitution and mass of those that were shot, as far as they were measured."""
    cors = [shot.ball_cor for shot in group if shot.ball_cor is not None]
    masses = [shot.ball_mass for shot in group if shot.ball_mass is not None]
    if len(cors) == len(group):
        law = ball.restitution
        off = float(np.mean(cors)) - law.at(COR_SPEED)
        ball = ball.replaced(restitution=law.replaced(reference=law.reference + off))
    if len(masses) == len(group):
        ball = ball.replaced(mass=float(np.mean(masses)))
    return ball


def shot_ball_unknown(shots: Sequence[Shot], ball: Ball) -> Unknown:
    """Return the unknown of the shot balls' restitution: its logarithm over that of their law.

    What balls are at 60 mph and what they are at the anchor of their law is known apart, and not the slope between.
    """
    slope, anchor = slope_doubt(ball)
    measured = all(shot.ball_cor is not None for shot in shots)
    faster = float(np.mean([shot.closing_speed for shot in shots])) - (COR_SPEED if measured else anchor)
    lot = MEASURED_BALLS if measured else UNMEASURED_LOT
    return Unknown(OF_BALL, math.hypot(lot, slope * faster / ball.restitution.reference))

"""Measurements of one bat with a scale, a string and a telephone, and their predictions by a beam model."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.naming import MOST_BENDING, ModeName, NamedTone
from sweetspot.collision.kernel import hits
from sweetspot.dynamics.beam import BeamModel
from sweetspot.dynamics.hoop import hoop_frequency
from sweetspot.dynamics.reduction import all_modes, bending_frequencies
from sweetspot.dynamics.rigid import RigidBody, pendulum_period, rigid_body
from sweetspot.equipment.ball import Ball
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.units import INCH

MeasuredKind = Literal["mass", "balance_point", "moi", "period", "frequency", "efficiency"]
OF_BODY = ("mass", "balance_point", "moi", "period")
"""Kinds that ask for no more than the motion of a rigid body."""
EFFICIENCY_ERROR = 0.01
"""One sigma of q that the model itself deserves (assumed): two makers' tests of one bat differ by as much."""
BENDING_ERROR, HOOP_ERROR = 0.005, 0.03
"""One sigma of a frequency's logarithm that the model itself deserves (assumed): grain, paint and glue; for hoop modes
the course of the wall."""
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

    ``value``: SI. ``axis``: m from the knob end, of a moment of inertia or a pendulum's period.
    """

    kind: MeasuredKind
    value: Measured
    axis: float = STANDARD_AXIS
    mode: ModeName | None = None
    shooting: Shooting | None = None

    @property
    def name(self) -> str:
        """Its name in plain words."""
        words = {"balance_point": "balance point", "moi": "moment of inertia", "period": "pendulum"}
        if self.shooting is not None:
            return f"q {self.shooting.position / INCH:.1f} in from the knob"
        return str(self.mode) if self.mode else words.get(self.kind, self.kind)

    @property
    def error(self) -> float:
        """One sigma of measurement and model together, SI."""
        if self.shooting is not None:
            return float(np.hypot(self.value.error, EFFICIENCY_ERROR))
        if self.mode is None:
            return self.value.error
        model = HOOP_ERROR if self.mode.family == "hoop" else BENDING_ERROR
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


def predicted(beam: BeamModel, measurements: Sequence[Measurement], *, livelier: float = 0.0) -> Array:
    """Return the values that a beam model predicts for measurements, SI, shape (n,).

    ``livelier``: logarithm of the shot balls' restitution over that of their law.
    """
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
            values.append(prediction_of_body(body, measurement))
        elif measurement.shooting is not None:
            values.append(efficiencies[measurement.shooting])
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


@lru_cache(maxsize=64)
def _bending(beam: BeamModel, count: int) -> Array:
    """Return the lowest bending frequencies; those of the bat as described serve every choice of measurements."""
    return bending_frequencies(beam, count=count, elements=ELEMENTS)


def prediction_of_body(body: RigidBody, measurement: Measurement) -> float:
    """Return the value that a rigid body predicts for a measurement on scale, edge or pendulum, SI."""
    if measurement.kind == "mass":
        return body.mass
    if measurement.kind == "balance_point":
        return body.balance_point
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

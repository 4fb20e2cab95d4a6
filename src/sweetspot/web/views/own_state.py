"""Own bat: what was measured on it, or on a racket, club or stick, and from that to the bat that it allows."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Literal, get_args

from pydantic import Field

from sweetspot.answers.calibrate import CalibrateAnswer, CalibrateQuestion, calibrate_answer
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.mode_naming import ModeName
from sweetspot.calibration.unknowns import Unknown, unknowns_of
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.units import INCH, OUNCE, OUNCE_INCH_SQUARED
from sweetspot.web.bats import described, implement_of
from sweetspot.web.controls import BatState, Name, Toml
from sweetspot.web.errors import FieldError, about
from sweetspot.web.uploads import UploadKey

FARTHEST_PIVOT = 0.9
"""Part of the balance point's place beyond which a bat is not hung."""
ToneName = Literal["bending-1", "bending-2", "bending-3", "bending-4", "bending-5", "hoop"]
TONES: tuple[ToneName, ...] = get_args(ToneName)


def mode_of(name: ToneName) -> ModeName:
    """Return the mode of a tone's name."""
    return ModeName("hoop", 2) if name == "hoop" else ModeName("bending", int(name[-1]))


MEASURED = ("mass", "balance point", "pendulum", "moment of inertia", *map(str, map(mode_of, TONES)))
"""Names of all that can be measured here."""
Tone = tuple[ToneName, Annotated[float, Field(gt=20, le=20000)], Annotated[float, Field(gt=0, le=1000)]]
"""Mode, Hz, and one sigma."""
Weight = Annotated[float, Field(ge=2, le=60)]
Place = Annotated[float, Field(ge=5, le=40)]
Period = Annotated[float, Field(ge=800, le=2500)]
SwingWeight = Annotated[float, Field(ge=50, le=40000)]
Ratio = Annotated[float, Field(gt=0, le=0.1)]


class OwnState(BatState):
    """The bat as described, and what scale, balance, pendulum and tap say of it; what is empty was not measured."""

    implement: Name | None = Field(
        None, description="what was measured, where it is not the bat: name in the catalogue"
    )
    implement_toml: Toml | None = Field(None, description="the text of its own file, where implement is given")
    weighed_oz: Weight | None = Field(None, description="on a scale")
    weighed_error_oz: float = Field(0.05, ge=0.005, le=2, description="one sigma of that")
    balanced_in: Place | None = Field(None, description="balance point from the knob end")
    balanced_error_in: float = Field(0.1, ge=0.01, le=2, description="one sigma of that")
    pendulum_ms: Period | None = Field(None, description="of one full swing about the pivot")
    pendulum_error_ms: float = Field(3.0, ge=0.1, le=100, description="one sigma of that")
    swing_weight_oz_in2: SwingWeight | None = Field(None, description="moment of inertia about where it hangs")
    swing_weight_error_oz_in2: float = Field(10.0, ge=1, le=1000, description="one sigma of that")
    pivot_in: Annotated[float, Field(ge=0, le=20)] | None = Field(
        None, description="where it hangs, from the grip's end; empty: as its sport has it"
    )
    tones: Annotated[tuple[Tone, ...], Field(max_length=6)] = Field(
        (), description="modes that were heard: name, frequency in Hz, one sigma in Hz"
    )
    damping: Ratio | None = Field(None, description="damping ratio of the bending modes, heard")
    damping_error: Ratio = Field(0.0005, description="one sigma of that")
    diameter_error: float = Field(0.003, ge=0.0005, le=0.05, description="of handle and barrel each, a part of it")
    left_out: Annotated[tuple[Name, ...], Field(max_length=10)] = Field((), description="measurements not to count")
    tap_from_tip_in: float = Field(1.0, ge=0, le=40, description="where it is tapped")
    league: Name = Field("usual", description="whose rules hold: a league, or usual for the bat")
    recordings: Annotated[tuple[UploadKey, ...], Field(max_length=40)] = Field(
        (), description="sounds that were handed in, for what is asked of taps"
    )


def own_of(state: OwnState) -> Implement:
    """Return the measured implement, as it is described: the bat, or what is named in its place."""
    implement = described(state) if state.implement is None else implement_of(state.implement, state.implement_toml)
    return implement.as_drawn()


@lru_cache(maxsize=64)
def unknown_of(state: OwnState) -> tuple[Implement, tuple[Unknown, ...]]:
    """Return the measured implement, as it is described, and its unknowns."""
    implement = own_of(state)
    with about("bat" if state.implement is None else "implement"):
        return implement, unknowns_of(implement, diameter_spread=state.diameter_error)


def pivot_of(state: OwnState, implement: Implement) -> float:
    """Return the pivot from which it hangs, and the axis of its swing weight, in m from the grip's end."""
    if state.pivot_in is not None:
        return state.pivot_in * INCH
    return implement.swing_axis


def measurements_of(state: OwnState) -> list[Measurement]:
    """Return all measurements of a state."""
    measurements = []
    axis = pivot_of(state, own_of(state))
    if state.weighed_oz is not None:
        measurements.append(Measurement("mass", Measured(state.weighed_oz * OUNCE, state.weighed_error_oz * OUNCE)))
    if state.balanced_in is not None:
        measurements.append(
            Measurement("balance_point", Measured(state.balanced_in * INCH, state.balanced_error_in * INCH))
        )
    if state.pendulum_ms is not None:
        period = Measured(1e-3 * state.pendulum_ms, 1e-3 * state.pendulum_error_ms)
        measurements.append(Measurement("period", period, axis=axis))
    if state.swing_weight_oz_in2 is not None:
        value, error = state.swing_weight_oz_in2, state.swing_weight_error_oz_in2
        moi = Measured(value * OUNCE_INCH_SQUARED, error * OUNCE_INCH_SQUARED)
        measurements.append(Measurement("moi", moi, axis=axis))
    for name, frequency, error in state.tones:
        measurements.append(Measurement("frequency", Measured(frequency, error), mode=mode_of(name)))
    return measurements


def name_of(mode: ModeName) -> ToneName:
    """Return a mode's name in a state."""
    return TONES[-1 if mode.family == "hoop" else mode.harmonic - 1]


@lru_cache(maxsize=64)
def answer_of(state: OwnState) -> CalibrateAnswer | None:
    """Return the bat that the measurements that count allow; None: nothing was measured."""
    for name in state.left_out:
        if name not in MEASURED:
            raise FieldError("left_out", f"there is no measurement {name!r}; there are {', '.join(MEASURED)}")
    counted = [measurement for measurement in measurements_of(state) if measurement.name not in state.left_out]
    if not counted:
        return None
    bat = own_of(state)
    balance = rigid_body(beam_of(bat)).balance_point
    if state.pendulum_ms is not None and pivot_of(state, bat) > FARTHEST_PIVOT * balance:
        raise FieldError(
            "pivot_in",
            f"what balances {balance / INCH:.4g} in from its {bat.grip_end} hardly swings from there; hang it from the "
            "handle",
        )
    with about("bat" if state.implement is None else "implement"):
        return calibrate_answer(
            CalibrateQuestion(bat, counted, damping=damping_of(state), diameter_error=state.diameter_error)
        )


def damping_of(state: OwnState) -> Measured | None:
    """Return the damping that was heard."""
    return None if state.damping is None else Measured(state.damping, state.damping_error)

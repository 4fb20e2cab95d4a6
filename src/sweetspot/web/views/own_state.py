"""Own bat: what was measured on it, and from that to the bat that the measurements allow."""

from __future__ import annotations

from functools import lru_cache
from typing import Annotated, Literal

from pydantic import Field

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.measurements import Measurement
from sweetspot.calibration.naming import ModeName
from sweetspot.calibration.posterior import Posterior, calibrate
from sweetspot.calibration.unknowns import Unknown, unknowns_of
from sweetspot.calibration.unknowns import described as beam_of
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.units import INCH, OUNCE
from sweetspot.web.bats import described
from sweetspot.web.errors import FieldError, about
from sweetspot.web.states import BatState, Name
from sweetspot.web.uploads import UploadKey

FARTHEST_PIVOT = 0.9
"""Part of the balance point's place beyond which a bat is not hung."""
ToneName = Literal["bending-1", "bending-2", "bending-3", "bending-4", "bending-5", "hoop"]
Tone = tuple[ToneName, Annotated[float, Field(gt=20, le=20000)], Annotated[float, Field(gt=0, le=1000)]]
"""Mode, Hz, and one sigma."""
Weight = Annotated[float, Field(ge=10, le=60)]
Place = Annotated[float, Field(ge=5, le=40)]
Period = Annotated[float, Field(ge=800, le=2500)]
Ratio = Annotated[float, Field(gt=0, le=0.1)]


class OwnState(BatState):
    """The bat as described, and what scale, balance, pendulum and tap say of it; what is empty was not measured."""

    weighed_oz: Weight | None = Field(None, description="on a scale")
    weighed_error_oz: float = Field(0.05, ge=0.005, le=2, description="one sigma of that")
    balanced_in: Place | None = Field(None, description="balance point from the knob end")
    balanced_error_in: float = Field(0.1, ge=0.01, le=2, description="one sigma of that")
    pendulum_ms: Period | None = Field(None, description="of one full swing about the pivot")
    pendulum_error_ms: float = Field(3.0, ge=0.1, le=100, description="one sigma of that")
    pivot_in: float = Field(6.0, ge=0, le=20, description="where it hangs, from the knob end")
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


@lru_cache(maxsize=64)
def bat_of(state: OwnState) -> tuple[Bat, tuple[Unknown, ...]]:
    """Return the bat as it is described, and what is not known of it."""
    bat = described(state)
    with about("bat"):
        return bat, unknowns_of(bat, diameter_spread=state.diameter_error)


def measurements_of(state: OwnState) -> list[Measurement]:
    """Return what was measured, all of it."""
    measurements = []
    if state.weighed_oz is not None:
        measurements.append(Measurement("mass", Measured(state.weighed_oz * OUNCE, state.weighed_error_oz * OUNCE)))
    if state.balanced_in is not None:
        measurements.append(
            Measurement("balance_point", Measured(state.balanced_in * INCH, state.balanced_error_in * INCH))
        )
    if state.pendulum_ms is not None:
        period = Measured(1e-3 * state.pendulum_ms, 1e-3 * state.pendulum_error_ms)
        measurements.append(Measurement("period", period, axis=state.pivot_in * INCH))
    for name, frequency, error in state.tones:
        measurements.append(Measurement("frequency", Measured(frequency, error), mode=mode_of(name)))
    return measurements


def mode_of(name: ToneName) -> ModeName:
    """Return the mode of a tone's name."""
    return ModeName("hoop", 2) if name == "hoop" else ModeName("bending", int(name[-1]))


def name_of(mode: ModeName) -> str:
    """Return a mode's name in a state."""
    return "hoop" if mode.family == "hoop" else f"bending-{mode.harmonic}"


@lru_cache(maxsize=64)
def posterior_of(state: OwnState) -> Posterior | None:
    """Return the bat that the measurements that count allow; None: nothing was measured."""
    measured = [one for one in measurements_of(state) if one.name not in state.left_out]
    if not measured:
        return None
    bat, unknowns = bat_of(state)
    described_beam = beam_of(bat)
    balance = rigid_body(described_beam).balance_point
    if state.pendulum_ms is not None and state.pivot_in * INCH > FARTHEST_PIVOT * balance:
        raise FieldError(
            "pivot_in", f"a bat that balances {balance / INCH:.4g} in from its knob hardly swings from there; hang it "
            "from the handle"
        )  # fmt: skip
    with about("bat"):
        return calibrate(described_beam, unknowns, measured)


def damping_of(state: OwnState) -> Measured | None:
    """Return the damping that was heard."""
    return None if state.damping is None else Measured(state.damping, state.damping_error)

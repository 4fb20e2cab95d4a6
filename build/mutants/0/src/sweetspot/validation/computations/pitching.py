"""Pitches of the catalogue flown to the plate."""

from __future__ import annotations

from functools import cache

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.deliveries import usual_height
from sweetspot.flight.air import Air
from sweetspot.flight.pitch import MIDDLE, PitchFlight, aimed
from sweetspot.units import FOOT

DAY = Air(temperature=24.0, elevation=290 * FOOT)
"""What the drag was fitted with: a warm evening (assumed) at the mean elevation of the day's parks."""


@cache
def flown(pitch: str, law: str) -> PitchFlight:
    """Return a pitch of the catalogue thrown to where such pitches pass the plate."""
    return aimed(
        catalog.delivery(pitch),
        ball=catalog.ball(),
        aerodynamics=aerodynamics(law),
        air=DAY,
        target=(MIDDLE[0], usual_height(pitch)),
    )


def pitch_speed_ratio(*, pitch: str, law: str = "pitched-baseball") -> float:
    """Return speed at the plate over speed at release."""
    return flown(pitch, law).speed_ratio


def pitch_plate_speed(*, pitch: str) -> float:
    """Return speed at the plate."""
    return flown(pitch, "pitched-baseball").plate.speed


def pitch_fall(*, pitch: str) -> float:
    """Return the vertical approach angle at the plate."""
    return flown(pitch, "pitched-baseball").vertical_approach_angle


def pitch_mean_speed_ratio(*, pitches: dict[str, int]) -> float:
    """Return the mean ratio over a mix of pitches, given how often each was thrown."""
    total = sum(count * pitch_speed_ratio(pitch=pitch) for pitch, count in pitches.items())
    return total / sum(pitches.values())


COMPUTATIONS = (pitch_speed_ratio, pitch_plate_speed, pitch_fall, pitch_mean_speed_ratio)

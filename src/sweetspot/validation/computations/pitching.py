"""Pitches of the catalogue flown to the plate."""

from __future__ import annotations

from functools import cache

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import STILL_AIR, aerodynamics
from sweetspot.catalog.deliveries import usual_height
from sweetspot.flight.air import CALM, MEAN_BREEZE, Air
from sweetspot.flight.pitch import MIDDLE, PitchFlight, aimed
from sweetspot.units import FOOT

DAY = Air(temperature=22.2, elevation=290 * FOOT)
"""What the drag was fitted with: 72 degF (assumed) at the mean elevation of the day's parks."""
DAY_DRAG = 0.2905
"""Of the law of pitches: the day's own level [savant_2020day]; balls differ from year to year."""


@cache
def flown(pitch: str, law: str = "") -> PitchFlight:
    """Return a pitch of the catalogue thrown to where such pitches pass the plate, by the day's drag or by a law.

    The law of still air is given the breeze of the mean park.
    """
    known = aerodynamics(law) if law else aerodynamics("pitched-baseball").replaced(drag=DAY_DRAG)
    return aimed(
        catalog.delivery(pitch),
        ball=catalog.ball(),
        aerodynamics=known,
        air=DAY,
        wind=MEAN_BREEZE if law == STILL_AIR else CALM,
        target=(MIDDLE[0], usual_height(pitch)),
    )


def pitch_speed_ratio(*, pitch: str, law: str = "") -> float:
    """Return speed at the plate over speed at release."""
    return flown(pitch, law).speed_ratio


def pitch_plate_speed(*, pitch: str) -> float:
    """Return speed at the plate."""
    return flown(pitch).plate.speed


def pitch_fall(*, pitch: str) -> float:
    """Return the vertical approach angle at the plate."""
    return flown(pitch).vertical_approach_angle


def pitch_mean_speed_ratio(*, pitches: dict[str, int]) -> float:
    """Return the mean ratio over a mix of pitches, given how often each was thrown."""
    total = sum(count * pitch_speed_ratio(pitch=pitch) for pitch, count in pitches.items())
    return total / sum(pitches.values())


COMPUTATIONS = (pitch_speed_ratio, pitch_plate_speed, pitch_fall, pitch_mean_speed_ratio)

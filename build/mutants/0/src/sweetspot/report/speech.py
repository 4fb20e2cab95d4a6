"""How a sport's people say it: speeds and places in their units, things by their words."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.catalog.sports import sport
from sweetspot.implement import Implement
from sweetspot.sport import Sport, Words
from sweetspot.units import FOOT, INCH, MPH

SPEEDS = {"mph": MPH, "m/s": 1.0}
PLACES = {"in": INCH, "cm": 0.01}
DISTANCES = {"ft": FOOT, "yd": 3 * FOOT, "m": 1.0}


@dataclass(frozen=True)
class Speech:
    """The words of one sport with its units.

    Parameters
    ----------
    sport : whose.
    """

    sport: Sport

    @property
    def words(self) -> Words:
        """What its people call things."""
        return self.sport.words

    def speed(self, value: float) -> str:
        """Return a speed (m/s) as text."""
        unit = self.words.speed_unit
        return f"{value / SPEEDS[unit]:.1f} {unit}"

    def place(self, value: float) -> str:
        """Return a distance on the implement (m) as text."""
        unit = self.words.place_unit
        return f"{value / PLACES[unit]:.1f} {unit}"

    def distance(self, value: float) -> str:
        """Return a flight's length (m) as text; short ones to the centimetre."""
        unit = self.words.distance_unit
        number = value / DISTANCES[unit]
        return f"{number:.{1 if abs(number) >= 30 else 2}f} {unit}"


def speech(name: str) -> Speech:
    """Return how people of a sport speak; raises `InputError` for an unknown one.

    >>> speech("golf").distance(91.44)
    '100.0 yd'
    """
    return Speech(sport(name))


def speaks_otherwise(bat: Implement) -> bool:
    """Return whether the people of its sport use other words and units than those of baseball."""
    return speech(bat.sport).words != Words()

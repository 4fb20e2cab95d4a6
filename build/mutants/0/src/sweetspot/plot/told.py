"""How pictures tell speeds, places and things: in the units and words of the implement's sport."""

from __future__ import annotations

from dataclasses import dataclass

from sweetspot.catalog.sports import sport
from sweetspot.implement import Implement
from sweetspot.sport import Words
from sweetspot.units import INCH, MPH, OUNCE

PLACES = {"in": (INCH, "inches", 3), "cm": (0.01, "centimetres", 10)}
"""Unit of places: its size in m, its name in full, and how many of them lie between ticks."""
SPEEDS = {"mph": (MPH, 1.0, "m/s"), "m/s": (1.0, 0.27777777777777778, "km/h")}
"""Unit of speeds: its size in m/s, and size and name of the other one beside it."""


@dataclass(frozen=True)
class Told:
    """Words and units of one sport."""

    words: Words

    @property
    def speed_size(self) -> float:
        """Size in m/s of the unit of speeds."""
        return SPEEDS[self.words.speed_unit][0]

    @property
    def other_speed(self) -> tuple[float, str]:
        """Size in m/s and name of the other unit, that a second axis shows."""
        return SPEEDS[self.words.speed_unit][1:]

    @property
    def place_size(self) -> float:
        """Size in m of the unit of places."""
        return PLACES[self.words.place_unit][0]

    @property
    def place_long(self) -> str:
        """Name of the unit of places in full."""
        return PLACES[self.words.place_unit][1]

    @property
    def tick_step(self) -> int:
        """How many units of places lie between ticks."""
        return PLACES[self.words.place_unit][2]

    def speed(self, value: float, *, digits: int = 1) -> str:
        """Return a speed (m/s) with its unit."""
        return f"{value / self.speed_size:.{digits}f} {self.words.speed_unit}"

    def place(self, value: float) -> str:
        """Return a distance on the implement (m) with its unit."""
        return f"{value / self.place_size:.1f} {self.words.place_unit}"

    def length(self, value: float) -> str:
        """Return the length (m) of an implement with its unit: inches with two digits, as makers write them."""
        digits = 2 if self.words.place_unit == "in" else 1
        return f"{value / self.place_size:.{digits}f} {self.words.place_unit}"

    def weight(self, value: float) -> str:
        """Return a weight (kg): ounces for people who count in inches, grams for others."""
        return f"{value / OUNCE:.1f} oz" if self.words.place_unit == "in" else f"{1e3 * value:.0f} g"

    def coming(self, speed: float) -> str:
        """Return what comes in: "a 90 mph pitch", or a ball at rest."""
        if not speed > 0:
            return f"a {self.words.incoming} at rest"
        number = f"{speed / self.speed_size:.0f}"
        article = "an" if number.startswith("8") or number in ("11", "18") else "a"
        return f"{article} {number} {self.words.speed_unit} {self.words.incoming}"


def told(bat: Implement) -> Told:
    """Return how the people of its sport are told about an implement."""
    return Told(sport(bat.sport).words)

"""What a comparison says, in plain words: who gains, who loses, and whether corking helps."""

from __future__ import annotations

import math
from typing import NamedTuple

from sweetspot.compare import Compared, Comparison
from sweetspot.implement import Implement
from sweetspot.swing_law import Interval
from sweetspot.trampoline import wall_point_of
from sweetspot.units import INCH, MPH, OUNCE

PUBLISHED_EFFICIENCY = (0.214, 0.193)
"""q of a whole and of the corked bat in the laboratory [nathan2011corked]."""
PUBLISHED_BREAK_EVEN = 2.9 * MPH
"""m/s of bat speed that follows from these two at a 94 mph pitch and 70 mph of bat speed."""
NOTHING = 0.005 * MPH
"""m/s that no table shows."""


class Readers(NamedTuple):
    """The units that a text is written in: size in SI, name and decimals of speeds, weights, lengths."""

    speed: float
    speed_name: str
    speed_digits: int
    mass: float
    mass_name: str
    mass_digits: int
    length: float
    length_name: str

    def number(self, speed: float, sign: str = "") -> str:
        """Return a speed (m/s) without its unit."""
        return f"{speed / self.speed:{sign}z.{self.speed_digits}f}"

    def speeds(self, speed: float, sign: str = "") -> str:
        """Return a speed (m/s) with its unit."""
        return f"{self.number(speed, sign)} {self.speed_name}"

    def weight(self, mass: float) -> str:
        """Return a weight (kg) with its unit."""
        return f"{mass / self.mass:.{self.mass_digits}f} {self.mass_name}"

    def place(self, distance: float) -> str:
        """Return a distance on the bat (m) with its unit."""
        return f"{distance / self.length:.1f} {self.length_name}"

    def between(self, interval: Interval) -> str:
        """Return the ends of an interval of speeds (m/s), without their unit."""
        return f"{self.number(interval.low, '+')} to {self.number(interval.high, '+')}"


US = Readers(MPH, "mph", 1, OUNCE, "oz", 1, INCH, "in")
SI = Readers(1.0, "m/s", 2, 1e-3, "g", 0, 0.01, "cm")


def verdict(comparison: Comparison[Implement], readers: Readers = US) -> list[str]:
    """Return one sentence for every bat after the first."""
    first = comparison.reference
    return [_sentence(found, first, readers) for found in comparison.compared[1:]]


def cork_verdict(comparison: Comparison[Implement], readers: Readers = US) -> list[str]:
    """Return the answer to "does corking help?" for a comparison labelled unmodified, drilled, cork, ...

    The published drop of q and break-even speed stand beside the predicted ones; nothing is fitted to them.
    """
    first = comparison.reference
    corked = next(found for found in comparison.compared if found.label == "cork")
    return [
        _answer(first, corked, comparison, readers),
        _beside_published(first, corked, readers),
        _papers_argument(first, corked),
    ]


def wall_verdict(comparison: Comparison) -> list[str]:
    """Return what another wall does, for a comparison of a hollow bat with itself with that wall."""
    first, other = (wall_point_of(found.analysis) for found in comparison.compared[:2])
    size = "thinner" if other.thickness < first.thickness else "thicker"
    temper = "livelier" if other.bbcor > first.bbcor else "deader"
    return [
        f"Where the ball hits best the wall is {1e3 * other.thickness:.2f} mm thick instead of "
        f"{1e3 * first.thickness:.2f} mm and rings at {other.hoop_frequency:.0f} Hz instead of "
        f"{first.hoop_frequency:.0f} Hz. It takes {100 * other.energy.share:.1f} % of the ball's energy instead of "
        f"{100 * first.energy.share:.1f} % and gives {100 * other.energy.restitution**2:.0f} % of that back in time; "
        f"what it takes, the ball does not lose. BBCOR there goes from {first.bbcor:.3f} to {other.bbcor:.3f}: the "
        f"{size} wall is the {temper} one."
    ]


def _sentence(found: Compared[Implement], first: Compared[Implement], readers: Readers) -> str:
    faster = found.bat_speed.shifted(-first.bat_speed.value)
    text = f"{found.label}: "
    if abs(faster.value) > NOTHING:
        text += f"swung {readers.speeds(abs(faster.value))} {'faster' if faster.value > 0 else 'slower'}, "
    change = found.change
    if max(abs(change.low), abs(change.high)) < NOTHING:
        return text + f"the ball leaves as fast as from {first.label}."
    text += f"the ball leaves {readers.speeds(abs(change.value))} {'faster' if change.value > 0 else 'slower'}"
    if change.low < change.high:
        text += f" ({readers.between(change)})"
    if change.low > 0:
        return text + ": a gain."
    if change.high < 0:
        return text + ": a loss."
    return text + ": the sign is not sure."


def _answer(
    first: Compared[Implement], corked: Compared[Implement], comparison: Comparison[Implement], readers: Readers
) -> str:
    lighter = first.analysis.body.mass - corked.analysis.body.mass
    text = f"Does corking help? The corked bat is {readers.weight(lighter)} lighter"
    if comparison.law is None:
        text += f"; swung no faster, it sends the ball off {readers.speeds(corked.change.value, '+')}. "
        return text + _needed(first, corked, readers)
    gained = corked.bat_speed.shifted(-first.bat_speed.value)
    text += (
        f" and the same player swings it {readers.speeds(gained.value)} faster ({readers.between(gained)}). "
        f"{_needed(first, corked, readers)} Net change of the exit speed: {readers.speeds(corked.change.value, '+')} "
        f"({readers.between(corked.change)}). "
    )
    if corked.change.high < 0:
        return text + "No, the ball leaves slower. What remains is a quicker, later swing, which is not computed here."
    if corked.change.low > 0:
        return text + "Here it does, by this law."
    return text + "Whether it helps cannot be told within the spread of what players do."


def _needed(first: Compared[Implement], corked: Compared[Implement], readers: Readers) -> str:
    more = corked.break_even - first.bat_speed.value
    if math.isnan(more):
        return "No swing is fast enough to break even with it."
    return f"To break even it must be swung {readers.speeds(abs(more))} {'faster' if more > 0 else 'slower'}."


def _beside_published(first: Compared[Implement], corked: Compared[Implement], readers: Readers) -> str:
    whole, after = PUBLISHED_EFFICIENCY
    return (
        f"Predicted and published: the greatest q falls from {first.collision_efficiency:.3f} to "
        f"{corked.collision_efficiency:.3f}, by {first.collision_efficiency - corked.collision_efficiency:.3f}; in the "
        f"laboratory it fell from {whole} to {after}, by {whole - after:.3f}, for another bat. At a 94 mph pitch and "
        f"70 mph of bat speed the published q values need {readers.speeds(PUBLISHED_BREAK_EVEN, '+')} to break even. "
        f"BBCOR changes by {corked.bbcor - first.bbcor:+.3f}: no trampoline. Nothing was fitted to these."
    )


def _papers_argument(first: Compared[Implement], corked: Compared[Implement]) -> str:
    before, after = first.analysis.best, corked.analysis.best
    return (
        "The paper argues with Hooke's law and momentum: a softer bat is pressed in further, so the force F = k x is "
        "greater and acts longer, so F t and with it the ball's change of speed are greater. But a softer spring is "
        "pressed in further by less force, not more. Here the peak force goes from "
        f"{before.peak_force / 1e3:.1f} to {after.peak_force / 1e3:.1f} kN and contact from "
        f"{1e3 * before.contact_time:.3f} to {1e3 * after.contact_time:.3f} ms. What counts is mass: a lighter barrel "
        "is pushed back more and returns less speed to the ball."
    )

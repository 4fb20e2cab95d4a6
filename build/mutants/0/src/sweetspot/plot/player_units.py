"""The unit that each goal of a player is told in."""

from __future__ import annotations

from sweetspot.player.goal import Goal
from sweetspot.units import FOOT, MPH


def scale(goal: Goal) -> tuple[float, int, str]:
    """Return the size in SI of the unit that a goal is told in, digits, and its name."""
    return {"exit-speed": (MPH, 1, "mph"), "carry": (FOOT, 1, "ft"), "line": (0.01, 1, "of 100 swings")}[goal.name]

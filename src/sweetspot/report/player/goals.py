"""What a player wants more of, in words, and its values."""

from __future__ import annotations

from sweetspot.numerics.interval import Interval
from sweetspot.player.goal import Goal
from sweetspot.report.sentences import Sentence, Slot, say, within

GOALS: dict[str, tuple[str, int | None]] = {
    "exit-speed": ("speed_change", None), "carry": ("distance", 1), "line": ("share", 1),
}  # fmt: skip
"""Scale and digits of every goal."""


def goal_words(goal: Goal) -> Sentence:
    """Return what a goal is in words.

    >>> from sweetspot.report.quantities import US
    >>> goal_words(Goal("line", line=91.44)).read(US)
    'hits beyond 300 ft'
    """
    if goal.line is not None:
        return say("hits beyond {line}", line=Slot(goal.line, "distance"))
    return say({"exit-speed": "exit speed", "carry": "carry"}[goal.name])


def pitch_words(speed: float) -> Sentence:
    """Return what comes to be hit.

    >>> from sweetspot.report.quantities import US
    >>> pitch_words(0.0).read(US), pitch_words(26.8).read(US)
    ('ball at rest', '60 mph pitch at the plate')
    """
    return say("{speed} pitch at the plate", speed=Slot(speed, "speed", 0)) if speed else say("ball at rest")


def goal_shown(interval: Interval, goal: Goal, *, sign: bool = False) -> Sentence:
    """Return a value of the goal, or a change of it, with its interval."""
    scale, digits = GOALS[goal.name]
    return within(interval, scale, digits=digits, sign=sign)

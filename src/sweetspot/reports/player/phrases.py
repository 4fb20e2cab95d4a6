"""What a player wants more of and what a bat is that is tried, in words, in the reader's units."""

from __future__ import annotations

from sweetspot.numerics.interval import Interval
from sweetspot.player.candidate import Candidate
from sweetspot.player.goal import Goal
from sweetspot.reports.sentences import Sentence, Slot, say, within

GOALS: dict[str, tuple[str, int | None]] = {
    "exit-speed": ("speed_change", None),
    "carry": ("distance", 1),
    "line": ("share", 1),
}
"""Scale and digits of every goal."""
SCALES = {"weight": "mass", "balance": "mass", "length": "place", "choke": "place"}
"""Of what is changed, by family."""


def goal_words(goal: Goal) -> Sentence:
    """Return a goal in words.

    >>> from sweetspot.reports.quantities import US
    >>> goal_words(Goal("line", line=91.44)).read(US)
    'hits beyond 300 ft'
    """
    if goal.line is not None:
        return say("hits beyond {line:distance}", line=goal.line)
    return say({"exit-speed": "exit speed", "carry": "carry"}[goal.name])


def pitch_words(speed: float) -> Sentence:
    """Return the incoming ball in words.

    >>> from sweetspot.reports.quantities import US
    >>> pitch_words(0.0).read(US), pitch_words(26.8).read(US)
    ('ball at rest', '60 mph pitch at the plate')
    """
    return say("{speed:speed, 0} pitch at the plate", speed=speed) if speed else say("ball at rest")


def goal_shown(interval: Interval, goal: Goal, *, sign: bool = False) -> Sentence:
    """Return a value of the goal, or a change of it, with its interval."""
    scale, digits = GOALS[goal.name]
    return within(interval, scale, digits=digits, sign=sign)


def option_words(candidate: Candidate) -> Sentence:
    """Return a tried bat relative to the player's own, "1 in longer, same weight", or another bat's name."""
    scale = SCALES.get(candidate.family)
    if scale is None:
        return say("{name}", name=candidate.label)
    amount = Slot(abs(candidate.amount), scale, round=True)
    if candidate.family == "balance":
        where = "tip" if candidate.key == "end-loaded" else "knob"
        return say("{amount} at the {where}", amount=amount, where=where)
    if candidate.family == "choke":
        return say("choked up {amount}", amount=amount)
    if candidate.family == "length":
        way = "longer" if candidate.amount > 0 else "shorter"
        return say("{amount} {way}, same weight", amount=amount, way=way)
    return say("{amount} {way}", amount=amount, way="heavier" if candidate.amount > 0 else "lighter")

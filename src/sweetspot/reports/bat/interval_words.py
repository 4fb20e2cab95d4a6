"""How sure the exit speed of a report is, what its interval comes from, and what would narrow it."""

from __future__ import annotations

from sweetspot.answers.report import ReportAnswer
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import REACH, Interval
from sweetspot.reports.measuring_words import what_to_measure
from sweetspot.reports.sentences import Sentence, Slot, listed, say
from sweetspot.reports.sport_words import in_words
from sweetspot.uncertainty.drawn_hits import SpeedDoubt
from sweetspot.uncertainty.sources import BALL_SOURCES, PATCH, PITCH, SWING

MOSTLY, COUNTS = 0.6, 0.1
"""Parts of the variance from which on one thing is most of it, and from which on a thing is named beside others."""


def sureness(report: ReportAnswer, words: Terms) -> Sentence:
    """Return the doubt of the exit speed and its causes; nothing if unknown or if it stands beside the speed."""
    if report.doubt is not None:
        return doubt_words(report.doubt, words)
    if report.half_by_ball is None:
        return say("")
    return in_words(", give or take {half:speed} by the {ball} alone", words, half=report.half_by_ball)


def narrower(report: ReportAnswer) -> Sentence:
    """Return the measurement that makes the exit speed much surer; nothing where none does."""
    whole = report.best_hit.exit_speed
    now = whole.half_width if isinstance(whole, Interval) else float(report.best_hit.exit_speed_half or 0.0)
    return what_to_measure(report.worth_measuring, now)


def doubt_words(doubt: SpeedDoubt, words: Terms) -> Sentence:
    """Return the half width of the interval and what it comes from: ", give or take 6 mph, mostly by the ball"."""
    half = Slot(REACH * doubt.error, "speed")
    parts = _by_thing(doubt, words)
    if len(parts) == 1:
        return say(", give or take {half} by {thing} alone", half=half, thing=next(iter(parts)))
    ranked = sorted(parts, key=lambda thing: -parts[thing])
    if parts[ranked[0]] >= MOSTLY:
        return say(", give or take {half}, mostly by {thing}", half=half, thing=ranked[0])
    things = listed([thing for thing in ranked if parts[thing] >= COUNTS])
    return say(", give or take {half}, by {things}", half=half, things=things)


def _by_thing(doubt: SpeedDoubt, words: Terms) -> dict[str, float]:
    """Return the parts of the variance due to the ball, the implement and the given speeds."""
    parts: dict[str, float] = {}
    for name, share in doubt.shares.items():
        if name in BALL_SOURCES or name == PATCH:
            thing = f"the {words.ball}"
        elif name in (SWING, PITCH):
            thing = "the speeds as they were written"
        else:
            thing = f"the {words.implement}"
        parts[thing] = parts.get(thing, 0.0) + share
    return parts

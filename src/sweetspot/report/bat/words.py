"""The answer in plain words, for any sport: where it hits best, why there and not at the end, what a miss costs."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.bat_analysis import dead_spot
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.answers.report import ReportAnswer
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.sport import Terms
from sweetspot.numerics.interval import Interval, Number
from sweetspot.report.bat.assumed_values import soft_defaults
from sweetspot.report.bat.sure_words import doubt_words
from sweetspot.report.hit.second_touch import best_in_doubt
from sweetspot.report.sentences import Part, Sentence, Slot, joined, say, within
from sweetspot.report.sport_words import arriving, in_words, weight, words_of

LEAST_SHARE = 5e-4
"""Part of the energy below which one decimal of a per cent would say none."""
WHY_BOTH = (
    "These intervals reach from a {ball} that loses its energy by how far it is pressed to one that loses it by how "
    "fast; no measurement has settled which."
)
WHY_TWO = (
    "In brackets: what a {ball} that loses its energy by how fast it is pressed, not by how far, allows as well; no "
    "measurement has settled that."
)
SMALL = 1e-3
"""Relative change of a speed that is told as less than this."""
FOLLOWS = 0.005
"""Below minus this q is called negative."""


def answer_words(report: ReportAnswer) -> list[Sentence]:
    """Return the answer as a few paragraphs; every number that was assumed and not measured is said to be so."""
    analysis, words = report.analysis, words_of(report.analysis.bat)
    paragraphs = (
        _where(report, words), *best_in_doubt(analysis.best, words), _bounce(report, words),
        _why_not_the_end(report, words), _miss(report, words), _hands(report, words), _wall(report),
        soft_defaults(analysis.bat, analysis.conditions.ball, analysis.conditions),
    )  # fmt: skip
    return [words for words in paragraphs if words.parts]


def from_tip(report: ReportAnswer, position: Number) -> Slot:
    """Return how far from the tip a position is."""
    return Slot(report.analysis.bat.length - position, "place")


def cost(loss: Number, *, drawn: bool) -> Sentence:
    """Return a cost with its interval: of draws, or in brackets that of two laws of the ball."""
    if drawn or not isinstance(loss, Interval):
        return Sentence((Slot(loss, "speed"),))
    return within(loss, "speed")


def _sure(report: ReportAnswer, words: Terms) -> Sentence:
    """Return how far the exit speed may be off, and by what; nothing where that is not known, or stands beside it."""
    if report.doubt is not None:
        return doubt_words(report.doubt, words)
    if report.half_by_ball is None:
        return say("")
    return in_words(", give or take {half} by the {ball} alone", words, half=Slot(report.half_by_ball, "speed"))


def _where(report: ReportAnswer, words: Terms) -> Sentence:
    spots, best = report.sweet_spots, report.best_hit
    text = in_words(
        "This {implement} hits best {place} from the {tip}: {coming} leaves at {speed}{doubt}.", words,
        place=from_tip(report, spots.max_exit_speed), coming=arriving(words, float(report.conditions.pitch_speed)),
        speed=Slot(best.exit_speed, "speed"), doubt=_sure(report, words),
    )  # fmt: skip
    if words.smash_factor and best.smash_factor is not None:
        text += in_words(
            " Its {smash_factor}, {exit_speed} over {implement} speed, is {ratio}.", words,
            ratio=Slot(best.smash_factor, "ratio", 2),
        )  # fmt: skip
    if spots.zone is None or spots.zone_width is None:
        return text + in_words(" No stretch is both fast and quiet: there is no {zone} by our measure.", words)
    inner, outer = spots.zone[0], spots.zone[1]
    return text + in_words(
        " The {zone}, within {loss} of that and with less than half the mean vibration at the {hands}, reaches from "
        "{outer} to {inner} from the {tip}, {width} wide.", words,
        loss=Slot(ZONE_LOSS, "speed", round=True),
        outer=from_tip(report, outer).bare,
        inner=from_tip(report, inner),
        width=Slot(spots.zone_width, "place"),
    ) + _outside(float(spots.max_exit_speed), (float(inner), float(outer)), words)  # fmt: skip


def _outside(best: float, zone: tuple[float, float], words: Terms) -> Sentence:
    """Return, where the place that hits best lies outside the zone, on which side of it."""
    if zone[0] <= best <= zone[1]:
        return say("")
    return in_words(
        " The place that hits best lies outside it, nearer the {end}.", words,
        end=words.tip if best > zone[1] else words.hands,
    )  # fmt: skip


def _bounce(report: ReportAnswer, words: Terms) -> Sentence:
    """Return where a ball comes back best and worst, where the sport has words for it, and what a negative q means."""
    parts: list[Sentence] = []
    if words.strongest:
        parts.append(
            in_words(
                "The {strongest} is {place} from the {tip}, where a {implement} at rest gives back {share} of the "
                "speed.", words, place=from_tip(report, report.sweet_spots.max_collision_efficiency),
                share=Slot(report.greatest_efficiency, "share"),
            )
        )  # fmt: skip
    analysis = report.analysis
    dead = dead_spot(analysis)
    if words.deadest and dead is not None:
        parts.append(
            in_words(
                "The {deadest} is {place} from the {tip}: a {ball} there does not come back, for its {thrown} meet "
                "only {met}, and vibration takes more.", words, place=from_tip(report, dead),
                thrown=weight(analysis.conditions.ball.mass), met=weight(effective_mass(analysis.body, dead)),
            )
        )  # fmt: skip
    if float(report.best_hit.collision_efficiency) < -FOLLOWS:
        parts.append(
            in_words(
                "The {efficiency} is negative: the {ball} leaves slower than the {implement} came, and follows it.",
                words,
            )
        )
    return joined(parts)


def _why_not_the_end(report: ReportAnswer, words: Terms) -> Sentence:
    """Return why not at the tip; nothing where that is the fastest place or not the best one's rival."""
    there, face = report.at_the_tip, report.analysis.bat.face
    if there is None:
        return Sentence(())
    springy = face is not None and face.stiffness is not None
    rigid = "" if springy else "A rigid {implement} would send it off at {rigid}. "
    slots: dict[str, Part] = {
        "gain": Slot(there.bat_speed_gain, "speed"),
        "there": Slot(there.effective_mass, "mass"),
        "here": Slot(there.best_effective_mass, "mass"),
        "rigid": Slot(there.rigid_exit_speed, "speed"),
        "real": Slot(there.exit_speed, "speed"),
        "less": Slot(there.exit_speed_loss, "speed"),
    }
    return in_words(
        "Why not at the {tip}? The last place to be hit moves {gain} faster, but there the {implement} gives way by "
        f"turning: the {{ball}} meets only {{there}} instead of {{here}}. {rigid}A real one also bends and keeps that "
        "energy as vibration: {real}, {less} less than at its best.", words, **slots,
    )  # fmt: skip


def _miss(report: ReportAnswer, words: Terms) -> Sentence:
    drawn = report.uncertainty is not None
    costs = [
        in_words(
            "{distance}: {inside} towards the {hands}, {outside} towards the {tip}", words,
            distance=Slot(one.distance, "place", round=True), inside=cost(one.inside, drawn=drawn),
            outside=f"off the {words.implement}" if np.isnan(float(one.outside)) else cost(one.outside, drawn=drawn),
        )
        for one in report.misses
    ]  # fmt: skip
    if not costs:
        return Sentence(())
    return joined([say("What a miss costs: {costs}.", costs=joined(costs, "; ")), why_intervals(words, drawn=drawn)])


def why_intervals(words: Terms, *, drawn: bool) -> Sentence:
    """Return what the intervals of a miss reach over."""
    return in_words(WHY_BOTH if drawn else WHY_TWO, words)


def _hands(report: ReportAnswer, words: Terms) -> Sentence:
    spots, effect, both = report.sweet_spots, float(report.grip_effect), words.hands == "hands"
    size = Slot(effect, "share", 1, sign=True) if abs(effect) >= SMALL else say("less than 0.1 %")
    return in_words(
        f"The {'hands feel' if both else 'hand feels'} least vibration from a hit {{quiet}} from the "
        "{tip} (nodes of the first and second bending mode: {first} and {second}), and no jolt from one at the centre "
        "of percussion, {percussion}. How the {implement} is held hardly matters to the {ball}: "
        f"{'typical hands change' if both else 'a typical hand changes'} its speed by {{size}}.", words,
        quiet=from_tip(report, spots.min_sting),
        first=from_tip(report, spots.node_1).bare,
        second=from_tip(report, spots.node_2),
        percussion=from_tip(report, spots.center_of_percussion), size=size,
    )  # fmt: skip


def _wall(report: ReportAnswer) -> Sentence:
    """Return what a hollow barrel's wall does; how much, not only its frequency, says how lively it is."""
    if report.lowest_hoop is None:
        return Sentence(())
    share = report.best_hit.energy_share.hoop
    return say(
        "It is hollow: its wall gives way and springs back, and rings at {frequency} (lowest hoop mode). Of the energy "
        "of its best hit {left} stay in the wall's ringing.",
        frequency=Slot(report.lowest_hoop, "frequency"),
        left=Slot(share, "share", 1) if float(share) >= LEAST_SHARE else "less than 0.1 %",
    )

"""The answer in plain words, for any sport: where it hits best, why there and not at the end, what a miss costs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, bent_part, dead_spot, too_soft
from sweetspot.analysis.position_scan import Scan
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.answers.report import ReportAnswer
from sweetspot.dynamics.rigid import RigidBody, effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Interval, Number
from sweetspot.reports.bat.interval_words import narrower, sureness
from sweetspot.reports.bat.provenance import soft_defaults
from sweetspot.reports.hit.document import best_in_doubt, curve
from sweetspot.reports.sentences import Line, Part, Sentence, Slot, joined, say, tell, within
from sweetspot.reports.sport_words import arriving, in_words, weight, words_of

LEAST_SHARE = 5e-4
"""Part of the energy below which one decimal of a per cent would say none."""
WHY_IN_BRACKETS = (
    "In brackets: what is left open by how a {ball} loses its energy (90 %), partly by how far it is pressed and "
    "partly by how fast."
)
SMALL = 1e-3
"""Relative change of a speed below which it is reported as less than this."""
FOLLOWS = 0.005
"""Below minus this q is called negative."""


def answer_words(report: ReportAnswer) -> list[Sentence]:
    """Return the answer as a few paragraphs; every number that was assumed and not measured is said to be so."""
    analysis, words = report.analysis, words_of(report.analysis.bat.sport)
    if too_soft(analysis):
        return [_too_soft(analysis, words)]
    paragraphs = (
        _where(report, words),
        *best_in_doubt(analysis.best, words),
        _bounce(report, words),
        _why_not_the_end(report, words),
        _miss(report, words),
        _beside(report, words),
        _hands(report, words),
        _wall(report),
        soft_defaults(analysis.bat.sport, analysis.conditions.ball, analysis.conditions),
    )
    return [words for words in paragraphs if words.parts]


def from_tip(report: ReportAnswer, position: Number) -> Slot:
    """Return the distance of a position from the tip."""
    return Slot(report.analysis.bat.length - position, "place")


def cost(loss: Number, *, drawn: bool) -> Sentence:
    """Return a cost with its interval: of draws, or in brackets that of two laws of the ball."""
    if not np.isfinite(float(loss)):
        return say("the ball stays on it")
    if drawn or not isinstance(loss, Interval):
        return Sentence((Slot(loss, "speed"),))
    return within(loss, "speed")


def _beside(report: ReportAnswer, words: Terms) -> Sentence:
    """Describe how hits beside the middle line change speed and direction; nothing for what has no flat face."""
    if not report.off_center:
        return say("")
    misses = [
        say(
            "{lateral:place, round} beside it {speed:speed}, {aside} to that side{curve}",
            lateral=hit.lateral,
            speed=hit.exit_speed,
            aside=Slot(hit.aside, "angle", 1),
            curve=curve(hit.gear_spin),
        )
        for hit in report.off_center
    ]
    return in_words(
        "Beside the middle line the face turns under the {ball}. In the middle of the face: {misses}.",
        words,
        misses=joined(misses, "; "),
    )


def _too_soft(analysis: Analysis[Implement], words: Terms) -> Sentence:
    """Return the sentence in place of an answer that would be none."""
    if not np.isfinite(bent_part(analysis)):
        return in_words("No {ball} leaves this {implement} in what is computed here: it is too soft.", words)
    return in_words(
        "This {implement} bends by {part:share} of its length while the {ball} is on it. What is computed here is for "
        "implements that bend by a hundredth at most: the speeds below predict nothing.",
        words,
        part=bent_part(analysis),
    )


def _where(report: ReportAnswer, words: Terms) -> Sentence:
    spots, best = report.sweet_spots, report.best_hit
    text = in_words(
        "This {implement} hits best {place} from the {tip}: {coming} leaves at {speed:speed}{doubt}.",
        words,
        place=from_tip(report, spots.max_exit_speed),
        coming=arriving(words, float(report.conditions.pitch_speed)),
        speed=best.exit_speed,
        doubt=sureness(report, words),
    ) + narrower(report)
    if words.smash_factor and best.smash_factor is not None:
        text += in_words(
            " Its {smash_factor}, {exit_speed} over {implement} speed, is {ratio:ratio, 2}.",
            words,
            ratio=best.smash_factor,
        )
    if spots.zone is None or spots.zone_width is None:
        return text + in_words(" No stretch is both fast and quiet: there is no {zone} by our measure.", words)
    inner, outer = spots.zone[0], spots.zone[1]
    return (
        text
        + in_words(
            " The {zone}, within {loss:speed, round} of that and with less than half the mean vibration at the "
            "{hands}, reaches from {outer} to {inner} from the {tip}, {width:place} wide.",
            words,
            loss=ZONE_LOSS,
            outer=from_tip(report, outer).bare,
            inner=from_tip(report, inner),
            width=spots.zone_width,
        )
        + _outside(float(spots.max_exit_speed), (float(inner), float(outer)), words)
    )


def _outside(best: float, zone: tuple[float, float], words: Terms) -> Sentence:
    """Return on which side of the zone the best place lies, if outside it."""
    if zone[0] <= best <= zone[1]:
        return say("")
    return in_words(
        " The place that hits best lies outside it, nearer the {end}.",
        words,
        end=words.tip if best > zone[1] else words.hands,
    )


def _bounce(report: ReportAnswer, words: Terms) -> Sentence:
    """Return the places of greatest q and of the dead spot, if the sport names them, and what a negative q means."""
    parts: list[Sentence] = []
    if words.strongest:
        parts.append(
            in_words(
                "The {strongest} is {place} from the {tip}, where a {implement} at rest gives back {share:share} of "
                "the speed.",
                words,
                place=from_tip(report, report.sweet_spots.max_collision_efficiency),
                share=report.greatest_efficiency,
            )
        )
    analysis = report.analysis
    dead = dead_spot(analysis)
    if words.deadest and dead is not None:
        parts.append(
            in_words(
                "The {deadest} is {place} from the {tip}: a {ball} there does not come back, for its {thrown} meet "
                "only {met}, and vibration takes more.",
                words,
                place=from_tip(report, dead),
                thrown=weight(analysis.conditions.ball.mass),
                met=weight(effective_mass(analysis.body, dead)),
            )
        )
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
        "Why not at the {tip}? The last place to be hit moves {gain} faster, but there the {implement} recoils by "
        f"turning: the {{ball}} meets only {{there}} instead of {{here}}. {rigid}A real one also bends and keeps that "
        "energy as vibration: {real}, {less} less than at its best.",
        words,
        **slots,
    )


def _miss(report: ReportAnswer, words: Terms) -> Sentence:
    drawn = report.uncertainty is not None
    best, end = float(report.sweet_spots.max_exit_speed), float(report.scan.position[-1])
    costs = [
        miss_words(
            float(miss.distance),
            cost(miss.inside, drawn=drawn),
            None if best + float(miss.distance) > end else cost(miss.outside, drawn=drawn),
            words,
        )
        for miss in report.misses
    ]
    return joined([misses_words(costs), why_in_brackets(report, words)]) if costs else Sentence(())


def miss_words(distance: float, inside: Sentence, outside: Sentence | None, words: Terms) -> Sentence:
    """Return the cost of missing the best place by ``distance`` m; ``outside`` None: nothing is hit there."""
    off = f"off the {words.implement}" if outside is None else outside
    template = "{distance:place, round}: {inside} towards the {hands}, {outside} towards the {tip}"
    return in_words(template, words, distance=distance, inside=inside, outside=off)


def misses_words(costs: Sequence[Sentence]) -> Sentence:
    """Return the costs of misses, one after the other."""
    return say("What a miss costs: {costs}.", costs=joined(costs, "; "))


def why_in_brackets(report: ReportAnswer, words: Terms) -> Sentence:
    """Return the explanation of the intervals of misses where no draws were made; empty where there are none."""
    ends = any(isinstance(cost, Interval) for miss in report.misses for cost in (miss.inside, miss.outside))
    return in_words(WHY_IN_BRACKETS, words) if ends and report.uncertainty is None else say("")


def _hands(report: ReportAnswer, words: Terms) -> Sentence:
    spots, effect, both = report.sweet_spots, float(report.grip_effect), words.hands == "hands"
    size = Slot(effect, "share", 1, sign=True) if abs(effect) >= SMALL else say("less than 0.1 %")
    return in_words(
        f"The {'hands feel' if both else 'hand feels'} least vibration from a hit {{quiet}} from the "
        "{tip} (nodes of the first and second bending mode: {first} and {second}), and no jolt from one at the centre "
        "of percussion, {percussion}. How the {implement} is held hardly matters to the {ball}: "
        f"{'typical hands change' if both else 'a typical hand changes'} its speed by {{size}}.",
        words,
        quiet=from_tip(report, spots.min_sting),
        first=from_tip(report, spots.node_1).bare,
        second=from_tip(report, spots.node_2),
        percussion=from_tip(report, spots.center_of_percussion),
        size=size,
    )


def _wall(report: ReportAnswer) -> Sentence:
    """Return the ringing of a hollow barrel's wall: its lowest frequency and its share of the energy."""
    if report.lowest_hoop is None:
        return Sentence(())
    share = report.best_hit.energy_share.hoop
    return say(
        "It is hollow: its wall deflects and springs back, and rings at {frequency:frequency} (lowest hoop mode). Of "
        "the energy of its best hit {left} stay in the wall's ringing.",
        frequency=report.lowest_hoop,
        left=Slot(share, "share", 1) if float(share) >= LEAST_SHARE else "less than 0.1 %",
    )


NEAR = 0.006
"""m from the best place within which a hit counts as the best one."""
LITTLE = 0.05
"""m/s below which a part of the difference is not mentioned."""


@dataclass(frozen=True)
class SpeedDifference:
    """Contributions to a place's exit speed, against the best place, m/s; the parts sum to ``whole``.

    Parameters
    ----------
    motion : the place moves faster or slower: (1 + q_r) of the change, q_r of a rigid bat at the best place.
    giving : a rigid bat there is lighter or heavier to the ball.
    keeping : the real bat bends, and its wall rings, more or less than at the best place.
    """

    position: float
    motion: float
    giving: float
    keeping: float

    @property
    def whole(self) -> float:
        """The difference, m/s: below zero where the ball leaves slower than at the best place."""
        return self.motion + self.giving + self.keeping


def speed_difference(scan: Scan, position: float, *, best: float, exit_speed: float | None = None) -> SpeedDifference:
    """Return the contributions to the exit speed at a place (m from the knob end), against the best place.

    Parameters
    ----------
    exit_speed : m/s of a hit at that very place, where one was made; None: between the neighbours in the scan, which
        is wrong next to where a ball begins to be touched twice, since exit speeds jump there.
    """

    def at(values: Array, place: float) -> float:
        return float(np.interp(place, scan.position, values))

    rigid = at(scan.rigid_exit_speed, position) - at(scan.rigid_exit_speed, best)
    real = (at(scan.exit_speed, position) if exit_speed is None else exit_speed) - at(scan.exit_speed, best)
    motion = (1 + at(scan.rigid_efficiency, best)) * (at(scan.bat_speed, position) - at(scan.bat_speed, best))
    return SpeedDifference(position, motion, rigid - motion, real - rigid)


def why_here(
    difference: SpeedDifference,
    *,
    body: RigidBody,
    conditions: Conditions,
    best: float,
    words: Terms,
    in_the_middle: bool = True,
) -> Sentence:
    """Return why a ball met in the middle leaves a place as it does, with what each reason costs.

    Parameters
    ----------
    in_the_middle : whether the ball that is asked about is met so; else the best place is said to be that of others.
    """
    place = difference.position
    here, there = float(effective_mass(body, place)), float(effective_mass(body, best))
    near, vibrates = abs(place - best) < NEAR, abs(difference.keeping) > LITTLE
    faster = conditions.swing.speed_at(place) - conditions.swing.speed_at(best)
    return tell(
        WHY_HERE,
        **words.model_dump(),
        near=near,
        near_in_the_middle=near and in_the_middle,
        near_but_met_off_axis=near and not in_the_middle,
        faster_here=not near and faster > 0,
        slower_here=not near and not faster > 0,
        keeping_told=not near and vibrates,
        keeping_untold=not near and not vibrates,
        keeps_more=not near and vibrates and difference.keeping < 0,
        keeps_less=not near and vibrates and not difference.keeping < 0,
        change=abs(faster),
        motion=difference.motion,
        giving=difference.giving,
        keeping=difference.keeping,
        together=difference.whole,
        met_here=weight(here),
        met_there=weight(there),
        whole_mass=weight(body.mass),
    )


WHY_HERE = (
    Line("This is", when="near_in_the_middle"),
    Line("For a {ball} met in the middle this is", when="near_but_met_off_axis"),
    Line(
        " the best place along the {implement}: further out it moves faster but recoils more and bends more, further "
        "in it moves slower. The {ball} meets {met_here} of {whole_mass}.",
        when="near",
    ),
    Line("Against the best place the {implement} moves {change:speed}", unless="near"),
    Line(" faster", when="faster_here"),
    Line(" slower", when="slower_here"),
    Line(" here ({motion:speed, sign}),", unless="near"),
    Line(" and", when="keeping_untold"),
    Line(" the {ball} meets {met_here} instead of {met_there} of it ({giving:speed, sign})", unless="near"),
    Line(", and it keeps", when="keeping_told"),
    Line(" more", when="keeps_more"),
    Line(" less", when="keeps_less"),
    Line(" as vibration ({keeping:speed, sign})", when="keeping_told"),
    Line(": together {together:speed, sign}.", unless="near"),
)
"""Why a ball met in the middle leaves a place as it does; see `why_here`."""


def why_off_axis(offset: float, cost: float, *, words: Terms) -> Sentence:
    """Return the cost (m/s) of a ball whose centre lies ``offset`` (m) off the implement's axis."""
    side, amount = "above" if offset > 0 else "below", "less" if cost < 0 else "more"
    result = "leaves as fast as from the middle."
    if abs(cost) > LITTLE:
        result = f"gets {amount} of the swing ({{cost:speed, sign}})."
    template = f"Met {{offset:length}} {side} the middle, the {{ball}} {result}"
    return in_words(template, words, offset=abs(offset), cost=cost)


def why_backwards(offset: float, *, words: Terms) -> Sentence:
    """Return why a ball that is met so far off the implement's axis, m, leaves behind the batter."""
    template = f"Met {{offset}} {'above' if offset > 0 else 'below'} the middle, the {{ball}} "
    return in_words(
        template + "glances off the {implement} and goes on backwards.", words, offset=Slot(abs(offset), "length")
    )

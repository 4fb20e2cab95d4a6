"""The answer in plain words, for any sport: where it hits best, why there and not at the end, what a miss costs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from sweetspot.analysis.bat_analysis import Analysis, dead_spot, exit_speed_of
from sweetspot.analysis.miss_cost import Loss, miss_costs
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.calibration.ball_doubt import speed_by_ball
from sweetspot.calibration.draws.linear_doubt import SpeedDoubt
from sweetspot.dynamics.rigid import effective_mass
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Words
from sweetspot.numerics.interval import Interval
from sweetspot.report.bat.assumed_values import soft_defaults
from sweetspot.report.bat.sure_words import doubt_words
from sweetspot.report.hit.second_touch import best_in_doubt
from sweetspot.report.sentences import Part, Sentence, Slot, joined, say, within
from sweetspot.report.sport_words import arriving, in_words, weight, words_of
from sweetspot.units import INCH

MISSES = {"in": (1 * INCH, 2 * INCH, 3 * INCH), "cm": (0.02, 0.04, 0.06)}
"""m, by the unit in which a sport's people read places; half of that on faces too short for two of them."""
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
BEST_PLACE, BEST_SPEED = "sweet_spots.max_exit_speed_m", "best_hit.exit_speed_m_s"
"""Where the answer is in the data."""
SMALL = 1e-3
"""Relative change of a speed that is told as less than this."""
FOLLOWS = 0.005
"""Below minus this q is called negative."""


class Miss(NamedTuple):
    """What a miss by ``distance`` (m) costs, towards the hands and towards the tip."""

    distance: float
    inside: Loss
    outside: Loss


def misses_of(analysis: Analysis[Implement]) -> list[Miss]:
    """Return what misses cost that still hit the face on the hands' side, up to three."""
    best, nearest = analysis.sweet_spots.max_exit_speed, float(analysis.scan.position[0])
    usual = MISSES[words_of(analysis.bat).place_unit]
    fitting = [tuple(part * one for one in usual if best - part * one >= nearest) for part in (1.0, 0.5)]
    distances = fitting[0] if len(fitting[0]) > 1 else fitting[1]  # half as far on a short face
    costs = miss_costs(analysis, distances) if distances else []
    return [Miss(distance, *both) for distance, both in zip(distances, costs, strict=True)]


def answer(
    analysis: Analysis[Implement], misses: Sequence[Miss], *, doubt: SpeedDoubt | None = None, drawn: bool = False
) -> list[Sentence]:
    """Return the answer as a few paragraphs; every number that was assumed and not measured is said to be so.

    Parameters
    ----------
    doubt : how sure the exit speed is, and by what; None: it is told how far it may be off by the ball alone, which is
        the quickest.
    drawn : whether intervals of draws take the place of that.
    """
    words = words_of(analysis.bat)
    sure = say("") if drawn else _by_ball(analysis) if doubt is None else doubt_words(doubt, words)
    paragraphs = (
        _where(analysis, words, sure), *best_in_doubt(analysis.best, words), _bounce(analysis, words),
        _why_not_the_end(analysis, words), _miss(misses, words, drawn=drawn), _hands(analysis, words), _wall(analysis),
        soft_defaults(analysis.bat, analysis.conditions.ball, analysis.conditions),
    )  # fmt: skip
    return [words for words in paragraphs if words.parts]


def from_tip(analysis: Analysis[Implement], position: float, of: str = "") -> Slot:
    """Return how far from the tip a position is; ``of`` as in `Slot`."""
    return Slot(analysis.bat.length - position, "place", of=f"-{of}" if of else "")


def cost(loss: Loss, of: str) -> Sentence:
    """Return a cost and its interval; ``of`` as in `Slot`."""
    return within(Interval(loss.value, loss.low, loss.high), "speed", of=of)


def hand_and_tip(number: int) -> tuple[str, str]:
    """Return the names of what a miss costs either way, as draws have them."""
    return f"misses.{number}.inside_m_s", f"misses.{number}.outside_m_s"


def _by_ball(analysis: Analysis[Implement]) -> Sentence:
    """Return how far the exit speed may be off by the ball alone; nothing where that is not known."""
    speed = speed_by_ball(analysis)
    if speed is None:
        return say("")
    words = words_of(analysis.bat)
    return in_words(", give or take {half} by the {ball} alone", words, half=Slot(speed.high - speed.value, "speed"))


def _where(analysis: Analysis[Implement], words: Words, sure: Sentence) -> Sentence:
    spots, best, conditions = analysis.sweet_spots, analysis.best, analysis.conditions
    leaves, swung = exit_speed_of(best, conditions), conditions.swing.speed_at(best.position)
    text = in_words(
        "This {implement} hits best {place} from the {tip}: {coming} leaves at {speed}{doubt}.", words,
        place=from_tip(analysis, spots.max_exit_speed, BEST_PLACE), coming=arriving(words, conditions.pitch.speed),
        speed=Slot(leaves, "speed", of=BEST_SPEED), doubt=sure,
    )  # fmt: skip
    if words.smash_factor and swung:
        text += in_words(
            " Its {smash_factor}, {exit_speed} over {implement} speed, is {ratio}.", words,
            ratio=Slot(leaves / swung, "ratio", 2, of="best_hit.smash_factor"),
        )  # fmt: skip
    if spots.zone is None:
        return text + in_words(" No stretch is both fast and quiet: there is no {zone} by our measure.", words)
    return text + in_words(
        " The {zone}, within {loss} of that and with less than half the mean vibration at the {hands}, reaches from "
        "{outer} to {inner} from the {tip}, {width} wide.", words,
        loss=Slot(ZONE_LOSS, "speed", round=True),
        outer=from_tip(analysis, spots.zone[1], "sweet_spots.zone_end_m").bare,
        inner=from_tip(analysis, spots.zone[0], "sweet_spots.zone_start_m"),
        width=Slot(spots.zone[1] - spots.zone[0], "place", of="sweet_spots.zone_width_m"),
    ) + _outside(spots.max_exit_speed, spots.zone, words)  # fmt: skip


def _outside(best: float, zone: tuple[float, float], words: Words) -> Sentence:
    """Return, where the place that hits best lies outside the zone, on which side of it."""
    if zone[0] <= best <= zone[1]:
        return say("")
    return in_words(
        " The place that hits best lies outside it, nearer the {end}.", words,
        end=words.tip if best > zone[1] else words.hands,
    )  # fmt: skip


def _bounce(analysis: Analysis[Implement], words: Words) -> Sentence:
    """Return where a ball comes back best and worst, where the sport has words for it, and what a negative q means."""
    parts: list[Sentence] = []
    if words.strongest:
        most = float(np.nanmax(analysis.scan.collision_efficiency))
        parts.append(
            in_words(
                "The {strongest} is {place} from the {tip}, where a {implement} at rest gives back {share} of the "
                "speed.", words,
                place=from_tip(
                    analysis, analysis.sweet_spots.max_collision_efficiency, "sweet_spots.max_collision_efficiency_m"
                ),
                share=Slot(most, "share", of="told.max_collision_efficiency"),
            )
        )  # fmt: skip
    dead = dead_spot(analysis)
    if words.deadest and dead is not None:
        parts.append(
            in_words(
                "The {deadest} is {place} from the {tip}: a {ball} there does not come back, for its {thrown} meet "
                "only {met}, and vibration takes more.", words, place=from_tip(analysis, dead),
                thrown=weight(analysis.conditions.ball.mass), met=weight(effective_mass(analysis.body, dead)),
            )
        )  # fmt: skip
    if analysis.best.collision_efficiency < -FOLLOWS:
        parts.append(
            in_words(
                "The {efficiency} is negative: the {ball} leaves slower than the {implement} came, and follows it.",
                words,
            )
        )
    return joined(parts)


def _why_not_the_end(analysis: Analysis[Implement], words: Words) -> Sentence:
    """Return why not at the tip; nothing where that is the fastest place or not the best one's rival."""
    scan, body, swing = analysis.scan, analysis.body, analysis.conditions.swing
    best, last = analysis.sweet_spots.max_exit_speed, float(scan.position[-1])
    top, end = exit_speed_of(analysis.best, analysis.conditions), float(scan.exit_speed[-1])
    gain = swing.speed_at(last) - swing.speed_at(best)
    if not gain > 0 or not top > end:
        return Sentence(())
    face = analysis.bat.face
    springy = face is not None and face.stiffness is not None
    rigid = "" if springy else "A rigid {implement} would send it off at {rigid}. "
    slots: dict[str, Part] = {
        "gain": Slot(gain, "speed", of="told.gain_m_s"),
        "there": Slot(effective_mass(body, last), "mass", of="told.effective_mass_end_kg"),
        "here": Slot(effective_mass(body, best), "mass", of="told.effective_mass_best_kg"),
        "rigid": Slot(float(scan.rigid_exit_speed[-1]), "speed", of="told.end_rigid_exit_speed_m_s"),
        "real": Slot(end, "speed", of="told.end_exit_speed_m_s"),
        "less": Slot(top - end, "speed", of="told.less_m_s"),
    }  # fmt: skip
    return in_words(
        "Why not at the {tip}? The last place to be hit moves {gain} faster, but there the {implement} gives way by "
        f"turning: the {{ball}} meets only {{there}} instead of {{here}}. {rigid}A real one also bends and keeps that "
        "energy as vibration: {real}, {less} less than at its best.", words, **slots,
    )  # fmt: skip


def _miss(misses: Sequence[Miss], words: Words, *, drawn: bool) -> Sentence:
    costs = [
        in_words(
            "{distance}: {inside} towards the {hands}, {outside} towards the {tip}", words,
            distance=Slot(one.distance, "place", round=True), inside=cost(one.inside, hand_and_tip(number)[0]),
            outside=f"off the {words.implement}" if np.isnan(one.outside.value)
            else cost(one.outside, hand_and_tip(number)[1]),
        )
        for number, one in enumerate(misses)
    ]  # fmt: skip
    if not costs:
        return Sentence(())
    return joined([say("What a miss costs: {costs}.", costs=joined(costs, "; ")), why_intervals(words, drawn=drawn)])


def why_intervals(words: Words, *, drawn: bool) -> Sentence:
    """Return what the intervals of a miss reach over."""
    return in_words(WHY_BOTH if drawn else WHY_TWO, words)


def _hands(analysis: Analysis[Implement], words: Words) -> Sentence:
    spots, effect, both = analysis.sweet_spots, analysis.grip_effect, words.hands == "hands"
    size = Slot(effect, "share", 1, sign=True) if abs(effect) >= SMALL else say("less than 0.1 %")
    return in_words(
        f"The {'hands feel' if both else 'hand feels'} least vibration from a hit {{quiet}} from the "
        "{tip} (nodes of the first and second bending mode: {first} and {second}), and no jolt from one at the centre "
        "of percussion, {percussion}. How the {implement} is held hardly matters to the {ball}: "
        f"{'typical hands change' if both else 'a typical hand changes'} its speed by {{size}}.", words,
        quiet=from_tip(analysis, spots.min_sting, "sweet_spots.min_sting_m"),
        first=from_tip(analysis, spots.node_1, "sweet_spots.node_1_m").bare,
        second=from_tip(analysis, spots.node_2, "sweet_spots.node_2_m"),
        percussion=from_tip(analysis, spots.center_of_percussion, "sweet_spots.center_of_percussion_m"), size=size,
    )  # fmt: skip


def _wall(analysis: Analysis[Implement]) -> Sentence:
    """Return what a hollow barrel's wall does; how much, not only its frequency, says how lively it is."""
    hoops = analysis.modes.of_family("hoop")
    if not hoops:
        return Sentence(())
    energy = analysis.best.energy
    share = energy.hoop / energy.incoming if energy.incoming else 0.0
    left = Slot(share, "share", 1, of="best_hit.energy_share.hoop")
    return say(
        "It is hollow: its wall gives way and springs back, and rings at {frequency} (lowest hoop mode). Of the energy "
        "of its best hit {left} stay in the wall's ringing.",
        frequency=Slot(float(analysis.modes.frequency[hoops].min()), "frequency", of="told.lowest_hoop_hz"),
        left=left if share >= LEAST_SHARE else "less than 0.1 %",
    )  # fmt: skip

"""What a comparison says, in plain words: who gains, who loses, and whether corking helps."""

from __future__ import annotations

import math

from sweetspot.analysis.comparison import Comparison
from sweetspot.analysis.trampoline import wall_point_of
from sweetspot.answers.compare import BatGain, CompareAnswer, ComparedBat
from sweetspot.catalog.sports import sport
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.interval import ENDS, NO_SPEED, Interval, Number, interval_of, sure_sign
from sweetspot.reports.sentences import Sentence, Slot, joined, say, within
from sweetspot.reports.uncertainty.section import chance_words
from sweetspot.units import MPH

SURE = ENDS[1]
"""Chance from which on a difference is called sure: its 90 % interval leaves zero out."""
PUBLISHED_EFFICIENCY = (0.214, 0.193)
"""q of a whole and of the corked bat in the laboratory [nathan2011corked]."""
PUBLISHED_BREAK_EVEN = 2.9 * MPH
"""m/s of bat speed that follows from these two at a 94 mph pitch and 70 mph of bat speed."""


def verdict(answer: CompareAnswer) -> list[Sentence]:
    """Return one sentence for every bat after the first, whether its gain or loss is sure.

    What is not in the intervals is taken as described, and a sentence says itself that it holds only if that is so.
    """
    sentences = []
    for index, each in enumerate(answer.bats[1:], start=1):
        taken = [answer.bats[which].label for which in (0, index) if not answer.sources[which].unknowns]
        given = f" if {' and '.join(taken)} {'is' if len(taken) == 1 else 'are'} just as described" if taken else ""
        sentences.append(_sentence(answer, each, given=given))
    return sentences


def changes(answer: CompareAnswer) -> list[Sentence]:
    """Return one sentence for every bat after the first, without a word on how sure it is."""
    return [_change_words(answer, bat) + "." for bat in answer.bats[1:]]


def fastest_places(comparison: Comparison) -> Sentence:
    """Return where on each bat the ball leaves fastest."""
    places = [
        say("{label} hits fastest {place} from the tip", label=compared.label, place=Slot(from_tip, "place"))
        for compared in comparison.compared
        for from_tip in [compared.analysis.bat.length - compared.analysis.sweet_spots.max_exit_speed]
    ]
    return say("The bats to scale, tips aligned. {places}.", places=joined(places, "; "))


def speed_changes(answer: CompareAnswer) -> Sentence:
    """Return the change of each bat's exit speed against the first one's, with its interval."""
    rows = []
    for bat in answer.bats[1:]:
        change, ends = interval_of(bat.change), say("")
        if change.low < change.high:
            low, high = (_change(end) for end in (change.low, change.high))
            ends = say(", interval {low} to {high}", low=low, high=high)
        rows.append(say("{label} {change}{ends}", label=bat.label, change=_change(change.value), ends=ends))
    return say("Change of exit speed against {first}: {rows}.", first=answer.reference, rows=joined(rows, "; "))


def gain_words(gain: BatGain, reference: str) -> Sentence:
    """Return how probable it is that a bat's exit speed is higher than that of the first, hit by the same ball."""
    chance = gain.faster_probability
    sure = "surely a difference" if max(chance, 1 - chance) >= SURE else "not surely a difference"
    return say(
        "Hit by the same ball, {name} is faster than {reference} with a probability of {chance}: {verdict}.",
        name=gain.label, reference=reference, chance=chance_words(chance), verdict=sure,
    )  # fmt: skip


def cork_verdict(answer: CompareAnswer) -> list[Sentence]:
    """Return the answer to "does corking help?" for a comparison labelled unmodified, drilled, cork, ...

    The published drop of q and break-even speed stand beside the predicted ones; nothing is fitted to them.
    """
    first, corked = answer.bats[0], next(bat for bat in answer.bats if bat.label == "cork")
    return [_answer(first, corked, answer), _beside_published(first, corked), _papers_argument(first, corked)]


def wall_verdict(comparison: Comparison) -> list[Sentence]:
    """Return the effect of another wall, for a comparison of a hollow bat with itself with that wall."""
    first, other = (wall_point_of(compared.analysis) for compared in comparison.compared[:2])
    return [
        say(
            "Where the ball hits best the wall is {thin} thick instead of {before} and rings at {rings} instead of "
            "{rang}. It takes {share} of the ball's energy instead of {shared} and gives {back} of that back in time; "
            "what it takes, the ball does not lose. BBCOR in play there goes from {low} to {high}: the {size} wall is "
            "the {temper} one.",
            thin=Slot(other.thickness, "compression", 2), before=Slot(first.thickness, "compression", 2),
            rings=Slot(other.hoop_frequency, "frequency"), rang=Slot(first.hoop_frequency, "frequency"),
            share=Slot(other.energy.share, "share", 1), shared=Slot(first.energy.share, "share", 1),
            back=Slot(other.energy.restitution**2, "share"), low=Slot(first.bbcor, "ratio"),
            high=Slot(other.bbcor, "ratio"), size="thinner" if other.thickness < first.thickness else "thicker",
            temper="livelier" if other.bbcor > first.bbcor else "deader",
        )
    ]  # fmt: skip


def assumptions(answer: CompareAnswer) -> Sentence:
    """Return the conditions of the computation."""
    reference, law = answer.comparison.reference.analysis, answer.comparison.law
    words, conditions = sport(reference.bat.sport).words, reference.conditions
    tool, pitch = words.implement, conditions.pitch.speed
    greatest = (
        "q and BBCOR in play are the greatest on the barrel" if isinstance(reference.bat, Bat) else "q is the greatest"
    )
    text = say(
        "The {ball} {comes}. The {tool}'s speed is that {place} from the {tip}; {greatest} at this swing's closing "
        "speed. Break-even: the {tool} speed with which the ball leaves as fast as from the first {tool}.",
        ball=words.incoming, comes=say("comes at {speed}", speed=Slot(pitch, "speed")) if pitch else "is at rest",
        tool=tool, place=Slot(reference.bat.length - conditions.swing.measured_at, "place"), tip=words.tip,
        greatest=greatest,
    )  # fmt: skip
    if law is None:
        return text + f" Every {tool} is swung at the same speed, as no player does with unequal ones."
    foreign = "" if isinstance(reference.bat, Bat) else "; no law of this sport's own players is used"
    return text + say(
        " Same effort: {tool} speed goes as the moment of inertia about {axis} to the power -{power} ({law})"
        "{foreign}.",
        tool=tool, axis=_axis(law.axis, words.butt), power=f"{law.exponent:g}", law=law.name, foreign=foreign,
    )  # fmt: skip


def assumed(answer: CompareAnswer, *, draws: str) -> Sentence:
    """Return the conditions of the computation, and what the intervals include.

    Parameters
    ----------
    draws : where draws are, for intervals that come from none.
    """
    held = [without_draws(answer, draws)] if answer.uncertainty is None else []
    return joined([assumptions(answer), *held, *taken_as_described(answer)])


def without_draws(answer: CompareAnswer, draws: str) -> Sentence:
    """Return a sentence on the intervals in brackets, which come from no draws, and on how to get drawn ones."""
    law, words = answer.comparison.law, sport(answer.comparison.reference.analysis.bat.sport).words
    power = "" if law is None else say(
        ", and of the power (-{low} to -{high})",
        low=Slot(law.exponents.low, "ratio", 2), high=Slot(law.exponents.high, "ratio", 2),
    )  # fmt: skip
    return say(
        "In brackets: 90 % intervals of what is not known of {tool}s and {ball}{power}, each taken one standard "
        "deviation up and down; {draws} draws them and says what they come from.",
        draws=draws, tool=words.implement, ball=words.ball, power=power,
    )  # fmt: skip


def taken_as_described(answer: CompareAnswer) -> list[Sentence]:
    """Return of which of them no doubt is in the intervals, bat by bat; none: of every one it is."""
    every = zip(answer.bats, answer.sources, strict=True)
    return [
        say("{label} is {where}.", label=each.label, where=its.bat_where) for each, its in every if not its.unknowns
    ]


def _axis(axis: float, butt: str) -> Sentence:
    if axis == 0:
        return say("the {butt}", butt=butt)
    return say("{place} above the bottom of the grip", place=Slot(axis, "place"))


def _change(speed: Number, *, sign: bool = False) -> Slot:
    return Slot(speed, "speed_change", sign=sign)


def _change_words(answer: CompareAnswer, bat: ComparedBat) -> Sentence:
    """Return how much faster a bat is swung and the ball leaves, as far as it goes without an end."""
    faster, change = float(bat.swung_faster), float(bat.change)
    swung = say("")
    if abs(faster) > NO_SPEED:
        much: Number = bat.swung_faster if faster > 0 else -bat.swung_faster
        much = float(much) if answer.uncertainty is None else much
        swung = say("swung {speed} {way}, ", speed=_change(much), way="faster" if faster > 0 else "slower")
    text = say("{label}: {swung}the ball leaves ", label=bat.label, swung=swung)
    if abs(change) < NO_SPEED:
        return text + f"as fast as from {answer.reference}"
    return text + say("{speed} {way}", speed=_change(abs(change)), way="faster" if change > 0 else "slower")


def _sentence(answer: CompareAnswer, bat: ComparedBat, *, given: str) -> Sentence:
    change, text = interval_of(bat.change), _change_words(answer, bat)
    if max(abs(change.value), abs(change.low) / 3, abs(change.high) / 3) < NO_SPEED:
        return text + "."
    if change.low < change.high:
        text += say(" ({ends})", ends=_ends(change))
    if sign := sure_sign(change.low, change.high, nothing=NO_SPEED):
        return text + say(": a {gain}{given}.", gain="gain" if sign > 0 else "loss", given=given)
    return text + ": the sign is not sure."


def _ends(change: Interval) -> Sentence:
    low, high = (_change(end, sign=True).bare for end in (change.low, change.high))
    return say("{low} to {high}", low=low, high=high)


def _answer(first: ComparedBat, corked: ComparedBat, answer: CompareAnswer) -> Sentence:
    change = interval_of(corked.change)
    lighter = Slot(float(first.bat.mass) - float(corked.bat.mass), "mass")
    text = say("Does corking help? The corked bat is {mass} lighter", mass=lighter)
    if answer.swing_law is None:
        sent = say("; swung no faster, it sends the ball off {speed}.", speed=_change(change.value, sign=True))
        return joined([text + sent, _needed(first, corked)])
    gained = interval_of(corked.swung_faster)
    swung = say(" and the same player swings it {speed} faster", speed=_change(gained.value))
    swung += say(" ({ends}).", ends=_ends(gained))
    net = say("Net change of the exit speed: {change}.", change=within(change, "speed_change", sign=True))
    sign = sure_sign(change.low, change.high, nothing=NO_SPEED)
    if sign < 0:
        end = "No: the ball leaves slower. What remains is a quicker, later swing, which is not computed here."
    elif sign > 0:
        end = "Here it does."
    else:
        end = "Whether it helps cannot be decided within what is not known."
    return joined([text + swung, _needed(first, corked), net, end])


def _needed(first: ComparedBat, corked: ComparedBat) -> Sentence:
    more = float(corked.break_even_bat_speed) - float(first.bat_speed)
    if math.isnan(more):
        return say("No swing is fast enough to break even with it.")
    way = "faster" if more > 0 else "slower"
    return say("To break even it must be swung {speed} {way}.", speed=_change(abs(more)), way=way)


def _beside_published(first: ComparedBat, corked: ComparedBat) -> Sentence:
    whole, after = PUBLISHED_EFFICIENCY
    before, now = float(first.max_collision_efficiency), float(corked.max_collision_efficiency)
    returned = float(corked.max_bbcor) - float(first.max_bbcor)
    return say(
        "Predicted and published: the greatest q falls from {before} to {now}, by {fall}; in the laboratory it fell "
        "from {whole} to {after}, by {fell}, for another bat. At a {pitch} pitch and {bat} of bat speed the published "
        "q values need {needed} to break even. BBCOR in play changes by {bbcor}: no trampoline. Nothing was fitted to "
        "these.",
        before=Slot(before, "ratio"), now=Slot(now, "ratio"), fall=Slot(before - now, "ratio"),
        whole=Slot(whole, "ratio"), after=Slot(after, "ratio"), fell=Slot(whole - after, "ratio"),
        pitch=Slot(94 * MPH, "speed", 0), bat=Slot(70 * MPH, "speed", 0),
        needed=_change(PUBLISHED_BREAK_EVEN, sign=True), bbcor=Slot(returned, "ratio", sign=True),
    )  # fmt: skip


def _papers_argument(first: ComparedBat, corked: ComparedBat) -> Sentence:
    before, after = first.compared.analysis.best, corked.compared.analysis.best
    return say(
        "The paper argues with Hooke's law and momentum: a softer bat is pressed in further, so the force F = k x is "
        "greater and acts longer, so F t and with it the ball's change of speed are greater. But a softer spring is "
        "pressed in further by less force, not more. Here the peak force goes from {force} to {less} and contact from "
        "{time} to {longer}. What counts is mass: a lighter barrel is pushed back more and returns less speed to the "
        "ball.",
        force=Slot(before.peak_force, "blow").bare, less=Slot(after.peak_force, "blow"),
        time=Slot(before.contact_time, "contact").bare, longer=Slot(after.contact_time, "contact"),
    )  # fmt: skip

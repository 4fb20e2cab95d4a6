"""What a comparison says, in plain words: who gains, who loses, and whether corking helps."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from sweetspot.analysis.comparison import Compared, Comparison
from sweetspot.analysis.trampoline import wall_point_of
from sweetspot.catalog.sports import sport
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.confidence import NO_SPEED, sure_sign
from sweetspot.report.sentences import Sentence, Slot, joined, say, within
from sweetspot.uncertainty.sources import Sources
from sweetspot.units import MPH

PUBLISHED_EFFICIENCY = (0.214, 0.193)
"""q of a whole and of the corked bat in the laboratory [nathan2011corked]."""
PUBLISHED_BREAK_EVEN = 2.9 * MPH
"""m/s of bat speed that follows from these two at a 94 mph pitch and 70 mph of bat speed."""
INTERVAL_HOLDS = "90 % of draws of all that is not known: bats, ball, swing, swing law"
"""What intervals of draws hold; see `drawn_comparison`."""
LINEAR_HOLDS = "90 %, by straight lines, of all that is not known: bats, ball, swing, swing law"
"""What intervals hold that were worked out without draws; see `comparison_reaches`."""


def verdict(comparison: Comparison[Implement], *, sources: Sequence[Sources]) -> list[Sentence]:
    """Return one sentence for every bat after the first, whether its gain or loss is sure.

    Parameters
    ----------
    comparison : with intervals of all that is not known, see `with_intervals`.
    sources : what the intervals hold, bat by bat. What is not in them is taken as described, and every sentence says
        itself that it holds only if that is so.
    """
    sentences = []
    for index, one in enumerate(comparison.compared[1:], start=1):
        taken = [comparison.compared[which].label for which in (0, index) if not sources[which].unknowns]
        given = f" if {' and '.join(taken)} {'is' if len(taken) == 1 else 'are'} just as described" if taken else ""
        sentences.append(_sentence(one, comparison.reference, index, given=given))
    return sentences


def changes(comparison: Comparison[Implement]) -> list[Sentence]:
    """Return one sentence for every bat after the first, without a word on how sure it is."""
    return [
        _change_words(one, comparison.reference, index) + "."
        for index, one in enumerate(comparison.compared[1:], start=1)
    ]


def cork_verdict(comparison: Comparison[Implement]) -> list[Sentence]:
    """Return the answer to "does corking help?" for a comparison labelled unmodified, drilled, cork, ...

    The published drop of q and break-even speed stand beside the predicted ones; nothing is fitted to them.

    Parameters
    ----------
    comparison : with intervals of all that is not known.
    """
    first = comparison.reference
    corked = next(compared for compared in comparison.compared if compared.label == "cork")
    answer = _answer(first, corked, comparison)
    return [answer, _beside_published(first, corked), _papers_argument(first, corked)]


def wall_verdict(comparison: Comparison) -> list[Sentence]:
    """Return what another wall does, for a comparison of a hollow bat with itself with that wall."""
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


def assumptions(comparison: Comparison[Implement]) -> Sentence:
    """Return what the numbers were computed under."""
    reference, law = comparison.reference.analysis, comparison.law
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


def assumed(comparison: Comparison[Implement], sources: Sequence[Sources], *, draws: str) -> Sentence:
    """Return what the numbers were computed under, and what their intervals hold.

    Parameters
    ----------
    sources : see `verdict`.
    draws : where draws are, for intervals that come from none.
    """
    held = [without_draws(comparison, draws)] if draws else []
    return joined([assumptions(comparison), *held, *taken_as_described(comparison, sources)])


def without_draws(comparison: Comparison[Implement], draws: str) -> Sentence:
    """Return what the intervals in brackets hold that come from no draws, and where draws are."""
    law, words = comparison.law, sport(comparison.reference.analysis.bat.sport).words
    power = "" if law is None else say(
        ", and of the power (-{low} to -{high})",
        low=Slot(law.exponents.low, "ratio", 2), high=Slot(law.exponents.high, "ratio", 2),
    )  # fmt: skip
    return say(
        "In brackets: 90 % intervals of what is not known of {tool}s and {ball}{power}, each taken one standard "
        "deviation up and down; {draws} draws them and says what they come from.",
        draws=draws, tool=words.implement, ball=words.ball, power=power,
    )  # fmt: skip


def taken_as_described(comparison: Comparison[Implement], sources: Sequence[Sources]) -> list[Sentence]:
    """Return of which of them no doubt is in the intervals, bat by bat; none: of every one it is."""
    every = zip(comparison.compared, sources, strict=True)
    return [say("{label} is {where}.", label=one.label, where=its.bat_where) for one, its in every if not its.unknowns]


def _axis(axis: float, butt: str) -> Sentence:
    if axis == 0:
        return say("the {butt}", butt=butt)
    return say("{place} above the bottom of the grip", place=Slot(axis, "place"))


def _change(speed: float, *, sign: bool = False) -> Slot:
    return Slot(speed, "speed_change", sign=sign)


def _change_words(compared: Compared[Implement], first: Compared[Implement], index: int) -> Sentence:
    """Return how much faster a bat is swung and the ball leaves, as far as it goes without an end."""
    faster = compared.bat_speed.value - first.bat_speed.value
    change = compared.change
    swung = say("")
    if abs(faster) > NO_SPEED:
        of = f"{'-' if faster < 0 else ''}bats.{index}.swung_faster_m_s"
        much = replace(_change(abs(faster)), of=of)
        swung = say("swung {speed} {way}, ", speed=much, way="faster" if faster > 0 else "slower")
    text = say("{label}: {swung}the ball leaves ", label=compared.label, swung=swung)
    if abs(change.value) < NO_SPEED:
        return text + f"as fast as from {first.label}"
    way = "faster" if change.value > 0 else "slower"
    return text + say("{speed} {way}", speed=_change(abs(change.value)), way=way)


def _sentence(compared: Compared[Implement], first: Compared[Implement], index: int, *, given: str) -> Sentence:
    change, text = compared.change, _change_words(compared, first, index)
    if max(abs(change.value), abs(change.low) / 3, abs(change.high) / 3) < NO_SPEED:
        return text + "."
    if change.low < change.high:
        text += say(" ({ends})", ends=_ends(change.low, change.high))
    if sign := sure_sign(change.low, change.high, nothing=NO_SPEED):
        return text + say(": a {gain}{given}.", gain="gain" if sign > 0 else "loss", given=given)
    return text + ": the sign is not sure."


def _ends(low: float, high: float) -> Sentence:
    return say("{low} to {high}", low=_change(low, sign=True).bare, high=_change(high, sign=True).bare)


def _answer(first: Compared[Implement], corked: Compared[Implement], comparison: Comparison[Implement]) -> Sentence:
    change = corked.change
    lighter = Slot(first.analysis.body.mass - corked.analysis.body.mass, "mass")
    text = say("Does corking help? The corked bat is {mass} lighter", mass=lighter)
    if comparison.law is None:
        sent = say("; swung no faster, it sends the ball off {speed}.", speed=_change(change.value, sign=True))
        return joined([text + sent, _needed(first, corked)])
    gained = corked.bat_speed.shifted(-first.bat_speed.value)
    swung = say(" and the same player swings it {speed} faster", speed=_change(gained.value))
    if first.bat_speed.low == first.bat_speed.high:  # else the ends are those of both swings
        swung += say(" ({ends})", ends=_ends(gained.low, gained.high))
    swung += "."
    net = say("Net change of the exit speed: {change}.", change=within(change, "speed_change", sign=True))
    sign = sure_sign(change.low, change.high, nothing=NO_SPEED)
    if sign < 0:
        end = "No: the ball leaves slower. What remains is a quicker, later swing, which is not computed here."
    elif sign > 0:
        end = "Here it does."
    else:
        end = "Whether it helps cannot be told within what is not known."
    return joined([text + swung, _needed(first, corked), net, end])


def _needed(first: Compared[Implement], corked: Compared[Implement]) -> Sentence:
    more = corked.break_even - first.bat_speed.value
    if math.isnan(more):
        return say("No swing is fast enough to break even with it.")
    way = "faster" if more > 0 else "slower"
    return say("To break even it must be swung {speed} {way}.", speed=_change(abs(more)), way=way)


def _beside_published(first: Compared[Implement], corked: Compared[Implement]) -> Sentence:
    whole, after = PUBLISHED_EFFICIENCY
    before, now = first.collision_efficiency, corked.collision_efficiency
    return say(
        "Predicted and published: the greatest q falls from {before} to {now}, by {fall}; in the laboratory it fell "
        "from {whole} to {after}, by {fell}, for another bat. At a {pitch} pitch and {bat} of bat speed the published "
        "q values need {needed} to break even. BBCOR in play changes by {bbcor}: no trampoline. Nothing was fitted to "
        "these.",
        before=Slot(before, "ratio"), now=Slot(now, "ratio"), fall=Slot(before - now, "ratio"),
        whole=Slot(whole, "ratio"), after=Slot(after, "ratio"), fell=Slot(whole - after, "ratio"),
        pitch=Slot(94 * MPH, "speed", 0), bat=Slot(70 * MPH, "speed", 0),
        needed=_change(PUBLISHED_BREAK_EVEN, sign=True), bbcor=Slot(corked.bbcor - first.bbcor, "ratio", sign=True),
    )  # fmt: skip


def _papers_argument(first: Compared[Implement], corked: Compared[Implement]) -> Sentence:
    before, after = first.analysis.best, corked.analysis.best
    return say(
        "The paper argues with Hooke's law and momentum: a softer bat is pressed in further, so the force F = k x is "
        "greater and acts longer, so F t and with it the ball's change of speed are greater. But a softer spring is "
        "pressed in further by less force, not more. Here the peak force goes from {force} to {less} and contact from "
        "{time} to {longer}. What counts is mass: a lighter barrel is pushed back more and returns less speed to the "
        "ball.",
        force=Slot(before.peak_force, "blow").bare, less=Slot(after.peak_force, "blow"),
        time=Slot(before.contact_time, "contact").bare, longer=Slot(after.contact_time, "contact"),
    )  # fmt: skip

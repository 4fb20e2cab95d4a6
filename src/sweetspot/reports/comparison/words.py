"""What a comparison says, in plain words: who gains, who loses, and whether corking helps."""

from __future__ import annotations

import math

from sweetspot.analysis.comparison import Comparison
from sweetspot.analysis.trampoline import wall_point_of
from sweetspot.answers.compare import JAMMED, BatGain, CompareAnswer, ComparedBat
from sweetspot.catalog.materials import material
from sweetspot.catalog.sports import sport
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.interval import ENDS, NO_SPEED, Interval, chance_above, interval_of, sure_sign
from sweetspot.reports.measuring_words import what_to_measure
from sweetspot.reports.sentences import Line, Sentence, joined, say, tell
from sweetspot.reports.uncertainty import chance_words
from sweetspot.units import MPH

SURE = ENDS[1]
"""Chance from which on a difference is called sure: its 90 % interval leaves zero out."""
PROBABLY = 0.8
"""Chance from which on the sign of a difference that is not sure is called probable [our choice]."""
PUBLISHED_EFFICIENCY = (0.214, 0.193)
"""q of a whole and of the corked bat in the laboratory [nathan2011corked]."""
PUBLISHED_BREAK_EVEN = 2.9 * MPH
"""m/s of bat speed that follows from these two at a 94 mph pitch and 70 mph of bat speed."""
CORK = "cork"

CHANGE = (
    Line("{label}: "),
    Line("swung {swung:speed_change} faster, ", "swung_faster"),
    Line("swung {swung:speed_change} slower, ", "swung_slower"),
    Line("the ball leaves "),
    Line("as fast as from {reference}", "same"),
    Line("{speed:speed_change} faster", "faster"),
    Line("{speed:speed_change} slower", "slower"),
)
VERDICT = (
    *CHANGE,
    Line(" ({low:speed_change, sign, bare} to {high:speed_change, sign, bare})", "within"),
    Line(": a gain{given}", "gain"),
    Line(": a loss{given}", "loss"),
    Line(": probably a gain ({chance})", "probable_gain"),
    Line(": probably a loss ({chance})", "probable_loss"),
    Line(": the sign is not sure", "unsure"),
    Line("."),
)
"""One bat against the first, without and with how sure it is."""
BREAKING = (
    Line("{label} breaks sooner: ", "sooner"),
    Line("{label} breaks later: ", "later"),
    Line("jammed {place:place} from the tip from a closing speed of {now:speed, 0} on, instead of {before:speed, 0}."),
)
NOTICED = 1 * MPH
"""m/s of a breaking speed below which a difference is not worth a sentence [our choice]."""
PROBABLE = (
    Line("Hit by the same ball, {gain.label} is faster than {reference} with a probability of {chance}: "),
    Line("surely a difference.", "sure"),
    Line("not surely a difference.", unless="sure"),
)
CORKING = (
    Line("Does corking help? No: net of the faster swing the ball leaves {slower:speed_change} slower", "loss"),
    Line("Does corking help? Here it does: net of the faster swing the ball leaves {net:speed_change} faster", "gain"),
    Line("Does corking help? Probably not ({chance}): net of the faster swing ", "probable_loss"),
    Line("Does corking help? Probably ({chance}): net of the faster swing ", "probable_gain"),
    Line("Does corking help? Not surely either way: net of the faster swing ", "unsure"),
    Line("the exit speed changes by {net:speed_change, sign}", "open"),
    Line(" ({low:speed_change, sign, bare} to {high:speed_change, sign, bare}). ", "law"),
    Line("The corked bat is {lighter:mass} lighter"),
    Line("; swung no faster, it sends the ball off {change:speed_change, sign}.", unless="law"),
    Line(" and the same player swings it {gained:speed_change} faster", "law"),
    Line(" ({least:speed_change, sign, bare} to {most:speed_change, sign, bare}).", "law"),
    Line(" No swing is fast enough to break even with it.", "never"),
    Line(" To break even it must be swung {more:speed_change} faster.", "must_be_faster"),
    Line(" To break even it must be swung {more:speed_change} slower.", "may_be_slower"),
    Line(" What remains is a quicker, later swing, which is not computed here.", "loss"),
)
PUBLISHED = (
    "Predicted and published: the greatest q falls from {before:ratio} to {now:ratio}, by {fall:ratio}; in the "
    "laboratory it fell from {whole:ratio} to {after:ratio}, by {fell:ratio}, for another bat. At a {pitch:speed, 0} "
    "pitch and {bat:speed, 0} of bat speed the published q values need {needed:speed_change, sign} to break even. "
    "BBCOR in play changes by {bbcor:ratio, sign}: no trampoline. Nothing was fitted to these."
)
ARGUMENT = (
    "The paper [paper2014] argues with Hooke's law and momentum: a softer bat is pressed in further, so the force "
    "F = k x is greater and acts longer, so F t and with it the ball's change of speed are greater. But a softer "
    "spring is pressed in further by less force, not more. Here the peak force goes from "
    "{whole.peak_force:blow, bare} to {corked.peak_force:blow} and contact from {whole.contact_time:contact, bare} to "
    "{corked.contact_time:contact}. "
    "What counts is mass: a lighter barrel is pushed back more and returns less speed to the ball."
)
WALL = (
    "Where the ball hits best the wall is {other.thickness:compression, 2} thick instead of "
    "{first.thickness:compression, 2} and rings at {other.hoop_frequency:frequency} instead of "
    "{first.hoop_frequency:frequency}. It takes {other.energy.share:share, 1} of the ball's energy instead of "
    "{first.energy.share:share, 1} and gives {back:share} of that back in time; what it takes, the ball does not lose. "
    "BBCOR in play there goes from {first.bbcor:ratio} to {other.bbcor:ratio}: the {size} wall is the {temper} one."
)
ASSUMPTIONS = (
    Line("The {terms.incoming} comes at {pitch:speed}. ", "pitch"),
    Line("The {terms.incoming} is at rest. ", unless="pitch"),
    Line("The {terms.implement}'s speed is that {place:place} from the {terms.tip}; "),
    Line("q and BBCOR in play are the greatest on the barrel", "round_bat"),
    Line("q is the greatest", unless="round_bat"),
    Line(" at this swing's closing speed. Break-even: the {terms.implement} speed with which the ball leaves as fast "),
    Line("as from the first {terms.implement}. "),
    Line("Every {terms.implement} is swung at the same speed, as no player does with unequal ones.", unless="law"),
    Line("Same effort: {terms.implement} speed goes as the moment of inertia about ", "law"),
    Line("the {terms.butt}", "about_butt"),
    Line("{axis:place} above the bottom of the grip", "axis"),
    Line(" to the power -{power} ({law.name})", "law"),
    Line("; no law of this sport's own players is used", "foreign_law"),
    Line(".", "law"),
)
WITHOUT_DRAWS = (
    Line("In brackets: 90 % intervals of what is not known of {terms.implement}s and {terms.ball}"),
    Line(", and of the power (-{law.exponents.low:ratio, 2} to -{law.exponents.high:ratio, 2})", "law"),
    Line(", each taken one standard deviation up and down; {draws} draws them and says what they come from."),
)


def verdict(answer: CompareAnswer) -> list[Sentence]:
    """Return one sentence for every bat after the first, whether its gain or loss is sure.

    What is not in the intervals is taken as described, and a sentence says itself that it holds only if that is so.
    """
    sentences = []
    for index, bat in enumerate(answer.bats[1:], start=1):
        taken = [answer.bats[which].label for which in (0, index) if not answer.sources[which].unknowns]
        given = f" if {' and '.join(taken)} {'is' if len(taken) == 1 else 'are'} just as described" if taken else ""
        ends = interval_of(bat.change)
        open_sign = sure_sign(ends.low, ends.high, nothing=NO_SPEED) == 0
        measure = what_to_measure(bat.worth_measuring, ends.half_width, beside=bat.label) if open_sign else say("")
        sentences.append(tell(VERDICT, given=given, **_facts(answer, bat)) + measure)
    return sentences


def breaking_words(answer: CompareAnswer) -> list[Sentence]:
    """Return how much sooner or later a wooden bat breaks after what was done to it, for every changed one.

    What water does to the strain at which wood breaks is not known here, so nothing is said of another moisture.
    """
    first, sentences = answer.bats[0], []
    before, piece = float(first.breaking_speed), first.compared.analysis.bat
    for bat in answer.bats[1:]:
        implement, now = bat.compared.analysis.bat, float(bat.breaking_speed)
        same = piece in implement.lineage() and implement.materials == piece.materials
        if same and abs(now - before) >= NOTICED:
            facts = {"now": now, "before": before, "place": JAMMED}
            sentences.append(tell(BREAKING, label=bat.label, sooner=now < before, later=now > before, **facts))
    return sentences


def changes(answer: CompareAnswer) -> list[Sentence]:
    """Return one sentence for every bat after the first, without a word on how sure it is."""
    return [tell(CHANGE, **_facts(answer, bat)) + "." for bat in answer.bats[1:]]


def _facts(answer: CompareAnswer, bat: ComparedBat) -> dict[str, object]:
    """Return how much faster a bat is swung and the ball leaves, and how sure that is."""
    swung, change, ends = float(bat.swung_faster), float(bat.change), interval_of(bat.change)
    some = max(abs(change), abs(ends.low) / 3, abs(ends.high) / 3) >= NO_SPEED
    drawn = answer.uncertainty is not None
    more = (bat.swung_faster if swung > 0 else -bat.swung_faster) if drawn else abs(swung)
    return {
        "label": bat.label,
        "reference": answer.reference,
        "swung": more,
        "swung_faster": swung > NO_SPEED,
        "swung_slower": swung < -NO_SPEED,
        "speed": abs(change),
        "same": abs(change) < NO_SPEED,
        "faster": change >= NO_SPEED,
        "slower": change <= -NO_SPEED,
        "low": ends.low,
        "high": ends.high,
        "within": some and ends.low < ends.high,
        **_signs(ends, of_some=some),
        "chance": _chance_of_sign(ends),
    }


def _signs(change: Interval, *, of_some: bool) -> dict[str, bool]:
    """Return whether a change of speed is a gain or a loss, probably one, or not sure; all False where it is none."""
    sign, chance = sure_sign(change.low, change.high, nothing=NO_SPEED), chance_above(0.0, change)
    probable = of_some and sign == 0 and abs(change.value) >= NO_SPEED
    likely_gain, likely_loss = probable and chance >= PROBABLY, probable and chance <= 1 - PROBABLY
    return {
        "gain": of_some and sign > 0,
        "loss": of_some and sign < 0,
        "probable_gain": likely_gain,
        "probable_loss": likely_loss,
        "unsure": of_some and sign == 0 and not (likely_gain or likely_loss),
        "open": of_some and sign == 0,
    }


def _chance_of_sign(change: Interval) -> Sentence:
    """Return how probable the sign is that a change of speed has."""
    chance = chance_above(0.0, change)
    return chance_words(max(chance, 1 - chance))


def gain_words(gain: BatGain, reference: str) -> Sentence:
    """Return how probable it is that a bat's exit speed is higher than that of the first, hit by the same ball."""
    chance = gain.faster_probability
    sure = max(chance, 1 - chance) >= SURE
    return tell(PROBABLE, gain=gain, reference=reference, chance=chance_words(chance), sure=sure)


def cork_verdict(answer: CompareAnswer) -> list[Sentence]:
    """Return the answer to "does corking help?" where one of the bats is the first one, corked; else nothing.

    The published drop of q and break-even speed stand beside the predicted ones; nothing is fitted to them.
    """
    first, piece = answer.bats[0], answer.bats[0].compared.analysis.bat
    corked = next((bat for bat in answer.bats[1:] if _is_corked(bat.compared.analysis.bat, piece)), None)
    if corked is None:
        return []
    hits = [bat.compared.analysis.best for bat in (first, corked)]
    argument = say(ARGUMENT, whole=hits[0], corked=hits[1])
    return [_whether_it_helps(first, corked, answer), _beside_published(first, corked), argument]


def _is_corked(bat: Implement, piece: Implement) -> bool:
    """Return whether a bat is this piece of wood with cork in it."""
    if not isinstance(bat, Bat) or bat == piece or piece not in bat.lineage():
        return False
    return any(bore.fill == material(CORK) for bore in bat.bores)


def _whether_it_helps(first: ComparedBat, corked: ComparedBat, answer: CompareAnswer) -> Sentence:
    net, gained, law = interval_of(corked.change), interval_of(corked.swung_faster), answer.swing_law is not None
    more = float(corked.break_even_bat_speed) - float(first.bat_speed)
    return tell(
        CORKING,
        lighter=float(first.bat.mass) - float(corked.bat.mass),
        change=net.value,
        law=law,
        gained=gained.value,
        least=gained.low,
        most=gained.high,
        more=abs(more),
        never=math.isnan(more),
        must_be_faster=more > 0,
        may_be_slower=more <= 0,
        net=net.value,
        slower=-net.value,
        low=net.low,
        high=net.high,
        chance=_chance_of_sign(net),
        **_signs(net, of_some=law),
    )


def _beside_published(first: ComparedBat, corked: ComparedBat) -> Sentence:
    whole, after = PUBLISHED_EFFICIENCY
    before, now = float(first.max_collision_efficiency), float(corked.max_collision_efficiency)
    falls = {"before": before, "now": now, "fall": before - now, "whole": whole, "after": after, "fell": whole - after}
    bbcor, speeds = float(corked.max_bbcor) - float(first.max_bbcor), {"pitch": 94 * MPH, "bat": 70 * MPH}
    return say(PUBLISHED, bbcor=bbcor, needed=PUBLISHED_BREAK_EVEN, **falls, **speeds)


def wall_verdict(comparison: Comparison) -> list[Sentence]:
    """Return the effect of another wall, for a comparison of a hollow bat with itself with that wall."""
    first, other = (wall_point_of(compared.analysis) for compared in comparison.compared[:2])
    size = "thinner" if other.thickness < first.thickness else "thicker"
    temper = "livelier" if other.bbcor > first.bbcor else "deader"
    back = other.energy.restitution**2
    return [say(WALL, first=first, other=other, back=back, size=size, temper=temper)]


def assumptions(answer: CompareAnswer) -> Sentence:
    """Return the conditions of the computation."""
    reference, law = answer.comparison.reference.analysis, answer.comparison.law
    conditions, round_bat = reference.conditions, isinstance(reference.bat, Bat)
    return tell(
        ASSUMPTIONS,
        terms=sport(reference.bat.sport).words,
        pitch=conditions.pitch.speed,
        place=reference.bat.length - conditions.swing.measured_at,
        round_bat=round_bat,
        law=law,
        power=f"{law.exponent:g}" if law else "",
        axis=law and law.axis,
        about_butt=law and law.axis == 0,
        foreign_law=law and not round_bat,
    )


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
    terms = sport(answer.comparison.reference.analysis.bat.sport).words
    return tell(WITHOUT_DRAWS, terms=terms, law=answer.comparison.law, draws=draws)


def taken_as_described(answer: CompareAnswer) -> list[Sentence]:
    """Return of which of them no doubt is in the intervals, bat by bat; none: of every one it is."""
    pairs = zip(answer.bats, answer.sources, strict=True)
    return [say("{bat.label} is {its.bat_where}.", bat=bat, its=its) for bat, its in pairs if not its.unknowns]


FASTEST_PLACE = "{bat.label} hits fastest {place:place} from the tip"
SPEED_CHANGE = (
    Line("{label} {change:speed_change}"),
    Line(", interval {low:speed_change} to {high:speed_change}", "within"),
)


def fastest_places(comparison: Comparison) -> Sentence:
    """Return the place on each bat from which the ball leaves fastest."""
    found = [(bat, bat.analysis.bat.length - bat.analysis.sweet_spots.max_exit_speed) for bat in comparison.compared]
    places = joined([say(FASTEST_PLACE, bat=bat, place=place) for bat, place in found], "; ")
    return say("The bats to scale, tips aligned. {places}.", places=places)


def speed_changes(answer: CompareAnswer) -> Sentence:
    """Return the change of each bat's exit speed against the first one's, with its interval."""
    rows = []
    for bat in answer.bats[1:]:
        change = interval_of(bat.change)
        ends = {"low": change.low, "high": change.high, "within": change.low < change.high}
        rows.append(tell(SPEED_CHANGE, label=bat.label, change=change.value, **ends))
    return say("Change of exit speed against {first}: {rows}.", first=answer.reference, rows=joined(rows, "; "))

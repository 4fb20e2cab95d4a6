"""A design in sentences: where the best place goes and how wide the zone is, then what it is worth, then who pays."""

from __future__ import annotations

import numpy as np

from sweetspot.analysis.certification.rules import PERFORMANCE, Verdict, title
from sweetspot.analysis.sweet_spot import ZONE_LOSS
from sweetspot.answers.conditions import MassProperties
from sweetspot.answers.design_question import Designed
from sweetspot.catalog.sports import sport
from sweetspot.designs.batter import FROM_TIP
from sweetspot.designs.constraints import AS_IT_IS, Limit
from sweetspot.designs.gain import SHIPMENT, TOWARDS_END, TURNED_ALIKE, Gain, GainVerdict
from sweetspot.designs.measures import MEASURES
from sweetspot.designs.turned import HANDLES, TurnedSpace
from sweetspot.designs.variables import DENSITY_SPREAD, MODULUS_SPREAD
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.cricket_bat import CricketBat
from sweetspot.reports.certification.limits_shown import unsure_words
from sweetspot.reports.sentences import Sentence, Slot, joined, say, with_doubt
from sweetspot.units import INCH, grouped

STILL = 0.02 * INCH
"""m below which a place counts as unmoved."""

FURTHER = 0.05
"""Relative growth of a handle's bending that is reported (assumed: two pieces of one species differ by more)."""


def tool_of(design: Designed) -> str:
    """Return the sport's word for the designed implement."""
    return sport(design.bench.space.present.sport).words.implement


def label_of(design: Designed, measure: str) -> str:
    """Return the name of a measure in the sport of the designed implement."""
    return f"{tool_of(design)} speed" if measure == "bat_speed" else MEASURES[measure].label


def gained_words(change: float | None, gain: Gain | None = None) -> Sentence:
    """Return the gain of a bat over a batter's contacts, m/s, with how sure that is; None: it is the present bat."""
    if change is None:
        return say("This is the present bat still: pull a round handle, or let the search find better.")
    doubt = verdict = say("")
    if gain is not None:
        doubt = say(", give or take {doubt:speed_change} (90 %)", doubt=gain.doubt)
        verdict = say(": {verdict}", verdict=gain.verdict.value)
    return say(
        "Over these contacts the ball leaves {change}{doubt}{verdict}.",
        change=_faster(change),
        doubt=doubt,
        verdict=verdict,
    )


def weight_words(weights: MassProperties, moi_doubt: float) -> Sentence:
    """Return the weight and balance of a bat; ``moi_doubt`` is the standard deviation of its swing weight."""
    return say(
        "{weights.mass:mass}, balance {weights.balance_point:place} from the knob, swing weight {moi}.",
        weights=weights,
        moi=with_doubt(float(weights.moi_6in), moi_doubt, "moi"),
    )


def limit_words(limit: Limit, value: float, *, beyond: float | None) -> Sentence:
    """Return a value beside its limit, by how much it is beyond it, and who wants it, unless it is a lock."""
    scale = MEASURES[limit.measure].scale
    ends = {"least": limit.least, "most": limit.most}
    slots = {name: Slot(end, scale) for name, end in ends.items() if end is not None}
    ways = {"least": ", at least {least}", "most": ", at most {most}"}
    words = ", allowed {least} to {most}" if len(slots) == len(ends) else "".join(ways[name] for name in slots)
    over = "" if beyond is None else say(", beyond by {beyond}", beyond=Slot(beyond, scale))
    why = "" if limit.why == AS_IT_IS else f" ({limit.why})"
    return say("{value}" + words + "{over}{why}", value=Slot(value, scale), over=over, why=why, **slots)


def gain_words(design: Designed) -> list[Sentence]:
    """Return the changes of a design, their worth to this batter, who should not use it, and how it is swung."""
    words = [*unbounded_words(design), moved_words(design), worth_words(design), warning_words(design)]
    return [*words, *wall_words(design), *outline_words(design), effort_words(design)]


def moved_words(design: Designed) -> Sentence:
    """Return the shift of the best place, then the zone's width, and last the change of the greatest exit speed."""
    gain = design.gain
    if abs(gain.shift) < STILL:
        place = say("The best place stays where it is, {place:place} from the tip", place=design.value("best_from_tip"))
    else:
        way = "towards the hands" if gain.shift > 0 else "towards the tip"
        place = say(
            "The best place moves {shift:length} {way}, to {place:place} from the tip",
            shift=abs(gain.shift),
            way=way,
            place=design.value("best_from_tip"),
        )
    zone = say(
        "; the zone within {near:speed, round} of the best is {width:place} wide, {wider:length} {more}.",
        near=ZONE_LOSS,
        width=design.value("zone"),
        wider=abs(gain.wider),
        more="wider" if gain.wider >= 0 else "narrower",
    )
    top = say(" The greatest exit speed changes by {change:speed_change, sign}.", change=gain.greatest)
    return joined([place + zone + top, *_unmet(design)])


FAR = 1 * INCH
"""m by which the best place may miss the contacts before it is said (assumed: twice what is known of places)."""


def _unmet(design: Designed) -> list[Sentence]:
    """Return that the best place cannot come to where this batter meets the ball; nothing where it is near."""
    contact, best = design.bench.batter.mean_contact, design.value("best_from_tip")
    if abs(contact - best) < FAR:
        return []
    return [
        say(
            "It can't come to your contacts within these limits: it stays {short:length} short of them.",
            short=abs(contact - best),
        )
    ]


def first_words(design: Designed) -> Sentence:
    """Return the worth and the change of the first bat that a search finds, in one line."""
    return joined(
        [
            say(
                "first answer: the ball leaves {gain}, give or take {doubt:speed_change} (90 %), {verdict}; the best "
                "place is {place:place} from the tip.",
                gain=_faster(design.gain.expected),
                doubt=design.gain.doubt,
                verdict=design.gain.verdict.value,
                place=design.value("best_from_tip"),
            ),
            *wall_words(design),
            *outline_words(design),
            say("The front follows."),
        ]
    )


LEAST = 0.01 * INCH
"""m by which a diameter has to change to be named: a lathe's tolerance."""


def outline_words(design: Designed) -> list[Sentence]:
    """Return the greatest changes of a turned bat's outline, and of its cup; nothing for other implements."""
    space, present = design.bench.space, design.bench.space.present
    if not isinstance(space, TurnedSpace) or not isinstance(present, Bat) or not isinstance(design.bat, Bat):
        return []
    apart = design.numbers[: len(HANDLES)] - space.start[: len(HANDLES)]
    places = (1 - HANDLES) * design.bat.length
    changes = [
        say("{size:length} {way} {place:place} from the tip", size=abs(by), way=way, place=float(places[index]))
        for way, index, by in (
            ("thicker", int(np.argmax(apart)), float(apart.max())),
            ("thinner", int(np.argmin(apart)), float(apart.min())),
        )
        if abs(by) >= LEAST and (by > 0) == (way == "thicker")
    ]
    cups = [0.0 if bat.cup is None else bat.cup.depth for bat in (present, design.bat)]
    if abs(cups[1] - cups[0]) >= LEAST:
        changes.append(say("a cup {depth:length} deep instead of {before:length}", depth=cups[1], before=cups[0]))
    return [say("What changes most: {changes}.", changes=joined(changes, ", "))] if changes else []


def worth_words(design: Designed) -> Sentence:
    """Return the gain of the design for this batter, beside the scatter that could hide it."""
    gain, batter = design.gain, design.bench.batter
    first = say(
        "For contacts around {place:place} from the tip the ball leaves {gain} on average, give or take "
        "{doubt:speed_change} (90 %): {verdict}; faster in {odds} of 100 such pairs.",
        place=batter.mean_contact,
        gain=_faster(gain.expected),
        doubt=gain.doubt,
        verdict=gain.verdict.value,
        odds=_of_100(gain.odds),
    )
    return joined([first, *_balls(design), _doubts(design)])


def _of_100(odds: float) -> str:
    """Return how many of 100, without claiming none or all.

    >>> _of_100(0.9999), _of_100(0.948), _of_100(0.001)
    ('more than 99', '95', 'fewer than 1')
    """
    count = round(100 * odds)
    return "more than 99" if count >= 100 else "fewer than 1" if count < 1 else f"{count}"


def _balls(design: Designed) -> list[Sentence]:
    """Return how the number of balls limits the answer; nothing if no balls were given."""
    gain = design.gain
    if not gain.balls:
        return []
    count = f"{gain.balls:.0f} {'ball tells' if round(gain.balls) == 1 else 'balls tell'}"
    sample = say(
        "{count} of the contacts, beside what is known of all batters, and that adds {sample:speed_change}",
        count=count[0].upper() + count[1:],
        sample=gain.sample,
    )
    if gain.balls_needed is not None:
        return [
            sample + say("; from about {needed} met as these the gain would be seen.", needed=_about(gain.balls_needed))
        ]
    if gain.expected > 0 and gain.verdict is not GainVerdict.SEEN:
        return [sample + say("; a gain of this size would be seen from no number of balls.")]
    return [sample + say(".")]


def _about(count: int) -> str:
    """Return a number of balls to two digits, upwards."""
    unit = 10 ** max(0, len(str(count)) - 2)
    return grouped(-(-count // unit) * unit)


def _faster(change: float) -> Sentence:
    return say("{size:speed_change} {way}", size=abs(change), way="faster" if change >= 0 else "slower")


def _doubts(design: Designed) -> Sentence:
    gain = design.gain
    parts = []
    if not gain.shipment:
        willow = say(
            "; willow's density by {density}, its stiffness by {modulus}",
            density=_spread(DENSITY_SPREAD),
            modulus=_spread(MODULUS_SPREAD),
        )
        parts.append(
            say(
                "Two of one model differ by {wood:speed_change} (one standard deviation: every number that is changed "
                "by {alike}{willow}; assumed).",
                wood=gain.wood,
                alike=_spread(TURNED_ALIKE),
                willow=willow if isinstance(design.bench.space.present, CricketBat) else say(""),
            )
        )
    else:
        parts.append(
            say(
                "Two bats of one shape differ by {gain.wood:speed_change} (one standard deviation: density {density}, "
                "stiffness {modulus}; {gain.by_weight:speed_change} chosen by weight), or by "
                "{gain.shipment:speed_change}: best and worst of a dozen by up to {shipment:speed, 0, round}.",
                gain=gain,
                density=_spread(DENSITY_SPREAD),
                modulus=_spread(MODULUS_SPREAD),
                shipment=SHIPMENT,
            )
        )
    law = design.bench.batter.law
    swing = (
        say("The swing law adds {law:speed_change}; ", law=gain.law)
        if law is not None
        else say("All are swung alike; ")
    )
    contact = say(
        "the place of contact, known to {doubt:place}, adds {contact:speed_change}.",
        doubt=design.bench.batter.doubt,
        contact=gain.contact,
    )
    return joined([*parts, swing + contact])


def _spread(part: float) -> Sentence:
    return say("{part:share}", part=part)


def warning_words(design: Designed) -> Sentence:
    """Return who should not use the design, and what it costs there."""
    gain = design.gain
    outer = (gain.turning_place or design.bench.batter.mean_contact) > FROM_TIP
    worst = int(np.argmin(np.where(outer, gain.curve, np.inf)))
    place = Slot(float(FROM_TIP[worst]), "place")
    if not outer.any() or gain.curve[worst] >= 0:
        return say(
            "Who should not use it: by exit speed, no one; {place:place} from the tip it still gains "
            "{gain:speed_change}.",
            place=TOWARDS_END,
            gain=gain.at(TOWARDS_END),
        )
    tool = tool_of(design)
    turning = say("Towards the tip the present {tool} is better", tool=tool)
    if gain.turning_place is not None:
        near = Slot(gain.turning_place, "place")
        turning = say("Nearer the tip than {turning} the present {tool} is better", turning=near, tool=tool)
    return turning + say(
        ": {place} from the tip the design costs {cost:speed_change}. Who meets the ball out there, or is late, "
        "should not use it.",
        place=place,
        cost=-float(gain.curve[worst]),
    )


def breaking_words(design: Designed) -> list[Sentence]:
    """Return whether the handle of the design is bent further than the present one's; nothing where it hardly is."""
    if design.bent is None:
        return []
    now, after = design.bent
    if after.strain < (1 + FURTHER) * now.strain:
        return []
    return [
        say(
            "Its handle is bent further: up to {after:strain} against {now:strain} over these contacts, by a ball met "
            "{place:place} from the tip. Bats break there; a thicker grip (--handle) costs weight, not speed.",
            after=after.strain,
            now=now.strain,
            place=after.from_tip,
        )
    ]


def rules_words(design: Designed) -> list[Sentence]:
    """Return whether the design keeps the league's rules, as far as a drawing decides them."""
    failed, open_ones = (
        [title(check.rule) for check in design.checks if check.verdict is verdict]
        for verdict in (Verdict.FAIL, Verdict.NOT_DECIDABLE)
    )
    if not design.checks:
        return []
    verdict = (
        say("It breaks the rules: {failed}.", failed=", ".join(failed))
        if failed
        else say("It keeps every rule of its league that a drawing decides.")
    )
    left = say(" Left open: {left}.", left=", ".join(open_ones)) if open_ones else say("")
    return [verdict + say(unsure_words(design.checks)) + left]


def unbounded_words(design: Designed) -> list[Sentence]:
    """Return that no rule of performance bounds the wall of a hollow bat; nothing where one does, or it has no wall."""
    bounded = {limit.measure for limit in design.question.limits}
    if not design.bench.tested or bounded & PERFORMANCE:
        return []
    left = [check for check in design.checks if check.rule.quantity in PERFORMANCE]
    why = (
        say("no league's rules were asked for")
        if not design.checks
        else say("its league limits none that can be tested")
    )
    if left:
        why = say("{rule} is not decidable: {reason}", rule=title(left[0].rule), reason=left[0].reason)
    return [
        say(
            "No rule of performance bounds this wall, so the gain below says nothing of a legal bat: {why}. A thinner "
            "wall usually hits harder: take a league that limits BBCOR or BPF (--league), or leave the wall as it is.",
            why=why,
        )
    ]


def wall_words(design: Designed) -> list[Sentence]:
    """Return the changes to a hollow bat's wall and end cap; nothing for other implements."""
    if not design.bench.tested:
        return []
    changes = [
        say(
            "{label} {place}from {before} to {after}",
            label=variable.label,
            place=say("{place:place} from the tip ", place=variable.from_tip) if variable.from_tip is not None else "",
            before=Slot(variable.start, variable.scale, 2).bare,
            after=Slot(value, variable.scale, 2),
        )
        for variable, value in zip(design.bench.space.variables, design.numbers.tolist(), strict=True)
    ]
    return [say("What to change: {changes}. The outside stays as it is.", changes=joined(changes, "; "))]


BALL_GAMES = ("baseball", "youth-baseball", "softball", "slow-pitch")
"""Sports of players such as the law of swings was measured on."""


def effort_words(design: Designed) -> Sentence:
    """Return the effect of the design on the swing."""
    gain, law = design.gain, design.bench.batter.law
    if law is None:
        return say("All are swung at the same speed.")
    played = design.bench.space.present.sport
    low, high = sorted(_time(design, exponent) for exponent in (law.exponents.low, law.exponents.high))
    return say(
        "Time to contact changes by {time:contact, 2, sign} ({low:contact, 2, sign, bare} to {high:contact, 2, sign}) "
        "of {whole:contact, 0}, by the law of {law}{borrowed}.",
        time=gain.time,
        low=low,
        high=high,
        whole=_swing_time(),
        law=law.name,
        borrowed="" if played in BALL_GAMES else f": none is known for {sport(played).name.lower()}",
    )


def _time(design: Designed, exponent: float) -> float:
    law, ratio = design.bench.batter.law, design.value("swing_time") / _swing_time()
    assert law is not None
    return float(_swing_time() * (ratio ** (exponent / max(law.exponent, 1e-9)) - 1))


def _swing_time() -> float:
    from sweetspot.designs.measures import SWING_TIME

    return SWING_TIME

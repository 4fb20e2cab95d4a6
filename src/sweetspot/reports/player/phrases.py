"""Phrases of a player: what he wants more of, a bat that is tried, and the bats swung, each against each."""

from __future__ import annotations

from sweetspot.numerics.interval import Interval
from sweetspot.player.advice import ATTACK_CHANGE, Advice
from sweetspot.player.bat_pairs import BatPair
from sweetspot.player.candidate import Candidate
from sweetspot.player.goal import Goal
from sweetspot.reports.document import Cell, Table, table_head
from sweetspot.reports.sentences import Sentence, Slot, Words, joined, say, within
from sweetspot.units import INCH, MPH

GOALS: dict[str, tuple[str, int | None]] = {
    "exit-speed": ("speed_change", None),
    "carry": ("distance", 1),
    "line": ("share", 1),
}
"""Scale and digits of every goal."""
SCALES = {"weight": "mass", "balance": "mass", "choke": "place"}
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
    """Return a tried bat relative to the player's own, "1 oz at the tip", or another bat's name."""
    scale = SCALES.get(candidate.family)
    if scale is None:
        return say("{name}", name=candidate.label)
    amount = Slot(abs(candidate.amount), scale, round=True)
    if candidate.family == "balance":
        where = "tip" if candidate.key == "end-loaded" else "knob"
        return say("{amount} at the {where}", amount=amount, where=where)
    if candidate.family == "choke":
        return say("choked up {amount}", amount=amount)
    return say("{amount} {way}", amount=amount, way="heavier" if candidate.amount > 0 else "lighter")


def changes() -> dict[str, Sentence]:
    """Return the single changes whose worth is reported, in words, by key of `Advice.worth`."""
    inch, quarter = Slot(INCH, "place"), Slot(INCH / 4, "offset")
    return {
        "bat_speed": say("{speed:speed_change} more bat speed", speed=MPH),
        "position_spread": say("{inch} less scatter along the bat", inch=inch),
        "offset_spread": say("{quarter} less scatter over and under", quarter=quarter),
        "towards_tip": say("contact {inch} nearer the tip", inch=inch),
        "towards_hands": say("contact {inch} nearer the hands", inch=inch),
        "higher": say("ball {quarter} higher on the bat", quarter=quarter),
        "lower": say("ball {quarter} lower on the bat", quarter=quarter),
        "attack_angle": say("{angle} more upward swing", angle=Slot(ATTACK_CHANGE, "angle")),
        "flatter": say("{angle} flatter swing", angle=Slot(ATTACK_CHANGE, "angle")),
    }


PAIRS_TOLD = 6
"""Pairs that are described in words; a table has all."""
BETTER = ("better", "better by the model")
VERDICTS = {
    "better": "the first is better, as measured too",
    "better by the model": "the first is better by the model",
    "cannot tell": "the swings cannot tell",
    "gainsaid": "measured and model disagree",
}


def of_those_swung(advice: Advice) -> Words:
    """Return the bats of the file ranked as far as the data can tell, each against each; "" of fewer than two."""
    seldom = _too_seldom(advice.seldom)
    if not advice.pairs:
        return seldom
    gainsaid = [pair for pair in advice.pairs if pair.verdict == "gainsaid"]
    decided = [pair for pair in advice.pairs if pair.verdict in BETTER]
    unsure = [pair for pair in advice.pairs if pair.verdict == "cannot tell"]
    parts = [*(_better(pair, advice) for pair in decided), *(_unsure(pair, advice) for pair in unsure)]
    left = len(parts) - PAIRS_TOLD
    listed = joined(parts[:PAIRS_TOLD], "; ")
    if left > 0:
        listed += f"; {left} more pair{'s' if left > 1 else ''} in the table"
    ranked = say("{lead}: {listed}.", lead=_lead(advice.pairs), listed=listed) if parts else ""
    return joined([*(_gainsaid(pair, advice) for pair in gainsaid), ranked, seldom])


def pairs_table(advice: Advice) -> Table:
    """Return every two of the bats that were swung: the gain expected, how likely, and what was measured."""
    columns = table_head("bat | against | expected gain > | better: share | measured exit speed > | so")
    rows: list[list[Cell]] = [
        [
            pair.better,
            pair.other,
            goal_shown(pair.gain, advice.goal, sign=True),
            pair.chance,
            within(pair.measured, "speed_change", sign=True) if pair.measured else "not with both",
            VERDICTS[pair.verdict],
        ]
        for pair in advice.pairs
    ]
    return Table("", columns, rows)


def _lead(pairs: tuple[BatPair, ...]) -> str:
    """Return the conclusion from all pairs: the best bat, if there is one."""
    top = pairs[0].better
    verdicts = [pair.verdict for pair in pairs if pair.better == top]
    if all(verdict == "better" for verdict in verdicts):
        return f"Of the bats swung {top} is best"
    if all(verdict in BETTER for verdict in verdicts):
        return f"Of the bats swung {top} is best by the model"
    if any(pair.verdict in BETTER for pair in pairs):
        return "Of the bats swung none is surely the best of all"
    return "Of the bats swung none is surely better"


def _better(pair: BatPair, advice: Advice) -> Sentence:
    words = say(
        "{pair.better} against {pair.other} {gain}", pair=pair, gain=goal_shown(pair.gain, advice.goal, sign=True)
    )
    if pair.measured is None or not pair.goal_is_speed:
        return words
    more = pair.measured.low > pair.gain.high
    return words + say(
        ", as measured {measured:speed_change, sign, ends}{doubt}",
        measured=pair.measured,
        doubt=", which alone could not tell"
        if pair.verdict != "better"
        else ", more than the model explains"
        if more
        else "",
    )


def _unsure(pair: BatPair, advice: Advice) -> Sentence:
    gain = goal_shown(pair.gain, advice.goal, sign=True)
    if pair.measured is not None and pair.goal_is_speed and pair.measured.value < 0 < pair.gain.low:
        return say(
            "{pair.better} against {pair.other} {gain} by the model and {pair.measured:speed_change, sign, ends} as "
            "measured: not sure",
            pair=pair,
            gain=gain,
        )
    return say("{pair.better} against {pair.other} {gain}: not sure", pair=pair, gain=gain)


def _gainsaid(pair: BatPair, advice: Advice) -> Sentence:
    assert pair.measured is not None  # or nothing could gainsay the model
    return say(
        "Of {better} and {other} the swings say one thing and the model of ball and bat another: with {better} the "
        "ball left {measured:speed_change} slower on average, where the model expects {gain}. Believe the measurement "
        "if pitches and days were alike, and check the bats' files.",
        better=pair.better,
        other=pair.other,
        measured=-pair.measured.value,
        gain=goal_shown(pair.gain, advice.goal, sign=True),
    )


def _too_seldom(names: tuple[str, ...]) -> Words:
    if not names:
        return ""
    return f"Swung too seldom to be compared: {', '.join(names)}."

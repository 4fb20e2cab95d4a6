"""The bats that a player swung, each against each, in words and as a table."""

from __future__ import annotations

from sweetspot.player.advice import Advice
from sweetspot.player.bat_pairs import BatPair
from sweetspot.reports.document import Cell, Table, table_head
from sweetspot.reports.player.phrases import goal_shown
from sweetspot.reports.sentences import Sentence, Words, joined, say, within

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
        return "Of the bats swung no one is surely the best of all"
    return "Which of the bats swung is best the swings cannot tell"


def _better(pair: BatPair, advice: Advice) -> Sentence:
    words = say(
        "{better} against {other} {gain}",
        better=pair.better,
        other=pair.other,
        gain=goal_shown(pair.gain, advice.goal, sign=True),
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
            "{better} against {other} {gain} by the model and {measured:speed_change, sign, ends} as measured: the "
            "swings cannot tell",
            better=pair.better,
            other=pair.other,
            gain=gain,
            measured=pair.measured,
        )
    return say(
        "{better} against {other} {gain}: the swings cannot tell", better=pair.better, other=pair.other, gain=gain
    )


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
    return f"MeasuredBat too seldom to be compared: {', '.join(names)}."

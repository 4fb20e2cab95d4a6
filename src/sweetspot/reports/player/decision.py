"""What is decided about a player's bat and training by the player's own swings, and what holds for everybody."""

from __future__ import annotations

from sweetspot.player.advice import Advice, Option, Worth
from sweetspot.player.bat_pairs import measured_bats
from sweetspot.player.best_bat import BatChoice
from sweetspot.reports.player.phrases import changes, goal_shown, goal_words, option_words
from sweetspot.reports.sentences import Sentence, Words, joined, say

EXPERIMENT = (
    "Swings with two bats that differ enough in weight would tell: `sweetspot plan-swings` says which and how many."
)
LISTED = 3
"""Bats that the line for everybody names, and changes of the player that the first lines do."""
NEITHER_WAY = ("weight", "balance", "choke")
"""Families of small changes; the line for everybody names the best of each only."""


def lead_paragraphs(advice: Advice) -> list[Words]:
    """Return the decision of own swings, or that they cannot tell and what would; then what holds for anybody."""
    return [joined([_bat(advice), _training(advice)]), for_everybody(advice)]


def _bat(advice: Advice) -> Words:
    """Return the bat that the swings name, or why they name none."""
    choice = advice.choice
    if choice is not None and advice.named_best is not None:
        return joined([_named(choice, advice), *_computed(advice, "Better still, of bats not swung yet: {label}, ")])
    if computed := _computed(advice, "By this player's own swings {label} would be better: "):
        return computed[0]
    likeliest: Words = ""
    if choice is not None and choice.own:
        first = choice.bats[0]
        likeliest = say("; likeliest is {name}, with {chance:share}", name=first.name, chance=first.chance)
    several = len(measured_bats(advice.posterior.model)) > 1
    why = (
        "the bats are too much alike for it, or too few swings were made with each"
        if several
        else "all were made with one bat"
    )
    return say(
        "Which bat is best for this player these swings cannot tell{likeliest}: {why}. {experiment}",
        likeliest=likeliest,
        why=why,
        experiment=EXPERIMENT,
    )


def _computed(advice: Advice, text: str) -> list[Sentence]:
    """Return the bat that was not swung and that the own swings surely call better; nothing where there is none."""
    best = advice.surely_best
    if best is None or best.candidate.family == "swung":
        return []
    sentence = say(
        text + "{change}, with a chance of {chance:share}.",
        label=option_words(best.candidate),
        change=goal_shown(best.change, advice.goal, sign=True),
        chance=best.chance,
    )
    return [sentence]


def _named(choice: BatChoice, advice: Advice) -> Sentence:
    first, second = choice.bats[:2]
    return say(
        "Of {count} bats {best} is best for this player, with a chance of {chance:share}: {lead} of {goal} against "
        "{other}.",
        count="the two" if len(choice.bats) == 2 else f"the {len(choice.bats)}",
        best=first.name,
        chance=first.chance,
        lead=goal_shown(choice.lead, advice.goal, sign=True),
        goal=goal_words(advice.goal),
        other=second.name,
    )


def _training(advice: Advice) -> Words:
    """Return the changes surely worth training, by own swings."""
    sure = advice.surely_worth[:LISTED]
    if not sure:
        return ""
    listed = joined([_gain(worth, advice) for worth in sure], "; ")
    return say("Worth training, by these swings: {listed}.", listed=listed)


def _gain(worth: Worth, advice: Advice) -> Sentence:
    return say("{change} {gain}", change=changes()[worth.key], gain=goal_shown(worth.gain, advice.goal, sign=True))


def for_everybody(advice: Advice) -> Sentence:
    """Return the gains of any player, not by these swings, in one line."""
    better: list[Option] = []
    for option in sorted(advice.options, key=lambda option: -option.usual.value):
        small = option.candidate.family in NEITHER_WAY
        listed_already = small and any(other.candidate.family == option.candidate.family for other in better)
        if not option.own and not listed_already and advice.usual_sign(option) > 0:
            better.append(option)
    if not better:
        return say("For everybody, not by these swings: no bat tried is surely better.")
    listed = joined(
        [
            say(
                "{label} {gain}",
                label=option_words(option.candidate),
                gain=goal_shown(option.usual, advice.goal, sign=True),
            )
            for option in better[:LISTED]
        ],
        "; ",
    )
    return say("For everybody, not by these swings: {listed}.", listed=listed)

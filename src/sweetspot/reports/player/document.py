"""A player's fit as a document: the training report, and what stands behind it."""

from __future__ import annotations

from sweetspot.answers.player import FitPlayerAnswer
from sweetspot.answers.records import to_dict
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.player.advice import Advice
from sweetspot.player.goal import Goal
from sweetspot.player.posterior import Learned
from sweetspot.reports.document import (
    Bullets,
    Cards,
    Cell,
    Column,
    Document,
    Paragraph,
    Picture,
    Question,
    Section,
    Table,
    as_columns,
    drawn,
    table_head,
)
from sweetspot.reports.player.phrases import GOALS, goal_shown, goal_words, option_words, pairs_table, pitch_words
from sweetspot.reports.player.training import training_section
from sweetspot.reports.player.words import PARAMETERS, answers, findings, notes, parameter_shown
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import Sentence, Slot, Words, read, say

LEAD = 2
"""Paragraphs that decide; what stands behind them opens on demand."""


def player_document(answer: FitPlayerAnswer, *, player: str = "", day: str = "") -> Document:
    """Return the training report as a document."""
    advice, found, asked = answer.advice, findings(answer), answers(answer.advice)
    untried = [f"Could not be tried: {fault}." for fault in answer.not_tried]
    picture = Picture(
        "player",
        drawn("sweetspot.reports.player.picture:player_figure", advice, player=player, day=day),
        label=say(
            "Contacts on the barrel, bat speed against exit speed, what changes of player and bat are worth in {goal}, "
            "and the swing from the side and from behind.",
            goal=goal_words(advice.goal),
        ),
        caption="Lines are 90 % intervals over what the swings allow.",
        sheet=drawn("sweetspot.reports.player.picture:player_sheet", advice),
    )
    return Document(
        name="player",
        kind="Training report",
        title=advice.posterior.model.bats[0].bat.name,
        subtitle=say("for {goal}, {pitch}", goal=goal_words(advice.goal), pitch=pitch_words(advice.pitch_speed)),
        blocks=[
            _cards(advice),
            *map(Paragraph, found[:LEAD]),
            picture,
            training_section(advice),
        ],
        details=[
            Section("swings", "What the swings say", [*map(Paragraph, found[LEAD:])]),
            Section("answers", "Questions and answers", [Question(*pair) for pair in asked]),
            *([Section("pairs", "The bats swung, each against each", [pairs_table(advice)])] if advice.pairs else []),
            Section("bats", "Bats tried, the best first", [_bats(advice)]),
            Section("numbers", "The player in numbers", [_facts(advice.posterior.learned)]),
            Section("file", "About the file", [Bullets([*notes(answer.file), *untried, _means(advice.goal)])]),
        ],
        data={
            **answer.to_dict(),
            "findings": [read(words, US) for words in found],
            "answers": [{"question": question, "answer": read(words, US)} for question, words in asked],
        },
        rows=as_columns([to_dict(row) for row in answer.rows]),
        drawing=picture,
    )


def _cards(advice: Advice) -> Cards:
    """Return the numbers that a player asks for first, large."""
    scale, digits = GOALS[advice.goal.name]
    learned = advice.posterior.learned
    cards: list[tuple[Words, Words]] = [
        (Sentence((Slot(advice.now.value, scale, digits),)), say("expected {goal} now", goal=goal_words(advice.goal))),
        (Sentence((Slot(learned["bat_speed"].interval.value, "speed"),)), "mean bat speed"),
        (Sentence((Slot(learned["position_spread"].interval.value, "place"),)), "scatter of contact along the bat"),
        (Sentence((Slot(advice.contact_point.value, "place"),)), "from the tip: best place to meet the ball"),
    ]
    return Cards(cards)


def _bats(advice: Advice) -> Table:
    """Return the bats tried, the player's own first."""
    goal, bat_now = advice.goal, advice.posterior.model.bats[0].bat
    columns = table_head(
        "bat | mass: mass | MOI: moi | bat speed: speed | expected > | change > | better: share | for anybody > | "
        "by these swings"
    )
    rows: list[list[Cell]] = [[f"{bat_now.name} (now)", "", "", "", goal_shown(advice.now, goal), "", "", "", ""]]
    for option in advice.options:
        bat, body = option.candidate.bat, option.candidate.body
        expected, change = goal_shown(option.goal, goal), goal_shown(option.change, goal, sign=True)
        moi = body.moi(bat.choke + STANDARD_AXIS)
        name = option_words(option.candidate)
        usual = goal_shown(option.usual, goal, sign=True)
        evidence = "yes" if option.own else "cannot tell" if option.length_known else "length not swung"
        rows.append([name, body.mass, moi, option.bat_speed.value, expected, change, option.chance, usual, evidence])
    return Table("", columns, rows)


def _facts(learned: dict[str, Learned]) -> Table:
    """Return every parameter: value, interval, prior, and whether the data determine it."""
    columns = table_head("parameter | value (90 %) | before the data")
    rows: list[list[Cell]] = [
        [
            PARAMETERS[name][0],
            parameter_shown(name, parameter.interval),
            parameter_shown(name, parameter.before),
            parameter.width_ratio,
            "yes" if parameter.told else "data cannot tell",
        ]
        for name, parameter in learned.items()
    ]
    return Table("", [*columns, Column("width ratio", "ratio", 2), Column("learned")], rows)


def _means(goal: Goal) -> str:
    """Return an explanation of the numbers."""
    fast = goal.name == "exit-speed"
    missed = "misses and balls just grazed are not in it" if fast else "misses and balls just grazed bring nothing"
    extra = "" if fast else " Carry is to the first touch of the ground, in still air."
    return (
        "In brackets: 90 % intervals over what the data allow. Expected: the mean over this player's scatter of "
        f"swings; {missed}.{extra} With another bat the player is taken to meet the ball equally far from the tip. "
        "Better: the part of what the data allow in which the bat is better."
    )

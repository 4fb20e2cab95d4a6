"""A player's fit as a document: the training report, and what stands behind it."""

from __future__ import annotations

from typing import Any

from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.player.advice import Advice
from sweetspot.player.goal import Goal
from sweetspot.player.posterior import Posterior
from sweetspot.player.swings import Swings
from sweetspot.report.document import (
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
)
from sweetspot.report.json_shapes import as_columns
from sweetspot.report.player.goals import GOALS, goal_shown, goal_words, pitch_words
from sweetspot.report.player.numbers import option_rows, player_json
from sweetspot.report.player.pair_words import pairs_table
from sweetspot.report.player.tried_bats import option_words
from sweetspot.report.player.words import (
    PARAMETERS,
    answers,
    findings,
    notes,
    parameter_shown,
)
from sweetspot.report.quantities import Reader
from sweetspot.report.sentences import Sentence, Slot, Words, say


def player_document(
    posterior: Posterior, advice: Advice, swings: Swings, *, player: str = "", day: str = ""
) -> Document:
    """Return the training report as a document.

    Parameters
    ----------
    player : whom it is for, named in the picture.
    day : when it was made, in the picture too.
    """
    untried = [f"Could not be tried: {fault}." for fault in advice.faults]
    picture = Picture(
        "player", lambda reading: _drawn(posterior, advice, reading, player=player, day=day),
        label=say(
            "Expected {goal} against the contact point, and what changes of player and bat are worth.",
            goal=goal_words(advice.goal),
        ),
        caption="Lines are 90 % intervals over what the swings allow.",
        sheet=lambda reading: _drawn_sheet(posterior, advice, reading),
    )  # fmt: skip
    return Document(
        name="player", kind="Training report", title=posterior.model.bats[0].bat.name,
        subtitle=_subtitle(advice),
        blocks=[
            _cards(posterior, advice), *map(Paragraph, findings(posterior, swings)),
            Section("answers", "Questions and answers", [Question(*one) for one in answers(advice)]), picture,
        ],
        details=[
            *([Section("pairs", "The bats swung, each against each", [pairs_table(advice)])] if advice.pairs else []),
            Section("bats", "Bats tried, the best first", [_bats(advice)]),
            Section("numbers", "The player in numbers", [_facts(posterior)]),
            Section("file", "About the file", [Bullets([*notes(swings), *untried, _means(advice.goal)])]),
        ],
        data=player_json(posterior, advice, swings), rows=as_columns(option_rows(advice)), drawing=picture,
    )  # fmt: skip


def _subtitle(advice: Advice) -> Sentence:
    return say(
        "for {goal}, {pitch}", goal=goal_words(advice.goal), pitch=pitch_words(advice.pitch_speed),
    )  # fmt: skip


def _cards(posterior: Posterior, advice: Advice) -> Cards:
    """Return the numbers that a player asks for first, large."""
    scale, digits = GOALS[advice.goal.name]
    learned = posterior.learned
    cards: list[tuple[Words, Words]] = [
        (Sentence((Slot(advice.now.value, scale, digits),)), say("expected {goal} now", goal=goal_words(advice.goal))),
        (Sentence((Slot(learned["bat_speed"].interval.value, "speed"),)), "mean bat speed"),
        (Sentence((Slot(learned["position_spread"].interval.value, "place"),)), "scatter of contact along the bat"),
        (Sentence((Slot(advice.contact_point.value, "place"),)), "from the tip: best place to meet the ball"),
    ]
    return Cards(cards)


def _bats(advice: Advice) -> Table:
    """Return the bats tried, the player's own first."""
    own = advice.posterior.model.bats[0].bat
    columns = [
        Column("bat"), Column("mass", "mass"), Column("MOI", "moi"), Column("bat speed", "speed"),
        Column("expected", right=True), Column("change", right=True), Column("better", "share"),
    ]  # fmt: skip
    rows: list[list[Cell]] = [[f"{own.name} (now)", "", "", "", goal_shown(advice.now, advice.goal), "", ""]]
    for option in advice.options:
        bat, body = option.candidate.bat, option.candidate.body
        rows.append([
            option_words(option.candidate), body.mass, body.moi(bat.choke + STANDARD_AXIS), option.bat_speed.value,
            goal_shown(option.goal, advice.goal), goal_shown(option.change, advice.goal, sign=True), option.chance,
        ])  # fmt: skip
    return Table("", columns, rows)


def _facts(posterior: Posterior) -> Table:
    """Return every parameter: value, interval, what was known before, whether the data told."""
    columns = [Column("parameter"), Column("value (90 %)"), Column("before the data")]
    rows: list[list[Cell]] = [
        [
            PARAMETERS[name][0], parameter_shown(name, one.interval), parameter_shown(name, one.before),
            one.width_ratio, "yes" if one.told else "data cannot tell",
        ]
        for name, one in posterior.learned.items()
    ]  # fmt: skip
    return Table("", [*columns, Column("width ratio", "ratio", 2), Column("learned")], rows)


def _means(goal: Goal) -> str:
    """Return what the numbers mean."""
    fast = goal.name == "exit-speed"
    missed = "misses and balls just grazed are not in it" if fast else "misses and balls just grazed bring nothing"
    extra = "" if fast else " Carry is to the first touch of the ground, in still air."
    return (
        "In brackets: 90 % intervals over what the data allow. Expected: the mean over this player's scatter of "
        f"swings; {missed}.{extra} With another bat the player is taken to meet the ball equally far from the tip. "
        "Better: the part of what the data allow in which the bat is better."
    )


def _drawn(posterior: Posterior, advice: Advice, reading: Reader, *, player: str, day: str) -> Any:
    from sweetspot.report.player.picture import player_figure

    return player_figure(posterior, advice, player=player, day=day, reading=reading)


def _drawn_sheet(posterior: Posterior, advice: Advice, reading: Reader) -> Any:
    from sweetspot.report.player.picture import ON_A_SHEET, player_figure

    return player_figure(posterior, advice, reading=reading, paper=ON_A_SHEET)

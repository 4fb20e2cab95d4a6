"""What a player should train: changes ranked by what they bring this one, and where he stands among others."""

from __future__ import annotations

from dataclasses import astuple

from sweetspot.catalog.league_batters import major_league
from sweetspot.player.advice import Advice
from sweetspot.player.standing import RankedQuantity
from sweetspot.reports.document import Cell, Paragraph, Section, Table, table_head
from sweetspot.reports.player.phrases import changes, goal_shown, goal_words
from sweetspot.reports.player.words import PARAMETERS
from sweetspot.reports.sentences import Sentence, say, within

SQUARED_UP = ("squared up, of balls in play", "share", 0)
USUAL = "what is usual for players"


def training_section(advice: Advice) -> Section:
    """Return the changes by their worth, the standing among others, and the hardest hits at this bat speed."""
    tables = [_worth_table(advice)]
    if advice.standing.quantities:
        tables.append(_standing_table(advice))
    hardest = hardest_words(advice)
    return Section("training", "What to train", [*tables, *([Paragraph(hardest)] if hardest is not None else [])])


def _worth_table(advice: Advice) -> Table:
    goal = advice.goal
    rows: list[list[Cell]] = [
        [
            changes()[worth.key],
            goal_shown(worth.gain, goal, sign=True),
            goal_shown(worth.usual, goal, sign=True),
            "yes" if worth.own else "cannot tell",
        ]
        for worth in advice.ranked_worth
    ]
    columns = table_head("change | worth > | for anybody > | by these swings")
    return Table(say("What a change of the player is worth in {goal}", goal=goal_words(goal)), columns, rows)


def _standing_table(advice: Advice) -> Table:
    rows: list[list[Cell]] = []
    for standing in advice.standing.quantities:
        name, scale, digits = PARAMETERS.get(standing.name, SQUARED_UP)
        value = within(standing.value, scale, digits=digits)
        rows.append([name, value, _among(standing), of_hundred(standing)])
    columns = table_head("quantity | this player > | beside | have less, of 100 >")
    return Table("Beside other batters", columns, rows)


def _among(standing: RankedQuantity) -> str:
    others = {"league": major_league().name, "same bat speed": "those of the same bat speed", "usual": USUAL}
    return others[standing.against]


def of_hundred(standing: RankedQuantity) -> str:
    """Return how many of a hundred have less, with the interval; of a league no more than its quantiles say."""
    value, low, high = (f"{100 * part:.0f}" for part in astuple(standing.share_below))
    least, most = major_league().bat_speed.levels[[0, -1]]
    if standing.against == "league" and not least < standing.share_below.value < most:
        return f"{'at most' if standing.share_below.value <= least else 'at least'} {value}"
    return value if low == high else f"{value} ({low} to {high})"


def hardest_words(advice: Advice) -> Sentence | None:
    """Return a comparison with the hardest-hit balls at this bat speed, None where none are tabled."""
    hardest, off_path = advice.standing.hardest_hit, advice.standing.off_path
    if hardest is None:
        return None
    text = say(
        "Of {hardest.balls} major-league balls at this bat speed ({hardest.slowest:speed, 0, bare} to "
        "{hardest.fastest:speed, 0}) the hardest-hit fifth, {hardest.exit_speed:speed, 0} and up, left within "
        "{hardest.best_off_path:angle, 0} of the bat's path half of the time, the others within "
        "{hardest.others_off_path:angle, 0}",
        hardest=hardest,
    )
    if off_path is not None:
        text += say("; this player's do within {off:angle, 0, ends}", off=off_path)
    return text + say(
        ". Their attack angle was {hardest.best_attack_angle:angle, 0} on average, the others' "
        "{hardest.others_attack_angle:angle, 0}.",
        hardest=hardest,
    )

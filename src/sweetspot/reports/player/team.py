"""A team on one sheet: a row for every batter of a file, and what each leans on the league."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.answers.records import to_dict
from sweetspot.answers.team import FitTeamAnswer, TeamBatter
from sweetspot.player.goal import Goal
from sweetspot.player.prior import ANYBODY, NAMES, Population, population_range
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Document,
    Paragraph,
    Section,
    Table,
    as_columns,
    table_head,
)
from sweetspot.reports.player.decision import for_everybody
from sweetspot.reports.player.phrases import GOALS, goal_shown, goal_words, option_words
from sweetspot.reports.player.words import PARAMETERS, parameter_shown, taken_for
from sweetspot.reports.sentences import Sentence, Slot, Words, say
from sweetspot.units import INCH

MEANS = say(
    "The batter who surely gains most by own swings stands first. Bat speed and scatter: most likely values. Expected: "
    "the mean over the batter's swings with the bat now. Best place: mean contact from the tip. Less scatter: what "
    "{inch:place, round} less of it along the bat brings, with its 90 % interval, where own swings say so. A bat "
    "is named only where the batter's own swings say so and the 90 % interval of its gain leaves zero out.",
    inch=INCH,
)
NO_LEAGUE = "With fewer than five batters nothing is known of how they differ; each is fitted alone."
POOLED = {"bat_speed": "speed", "position_spread": "along", "offset_spread": "across"}
"""Parameters whose lean stands in the table, by heading; the JSON has all."""
LEANS = (
    "Mean bat speed, and scatter of contact along and across the bat: first from the batter's own swings and what is "
    "usual for players, then pooled, knowing how the batters of this file differ; the sheet rests on these. Own: how "
    "much of the pooled scatter along the bat is the batter's own word, the rest is the league's; few swings lean on "
    "the league, many hardly move."
)


def team_document(answer: FitTeamAnswer) -> Document:
    """Return a team as a document of one sheet, the batter who surely gains most by own swings first."""
    batters, goal, population = answer.batters, answer.question.goal, answer.population
    blocks: list[Block] = [_table(batters, goal), Paragraph(MEANS, "note")]
    if len(_bats(batters)) == 1:  # what holds for everybody is the same for all who swing one bat
        blocks.insert(0, Paragraph(for_everybody(batters[0].advice)))
    taken = dict.fromkeys(words for batter in batters for words in taken_for(batter.posterior.model))
    blocks += [Paragraph(words, "note") for words in taken]
    if answer.left_out:
        blocks += [Paragraph("Left out:"), Bullets(list(answer.left_out))]
    details: list[Block] = []
    if population is None:
        blocks.append(Paragraph(NO_LEAGUE, "note"))
    else:
        details = [
            Section("pooled", "Alone and pooled", [_lean(batters), Paragraph(LEANS, "note")]),
            Section("league", "How the batters differ", [_league(population)]),
        ]
    return Document(
        name="team",
        title="Team sheet",
        subtitle=say(
            "{count} {noun}, for {goal}; {bat}",
            count=len(batters),
            noun="batter" if len(batters) == 1 else "batters",
            goal=goal_words(goal),
            bat=", ".join(_bats(batters)),
        ),
        kind="Training report",
        blocks=blocks,
        details=details,
        data=answer.to_dict(),
        rows=as_columns([to_dict(row) for row in answer.rows]),
    )


def _bats(batters: Sequence[TeamBatter]) -> list[str]:
    return sorted({batter.bat for batter in batters})


def _table(batters: Sequence[TeamBatter], goal: Goal) -> Table:
    scale, digits = GOALS[goal.name]
    several = len(_bats(batters)) > 1
    columns = [
        Column("batter"),
        Column("swings", right=True),
        *([Column("bat now")] if several else []),
        Column("bat speed", "speed"),
        Column("scatter", "place"),
        Column("expected", scale, digits=digits),
        Column("best at", "place"),
        Column("less scatter", right=True),
        Column("a better bat"),
    ]
    rows: list[list[Cell]] = [
        [
            batter.batter,
            f"{batter.swings}",
            *([batter.bat] if several else []),
            float(batter.bat_speed),
            float(batter.position_spread),
            float(batter.expected),
            float(batter.contact_point_from_tip),
            _less_scatter(batter, goal),
            _better(batter, scale, digits),
        ]
        for batter in batters
    ]
    return Table("", columns, rows)


def _less_scatter(batter: TeamBatter, goal: Goal) -> Words:
    worth = batter.advice.worth["position_spread"]
    return goal_shown(worth.gain, goal, sign=True) if worth.own else "swings cannot tell"


def _better(batter: TeamBatter, scale: str, digits: int | None) -> Words:
    best = batter.best
    if best is None:
        return "swings cannot tell"
    gain = Sentence((Slot(best.change.value, scale, digits, sign=True),))
    return say("{label} {gain}", label=option_words(best.candidate), gain=gain)


def _lean(batters: Sequence[TeamBatter]) -> Table:
    columns = table_head("batter | swings >")
    for name, heading in POOLED.items():
        _, scale, digits = PARAMETERS[name]
        columns += [Column(heading, scale, digits=digits), Column("pooled", scale, digits=digits)]
    rows: list[list[Cell]] = []
    for batter in batters:
        cells: list[Cell] = [batter.batter, f"{batter.swings}"]
        for name in POOLED:
            cells += [fit.learned[name].interval.value for fit in (batter.alone, batter.posterior)]
        rows.append([*cells, batter.parameters["position_spread"].own_share])
    return Table("", [*columns, Column("own", "share")], rows)


def _league(population: Population) -> Table:
    """Return every parameter: the league's middle and what 90 % of its batters lie within, and what is usual."""
    columns = table_head("parameter | this league (90 % of its batters) | players as is usual")
    ranges = [population_range(players) for players in (population, ANYBODY)]
    rows: list[list[Cell]] = [
        [PARAMETERS[name][0], *(parameter_shown(name, by_name[name]) for by_name in ranges)] for name in NAMES
    ]
    return Table("", columns, rows)

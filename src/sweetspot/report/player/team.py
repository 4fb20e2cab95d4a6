"""A team on one sheet: a row for every batter of a file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from sweetspot.player.advice import Advice, Option
from sweetspot.player.goal import Goal
from sweetspot.player.prior import Population
from sweetspot.report.document import Block, Bullets, Cell, Column, Document, Paragraph, Table
from sweetspot.report.json_shapes import as_columns, cleaned
from sweetspot.report.player.goals import GOALS, goal_words
from sweetspot.report.player.pooled import league_json, league_sections, pooled_parameters
from sweetspot.report.player.teammate import Teammate
from sweetspot.report.player.tried_bats import option_words
from sweetspot.report.player.words import taken_for
from sweetspot.report.sentences import Sentence, Slot, Words, say
from sweetspot.units import INCH

MEANS = say(
    "Bat speed and scatter: most likely values. Expected: the mean over the batter's swings with the bat now. Best "
    "place: mean contact from the tip. Less scatter: what {inch} less of it along the bat brings. A bat is named only "
    "where the 90 % interval of its gain leaves zero out; (law) stands behind it where the average player's swing law "
    "says so and not these swings.", inch=Slot(INCH, "place", round=True),
)  # fmt: skip
NO_LEAGUE = "With fewer than five batters nothing is known of how they differ; each is fitted alone."


def team_document(
    members: Sequence[Teammate], left_out: Sequence[str], goal: Goal, league: Population | None = None
) -> Document:
    """Return a team as a document of one sheet, the batter with the most to gain from less scatter first.

    Parameters
    ----------
    left_out : batters of whom nothing can be told, and why.
    league : how the batters differ; None: too few to know, and each is fitted alone.
    """
    ordered = sorted(members, key=lambda member: -member.advice.worth["position_spread"].gain.value)
    blocks: list[Block] = [_table(ordered, goal), Paragraph(MEANS, "note")]
    taken = dict.fromkeys(words for one in ordered for words in taken_for(one.posterior.model))
    blocks += [Paragraph(words, "note") for words in taken]
    if left_out:
        blocks += [Paragraph("Left out:"), Bullets(list(left_out))]
    rows = [_row(member) for member in ordered]
    if league is None:
        blocks.append(Paragraph(NO_LEAGUE, "note"))
    noun = "batter" if len(members) == 1 else "batters"
    return Document(
        name="team", title="Team sheet",
        subtitle=say("{count} {noun}, for {goal}; {bat}", count=len(members), noun=noun, goal=goal_words(goal),
                     bat=", ".join(_bats(members))),
        kind="Training report", blocks=blocks, details=[] if league is None else league_sections(ordered, league),
        data={
            "batters": [row | {"parameters": pooled_parameters(member, league)}
                        for row, member in zip(rows, ordered, strict=True)],
            "league": league and league_json(league, len(members)), "left_out": list(left_out),
        },
        rows=as_columns(rows),
    )  # fmt: skip


def _bat(member: Teammate) -> str:
    return member.posterior.model.bats[0].bat.name


def _bats(members: Sequence[Teammate]) -> list[str]:
    return sorted({_bat(member) for member in members})


def _table(members: Sequence[Teammate], goal: Goal) -> Table:
    scale, digits = GOALS[goal.name]
    several = len(_bats(members)) > 1
    columns = [
        Column("batter"), Column("swings", right=True), *([Column("bat now")] if several else []),
        Column("bat speed", "speed"), Column("scatter", "place"), Column("expected", scale, digits=digits),
        Column("best at", "place"), Column("less scatter", scale, digits=digits, sign=True), Column("a better bat"),
    ]  # fmt: skip
    rows: list[list[Cell]] = []
    for member in members:
        learned, advice = member.posterior.learned, member.advice
        rows.append([
            member.name, f"{len(member.posterior.model.swings)}", *([_bat(member)] if several else []),
            learned["bat_speed"].interval.value, learned["position_spread"].interval.value, advice.now.value,
            advice.contact_point.value, advice.worth["position_spread"].gain.value, _better(advice, scale, digits),
        ])  # fmt: skip
    return Table("", columns, rows)


def _better(advice: Advice, scale: str, digits: int | None) -> Words:
    best = best_option(advice)
    if best is None:
        return "none surely"
    law = "" if advice.posterior.learned["exponent"].told else " (law)"
    gain = Sentence((Slot(best.change.value, scale, digits, sign=True),))
    return say("{label} {gain}{law}", label=option_words(best.candidate), gain=gain, law=law)


def best_option(advice: Advice) -> Option | None:
    """Return the bat that is surely better by most, None where there is none."""
    return next((option for option in advice.options if advice.sign_of(option) > 0), None)


def _row(member: Teammate) -> dict[str, Any]:
    learned, advice = member.posterior.learned, member.advice
    best = best_option(advice)
    return cleaned({
        "batter": member.name,
        "swings": len(member.posterior.model.swings),
        "bat": member.posterior.model.bats[0].bat.name,
        "bat_speed_m_s": learned["bat_speed"].interval.value,
        "bat_speed_alone_m_s": member.alone.learned["bat_speed"].interval.value,
        "position_spread_m": learned["position_spread"].interval.value,
        "position_spread_alone_m": member.alone.learned["position_spread"].interval.value,
        "goal": advice.goal.name,
        "expected": advice.now.value,
        "contact_point_from_tip_m": advice.contact_point.value,
        "one_inch_less_scatter": advice.worth["position_spread"].gain.value,
        "better_bat": None if best is None else best.candidate.label,
        "better_by": None if best is None else best.change.value,
    })  # fmt: skip

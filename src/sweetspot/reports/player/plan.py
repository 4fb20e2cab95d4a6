"""A plan of swings as a document: what to swing and why, and the sheet to fill in."""

from __future__ import annotations

import csv
import io
from itertools import groupby

from sweetspot.answers.plan_swings import PlanSwingsAnswer
from sweetspot.numerics.interval import Interval
from sweetspot.reports.document import Cell, Document, Paragraph, Section, Table, as_columns, table_head
from sweetspot.reports.player.words import parameter_shown
from sweetspot.reports.sentences import Sentence, Slot, Words, joined, say

SOUGHT = {
    "exponent": ("what a heavier bat costs this player, the exponent n", "ratio", 3),
    "position": ("where this player meets the ball on average", "place", 2),
}
"""Of what is to be found: its name, its scale and digits."""
SHEET = "sheet.csv"
HEADINGS = ("swing", "bat", "bat_speed_mph", "exit_speed_mph", "pitch_speed_mph", "position_in_from_tip")
ORDER = (
    "Swing in this order, a few with each bat in turn, so that warming up and getting tired count alike for all. Full "
    "swings only; write down every one, good or bad."
)
HOW = {
    "exponent": "Measure the bat speed of every swing with the same sensor; exit speeds help and are not needed.",
    "position": "Mark the barrel with tape or spray, and write down where the ball's mark is, from the tip.",
}


def plan_document(answer: PlanSwingsAnswer) -> Document:
    """Return a plan of swings as a document, with the sheet as a file to fill in."""
    blocks = [Paragraph(lead_words(answer))]
    if answer.order:
        blocks += [Paragraph(HOW[answer.aim]), *([Paragraph(ORDER)] if len(answer.bats) > 1 else [])]
    columns = table_head("swings | bat")
    rows: list[list[Cell]] = []
    first = 1 + (answer.swings_made if answer.verdict == "go on" else 0)
    for name, turn in groupby(answer.order):
        count = len(list(turn))
        rows.append([f"{first}-{first + count - 1}" if count > 1 else f"{first}", name])
        first += count
    bats = Table(
        "", table_head("bat | mass: mass | MOI: moi | swings >"),
        [[bat.name, float(bat.mass), float(bat.moi_6in), f"{bat.swings}"] for bat in answer.bats],
    )  # fmt: skip
    return Document(
        name="plan-swings",
        kind="Plan of swings",
        title=answer.question.bats[0].name,
        subtitle=say("to find {sought}", sought=SOUGHT[answer.aim][0]),
        blocks=[*blocks, *([Section("order", "The order", [Table("", columns, rows)])] if rows else [])],
        details=[Section("bats", "The bats", [bats])],
        data=answer.to_dict(),
        rows=as_columns(sheet_rows(answer)),
        attachments={SHEET: lambda _: sheet_csv(answer)} if answer.order else {},
    )


def lead_words(answer: PlanSwingsAnswer) -> Words:
    """Return the verdict of a plan in words."""
    within, expected = (_error(answer, error) for error in (answer.within, answer.expected_error))
    names = joined([say("{name}", name=bat.name) for bat in answer.bats], " and ")
    count, sought = len(answer.order) or answer.further, SOUGHT[answer.aim][0]
    if answer.verdict == "known":
        return say("No swing is needed: {sought} is known to {within} of any player.", sought=sought, within=within)
    if answer.verdict == "too many":
        return say(
            "These bats cannot find {sought} to within {within}: {count} swings with {names} would find it to within "
            "{expected}. Give bats that differ more in weight, or ask for less.",
            sought=sought, within=within, count=count, names=names, expected=expected,
        )  # fmt: skip
    if answer.verdict == "swing":
        return say(
            "{count} swings with {names} are expected to find {sought} to within {expected}; after each batch of "
            "{batch} the filled sheet says whether to stop.",
            count=count, names=names, sought=sought, expected=expected, batch=answer.question.batch,
        )  # fmt: skip
    assert isinstance(answer.estimate, Interval)
    found = parameter_shown(answer.aim, answer.estimate)
    if answer.verdict == "stop":
        return say(
            "Stop: after {made} swings {sought} is {found}, which is within {within}.",
            made=answer.swings_made, sought=sought, found=found, within=within,
        )  # fmt: skip
    return say(
        "Go on: after {made} swings {sought} is {found}, not yet within {within}; some {further} more are expected to "
        "do. The next {count} follow.",
        made=answer.swings_made, sought=sought, found=found, within=within, further=answer.further, count=count,
    )  # fmt: skip


def _error(answer: PlanSwingsAnswer, error: float) -> Sentence:
    _, scale, digits = SOUGHT[answer.aim]
    return Sentence((Slot(error, scale, digits),))


def sheet_rows(answer: PlanSwingsAnswer) -> list[dict[str, object]]:
    """Return the rows of the sheet, with nothing but the bats in them."""
    first = 1 + answer.swings_made
    return [
        dict.fromkeys(HEADINGS, "") | {"swing": number, "bat": name} for number, name in enumerate(answer.order, first)
    ]


def sheet_csv(answer: PlanSwingsAnswer) -> bytes:
    """Return the sheet to fill in, as CSV."""
    text = io.StringIO()
    writer = csv.DictWriter(text, HEADINGS, lineterminator="\n")
    writer.writeheader()
    writer.writerows(sheet_rows(answer))
    return text.getvalue().encode()

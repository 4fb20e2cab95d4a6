"""A tested golf club and the rules held against it as a document."""

from __future__ import annotations

from sweetspot.analysis.certification.rules import Verdict
from sweetspot.answers.certify_club import CertifyClubAnswer
from sweetspot.reports.certification.limits_shown import broken_rules, value_shown
from sweetspot.reports.certification.rules_shown import listed, reasons, rules_table
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, as_columns
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.reports.uncertainty import chance_words

FAILS = "{club} fails: {rules}."
KEEPS = "{club} is legal: characteristic time {time}, at most {limit} is allowed."
PROBABLY = "{club} is legal with a probability of {chance}: characteristic time {time}, at most {limit} is allowed."
READ_IT = (
    "The characteristic time of this face was not read: it is computed from the stiffness in its file. A club fitter's "
    'pendulum settles it; write what it reads into the file, [head] characteristic_time = "245 us".'
)
HOW = (
    "The characteristic time goes with the square root of the face's give. Its constant was fitted to one published "
    "pair of limits, 239 µs and 0.822; the other, 257 µs and 0.830, is then met to 0.001. The restitution also "
    "depends on the mass of the face that moves with the ball, which was not measured."
)


def certify_club_document(answer: CertifyClubAnswer) -> Document:
    """Return a tested club as a document."""
    blocks: list[Block] = [Paragraph(_headline(answer))] if answer.checks else []
    if not answer.test.read:
        blocks.append(Paragraph(READ_IT))
    blocks += [_test(answer), Paragraph(HOW)]
    if answer.checks:
        blocks += [rules_table(answer.checks), *listed(reasons(answer.checks))]
    data = answer.to_dict()
    return Document(
        name="certify",
        title=answer.club.name,
        subtitle=answer.ball,
        kind="Club test",
        blocks=blocks,
        data=data,
        rows=as_columns(data["checks"]),
        passed=answer.passed,
    )


def _headline(answer: CertifyClubAnswer) -> Sentence:
    name = answer.club.name
    failed = [check for check in answer.checks if check.outcome.verdict is Verdict.FAIL and check.sure]
    if failed:
        return say(FAILS, club=name, rules=broken_rules(failed))
    timed = next(check for check in answer.checks if check.quantity == "characteristic_time")
    chance = timed.passes_probability
    words = KEEPS if chance is None else PROBABLY
    return say(
        words,
        club=name,
        chance="" if chance is None else chance_words(chance),
        time=value_shown(timed.quantity, answer.test.characteristic_time),
        limit=value_shown(timed.quantity, timed.most),
    )


def _test(answer: CertifyClubAnswer) -> Table:
    test = answer.test
    how = "read" if test.read else "computed"
    rows: list[list[Cell]] = [
        ["characteristic time of the face", Slot(test.characteristic_time, "tap_time"), how],
        ["restitution of the bare head", Slot(test.cor, "ratio", 3), say("ball at {speed:speed, 0}", speed=test.speed)],
        ["moment of inertia of the head", Slot(test.head_moi, "head_moi"), "about the vertical"],
    ]
    return Table("", [Column("what"), Column("value", right=True), Column("")], rows)

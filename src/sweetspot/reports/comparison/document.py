"""A comparison as a document: who gains, what the implements are, what they do in play, and what that assumes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from sweetspot.analysis.certification.rules import NOT_SURE, Verdict
from sweetspot.analysis.comparison import Comparison
from sweetspot.answers.certify import CertifyAnswer, RuleCheck
from sweetspot.answers.compare import CompareAnswer, ComparedBat, compare_of
from sweetspot.answers.what_if import BAT_CELLS, FailedCell, WhatIfAnswer, cells_as_columns
from sweetspot.catalog.sports import sport
from sweetspot.catalog.swing_laws import swing_weight
from sweetspot.dynamics.rigid import moi_doubt
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.numerics.interval import Number, chance_above, interval_of
from sweetspot.reports.bat.tables import moment
from sweetspot.reports.certification.limits_shown import MARKS, broken_rules, limit_shown, value_shown
from sweetspot.reports.comparison.words import assumed, breaking_words, cork_verdict, gain_words, verdict
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Document,
    Marked,
    Paragraph,
    Picture,
    Table,
    as_columns,
    drawn,
    table_head,
)
from sweetspot.reports.grid import Grid, Side, varied
from sweetspot.reports.many import grid_document
from sweetspot.reports.quantities import QUANTITIES, reader
from sweetspot.reports.sentences import PLUS_MINUS, Sentence, Slot, Words, joined, read, say, within
from sweetspot.reports.uncertainty import how_sure
from sweetspot.uncertainty.sources import sources_of
from sweetspot.units import INCH

BBCOR_OF_PLAY = (
    "BBCOR in play is at this swing's closing speed. The number that rules limit is measured otherwise, in a test with "
    "the bat at rest{where}."
)

PLACES = INCH * np.array([1, 2, 3, 4, 5, 6, 7, 8, 10, 12])
"""m from the tip; hits that are listed one by one."""
MOST_BY_PLACE = 3
"""Bats beside the first whose columns fit a terminal; the picture draws any number."""
HANDLING = ("recoil weight kg cm²", "twist weight kg cm²", "MGR/I 1/s²", "polarization")
OF_MASS = ("mass", "balance_point", "moi_6in", "moi_knob")
"""Mass properties of a bat's row."""
WITH_RULES, WITHOUT = ", as in the table of the rules", "; `sweetspot certify` computes that one"


def compare_document(answer: CompareAnswer) -> Document:
    """Return a comparison as a document."""
    reference, bats, uncertainty = answer.comparison.reference.analysis, answer.bats, answer.uncertainty
    its = sport(reference.bat.sport)
    reading, tool, number = reader(None, its.words), its.words.implement, len(bats)
    gains, corked = verdict(answer), cork_verdict(answer)
    chances = [] if uncertainty is None else [gain_words(gain, answer.reference) for gain in uncertainty.gains]
    main = "exit speed" if number == 1 else f"change of {bats[-1].label}"
    picture = Picture(
        "curves", drawn("sweetspot.reports.comparison.picture:compare_figure", answer),
        label=f"Outlines, exit speed along each {tool}, and the difference from the first one.",
        caption="Tips aligned. Boxes: sweet zones. Dots: best places.",
        sheet=drawn("sweetspot.reports.comparison.picture:compare_sheet", answer),
    )  # fmt: skip
    ruled = any(bat.certificate is not None for bat in bats)
    taken = assumed(answer, draws="`--uncertainty`")
    notes: list[Words] = [
        joined([taken, PLUS_MINUS] if _has_doubt(bats) else [taken]),
        *([BBCOR_OF_PLAY.format(where=WITH_RULES if ruled else WITHOUT)] if isinstance(reference.bat, Bat) else []),
    ]
    data = answer.to_dict() | {"verdict": [read(sentence, reading) for sentence in (*gains, *corked)]}
    return Document(
        name="compare", title=f"One {tool}" if number == 1 else f"{number} {tool}s, one player",
        subtitle=_effort(answer), kind="Comparison",
        blocks=[
            *map(Paragraph, (*corked[:1], *gains, *chances, *breaking_words(answer))), picture,
            _things(answer), *_paddles(answer), *_handling(answer), _in_play(answer),
            *([legality_table(bats)] if ruled else []),
            *(Paragraph(note, "note") for note in notes),
            *([] if uncertainty is None else [how_sure(uncertainty, main)]),
        ],
        data=data, rows=as_columns([_row(each) for each in data["bats"]]), reader=reading, drawing=picture,
        details=_by_place(answer), appendix=[*map(Paragraph, corked[1:])],
    )  # fmt: skip


def comparison_document(comparison: Comparison[Implement]) -> Document:
    """Return a comparison alone as a document: nothing is known of its implements but what they are."""
    every = (each.analysis for each in comparison.compared)
    return compare_document(compare_of(comparison, [sources_of(each.bat, each.conditions) for each in every]))


def _effort(answer: CompareAnswer) -> str:
    tool, law = sport(answer.comparison.reference.analysis.bat.sport).words.implement, answer.swing_law
    return f"all at the same {tool} speed" if law is None else f"same effort by the law of {law.name}"


def _has_doubt(bats: Sequence[ComparedBat]) -> bool:
    """Return whether a moment of inertia among them was not measured."""
    every = (bat.compared.analysis for bat in bats)
    return any(isinstance(each.bat, Bat) and moi_doubt(each.bat, each.body, STANDARD_AXIS) > 0 for each in every)


def _things(answer: CompareAnswer) -> Table:
    """Return the properties of the implements; round bats have a BBCOR, others their sport's swing weight."""
    bat = answer.comparison.reference.analysis.bat
    tool, convention = sport(bat.sport).words.implement, swing_weight(bat.sport)
    columns = [Column(tool), Column("mass", "mass"), Column("balance", "length")]
    weighed = Column("MOI" if isinstance(bat, Bat) else convention.name, right=True)
    columns += [weighed, Column("f1", "frequency"), Column("q max", "ratio")]
    columns += [Column("BBCOR in play", "ratio")] if isinstance(bat, Bat) else []
    rows: list[list[Cell]] = []
    for each in answer.bats:
        implement, body = each.compared.analysis.bat, each.compared.analysis.body
        turning: Cell = convention.text_of(body)
        if isinstance(implement, Bat):
            turning = moment(_of_draws(answer, each.bat.moi_6in), moi_doubt(implement, body, STANDARD_AXIS))
        row: list[Cell] = [
            each.label, Slot(_of_draws(answer, each.bat.mass), "mass", unit=False),
            Slot(_of_draws(answer, each.bat.balance_point), "length", unit=False),
            turning,
            Slot(_of_draws(answer, each.bending_1), "frequency", unit=False),
            Slot(_of_draws(answer, each.max_collision_efficiency), "ratio"),
        ]  # fmt: skip
        row += [Slot(_of_draws(answer, each.max_bbcor), "ratio")] if isinstance(bat, Bat) else []
        rows.append(row)
    return Table(f"The {tool}s", columns, rows, name="compared")


def _paddles(answer: CompareAnswer) -> list[Block]:
    """Return the numbers that players compare: swing and twist weight, sweet zone, tone, and whether they are legal."""
    rows: list[list[Cell]] = []
    for each in answer.bats:
        face, tool = each.paddle, each.compared.analysis.bat
        if face is None:
            return []
        zone: Cell = None
        if each.zone is not None:
            low, high = each.zone
            zone = say("{near:place, bare} to {far:place}", near=tool.length - high, far=tool.length - low)
        legal: Cell = None
        if face.pbcor is not None and face.pbcor_limit is not None:
            legal = say("{chance:share}", chance=1 - chance_above(float(face.pbcor_limit), interval_of(face.pbcor)))
        rows.append(
            [
                each.label,
                Slot(face.swing_weight, "twist_weight", unit=False),
                Slot(face.twist_weight, "twist_weight", unit=False),
                zone,
                Slot(face.face_tone, "frequency", 0, unit=False),
                None if face.pbcor is None else Slot(face.pbcor, "ratio", 3),
                legal,
            ]
        )
    heads = ("swing weight kg cm²", "twist weight kg cm²", "sweet zone from the tip", "face Hz", "PBCoR", "legal")
    return [Table("As players compare them", [Column("paddle"), *(Column(name, right=True) for name in heads)], rows)]


def _handling(answer: CompareAnswer) -> list[Block]:
    """Return how rackets handle, and what hits beside the middle line do; nothing for other implements."""
    if any(each.handling is None for each in answer.bats):
        return []
    words = sport(answer.comparison.reference.analysis.bat.sport).words
    columns = [Column(words.implement), *(Column(name, right=True) for name in HANDLING)]
    laterals = [hit.lateral for hit in answer.bats[0].off_center]
    for lateral in laterals:
        columns += [
            Column(say("{lateral:place, round} beside", lateral=lateral), "speed"),
            Column(say("{lateral:place, round} beside: aside", lateral=lateral), "angle"),
        ]
    rows: list[list[Cell]] = []
    for each in answer.bats:
        assert each.handling is not None  # all have been asked
        numbers = each.handling
        row: list[Cell] = [
            each.label,
            f"{1e4 * float(numbers.recoil_weight):.4g}",
            f"{1e4 * float(numbers.twist_weight):.4g}",
            f"{float(numbers.mgr_over_i):.2f}",
            f"{float(numbers.polarization):.2f}",
        ]
        for hit in each.off_center[: len(laterals)]:
            row += [Slot(hit.exit_speed, "speed", unit=False), Slot(hit.aside, "angle", 1, unit=False)]
        rows.append(row)
    return [Table("How they handle", columns, rows, name="handling")]


def _of_draws(answer: CompareAnswer, number: Number) -> Number:
    """Return a number with its interval where draws were made; straight lines have room for the speeds' alone."""
    return float(number) if answer.uncertainty is None else number


def _in_play(answer: CompareAnswer) -> Table:
    words = sport(answer.comparison.reference.analysis.bat.sport).words
    tool = words.implement
    columns = [
        Column(tool), Column(f"{tool} speed", "speed"), Column(words.exit_speed, "speed"),
        Column("change", "speed_change"), Column("break-even", "speed"),
    ]  # fmt: skip

    def speed(number: Number, scale: str = "speed", *, sign: bool = False) -> Cell:
        if answer.uncertainty is not None:
            return Slot(number, scale, sign=sign, unit=False)
        return within(interval_of(number), scale, sign=sign, unit=False)

    rows: list[list[Cell]] = [
        [
            each.label, speed(each.bat_speed), speed(each.exit_speed),
            speed(each.change, "speed_change", sign=True) if number else "reference",
            Slot(_of_draws(answer, each.break_even_bat_speed), "speed", unit=False),
        ]
        for number, each in enumerate(answer.bats)
    ]  # fmt: skip
    return Table("In play", columns, rows, name="compared")


def _by_place(answer: CompareAnswer) -> list[Block]:
    """Return the gain at each place on a round bat against the first, as in the picture; none for many bats."""
    first, *others = answer.comparison.compared
    if not isinstance(first.analysis.bat, Bat) or not 0 < len(others) <= MOST_BY_PLACE:
        return []
    reference = first.exit_speed_from_tip(PLACES)
    changes = [other.exit_speed_from_tip(PLACES) - reference for other in others]
    columns = [
        Column("hit from the tip", "place"), *(Column(f"{other.label},", "speed_change", sign=True) for other in others)
    ]  # fmt: skip
    rows: list[list[Cell]] = [list(map(float, row)) for row in zip(PLACES, *changes, strict=True)]
    return [Table(f"Change by place, against {first.label}", columns, rows)]


def _row(bat: Mapping[str, object]) -> dict[str, object]:
    """Return one bat of the data as a flat row."""
    row: dict[str, object] = {"label": bat["label"]}
    for key, value in bat.items():
        if key == "bat" and isinstance(value, dict):
            row |= {name: number for name, number in value.items() if name.startswith(OF_MASS)}
        elif isinstance(value, dict) and "value" in value:
            stem = key.removesuffix("_m_s")
            row |= {key: value["value"], f"{stem}_low_m_s": value["low"], f"{stem}_high_m_s": value["high"]}
        elif isinstance(value, float | None):
            row[key] = value
    return row


def legality_table(bats: Sequence[ComparedBat]) -> Table:
    """Return the verdict on every bat that was held against rules, and which rules make it or stay open."""
    columns = table_head("bat | rules of | verdict | why")
    rows: list[list[Cell]] = [
        [bat.label, _leagues(tested), _verdict(tested), _reason(tested)]
        for bat in bats
        if (tested := bat.certificate) is not None
    ]
    return Table("By the rules, as the model sees it; no certificate", columns, rows, name="compared")


def _verdict(tested: CertifyAnswer) -> Marked:
    """Return pass, fail or not decidable for all rules together, marked where it is sure."""
    word = tested.verdict
    if word is Verdict.NOT_DECIDABLE:
        return Marked(word.value, "")
    return Marked(word.value, MARKS[word]) if tested.sure else Marked(f"{word}{NOT_SURE}", "")


def _reason(tested: CertifyAnswer) -> Sentence:
    """Return the rules that are broken; of a bat that breaks none the limit on its liveliness, and what stays open."""
    if tested.failed:
        return broken_rules(tested.failed, not_sure=NOT_SURE)
    lively = [
        say("{rule} of the test {value}, allowed {limit}{doubt}", rule=check.title,
            value=value_shown(check.quantity, check.value), limit=limit_shown(check), doubt=_doubt(check))
        for check in tested.checks
        if check.outcome.verdict is Verdict.PASS and check.quantity in ("bbcor", "bpf", "besr")
    ]  # fmt: skip
    lively += [
        say("one piece of wood, which {check.league_name} do not hold to {check.title}", check=check)
        for check in tested.checks
        if check.outcome.verdict is Verdict.NOT_APPLICABLE and check.quantity == "bbcor"
    ]
    undecided = (check.title for check in tested.checks if check.outcome.verdict is Verdict.NOT_DECIDABLE)
    left = list(dict.fromkeys(undecided))  # two leagues may share a rule
    return joined([*lively, *([say("open: {rules}", rules=", ".join(left))] if left else [])], "; ")


def _doubt(check: RuleCheck) -> str:
    return "" if check.sure else NOT_SURE


def _leagues(tested: CertifyAnswer) -> str:
    names = {check.league: check.league_name for check in tested.checks}
    return "; ".join(names.values())


REASONS_SHOWN = 5
HEADINGS = {"exit_speed": "exit speed", "collision_efficiency": "q", "bbcor": "BBCOR in play", "bat_speed": "bat speed",
            "mass": "mass", "balance_point": "balance", "moi": "MOI", "frequency": "f1"}  # fmt: skip
"""Short names of answers, where each has a column."""
BBCOR_IS = "BBCOR in play is at this swing's closing speed; `sweetspot certify` computes that of the test."


def what_if_document(answer: WhatIfAnswer) -> Document:
    """Return one answer as a table, and below it the reasons of cells that have none; of rows alone every answer."""
    cell, down = answer.question.cell, answer.rows.varied
    across = None if answer.columns is None else answer.columns.varied
    assert down is not None
    data = answer.to_dict()
    reasons = np.full(answer.answers.mass.shape, "", dtype=object)
    for failure in answer.failures:
        reasons[failure.row, failure.column] = failure.reason
    document = grid_document(
        Grid(cell, down, across, getattr(answer.answers, cell)),
        name="compare",
        kind="What if",
        data=data,
        rows={**cells_as_columns(data), "reason": reasons.ravel().tolist()},
        notes=[Bullets(_reasons(answer, down, across))] if answer.failures else [],
        title=answer.question.bat.name,
    )
    if across:
        return document
    return replace(document, blocks=[_every_answer(answer, down), Paragraph(BBCOR_IS, "note"), *document.blocks[1:]])


def _every_answer(answer: WhatIfAnswer, down: Side) -> Table:
    """Return every answer of every row: variants of a bat side by side."""
    name, values = down
    names = [each for each in BAT_CELLS if each != name]
    columns = [Column(name.replace("_", " "), QUANTITIES[name].scale)]
    columns += [Column(HEADINGS[each], QUANTITIES[each].scale) for each in names]
    rows: list[list[Cell]] = [
        [varied(name, value), *(float(getattr(answer.answers, each)[row, 0]) for each in names)]
        for row, value in enumerate(values)
    ]
    return Table("", columns, rows)


def _reasons(answer: WhatIfAnswer, down: Side, across: Side | None) -> list[Sentence]:
    failed = answer.failures
    lines = [
        say("at {where}: {reason}", where=joined(_where(cell, down, across), ", "), reason=cell.reason)
        for cell in failed[:REASONS_SHOWN]
    ]
    more = len(failed) - len(lines)
    return [*lines, say("and {more} more cells; --format json has every reason", more=more)] if more else lines


def _where(cell: FailedCell, down: Side, across: Side | None) -> list[Slot]:
    where = [varied(down[0], float(down[1][cell.row]))]
    return where if across is None else [*where, varied(across[0], float(across[1][cell.column]))]

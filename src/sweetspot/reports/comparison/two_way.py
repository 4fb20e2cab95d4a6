"""A what-if table of one bat as a document."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sweetspot.answers.what_if import BAT_CELLS, FailedCell, WhatIfAnswer
from sweetspot.reports.document import Bullets, Cell, Column, Document, Paragraph, Table, cells_as_columns
from sweetspot.reports.grid.document import grid_document
from sweetspot.reports.grid.grid import Grid, Side, varied
from sweetspot.reports.quantities import QUANTITIES
from sweetspot.reports.sentences import Sentence, Slot, joined, say

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

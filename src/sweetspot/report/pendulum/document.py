"""A hanging bat as a document: period, moment of inertia and centre of percussion."""

from __future__ import annotations

from sweetspot.answers.pendulum import PendulumAnswer
from sweetspot.report.document import Cell, Column, Document, Table
from sweetspot.report.sentences import Slot, say
from sweetspot.report.uncertainty.uncertainty_section import how_sure


def pendulum_document(answer: PendulumAnswer) -> Document:
    """Return a hanging bat as a document."""
    about = say("moment of inertia about {pivot}", pivot=Slot(answer.pivot, "place", round=True))
    rows: list[tuple[Cell, Cell]] = [
        ("period", Slot(answer.period, "time", 4)),
        (about, Slot(answer.moi, "moi")),
        ("centre of percussion, from the knob end", Slot(answer.center_of_percussion, "length")),
    ]
    data, named = answer.to_dict(), "moment of inertia" if answer.question.timed else "period"
    return Document(
        name="pendulum",
        title="Pendulum",
        blocks=[
            Table("", [Column(""), Column("value", right=True)], rows),
            *([] if answer.uncertainty is None else [how_sure(answer.uncertainty, named)]),
        ],
        data=data,
        rows={name: [value] for name, value in data.items() if name != "uncertainty"},
    )

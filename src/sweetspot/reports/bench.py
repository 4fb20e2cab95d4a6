"""A drop test as a document: how high the ball comes back, and where its energy goes."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot import validation
from sweetspot.answers.drop import DropAnswer
from sweetspot.answers.paper import PaperAnswer
from sweetspot.answers.pendulum import PendulumAnswer
from sweetspot.answers.records import to_dict
from sweetspot.papers.formulas import PaperRow, Value
from sweetspot.reports.document import (
    Block,
    Cell,
    Column,
    Document,
    Marked,
    Paragraph,
    Table,
    as_columns,
    values_table,
)
from sweetspot.reports.paper.claims import claims_headline, claims_table
from sweetspot.reports.paper.statements import CHAIN, StatedRow, stated
from sweetspot.reports.quantities import SI, Reader
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.reports.uncertainty import how_sure
from sweetspot.units.text import GROUPED_FROM, grouped
from sweetspot.validation import Result

SUPPORTS = {"clamped": "clamped at its edges", "floor": "lying on a floor", "free": "free"}


def drop_document(answer: DropAnswer) -> Document:
    """Return a drop test as a document; in SI unless somebody says otherwise, as its laboratories have it."""
    blocks: list[Block] = [Paragraph(_rebound_words(answer)), values_table(_rows(answer))]
    if float(answer.deflection) > float(answer.thickness):
        bent = say(
            "Beware: the block deflects by {deflection:pressed}, more than its thickness: real plates are stiffer "
            "then.",
            deflection=answer.deflection,
        )
        blocks.append(Paragraph(bent, "warning"))
    if answer.uncertainty is not None:
        blocks.append(how_sure(answer.uncertainty, "restitution"))
    data = answer.to_dict()
    flat = {name: value for name, value in data.items() if not isinstance(value, dict) and name != "outcome"}
    energies = {f"energy_{name}_j": joules for name, joules in data["energy_j"].items()}
    return Document(
        name="drop",
        title="A ball on a block",
        kind="Drop test",
        blocks=blocks,
        data=data,
        rows={name: [value] for name, value in (flat | energies).items()},
        reader=SI,
    )


def _rebound_words(answer: DropAnswer) -> Sentence:
    """Return how the ball comes back: by heights where it was dropped, else by speeds."""
    dropped = answer.question.speed is None
    return say(
        "{how} {before}, the ball {back} {after}: restitution {answer.restitution:ratio, 3}, {kept:share} of the "
        "energy.",
        how="Dropped from" if dropped else "Met at",
        before=Slot(answer.fall_height, "place") if dropped else Slot(answer.fall_speed, "speed", 2),
        back="comes back to" if dropped else "leaves at",
        after=Slot(answer.rebound_height, "place") if dropped else Slot(answer.rebound_speed, "speed", 2),
        answer=answer,
        kept=answer.energy_kept,
    )


def _rows(answer: DropAnswer) -> list[tuple[Cell, Cell]]:
    made_of = say(
        "{answer.material}, {answer.thickness:pressed} thick, {answer.block_mass:mass}, {support}",
        answer=answer,
        support=SUPPORTS[answer.support],
    )
    rows: list[tuple[Cell, Cell]] = [
        ("block", made_of),
        ("the ball meets it at", Slot(answer.fall_speed, "speed", 2)),
        ("leaves it at", Slot(answer.rebound_speed, "speed", 2)),
    ]
    if answer.question.speed is None:
        terminal = answer.terminal_speed
        rows += [
            ("falls from", Slot(answer.fall_height, "place")),
            ("comes back to", Slot(answer.rebound_height, "place")),
            ("terminal speed in the air", "none, no air" if terminal is None else Slot(terminal, "speed")),
        ]
    rows += [
        ("restitution e", Slot(answer.restitution, "ratio", 4)),
        ("energy kept by the ball", Slot(answer.energy_kept, "share", 1)),
        ("energy the block would hold, pressed slowly", Slot(answer.block_share, "share", 2)),
        ("contact time", Slot(answer.contact_time, "contact", 2)),
        ("peak force", Slot(answer.peak_force, "weight")),
    ]
    incoming = float(answer.energy.incoming)
    for name, joules in vars(answer.energy).items():
        size = say("{joules:energy, 3}, {part:share, 1}", joules=joules, part=float(joules) / incoming)
        rows.append((f"energy: {name.replace('_', ' ')}", size))
    return rows


def pendulum_document(answer: PendulumAnswer) -> Document:
    """Return a hanging bat as a document."""
    about = say("moment of inertia about {pivot:place, round}", pivot=answer.pivot)
    rows: list[tuple[Cell, Cell]] = [
        ("period", Slot(answer.period, "time", 4)),
        (about, Slot(answer.moi, "moi")),
        ("centre of percussion, from the knob end", Slot(answer.center_of_percussion, "length")),
    ]
    data, named = answer.to_dict(), "moment of inertia" if answer.question.timed else "period"
    if answer.question.timed:
        lead = (say("The moment of inertia about {pivot:place, round} is", pivot=answer.pivot), Slot(answer.moi, "moi"))
    else:
        lead = (say("It swings to and fro in"), Slot(answer.period, "time", 4))
    return Document(
        name="pendulum",
        title="Pendulum",
        blocks=[
            Paragraph(say("{name} {value}.", name=lead[0], value=lead[1])),
            values_table(rows),
            *([] if answer.uncertainty is None else [how_sure(answer.uncertainty, named)]),
        ],
        data=data,
        rows={name: [value] for name, value in data.items() if name != "uncertainty"},
    )


def validation_document(results: Sequence[Result]) -> Document:
    """Return results as a document; it has not passed when a row misses without an explanation."""
    rows, headline = validation.rows(results), validation.headline(results)
    short, counts = validation.short_rows(results), [count._asdict() for count in validation.summary(results)]
    columns = [Column(name) for name in short[0]]
    cells: list[list[Cell]] = [
        [*[*row.values()][:-1], Marked(result.status, "hit" if result.ok else "missed")]
        for row, result in zip(short, results, strict=True)
    ]
    return Document(
        name="validate",
        title="Published cases",
        kind="Validation",
        blocks=[Paragraph(headline), Table("", columns, cells, name="published")],
        data={"headline": headline, "summary": counts, "rows": rows},
        rows=as_columns(rows),
        passed=validation.passed(results),
    )


def paper_document(answer: PaperAnswer) -> Document:
    """Return the paper's chain as a document."""
    data = answer.to_dict() | {"rows": [to_dict(stated(row)) for row in answer.rows]}
    return Document(
        name="paper",
        title="The paper",
        subtitle=answer.analysis.bat.name,
        kind="Paper",
        blocks=[Paragraph(claims_headline(answer.claims)), claims_table(answer.claims)],
        reader=CHAIN,
        appendix=[paper_table(answer.rows, "Every equation, in the paper's order")],
        data=data,
        rows=as_columns(data["rows"]),
    )


def paper_table(rows: Sequence[PaperRow], title: str = "", reading: Reader = CHAIN) -> Table:
    """Return the paper's chain, each statement with its comment below it; units are those of the paper."""
    columns = [Column(name) for name in ("eq.", "statement", "paper", "computed", "full model", "unit")]
    return Table(title, columns, [_cells(stated(row, reading)) for row in rows], name="paper")


def _cells(row: StatedRow) -> list[Cell]:
    numbers = [_shown(value) for value in (row.paper, row.computed, row.full_model)]
    return [row.equation, f"{row.quantity}\n{row.comment}\n", *numbers, row.unit]


def _shown(value: Value) -> Cell:
    if value is None or isinstance(value, str):
        return value
    text = f"{value:.5g}"
    return grouped(float(text)) if abs(float(text)) >= GROUPED_FROM else text

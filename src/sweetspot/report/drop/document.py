"""A drop test as a document: how high the ball comes back, and where its energy goes."""

from __future__ import annotations

from sweetspot.answers.drop import DropAnswer
from sweetspot.report.document import Block, Cell, Column, Document, Paragraph, Table
from sweetspot.report.quantities import SI
from sweetspot.report.sentences import Slot, say
from sweetspot.report.uncertainty.uncertainty_section import how_sure

SUPPORTS = {"clamped": "clamped at its edges", "floor": "lying on a floor", "free": "free"}


def drop_document(answer: DropAnswer) -> Document:
    """Return a drop test as a document; in SI unless somebody says otherwise, as its laboratories have it."""
    blocks: list[Block] = [Table("", [Column(""), Column("value", right=True)], _rows(answer))]
    if float(answer.deflection) > float(answer.thickness):
        bent = say(
            "Beware: the block gives way by {deflection}, more than its thickness: real plates are stiffer then.",
            deflection=Slot(answer.deflection, "pressed"),
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


def _rows(answer: DropAnswer) -> list[tuple[Cell, Cell]]:
    made_of = say(
        "{material}, {thickness} thick, {mass}, {support}",
        material=answer.material,
        support=SUPPORTS[answer.support],
        thickness=Slot(answer.thickness, "pressed"),
        mass=Slot(answer.block_mass, "mass"),
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
        size = say(
            "{joules}, {part}",
            joules=Slot(joules, "energy", 3),
            part=Slot(float(joules) / incoming, "share", 1),
        )
        rows.append((f"energy: {name.replace('_', ' ')}", size))
    return rows

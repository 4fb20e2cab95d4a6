"""A measured outline as a document."""

from __future__ import annotations

import numpy as np

from sweetspot.answers.outline import OutlineAnswer, PhotoOutlineAnswer
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.outline.photo.photo_outline import HOOKED
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.reports.document import Block, Column, Document, Paragraph, Table, table_head
from sweetspot.reports.sentences import Sentence, Slot, joined, measured_words, say
from sweetspot.units import INCH


def outline_document(answer: OutlineAnswer) -> Document:
    """Return an outline as a document: how thick the bat is, what it would weigh, what was not measured."""
    data = answer.to_dict()
    rows = {name: data["profile"][name] for name in ("position_m", "diameter_m")}
    notes: list[Block] = [Paragraph(words, "note") for words in answer.notes]
    if isinstance(answer, PhotoOutlineAnswer):
        rows["diameter_error_m"] = data["diameter_error_m"]
        notes = [Paragraph(photo_words(answer)), *notes, _inches(answer)]
    blocks = [Paragraph(outline_words(answer)), *notes]
    return Document(name="outline", title=answer.bat.name, blocks=blocks, data=data, rows=rows)


def _inches(answer: PhotoOutlineAnswer) -> Table:
    """Return the diameters at every inch from the tip, as a caliper would be held, with their intervals.

    Where a tape hooked over the tip would begin farther in, also those at every inch of such a tape.
    """
    length = float(answer.profile.position[-1])
    from_tip: Array = np.asarray(INCH * np.arange(1, int(length / INCH)), dtype=np.float64)

    def diameters(places: Array) -> list[Sentence]:
        values, errors = (
            np.interp(places, answer.profile.position, sizes)
            for sizes in (answer.profile.diameter, answer.diameter_error)
        )
        return [
            measured_words(Measured(value, error), "compression")
            for value, error in zip(values.tolist(), errors.tolist(), strict=True)
        ]

    columns = table_head("from the tip: length | diameter (90 %) >")
    cells = [diameters(length - from_tip)]
    if answer.tape_hooked_at > HOOKED:
        columns.append(Column("by a hooked tape", right=True))
        cells.append(diameters(length - answer.tape_hooked_at - from_tip))
    rows = [(float(place), *row) for place, *row in zip(from_tip, *cells, strict=True)]
    return Table("Every inch", columns, rows)


def photo_words(answer: PhotoOutlineAnswer) -> Sentence:
    """Return in words how sure the diameters of a photograph are, and what its edges look like."""
    errors = np.sort(answer.diameter_error)
    usual, most = (REACH * float(errors[int(part * (len(errors) - 1))]) for part in (0.5, 0.9))
    return say(
        "From the photograph: a pixel is {answer.pixel:compression, 2}; its edges scatter by "
        "{answer.edge_scatter:compression, 2} (rms) and the axis is straight to {answer.axis_bend:compression, 2}. "
        "Half of the diameters are sure to ± {usual:compression}, nine tenths to ± {most:compression}, places along "
        "the bat to ± {place:compression}: where it is steep, these decide (90 % intervals).",
        answer=answer,
        usual=usual,
        most=most,
        place=REACH * answer.place_error,
    )


def outline_words(answer: OutlineAnswer) -> Sentence:
    """Return in words how thick the bat is and what it weighs, or would."""
    bat, sizes = answer.bat, answer.profile.diameter
    beyond_knob = sizes[answer.profile.position > 0.15 * bat.length]
    hollow = bat.shell is not None or bat.cup is not None or bool(bat.bores)
    weighs = (
        "Of {wood}, it weighs {mass} and balances {balance} from the knob."
        if bat.mass is not None
        else "{made} {wood} of {density} it would weigh {mass} and balance {balance} from the knob."
    )
    words = [
        say(
            "{count} stations: handle {thin:length}, barrel {thick:length}, length {length:length}.",
            count=len(sizes),
            thin=float(beyond_knob.min()),
            thick=float(beyond_knob.max()),
            length=bat.length,
        ),
        say(
            weighs,
            made="In" if hollow else "Solid, without cup or holes, in",
            wood=bat.material.name,
            density=Slot(bat.material.density, "density"),
            mass=Slot(answer.mass, "mass"),
            balance=Slot(answer.balance_point, "length"),
        ),
    ]
    if count := len(answer.assumed_position):
        words.append(say("{count} stations at the ends were not measured but assumed.", count=count))
    return joined(words)

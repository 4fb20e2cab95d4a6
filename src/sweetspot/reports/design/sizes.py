"""Sizes for the maker: diameters along the bat, and the effect of their tolerance."""

from __future__ import annotations

import numpy as np

from sweetspot.answers.design_question import Designed
from sweetspot.designs.turned import HANDLES, TurnedSpace
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.reports.document import Cell, Paragraph, Table, table_head
from sweetspot.reports.quantities import Reader
from sweetspot.reports.sentences import Sentence, Slot, say
from sweetspot.units import INCH

TOLERANCE = 0.01 * INCH
"""m by which a diameter may be off: what a lathe with a copying rest holds (assumed)."""


def inch_places(bat: Bat) -> Array:
    """Return places at every inch from the tip, and the knob end, m from the knob end."""
    count = int(bat.length / INCH + 1e-9)
    return np.unique(np.concatenate([[0.0], bat.length - np.arange(count, -1, -1) * INCH]).clip(0.0))


def sizes_table(bat: Bat) -> Table:
    """Return the diameter at every inch, in the reader's unit and in mm."""
    rows: list[list[Cell]] = [
        [
            bat.length - place,
            place,
            float(bat.diameter_at(place)),
            Slot(float(bat.diameter_at(place)), "compression", 2),
        ]
        for place in inch_places(bat)[::-1]
    ]
    columns = table_head("from the tip: place | from the knob end: length | diameter: length, 3 | diameter >")
    return Table("Diameters to turn", columns, rows)


def tolerance_words(design: Designed) -> Sentence | None:
    """Return the effect of a diameter off by the tolerance all along; None for an implement that is not turned."""
    space = design.bench.space
    if not isinstance(space, TurnedSpace):
        return None
    thicker = design.numbers.copy()
    thicker[: len(HANDLES)] += TOLERANCE
    measures = design.bench.measured(thicker)
    return say(
        "Tolerance: ± {tolerance:length, 3} of diameter. Thicker by that all along, the bat weighs {mass:mass} more, "
        "its moment of inertia grows by {moi:moi} and the exit speed over these contacts changes by "
        "{speed:speed_change, 2, sign}.",
        tolerance=TOLERANCE,
        mass=float(measures.values["mass"][0]) - design.value("mass"),
        moi=float(measures.values["moi"][0]) - design.value("moi"),
        speed=float(measures.values["exit_speed"][0]) - design.value("exit_speed"),
    )


def drawing(bat: Bat, ending: str, reading: Reader) -> bytes:
    """Return the drawing of a bat as a file with this ending: csv, svg or dxf."""
    from pathlib import Path

    from sweetspot.reports.drawing.drawing_files import drawing_bytes

    return drawing_bytes(bat, Path(f"bat.{ending}"), reading=reading)


def tolerance_paragraph(design: Designed) -> list[Paragraph]:
    """Return the tolerance as a note, or nothing."""
    words = tolerance_words(design)
    return [] if words is None else [Paragraph(words, "note")]

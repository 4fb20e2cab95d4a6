"""A measured outline as a document."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sweetspot.answers.certify import RuleCheck
from sweetspot.answers.outline import TOLERANCE, OutlineAnswer, PhotoOutlineAnswer
from sweetspot.calibration.measured import Measured
from sweetspot.calibration.outline.photo.photo_outline import HOOKED
from sweetspot.catalog.sports import sport
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import REACH
from sweetspot.reports.certification.limits_shown import broken_rules
from sweetspot.reports.document import Block, Cell, Column, Document, Paragraph, Table, table_head
from sweetspot.reports.drawings.solids import bat_parts
from sweetspot.reports.quantities import Reader, reader
from sweetspot.reports.sentences import Sentence, Slot, joined, measured_words, read, say
from sweetspot.units import INCH


def outline_document(answer: OutlineAnswer) -> Document:
    """Return an outline as a document: how thick the bat is, what it would weigh, what was not measured."""
    data = answer.to_dict()
    rows = {name: data["profile"][name] for name in ("position_m", "diameter_m")}
    notes: list[Block] = [Paragraph(words, "note") for words in answer.notes]
    if isinstance(answer, PhotoOutlineAnswer):
        rows["diameter_error_m"] = data["diameter_error_m"]
        notes = [Paragraph(photo_words(answer)), *notes, _inches(answer)]
    if isinstance(answer.bat, Bat) and answer.mass_by_tolerance is not None:
        notes.append(Paragraph(tolerance_words(answer), "note"))
    blocks = [*(Paragraph(words) for words in illegal_words(answer.broken)), Paragraph(outline_words(answer)), *notes]
    if isinstance(answer.bat, Bat) and (answer.bat.shell is not None or answer.bat.bores):
        blocks.append(_parts(answer.bat))
    return Document(
        name="outline",
        title=answer.bat.name,
        blocks=blocks,
        data=data,
        rows=rows,
        reader=reader(None, sport(answer.bat.sport).words),
    )


def illegal_words(broken: Sequence[RuleCheck]) -> list[Sentence]:
    """Return that a drawing breaks rules, and which; nothing where it breaks none."""
    return [say("NOT LEGAL: {rules}.", rules=broken_rules(broken))] if broken else []


def tolerance_words(answer: OutlineAnswer) -> Sentence:
    """Return the effect of diameters off by the tolerance all along."""
    return say(
        "Tolerance: ± {answer.tolerance:length, 3} of diameter. Thicker by that all along, it weighs "
        "{more:mass, 2} more.",
        answer=answer,
        more=answer.mass_by_tolerance or 0.0,
    )


def drawing_remarks(broken: Sequence[RuleCheck], reading: Reader) -> list[str]:
    """Return the remarks on a drawing: the rules that it breaks, and its tolerance."""
    tolerance = say("Tolerance ± {tolerance:length, 3} of diameter unless agreed.", tolerance=TOLERANCE)
    return [read(words, reading) for words in (*illegal_words(broken), tolerance)]


def _parts(bat: Bat) -> Table:
    """Return the solids that files hold, and what they leave out."""
    parts = bat_parts(bat)
    rows: list[list[Cell]] = [
        [part.name, part.material, Slot(part.volume * 1e6, "ratio", 1), Slot(part.mass, "mass")] for part in parts
    ]
    added = sum(weight.mass for weight in bat.point_masses) + (0.0 if bat.shell is None else bat.shell.joint_mass)
    rows += [["not drawn", "tape, joint, added weights", None, Slot(added, "mass")]] if added else []
    return Table("Solids that files hold", table_head("solid | material | cm³ > | weight >"), rows)


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
    if not isinstance(bat, Bat):
        return say(
            "{bat.made_of}: widest {wide:length}, length {length:length}. It weighs {mass:mass} and balances "
            "{balance:length} from the end in the hand.",
            bat=bat,
            wide=float(sizes.max()),
            length=bat.length,
            mass=answer.mass,
            balance=answer.balance_point,
        )
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

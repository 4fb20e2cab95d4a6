"""A measured outline in words and as JSON."""

from __future__ import annotations

from typing import Any

import numpy as np

from sweetspot.calibration.measured import Measured
from sweetspot.calibration.outline.measured_outline import Outline
from sweetspot.calibration.outline.photo.photo_outline import HOOKED, PhotoOutline
from sweetspot.dynamics.rigid import RigidBody
from sweetspot.equipment.bat import Bat
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.confidence import REACH
from sweetspot.report.calibration.intervals import measured_words
from sweetspot.report.document import Block, Column, Document, Paragraph, Table
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.sentences import Sentence, Slot, joined, say
from sweetspot.units import INCH


def outline_document(outline: Outline, bat: Bat, body: RigidBody) -> Document:
    """Return an outline as an answer: how thick the bat is, what it would weigh, what was not measured."""
    data = outline_json(outline, bat, body)
    rows = {name: data["profile"][name] for name in ("position_m", "diameter_m")}
    notes: list[Block] = [Paragraph(words, "note") for words in outline.notes]
    if isinstance(outline, PhotoOutline):
        data |= photo_json(outline)
        rows["diameter_error_m"] = data["diameter_error_m"]
        notes = [Paragraph(photo_words(outline)), *notes, _inches(outline)]
    blocks = [Paragraph(outline_words(outline, bat, body)), *notes]
    return Document(name="outline", title=bat.name, blocks=blocks, data=data, rows=rows)


def photo_json(outline: PhotoOutline) -> dict[str, Any]:
    """Return how sure an outline from a photograph is, SI."""
    return cleaned(
        {
            "pixel_m": outline.pixel,
            "edge_scatter_m": outline.edge_scatter,
            "axis_bend_m": outline.axis_bend,
            "diameter_error_m": outline.diameter_error,
            "place_error_m": outline.place_error,
            "camera_distance_m": outline.camera_distance,
            "tape_hooked_at_m": outline.hooked,
        }
    )


def _inches(outline: PhotoOutline) -> Table:
    """Return the diameters at every inch from the tip, as a caliper would be held, with their intervals.

    Where a tape hooked over the tip would begin farther in, also those at every inch of such a tape.
    """
    length = outline.profile[-1][0]
    from_tip: Array = np.asarray(INCH * np.arange(1, int(length / INCH)), dtype=np.float64)
    places, diameters = np.array(outline.profile).T

    def told(where: Array) -> list[Sentence]:
        values, errors = (np.interp(where, places, of) for of in (diameters, np.array(outline.diameter_error)))
        return [
            measured_words(Measured(float(value), float(error)), "compression")
            for value, error in zip(values, errors, strict=True)
        ]

    columns = [Column("from the tip", "length"), Column("diameter (90 %)", right=True)]
    cells = [told(length - from_tip)]
    if outline.hooked > HOOKED:
        columns.append(Column("by a hooked tape", right=True))
        cells.append(told(length - outline.hooked - from_tip))
    rows = [(float(place), *row) for place, *row in zip(from_tip, *cells, strict=True)]
    return Table("Every inch", columns, rows)


def photo_words(outline: PhotoOutline) -> Sentence:
    """Return in words how sure the diameters of a photograph are, and what its edges look like."""
    errors = sorted(outline.diameter_error)
    usual, most = (REACH * errors[int(part * (len(errors) - 1))] for part in (0.5, 0.9))
    return say(
        "From the photograph: a pixel is {pixel}; its edges scatter by {scatter} (rms) and the axis is straight to "
        "{bend}. Half of the diameters are sure to ± {usual}, nine tenths to ± {most}, places along the bat to ± "
        "{place}: where it is steep, these decide (90 % intervals).",
        pixel=Slot(outline.pixel, "compression", 2), scatter=Slot(outline.edge_scatter, "compression", 2),
        bend=Slot(outline.axis_bend, "compression", 2), usual=Slot(usual, "compression"),
        most=Slot(most, "compression"), place=Slot(REACH * outline.place_error, "compression"),
    )  # fmt: skip


def outline_json(outline: Outline, bat: Bat, body: RigidBody) -> dict[str, Any]:
    """Return stations, those that were assumed, and what the bat weighs, or would at the catalogue's density; SI."""
    positions, diameters = zip(*outline.profile, strict=True)
    return cleaned(
        {
            "profile": {"position_m": positions, "diameter_m": diameters},
            "assumed_position_m": outline.assumed,
            "length_m": bat.length,
            "mass_kg": body.mass,
            "balance_point_m": body.balance_point,
            "notes": outline.notes,
        }
    )


def outline_words(outline: Outline, bat: Bat, body: RigidBody) -> Sentence:
    """Return in words how thick the bat is and what it weighs, or would."""
    beyond_knob = [size for place, size in outline.profile if place > 0.15 * bat.length]
    hollow = bat.shell is not None or bat.cup is not None or bool(bat.bores)
    weighs = (
        "Of {wood}, it weighs {mass} and balances {balance} from the knob."
        if bat.mass is not None
        else "{made} {wood} of {density} it would weigh {mass} and balance {balance} from the knob."
    )
    made = "In" if hollow else "Solid, without cup or holes, in"
    words = [
        say(
            "{count} stations: handle {thin}, barrel {thick}, length {length}.", count=len(outline.profile),
            thin=Slot(min(beyond_knob), "length"), thick=Slot(max(beyond_knob), "length"),
            length=Slot(bat.length, "length"),
        ),
        say(
            weighs, made=made, wood=bat.material.name, density=Slot(bat.material.density, "density"),
            mass=Slot(body.mass, "mass"), balance=Slot(body.balance_point, "length"),
        ),
    ]  # fmt: skip
    if outline.assumed:
        words.append(say("{count} stations at the ends were not measured but assumed.", count=len(outline.assumed)))
    return joined(words)

"""What a report takes for granted, and where its constants come from."""

from __future__ import annotations

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.catalog.sports import sport
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import ASSUMED_MARK
from sweetspot.report.bat.provenance import own_values, shown, used_records
from sweetspot.report.document import Block, Bullets, Cell, Column, Linked, Paragraph, Section, Table
from sweetspot.report.sentences import Sentence, Slot, Words, say
from sweetspot.report.sport_words import in_words, words_of
from sweetspot.units import MPH

PATCH = 2 * MPH
"""m/s of exit speed that the size of the patch under the ball is worth on a hollow bat."""


def assumptions_section(analysis: Analysis[Implement]) -> Section:
    """Return what the model takes for granted, what the sport's description leaves out, and what was assumed."""
    words, records = words_of(analysis.bat), used_records(analysis)
    assumed = [
        f"{heading.partition(': ')[2]} {record.name.rpartition('.')[2].replace('_', ' ')}"
        for heading, entries in records.items()
        for record in entries
        if record.kind == "assumed"
    ]
    points: list[Words] = [
        _face(analysis),
        in_words(
            "The {implement} bends as a beam of varying section (bending, shear and rotary inertia). That holds for "
            "waves longer than it is thick, up to about 10 kHz.", words,
        ),
        _grip(analysis),
        in_words("The {ball} comes straight at the middle line, without spin, and the {implement} turns in one plane.",
                 words),
        in_words("Every place is hit with the same turning speed, whatever the {implement} weighs.", words),
        in_words(
            "Sting is the speed of the handle's vibration at both hands right after the hit, weighted by frequency as "
            "hands feel it (ISO 5349, flat to about 600 Hz). The limits of the {zone} are our choice.", words,
        ),
        *(f"Not covered: {text}." for text in sport(analysis.bat.sport).not_covered),
        f"Constants that are assumed, because no source was read: {', '.join(assumed)}; where a stroke's number is, "
        f"{ASSUMED_MARK} stands behind it." if assumed else "",
    ]  # fmt: skip
    return Section("assumptions", "Assumptions and limits", [Bullets([point for point in points if point])])


def _face(analysis: Analysis[Implement]) -> Sentence:
    """Say what gives way under the ball."""
    if "hoop" in analysis.modes.families:
        return say(
            "The wall of this hollow bat gives way in hoop modes, felt through a round patch under the ball; the size "
            "of that patch is uncertain and is worth about {change} either way.", change=Slot(PATCH, "speed", 0),
        )  # fmt: skip
    if analysis.bat.face is not None and analysis.bat.face.stiffness is not None:
        return say("The face is one spring and damper under the ball, softer or stiffer by its place.")
    return say("The face is rigid. What it gives and returns itself is contained in the ball's restitution.")


def _grip(analysis: Analysis[Implement]) -> Sentence:
    """Say how it is held, and how little that matters to the ball."""
    hands, words = analysis.conditions.hands, words_of(analysis.bat)
    change = Slot(abs(analysis.grip_effect), "share", 1)
    if any((hands.mass, hands.stiffness, hands.damping)):
        return say("Each hand is a mass on a spring and a damper; typical ones change the exit speed by {change}.",
                   change=change)  # fmt: skip
    return in_words(
        "The {implement} is free while {ball} and {implement} touch. Typical hands would change the {exit_speed} by "
        "{change}; they damp the vibration, so the sting is an upper bound.", words, change=change,
    )  # fmt: skip


def constants_section(analysis: Analysis[Implement]) -> Section:
    """Return value, spread, kind and source of every catalogue number used."""
    columns = [Column(name) for name in ("constant", "value and spread", "kind", "source and place in it")]
    blocks: list[Block] = [Paragraph(words) for words in own_values(analysis)]
    for heading, entries in used_records(analysis).items():
        rows: list[list[Cell]] = []
        for record in entries:
            name = record.name.rpartition(".")[2].replace("_", " ")
            spread = "" if record.spread is None else f", spread {shown(record.spread)}"
            source = Linked(record.source, f"#source-{record.source}", record.where)
            rows.append([name, shown(record.value) + spread, record.kind, source])
        title = heading[0].upper() + heading[1:]
        blocks.append(
            Section(f"constants-{len(blocks)}", title, [Table("", columns, rows, name="provenance")], level=3)
        )
    return Section("constants", "Where the constants come from", blocks)

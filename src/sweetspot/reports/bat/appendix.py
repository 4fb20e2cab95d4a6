"""Assumptions of a report and the sources of its constants."""

from __future__ import annotations

from collections.abc import Sequence

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import canonical
from sweetspot.catalog.sports import DEFAULT_SPORT, sport
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import ASSUMED_MARK
from sweetspot.reports.bat.provenance import own_values, shown, used_records
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Linked,
    Marked,
    Paragraph,
    Section,
    Table,
    table_head,
)
from sweetspot.reports.sentences import Sentence, Slot, Words, say
from sweetspot.reports.sport_words import in_words, words_of
from sweetspot.units import MPH
from sweetspot.validation import Result, Row, sources
from sweetspot.validation.computations import space
from sweetspot.validation.computations.registry import COMPUTATIONS
from sweetspot.validation.verdicts import judged, number_words

PATCH = 2 * MPH
"""m/s of exit speed that the size of the patch under the ball is worth on a hollow bat."""


BEAM = (
    "The {implement} bends as a beam of varying section (bending, shear and rotary inertia). That holds for waves "
    "longer than it is thick, up to about 10 kHz."
)
ASSUMPTIONS = (
    "The {ball} comes straight at the middle line, without spin, and the {implement} turns in one plane.",
    "Every place is hit with the same turning speed, whatever the {implement} weighs.",
    "Sting is the speed of the handle's vibration at both hands right after the hit, weighted by frequency as hands "
    "feel it (ISO 5349, flat to about 600 Hz). The limits of the {zone} are our choice.",
)


def assumptions_section(analysis: Analysis[Implement]) -> Section:
    """Return the assumptions of the model, the gaps of the sport's description, and the assumed values."""
    words, records = words_of(analysis.bat.sport), used_records(analysis)
    assumed = [
        f"{heading.partition(': ')[2]} {record.name.rpartition('.')[2].replace('_', ' ')}"
        for heading, entries in records.items()
        for record in entries
        if record.kind == "assumed"
    ]
    points: list[Words] = [_face(analysis), in_words(BEAM, words), _grip(analysis)]
    points += [in_words(assumption, words) for assumption in ASSUMPTIONS]
    points += [f"Not covered: {text}." for text in sport(analysis.bat.sport).not_covered]
    if assumed:
        points.append(
            f"Constants that are assumed, because no source was read: {', '.join(assumed)}; where a stroke's number "
            f"is, {ASSUMED_MARK} stands behind it."
        )
    return Section("assumptions", "Assumptions and limits", [Bullets(points)])


def _face(analysis: Analysis[Implement]) -> Sentence:
    """Return a sentence on what deforms under the ball."""
    if "hoop" in analysis.modes.families:
        return say(
            "The wall of this hollow bat deflects in hoop modes, felt through a round patch under the ball; the size "
            "of that patch is uncertain and is worth about {change:speed, 0} either way.",
            change=PATCH,
        )
    if analysis.bat.face is not None and analysis.bat.face.stiffness is not None:
        return say("The face is one spring and damper under the ball, softer or stiffer by its place.")
    return say("The face is rigid. What it gives and returns itself is contained in the ball's restitution.")


def _grip(analysis: Analysis[Implement]) -> Sentence:
    """Return a sentence on the grip and its small effect on the ball."""
    hands, words = analysis.conditions.hands, words_of(analysis.bat.sport)
    change = Slot(abs(analysis.grip_effect), "share", 1)
    if any((hands.mass, hands.stiffness, hands.damping)):
        held = "Each hand is a mass on a spring and a damper; typical ones change the exit speed by {change}."
        return say(held, change=change)
    return in_words(
        "The {implement} is free while {ball} and {implement} touch. Typical hands would change the {exit_speed} by "
        "{change}; they damp the vibration, so the sting is an upper bound.",
        words,
        change=change,
    )


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


ROWS = 14
SLOW = {name for name, function in COMPUTATIONS.items() if function.__module__ == space.__name__}
SLOW |= {"turned", "restitution_of_share"}
"""Computations that are too slow for a report: the speed of a given hit is searched, a league's hits are drawn, many
walls are tried."""


def published_section(results: Sequence[Result]) -> list[Block]:
    """Return a section of published values beside ours; none when there is nothing to compare."""
    if not results:
        return []
    words = (
        "The same model for implements of this sport in the catalogue, beside published numbers that did not go into "
        "it, known and explained misses among them; `sweetspot validate` lists all cases."
    )
    columns = table_head("quantity | source | published > | computed > | allowed | verdict")
    why = [
        f"{result.quantity[0].upper() + result.quantity[1:]}: {result.expected_miss}"
        for result in results
        if not result.ok and result.expected_miss
    ]
    reasons: list[Block] = [Section("why-miss", "Why these miss", [Bullets(why)], level=3)] if why else []
    table = Table("", columns, [_cells(result) for result in results], name="published")
    return [Section("published", "Beside published values", [Paragraph(words), table, *reasons])]


def _cells(result: Result) -> list[Cell]:
    unit = f" {result.unit}" if result.unit else ""
    worded = not any(letter.isdigit() for letter in result.printed)
    printed = result.printed if worded or result.unit in result.printed else result.printed + unit
    return [
        result.quantity,
        Linked(result.source, f"#source-{result.source}", result.name),
        printed,
        number_words(result) + unit,
        result.allowed_text,
        Marked(result.status, "hit" if result.ok else "missed"),
    ]


def chosen(sport: str) -> list[Result]:
    """Return in turn one row from every source about a sport's implements, and known misses for at most half of it."""
    by_source = [[(row, case) for row in case.rows if _predicts(row) and sport in _sports(row)] for case in sources()]
    missed = [pair for queue in by_source for pair in queue if pair[0].expected_miss][: ROWS // 2]
    queues = [[pair for pair in queue if _tells(pair[0])] for queue in by_source]
    turns = max(map(len, queues), default=0)
    others = [queue[turn] for turn in range(turns) for queue in queues if turn < len(queue)]
    return [judged(row, case) for row, case in [*others[: ROWS - len(missed)], *missed]]


def _sports(row: Row) -> set[str]:
    """Return the sports of the catalogue's implements that a row names."""
    tables = {canonical(key): table for key, table in implement_tables().items()}
    named = [canonical(text) for text in row.inputs.values() if isinstance(text, str)]
    return {canonical(tables[name].text("sport", DEFAULT_SPORT)) for name in named if name in tables}


def _predicts(row: Row) -> bool:
    """Return whether a row predicts something about bats and is computed fast enough for a report."""
    return "prediction" in row.evidence and row.computation not in SLOW


def _tells(row: Row) -> bool:
    """Return whether a row is a measured number and not a known miss."""
    number = row.kind in ("quantitative", "band") and any(letter.isdigit() for letter in row.printed)
    return number and not row.expected_miss

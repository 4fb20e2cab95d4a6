"""Where the numbers behind a report come from: catalogue records of the bat, its materials and the ball."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.catalog.balls import ball
from sweetspot.catalog.bats import wall_pattern
from sweetspot.catalog.files.ball import BALLS
from sweetspot.catalog.implements import implement, implement_tables
from sweetspot.catalog.materials import FILE as MATERIAL_FILE
from sweetspot.catalog.materials import RUBBERS, material
from sweetspot.catalog.records import Record, all_records, read_table
from sweetspot.catalog.rules import league
from sweetspot.catalog.sports import sport
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.material import Material
from sweetspot.equipment.table_tennis_racket import Rubber, TableTennisRacket
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.interval import Number
from sweetspot.reports.document import Block, Paragraph
from sweetspot.reports.sentences import Sentence, Slot, joined, listed, say
from sweetspot.reports.sport_words import in_words, words_of

MECHANICS = ("nathan2000", "nathan2003", "cross1998", "cowper1966", "astm_f2398", "astm_f2219", "griffin2012")
METHOD_SOURCES = (*MECHANICS, "russell2017acoustics", "paper2014")
"""Sources of the formulas and definitions in every report."""
STATIONS_SHOWN = 3
OF_THE_BALL = {
    **{"mass": "weight", "cor_reference": "restitution", "cor_slope": "loss of restitution with speed"},
    **dict.fromkeys(("peak_force", "load", "contact_time"), "stiffness"),
}
"""What people call the values of a ball's file that decide how fast it leaves."""


def used_records(analysis: Analysis[Implement]) -> dict[str, list[Record]]:
    """Return the records of everything that went into an analysis, under a heading for each thing."""
    described = analysis.bat
    records = {f"{sport(described.sport).words.implement}: {described.name}": bat_records(described)}
    for made_of in {used.name: used for used in described.materials}.values():
        records[f"material: {made_of.name}"] = material_records(made_of)
    for rubber in described.rubbers if isinstance(described, TableTennisRacket) else ():
        records[f"rubber: {rubber.name}"] = rubber_records(rubber)
    used = analysis.conditions.ball
    records[f"ball: {used.name}"] = ball_records(used)
    return {heading: entries for heading, entries in records.items() if entries}


def own_values(analysis: Analysis[Implement]) -> list[str]:
    """Return in words what was used but is not the catalogue's: a bat from a file, changed materials or balls."""
    words = []
    described, used = analysis.bat, analysis.conditions.ball
    originals = [each for each in described.lineage() if _key_of(each) is not None]
    if not originals:
        words.append(f"Sizes and weight of {described.name}: as given by whoever described it.")
    elif originals[0] is not described:
        words.append(f"The records of the bat are those of {originals[0].name}, before it was changed.")
    for made_of in described.materials:
        words += (
            _changes("material", made_of, material(key))
            if (key := _material_key(made_of))
            else [f"The material {made_of.name} is not in the catalogue."]
        )
    words += (
        _changes("ball", used, ball(key))
        if (key := _ball_key(used))
        else [f"The ball {used.name} is not in the catalogue."]
    )
    return list(dict.fromkeys(words))


def bat_records(described: Implement) -> list[Record]:
    """Return the records of a catalogue bat and of what it was changed from; none for a bat that has nothing of it."""
    records = []
    for key in filter(None, map(_key_of, described.lineage())):
        entry = implement_tables()[key]
        tables = {f"{key}.{name}": table for name, table in entry.items() if isinstance(table, Mapping)}
        records += all_records(entry, key)
        records += [record for name, table in tables.items() for record in all_records(table, name)]
    return records


def _key_of(described: Implement) -> str | None:
    """Return the key of a catalogue bat; None for any other."""
    named = (key for key, entry in implement_tables().items() if entry.name == described.name)
    return next((key for key in named if implement(key) == described), None)


def material_records(made_of: Material) -> list[Record]:
    """Return the records of a material; none when its name is not in the catalogue."""
    key = _material_key(made_of)
    return all_records(read_table(MATERIAL_FILE)[key], key) if key else []


def ball_records(used: Ball) -> list[Record]:
    """Return the records of a ball; none when its name is not in the catalogue."""
    key = _ball_key(used)
    return all_records(read_table(BALLS)[key], key) if key else []


def assumed_of_ball(used: Ball) -> list[str]:
    """Return in words what of a ball the catalogue assumes and was not given otherwise.

    >>> assumed_of_ball(ball("youth-soft")), assumed_of_ball(ball("baseball"))
    (['weight', 'restitution', 'stiffness'], [])
    """
    if not (key := _ball_key(used)):
        return []
    original = ball(key)
    same = {
        "weight": used.mass == original.mass,
        "restitution": used.restitution.reference == original.restitution.reference,
        "loss of restitution with speed": used.restitution.slope == original.restitution.slope,
        "stiffness": used.stiffness == original.stiffness,
    }
    names = [record.name.rpartition(".")[2] for record in ball_records(used) if record.kind == "assumed"]
    called = dict.fromkeys(OF_THE_BALL[name] for name in names if name in OF_THE_BALL)
    return [name for name in called if same[name]]


def rubber_records(used: Rubber) -> list[Record]:
    """Return the records of a table-tennis rubber; none when its name is not in the catalogue."""
    table = read_table(RUBBERS)
    return next((all_records(entry, key) for key, entry in table.items() if entry.name == used.name), [])


def sources_of(records: dict[str, list[Record]]) -> list[str]:
    """Return the keys of all sources behind records and methods, each once, in alphabetical order."""
    return sorted({*METHOD_SOURCES, *(record.source for entries in records.values() for record in entries)})


def shown(value: Any) -> str:
    """Return a record's value in a few words.

    >>> shown({"barrel": "2.5 in", "knob": "2 in"}), shown([["0 in", "1 in"], ["33 in", "2 in"]])
    ('barrel 2.5 in, knob 2 in', '0 in: 1 in; 33 in: 2 in')
    """
    if isinstance(value, dict):
        return ", ".join(f"{name.replace('_', ' ')} {shown(item)}" for name, item in value.items())
    if isinstance(value, list):
        if value and isinstance(value[0], dict):
            return "; ".join(shown(item) for item in value)
        pairs = [": ".join(map(str, pair)) if isinstance(pair, list) else str(pair) for pair in value]
        if len(pairs) > 2 * STATIONS_SHOWN:
            left_out = len(pairs) - 2 * STATIONS_SHOWN
            pairs = [*pairs[:STATIONS_SHOWN], f"{left_out} more", *pairs[-STATIONS_SHOWN:]]
        return "; ".join(pairs)
    return str(value)


def _material_key(made_of: Material) -> str | None:
    return next((key for key, entry in read_table(MATERIAL_FILE).items() if entry.name == made_of.name), None)


def _ball_key(used: Ball) -> str | None:
    return next((key for key, entry in read_table(BALLS).items() if entry.name == used.name), None)


def _changes(what: str, used: Material | Ball, original: Material | Ball) -> list[str]:
    """Say which fields of a thing differ from the catalogue's."""
    names = [name for name in type(used).model_fields if getattr(used, name) != getattr(original, name)]
    if not names:
        return []
    fields = ", ".join(names).replace("_", " ")
    return [f"Not the catalogue's values, but given for this report: {fields} of the {what} {used.name}."]


def soft_defaults(sport_name: str, ball: Ball, conditions: Conditions | None = None) -> Sentence:
    """Return a sentence on the assumed values of a ball and, with conditions, of the speeds; empty if there are none.

    >>> from sweetspot.catalog.balls import ball
    >>> from sweetspot.catalog.bats import bat
    >>> from sweetspot.reports.sport_words import reader_of
    >>> slow = bat("slow-pitch")
    >>> soft_defaults(slow.sport, ball("softball-12in")).read(reader_of(slow.sport))
    'Assumed, not measured: of the ball, loss of restitution with speed and stiffness.'
    >>> soft_defaults("baseball", ball("baseball")).parts
    ()
    """
    stroke = sport(sport_name).stroke
    used = (
        ((stroke.swing_speed, conditions.swing.bat_speed), (stroke.ball_speed, conditions.pitch.speed))
        if conditions
        else ()
    )
    soft = [
        say("{name} {speed:speed, round}", name=each.name, speed=value)
        for each, value in used
        if each.kind == "assumed" and each.value == value
    ]
    if values := assumed_of_ball(ball):
        soft.append(in_words("of the {ball}, {listed}", words_of(sport_name), listed=listed(values)))
    return say("Assumed, not measured: {soft}.", soft=joined(soft, "; ")) if soft else Sentence(())


def known_misses(sport_name: str, from_tip: float | None = None) -> list[Block]:
    """List the places where an answer on an implement of a sport is known to be wrong; nothing elsewhere.

    Parameters
    ----------
    from_tip : m, of the hit; None: the whole implement is asked for.
    """
    misses = sport(sport_name).misses
    return [
        Paragraph(f"Known to be off: {miss.text}", "warning")
        for miss in misses
        if from_tip is None or miss.nearest <= from_tip <= miss.farthest
    ]


def assumed_wall(implement: Implement, efficiency: Number | None = None, bbcor: float = 0.0) -> list[Block]:
    """Return that a hollow bat's walls are the catalogue's and were not measured; nothing of any other implement.

    Parameters
    ----------
    efficiency, bbcor : the greatest q of a bat, and BBCOR at its best place. If a baseball bat is livelier than both
        the limit of 1999 and today's, the note says so.
    """
    if not isinstance(implement, Bat) or (pattern := wall_pattern(implement)) is None:
        return []
    note = say(
        "Its walls are those of the catalogue's {pattern}: assumed, not measured, and how fast a hollow bat hits rests "
        "on them.",
        pattern=pattern,
    )
    former, today = _limit("ncaa-1999", "besr") - 0.5, _limit("ncaa", "bbcor")
    if efficiency is None or implement.sport != "baseball" or float(efficiency) <= former or bbcor <= today:
        return [Paragraph(note, "warning")]
    beyond = say(
        "With q up to {most} it breaks the limit that colleges set in 1999, {former}, and every later one. A metal bat "
        "made to a limit has thicker walls and hits slower.",
        most=Slot(efficiency, "ratio", 3),
        former=Slot(former, "ratio", 3),
    )
    return [Paragraph(joined([note, beyond], " "), "warning")]


def _limit(name: str, quantity: str) -> float:
    """Return the most that a league allows of a quantity."""
    (most,) = (rule.most for rule in league(name).rules if rule.quantity == quantity)
    assert most is not None
    return most


def soft_note(sport_name: str, ball: Ball) -> list[Block]:
    """Return the assumed values of a ball as a note of a document, or nothing."""
    words = soft_defaults(sport_name, ball)
    return [Paragraph(words, "note")] if words.parts else []

"""A design as a document: what it does for the batter, bats beside each other, the front, sizes for the maker."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from sweetspot.answers.design import DesignAnswer
from sweetspot.answers.design_question import Designed
from sweetspot.answers.outline import TOLERANCE, rules_broken
from sweetspot.answers.records import to_dict
from sweetspot.catalog.files.write import implement_toml
from sweetspot.catalog.sports import sport
from sweetspot.designs.measures import MEASURES, MeasuredDesigns
from sweetspot.designs.pareto import saved
from sweetspot.designs.turned import HANDLES, TurnedSpace
from sweetspot.designs.variables import Space
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.arrays import Array
from sweetspot.reports.calibration.outline_report import drawing_remarks
from sweetspot.reports.design.words import breaking_words, gain_words, label_of, rules_words, tool_of
from sweetspot.reports.document import (
    Block,
    Bullets,
    Cell,
    Column,
    Document,
    Paragraph,
    Picture,
    Section,
    Table,
    drawn,
    table_head,
)
from sweetspot.reports.quantities import Reader, reader
from sweetspot.reports.sentences import Sentence, Slot, Words, read, say
from sweetspot.units import INCH

BESIDE = (
    "exit_speed",
    "best",
    "best_from_tip",
    "zone",
    "sting",
    "bat_speed",
    "swing_time",
    "mass",
    "balance_point",
    "moi",
    "length",
    "diameter",
    "handle",
    "knob",
    "cup_depth",
    "cup_diameter",
    "frequency",
    "durability",
)
ASKED = ("length", "knob", "cup_diameter")
"""What stands beside the present bat only where it was allowed to change."""
ON_FRONT = ("best_from_tip", "mass", "moi", "diameter")
MOST_ROWS = 8
FILES = "designed-bat"
"""How the files for the maker begin."""


def design_document(answer: DesignAnswer) -> Document:
    """Return a design as a document, with the bat's file and drawings going along."""
    design = answer.designed
    bat, sport_words = design.bat, sport(design.bench.space.present.sport).words
    reading = reader(None, sport_words)
    words = [*gain_words(design), *breaking_words(design), *rules_words(design)]
    picture = Picture(
        "design",
        drawn("sweetspot.reports.design.picture:design_figure", design),
        label="The design's outline, its difference from the present bat, and the front.",
        caption="Band: two of one shape, 90 %. Grey: where the ball is met.",
    )
    notes: list[Words] = [_assumed(design)]
    if not answer.complete:
        notes.append(
            f"Stopped after {answer.generations} of {design.question.generations} generations; the front is that "
            "found by then."
        )
    turned = isinstance(bat, Bat) and bat.shell is None
    return Document(
        name="design",
        title=bat.name,
        kind="Design",
        subtitle=_subtitle(design),
        blocks=[*map(Paragraph, words), picture, _beside(design), *(Paragraph(note, "note") for note in notes)],
        data={**answer.to_dict(), "words": [read(sentence, reading) for sentence in words]},
        rows=to_dict(answer.front),
        reader=reading,
        drawing=picture,
        details=[
            *_materials(answer),
            _front(design),
            *([_rules(design)] if design.checks else []),
            *_limits(design),
            *([sizes_table(bat)] if isinstance(bat, Bat) and turned else []),
            *tolerance_paragraph(design),
        ],
        attachments=_files(design),
    )


def _files(design: Designed) -> dict[str, Callable[[Reader], bytes]]:
    """Return the files that go along: the bat, its drawings, and the search to go on from."""
    bat = design.bat
    files: dict[str, Callable[[Reader], bytes]] = {
        "search.json": lambda _: saved(design.bench, design.question, design.front).encode(),
        f"{FILES}.toml": lambda _: implement_toml(bat).encode(),
    }
    for ending in DRAWN_BATS if isinstance(bat, Bat) else DRAWN_OTHERS:
        files[f"{FILES}.{ending}"] = partial(_drawing, design, ending)
    return files


DRAWN_BATS, DRAWN_OTHERS = ("svg", "dxf", "pdf", "csv", "lathe.csv", "stl", "step"), ("svg", "dxf", "pdf")
"""Endings of the drawings that go along with a round bat, and with anything else."""


def _drawing(design: Designed, ending: str, reading: Reader) -> bytes:
    remarks = drawing_remarks(rules_broken(design.bat, design.league), reading)
    return drawing(design.bat, ending, reading, remarks)


def _subtitle(design: Designed) -> str:
    wants = " and ".join(MEASURES[want].label for want in design.question.wants)
    return f"{tool_of(design)} {design.picked + 1} of {len(design.front)} on the front of {wants}"


def _assumed(design: Designed) -> Words:
    batter = design.bench.batter
    return say(
        "Contacts {batter.mean_contact:place} from the tip on average; {batter.pitch_speed:speed, 0} {incoming}, "
        "{batter.bat_speed:speed, 0} of {tool} speed with the present {tool}. The same places from the tip and the "
        "same effort with every {tool}. The model's ball, {wood} and swing; nothing was made.",
        tool=tool_of(design),
        incoming=sport(design.bench.space.present.sport).words.incoming,
        wood="wood" if design.gain.shipment else "material",
        batter=batter,
    )


def compared(space: Space, measured: MeasuredDesigns) -> list[str]:
    """Return which measures of a design stand beside the present bat's."""
    changing = {variable.name for variable in space.variables}
    return [name for name in BESIDE if name in measured.values and (name not in ASKED or name in changing)]


def _beside(design: Designed) -> Table:
    rows: list[list[Cell]] = []
    for name in compared(design.bench.space, design.front.measured):
        measure = MEASURES[name]
        value = design.value(name)
        now = design.now.values.get(name)
        before: Cell = None if now is None else Slot(float(now[0]), measure.scale)
        change: Cell = None if now is None else Slot(value - float(now[0]), _changes(measure.scale), sign=True)
        rows.append([label_of(design, name), before, Slot(value, measure.scale), change])
    if design.bent is not None:
        strains = [bending.strain for bending in design.bent]
        rows.append(
            [
                "greatest bending of the handle",
                *(Slot(strain, "strain") for strain in strains),
                Slot(strains[1] - strains[0], "strain", sign=True),
            ]
        )
    columns = table_head(" | present > | design > | change >")
    return Table(f"Beside the present {tool_of(design)}", columns, rows)


def _changes(scale: str) -> str:
    return {"speed": "speed_change", "place": "length"}.get(scale, scale)


def _front(design: Designed) -> Table:
    wants = design.question.wants
    names = [name for name in (*wants, *ON_FRONT) if name in design.front.measured.values]
    count = len(design.front)
    rows_shown = sorted({*np.linspace(0, count - 1, min(MOST_ROWS, count)).round().astype(int).tolist(), design.picked})
    rows: list[list[Cell]] = [
        [str(row + 1), *(float(design.front.measured.values[name][row]) for name in names)] for row in rows_shown
    ]
    columns = [Column(tool_of(design))] + [Column(_short(name), MEASURES[name].scale) for name in names]
    return Table(
        f"The front: {count} {tool_of(design)}s, none better in everything (--pick N tells about another)"
        if count > 1
        else f"The front: one {tool_of(design)}, better in everything than the others",
        columns,
        rows,
    )


def _materials(answer: DesignAnswer) -> list[Block]:
    """Return the best in every want of each material, where several were looked at; none: it keeps no limit."""
    wants = answer.wants
    rows: list[list[Cell]] = [
        [material.name, *(getattr(material.best, want) for want in wants)] for material in answer.materials
    ]
    columns = [Column("material")] + [Column(_short(name), MEASURES[name].scale) for name in wants]
    return [Table("Materials: the best of each front", columns, rows)] if rows else []


def _short(name: str) -> str:
    return {
        "exit_speed": "exit speed",
        "zone": "zone",
        "sting": "sting",
        "best": "greatest",
        "best_from_tip": "best place",
        "swing_time": "time",
        "moi": "MOI",
        "diameter": "thickest",
        "durability": "durability",
    }.get(name, MEASURES[name].label)


def _rules(design: Designed) -> Table:
    from sweetspot.analysis.certification.rules import title

    rows: list[list[Cell]] = [[title(check.rule), check.words, check.reason] for check in design.checks]
    return Table("Rules", table_head("rule | verdict | why"), rows)


def _limits(design: Designed) -> list[Section]:
    lines = []
    for limit in design.question.limits:
        scale = MEASURES[limit.measure].scale
        low, high = (None if end is None else Slot(end, scale) for end in (limit.least, limit.most))
        label = MEASURES[limit.measure].label
        if low is not None and high is not None:
            lines.append(say("{label}: {low} to {high} ({why})", label=label, low=low.bare, high=high, why=limit.why))
        else:
            end, side = (low, "at least") if high is None else (high, "at most")
            assert end is not None
            lines.append(say("{label}: {side} {end} ({why})", label=label, side=side, end=end, why=limit.why))
    return [Section("limits", "Limits kept", [Bullets(lines)])] if lines else []


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


def drawing(bat: Implement, ending: str, reading: Reader, remarks: Sequence[str] = ()) -> bytes:
    """Return the drawing of a bat as a file with this ending; ``remarks``: what must stand on it."""
    from pathlib import Path

    from sweetspot.reports.drawings.drawing_file import Workshop, drawing_bytes

    return drawing_bytes(bat, Path(f"bat.{ending}"), reading=reading, workshop=Workshop(tuple(remarks)))


def tolerance_paragraph(design: Designed) -> list[Paragraph]:
    """Return the tolerance as a note, or nothing."""
    words = tolerance_words(design)
    return [] if words is None else [Paragraph(words, "note")]

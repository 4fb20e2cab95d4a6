"""The report of an implement of any sport as a document: one sheet with the answer, then tables, limits and sources."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.answers.hit import hit_of
from sweetspot.calibration.draws.intervals import Reaches
from sweetspot.calibration.draws.linear_doubt import speed_doubt
from sweetspot.calibration.draws.sources import Sources as Unknown
from sweetspot.calibration.draws.sources import sources_of
from sweetspot.catalog.sports import sport
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.outline_doubt import moi_doubt
from sweetspot.dynamics.rigid import RigidBody, rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.numerics.confidence import REACH
from sweetspot.numerics.constants import STANDARD_AXIS
from sweetspot.report.bat.json import bat_json, report_json
from sweetspot.report.bat.made_of import made_of_words
from sweetspot.report.bat.tables import (
    along_table,
    conditions_table,
    mass_table,
    misses_table,
    modes_table,
    spots_table,
    stations,
)
from sweetspot.report.bat.words import (
    BEST_PLACE,
    BEST_SPEED,
    Miss,
    answer,
    from_tip,
    hand_and_tip,
    misses_of,
    why_intervals,
)
from sweetspot.report.document import Block, Cards, Document, Paragraph, Picture, Section, Sources
from sweetspot.report.hit.document import hit_picture, hit_table
from sweetspot.report.hit.second_touch import touched_again_between
from sweetspot.report.quantities import Reader
from sweetspot.report.sentences import PLUS_MINUS, Bounds, Sentence, Slot, Words, joined, say
from sweetspot.report.sport_words import in_words, reader_of, weight, words_of

COLUMNS, ROWS = 120, 90
"""Places of the maps of a face: enough for the eye."""


def report_document(
    analysis: Analysis[Implement],
    *,
    misses: Sequence[Miss] | None = None,
    reaches: Reaches | None = None,
    sources: Unknown | None = None,
) -> Document:
    """Return the report of an analysis as a document.

    Parameters
    ----------
    misses : what they cost; None: worked out.
    reaches : how far the intervals of draws go, which are put beside all numbers and into the picture; None: there are
        none, and the doubt of the best hit's exit speed is said as it is known without draws.
    sources : what is not known; None: what is not for a bat of this description, hit so.
    """
    bat, data = analysis.bat, report_json(analysis)
    doubt = None
    if reaches is None:
        doubt = speed_doubt(analysis, sources_of(bat, analysis.conditions) if sources is None else sources)
        if doubt is not None:
            data["best_hit"]["exit_speed_half_m_s"] = REACH * doubt.error
    misses = misses_of(analysis) if misses is None else misses
    overview = _overview(analysis, reaches)
    return Document(
        name="report", title=bat.name, subtitle=_sizes(analysis), kind=f"{sport(bat.sport).name}: sweet spot report",
        blocks=[
            _cards(analysis, misses, drawn=reaches is not None),
            *(Paragraph(words) for words in answer(analysis, misses, doubt=doubt, drawn=reaches is not None)),
            *(Paragraph(words) for words in remarks(bat)),
            overview,
        ],
        details=_details(analysis), appendix=partial(_appendix, analysis, misses, drawn=reaches is not None),
        data=data, rows=data["scan"],
        reader=reader_of(bat), drawing=overview,
    )  # fmt: skip


def described_document(bat: Implement) -> Document:
    """Return an implement alone, as nobody swings it, as a document: its size, weight and balance."""
    body = rigid_body(beam_model(bat))
    data = bat_json(bat.name, bat.length, body)
    return Document(
        name="bat", title=bat.name, subtitle=made_of_words(bat),
        kind=f"{sport(bat.sport).name}: {words_of(bat).implement}",
        blocks=[*_mass(bat, body), *(Paragraph(words) for words in remarks(bat))],
        data=data, rows={name: [value] for name, value in data.items()}, reader=reader_of(bat),
    )  # fmt: skip


def remarks(bat: Implement) -> list[str]:
    """Return how a bat's description was made to agree with what was measured on it; nothing where it did."""
    return [bat.remark] if isinstance(bat, Bat) and bat.remark else []


def _sizes(analysis: Analysis[Implement]) -> Sentence:
    bat, body, ball = analysis.bat, analysis.body, analysis.conditions.ball
    other = "" if ball == standard_conditions(bat).ball else f"; hit by: {ball.name}"
    return in_words(
        "{length} long, {mass}, {made_of}, balance {balance} from the {butt}{other}", words_of(bat), other=other,
        length=Slot(bat.length, "length"), mass=Slot(body.mass, "mass", of="bat.mass_kg"), made_of=made_of_words(bat),
        balance=Slot(body.balance_point, "place", of="bat.balance_point_m"),
    )  # fmt: skip


def _cards(analysis: Analysis[Implement], misses: Sequence[Miss], *, drawn: bool) -> Cards:
    """Return the few numbers that everybody asks for."""
    spots, words = analysis.sweet_spots, words_of(analysis.bat)
    width: Words | Slot = (
        "none" if spots.zone is None else Slot(spots.zone[1] - spots.zone[0], "place", of="sweet_spots.zone_width_m")
    )
    wide = "{zone}: no stretch is fast and quiet" if spots.zone is None else "wide: the {zone}, fast and quiet"
    cards: list[tuple[Words | Slot, Words]] = [
        (from_tip(analysis, spots.max_exit_speed, BEST_PLACE), in_words("from the {tip}: where it hits best", words)),
        (
            Slot(exit_speed_of(analysis.best, analysis.conditions), "speed", of=BEST_SPEED),
            f"{words.exit_speed} of the best hit",
        ),
        (width, in_words(wide, words)),
    ]
    if len(misses) > 1:
        miss = misses[1]
        worse = miss.inside if miss.outside.value != miss.outside.value else max(miss.inside, miss.outside)
        missed, bounds = (
            Slot(miss.distance, "place", round=True),
            Bounds(Slot(worse.value, "speed"), worse.low, worse.high),
        )
        of = hand_and_tip(1)[0 if worse is miss.inside else 1]
        told = say("for missing it by {missed}{bounds}", missed=missed, bounds="" if drawn else bounds)
        cards.append((Slot(-worse.value, "speed", of=f"-{of}"), told))
    return Cards([(joined([number]), words) for number, words in cards])


def _overview(analysis: Analysis[Implement], reaches: Reaches | None) -> Picture:
    words = words_of(analysis.bat)
    label = in_words(
        "{name} drawn to scale, its sweet spots marked. Below it curves of exit speed, collision efficiency, jolt at "
        "the hand, sting and bending modes along it. {exit_speed} is greatest, {speed}, {place} from the {tip}.", words,
        name=analysis.bat.name, speed=Slot(exit_speed_of(analysis.best, analysis.conditions), "speed", of=BEST_SPEED),
        place=from_tip(analysis, analysis.sweet_spots.max_exit_speed, BEST_PLACE),
    )  # fmt: skip
    shaded = "" if analysis.sweet_spots.zone is None else in_words(" Shaded: the {zone}.", words)
    caption = in_words("The {implement} to scale and, place for place, what a hit there does.", words) + shaded
    sheet = partial(_drawn_sheet, analysis, reaches=reaches)
    return Picture("overview", partial(_drawn_overview, analysis, reaches=reaches), label, caption, sheet)


def _drawn_overview(analysis: Analysis[Implement], reading: Reader, *, reaches: Reaches | None) -> Any:
    from sweetspot.report.bat.figure import report_figure

    return report_figure(analysis, reading, reaches)


def _drawn_sheet(analysis: Analysis[Implement], reading: Reader, *, reaches: Reaches | None) -> Any:
    from sweetspot.report.bat.sheet_picture import sheet_figure

    return sheet_figure(analysis, reading, reaches)


def _details(analysis: Analysis[Implement]) -> list[Block]:
    """Return the tables, which terminals show too."""
    words = words_of(analysis.bat)
    best = hit_of(analysis.best, body=analysis.body, conditions=analysis.conditions)
    masses = in_words(
        "{implement} {tool}, {ball} {thrown}",
        words,
        tool=Slot(analysis.body.mass, "mass", of="bat.mass_kg"),
        thrown=weight(analysis.conditions.ball.mass, "conditions.ball_mass_kg"),
    )
    table = hit_table(best, analysis.bat, masses, at="best_hit.")
    caption = in_words(
        "Left: the force between {ball} and {implement}. Right: the same force against the {ball}'s compression; the "
        "area inside the loop is heat. Below: the energy as a laboratory counts it that fires the {ball} at a "
        "{implement} at rest, where a {ball} that flies back slowly has little energy left.", words,
    )  # fmt: skip
    where = in_words("The best hit, {place} from the {tip}", words, place=from_tip(analysis, analysis.best.position))
    return [
        Section("sweet-spots", "Every sweet spot", [spots_table(analysis)]),
        Section("along", f"Along the {words.implement}", [along_table(analysis), *_touched_again(analysis)]),
        Section("mass", "Weight and balance", _mass(analysis.bat, analysis.body, told=True)),
        Section("modes", "How it rings", [modes_table(analysis.bat, analysis.modes)]),
        Section("best-hit", where, [table, hit_picture(analysis.best, words, caption)]),
        Section("conditions", "Conditions", [conditions_table(analysis)]),
    ]


def _touched_again(analysis: Analysis[Implement]) -> list[Block]:
    """Return what is not known of hits in the table that touch the ball more than once."""
    scan, length = analysis.scan, analysis.bat.length
    from_tip = length - scan.position
    shown = from_tip <= stations(analysis)[-1]
    doubts = touched_again_between(from_tip[shown], scan.touches[shown], words_of(analysis.bat))
    return [Paragraph(doubt, "note") for doubt in doubts]


def _mass(bat: Implement, body: RigidBody, *, told: bool = False) -> list[Block]:
    """Return the table of weight and balance, and what ± means where it has one or was told of a speed before."""
    doubted = told or moi_doubt(bat, body, STANDARD_AXIS) > 0
    return [mass_table(bat, body), *([Paragraph(PLUS_MINUS, "note")] if doubted else [])]


def _appendix(analysis: Analysis[Implement], misses: Sequence[Miss], *, drawn: bool) -> list[Block]:
    """Return what only an opened page shows: maps, misses, limits, published numbers, constants, sources."""
    from sweetspot.report.bat.appendix import assumptions_section, constants_section
    from sweetspot.report.bat.beside_published import chosen, published_section
    from sweetspot.report.bat.provenance import sources_of, used_records

    face, published = analysis.bat.face, chosen(analysis.bat.sport)
    keys = sources_of(used_records(analysis)) + [result.source for result in published]
    return [
        *([] if face is None else [Section("face-map", "All over the face", [_face_picture(analysis)])]),
        *([Section("misses", "What a miss costs", [
            misses_table(misses, analysis.bat), Paragraph(why_intervals(words_of(analysis.bat), drawn=drawn)),
        ])]
          if misses else []),
        assumptions_section(analysis), *published_section(published), constants_section(analysis),
        Section("sources", "Sources", [Sources(sorted(set(keys)))]),
    ]  # fmt: skip


def _face_picture(analysis: Analysis[Implement]) -> Picture:
    caption = in_words(
        "Hits all over the face, handle to the left: {exit_speed}, efficiency and vibration at the hand. The dot is "
        "the best place. A hit beside the line also turns the face, which sends the {ball} off at an angle: that is "
        "not in these maps.", words_of(analysis.bat),
    )  # fmt: skip
    label = f"Three maps of the face of {analysis.bat.name}: exit speed, efficiency and sting."
    return Picture("face", partial(_drawn_face, analysis), label, caption)


def _drawn_face(analysis: Analysis[Implement], reading: Reader) -> Any:
    from sweetspot.analysis.face_maps import face_map
    from sweetspot.report.bat.face_picture import face_figure

    hits = face_map(analysis.reduced, analysis.conditions, columns=COLUMNS, rows=ROWS)
    return face_figure(hits, analysis.bat, reading)

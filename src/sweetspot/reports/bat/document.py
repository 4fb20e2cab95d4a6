"""The report of an implement of any sport as a document: one sheet with the answer, then tables, limits and sources."""

from __future__ import annotations

from functools import partial

from sweetspot.analysis.bat_analysis import Analysis
from sweetspot.answers.description import Description, described
from sweetspot.answers.records import to_dict
from sweetspot.answers.report import ReportAnswer
from sweetspot.answers.unhit import UnhitAnswer
from sweetspot.catalog.sports import sport
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import ReducedBat
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.implement import Implement
from sweetspot.equipment.sport import Terms
from sweetspot.motion.swing import Conditions
from sweetspot.numerics.interval import Interval
from sweetspot.reports.bat.provenance import assumed_wall, known_misses
from sweetspot.reports.bat.tables import (
    along_table,
    conditions_table,
    mass_table,
    misses_table,
    modes_table,
    places_table,
    spots_table,
    stations,
)
from sweetspot.reports.bat.words import answer_words, from_tip, why_in_brackets
from sweetspot.reports.document import Block, Cards, Document, Paragraph, Picture, Section, SourceList, drawn, one_row
from sweetspot.reports.hit.document import hit_picture, hit_table, masses_words, touched_again_between
from sweetspot.reports.sentences import PLUS_MINUS, Bounds, Sentence, Slot, Words, joined, say
from sweetspot.reports.sport_words import in_words, made_of_words, reader_of, weight, words_of
from sweetspot.reports.uncertainty import how_sure


def report_document(report: ReportAnswer) -> Document:
    """Return a report as a document."""
    bat, data = report.analysis.bat, report.to_dict()
    overview = _overview(report)
    return Document(
        name="report",
        title=bat.name,
        subtitle=_sizes(report),
        kind=f"{sport(bat.sport).name}: sweet spot report",
        blocks=[
            _cards(report),
            *(Paragraph(words) for words in answer_words(report)),
            *(Paragraph(words) for words in remarks(bat)),
            *known_misses(bat.sport),
            *assumed_wall(bat, report.greatest_efficiency, float(report.best_hit.bbcor)),
            overview,
            *([] if report.uncertainty is None else [how_sure(report.uncertainty, "best exit speed")]),
        ],
        details=_details(report),
        appendix=partial(_appendix, report),
        data=data,
        rows=data["scan"],
        reader=reader_of(bat.sport),
        drawing=overview,
    )


def described_document(bat: Implement) -> Document:
    """Return an implement without a swing as a document: its size, weight and balance."""
    beam = beam_model(bat)
    description = described(beam, rigid_body(beam))
    data = to_dict(description.bat)
    words = words_of(bat.sport)
    return Document(
        name="bat",
        title=bat.name,
        subtitle=made_of_words(bat),
        kind=f"{sport(bat.sport).name}: {words.implement}",
        blocks=[*_mass(description, words), *(Paragraph(words) for words in remarks(bat))],
        data=data,
        rows=one_row(data),
        reader=reader_of(bat.sport),
    )


def remarks(bat: Implement) -> list[str]:
    """Return how a bat's description was adjusted to its measurements; nothing if they agreed."""
    return [bat.remark] if isinstance(bat, Bat) and bat.remark else []


def _sizes(report: ReportAnswer) -> Sentence:
    bat, ball = report.analysis.bat, report.analysis.conditions.ball
    other = "" if ball == standard_conditions(bat).ball else f"; hit by: {ball.name}"
    return in_words(
        "{length:length} long, {report.bat.mass:mass}, {made_of}, balance {report.bat.balance_point:place} from the "
        "{butt}{other}",
        words_of(bat.sport),
        other=other,
        length=bat.length,
        report=report,
        made_of=made_of_words(bat),
    )


def _cards(report: ReportAnswer) -> Cards:
    """Return the cards with the main numbers."""
    spots, words = report.sweet_spots, words_of(report.analysis.bat.sport)
    width: Words | Slot = "none" if spots.zone_width is None else Slot(spots.zone_width, "place")
    wide = "{zone}: no stretch is fast and quiet" if spots.zone is None else "wide: the {zone}, fast and quiet"
    cards: list[tuple[Words | Slot, Words]] = [
        (from_tip(report, spots.max_exit_speed), in_words("from the {tip}: where it hits best", words)),
        (Slot(report.best_hit.exit_speed, "speed"), f"{words.exit_speed} of the best hit"),
        (width, in_words(wide, words)),
    ]
    if len(report.misses) > 1:
        miss = report.misses[1]
        worse = miss.inside
        if float(miss.outside) > float(miss.inside):  # not where it is off the implement, which is nan
            worse = miss.outside
        drawn, bounds = report.uncertainty is not None, say("")
        if isinstance(worse, Interval) and not drawn:
            bounds = Sentence((Bounds(Slot(worse.value, "speed"), worse.low, worse.high),))
        missed = Slot(miss.distance, "place", round=True)
        caption = say("for missing it by {missed}{bounds}", missed=missed, bounds=bounds)
        lost = worse if drawn else float(worse)
        cards.append((Slot(-lost, "speed"), caption))
    return Cards([(joined([number]), words) for number, words in cards])


def _overview(report: ReportAnswer) -> Picture:
    bat, spots = report.analysis.bat, report.sweet_spots
    words = words_of(bat.sport)
    label = in_words(
        "{name} drawn to scale, its sweet spots marked. Below it curves of exit speed, collision efficiency, jolt at "
        "the hand, sting and bending modes along it. {exit_speed} is greatest, {speed:speed}, {place} from the {tip}.",
        words,
        name=bat.name,
        speed=report.best_hit.exit_speed,
        place=from_tip(report, spots.max_exit_speed),
    )
    shaded = "" if spots.zone is None else in_words(" Shaded: the {zone}.", words)
    caption = in_words("The {implement} to scale and, place for place, what a hit there does.", words) + shaded
    return Picture(
        "overview",
        drawn("sweetspot.reports.bat.figure:report_figure", report),
        label,
        caption,
        drawn("sweetspot.reports.bat.figure:sheet_figure", report),
    )


def _details(report: ReportAnswer) -> list[Block]:
    """Return the tables, which terminals show too."""
    analysis = report.analysis
    words = words_of(analysis.bat.sport)
    caption = in_words(
        "Left: the force between {ball} and {implement}. Right: the same force against the {ball}'s compression; the "
        "area inside the loop is heat. Below: the energy as a laboratory counts it that fires the {ball} at a "
        "{implement} at rest, where a {ball} that flies back slowly has little energy left.",
        words,
    )
    where = in_words("The best hit, {place} from the {tip}", words, place=from_tip(report, analysis.best.position))
    masses = masses_words(report.bat.mass, report.conditions.ball_mass, words)
    table = hit_table(report.best_hit, words, masses, rigid=analysis.bat.face is None)
    return [
        Section("sweet-spots", "Every sweet spot", [spots_table(report)]),
        Section("along", f"Along the {words.implement}", [along_table(report), *_touched_again(analysis)]),
        Section("mass", "Weight and balance", _mass(report, words, note=True)),
        Section("modes", "How it rings", [modes_table(report.modes, words, analysis.bat.length)]),
        Section("best-hit", where, [table, hit_picture(analysis.best, words, caption)]),
        Section("conditions", "Conditions", [conditions_table(report)]),
    ]


def _touched_again(analysis: Analysis[Implement]) -> list[Block]:
    """Return notes on the hits in the table that touch the ball more than once."""
    scan, length = analysis.scan, analysis.bat.length
    from_tip = length - scan.position
    in_table = from_tip <= stations(analysis)[-1]
    doubts = touched_again_between(from_tip[in_table], scan.touches[in_table], words_of(analysis.bat.sport))
    return [Paragraph(doubt, "note") for doubt in doubts]


def _mass(description: Description, words: Terms, *, note: bool = False) -> list[Block]:
    """Return the table of weight and balance, with a note on ± if ``note`` or if the moment of inertia has a doubt."""
    doubted = note or float(description.bat.moi_6in_doubt) > 0
    return [mass_table(description, words), *([Paragraph(PLUS_MINUS, "note")] if doubted else [])]


def _appendix(report: ReportAnswer) -> list[Block]:
    """Return the appendix of a page: maps, misses, limits, published numbers, constants, sources."""
    from sweetspot.reports.bat.appendix import assumptions_section, chosen, constants_section, published_section
    from sweetspot.reports.bat.provenance import sources_of, used_records

    analysis = report.analysis
    face, results = analysis.bat.face, chosen(analysis.bat.sport)
    keys = sources_of(used_records(analysis)) + [result.source for result in results]
    sections = [] if face is None else [Section("face-map", "All over the face", [_face_picture(analysis)])]
    if report.misses:
        why = why_in_brackets(report, words_of(analysis.bat.sport))
        explained = [Paragraph(why)] if why.parts else []
        sections.append(Section("misses", "What a miss costs", [misses_table(report), *explained]))
    sources = Section("sources", "Sources", [SourceList(sorted(set(keys)))])
    published = published_section(results)
    return [*sections, assumptions_section(analysis), *published, constants_section(analysis), sources]


def _face_picture(analysis: Analysis[Implement]) -> Picture:
    caption = in_words(
        "Hits all over the face, handle to the left: {exit_speed}, efficiency and vibration at the hand. The dot is "
        "the best place. A hit beside the line also turns the face, which sends the {ball} off at an angle: that is "
        "not in these maps.",
        words_of(analysis.bat.sport),
    )
    label = f"Three maps of the face of {analysis.bat.name}: exit speed, efficiency and sting."
    return Picture(
        "face", drawn("sweetspot.reports.bat.outline_picture:analysis_face_figure", analysis), label, caption
    )


def unhit_document(answer: UnhitAnswer) -> Document:
    """Return the report of an implement that is no heavier than the ball."""
    bat, data = answer.reduced.bat, answer.to_dict()
    places = {name: place for name, place in vars(answer.sweet_spots).items() if place is not None}
    return Document(
        name="report",
        title=bat.name,
        subtitle=made_of_words(bat),
        kind=f"{sport(bat.sport).name}: without a ball",
        blocks=[Paragraph(_why(answer.reduced, answer.conditions))],
        details=[
            Section("sweet-spots", "What needs no ball", [places_table(places, words_of(bat.sport), bat.length)]),
            Section("mass", "Weight and balance", [mass_table(answer, words_of(bat.sport))]),
            Section("modes", "How it rings", [modes_table(answer.modes, words_of(bat.sport), bat.length)]),
        ],
        data=data,
        rows={name: [mode[name] for mode in data["modes"]] for name in ("family", "harmonic", "frequency_hz")},
        reader=reader_of(bat.sport),
    )


def _why(reduced: ReducedBat[Implement], conditions: Conditions) -> Sentence:
    bat = reduced.bat
    return in_words(
        "No hit is computed: the {ball} weighs {ball_mass} and this {implement} {mass}; a {ball} that is not lighter "
        "sweeps it aside. Its first two tones are {first} and {second}. What else needs no {ball} stands below.",
        words_of(bat.sport),
        ball_mass=weight(conditions.ball.mass),
        mass=weight(reduced.body.mass),
        first=_tone(reduced, 1),
        second=_tone(reduced, 2),
    )


def _tone(reduced: ReducedBat[Implement], harmonic: int) -> Slot:
    modes = reduced.modes
    return Slot(float(modes.frequency[modes.of_family("bending")[harmonic - 1]]), "frequency")

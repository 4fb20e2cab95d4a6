"""Answers as a notebook shows them: each kind of answer is turned into its document, and that into HTML."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from io import StringIO
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any

from sweetspot.answers.setups import SwungWith
from sweetspot.errors import InputError
from sweetspot.numerics.interval import NO_SPEED
from sweetspot.reports.document import Document, Paragraph
from sweetspot.reports.sentences import Sentence, say

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from sweetspot.analysis.bat_analysis import Analysis
    from sweetspot.flight.trajectory import Flight


def html_of(answer: Any) -> str:
    """Return an answer of the package as HTML, its details and its appendix, if that is made already, to be opened.

    Raises
    ------
    TypeError
        for what has no document.
    """
    document = document_of(answer)
    from sweetspot.reports.html import notebook_cell

    behind = () if callable(document.appendix) else document.appendix
    return notebook_cell(replace(document, appendix=[*document.details, *behind]), document.reader)


def text_of(answer: Any) -> str:
    """Return an answer as the command line prints it."""
    from rich.console import Console

    from sweetspot.reports.terminal import ROOM, to_terminal

    document = document_of(answer)
    console = Console(width=ROOM, highlight=False, file=StringIO(), record=True)
    console.print(to_terminal(document, document.reader))
    return "\n".join(line.rstrip() for line in console.export_text().splitlines())


def figure_of(answer: Any) -> Figure:
    """Return the picture of an answer of the package, in the units of its sport.

    Raises
    ------
    InputError
        for an answer that has none.
    """
    document = document_of(answer)
    if document.drawing is None:
        raise InputError(f"a {type(answer).__name__} has no picture; print it, or plot its fields")
    return document.drawing.draw(document.reader)


def document_of(answer: Any) -> Document:
    """Return the document of an answer: an analysis, a play, a flight, ... or a document itself."""
    if isinstance(answer, Document):
        return answer
    for kind in type(answer).__mro__:
        if maker := MAKERS.get(kind.__name__):
            document: Document = resolve_name(maker)(answer)
            return with_effort(document, getattr(answer, "swung_with", None))
    raise TypeError(f"a {type(answer).__name__} has no document; use its own fields")


def _flight_document(flight: Flight) -> Document:
    from sweetspot.answers.flight import flight_of
    from sweetspot.reports.flight.document import flight_document

    return flight_document(flight_of(flight))


def _analysis_document(found: Analysis[Any]) -> Document:
    from sweetspot.answers.report import report_of
    from sweetspot.reports.bat.document import report_document
    from sweetspot.uncertainty.sources import sources_of

    return report_document(report_of(found, sources_of(found.bat, found.conditions)))


MAKERS: Mapping[str, str] = {
    "Flight": "sweetspot.reports.notebook:_flight_document",
    "FlyAnswer": "sweetspot.reports.flight.document:fly_document",
    "FlightAnswer": "sweetspot.reports.flight.document:flight_document",
    "PlayAnswer": "sweetspot.reports.play:play_document",
    "OptimumAnswer": "sweetspot.reports.optimum:optimum_document",
    "DropAnswer": "sweetspot.reports.bench:drop_document",
    "DesignAnswer": "sweetspot.reports.design.document:design_document",
    "SeasonAnswer": "sweetspot.reports.season.document:season_document",
    "SeasonPlayer": "sweetspot.reports.season.document:player_page",
    "PendulumAnswer": "sweetspot.reports.bench:pendulum_document",
    "RankAnswer": "sweetspot.reports.calibration.ranking_report:ranking_document",
    "CalibrateAnswer": "sweetspot.reports.calibration.document:calibration_document",
    "CalibrateBallAnswer": "sweetspot.reports.calibration.ball_report:calibrate_ball_document",
    "FitPlayerAnswer": "sweetspot.reports.player.document:player_document",
    "PlanSwingsAnswer": "sweetspot.reports.player.plan:plan_document",
    "FitTeamAnswer": "sweetspot.reports.player.team:team_document",
    "TapAnswer": "sweetspot.reports.tap:tap_document",
    "OutlineAnswer": "sweetspot.reports.calibration.outline_report:outline_document",
    "Comparison": "sweetspot.reports.comparison.document:comparison_document",
    "Certification": "sweetspot.reports.certification.document:certification_document",
    "Analysis": "sweetspot.reports.notebook:_analysis_document",
    "ReportAnswer": "sweetspot.reports.bat.document:report_document",
    "UnhitAnswer": "sweetspot.reports.bat.document:unhit_document",
    "SealedAnswer": "sweetspot.reports.sealed:sealed_document",
    "ScoreAnswer": "sweetspot.reports.sealed:score_document",
    "PaperAnswer": "sweetspot.reports.bench:paper_document",
    "CertifyClubAnswer": "sweetspot.reports.certification.club_document:certify_club_document",
    "CertifyPaddleAnswer": "sweetspot.reports.certification.paddle_document:certify_paddle_document",
    "CertifyAnswer": "sweetspot.reports.certification.document:certificate_document",
    "KitAnswer": "sweetspot.reports.kit:kit_document",
    "MatchAnswer": "sweetspot.reports.matching:match_document",
    "CompareAnswer": "sweetspot.reports.comparison.document:compare_document",
    "MaterialAnswer": "sweetspot.reports.materials:material_document",
    "MaterialsAnswer": "sweetspot.reports.materials:materials_document",
    "ParkAnswer": "sweetspot.reports.flight.parks:park_document",
    "ParksAnswer": "sweetspot.reports.flight.parks:parks_document",
    "SportAnswer": "sweetspot.reports.sports:sport_document",
    "SportsAnswer": "sweetspot.reports.sports:sports_document",
    "WhatIfAnswer": "sweetspot.reports.comparison.document:what_if_document",
    "FlyTableAnswer": "sweetspot.reports.many:fly_table_document",
    "HitAnswer": "sweetspot.reports.hit.document:hit_document",
    "Impact": "sweetspot.reports.hit.document:impact_document",
    "Implement": "sweetspot.reports.bat.document:described_document",
    "Impacts": "sweetspot.reports.many:impacts_document",
    "Strikes": "sweetspot.reports.many:impacts_document",
    "Flights": "sweetspot.reports.many:flights_document",
    "Play": "sweetspot.reports.play:bare_play_document",
    "Plays": "sweetspot.reports.play:bare_play_document",
    "Strike": "sweetspot.reports.play:strike_document",
    "Modes": "sweetspot.reports.modes:modes_document",
}
"""By the class of an answer, a name of one meaning, the function that makes its document; loaded when it is needed."""


def effort_words(swung: SwungWith) -> Sentence:
    """Say how a changed bat is swung, and what its speed became."""
    name, speed = swung.changed.bat.name, float(swung.bat_speed)
    if swung.same == "speed":
        other = swung.changed.with_same_effort(swung.conditions).swing.bat_speed
        return say(
            "{name}: swung at the same speed as before the change, {speed:speed}; with the same effort it would move "
            "at {other:speed}.",
            name=name,
            speed=speed,
            other=other,
        )
    before = float(swung.bat_speed_before)
    if abs(speed - before) < NO_SPEED:
        return say(
            "{name}: swung with the same effort as before the change, which leaves its speed at {speed:speed}.",
            name=name,
            speed=speed,
        )
    return say(
        "{name}: swung with the same effort as before the change, at {speed:speed} in place of {before:speed}.",
        name=name,
        speed=speed,
        before=before,
    )


def with_effort(document: Document, swung: SwungWith | None) -> Document:
    """Return an answer about a changed bat with the sentence that says how it is swung; of another as it is."""
    if swung is None:
        return document
    blocks = [*document.blocks]
    place = next((at for at, block in enumerate(blocks[:2], start=1) if isinstance(block, Paragraph)), 0)
    blocks.insert(place, Paragraph(effort_words(swung)))
    return replace(document, blocks=blocks)

"""Answers as a notebook shows them: each kind of answer is turned into its document, and that into HTML."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO
from typing import TYPE_CHECKING, Any

from sweetspot.errors import InputError
from sweetspot.reports.document import Document
from sweetspot.reports.html import notebook_cell
from sweetspot.reports.swung_with import with_effort

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def html_of(answer: Any) -> str:
    """Return an answer of the package as HTML.

    Raises
    ------
    TypeError
        for what has no document.
    """
    document = document_of(answer)
    return notebook_cell(document, document.reader)


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
    for kind, make in _makers():
        if isinstance(answer, kind):
            return with_effort(make(answer), getattr(answer, "swung_with", None))
    raise TypeError(f"a {type(answer).__name__} has no document; use its own fields")


def _makers() -> tuple[tuple[type, Callable[[Any], Document]], ...]:
    """Return every kind of answer with what makes its document."""
    from sweetspot.analysis.bat_analysis import Analysis
    from sweetspot.analysis.certification.simulated_test import Certification
    from sweetspot.analysis.comparison import Comparison
    from sweetspot.analysis.full_play import Play, Plays
    from sweetspot.answers.calibrate import CalibrateAnswer
    from sweetspot.answers.certify import CertifyAnswer
    from sweetspot.answers.compare import CompareAnswer
    from sweetspot.answers.design import DesignAnswer
    from sweetspot.answers.drop import DropAnswer
    from sweetspot.answers.flight import FlightAnswer, flight_of
    from sweetspot.answers.fly import FlyAnswer
    from sweetspot.answers.hit import HitAnswer
    from sweetspot.answers.optimum import OptimumAnswer
    from sweetspot.answers.outline import OutlineAnswer
    from sweetspot.answers.paper import PaperAnswer
    from sweetspot.answers.pendulum import PendulumAnswer
    from sweetspot.answers.play import PlayAnswer
    from sweetspot.answers.player import FitPlayerAnswer
    from sweetspot.answers.rank import RankAnswer
    from sweetspot.answers.report import ReportAnswer, report_of
    from sweetspot.answers.season import SeasonAnswer, SeasonPlayer
    from sweetspot.answers.tap import TapAnswer
    from sweetspot.answers.team import FitTeamAnswer
    from sweetspot.answers.unhit import UnhitAnswer
    from sweetspot.collision.hit_in_space import Strike, Strikes
    from sweetspot.collision.impact import Impact, Impacts
    from sweetspot.dynamics.modes import Modes
    from sweetspot.equipment.implement import Implement
    from sweetspot.flight.kernel import Flights
    from sweetspot.flight.trajectory import Flight
    from sweetspot.reports.bat.document import described_document, report_document, unhit_document
    from sweetspot.reports.bench import drop_document, paper_document, pendulum_document
    from sweetspot.reports.calibration.document import calibration_document
    from sweetspot.reports.calibration.outline_report import outline_document
    from sweetspot.reports.calibration.ranking_report import ranking_document
    from sweetspot.reports.certification.document import certificate_document, certification_document
    from sweetspot.reports.comparison.document import compare_document, comparison_document
    from sweetspot.reports.design.document import design_document
    from sweetspot.reports.flight.document import flight_document, fly_document
    from sweetspot.reports.flight.many import flights_document
    from sweetspot.reports.hit.document import hit_document, impact_document
    from sweetspot.reports.hit.many_hits import impacts_document
    from sweetspot.reports.modes.document import modes_document
    from sweetspot.reports.optimum.document import optimum_document
    from sweetspot.reports.play.document import bare_play_document, play_document, strike_document
    from sweetspot.reports.player.document import player_document
    from sweetspot.reports.player.team import team_document
    from sweetspot.reports.season.document import season_document
    from sweetspot.reports.season.one_player import player_page
    from sweetspot.reports.tap.document import tap_document
    from sweetspot.uncertainty.sources import sources_of

    return (
        (Flight, lambda flight: flight_document(flight_of(flight))),
        (FlyAnswer, fly_document),
        (FlightAnswer, flight_document),
        (PlayAnswer, play_document),
        (OptimumAnswer, optimum_document),
        (DropAnswer, drop_document),
        (DesignAnswer, design_document),
        (SeasonAnswer, season_document),
        (SeasonPlayer, player_page),
        (PendulumAnswer, pendulum_document),
        (RankAnswer, ranking_document),
        (CalibrateAnswer, calibration_document),
        (FitPlayerAnswer, player_document),
        (FitTeamAnswer, team_document),
        (TapAnswer, tap_document),
        (OutlineAnswer, outline_document),
        (Comparison, comparison_document),
        (Certification, certification_document),
        (Analysis, lambda found: report_document(report_of(found, sources_of(found.bat, found.conditions)))),
        (ReportAnswer, report_document),
        (UnhitAnswer, unhit_document),
        (PaperAnswer, paper_document),
        (CertifyAnswer, certificate_document),
        (CompareAnswer, compare_document),
        (HitAnswer, hit_document),
        (Impact, impact_document),
        (Implement, described_document),
        (Impacts, impacts_document),
        (Strikes, impacts_document),
        (Flights, flights_document),
        (Play, bare_play_document),
        (Plays, bare_play_document),
        (Strike, strike_document),
        (Modes, modes_document),
    )

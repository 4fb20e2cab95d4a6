"""Write the tables, figures and numbers that the pages include. Called when the pages are built; needs no network."""

from __future__ import annotations

import json
import time
from collections.abc import Callable
from pathlib import Path

import choices
import evidence
import licences
import modules
import sport_tables
import tables
from cases import analysed
from facts import facts
from figures import (
    architecture,
    axes,
    ball,
    calibration,
    convergence,
    flight,
    hollow,
    home_runs,
    oblique,
    optimum,
    parks,
    percussion,
    season,
    spots,
)
from matplotlib import rc_context
from matplotlib.figure import Figure

from sweetspot.answers.report import report_of
from sweetspot.answers.schema import answer_names, answer_schema, answer_type
from sweetspot.reports.bat.figure import report_figure

HERE = Path(__file__).resolve().parent
SVG = {"svg.hashsalt": "sweetspot", "svg.fonttype": "path", "font.family": "DejaVu Sans", "font.size": 10}


def figures() -> dict[str, Callable[[], Figure]]:
    """Return every figure by the name of its file."""
    return {
        "flagship": lambda: report_figure(report_of(analysed())),
        "architecture": architecture.architecture_figure,
        "axes": axes.axes_figure,
        "sweet_spots": spots.sweet_spots_figure,
        "modes": spots.modes_figure,
        "ledger": spots.ledger_figure,
        "ball": ball.force_figure,
        "wall": hollow.wall_figure,
        "offset": oblique.offset_figure,
        "parks": parks.parks_figure,
        "home_runs": home_runs.calibration_figure,
        "season": season.coverage_figure,
        "optimum": optimum.optimum_figure,
        "flight": flight.flight_figure,
        "flight_convergence": flight.flight_convergence,
        "calibration": calibration.worth_figure,
        "hand_force": percussion.hand_force_figure,
        "mesh_convergence": convergence.mesh_convergence,
        "step_convergence": convergence.step_convergence,
        "mode_count_convergence": convergence.mode_count_convergence,
    }


def pages() -> dict[str, Callable[[], str]]:
    """Return every included text by the name of its file."""
    return {
        "spots_table": tables.spots_table,
        "along_table": tables.along_table,
        "paper_table": tables.paper_table,
        "bats_table": tables.bats_table,
        "parks_table": tables.parks_table,
        "optimum_table": tables.optimum_table,
        "launch_table": tables.launch_table,
        "home_runs_table": tables.home_runs_table,
        "pitches_table": tables.pitches_table,
        "catalogue": tables.catalogue_page,
        "choices": choices.choices_page,
        "sources": tables.sources_page,
        "licences": licences.licences_table,
        "bundled": licences.bundled_table,
        "schemas": schemas_table,
        "validation": tables.validation_page,
        "validation_summary": tables.validation_summary,
        "validation_subjects": tables.subjects_table,
        "error_from": tables.error_from_table,
        "evidence_summary": evidence.evidence_summary,
        "evidence": evidence.evidence_table,
        "unnoticed": evidence.unnoticed_table,
        **sport_tables.pages(),
    }


def schemas_table() -> str:
    """Write the schema of every answer for `html_extra_path` and return a table of them."""
    folder = HERE / "_generated" / "extra" / "schema"
    folder.mkdir(parents=True, exist_ok=True)
    rows = []
    for question, name in answer_names().items():
        content = json.dumps(answer_schema(answer_type(question)), indent=1).encode()
        write_if_changed(folder / f"{question}.json", content)
        rows.append((f"`{question}`", f"`{name}`", f'<a href="schema/{question}.json">{question}.json</a>'))
    return tables.table(("Answer", "Python", "Schema"), rows)


def generate_all(folder: Path) -> dict[str, str]:
    """Write every figure and table into ``folder`` and return the numbers that the text quotes."""
    folder.mkdir(exist_ok=True)
    for name, text in pages().items():
        write_if_changed(folder / f"{name}.md", text().encode())
    for name, draw in figures().items():
        path = folder / f"{name}.svg"
        with rc_context(SVG):
            draw().savefig(path, metadata={"Date": None})
    for name, text in modules.reference_pages().items():
        write_if_changed(folder.parent / "reference" / f"{name}.rst", text.encode())
    return facts()


def write_if_changed(path: Path, content: bytes) -> None:
    """Write a file only when its content differs, so that pages are not read again for nothing."""
    if not path.exists() or path.read_bytes() != content:
        path.write_bytes(content)


if __name__ == "__main__":
    start = time.perf_counter()
    for name, value in generate_all(HERE / "_generated").items():
        print(f"{name:24} {value}")
    print(f"written in {time.perf_counter() - start:.1f} s")

"""The printed report: one self-contained page with its pictures, and the same as files for other uses."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from pathlib import Path

from sweetspot import __version__
from sweetspot.analysis.bat_analysis import Analysis, exit_speed_of
from sweetspot.equipment.implement import Implement
from sweetspot.errors import InputError
from sweetspot.report.bat.words import answer, from_tip
from sweetspot.report.json_shapes import report_json
from sweetspot.units import INCH, MPH, OUNCE

NAMES = ("report.html", "report.png", "report.svg", "report.json")


def write_report(analysis: Analysis[Implement], folder: Path) -> list[Path]:
    """Write report.html, report.png, report.svg and report.json into a folder, all of them or none.

    The page needs nothing else: pictures and style are inside it. A folder that does not exist is made.

    Raises
    ------
    InputError
        when the folder cannot be written; it is then as it was.
    """
    from sweetspot.report.bat.figure import report_figure
    from sweetspot.report.file_set import write_folder
    from sweetspot.report.hit.picture import hit_figure
    from sweetspot.report.pictures.files import png_bytes, svg_bytes

    check_folder(folder)
    overview = report_figure(analysis)
    drawing = svg_bytes(overview)
    contents = {
        "report.html": page(analysis, overview=drawing, hit=svg_bytes(hit_figure(analysis.best))).encode(),
        "report.png": png_bytes(overview),
        "report.svg": drawing,
        "report.json": (json.dumps(report_json(analysis), indent=1, allow_nan=False) + "\n").encode(),
    }
    return write_folder(folder, {name: contents[name] for name in NAMES})


def check_folder(folder: Path, names: Sequence[str] = NAMES) -> None:
    """Refuse a folder that a report of files with these names could not be written to, without touching anything.

    Raises
    ------
    InputError
        when it is a file, lies below one, cannot be written, or has a folder where a report's file would go.
    """
    existing = next(path for path in (folder, *folder.absolute().parents) if os.path.lexists(path))
    if not existing.is_dir():
        raise InputError(f"{folder} cannot be a report's folder: {existing} is not a folder; choose another place")
    if not os.access(existing, os.W_OK | os.X_OK):
        raise InputError(f"{folder} cannot be written: no permission to write in {existing}; choose another folder")
    for name in names:
        if (folder / name).is_dir():
            raise InputError(f"{folder / name} is a folder where a file of the report would go; choose another folder")


def page(analysis: Analysis[Implement], *, overview: bytes, hit: bytes) -> str:
    """Return the whole page as HTML.

    Parameters
    ----------
    overview, hit : the two pictures as SVG files.
    """
    from sweetspot.report.bat import sections
    from sweetspot.report.bat.beside_published import published
    from sweetspot.report.markup import paragraphs, picture, text
    from sweetspot.report.sports.html import sport_page
    from sweetspot.report.sports.vocabulary import speaks_otherwise

    bat, body = analysis.bat, analysis.body
    if speaks_otherwise(bat):
        return sport_page(analysis, overview=overview, hit=hit)
    sizes = (
        f"{bat.length / INCH:.2f} in long, {body.mass / OUNCE:.1f} oz, {bat.made_of}, "
        f"balance {body.balance_point / INCH:.1f} in from the knob"
    )
    hit_caption = (
        "Left: the force between ball and bat. Right: the same force against the ball's compression; the area inside "
        "the loop is heat. Below: the energy as a laboratory counts it that fires the ball at a bat at rest, where "
        "a ball that flies back slowly has little energy left."
    )
    parts = [
        f"<header>\n<p>Sweet spot report</p>\n<h1>{text(bat.name)}</h1>\n<p>{text(sizes)}</p>\n</header>",
        sections.key_numbers(analysis),
        f'<div class="answer">\n{paragraphs(answer(analysis))}\n</div>',
        picture(overview, name="overview", label=_overview_label(analysis), caption=(
            "The bat to scale and, place for place, what a hit there does. Shaded: the sweet zone.")),
        sections.sweet_spots(analysis),
        sections.misses(analysis),
        sections.mass_properties(analysis),
        sections.modes(analysis),
        sections.best_hit(analysis, picture(hit, name="hit", label=_hit_label(analysis), caption=hit_caption)),
        sections.conditions(analysis),
        sections.assumptions(analysis),
        published(),
        sections.provenance(analysis),
        sections.sources(analysis),
        f"<footer>sweetspot {text(__version__)}. Lengths along the bat are measured on its axis.</footer>",
    ]  # fmt: skip
    style = Path(__file__).parents[1].joinpath("page.css").read_text(encoding="utf-8")
    content = "\n".join(parts)
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{text(bat.name)}: sweet spot report</title>\n<style>\n{style}</style>\n</head>\n<body>\n<main>\n"
        f"{content}\n</main>\n</body>\n</html>\n"
    )


def _overview_label(analysis: Analysis[Implement]) -> str:
    best = from_tip(analysis, analysis.sweet_spots.max_exit_speed)
    speed = exit_speed_of(analysis.best, analysis.conditions) / MPH
    return (
        f"{analysis.bat.name} drawn to scale, its sweet spots marked. Below it curves of exit speed, collision "
        f"efficiency, jolt at the top hand, sting and bending modes along the bat. Exit speed is greatest, {speed:.1f} "
        f"mph, {best:.1f} inches from the tip."
    )


def _hit_label(analysis: Analysis[Implement]) -> str:
    impact = analysis.best
    heat = 100 * impact.energy.heat / impact.energy.incoming
    return (
        f"Force of the best hit: it rises to {impact.peak_force / 1e3:.1f} kilonewtons and lasts "
        f"{1e3 * impact.contact_time:.2f} milliseconds. Of the energy, {heat:.0f} per cent become heat in the ball."
    )

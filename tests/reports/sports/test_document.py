"""Printed reports, pictures and comparisons of other sports."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree as Tree

import pytest

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.equipment.implement import Implement
from sweetspot.reports.bat.document import report_document
from sweetspot.reports.bat.figure import report_figure
from sweetspot.reports.files import write_document
from sweetspot.reports.html import page
from sweetspot.reports.pictures.style import svg_bytes
from tests.reports.told import reported

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture(scope="module")
def racket() -> Analysis[Implement]:
    found: Implement = catalog.implement("tennis-racket")
    return analyse(found, standard_conditions(found))


def test_the_page_speaks_the_sports_language(racket: Analysis[Implement], tmp_path: Path) -> None:
    document = report_document(reported(racket))
    written = write_document(document, tmp_path, reader=document.reader)
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert [path.name for path in written] == ["report.html", "report.json", "report.png", "report.svg"]
    visible = re.sub(r"<style>.*?</style>|<svg.*?</svg>|<[^>]+>", " ", text, flags=re.DOTALL)
    visible = visible[: visible.index("Beside published values")]
    assert "This racket hits best" in visible and "All over the face" in visible and "power zone" in visible
    assert "320 kg cm²" in visible and "m/s" in visible
    assert " mph" not in visible and " bat " not in visible and "from the knob" not in visible


def test_the_pictures_axis_counts_in_centimetres(racket: Analysis[Implement]) -> None:
    figure = report_figure(reported(racket))
    words = {text.get_text() for axes in figure.axes for text in axes.texts} | {
        axes.get_xlabel() for axes in figure.axes
    }
    assert "centimetres from the tip" in words and "inches from the tip" not in words
    Tree.fromstring(svg_bytes(figure))  # well formed


@pytest.mark.parametrize("name", ["golf-driver", "table-tennis-racket", "cricket-bat", "hockey-stick"])
def test_every_sport_has_a_page(name: str) -> None:
    found: Implement = catalog.implement(name)
    document = report_document(reported(analyse(found, standard_conditions(found))))
    text = page(document, document.reader)
    assert "nan" not in re.sub(r"<[^>]+>", " ", text).split()
    assert ("smash factor" in text) == (name == "golf-driver")
    assert ("inverted rubber on sponge" in text) == (name == "table-tennis-racket")


def test_json_has_the_map_and_the_swing_weight(run: Run) -> None:
    code, out, _ = run("report", "golf-driver", "--format", "json")
    found = json.loads(out)
    assert code == 0 and found["sport"] == "golf" and found["swing_weight"]["text"].startswith("D")
    assert len(found["face_map"]["exit_speed_m_s"]) == len(found["face_map"]["lateral_m"])
    assert found["face_map"]["exit_speed_m_s"][0][0] is None  # off the oval
    assert {mode["family"] for mode in found["modes"]} == {"bending", "face"}


def test_a_hit_beside_the_line(run: Run) -> None:
    at = ("--at", "16cm-from-tip", "--format", "json")
    middle, beside = (json.loads(run("hit", "tennis-racket", *at, "--beside", place)[1]) for place in ("0cm", "6cm"))
    assert beside["lateral_m"] == pytest.approx(0.06)
    assert beside["exit_speed_m_s"] < middle["exit_speed_m_s"] - 2


def test_rackets_are_compared_in_their_own_units(run: Run, tmp_path: Path) -> None:
    code, out, _ = run("compare", "tennis-racket", "tennis-racket", "--same-speed", "--out", str(tmp_path))
    assert code == 0 and "racket speed m/s" in out and "320 kg cm^2" in out and "mph" not in out
    assert (tmp_path / "compare.png").stat().st_size > 10_000

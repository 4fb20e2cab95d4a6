"""± means half of a 90 % interval wherever an answer prints it, or the same line names what else it is."""

from __future__ import annotations

import ast
import re
import shlex
from pathlib import Path

import pytest

import sweetspot
from sweetspot.answers.materials import material_answer
from sweetspot.calibration.measured import Measured
from sweetspot.catalog.materials import material_spreads
from sweetspot.cli import main
from sweetspot.numerics.interval import REACH, interval_of
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import Doubtful, Sentence, measured_words
from tests.documented import TUTORIALS

PACKAGE = Path(sweetspot.__file__).parent
SAID = re.compile(r"90 % interval|give or take")
OTHERWISE = re.compile(r"[Tt]olerance|standard deviation|write|Write|intervals|half of its 90 %")
"""Words of a text that prints ± by itself: another meaning, or the usual one, or how a user writes it."""
MADE = {
    "reports/sentences.py": (2, "the one place that makes it of an interval"),
    "reports/calibration/document.py": (2, "in the tables of `calibrate`, whose note says what it is"),
    "reports/materials.py": (1, "strength, of the interval in the answer"),
    "reports/calibration/ranking_report.py": (1, "head of a column, whose note says what it is"),
    "reports/terminal.py": (1, "where lines may break"),
    "reports/plain_signs.py": (1, "how it is spelled without Unicode"),
    "reports/drawings/lathe.py": (1, "the same"),
    "reports/bat/along_picture.py": (2, "where lines may break"),
}
"""Files that print ± without saying in the same text what it is, how often, and why they may."""


def texts(path: Path) -> list[str]:
    """Return the strings of a program but for its docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    told = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    inside = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    found = [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and not {id(node)} & (told | inside)
    ]
    whole = [ast.unparse(node) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr)]
    return found + whole


def test_every_text_that_prints_it_says_what_it_is_or_is_known() -> None:
    bare = {}
    for path in sorted((PACKAGE / "reports").rglob("*.py")):
        count = sum("±" in text and not OTHERWISE.search(text) for text in texts(path))
        if count:
            bare[path.relative_to(PACKAGE).as_posix()] = count
    assert bare == {name: count for name, (count, _) in MADE.items()}, (
        "say in that text what ± is there, or print an interval"
    )


def test_it_is_made_of_the_whole_interval() -> None:
    assert Sentence((Doubtful(100.0, REACH * 2, "frequency", False),)).read(US) == "100.0 ± 3.3 Hz"
    assert measured_words(Measured(100.0, 2.0), "frequency").read(US) == "100.0 ± 3.3 Hz"


def test_a_spread_of_the_catalogue_is_one_standard_deviation() -> None:
    """The card of a material shows the interval that calibrations begin with."""
    shown = {each.quantity: interval_of(each.value) for each in material_answer("white ash").values}
    spreads = material_spreads("white ash")
    assert {"density", "longitudinal_modulus"} <= set(spreads)
    for quantity, spread in spreads.items():
        assert shown[quantity].high - shown[quantity].value == pytest.approx(REACH * spread * shown[quantity].value)


@pytest.mark.parametrize(
    "line",
    [
        "materials white-ash",
        "bats",
        "pendulum --mass 31.0oz±0.1oz --balance-point 22.05in±0.05in --period 1.4545s±0.003s --uncertainty",
        "calibrate-ball tennis --drop 254cm:135cm±1cm --temperature 10degC",
        "calibrate r161-ash --mass 31.00oz±0.05oz --tone bending-1:171.8Hz±0.5Hz",
        "certify college-alloy",
        "report r161-ash",
        f"rank {TUTORIALS / 'coach' / 'dozen.csv'} --like r161-ash",
    ],
)
def test_an_answer_with_it_says_what_it_is(line: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(shlex.split(line))
    text = " ".join(capsys.readouterr().out.split())
    assert "±" in text and SAID.search(text)

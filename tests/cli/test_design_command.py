"""`sweetspot design` as people call it."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot.catalog import load_implement
from sweetspot.catalog.files.read import read_bat
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body

Run = Callable[..., tuple[int, str, str]]
RunJson = Callable[..., Any]
QUICK = ("--population", "8", "--generations", "1", "--want", "exit-speed")


def test_a_design_with_its_files(run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = tmp_path / "design"
    code, text, _ = run("design", "mlb-a", "--contact", "8in", "--contact-spread", "1.2in", *QUICK, "--out", str(out))
    assert code == 0
    assert text.index("best place moves") < text.index("zone within") < text.index("greatest exit speed")
    assert "should not use it" in text
    assert {path.name for path in out.iterdir()} == {
        "design.html", "design.json", "design.png", "design.svg", "search.json", "designed-bat.toml",
        "designed-bat.svg", "designed-bat.dxf", "designed-bat.csv", "designed-bat.lathe.csv", "designed-bat.pdf",
        "designed-bat.stl", "designed-bat.step",
    }  # fmt: skip
    answer = json.loads((out / "design.json").read_text(encoding="utf-8"))
    bat = read_bat(out / "designed-bat.toml")
    assert bat.mass == pytest.approx(answer["measures"]["mass_kg"], rel=1e-9)
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 3)  # it goes on from what was found
    code, again, _ = run(
        "design", "mlb-a", "--contact", "8in", "--contact-spread", "1.2in", *QUICK, "--format", "csv", "--resume",
        str(out / "search.json"),
    )  # fmt: skip
    rows = list(csv.DictReader(io.StringIO(again)))
    assert code == 0 and float(rows[0]["exit_speed_m_s"]) > answer["present_measures"]["exit_speed_m_s"]


@pytest.fixture
def short_polish(monkeypatch: pytest.MonkeyPatch) -> None:
    """A search that begins with a start hardly polished: every hollow bat costs a tenth of a second."""
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 2)
    monkeypatch.setattr("sweetspot.designs.local_search.WAYS", 1)
    monkeypatch.setattr("sweetspot.designs.local_search.POINTS", 5)


@pytest.mark.usefixtures("short_polish")
def test_the_best_of_several_woods_and_lengths(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "woods"
    code, text, _ = run(
        "design", "mlb-a", "--wood", "maple", "--wood", "ash", "--length", "33.5in:34.5in", "--keep", "moi", *QUICK,
        "--out", str(out),
    )  # fmt: skip
    answer = json.loads((out / "design.json").read_text(encoding="utf-8"))
    assert code == 0 and {one["name"] for one in answer["materials"]} == {"sugar maple", "white ash"}
    best = max(answer["materials"], key=lambda one: one["exit_speed_m_s"])
    assert read_bat(out / "designed-bat.toml").material.name == best["name"]
    assert 33.5 * 0.0254 <= answer["variables"]["length"]["value"] <= 34.5 * 0.0254
    assert "Materials: the best of each front" in text


@pytest.mark.usefixtures("short_polish")
def test_a_hollow_bat_by_the_same_command(run_json: RunJson) -> None:
    answer = run_json("design", "single-wall", "--league", "none", *QUICK)
    assert 0.5 < answer["measures"]["bbcor"] < 0.6
    assert {"wall_1", "end_cap_mass"} <= answer["variables"].keys()


@pytest.mark.usefixtures("short_polish")
@pytest.mark.parametrize(
    ("league", "bounded", "undecided"),
    [("asa", False, True), ("none", False, False), ("softball", True, False)],
    ids=["asa", "none", "softball"],
)
def test_a_wall_that_no_rule_bounds_is_said_first(
    league: str, bounded: bool, undecided: bool, run_json: RunJson
) -> None:
    """98 mph is not decidable, so nothing keeps a wall from growing hotter; what to change is said in any case."""
    moi = ("--keep", "mass", "--moi", "8000oz*in^2:10500oz*in^2")
    words = run_json("design", "slow-pitch", *moi, "--league", league, *QUICK)["words"]
    assert words[0].startswith("No rule of performance bounds this wall") is not bounded
    assert any(one.startswith("What to change: wall 11.0 in from the tip from") for one in words)
    assert ("batted-ball speed is not decidable" in words[0]) is undecided


@pytest.mark.usefixtures("short_polish")
def test_a_league_with_bpf_decides_it_by_the_simulated_test(run_json: RunJson) -> None:
    answer = run_json("design", "slow-pitch", "--league", "softball", *QUICK)
    assert [(one["quantity"], one["verdict"]) for one in answer["rules"]] == [("bpf", "pass"), ("unaltered", "pass")]
    assert {"measure": "bpf", "least": None, "most": 1.2, "why": "softball, BPF rule"} in answer["limits"]
    assert answer["measures"]["bpf"] <= 1.2


@pytest.mark.usefixtures("short_polish")
@pytest.mark.parametrize("name", ["cricket-bat", "tennis-racket", "golf-driver"])
def test_other_sports_by_the_same_command(run: Run, tmp_path: Path, name: str) -> None:
    out = tmp_path / name
    code, text, _ = run("design", name, *QUICK, "--out", str(out))
    assert code == 0
    answer = json.loads((out / "design.json").read_text(encoding="utf-8"))
    made = load_implement(str(out / "designed-bat.toml"))
    assert rigid_body(beam_model(made)).mass == pytest.approx(answer["measures"]["mass_kg"], rel=1e-9)
    assert "Two of one model differ by" in text and "turned" not in text
    assert ("width of the blade" in text) == (name == "cricket-bat")


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (
            ("--mass", "26oz:27oz", "--moi", "12000oz*in^2:", "--keep", "nothing", "--league", "none"),
            "exclude each other: mass from 26.00 oz",
        ),
        (("single-wall", *QUICK), "the nearest has greatest BBCOR, in the test"),
    ],
)
@pytest.mark.usefixtures("short_polish")
def test_bad_questions_are_one_line(run: Run, arguments: tuple[str, ...], fault: str) -> None:
    code, _, said = run("design", *arguments)
    assert code == 2
    assert fault in said and said.count("\n") == 1

"""The command `optimum`: three questions, three formats, and clear refusals."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.analysis.optimum import best_launch
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.units import FOOT, MPH, RPM

Run = Callable[..., tuple[int, str, str]]


def test_all_three_questions(run_json: Callable[..., Any]) -> None:
    found = run_json("optimum", "--park", "fenway", "--exit-speed", "100mph")
    assert [row["pitch"] for row in found["swings"]] == ["four-seam fastball", "curve ball"]
    fast, slow = found["swings"]
    assert fast["pitch_speed_m_s"] > slow["pitch_speed_m_s"] and fast["carry_m"] > slow["carry_m"] > 380 * FOOT
    assert [row["launch_angle_rad"] for row in found["launches"]] == pytest.approx([0.524], abs=0.01)
    assert found["parks"][0]["park"] == "Fenway Park"
    assert 75 * MPH < found["parks"][0]["exit_speed_m_s"] < 85 * MPH


def test_csv_answers_one_question(run: Run) -> None:
    code, out, _ = run("optimum", "--show", "parks", "--park", "all", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert code == 0 and len(rows) == 30
    speeds = [float(row["exit_speed_m_s"]) for row in rows]
    assert rows[0]["park"] == "Fenway Park" and speeds == sorted(speeds)
    code, out, _ = run("optimum", "--pitch", "CH", "--format", "csv")
    assert code == 0 and [row["pitch"] for row in csv.DictReader(io.StringIO(out))] == ["changeup"]


def test_given_angle_place_and_speed_are_kept(run_json: Callable[..., Any]) -> None:
    arguments = ("--show", "swing", "--pitch", "FF", "--attack-angle", "9deg", "--at", "5in-from-tip")
    found = run_json("optimum", *arguments, "--release-speed", "80mph")["swings"]
    assert found[0]["attack_angle_rad"] == pytest.approx(0.15708, abs=1e-5)
    assert found[0]["position_m"] == pytest.approx(28 * 0.0254)
    assert found[0]["release_speed_m_s"] == pytest.approx(80 * MPH)


def test_tables_for_people(run: Run) -> None:
    code, out, _ = run("optimum", "--park", "coors", "--pitch", "slider")
    assert code == 0 and "slider" in out and "Coors Field" in out and "Launch angle" in out


def test_files_and_units(run: Run, tmp_path: Path) -> None:
    code, out, _ = run("optimum", "--show", "launch", "--units", "si", "--out", str(tmp_path))
    words = " ".join(out.split())
    assert code == 0 and "exit speed m/s" in words and "carry m" in words
    assert {path.name for path in tmp_path.iterdir()} == {f"optimum.{end}" for end in ("html", "json", "png", "svg")}


def test_the_ball_that_was_asked_for_is_flown(run_json: Callable[..., Any]) -> None:
    arguments = ("--show", "launch", "--exit-speed", "90mph", "--ball", "softball-12in")
    best = best_launch(
        90 * MPH,
        FlightConditions(ball=catalog.ball("softball-12in"), aerodynamics=catalog.aerodynamics("softball"), air=Air()),
        backspin=2200 * RPM,
    )
    assert run_json("optimum", *arguments)["launches"][0]["carry_m"] == pytest.approx(best.carry, rel=1e-3)

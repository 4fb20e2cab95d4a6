"""The command line as a user meets it: answers, formats, exit codes, messages."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import pytest

import sweetspot

Run = Callable[..., tuple[int, str, str]]
RunJson = Callable[..., Any]

GOOD_BAT = """
name = "my ash bat"
length = "33 1/2 in"
mass = "28 oz"
material = "white ash"
profile = [
  ["0 in", "2.0 in"], ["1.0 in", "1.05 in"], ["12 in", "1.0 in"], ["24 in", "2.4 in"], ["2 ft 9.5 in", "1.6 in"],
]

[[bore]]
diameter = "1 in"
depth = "8 in"
fill = "cork"
plug = "1 in"

[cup]
diameter = "1.4 in"
depth = "0.9 in"
"""


def test_report_says_where_and_why(run: Run) -> None:
    code, out, _ = run("report", "r161-ash")
    assert code == 0
    words = " ".join(out.split())
    assert "This bat hits best" in words and "Why not at the tip?" in words and "What a miss costs" in words


def test_report_json_keeps_the_border_contract(run_json: RunJson) -> None:
    result = run_json("report", "r161-ash")
    assert {
        "name", "length_m", "mass_kg", "balance_point_m", "moi_cm_kg_m2", "moi_knob_kg_m2", "moi_6in_kg_m2",
    } <= set(result["bat"])  # fmt: skip
    assert {"family", "harmonic", "frequency_hz", "damping_ratio", "nodes_m"} == set(result["modes"][0])
    assert result["modes"][0]["family"] == "bending" and len(result["modes"]) >= 12
    assert {
        "center_of_percussion_m", "node_1_m", "node_2_m", "max_collision_efficiency_m", "max_exit_speed_m",
        "min_sting_m", "zone_m",
    } == set(result["sweet_spots"])  # fmt: skip
    assert {
        "position_m", "collision_efficiency", "bbcor", "bat_speed_m_s", "exit_speed_m_s", "hand_impulse_n_s", "sting",
    } <= set(result["scan"])  # fmt: skip
    lengths = {len(column) for column in result["scan"].values()}
    assert len(lengths) == 1 and lengths.pop() > 50
    assert result["conditions"]["pitch_speed_m_s"] == pytest.approx(40.2336)


def test_hit_json(run_json: RunJson) -> None:
    result = run_json("hit", "r161-ash", "--at", "6in-from-tip")
    assert {
        "position_m", "collision_efficiency", "exit_speed_m_s", "bbcor", "contact_time_s", "peak_force_n",
        "peak_compression_m", "energy_j", "outcome",
    } <= set(result)  # fmt: skip
    assert result["outcome"] == "separated" and result["position_m"] == pytest.approx(0.6858)
    parts = sum(value for name, value in result["energy_j"].items() if name != "incoming")
    assert parts == pytest.approx(result["energy_j"]["incoming"], rel=1e-4)
    same = run_json("hit", "r161-ash", "--at", "27in")
    assert same["exit_speed_m_s"] == pytest.approx(result["exit_speed_m_s"])


def test_paper_json(run_json: RunJson) -> None:
    rows = run_json("paper")["rows"]
    assert all({"equation", "quantity", "paper", "computed", "full_model", "comment"} <= set(row) for row in rows)
    assert pytest.approx(0.26325) in [row["computed"] for row in rows if row["equation"] == "W"]


def test_paper_takes_other_numbers(run_json: RunJson) -> None:
    rows = run_json("paper", "--metal-share", "20%", "--entry-angle", "30deg")["rows"]
    returned = next(row["computed"] for row in rows if row["quantity"].startswith("W2"))
    assert returned == pytest.approx(0.9**2 * 0.2 + 0.45**2 * 0.8)  # the paper's formula
    assert any("alpha = 30°" in row["quantity"] for row in rows)


@pytest.mark.parametrize("command", [["report", "youth-30"], ["hit", "youth-30", "--at", "25in"], ["paper"], ["bats"]])
def test_csv_is_a_table(run: Run, command: list[str]) -> None:
    code, out, err = run(*command, "--format", "csv")
    rows = list(csv.reader(io.StringIO(out)))
    assert code == 0, err
    assert len(rows) > 5 and {len(row) for row in rows} == {len(rows[0])}


def test_options_mean_what_they_say(run_json: RunJson) -> None:
    hit = ("hit", "r161-ash", "--at", "27in")
    plain = run_json(*hit)
    assert run_json(*hit, "--pitch-speed", "40.2336m/s")["exit_speed_m_s"] == pytest.approx(plain["exit_speed_m_s"])
    assert run_json(*hit, "--pitch-speed", "tee")["closing_speed_m_s"] == pytest.approx(31.2928)
    assert run_json(*hit, "--bat-speed-at", "33in")["bat_speed_m_s"] < 31.29
    assert run_json(*hit, "--pivot=-2in")["bat_speed_m_s"] == pytest.approx(31.2928)
    assert run_json(*hit, "--ball-humidity", "70%")["exit_speed_m_s"] < plain["exit_speed_m_s"]
    assert run_json(*hit, "--ball", "baseball-lively")["exit_speed_m_s"] > plain["exit_speed_m_s"]
    choked = run_json("report", "r161-ash", "--hands", "8in")
    assert (
        choked["sweet_spots"]["center_of_percussion_m"]
        > run_json("report", "r161-ash")["sweet_spots"]["center_of_percussion_m"]
    )


def test_own_bat_file(run_json: RunJson, tmp_path: Path) -> None:
    (tmp_path / "bat.toml").write_text(GOOD_BAT)
    bat = run_json("report", str(tmp_path / "bat.toml"))["bat"]
    assert bat["length_m"] == pytest.approx(0.8509) and bat["mass_kg"] == pytest.approx(28 * 0.028349523125)


def test_schema_describes_a_bat_file(run: Run) -> None:
    import tomllib

    code, out, _ = run("schema")
    schema = json.loads(out)
    assert code == 0
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(tomllib.loads(GOOD_BAT), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**tomllib.loads(GOOD_BAT), "colour": "red"}, schema)


def test_pendulum_both_ways(run_json: RunJson) -> None:
    bat = ("pendulum", "--mass", "31oz", "--balance-point", "22.4in")
    there = run_json(*bat, "--period", "1.4s")
    back = run_json(*bat, "--moi", f"{there['moi_kg_m2']}kg*m^2")
    assert back["period_s"] == pytest.approx(1.4)


def test_a_heavy_ball_on_a_light_bat(run: Run, tmp_path: Path) -> None:
    light = """
name = "twig"
length = "14 in"
sport = "softball"
material = "white ash"
profile = [["0 in", "1.15 in"], ["14 in", "1.15 in"]]
"""
    (tmp_path / "twig.toml").write_text(light)
    twig = str(tmp_path / "twig.toml")
    code, _, err = run("report", twig)
    assert code == 2 and "(1.15 in); usual is 1.6 to 5 in" in err and "add --force if it is intended" in err
    code, _, err = run("hit", twig, "--at", "3in-from-tip", "--force")
    assert code == 2 and "a ball lighter than the bat" in err
    code, out, _ = run("report", twig, "--force")
    assert code == 0 and "No hit is computed" in out and "bending 5" in out
    code, out, _ = run("report", twig, "--force", "--format", "json")
    found = json.loads(out)
    assert code == 0 and "scan" not in found
    # exact: a uniform free rod's first node lies at 0.2242 of its length from its end (slender; shear moves it little)
    assert (0.3556 - found["sweet_spots"]["node_1_m"]) / 0.3556 == pytest.approx(0.2242, abs=2e-3)


def test_output_folder_that_cannot_be_written(run: Run, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("in the way")
    code, out, err = run("report", "r161-ash", "--out", str(tmp_path / "file" / "deeper"))
    assert code == 2 and out == "" and "Traceback" not in err
    assert (tmp_path / "file").read_text() == "in the way" and list(tmp_path.iterdir()) == [tmp_path / "file"]


def command(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "sweetspot", *arguments], capture_output=True, text=True, check=False)


def test_as_a_program() -> None:
    helped = command("--help")
    assert helped.returncode == 0 and "report" in helped.stdout
    assert helped.stderr.splitlines() == []
    assert command("--version").stdout.split()[0] == sweetspot.__version__
    wrong = command("report", "nope")
    assert wrong.returncode == 2 and "Traceback" not in wrong.stderr and wrong.stdout == ""


def test_start_up_stays_light() -> None:
    """Heavy libraries load only when a command needs them."""
    assert not {"numpy", "scipy", "numba", "skfem", "matplotlib", "pint"} & loaded(
        "sweetspot, sweetspot.cli.app; sweetspot.cli.app.load_all()"
    )
    assert not {"matplotlib", "rich"} & loaded("sweetspot.reports.html, sweetspot.reports.document")
    loading_a_bat = loaded("sweetspot; sweetspot.catalog.load_implement('r161-ash'); sweetspot.catalog.aerodynamics()")
    assert not {"pint", "matplotlib", "rich", "scipy.linalg", "scipy.special", "scipy.sparse"} & loading_a_bat


def loaded(what: str) -> set[str]:
    """Return the modules that an interpreter holds after an import."""
    code = f"import sys, {what}; print(*sys.modules)"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(result.stdout.split())

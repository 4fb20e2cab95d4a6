"""`sweetspot rank`: a table of bats becomes an order, with how sure it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., tuple[int, str, str]]
HEAD = "name,mass_oz,balance_point_in,pendulum_s,bending_1_hz,moisture_percent\n"
ONE, OTHER = (
    "A,31.00±0.05,22.05±0.05,1.4545±0.003,171.5±0.4,12\n",
    "B,31.00±0.05,22.05±0.05,1.4545±0.003,155.0±0.4,12\n",
)


def test_two_bats(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    table = tmp_path / "bats.csv"
    table.write_text(HEAD + ONE + OTHER, encoding="utf-8")
    found = run_json("rank", str(table), "--like", "r161-ash")
    assert [one["name"] for one in found["bats"]] == ["A", "B"]
    assert found["bats"][0]["best_chance"] > 0.7
    assert "modulus" in found["bats"][1]["differs"]
    for name, rows in (("a", ONE), ("b", OTHER)):
        (tmp_path / "folder").mkdir(exist_ok=True)
        (tmp_path / "folder" / f"{name}.csv").write_text(HEAD + rows, encoding="utf-8")
    code, out, _ = run("rank", str(tmp_path / "folder"), "--like", "r161-ash", "--same-speed", "--units", "si")
    assert code == 0
    assert "A comes first" in out
    assert "m/s" in out


def test_a_folder_of_bats_that_were_calibrated_one_by_one(
    run: Run, run_json: Callable[..., Any], tmp_path: Path
) -> None:
    """They are ranked as a table of the same measurements ranks them; what cannot be is named, file by file."""
    folder = tmp_path / "bats"
    folder.mkdir()
    for name, tone in (("A", "171.5"), ("B", "155.0")):
        given = ("--mass", "31.00oz±0.05oz", "--balance-point", "22.05in±0.05in", "--pendulum", "1.4545s±0.003s")
        tones = ("--tone", f"bending-1:{tone}Hz±0.4Hz")
        assert run("calibrate", "r161-ash", *given, *tones, "--out", str(folder / f"{name}.toml"))[0] == 0
    table = tmp_path / "bats.csv"
    table.write_text(HEAD + ONE.replace(",12\n", ",\n") + OTHER.replace(",12\n", ",\n"), encoding="utf-8")
    by_file, by_row = (run_json("rank", str(one), "--like", "r161-ash") for one in (folder, table))
    assert [one["name"] for one in by_file["bats"]] == ["A", "B"]
    for mine, theirs in zip(by_file["bats"], by_row["bats"], strict=True):
        assert mine["exit_speed_m_s"] == pytest.approx(theirs["exit_speed_m_s"], abs=1e-6)
        assert mine["best_chance"] == theirs["best_chance"]
    (folder / "C.toml").write_text(run("show", "r161-ash")[1], encoding="utf-8")
    (folder / "d.csv").write_text("a,b\n1,2\n", encoding="utf-8")
    code, out, err = run("rank", str(folder), "--like", "r161-ash")
    assert (code, out) == (2, "")
    assert "C.toml does not hold what was measured" in err and "d.csv has no line of headings" in err
    for other in ("C.toml", "d.csv"):
        (folder / other).unlink()
    assert "a ranking is of bats of one model" in run("rank", str(folder), "--like", "mlb-a")[2]
    (folder / "e.csv").write_text("name,mass_oz\nA,31\n", encoding="utf-8")
    assert "two bats of the name 'A'" in run("rank", str(folder), "--like", "r161-ash")[2]


def test_a_column_that_is_not_understood_is_told(run: Run, tmp_path: Path) -> None:
    """Under another heading a weight would be left out in silence, and the bats would seem alike."""
    table = tmp_path / "bats.csv"
    table.write_text("name,heft,balance_point_in\nA,31,22.05±0.05\nB,29,22.00±0.05\n", encoding="utf-8")
    code, _, err = run("rank", str(table), "--like", "r161-ash")
    assert code == 0
    assert "not understood and not used: heft; columns may be name, mass_oz" in err


def test_one_thing_in_two_units_is_refused(run: Run, tmp_path: Path) -> None:
    table = tmp_path / "bats.csv"
    table.write_text("name,mass_oz,mass_g,balance_point_in\nA,31,879,22.05\nB,31,890,22.00\n", encoding="utf-8")
    code, out, err = run("rank", str(table), "--like", "r161-ash")
    assert (code, out) == (2, "")
    assert "columns mass_oz and mass_g both give mass; keep one of them" in err


def test_intervals_need_no_option(run: Run, tmp_path: Path) -> None:
    """What always has its intervals may be asked for them; what quotes numbers has none."""
    table = tmp_path / "bats.csv"
    table.write_text(HEAD + "A,31.0,22.05,1.454,160,\nB,31.4,22.1,1.456,165,\n", encoding="utf-8")
    unasked = run("rank", str(table), "--like", "r161-ash")
    assert run("rank", str(table), "--like", "r161-ash", "--uncertainty")[:2] == unasked[:2]
    assert unasked[0] == 0
    code, _, err = run("parks", "--uncertainty")
    assert code == 2 and err.startswith("sweetspot: parks has no --uncertainty: it tells nothing that is computed")


def test_a_bat_whose_measurements_contradict_each_other_is_not_ranked(
    run: Run, run_json: Callable[..., Any], tmp_path: Path
) -> None:
    """A swing of 1.30 s is not that of a bat of this weight and balance; the order of the others is told without it."""
    table = tmp_path / "bats.csv"
    swung = OTHER.replace("B", "C").replace("1.4545", "1.3000")
    table.write_text(HEAD + ONE + OTHER + swung, encoding="utf-8")
    _, out, _ = run("rank", str(table), "--like", "r161-ash")
    words = " ".join(out.split())
    warning = words.index("C: pendulum lies ")
    assert warning < words.index("It is not ranked") < words.index("A comes first") < words.index("best of 2; B comes")
    assert "A: " not in words
    assert "A value without ± counts to its last digit" in words
    three = run_json("rank", str(table), "--like", "r161-ash")
    pulls = {one["name"]: one["contradictions"] for one in three["bats"]}
    assert (pulls["A"], pulls["B"]) == ({}, {})
    assert max(abs(pull) for pull in pulls["C"].values()) > 3
    assert [one["best_chance"] is None for one in three["bats"]] == [False, False, True]
    table.write_text(HEAD + ONE + OTHER, encoding="utf-8")
    two = run_json("rank", str(table), "--like", "r161-ash")
    assert three["scatter_m_s"] == pytest.approx(two["scatter_m_s"], rel=0.05)  # of other draws
    assert "not ranked" not in " ".join(run("rank", str(table), "--like", "r161-ash")[1].split())
    table.write_text(HEAD + ONE + swung, encoding="utf-8")
    code, out, err = run("rank", str(table), "--like", "r161-ash")
    assert (code, out) == (2, "")
    assert "C: pendulum lies" in err
    assert "measurements agree" in err


@pytest.mark.parametrize(
    ("content", "message"), [(None, "no such file"), (HEAD + ONE, "two or more"), ("a,b\n1,2\n", "heading")]
)
def test_refusals(run: Run, tmp_path: Path, content: str | None, message: str) -> None:
    table = tmp_path / "bats.csv"
    if content is not None:
        table.write_text(content, encoding="utf-8")
    code, out, err = run("rank", str(table), "--like", "r161-ash")
    assert (code, out) == (2, "")
    assert message in err


@pytest.mark.parametrize("heading", ["cpm", "frequency (cpm)", "bending_1_cpm", "Cycles per minute"])
def test_a_clamped_clubs_cycles_per_minute_are_refused(run: Run, tmp_path: Path, heading: str) -> None:
    table = tmp_path / "clubs.csv"
    table.write_text(f"name,mass_g,swing weight,{heading}\nA,312,D2,255\nB,314,D3,251\n", encoding="utf-8")
    code, out, err = run("rank", str(table), "--like", "golf-driver")
    assert (code, out) == (2, "")
    assert "grip clamped" in err and "Leave it out" in err

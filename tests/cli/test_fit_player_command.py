"""`sweetspot fit-player` from the outside: answers, files, bad input."""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.player.prior import natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import MPH

Run = Callable[..., tuple[int, str, str]]


@pytest.fixture(scope="module")
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("player") / "swings.csv"
    made = simulated_swings(natural(np.zeros(10)), bats=[catalog.bat("r161-ash")], ball=catalog.ball(), count=8,
                            pitch_speed=60 * MPH, seed=3)  # fmt: skip
    lines = ["Bat Speed (mph),Exit Velocity (mph),Launch Angle (deg)"]
    for one in made:
        assert one.bat_speed and one.exit_speed and one.launch_angle
        angle = math.degrees(one.launch_angle)
        lines.append(f"{one.bat_speed / MPH:.1f},{one.exit_speed / MPH:.1f},{angle:.1f}")
    path.write_text("\n".join([*lines, "70,400,3"]) + "\n", encoding="utf-8")
    return path


def test_answers_for_people_and_a_page(run: Run, file: Path, tmp_path: Path) -> None:
    out = tmp_path / "report"
    given = ("--pitch-speed", "60mph", "--for", "Ann <Example>", "--out", str(out))
    code, text, said = run("fit-player", str(file), *given)
    assert code == 0, said
    words = re.sub(r"\s+", " ", text)
    assert "Balanced or end-loaded?" in words and "What a change of the player is worth in exit speed" in words
    assert "8 swings count, 8 with bat speed and exit speed, from a file; 1 row does not (row 10: exit speed" in words
    assert "Only 8 swings are usable" in words
    assert "8 of 8 swings have a launch angle and no attack angle; where over or under" in words
    assert "1 row is not used: row 10: exit speed is 400.0 mph" in words
    assert sorted(path.name for path in out.iterdir()) == ["player.html", "player.json", "player.png", "player.svg"]
    page = (out / "player.html").read_text(encoding="utf-8")
    assert "<h1>R161, white ash</h1>" in page and "<b>For Ann &lt;Example&gt;</b>" in page
    assert "http" not in re.sub(r'xmlns\S*="[^"]*"', "", page)
    assert (out / "player.png").read_bytes().startswith(b"\x89PNG")
    assert "wrote" in said


def test_units_are_the_readers_and_a_softball_flies_by_its_own_law(run: Run, file: Path) -> None:
    given = ("--pitch-speed", "60mph", "--ball", "softball-12in", "--goal", "carry", "--units", "si")
    code, text, said = run("fit-player", str(file), *given)
    words = re.sub(r"\s+", " ", text)
    assert code == 0, said
    assert re.search(r"Bat speed is \d\d\.\d m/s", words) and re.search(r"cm \([^)]*\) from the tip", words)
    assert "0.45 m/s more bat speed +" in words and "2.5 cm less scatter along the bat" in words
    assert " ft" not in words and " in from the tip" not in words


def test_json_and_csv_for_programs(run: Run, run_json: Callable[..., Any], file: Path) -> None:
    given = ("fit-player", str(file), "--pitch-speed", "60mph", "--goal", "line", "--line", "200ft")
    found = run_json(*given, "--try", "mlb-a")
    assert found["goal"]["line_m"] == pytest.approx(60.96)
    assert 0 <= found["now_ratio"]["value"] <= 1
    assert any(option["key"].startswith("bat:") for option in found["options"])
    code, text, _ = run(*given, "--format", "csv")
    assert code == 0
    assert text.splitlines()[0].startswith("key,label,family,length_m,mass_kg")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ((), "--pitch-speed 82mph"),
        (("--pitch-speed", "60"), "without a unit"),
        (("--pitch-speed", "300mph"), "up to 110mph"),
        (("--pitch-speed", "tee", "--goal", "line"), "give both"),
        (("--pitch-speed", "tee", "--line", "300ft"), "give both"),
        (("--pitch-speed", "tee", "--bat", "r162"), "Did you mean r161-ash"),
        (("--pitch-speed", "tee", "--try", "nothing-like-it"), "not in the catalogue"),
        (("--pitch-speed", "tee", "--batter", "me"), "no column that names the batter"),
        (("--pitch-speed", "tee", "--bat-speed-at", "3in"), "outer half"),
        (("--pitch-speed", "tee", "--seed", "-1"), "from 0 up"),
        (("--pitch-speed", "tee", "--out", "/dev/null"), "not a folder"),
    ],
)
def test_bad_input_is_told_in_one_line(run: Run, file: Path, options: tuple[str, ...], message: str) -> None:
    code, out, said = run("fit-player", str(file), *options)
    assert (code, out) == (2, "")
    assert message in said and said.count("\n") == 1


def test_no_file(run: Run, tmp_path: Path) -> None:
    code, _, said = run("fit-player", str(tmp_path / "none.csv"))
    assert code == 2 and ("is not a file" in said or "no such file" in said)


def test_a_league_is_pooled_and_says_by_how_much(run: Run, run_json: Callable[..., Any], tmp_path: Path) -> None:
    lines = ["batter,bat_speed_mph,exit_speed_mph,launch_angle_deg"]
    for number in range(6):
        place = natural(np.full(10, 0.1 * number))
        count = 28 if number == 5 else 8
        made = simulated_swings(
            place, bats=[catalog.bat("r161-ash")], ball=catalog.ball(), count=count, pitch_speed=60 * MPH, seed=number
        )
        for one in made:
            assert one.bat_speed and one.exit_speed and one.launch_angle
            numbers = one.bat_speed / MPH, one.exit_speed / MPH, math.degrees(one.launch_angle)
            lines.append(f"b{number}," + ",".join(f"{value:.1f}" for value in numbers))
    path = tmp_path / "league.csv"
    path.write_text("\n".join(lines), encoding="utf-8")
    given = ("fit-player", str(path), "--pitch-speed", "60mph", "--batter", "all")
    found = run_json(*given)
    assert found["league"]["players"] == 6 and found["league"]["position_spread"]["mean_m"] > 0
    by_name = {batter["batter"]: batter["parameters"] for batter in found["batters"]}
    for parameters in by_name.values():
        one = parameters["bat_speed_spread"]
        assert one["moved_m_s"] == pytest.approx(one["pooled"]["value_m_s"] - one["alone"]["value_m_s"], abs=1e-9)
    shares = {name: parameters["bat_speed_spread"]["own_share"] for name, parameters in by_name.items()}
    assert max(shares, key=lambda name: shares[name]) == "b5" and all(0 <= share <= 1 for share in shares.values())
    again = run_json(*given)
    assert again == found  # whatever thread did what
    few = tmp_path / "few.csv"
    few.write_text("\n".join(line for line in lines if not line.startswith(("b3", "b4"))), encoding="utf-8")
    code, text, said = run("fit-player", str(few), *given[2:])
    assert code == 0, said
    assert "fewer than five batters" in re.sub(r"\s+", " ", text) and "Alone and pooled" not in text


def test_bats_by_the_sensors_own_names(run: Run, file: Path, tmp_path: Path) -> None:
    """Two unknown names are two bats, one with BBCOR in its name is of metal, and --bat-is says which is which."""
    heading, *rows = file.read_text(encoding="utf-8").splitlines()[:-1]
    both = tmp_path / "both.csv"
    names = ("Louisville C271", "Victus Nox BBCOR 33/30")
    both.write_text("\n".join([f"{heading},bat", *(f"{row},{names[i % 2]}" for i, row in enumerate(rows))]), "utf-8")
    code, text, said = run("fit-player", str(both), "--pitch-speed", "60mph")
    words = re.sub(r"\s+", " ", text)
    assert code == 0, said
    assert "4 with Louisville C271, 4 with Victus Nox BBCOR 33/30" in words
    assert "'Louisville C271' for R161, white ash, 'Victus Nox BBCOR 33/30' for BBCOR alloy" in words
    given = ("--bat-is", f"{names[0]}=mlb-a", "--bat-is", f"{names[1].lower()}=composite")
    code, text, said = run("fit-player", str(both), "--pitch-speed", "60mph", *given)
    assert code == 0 and "taken for others" not in text and "MLB profile A" in text, said
    assert run("fit-player", str(both), "--bat-is", "Nox")[0] == 2

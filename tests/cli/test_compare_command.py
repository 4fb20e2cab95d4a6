"""`sweetspot compare` as a user meets it."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot.units import MPH

Run = Callable[..., tuple[int, str, str]]
RunJson = Callable[..., Any]


def test_table_says_who_gains(run: Run) -> None:
    code, out, _ = run("compare", "r161-ash", "corked-r161", "youth-30")
    words = " ".join(out.split())
    assert code == 0
    for heading in ("mass oz", "MOI", "q max", "BBCOR in play", "bat speed mph", "change mph", "reference"):
        assert heading in words
    assert "R161, corked: swung 2.0 mph faster, the ball leaves" in words and "mph slower (" in words
    assert (
        "about the knob to the power -0.29" in words
        and "In brackets: 90 % intervals of what is not known of bats and ball" in words
    )
    assert "10,300 ± 1000 oz in²" in words, "as `bats` and `report` tell it: nobody measured it"


def test_what_each_place_gains_is_told(run: Run) -> None:
    # a torpedo has its wood nearer the hands: faster there, slower near the tip
    _, out, _ = run("compare", "torpedo-twin", "torpedo")
    assert "Change by place, against Torpedo's twin" in out
    told = dict(re.findall(r"^ +(\d+\.\d) +([-+]\d\.\d)$", out, re.MULTILINE))
    assert len(told) == 10 and float(told["3.0"]) < 0 < float(told["8.0"])


def test_corking_is_answered_beside_the_published_numbers(run: Run) -> None:
    code, out, _ = run("compare", "r161-ash", "--what-if", "cork", "--details")
    words = " ".join(out.split())
    assert code == 0
    net = json.loads(run("compare", "r161-ash", "--what-if", "cork", "--format", "json")[1])["bats"][1]["change_m_s"]
    assert net["low"] < net["value"] < -0.2, "on the whole a loss, as published"
    told = "No: net of the faster swing the ball leaves" if round(net["high"] / MPH, 1) < 0 else "Probably not ("
    for text in (
        "R161, white ash, cork", "Does corking help?", told, "from 0.214 to 0.193", "+2.9 mph",
        "Hooke's law and momentum",
    ):  # fmt: skip
        assert text in words


def test_json_has_units_and_intervals(run_json: RunJson) -> None:
    result = run_json("compare", "r161-ash", "--what-if", "drilled 8in", "--what-if", "cork 8in x 1in")
    assert result["same"] == "effort" and result["reference"] == "R161, white ash"
    assert result["swing_law"]["exponent"] == pytest.approx({"value": 0.29, "low": 0.2242, "high": 0.3558}, abs=1e-4)
    whole, drilled, cork = result["bats"][:3]
    assert whole["change_m_s"] == {"value": 0.0, "low": 0.0, "high": 0.0}
    assert drilled["bat"]["mass_kg"] < cork["bat"]["mass_kg"] < whole["bat"]["mass_kg"]
    assert whole["break_even_bat_speed_m_s"] == whole["bat_speed_m_s"]["value"] == pytest.approx(31.2928)
    assert len(cork["scan"]["position_m"]) == len(cork["scan"]["exit_speed_m_s"])
    assert len(result["verdict"]) == 2 + 3


def test_same_speed_and_other_law(run_json: RunJson) -> None:
    same = run_json("compare", "r161-ash", "corked-r161", "--same-speed")
    assert same["same"] == "speed" and same["swing_law"] is None
    assert [bat["bat_speed_m_s"]["value"] for bat in same["bats"]] == pytest.approx([31.2928, 31.2928])
    other = run_json("compare", "r161-ash", "corked-r161", "--swing-law", "slow-pitch")
    assert other["swing_law"]["axis_from_grip_m"] == pytest.approx(0.1524)
    assert other["bats"][1]["bat_speed_m_s"]["value"] > 31.2928


@pytest.mark.parametrize(
    "arguments",
    [
        ["r161-ash", "youth-30", "russell-b5"],
        ["r161-ash", "--rows", "mass=30oz:31oz:2", "--columns", "bore-diameter=0.5in:3in:3"],
    ],
)
def test_csv_is_a_table(run: Run, arguments: list[str]) -> None:
    code, out, err = run("compare", *arguments, "--format", "csv")
    rows = list(csv.reader(io.StringIO(out)))
    assert code == 0, err
    assert len(rows) > 3 and {len(row) for row in rows} == {len(rows[0])}
    assert any(name.endswith("exit_speed_m_s") for name in rows[0])


def test_files_are_written_whole(run: Run, tmp_path: Path) -> None:
    folder = tmp_path / "new" / "comparison"
    code, _, err = run("compare", "r161-ash", "youth-30", "--out", str(folder))
    assert code == 0 and "wrote" in err
    assert sorted(path.name for path in folder.iterdir()) == [
        "compare.html",
        "compare.json",
        "compare.png",
        "compare.svg",
    ]
    assert json.loads((folder / "compare.json").read_text())["bats"][1]["label"].startswith("Youth")


def test_units_are_the_readers(run: Run, tmp_path: Path) -> None:
    code, out, _ = run("compare", "r161-ash", "corked-r161", "--units", "si", "--out", str(tmp_path))
    words = " ".join(out.split())
    assert code == 0 and "swung 0.88 m/s faster" in words and "mass g" in words and "kg cm²" in words
    assert "mph" not in words and " oz" not in words
    page = (tmp_path / "compare.html").read_text(encoding="utf-8")
    assert "0.88 m/s faster" in page and "BBCOR in play" in page


def test_a_difference_that_nobody_could_see_is_no_loss(run: Run, tmp_path: Path) -> None:
    twin = tmp_path / "twin.toml"
    twin.write_text('like = "r161-ash"\nname = "twin"\nmass = "31.02 oz"\n')
    out = " ".join(run("compare", "r161-ash", str(twin))[1].split())
    assert "twin: the ball leaves as fast as from R161, white ash." in out  # one piece: nothing else is open
    assert "0.0 mph slower" not in out


def test_a_calibrated_bat_stays_one_piece_of_wood(run: Run, tmp_path: Path) -> None:
    """The tape that a calibration lays on the knob is told from a weight that may sit inside the wood."""
    own = tmp_path / "own.toml"
    assert run("calibrate", "r161-ash", "--mass", "31.1oz", "--balance-point", "22.1in", "--out", str(own))[0] == 0
    assert "on_surface = true" in own.read_text(encoding="utf-8")
    rules = run("compare", str(own), "--units", "us")[1].split("By the rules")[1].split("The pitch comes")[0]
    assert "open" in rules and "one piece of solid wood" not in " ".join(rules.split())


def test_a_gain_against_plies_holds_if_they_are_as_described(run: Run) -> None:
    """Their doubt is not modelled, so it is not in the interval; the sentence and the note say so."""
    words = " ".join(run("compare", "composite", "russell-b6")[1].split())
    assert re.search(r"\): a (gain|loss) if Composite, one piece, 33 in is just as described\.", words), words[:400]
    assert "Composite, one piece, 33 in is taken as described: how its plies may differ is not modelled." in words


def test_rackets_are_compared_in_their_sports_words(run: Run) -> None:
    code, out, _ = run("compare", "tennis-racket", "badminton-racket", "--force")
    words = " ".join(out.split())
    assert code == 0 and "The rackets" in words and "swing weight" in words and "racket speed m/s" in words
    assert "BBCOR" not in words and "no law of this sport's own players" in words


def test_what_if_table(run: Run, run_json: RunJson, tmp_path: Path) -> None:
    asked = ["r161-ash", "--rows", "mass=30oz:31oz:2", "--columns", "bore-depth=0in:40in:3"]
    code, out, _ = run("compare", *asked, "--cell", "bbcor")
    words = " ".join(out.split())
    assert code == 0 and "bbcor: mass (oz) down, bore depth (in) across" in words
    assert "make it shallower" in words
    folder = tmp_path / "grid"
    assert run("compare", *asked, "--out", str(folder))[0] == 0
    assert sorted(path.suffix for path in folder.iterdir()) == [".html", ".json", ".png", ".svg"]
    result = run_json("compare", *asked)
    assert result["columns"]["bore_depth_m"] == pytest.approx([0.0, 0.508, 1.016])
    assert [row[2] for row in result["answers"]["exit_speed_m_s"]] == [None, None]
    assert [failure["column"] for failure in result["failures"]] == [2, 2]


def test_variants_of_a_bat_side_by_side(run: Run, run_json: RunJson) -> None:
    """Rows alone: every answer has a column, and a cup takes weight from the tip."""
    asked = ["r161-ash", "--rows", "cup-depth=0in:1.2in:3"]
    code, out, _ = run("compare", *asked)
    words = " ".join(out.split())
    assert code == 0 and "BBCOR in play is at this swing's closing speed" in words
    assert "computes that of the test" in words and len(re.findall(r"^ *[\d.]{4} +1\d\d\.\d ", out, re.MULTILINE)) == 3
    found = run_json("compare", *asked)
    assert found["columns"] is None and found["rows"]["cup_depth_m"] == pytest.approx([0.0, 0.01524, 0.03048])
    masses = [row[0] for row in found["answers"]["mass_kg"]]
    assert masses == sorted(masses, reverse=True) and masses[0] - masses[2] > 0.005


def test_every_bat_is_held_against_the_rules(run: Run, run_json: RunJson) -> None:
    """The number and the verdict are those of `certify`; a corked bat is no piece of solid wood."""
    bats = [bat["rules"] for bat in run_json("compare", "r161-ash", "corked-r161", "russell-b5")["bats"]]
    assert [bat["verdict"] for bat in bats] == ["pass", "fail", "fail"]
    assert bats[0]["passed"] and not bats[2]["passed"]
    code, text, _ = run("certify", "russell-b5", "--format", "json")
    certified = {check["quantity"]: check for check in json.loads(text)["checks"]}
    here = {check["quantity"]: check for check in bats[2]["checks"]}
    assert code == 1 and here["bbcor"].items() <= certified["bbcor"].items()
    _, out, _ = run("compare", "r161-ash", "corked-r161", "russell-b5")
    words = " ".join(out.split())
    assert "it is not one piece of solid wood (Major League" in words
    assert "one piece of wood, which NCAA and NFHS do not hold to BBCOR" in words
    assert "BBCOR of NCAA and NFHS (0.5" in words and "allowed at most 0.5000" in words


def test_doubt_comes_from_bats_by_name_and_is_drawn(run: Run, tmp_path: Path) -> None:
    _, out, _ = run("compare", "r161-ash", "mlb-a", "--uncertainty", "--out", str(tmp_path))
    shown = (tmp_path / "compare.svg").read_text(encoding="utf-8")
    assert shown.count('id="band"') == 1 and "90 % intervals" in shown, "the difference has its band"
    told = json.loads((tmp_path / "compare.json").read_text(encoding="utf-8"))["bats"][1]["scan"]
    assert len(told["exit_speed_low_m_s"]) == len(told["position_m"])
    rows = out.split("rests on")[1]
    assert "MLB profile A" in rows and "R161, white ash" in rows and "bat 1" not in out
    first = " ".join(out.split("Hit by the same ball")[0].split())
    assert re.search(r": (probably )?(a gain|a loss|the sign is not sure)( \(\d+ %\))?\.$", first), (
        "only the drawn is open"
    )


def test_a_long_table_says_nothing_to_a_log(run: Run) -> None:
    asked = ["--rows", "mass=30oz:31oz:5", "--columns", "pitch-speed=80mph:95mph:10", "--format", "csv"]
    code, out, err = run("compare", "r161-ash", *asked)
    assert (code, err) == (0, "") and len(out.splitlines()) == 51


def test_a_folder_that_is_a_file_is_refused(run: Run, tmp_path: Path) -> None:
    (tmp_path / "taken").write_text("x")
    code, _, err = run("compare", "r161-ash", "--out", str(tmp_path / "taken"))
    assert code == 2 and "cannot be made" in err


def test_an_error_that_nobody_counts_is_said(run: Callable[..., tuple[int, str, str]]) -> None:
    hit = ("hit", "r161-ash", "--at", "27in", "--bat-speed", "70mph±2mph")
    assert "an error behind ± counts where --uncertainty is given" in run(*hit)[2]
    assert "behind ±" not in run(*hit, "--uncertainty")[2]

"""`sweetspot certify` as a user meets it: verdicts, exit codes, formats, messages."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

Run = Callable[..., tuple[int, str, str]]

HEADINGS = "ball_in_mph,ball_out_mph,position_in_from_tip,ball_cor"
OUT = (27.9, 28.1, 28.0, 28.2, 27.8, 28.0)
SIX = [f"136,{out},6.0,0.5444" for out in OUT]
BESIDE = [f"136,{out - 4:.1f},{place},0.5444" for out in OUT for place in (5.0, 7.0)]
"""Lower places on both sides of the best."""


def written(folder: Path, *rows: str, headings: str = HEADINGS) -> str:
    path = folder / "shots.csv"
    path.write_text("\n".join([headings, *rows]) + "\n", encoding="utf-8")
    return str(path)


def checks(result: Any) -> dict[str, Any]:
    return {check["quantity"]: check for check in result["checks"]}


def test_a_wood_bat_passes(run: Run) -> None:
    code, out, _ = run("certify", "r161-ash")
    words = " ".join(out.split())
    assert code == 0 and "BBCOR" in words and "pass" in words and "not decidable" in words


def test_another_ball_than_the_bats_own_is_explained(run: Run) -> None:
    told = " ".join(run("certify", "fast-pitch")[1].split())
    assert (
        'the ball that the rule names [bpf_limits], "softball, 12 in, slow pitch", not with "softball, 12 in, fast'
        in told
    )
    assert "that the rule names" not in run("certify", "slow-pitch")[1]


def test_limits_of_the_past_are_told_as_such_in_the_first_sentence(run: Run) -> None:
    code, out, _ = run("certify", "youth-30", "--league", "little-league")
    first = " ".join(out.split("\n\n")[1].split())
    assert code == 0 and "limits that hold no more" in first and "keeps every rule" not in out


def test_the_verdict_the_one_number_and_the_rules_that_apply_come_first(run: Run) -> None:
    """The tables behind them, and rules that do not apply, are printed for who asks."""
    _, short, _ = run("certify", "r161-ash")
    _, long, _ = run("certify", "r161-ash", "--details")
    _, verdict, number, *_ = re.split(r"\n\s*\n", short)
    assert "surely keeps 3 of 4 rules" in verdict and number.startswith("BBCOR 0.49")
    measure = json.loads(run("certify", "r161-ash", "--format", "json")[1])["measure"]
    assert measure["quantity"] == "bbcor" and measure["value_low"] < measure["value"] < measure["value_high"] < 0.5
    assert "Simulated test" not in short and "does not apply" not in short and len(short.splitlines()) < 20
    assert "Simulated test" in long and "does not apply" in long


def test_json_keys_and_units(run: Run) -> None:
    code, out, _ = run("certify", "college-alloy", "--format", "json")
    result = json.loads(out)
    assert code == 0 and result["passed"] is True
    test = result["test"]
    assert {
        "pivot_m", "bbcor", "collision_efficiency", "besr", "bpf", "batted_ball_speed_m_s", "best_position_m", "fast",
        "slow", "spread", "spread_by_law", "spread_by_moi", "spread_by_wall",
    } == set(test)  # fmt: skip
    assert test["pivot_m"] == pytest.approx(0.1524)
    assert test["fast"]["closing_speed_m_s"] == pytest.approx(136 * 0.44704)
    assert test["slow"]["closing_speed_m_s"] == pytest.approx(60 * 0.44704)
    assert len(test["fast"]["position_m"]) == len(test["fast"]["bbcor"]) >= 20
    assert test["besr"] == pytest.approx(test["collision_efficiency"] + 0.5)
    limit = checks(result)["bbcor"]
    assert limit["verdict"] == "pass" and limit["margin"] == pytest.approx(0.5 - test["bbcor"])
    assert (limit["source"], limit["year"], limit["unit"]) == ("ncaa_bbcor", 2011, "-")


def test_a_corked_bat_fails_the_major_league(run: Run) -> None:
    code, out, _ = run("certify", "corked-r161", "--league", "mlb", "--format", "json")
    result = json.loads(out)
    assert code == 1 and result["passed"] is False
    assert checks(result)["solid_wood"]["verdict"] == "fail"


@pytest.mark.parametrize("league", ["ncaa", "nfhs", "high school", "mlb"])
def test_a_corked_bat_fails_by_what_was_done_to_it(run: Run, league: str) -> None:
    """An altered bat is forbidden, whatever its number: 0.4998 would keep BBCOR."""
    code, out, _ = run("certify", "corked-r161", "--league", league)
    first = " ".join(out.split("\n\n")[1].split())
    assert code == 1 and "it is altered" in first and "Not sure" not in first
    compared = " ".join(run("compare", "r161-ash", "corked-r161")[1].split())
    assert "it is altered (drilled" in compared


def test_one_piece_of_wood_need_not_meet_bbcor_and_glued_wood_must(run: Run, tmp_path: Path) -> None:
    """ncaa_bat_rule 1-12a, nfhs_bat_rule: all but one-piece solid wood; the designed torpedo measures 0.5034."""
    code, out, _ = run("certify", "torpedo-designed", "--format", "json")
    assert code == 0 and checks(json.loads(out))["bbcor"]["verdict"] == "does not apply"
    file = tmp_path / "glued.toml"
    file.write_text('like = "torpedo-designed"\n[material]\nlike = "maple"\nlaminated = true\n', encoding="utf-8")
    code, out, _ = run("certify", str(file), "--format", "json")
    assert code == 1 and checks(json.loads(out))["bbcor"]["verdict"] == "fail"
    first = " ".join(run("certify", str(file))[1].split("\n\n")[1].split())
    assert "fails as far as is known, but not surely: BBCOR of NCAA and NFHS (0.50" in first
    file.write_text('like = "torpedo-designed"\nmaterial = "bamboo"\nmass = "31 oz"\n', encoding="utf-8")
    assert "bbcor" in {
        key
        for key, one in checks(json.loads(run("certify", str(file), "--format", "json")[1])).items()
        if one["verdict"] in ("pass", "fail")
    }


def test_a_wall_of_the_catalogue_is_said_to_be_it(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "mine.toml"
    file.write_text('like = "college-alloy"\nname = "mine"\nmass = "30.6 oz"\n', encoding="utf-8")
    words = " ".join(run("certify", str(file))[1].split())
    assert "The wall is that of the catalogue's college-alloy; it was not measured on this bat" in words
    assert "The wall is" not in run("certify", "r161-ash")[1]


def test_a_softball_is_tested_as_a_softball(run: Run) -> None:
    words = " ".join(run("certify", "slow-pitch", "--details")[1].split())
    assert "25 mph ball, 85 mph bat" in words and "ball at 110 mph" in words
    assert "136 mph" not in words and "BBCOR of the test" not in words


def test_a_limit_that_holds_no_more_is_said_to(run: Run) -> None:
    code, out, _ = run("certify", "russell-b5", "--league", "little-league")
    assert code == 0 and "since 1 January 2018 bats must keep the USABat standard" in " ".join(out.split())


def test_the_first_sentence_is_no_surer_than_the_test(run: Run) -> None:
    """The alloy bat's BBCOR is below the limit, but the ball's patch leaves more than it; ash is far enough off."""
    unsure = "surely keeps 4 of 7 rules and breaks none. Not sure: BBCOR. It just passes; what is not known reaches"
    assert unsure in " ".join(run("certify", "college-alloy")[1].split())
    assert "Not sure" not in run("certify", "r161-ash")[1]
    limit = checks(json.loads(run("certify", "college-alloy", "--format", "json")[1]))["bbcor"]
    assert (limit["verdict"], limit["sure"]) == ("pass", False)


def test_compare_is_no_surer_than_certify(run: Run) -> None:
    """One rule for both: the interval decides whether a verdict is sure, and a sure fail is one whatever is not."""
    compared = json.loads(run("compare", "r161-ash", "college-alloy", "russell-b5", "--format", "json")[1])["bats"]
    told = [(bat["rules"]["verdict"], bat["rules"]["sure"]) for bat in compared]
    assert told == [("pass", True), ("pass", False), ("fail", True)]
    for bat, name in zip(compared, ("r161-ash", "college-alloy", "russell-b5"), strict=True):
        certified = json.loads(run("certify", name, "--format", "json")[1])["checks"]
        sure = {(one["league"], one["quantity"]): (one["verdict"], one["sure"]) for one in certified}
        assert all(
            sure[one["league"], one["quantity"]] == (one["verdict"], one["sure"])
            for one in bat["rules"]["checks"]
            if one["league"] == "ncaa"
        )
    words = " ".join(run("compare", "r161-ash", "college-alloy")[1].split())
    assert "pass, not sure BBCOR of the test 0.498" in words and "allowed at most 0.5000, not sure" in words


def test_where_nothing_can_be_decided_nothing_is_passed(run: Run) -> None:
    code, out, _ = run("certify", "slow-pitch", "--league", "asa")
    assert code == 1 and "is not passed: this test does not decide batted-ball speed" in " ".join(out.split())
    code, out, _ = run("certify", "youth-30", "--league", "usabat")
    assert code == 0 and "keeps every rule. It is taken as one piece of wood" in " ".join(out.split())
    code, out, _ = run("certify", "youth-alloy", "--league", "usabat")
    words = " ".join(out.split())
    assert code == 0 and "surely keeps 1 of 3 rules" in words and "Not decidable: performance like wood." in words


def test_units_are_the_readers_and_a_page_is_written(run: Run, tmp_path: Path) -> None:
    code, out, _ = run("certify", "russell-b5", "--units", "si", "--details", "--out", str(tmp_path))
    words = " ".join(out.split())
    assert code == 1 and "Russell B5, hollow fails: BBCOR of NCAA and NFHS (0.5" in words
    assert "ball at 61 m/s" in words and "mph" not in words and " oz" not in words
    page = (tmp_path / "certify.html").read_text(encoding="utf-8")
    assert '<span class="missed">fail</span>' in page and "BBCOR of the test" in page


def test_csv_has_one_row_per_rule(run: Run) -> None:
    code, out, _ = run("certify", "r161-ash", "--league", "all", "--format", "csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert code == 0
    assert {"mlb", "ncaa", "ncaa-1999", "usssa", "usabat"} <= {row["league"] for row in rows}
    assert "softball" not in {row["league"] for row in rows}  # another ball
    assert {row["verdict"] for row in rows} <= {"pass", "fail", "not decidable", "does not apply"}


def test_shots_that_pass(run: Run, tmp_path: Path) -> None:
    code, out, err = run("certify", "college-alloy", "--shots", written(tmp_path, *SIX, *BESIDE), "--format", "json")
    assert code == 0, err
    result = json.loads(out)
    shots = result["shots"]
    assert shots["good_rows"] == 18 and shots["bad_rows"] == []
    assert shots["bbcor"]["count"] == 6
    assert shots["bbcor"]["low"] < shots["bbcor"]["mean"] < shots["bbcor"]["high"] < 0.5
    assert {"mean_m_s", "standard_error_m_s", "low_m_s", "high_m_s", "count"} == set(shots["batted_ball_speed"])
    assert checks(result)["bbcor"]["verdict"] == "pass"


def test_shots_that_fail(run: Run, tmp_path: Path) -> None:
    lively = [f"136,{out},6.0,0.5444" for out in (32.9, 33.1, 33.0, 33.2, 32.8, 33.0)]
    code, out, _ = run("certify", "college-alloy", "--shots", written(tmp_path, *lively))
    assert code == 1 and "fail" in out
    beside = [f"136,{out},{place},0.5444" for out in (28.9, 29.1) for place in (5.0, 7.0)]
    dead = run(
        "certify", "college-alloy", "--shots", written(tmp_path, *lively, *beside), "--standard-ball-cor", "0.50"
    )
    assert dead[0] == 0  # the same shots as from livelier balls


def test_a_fail_stands_on_one_place(run: Run, tmp_path: Path) -> None:
    """A place beside it can only be livelier."""
    code, out, _ = run("certify", "russell-b5", "--shots", law_file(tmp_path, [6.0], peak=0.225))
    assert code == 1 and "fails: BBCOR of NCAA and NFHS (0.5" in " ".join(out.split())


def law_file(
    folder: Path,
    places: list[float],
    *,
    heading: str = "position_in_from_tip",
    dead: bool = False,
    unit: float = 1.0,
    peak: float = 0.205,
) -> str:
    """Return a file of six shots a place by one made-up law, q = peak - 0.011 (x - 6)^2 with x in in from the tip."""
    rows = [
        f"{136 * unit:.2f},{0 if dead else 136 * unit * (peak - 0.011 * (x - 6) ** 2 + error):.3f},{x}"
        for x in places
        for error in (-0.002, -0.001, 0.0, 0.0, 0.001, 0.002)
    ]
    return written(folder, *rows, headings=f"ball_in_mph,ball_out_mph,{heading}")


EVERY_HALF = [4.0, 4.5, 5.0, 5.5, 6.0, 6.5, 7.0]
MEASURED_BAT = 'like = "college-alloy"\nmass = "30.2 oz"\nmoi = "9700 oz*in^2"\n'


@pytest.mark.parametrize(
    ("places", "how", "told"),
    [
        ([9.5], {}, "Either its best place was not hit"),
        ([8.0, 8.5, 9.0, 9.5], {}, "(7 in) from the tip, nearer to the tip, was not hit"),
        ([*EVERY_HALF, 27.5], {"heading": "position_in_from_knob"}, "is it counted from the other end"),
        (EVERY_HALF, {"dead": True}, "the gate that times the rebound"),
        (EVERY_HALF, {"unit": 0.44704}, "looks like a column of speeds in another unit"),
        ([6.0, 9.0], {}, "(7 in) from the tip, nearer to the hands, was not hit"),
    ],
    ids=["one place", "edge", "from the knob", "dead gate", "unit", "gap"],
)
def test_what_was_not_measured_is_not_certified(
    places: list[float], how: dict[str, Any], told: str, run: Run, tmp_path: Path
) -> None:
    """A limit holds for the greatest value along the bat: lower places on both sides show it, and most rows count."""
    bat = tmp_path / "mine.toml"
    bat.write_text(MEASURED_BAT, encoding="utf-8")
    code, out, _ = run("certify", str(bat), "--shots", law_file(tmp_path, places, **how))
    first = " ".join(out.split("\n\n")[1].split())
    assert code == 1 and "is not passed: this test does not decide BBCOR" in first and told in first


def test_a_file_of_faults_is_no_test(run: Run, tmp_path: Path) -> None:
    faults = ["136,,6,0.5444"] * 10
    code, out, _ = run("certify", "college-alloy", "--shots", written(tmp_path, *SIX, *BESIDE, *faults))
    assert code == 1 and "only 18 of 28 rows could be used" in " ".join(out.split())


def test_bad_rows_are_printed(run: Run, tmp_path: Path) -> None:
    path = written(tmp_path, *SIX, "136,-4,6,0.5", "136,,6,0.5", "136,31,6,0.5444")
    code, out, _ = run("certify", "college-alloy", "--shots", path)
    words = " ".join(out.split())
    assert code in (0, 1)
    assert "Row 8 is not used: negative rebound" in words and "Row 9 is not used" in words
    assert "Row 10 stands out" in words


@pytest.mark.parametrize(
    ("rows", "message"),
    [(["136,28,6,0.54"], "1 good shot: no uncertainty can be given"), (["136,-28,6,0.54"], "negative rebound")],
)
def test_shots_that_are_bad_input(rows: list[str], message: str, run: Run, tmp_path: Path) -> None:
    code, out, err = run("certify", "college-alloy", "--shots", written(tmp_path, *rows))
    assert code == 2 and out == "" and message in err and err.count("\n") == 1


def test_mixed_units_are_refused(run: Run, tmp_path: Path) -> None:
    path = written(tmp_path, "136,60,28,6", headings="ball_in_mph,ball_in_m_s,ball_out_mph,position_in_from_tip")
    code, _, err = run("certify", "r161-ash", "--shots", path)
    assert code == 2 and "keep one of them, in one unit" in err


def test_the_wall_that_would_just_pass(run: Run) -> None:
    code, out, _ = run("certify", "single-wall", "--wall-that-passes", "--format", "json")
    wall = json.loads(out)["walls"][0]
    assert code == 1 and (wall["league"], wall["measure"], wall["limit"]) == ("ncaa", "bbcor", 0.5)
    assert 4e-3 < wall["thickness_m"] < 6e-3 and wall["mass_kg"] > 1.1
    assert run("certify", "r161-ash", "--wall-that-passes")[0] == 2

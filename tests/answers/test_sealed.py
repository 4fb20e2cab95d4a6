"""Blind tests: questions are answered as their own commands answer them, and scores count what was measured."""

from __future__ import annotations

import csv
import hashlib
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import sweetspot
from sweetspot.answers.sealed import SEALED_KINDS, TO_HALF, score_answer
from sweetspot.cli import main
from sweetspot.errors import InputError
from sweetspot.numerics.interval import Interval
from sweetspot.units import FOOT, INCH, MPH, OUNCE_INCH_SQUARED
from sweetspot.validation.sealed_files import (
    Prediction,
    SealedMeasurement,
    predictions_csv,
    read_measured,
    read_predictions,
    read_questions,
)

QUESTIONS = """ID;Kind;Implement;At;Pitch speed;Bat speed;Exit speed;Launch angle;Harmonic;Unit
a1;exit_speed;youth-30;;50mph;45mph;;;;mph
a2;collision_efficiency;youth-30;4in-from-tip;50mph;45mph;;;;
a3;best_place;youth-30;;50mph;45mph;;;;in
a4;tone;youth-30;;50mph;45mph;;;2;Hz
a5;moment;youth-30;;50mph;45mph;;;;oz*in^2
a6;carry;;;;;90mph;25deg;;ft
a7;node;youth-30;;50mph;45mph;;;;
"""
"""As a spreadsheet writes it where commas are decimal. What has no swing of its own is asked of the same one here."""
Run = Callable[..., tuple[int, str, str]]


def written(folder: Path, name: str, text: str) -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def ours(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Predictions as the command writes them, of questions that take no column that is not theirs."""
    folder = tmp_path_factory.mktemp("sealed")
    text = re.sub(r"^(a[457];.*?;.*?);;50mph;45mph", r"\1;;;", QUESTIONS, flags=re.MULTILINE)
    questions = written(folder, "questions.csv", text)
    with pytest.raises(SystemExit) as stopped:
        main(["validate", "--sealed", str(questions), "--out", str(folder / "out")])
    assert not stopped.value.code
    return folder


def test_predictions_are_what_the_other_questions_answer(ours: Path) -> None:
    predicted = {one.id: one for one in read_predictions(ours / "out" / "predictions.csv")}
    setup: dict[str, Any] = {"pitch_speed": "50 mph", "bat_speed": "45 mph", "uncertainty": True}
    report, usual = sweetspot.report("youth-30", **setup), sweetspot.report("youth-30", uncertainty=True)
    hit = sweetspot.hit("youth-30", at="4in-from-tip", **setup)
    fly = sweetspot.fly(exit_speed="90 mph", launch_angle="25 deg", uncertainty=True)
    expected = {
        "a1": (report.best_hit.exit_speed, MPH),
        "a2": (hit.collision_efficiency, 1.0),
        "a3": (report.sweet_spots.max_exit_speed, INCH),
        "a4": (usual.modes[1].frequency, 1.0),
        "a6": (fly.carry, FOOT),
        "a7": (usual.modes[0].nodes[0], 1.0),
    }
    for name, (number, unit) in expected.items():
        assert isinstance(value := number, Interval)
        one = predicted[name]
        assert one.value == pytest.approx(value.value / unit, rel=1e-9)
        assert (one.low_90, one.high_90) == pytest.approx((value.low / unit, value.high / unit), rel=1e-9)
        assert one.low_50 == pytest.approx(one.value - TO_HALF * (one.value - value.low / unit), rel=1e-9)
    assert predicted["a5"].value == pytest.approx(float(usual.bat.moi_6in) / OUNCE_INCH_SQUARED)


def test_every_answer_has_the_version_and_the_digest_of_the_questions(ours: Path) -> None:
    digest = hashlib.sha256((ours / "questions.csv").read_bytes()).hexdigest()
    lines = list(csv.DictReader((ours / "out" / "predictions.csv").read_text("utf-8").splitlines()))
    assert {(line["version"], line["questions_sha256"]) for line in lines} == {(sweetspot.__version__, digest)}
    data = json.loads((ours / "out" / "sealed.json").read_text("utf-8"))
    assert data["questions_sha256"] == digest and len(data["predictions"]) == len(lines) == 7


def test_the_score_command_reads_what_the_other_wrote(ours: Path, run: Run) -> None:
    predicted = {one.id: one for one in read_predictions(ours / "out" / "predictions.csv")}
    high = predicted["a6"].high_90
    assert high is not None
    measured = written(ours, "measured.csv", f"id,value,error\na1,{predicted['a1'].value + 0.5},\na6,{high + 40},1\n")
    code, out, err = run("validate", "--score", str(ours / "out" / "predictions.csv"), str(measured), "--json")
    assert code == 0, err
    speed, carry = json.loads(out)["scores"]
    assert (speed["kind"], speed["in_90"], speed["of_90"]) == ("exit_speed", 1, 1)
    assert speed["bias"] == pytest.approx(-0.5)
    assert (carry["in_50"], carry["in_90"], carry["worst_id"]) == (0, 0, "a6")
    assert carry["worst"] == pytest.approx(predicted["a6"].value - high - 40)
    assert "a3" in json.loads(out)["not_measured"]


def prediction(name: str, value: float, half: float | None = None, **changed: Any) -> Prediction:
    ends = [None] * 4 if half is None else [value - TO_HALF * half, value + TO_HALF * half, value - half, value + half]
    return Prediction(name, "tone", "Hz", value, *ends, **{"version": "1", "questions_sha256": "x"} | changed)


def test_coverage_bias_and_worst_are_counted_by_hand() -> None:
    """Half widths of 10 (90 %) and 4.10 (50 %): 3 off is in both, 8 in one, 14 in none; the last has no interval."""
    predictions = [prediction(name, 100.0, 10.0) for name in "abc"] + [prediction("d", 100.0)]
    found = [SealedMeasurement(name, 100.0 + off, 0.0) for name, off in zip("abcd", (3, -8, 14, -2), strict=True)]
    (score,) = score_answer(predictions, found, Path("measured.csv")).scores
    assert (score.in_50, score.of_50, score.in_90, score.of_90, score.count) == (1, 3, 2, 3, 4)
    assert score.bias == pytest.approx((-3 + 8 - 14 + 2) / 4)
    assert score.rms == pytest.approx(((9 + 64 + 196 + 4) / 4) ** 0.5)
    assert (score.worst_id, score.worst) == ("c", -14.0)


def test_the_error_of_a_measurement_widens_the_interval() -> None:
    """14 off: half of 10 and 1.645 x 6 in quadrature are 14.04; 1.645 x 5.9 leave 13.94."""
    for error, inside in ((6.0, 1), (5.9, 0)):
        answer = score_answer([prediction("a", 100.0, 10.0)], [SealedMeasurement("a", 114.0, error)], Path("m.csv"))
        assert answer.scores[0].in_90 == inside


def test_predictions_are_read_as_they_were_written(tmp_path: Path) -> None:
    predictions = [prediction("=1+1", 1 / 3, 0.1), prediction("b", 2 / 3)]
    path = tmp_path / "p.csv"
    path.write_bytes(predictions_csv(predictions))
    again = read_predictions(path)
    assert [one.value for one in again] == [1 / 3, 2 / 3]
    assert again[1].low_90 is None and again[0].high_90 == predictions[0].high_90


def test_questions_may_be_toml_and_bats_may_lie_beside_them(tmp_path: Path, run: Run) -> None:
    code, bat, _ = run("show", "youth-30")
    assert code == 0
    (tmp_path / "q").mkdir()
    written(tmp_path / "q", "mine.toml", bat)
    text = '[[question]]\nid = "a"\nkind = "moment"\nimplement = "mine.toml"\n'
    text += '[[question]]\nid = "b"\nkind = "moment"\nimplement = "youth-30"\n'
    code, out, err = run("validate", "--sealed", str(written(tmp_path / "q", "q.toml", text)), "--json")
    assert code == 0, err
    mine, theirs = json.loads(out)["predictions"]
    assert mine["value"] == pytest.approx(theirs["value"], rel=1e-6)


def test_all_bad_questions_are_named_in_one_message(tmp_path: Path, run: Run) -> None:
    head = "id,kind,implement,bat_speed,unit"
    rows = "a,exit_sped,r161-ash,,", "b,carry,r161-ash,,", "c,tone,r161-ash,70mph,", "d,exit_speed,,,"
    code, _, err = run("validate", "--sealed", str(written(tmp_path, "q.csv", "\n".join([head, *rows]))))
    assert code == 2
    assert "a: kind 'exit_sped' is not known" in err
    assert "b: carry needs exit_speed and launch_angle" in err
    assert "c: tone takes no bat_speed" in err
    assert "d: exit_speed needs implement" in err
    more = "a,exit_speed,r161-ash,70,", "b,exit_speed,no-such-bat,,", "c,moment,youth-30,,kg"
    code, _, err = run("validate", "--sealed", str(written(tmp_path, "q.csv", "\n".join([head, *more]))))
    assert code == 2
    assert all(words in err for words in ("a: ", "bat_speed", "b: ", "no-such-bat", "c: unit"))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("name,kind\na,tone\n", "no line of headings with an id"),
        ("id\na\n", "it has no column kind"),
        ("id,kind\na,tone\na,node\n,tone\nb,\n", "the id 'a' is there twice.*line 4 has no id.*line 5 .b. has no kind"),
        ("id,kind,kind\na,tone,node\n", "the column kind is there twice"),
        ("id,kind\n", "has no rows"),
    ],
)
def test_a_bad_file_of_questions_is_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        read_questions(written(tmp_path, "q.csv", text))


def test_a_file_of_another_toml_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"tables \[\[question\]\]"):
        read_questions(written(tmp_path, "q.toml", 'name = "a bat"\n'))


def test_bad_predictions_and_measurements_are_refused(tmp_path: Path) -> None:
    text = "id,value,low_50,high_50,low_90,high_90\na,x,,,,\nb,1,,,2,3\nc,1,0,,,\n"
    with pytest.raises(InputError, match=r"a\) has value 'x'.*b\) has value 1 outside.*c\) has one end"):
        read_predictions(written(tmp_path, "p.csv", text))
    with pytest.raises(InputError, match=r"a\) has no value.*b\) has error -1"):
        read_measured(written(tmp_path, "m.csv", "id,value,error\na,,1\nb,2,-1\n"))


def test_a_score_of_what_was_not_predicted_is_refused() -> None:
    with pytest.raises(InputError, match="z was not predicted"):
        score_answer([prediction("a", 1.0)], [SealedMeasurement("z", 1.0, 0.0)], Path("m.csv"))
    mixed = [prediction("a", 1.0), prediction("b", 1.0, version="2")]
    with pytest.raises(InputError, match="several versions"):
        score_answer(mixed, [SealedMeasurement("a", 1.0, 0.0)], Path("m.csv"))


def test_questions_and_scores_are_not_asked_together(run: Run, tmp_path: Path) -> None:
    code, _, err = run("validate", "--sealed", "q.csv", "--score", "p.csv", "m.csv")
    assert code == 2 and "not both" in err


def test_nothing_is_written_when_a_question_is_refused(run: Run, tmp_path: Path) -> None:
    questions = written(tmp_path, "q.csv", "id,kind,implement\na,tone,youth-30\nb,tone,nothing\n")
    code, _, _ = run("validate", "--sealed", str(questions), "--out", str(tmp_path / "out"))
    assert code == 2 and not (tmp_path / "out").exists()


def test_every_kind_is_answered_with_intervals(tmp_path: Path, run: Run) -> None:
    rows = []
    for kind, of in SEALED_KINDS.items():
        rows.append(f"{kind},{kind}," + (",80mph,30deg" if "launch_angle" in of.needs else "youth-30,,"))
    questions = written(tmp_path, "q.csv", "\n".join(["id,kind,implement,exit_speed,launch_angle", *rows]))
    code, out, err = run("validate", "--sealed", str(questions), "--json")
    assert code == 0, err
    predictions = json.loads(out)["predictions"]
    assert [one["kind"] for one in predictions] == list(SEALED_KINDS)
    for one in predictions:
        assert one["low_90"] < one["low_50"] < one["value"] < one["high_50"] < one["high_90"], one["kind"]

"""Changed constants of the physics: every one can still be changed, and what rows notice is counted right."""

from __future__ import annotations

import ast
import json
import tomllib
from pathlib import Path

import pytest

from tools import evidence
from tools.evidence import Constant
from tools.mutants import PACKAGE

SLIP = "flight/batted_spin.py"


def test_every_constant_can_be_changed() -> None:
    every = evidence.constants()
    assert len({str(constant) for constant in every}) == len(every) > 300
    for file in {constant.file for constant in every}:
        text = (PACKAGE / file).read_text("utf-8")
        ours = [constant for constant in every if constant.file == file]
        now = evidence.changed(text, [(constant, 1.25) for constant in ours])
        if file.endswith(".py"):
            compile(now, file, "exec")
            continue
        before, after = tomllib.loads(text), tomllib.loads(now)
        for constant in ours:
            table, key = constant.name.split(".")
            values = [float(str(entries[table][key]["value"]).split()[0]) for entries in (before, after)]
            assert values[1] == pytest.approx(1.25 * values[0], rel=1e-8), constant


def test_a_part_of_a_constant_of_a_module_is_changed_alone() -> None:
    (line,) = [constant for constant in evidence.constants() if constant.name == "TRACKED.backspin.1"]
    text = (PACKAGE / SLIP).read_text("utf-8")

    def tracked(text: str) -> tuple[float, ...]:
        (node,) = [
            node.value
            for node in ast.parse(text).body
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "TRACKED"
        ]
        assert isinstance(node, ast.Call)
        arguments = {keyword.arg: keyword.value for keyword in node.keywords}
        return tuple(eval(ast.unparse(arguments["backspin"])))

    before, after = tracked(text), tracked(evidence.changed(text, [(line, 0.8)]))
    assert after == pytest.approx((before[0], 0.8 * before[1], before[2]))


def test_a_constant_that_is_gone_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("NO_SUCH", "SHEET.backspin.9", "SHEET.colour", "MIDDLE_ANGLE.0"):
        monkeypatch.setattr(evidence, "MODULES", {SLIP: (name,)})
        with pytest.raises(evidence.StaleError, match=name):
            evidence.constants()


def test_only_rows_that_held_notice_and_answers_are_measured_by_their_intervals() -> None:
    rows = evidence._rows()
    holding = next(name for name, row in rows.items() if not row.expected_miss and row.evidence in evidence.PUBLISHED)
    explained = next(name for name, row in rows.items() if row.expected_miss)
    inside, beyond = sum(rows[holding].allowed) / 2, rows[holding].allowed[1] + 1
    baseline = {holding: inside, explained: 1.0, "speed": 10.0, "place": 1.0}
    ends = {"speed": [8.0, 13.0], "place": [0.5, 1.5]}
    quiet = evidence.findings(baseline, baseline, ends)
    assert quiet == {"noticed": [], "refused": 0, "moved": None}
    loud = evidence.findings({holding: beyond, explained: 99.0, "speed": 13.0, "place": 0.25}, baseline, ends)
    assert loud == {"noticed": [holding], "refused": 0, "moved": (1.5, "place")}, "3 up is the half width of the speed"
    assert evidence.findings({holding: "InputError: no"}, baseline, ends)["refused"] == 1


def test_rows_of_one_printed_number_are_counted_once() -> None:
    names = [name for name in evidence._rows() if name.startswith("russell_batvibes: mlb-")]
    tones = [name for name in names if name.endswith("frequency of mode 1")]
    assert len(tones) > 2
    counted = evidence._counted({"noticed": tones, "refused": 0, "moved": None})
    assert counted["rows"] == len(tones)
    assert counted["bats"] == ["russell_batvibes: 170 Hz"]
    assert counted["others"] == counted["fitted"] == []


def test_a_changed_shear_modulus_moves_the_tones_of_wood(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The whole way, with two items: a copy of the package, a warm process, the changed file, what was read."""
    monkeypatch.setattr(evidence, "WORK", tmp_path)
    laboratory = evidence.Laboratory(1, cold=False)
    (stiffness,) = [one for one in evidence.constants() if one.name == "white_ash.longitudinal_modulus"]
    names = ["tone, r161-ash", "carry, 100 mph at 28 deg"]
    try:
        before = laboratory.computed([], names)
        after = laboratory.computed([(stiffness, 1.25)], names)
        again = laboratory.computed([], names)
    finally:
        laboratory.close()
    assert again == before
    assert after[names[1]] == before[names[1]]
    assert 1.08 < after[names[0]] / before[names[0]] < 1.25**0.5, "softened by shear, so less than by the square root"


def test_what_is_saved_is_of_nearly_all_constants_that_there_are() -> None:
    """`make evidence` writes it; when more than a tenth of the constants are new or have gone, it is out of date."""
    saved = json.loads(evidence.SAVED.read_text("utf-8"))
    assert saved["measured"]["command"] == evidence.COMMAND
    measured = {(one["file"], one["name"]) for one in saved["constants"]}
    now = {(constant.file, constant.name) for constant in evidence.constants()}
    assert len(measured ^ now) < 0.1 * len(now), "run make evidence"
    for constant in saved["constants"]:
        assert len(constant["found"]) == len(evidence.FACTORS)
        for found in constant["found"]:
            assert found["rows"] >= len([*found["bats"], *found["others"], *found["fitted"]])


def test_constants_are_things_of_one_place() -> None:
    constant = Constant("catalog/balls.toml", "baseball.mass", "5.125", 10, 15)
    assert evidence.changed("mass = { 0 5.125 oz }"[:10] + "5.125 oz", [(constant, 2.0)]).endswith("10.25 oz")

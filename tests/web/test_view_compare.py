"""The comparison's answers: those of the library, with intervals, verdict and rules; and its lines."""

from __future__ import annotations

import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.analysis.comparison import compare
from sweetspot.answers.compare import compare_of
from sweetspot.answers.records import to_dict
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.dynamics.rigid import OF_SWING
from sweetspot.numerics.interval import REACH, interval_of
from sweetspot.reports.comparison.words import changes
from sweetspot.web.errors import FieldError
from sweetspot.web.views import compare as compare_view
from sweetspot.web.views.compare import VIEW, rules_sure, sure
from sweetspot.web.views.compare_state import CompareState


def answer(state: CompareState) -> dict[str, Any]:
    return to_dict(compare_view.answer(state))


def intervals(state: CompareState) -> dict[str, Any]:
    return to_dict(compare_view.intervals(state))


def rules(state: CompareState) -> list[dict[str, Any]]:
    return [to_dict(bat) for bat in compare_view.rules(state).certification]


def asked(**controls: Any) -> dict[str, Any]:
    return answer(CompareState.model_validate(controls))


def test_it_is_the_librarys_comparison() -> None:
    bats = [catalog.bat("r161-ash"), catalog.bat("russell-b6")]
    expected = compare(bats, conditions=standard_conditions(bats[0]), law=catalog.swing_law())
    found = asked(others=[{"bat": "russell-b6"}])
    assert found["verdict"]["us"] == [str(sentence) for sentence in changes(compare_of(expected))]
    for row, one in zip(found["bats"], expected.compared, strict=True):
        assert row["exit_speed_m_s"]["value"] == pytest.approx(one.exit_speed.value, rel=1e-12)
        assert row["change_m_s"]["value"] == pytest.approx(one.change.value, abs=1e-12)


@pytest.mark.parametrize(
    "controls",
    [
        {},
        {"bat": "mlb-a", "pitch_speed_mph": 88.0, "bat_speed_mph": 69.0},
        {"what_if": "cork", "same": "speed"},
        {"what_if": "change", "bat": "slow-pitch", "change": "rolled"},
        {"others": [{"bat": "youth-30"}]},
    ],
)
def test_its_verdict_is_the_command_s(controls: dict[str, Any], run_json: Callable[..., Any]) -> None:
    """Nothing is a gain or a loss by a part of the doubt: until the whole is there nothing is said of it."""
    state = CompareState.model_validate(controls)
    assert VIEW.recipe is not None
    expected = run_json(*shlex.split(VIEW.recipe(state)["command"].splitlines()[0])[1:])
    first, found = answer(state), intervals(state)
    signs = str.maketrans("\N{MINUS SIGN}", "-")
    assert [one.translate(signs) for one in found["verdict"]["us"]] == expected["verdict"]
    for row, bare, one in zip(found["bats"], first["bats"], expected["bats"], strict=True):
        assert row["change_m_s"] == pytest.approx(one["change_m_s"], abs=0.005)  # 69 mph is written to a mile per hour
        for name in ("bat_speed_m_s", "exit_speed_m_s", "change_m_s"):
            assert row[name]["value"] == pytest.approx(one[name]["value"], abs=1e-8)
            assert bare[name]["low"] == bare[name]["value"] == bare[name]["high"]
    words = " ".join(first["verdict"]["us"])
    assert not any(judged in words for judged in ("gain", "loss", "sure", "(", "corking"))


def test_one_bat_alone_has_nothing_to_be_judged() -> None:
    assert "Choose another bat" in intervals(CompareState(others=()))["verdict"]["us"][0]


def test_a_moment_of_inertia_that_was_not_measured_has_its_interval() -> None:
    ash, metal = (row["bat"] for row in asked(others=[{"bat": "russell-b6"}])["bats"])
    assert ash["moi_6in_half_kg_m2"] == pytest.approx(REACH * OF_SWING * ash["moi_6in_kg_m2"])
    assert metal["moi_6in_half_kg_m2"] == 0


def test_corking_is_answered_in_both_systems() -> None:
    state = CompareState(what_if="cork", hole_depth_in=10.0)
    found = intervals(state)
    assert [row["label"] for row in answer(state)["bats"]] == [
        "R161, white ash",
        *(f"R161, white ash, {made}" for made in ("drilled", "cork", "rubber", "foam")),
    ]
    assert any("Does corking help?" in text and " oz lighter" in text for text in found["verdict"]["us"])
    assert any("Does corking help?" in text and " g lighter" in text for text in found["verdict"]["si"])
    assert not any("mph faster" in text for text in found["verdict"]["si"])
    assert found["bats"][2]["change_m_s"]["high"] < 0  # cork loses, surely


def test_a_thinner_wall_takes_more_energy() -> None:
    found = asked(what_if="wall", bat="russell-b6", wall_times=0.85)
    own, thin = (row["wall"] for row in found["bats"])
    assert thin["thickness_m"] == pytest.approx(0.85 * own["thickness_m"], rel=0.02)  # best places differ a little
    assert thin["energy_share"] > own["energy_share"] and thin["hoop_frequency_hz"] < own["hoop_frequency_hz"]
    assert "the thinner wall is the livelier one" in found["verdict"]["us"][-1]


def test_rules_are_held_against_every_bat() -> None:
    found = rules(CompareState.model_validate({"others": [{"bat": "russell-b6"}], "league": "ncaa"}))
    first, metal = ({check["quantity"]: check["verdict"] for check in row["checks"]} for row in found)
    assert first["bbcor"] == "does not apply" and metal["bbcor"] == "fail"  # one piece of wood is exempt
    everyone = rules(CompareState(others=(), league="all"))
    leagues = {check["league"] for check in everyone[0]["checks"]}
    assert {"mlb", "ncaa", "usssa", "softball"} <= leagues


def test_one_bat_alone_is_no_fault() -> None:
    found = asked(others=[])
    assert len(found["bats"]) == 1 and "Choose another bat" in found["verdict"]["us"][0]


def test_the_same_bat_twice_has_two_names() -> None:
    assert [row["label"] for row in asked(others=[{}])["bats"]] == ["R161, white ash", "R161, white ash (2)"]


@pytest.mark.parametrize(
    ("controls", "field", "words"),
    [
        ({"others": [{"bat": "rosewood"}]}, "others.0.bat", "bat 2: bat 'rosewood' is not in the catalogue"),
        ({"what_if": "wall"}, "what_if", "is solid and has no wall"),
        ({"what_if": "cork", "hole_diameter_in": 2, "hole_depth_in": 20}, "hole_diameter_in", "make it narrower"),
        ({"what_if": "change", "change": "rolled"}, "change", "solid and has no wall"),
        ({"league": "sandlot"}, "league", "not in the catalogue"),
        ({"swing_law": "cricket"}, "swing_law", "not in the catalogue"),
    ],
)
def test_faults_name_their_control(controls: dict[str, Any], field: str, words: str) -> None:
    with pytest.raises(FieldError, match=words) as caught:
        asked(**controls)
    assert caught.value.field == field


@pytest.mark.parametrize(
    "controls",
    [
        {"others": [{"bat": "youth-30", "choke_up_in": 1.0}], "bat_speed_mph": 66.0},
        {"what_if": "cork", "hole_depth_in": 1.5, "same": "speed"},
        {"what_if": "wall", "bat": "russell-b6"},
        {"what_if": "change", "bat": "composite", "change": "rolled, end-load 1oz"},
    ],
)
def test_python_lines_give_the_same_numbers(
    controls: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    state = CompareState.model_validate(controls)
    assert VIEW.recipe is not None
    lines = VIEW.recipe(state)
    for name, text in lines.items():
        if name.endswith("toml"):
            (tmp_path / ("bat.toml" if name == "toml" else name)).write_text(text, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    names: dict[str, Any] = {}
    exec(lines["python"], names)
    shown = [interval_of(bat.exit_speed).value for bat in names["compare"].bats]
    expected = [row["exit_speed_m_s"]["value"] for row in answer(state)["bats"]]
    assert shown == pytest.approx(expected, rel=1e-6)
    assert lines["command"].startswith("sweetspot compare ") and "sweetspot certify " in lines["command"]


def test_the_command_line_gives_the_same_numbers(run_json: Callable[..., Any]) -> None:
    state = CompareState.model_validate({"what_if": "cork", "hole_depth_in": 8, "pitch_speed_mph": 80})
    assert VIEW.recipe is not None
    rows = run_json(*shlex.split(VIEW.recipe(state)["command"].splitlines()[0])[1:])["bats"]
    for row, expected in zip(rows, answer(state)["bats"], strict=True):
        # a bat changed on the page comes from the compiled kernels, which round otherwise
        assert row["change_m_s"]["value"] == pytest.approx(expected["change_m_s"]["value"], abs=1e-8)


def test_how_sure_a_comparison_and_its_tests_are() -> None:
    state = CompareState.model_validate({"others": [{"bat": "torpedo"}]})
    told = sure(state).html["us"]
    assert "probability" in told and "swing law" in told and "±" in told
    hollow = CompareState.model_validate({"bat": "college-alloy", "others": [{"bat": "russell-b6"}]})
    tests = rules_sure(hollow).html["us"]
    assert tests.count("keeps the limit on BBCOR") == 2
    assert 'id="how-sure-1"' in tests and 'id="how-sure-2"' in tests, "no anchor stands twice on a page"

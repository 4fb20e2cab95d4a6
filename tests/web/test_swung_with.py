"""A bat changed on the page is swung with the same effort as before or at the same speed, and views say which."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Page, expect

from sweetspot.answers.records import to_dict
from sweetspot.units import MPH
from sweetspot.web.views import VIEWS, compare, explorer, flight
from sweetspot.web.views.compare_state import CompareState
from sweetspot.web.views.flight_state import FlightState
from tests.web.parts import Answered, visit

CHANGES: list[dict[str, Any]] = [
    {"mass_oz": 36.0}, {"mass_oz": 28.0}, {"bore_diameter_in": 1.0}, {"cup_diameter_in": 1.2}, {"weight_oz": 2.0},
    {"choke_up_in": 1.0}, {"bat": "russell-b6", "wall_factor": 0.9},
]  # fmt: skip


def explored(**controls: Any) -> dict[str, Any]:
    return to_dict(explorer.answer(explorer.ExplorerState.model_validate(controls)))


@pytest.mark.parametrize("change", CHANGES, ids=str)
def test_a_changed_bat_is_swung_as_compare_swings_it(change: dict[str, Any]) -> None:
    """With the bat as it was as bat 1, the comparison says the same of the changed one.

    Each steps through its hits in its own way, within 1e-4 of the converged exit speed.
    """
    bat = change.get("bat", "r161-ash")
    beside = CompareState.model_validate({"bat": bat, "others": [{"bat": bat, **change}]})
    _, other = to_dict(compare.answer(beside))["bats"]
    found = explored(**change)
    assert found["conditions"]["bat_speed_m_s"] == pytest.approx(other["bat_speed_m_s"]["value"], rel=1e-7)
    assert found["best_exit_speed_m_s"] == pytest.approx(other["exit_speed_m_s"]["value"], rel=2e-4)
    words = found["bat"]["swung"]["us"]
    assert "with the same effort as before the change" in words
    assert f"{other['bat_speed_m_s']['value'] / MPH:.1f}" in words
    same = explored(**change, same="speed")
    assert same["conditions"]["bat_speed_m_s"] == pytest.approx(70 * MPH, rel=1e-12)
    assert "at the same speed as before the change" in same["bat"]["swung"]["us"]


def test_weight_is_no_gift_and_choking_up_is_not_free() -> None:
    """5 oz more were 4.7 mph more, and an inch up the handle nothing."""
    whole, heavy, held = (
        explored(**change)["best_exit_speed_m_s"] / MPH for change in ({}, {"mass_oz": 36.0}, {"choke_up_in": 1.0})
    )
    assert heavy - whole == pytest.approx(1.3, abs=0.2)
    assert held - whole == pytest.approx(-1.1, abs=0.2)


def test_a_bat_as_it_is_says_nothing_of_it() -> None:
    assert explored()["bat"]["swung"] is None
    assert explored(bat="russell-b6")["bat"]["swung"] is None
    assert "with the same effort" in explored(bat="corked-r161")["bat"]["swung"]["us"]  # R161 drilled, by its own file


def test_what_a_file_says_was_changed_counts_too() -> None:
    """A bat that was drilled here, kept as a file and brought again, is the same bat in the same hands."""
    lines = explorer.recipe(explorer.ExplorerState(bore_diameter_in=1.0, choke_up_in=0.5))
    here, there = explored(bore_diameter_in=1.0, choke_up_in=0.5), explored(bat_toml=lines["toml"])
    assert there["conditions"]["bat_speed_m_s"] == pytest.approx(here["conditions"]["bat_speed_m_s"], rel=1e-9)


def test_every_view_with_a_swing_has_the_switch() -> None:
    with_speed = {name for name, view in VIEWS.items() if "bat_speed_mph" in view.state.model_fields}
    assert {"explorer", "hit", "flight", "optimum", "compare", "modes"} <= with_speed
    assert all("same" in VIEWS[name].state.model_fields for name in with_speed)


@pytest.mark.parametrize("same", ["effort", "speed"])
@pytest.mark.parametrize("change", [{"mass_oz": 36.0, "choke_up_in": 1.0}, {"weight_oz": 2.0}])
def test_the_copied_commands_agree(
    same: str, change: dict[str, Any], run_json: Callable[..., Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)

    def told(lines: dict[str, str]) -> Any:
        for name, text in lines.items():
            if name.endswith("toml"):
                Path("bat.toml" if name == "toml" else name).write_text(text, encoding="utf-8")
        return run_json(*shlex.split(lines["command"].splitlines()[0])[1:])

    drilled = CompareState.model_validate({"bat": "corked-r161", "same": same})
    first = told(compare.recipe(drilled))["bats"][0]["bat_speed_m_s"]["value"]
    assert first == pytest.approx(to_dict(compare.answer(drilled))["bats"][0]["bat_speed_m_s"]["value"], rel=1e-9)
    side_by_side = CompareState.model_validate({**change, "same": same})
    found = told(compare.recipe(side_by_side))
    for row, expected in zip(found["bats"], to_dict(compare.answer(side_by_side))["bats"], strict=True):
        assert row["exit_speed_m_s"]["value"] == pytest.approx(expected["exit_speed_m_s"]["value"], rel=1e-6)
    state = FlightState.model_validate({**change, "same": same, "start": "swing", "offset_in": 0.5})
    played = told(flight.recipe(state))
    assert played["flight"]["carry_m"] == pytest.approx(to_dict(flight.answer(state))["flight"]["carry_m"], rel=1e-4)


def test_choking_up_says_what_it_costs(page: Page, server: str, answered: Answered) -> None:
    page.goto(f"{server}/explorer")
    count = answered(page)
    switch = page.locator("[data-field=same]")
    expect(switch).to_be_hidden()
    expect(page.locator("#swung")).to_be_hidden()
    page.goto(f"{server}/explorer?choke_up_in=1")
    count = answered(page)
    expect(page.locator("#swung")).to_contain_text("with the same effort as before the change, at 69.0")
    switch.locator("select").select_option("speed")
    answered(page, count)
    expect(page.locator("#swung")).to_contain_text("at the same speed as before the change")
    assert re.search("same=speed", page.url)
    visit(page, "flight")
    answered(page)
    assert re.search("same=speed", page.url)

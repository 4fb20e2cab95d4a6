"""A bat that was changed or is choked up: swung with the same effort as before, or at the same speed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.write import bat_toml
from sweetspot.units import INCH, MPH, OUNCE

RunJson = Callable[..., Any]
Run = Callable[..., tuple[int, str, str]]


@pytest.fixture
def choked(tmp_path: Path) -> str:
    path = tmp_path / "choked.toml"
    path.write_text(bat_toml(catalog.bat("youth-30").choked_up(1 * INCH)), encoding="utf-8")
    return str(path)


@pytest.mark.parametrize("asked", [("report",), ("hit", "--at", "6in-from-tip"), ("play",)])
def test_choking_up_costs_bat_speed_and_says_so(
    choked: str, asked: tuple[str, ...], run_json: RunJson, run: Run
) -> None:
    name, *more = asked
    found = run_json(name, choked, *more, "--bat-speed", "50mph")
    assert found["swung_with"]["same"] == "effort"
    assert found["swung_with"]["bat_speed_m_s"] / MPH == pytest.approx(49.0, abs=0.1)
    assert found["swung_with"]["bat_speed_before_m_s"] / MPH == pytest.approx(50.0)
    same = run_json(name, choked, *more, "--bat-speed", "50mph", "--same-speed")
    assert same["swung_with"] == {"same": "speed", "bat_speed_m_s": 50 * MPH, "bat_speed_before_m_s": 50 * MPH}
    words = " ".join(run(name, choked, *more, "--bat-speed", "50mph")[1].split())
    assert "swung with the same effort as before the change, at 49.0 mph in place of 50.0 mph" in words
    words = " ".join(run(name, choked, *more, "--bat-speed", "50mph", "--same-speed")[1].split())
    assert "at the same speed as before the change, 50.0 mph; with the same effort it would move at 49.0 mph" in words


def test_a_weight_on_the_barrel_is_swung_slower(tmp_path: Path, run_json: RunJson) -> None:
    bat = catalog.bat("r161-ash")
    path = tmp_path / "weighted.toml"
    path.write_text(bat_toml(bat.weighted(position=bat.length - 2 * INCH, mass=2 * OUNCE)), encoding="utf-8")
    plain, effort = (run_json("hit", name, "--at", "6in-from-tip") for name in ("r161-ash", str(path)))
    speed = run_json("hit", str(path), "--at", "6in-from-tip", "--same-speed")
    assert effort["bat_speed_m_s"] < plain["bat_speed_m_s"] - 1 * MPH
    assert speed["bat_speed_m_s"] == pytest.approx(plain["bat_speed_m_s"], rel=1e-12)
    assert "swung_with" not in plain


def test_the_comparison_with_the_bat_as_it_was_says_the_same(choked: str, run_json: RunJson) -> None:
    """The first bat of a comparison is the one that the swing is known with, changed or not."""
    other = run_json("compare", "youth-30", choked)["bats"][1]
    alone = run_json("report", choked)["swung_with"]["bat_speed_m_s"]
    assert other["change_m_s"]["value"] < 0 and other["bat_speed_m_s"]["value"] == pytest.approx(alone, rel=1e-9)
    first = run_json("compare", choked, "youth-30", "--bat-speed", "50mph")["bats"]
    own, whole = (row["bat_speed_m_s"]["value"] for row in first)
    assert own == pytest.approx(50 * MPH) and own < whole

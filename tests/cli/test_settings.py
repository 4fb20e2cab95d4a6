"""What somebody wants whenever nothing else is said: units and the own bat, from a small file."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sweetspot.cli.settings import PLACE, Settings, read_settings, settings_file

Run = Callable[..., tuple[int, str, str]]


def written(folder: Path, text: str, monkeypatch: pytest.MonkeyPatch) -> Path:
    path = folder / "config.toml"
    path.write_text(text, encoding="utf-8")
    monkeypatch.setenv(PLACE, str(path))
    return path


def test_units_and_bat_hold_where_nothing_else_is_said(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "own.toml").write_text('like = "youth-30"\nname = "the own one"\n', encoding="utf-8")
    written(tmp_path, 'units = "metric"\nbat = "own.toml"\n', monkeypatch)
    _, out, _ = run("hit", "--at", "tip")
    assert out.startswith("the own one") and "cm from the tip" in out and "mph" not in out
    _, out, _ = run("hit", "r161-ash", "--at", "tip", "--units", "imperial")
    assert out.startswith("R161") and "mph" in out


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ('unit = "metric"', "Did you mean units?"),
        ('units = "furlongs"', 'allowed is "metric" or "imperial"'),
        ("bat = 3", "a name of the catalogue or a file in quotes"),
        ("units = ", "is not valid TOML"),
    ],
)
def test_settings_that_mean_nothing_are_refused(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str, told: str
) -> None:
    path = written(tmp_path, text, monkeypatch)
    code, out, err = run("bats")
    assert (code, out) == (2, "") and told in err and str(path) in err


def test_there_need_be_no_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(PLACE, str(tmp_path / "none.toml"))
    assert read_settings() == Settings()
    monkeypatch.delenv(PLACE)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert settings_file() == tmp_path / "sweetspot" / "config.toml"

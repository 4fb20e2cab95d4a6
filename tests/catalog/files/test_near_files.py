"""A file's name with a slip is answered with the file that was meant."""

from __future__ import annotations

from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.catalog.entries import entry_toml
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import near_file, read_text


@pytest.mark.parametrize("slip", ["my-bat.tml", "my-bat", "my_bat", "my-bta.toml", "mybat.toml", "My-Bat.toml.txt"])
def test_a_bat_file_that_was_meant_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, slip: str) -> None:
    (tmp_path / "my-bat.toml").write_text(entry_toml("r161-ash"))
    (tmp_path / "shots.csv").write_text("")
    monkeypatch.chdir(tmp_path)
    for load in (catalog.load_bat, catalog.load_implement):
        with pytest.raises(InputError, match=r"Did you mean (the file )?my-bat\.toml\?"):
            load(slip)
    assert catalog.load_bat("r161-ash").name == "R161, white ash"


def test_what_is_like_no_file_is_not_guessed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "my-bat.toml").write_text("")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match=r"Did you mean r161-ash or corked-r161\?"):
        catalog.load_bat("r161")
    assert near_file(tmp_path / "nothing" / "my-bat.toml") is None and near_file(Path("x" * 5000)) is None
    with pytest.raises(InputError, match=r"no such file or directory$"):
        read_text(Path("shots.csv"), most=10, advice="")

"""Descriptions nobody measured: absurd sizes, bombs, names that are commands. Each is refused in few words."""

from __future__ import annotations

from pathlib import Path

import pytest

from sweetspot import catalog
from sweetspot.catalog.files.bat import read_toml, table_of_text
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.records import Entry, TomlTable
from sweetspot.errors import InputError

BAT = {"name": "bat", "length": "33 in", "material": "white ash", "profile": [["0 in", "1 in"], ["33 in", "2.5 in"]]}
SHELL = {"wall": [["0 in", "2.5 mm"], ["33 in", "2.5 mm"]]}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"kind": ["racket"]}, "not known"),
        ({"kind": "x" * 100_000}, "not known"),
        ({"name": ""}, "is empty"),
        ({"name": "  "}, "blanks"),
        ({"name": "x" * 100_000}, "at most 100"),
        ({"name": "\x1b[31mred\x1b]0;title\x07"}, "control"),
        ({"name": "turned \u202e round"}, "control"),
        ({"name": "two\nlines"}, "control"),
        ({"shell": {**SHELL, "end_cap_mass": "1e214 g"}}, "beyond anything"),
        ({"length": "1e195 mm"}, "beyond anything"),
        ({"profile": [["0 in", "1e-308 m"], ["33 in", "2.5 in"]]}, "beyond anything"),
        ({"mass": "1e-300 kg"}, "beyond anything"),
        ({f"key{number}": number for number in range(90_000)}, "and 89995 more"),
        ({"profile": [[f"{33 * part / 20_000:.6f} in", "2 in"] for part in range(20_001)]}, "up to 150"),
    ],
)
def test_absurd_bats(changes: TomlTable, said: str) -> None:
    with pytest.raises(InputError, match=said) as caught:
        implement_from_table({**BAT, **changes}, "bat.toml")
    assert len(str(caught.value)) < 1000


def test_names_of_all_scripts_are_welcome() -> None:
    for name in ("Louisville Slugger 125 (2019)", "棒", "بیس‌بال", "été", "o'Neil & <b>"):
        assert implement_from_table({**BAT, "name": name}, "bat.toml").name == name


@pytest.mark.parametrize(
    "text",
    [
        ".".join("a" * 5_000) + " = 1",
        " . ".join(['"a"'] * 5_000) + " = 1",
        "[" + ".".join("b" * 5_000) + "]",
        "x = " + "[" * 100_000,
        "name = " + "9" * 100_000,
    ],
)
def test_bombs_of_toml(text: str) -> None:
    with pytest.raises(InputError) as caught:
        table_of_text(text, "bat.toml")
    assert len(str(caught.value)) < 500


def test_dots_that_are_no_bomb() -> None:
    text = "note = '" + "It was so. " * 100 + "'\n# " + ". " * 100 + "\nnumbers = [" + "0.5, " * 500 + "]"
    assert Entry("file", table_of_text(text, "bat.toml")).numbers("numbers") == [0.5] * 500


def test_files_that_are_none(tmp_path: Path) -> None:
    for name in ("x" * 2000, "x" * 2000 + ".toml", "a\0b", str(tmp_path), "/dev/zero", "/dev/null/x.toml"):
        with pytest.raises(InputError) as caught:
            catalog.load_implement(name)
        assert len(str(caught.value)) < 500
    large = tmp_path / "large.toml"
    large.write_bytes(b"#" * 250_001)
    with pytest.raises(
        InputError, match=r"^\S+large.toml is larger than 0.25 MB; a bat file is TOML text of a few lines$"
    ):
        read_toml(large)

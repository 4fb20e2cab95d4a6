"""Slips of units in files are noticed part by part; what is meant can be insisted on."""

from __future__ import annotations

import pytest

from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import Entry, TomlTable, TomlValue
from sweetspot.errors import InputError
from sweetspot.plausibility import insisting


@pytest.mark.parametrize(
    ("name", "path", "text", "said"),
    [
        ("tennis-racket", ("head", "width"), "2.5 cm", "head.width was given as 2.5 cm; usual is 12 to 35 cm"),
        ("golf-driver", ("head", "mass"), "2 kg", "head.mass was given as 2 kg; usual is 0.1 to 0.5 kg"),
        ("r161-ash", ("turned", "value", "handle"), "1.01 cm", "turned.handle was given as 1.01 cm; usual is 1.52 to"),
        ("two-piece", ("shell", "value", "joint"), "15.5 cm", "joint was given as 0.18 of the length"),
        ("table-tennis-racket", ("blade_width",), "150 cm", "blade_width was given as 150 cm"),
    ],
)
def test_the_message_says_what_is_usual(name: str, path: tuple[str, ...], text: str, said: str) -> None:
    tables = {name: dict(implement_tables()[name])}
    table = _with(tables[name], path, text)
    with pytest.raises(InputError, match="Check the unit and the decimal point, or add --force"):
        implement_from_table(table, "mine.toml")
    with pytest.raises(InputError, match=said):
        implement_from_table(table, "mine.toml")


def test_who_insists_is_believed() -> None:
    table = _with(implement_tables()["golf-driver"], ("head", "mass"), "600 g")
    with insisting():
        assert implement_from_table(table, "mine.toml").length > 1


def _with(table: TomlTable, path: tuple[str, ...], text: str) -> dict[str, TomlValue]:
    head, *rest = path
    return {**table, head: _with(Entry("", table).table(head), tuple(rest), text) if rest else text}

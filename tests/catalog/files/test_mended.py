"""A line that is no TOML yet is shown as it may be written, and what is shown can be read."""

from __future__ import annotations

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sweetspot.catalog.files.bat import table_of_text
from sweetspot.catalog.files.mended import fault_of
from sweetspot.errors import InputError


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("length = 33in", 'line 1: sizes and names stand in quotes; write length = "33in"'),
        ('name = "x"\nlike = college-alloy  # mine', 'line 2: sizes and names stand in quotes; write like = "college'),
        ("like = \u201cr161-ash\u201d", "quotes are curly, as word processors write them, and must be straight"),
        ("mass: 31 oz", 'line 1: sizes and names stand in quotes; write mass = "31 oz"'),
        ('mass: "31 oz"', 'line 1: a key and its value are joined by =; write mass = "31 oz"'),
        ('mass = "31 oz', 'one at each end; write mass = "31 oz"'),
        ('profile = [["0 in", "1 in"], [33 in, 2.5 in]]', '["33 in", "2.5 in"]]'),
        ("{\\rtf1\\ansi", "save it as plain text"),
    ],
)
def test_the_mended_line_is_shown(text: str, told: str) -> None:
    with pytest.raises(InputError) as refused:
        table_of_text(text, "mine.toml")
    assert told in str(refused.value) and str(refused.value).startswith("mine.toml")


def test_what_cannot_be_mended_is_told_as_the_reader_of_toml_does() -> None:
    with pytest.raises(InputError, match=r"mine\.toml is not valid TOML"):
        table_of_text("= = =", "mine.toml")


@given(st.text(alphabet="abc= \"'[]{}#:.,0123456789\n\u201c\u201d", max_size=60))
def test_any_text_is_read_or_refused_in_one_sentence(text: str) -> None:
    try:
        tomllib.loads(text)
    except ValueError as error:
        reason = fault_of(text, error)
        assert "\n" not in reason

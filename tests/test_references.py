"""The bibliography: our own file read whole, and said in one line."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

import sweetspot
from sweetspot.errors import InputError
from sweetspot.references import cite, keys, parse_bibliography, reference

ROOT = Path(sweetspot.__file__).parent


def test_every_source_has_a_line_and_says_how_it_was_read() -> None:
    assert len(keys()) == len(set(keys())) > 50
    for key in keys():
        line = cite(key)
        assert line
        assert line.endswith((".", "?", "!"))
        assert not re.search(r"[{}\\\n]|  |\.\.", line), line
        assert reference(key).note, f"{key} does not say how it was read"
        link = reference(key).link
        assert link is None or link.startswith(("http://", "https://"))


def test_authors_bodies_years_and_letters() -> None:
    assert cite("nathan2003") == (
        "Nathan, A. M. (2003). Characterizing the performance of baseball bats. "
        "American Journal of Physics 71(2), 134\N{EN DASH}143."
    )
    assert cite("wsu_glossary").startswith("Sports Science Laboratory, Washington State University. Glossary")
    assert cite("cross2006").startswith("Cross, R. and Nathan, A. M. (2006).")
    assert cite("umass2022") == "Applied Sciences 12(7), 3494, 2022."
    assert cite("schroeder2023").startswith("Schr\N{LATIN SMALL LETTER O WITH DIAERESIS}der, T., Lindenmann, A. and")
    assert reference("cowper1966").link == "https://doi.org/10.1115/1.3625046"
    assert reference("cross2006").link == "https://arxiv.org/abs/physics/0605040"


def test_an_unknown_key_names_the_nearest() -> None:
    with pytest.raises(InputError, match="nathan2003"):
        cite("nathan203")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("@misc{a,\n  title = {x},\n}\n@misc{a,\n  title = {y},\n}\n", "twice"),
        ("@misc{a,\n  title = x,\n}\n", "not one line"),
        ("@misc{a,\n  title = {x}}\n", "does not end"),
    ],
)
def test_a_file_written_otherwise_is_refused(text: str, message: str) -> None:
    with pytest.raises(InputError, match=message):
        parse_bibliography(text)

"""The documentation's list of our choices has every number that the program marks as ours."""

from __future__ import annotations

import importlib.util
import io
import re
import tokenize
from pathlib import Path
from types import ModuleType

import pytest

from tests.documented import DOCS

MARKED = re.compile(r"our choice|\(assumed|[(\[](?:both )?recalled", re.IGNORECASE)


@pytest.fixture(scope="module")
def choices() -> ModuleType:
    spec = importlib.util.spec_from_file_location("choices", DOCS / "choices.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_choices_are_listed_with_their_values_and_reasons(choices: ModuleType) -> None:
    found = {(choice.module, choice.name): choice for choice in choices.choices()}
    wall = found["catalog.bats", "WALL_DOUBT"]
    assert (wall.value, wall.kind) == ("0.1", "our choice") and wall.words.endswith("no maker publishes one.")
    assert found["equipment.material", "DEFAULT_POISSON"].kind == "assumed"
    assert all(choice.name and len(choice.words) > 20 for choice in found.values())
    assert len(choices.choices_page().splitlines()) == len(choices.choices()) + 2 > 100


def test_every_mark_in_the_program_is_read(choices: ModuleType) -> None:
    """A comment is none of the places that the list is read from, nor is a text inside an expression."""
    unread = []
    for path in sorted(Path(choices.PACKAGE).rglob("*.py")):
        text = path.read_text(encoding="utf-8")
        if MARKED.search(text):
            comments = tokenize.generate_tokens(io.StringIO(text).readline)
            unread += [
                f"{path.name}: {token.string}"
                for token in comments
                if token.type == tokenize.COMMENT and MARKED.search(token.string)
            ]
    assert not unread, "say it in the text behind the constant"


def test_a_planted_choice_is_found(choices: ModuleType, tmp_path: Path) -> None:
    (tmp_path / "new.py").write_text('A, B = 1.5, 2\n"""m, of both [our choice]: nothing is wider."""\n')
    assert [tuple(choice) for choice in choices.choices(tmp_path)] == [
        ("new", "A, B", "(1.5, 2)", "our choice", "m, of both: nothing is wider.")
    ]

"""Generated inputs: an answer in finite numbers or a refusal; and every input that once broke something."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[2]))

from sweetspot.errors import InputError
from tests.fuzz import generators
from tests.fuzz.generators import KINDS, text_of

CORPUS = Path(__file__).parent / "corpus"
COUNT, OF_FILES = 2000, 800
"""Inputs of each kind, and of those that are written as files; `make fuzz` goes on, and looks for slow ones too."""
MESSAGE = 1500


def check(kind: str, text: str) -> None:
    try:
        KINDS[kind].take(text)
    except InputError as error:
        assert 0 < len(str(error)) < MESSAGE


@pytest.mark.parametrize("kind", KINDS)
def test_generated_inputs(monkeypatch: pytest.MonkeyPatch, kind: str) -> None:
    monkeypatch.setattr(generators, "MODES_EVERY", 10)
    for number in range(OF_FILES if kind in ("swings", "shots") else COUNT):
        try:
            check(kind, text_of(kind, number))
        except Exception as error:
            error.add_note(f"{kind} {number}: {text_of(kind, number)[:500]}")
            raise


@pytest.mark.parametrize("path", sorted(CORPUS.glob("*.json")), ids=lambda path: path.stem)
def test_what_once_broke_something(path: Path) -> None:
    kept = json.loads(path.read_text(encoding="utf-8"))
    check(kept["kind"], kept["text"])

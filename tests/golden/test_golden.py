"""Numbers that changed: what every command answered is kept, and a change needs `make golden` and a reason.

Golden, not true: these numbers are the program's own. Whether they are right is for the other tests to say.
"""

from __future__ import annotations

import json

import pytest

from tests.golden.commands import FOLDER, Answer, answer, commands, differences, file_of

TOLERANCE = 2e-3
"""Of each value. Other processors and libraries round otherwise, and where a light implement touches the ball twice
that grows to several 1e-4; on one machine `make golden-check` compares at 1e-9."""


@pytest.mark.parametrize("command", commands())
def test_the_numbers_are_the_kept_ones(command: str) -> None:
    kept = json.loads(file_of(command).read_text(encoding="utf-8"))
    changed = differences(kept, answer(command), tolerance=TOLERANCE)
    assert not changed, "\n".join(changed[:20])


def test_nothing_is_kept_that_is_not_asked() -> None:
    assert {file_of(command) for command in commands()} == set(FOLDER.glob("*.json"))


def test_a_change_is_seen() -> None:
    kept: Answer = {"speed": 46.0, "word": "home run", "gone": 1.0}
    assert len(differences(kept, {"speed": 46.001, "word": "out", "new": 2.0}, tolerance=1e-6)) == 4
    assert not differences(kept, dict(kept), tolerance=1e-9)

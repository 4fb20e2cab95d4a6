"""The first answers are made at once where processes can be had, and one after the other where they cannot."""

from __future__ import annotations

import errno
from typing import Any

import pytest

from sweetspot.web import first_answers
from sweetspot.web.states import ViewState


def test_without_another_process_this_one_does_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_process(*_: Any, **__: Any) -> None:
        raise OSError(errno.EAGAIN, "Resource temporarily unavailable")

    kept: dict[tuple[str, ViewState], bytes] = {}
    monkeypatch.setattr(first_answers, "ProcessPoolExecutor", no_process)
    monkeypatch.setattr(first_answers, "kept_answer", lambda name, state: kept.get((name, state)))
    monkeypatch.setattr(first_answers, "keep", lambda name, state, answer: kept.update({(name, state): answer}))
    words: list[str] = []
    first_answers.prepare(lambda name, *_: name.encode(), words.append)
    assert kept == {(name, state): name.encode() for name, state in first_answers.first_states()}
    assert "in this process alone" in words[-1]

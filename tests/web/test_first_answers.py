"""The first answers are made at once where processes can be had, and one after the other where they cannot."""

from __future__ import annotations

import errno
from typing import Any

import pytest

from sweetspot.web import first_answers


def test_without_another_process_this_one_does_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def no_process(*_: Any, **__: Any) -> None:
        raise OSError(errno.EAGAIN, "Resource temporarily unavailable")

    kept: dict[first_answers.Question, bytes] = {}
    monkeypatch.setattr(first_answers, "ProcessPoolExecutor", no_process)
    monkeypatch.setattr(first_answers, "kept_answer", lambda *question: kept.get(question))
    monkeypatch.setattr(first_answers, "keep", lambda question, answer: kept.update({question: answer}))
    words: list[str] = []
    first_answers.prepare(lambda name, *_: name.encode(), words.append)
    assert kept == {question: question[0].encode() for question in first_answers.first_questions()}
    assert "in this process alone" in words[-1]

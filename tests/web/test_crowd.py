"""Many people at once: another process answers as this one does, and what it cannot answer is answered here."""

from __future__ import annotations

import asyncio
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import pytest

from sweetspot.web import crowd
from sweetspot.web.answers import Answers, answer_json, state_of
from sweetspot.web.crowd import MANY, Crowd, GoneError, Relief
from sweetspot.web.errors import FieldError, fault
from sweetspot.web.states import ViewState
from sweetspot.web.views import VIEWS


class Idle:
    """A further process that has begun and answers nothing."""

    ready = alive = True

    def __init__(self, _: Any, first: Any) -> None:
        self.asked: list[Any] = []
        self.first = first

    @property
    def waiting(self) -> int:
        return len(self.asked)

    def ask(self, question: Any) -> Future[bytes]:
        self.asked.append(question)
        return Future()

    def end(self) -> None:
        self.alive = False


def test_another_process_answers_and_refuses_as_this_one_until_it_ends() -> None:
    relief = Relief(answer_json, (("season", VIEWS["season"].state()), ("player", VIEWS["player"].state())))
    question = ("paper", state_of("paper", {"entry_angle_deg": 7}))
    assert relief.ask(question).result(600) == answer_json(*question)
    wrong = ("explorer", state_of("explorer", {"bat": "no such bat"}))
    with pytest.raises(FieldError) as here:
        answer_json(*wrong)
    with pytest.raises(FieldError) as there:
        relief.ask(wrong).result(600)
    assert fault(there.value) == fault(here.value) and there.value.field == "bat"
    assert relief.ready and relief.waiting == 0
    relief.end()
    relief._begun.join(600)
    with pytest.raises(GoneError):
        relief.ask(question).result(600)


def test_processes_begin_when_a_crowd_lasts_and_take_what_waits_longer_here(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crowd, "Relief", Idle)
    monkeypatch.setattr(crowd, "LASTING", 0.0)
    first, question = (("season", ViewState()), ("explorer", ViewState())), ("explorer", ViewState())
    many = Crowd(answer_json, first, most=1)
    assert many.taken(question, waiting=MANY - 1) is None and not many._reliefs
    taken = [many.taken(question, waiting=MANY) for _ in range(2 * MANY)]
    assert [one is not None for one in taken] == [True] * MANY + [False] * MANY
    assert len(many._reliefs) == 1  # and no more than one
    idle: Any = many._reliefs[0]
    assert idle.first == first[::-1]  # what the crowd's view needs is loaded before all else
    assert many.taken(question, waiting=1) is None
    many.close()
    assert many.taken(question, waiting=MANY + 1) is None and not many._reliefs


def test_what_an_ended_process_was_asked_is_answered_here(monkeypatch: pytest.MonkeyPatch) -> None:
    def gone(*_: Any, **__: Any) -> Future[bytes]:
        future = Future[bytes]()
        future.set_exception(GoneError())
        return future

    answers, state = Answers(), state_of("paper", {"entry_angle_deg": 8})
    answers.prepared = True
    monkeypatch.setattr(Crowd, "taken", gone)
    with ThreadPoolExecutor(1) as apart:  # the browser has this thread's loop
        assert apart.submit(lambda: asyncio.run(answers.json("paper", state))).result() == answer_json("paper", state)
    answers.close()

"""Many people at once: another process answers as this one does, and what it cannot answer is answered here."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from typing import Any

import pytest

from sweetspot.web import crowd
from sweetspot.web.answers import answer_json, state_of
from sweetspot.web.crowd import AHEAD, MANY, Asked, Crowd, Relief, next_in
from sweetspot.web.errors import FieldError, fault
from sweetspot.web.states import ViewState
from sweetspot.web.views import VIEWS

QUESTION = ("explorer", ViewState())


class Later(Executor):
    """Work that begins when it is told to."""

    def __init__(self) -> None:
        self.works: list[Any] = []

    def submit(self, work: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Keep some work."""
        assert not args and not kwargs
        self.works.append(work)
        return Future()


class Idle:
    """A further process that has begun, takes what it has room for and answers nothing."""

    ready = alive = True

    def __init__(self, _: Any, first: Any, row: deque[Asked], again: Any) -> None:
        self.first, self.row, self.again = first, row, again
        self.asked: list[Asked] = []

    def fill(self) -> None:
        while len(self.asked) < AHEAD and (asked := next_in(self.row)):
            self.asked.append(asked)

    def end(self) -> None:
        self.alive = False


@pytest.fixture
def here() -> Iterator[ThreadPoolExecutor]:
    with ThreadPoolExecutor(1) as pool:
        yield pool


def relieved(question: Any, relief: Relief) -> bytes:
    """Return the answer of another process to the only question in the row."""
    asked = Asked(question)
    relief._row.append(asked)
    relief.fill()
    return asked.answer.result(600)


def test_another_process_answers_and_refuses_as_this_one_until_it_ends() -> None:
    first = (("season", VIEWS["season"].state()), ("player", VIEWS["player"].state()))
    returned: list[Asked] = []
    relief = Relief(answer_json, first, deque(), returned.append)
    question = ("paper", state_of("paper", {"entry_angle_deg": 7}))
    assert relieved(question, relief) == answer_json(*question)  # in the row before the process has begun
    wrong = ("explorer", state_of("explorer", {"bat": "no such bat"}))
    with pytest.raises(FieldError) as here:
        answer_json(*wrong)
    with pytest.raises(FieldError) as there:
        relieved(wrong, relief)
    assert fault(there.value) == fault(here.value) and there.value.field == "bat"
    assert relief.ready and not returned
    held = Asked(question)
    relief._asked[-1] = held  # taken, and not answered before the end
    relief.end()
    relief._begun.join(600)
    assert returned == [held] and not relief.ready


def test_processes_begin_when_a_crowd_lasts_and_take_what_waits(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crowd, "Relief", Idle)
    monkeypatch.setattr(crowd, "LASTING", 0.0)
    first = (("season", ViewState()), QUESTION)
    later = Later()
    many = Crowd(lambda name, _: name.encode(), first, later, most=1)
    answers = [many.ask(QUESTION) for _ in range(MANY - 1)]
    assert not many._reliefs
    answers += [many.ask(QUESTION) for _ in range(MANY)]
    assert len(many._reliefs) == 1  # and no more than one
    idle: Any = many._reliefs[0]
    assert idle.first == first[::-1]  # what the crowd's view needs is loaded before all else
    assert [one.answer for one in idle.asked] == answers[:AHEAD]  # who has waited longest comes first
    answers[AHEAD].cancel()
    for work in later.works:
        work()
    assert [one.done() for one in answers] == [False] * AHEAD + [True] * (len(answers) - AHEAD)
    assert answers[-1].result(0) == b"explorer"
    lost = idle.asked.pop()
    idle.again(lost)  # the process has ended
    later.works[-1]()
    assert lost.answer.result(0) == b"explorer"
    many.close()
    assert not idle.alive


def test_nobody_is_asked_elsewhere_while_one_question_is_under_way(
    monkeypatch: pytest.MonkeyPatch, here: ThreadPoolExecutor
) -> None:
    many = Crowd(answer_json, (), here, most=1)
    idle: Any = Idle(None, (), many._row, None)
    monkeypatch.setattr(many, "_reliefs", [idle])
    question = ("paper", state_of("paper", {"entry_angle_deg": 8}))
    assert many.ask(question).result(600) == answer_json(*question)
    wrong = ("explorer", state_of("explorer", {"bat": "no such bat"}))
    with pytest.raises(FieldError):
        many.ask(wrong).result(600)
    assert not idle.asked

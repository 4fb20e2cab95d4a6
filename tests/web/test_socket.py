"""The socket: the latest question wins, everything wrong is said, and nobody disturbs anybody else."""

from __future__ import annotations

import asyncio
import json
import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any

import httpx
import pytest
from websockets.exceptions import ConnectionClosed, InvalidHandshake, InvalidStatus
from websockets.sync.client import ClientConnection, connect

from sweetspot.web import answers, socket
from sweetspot.web.controls import ViewState
from sweetspot.web.errors import FieldError
from sweetspot.web.limits import LARGEST_BODY
from sweetspot.web.view import View
from sweetspot.web.views import VIEWS

LATE = 600.0
"""s after which no answer comes."""


@contextmanager
def talking(server: str, **options: Any) -> Iterator[ClientConnection]:
    patient: dict[str, Any] = {"open_timeout": LATE, "ping_interval": None}
    with connect(server.replace("http", "ws") + "/ws", compression=None, max_size=2**22, **patient, **options) as line:
        yield line


def asked(line: ClientConnection, number: int, **state: Any) -> dict[str, Any]:
    line.send(json.dumps({"id": number, "view": "explorer", "state": state}))
    answer: dict[str, Any] = {"status": ""}
    while "status" in answer:  # said before the answer, while the kernels load
        answer = json.loads(line.recv(timeout=LATE))
    return answer


def test_a_question_is_answered_under_its_number(server: str, client: httpx.Client) -> None:
    with talking(server) as line:
        found = asked(line, 7, pitch_speed_mph=85)
    assert found["id"] == 7
    assert found["answer"] == client.post("/api/v1/explorer", json={"pitch_speed_mph": 85}).json()


def test_the_latest_question_wins(server: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A burst is not answered one by one: what was overtaken while it waited is left out."""
    last, taken, all_taken = 60, socket._Conversation._take, threading.Event()
    answer = answers.AnswerPool.json

    async def take(self: socket._Conversation, text: str | None) -> None:
        await taken(self, text)
        if f'"id": {last},' in str(text):
            all_taken.set()

    async def answered(self: answers.AnswerPool, *question: Any) -> bytes:
        await asyncio.to_thread(all_taken.wait, LATE)
        return await answer(self, *question)

    monkeypatch.setattr(socket._Conversation, "_take", take)
    with talking(server) as line:
        monkeypatch.setattr(answers.AnswerPool, "json", answered)
        for number in range(1, last + 1):
            state = {"pitch_speed_mph": 50 + number / 2}
            line.send(json.dumps({"id": number, "view": "explorer", "state": state}))
        numbers: list[int] = []
        while not numbers or numbers[-1] != last:
            numbers.append(json.loads(line.recv(timeout=LATE))["id"])
    assert len(numbers) <= 2  # one that was begun, and the last one


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "JSON"),
        ("[" * 5000, "one JSON object"),
        ("null", "JSON object"),
        ('{"id": 1}', "required"),
        ('{"id": -1, "view": "explorer", "state": {}}', "0 or more"),
        ('{"id": 1, "view": "nothing", "state": {}}', "no view"),
        ('{"id": 1, "view": "explorer", "state": {"pitch_speed_mph": NaN}}', "finite"),
        ('{"id": 1, "view": "explorer", "state": {"pitch_speed_mph": 1e999}}', "finite"),
        ('{"id": 1, "view": "explorer", "state": {"bat": "gold"}}', "catalogue"),
        ('{"id": 1, "view": "explorer", "state": {}, "more": 1}', "no such"),
    ],
)
def test_what_is_wrong_is_said_and_the_line_stays_open(server: str, text: str, words: str) -> None:
    with talking(server) as line:
        line.send(text)
        error = json.loads(line.recv(timeout=LATE))["error"]
        assert words in error["message"]
        assert "answer" in asked(line, 2)


def test_bytes_are_refused_with_a_message(server: str) -> None:
    with talking(server) as line:
        line.send(b"\x00\xff")
        assert "JSON text" in json.loads(line.recv(timeout=LATE))["error"]["message"]


def test_a_text_that_is_none_ends_the_line(server: str) -> None:
    with talking(server) as line, pytest.raises(ConnectionClosed) as closed:
        with line.send_context():
            line.protocol.send_text(b"\xff\xfe")
        line.recv(timeout=LATE)
    assert closed.value.rcvd is not None
    assert closed.value.rcvd.code == 1007


def test_a_message_too_large_ends_the_line_and_nothing_else(server: str) -> None:
    with talking(server) as other:
        with talking(server) as line, pytest.raises(ConnectionClosed):
            line.send("x" * (LARGEST_BODY + 1))
            line.recv(timeout=LATE)
        assert "answer" in asked(other, 1)


def test_a_line_closed_in_mid_answer_disturbs_nobody(server: str) -> None:
    with talking(server) as other:
        for number in range(5):
            with talking(server) as line:
                line.send(json.dumps({"id": number, "view": "explorer", "state": {"bat_speed_mph": 60 + number / 7}}))
        assert "answer" in asked(other, 1, bat_speed_mph=61.234)


def test_users_do_not_see_each_other(server: str) -> None:
    with talking(server) as first, talking(server) as second:
        for line, speed in ((first, 81.5), (second, 82.5)):
            line.send(json.dumps({"id": 1, "view": "explorer", "state": {"pitch_speed_mph": speed}}))
        found = [json.loads(line.recv(timeout=LATE))["answer"]["conditions"] for line in (first, second)]
    assert [speed["pitch_speed_m_s"] for speed in found] == pytest.approx([81.5 * 0.44704, 82.5 * 0.44704])


def test_pages_of_other_servers_are_kept_out(server: str) -> None:
    with pytest.raises((InvalidStatus, InvalidHandshake)), talking(server, origin="https://evil.example"):
        pass
    with talking(server, origin=server) as line:
        assert "answer" in asked(line, 1)


def test_an_answer_that_takes_too_long_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    given_up = threading.Event()

    def slow(_: ViewState) -> dict[str, Any]:
        given_up.wait(60)
        return {}

    monkeypatch.setitem(VIEWS, "slow", View("slow", "Slow", ViewState, slow))
    monkeypatch.setattr(answers, "TIME_LIMIT", 0.05)
    found = answers.AnswerPool()
    found.prepared = True
    with ThreadPoolExecutor(1) as apart, pytest.raises(FieldError, match="longer than"):
        apart.submit(
            lambda: asyncio.run(found.json("slow", ViewState()))
        ).result()  # the browser has this thread's loop
    given_up.set()
    found.close()

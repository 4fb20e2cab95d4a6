"""What one address may ask for: a class that opens the page at once gets it whole, and a flood of questions waits."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress
from types import SimpleNamespace

import pytest

from sweetspot.web.files import static_files
from sweetspot.web.limits import REQUESTS_AT_ONCE, Guard, Message, Receive, Scope, Send

CLASS = 60


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], dict[str, object]]:
    """Return a function that asks for a path, from one address and in one moment, and returns the answer's head."""
    now = time.monotonic()
    monkeypatch.setattr("sweetspot.web.limits.time", SimpleNamespace(monotonic=lambda: now))

    async def found(_scope: Scope, _receive: Receive, send: Send) -> None:
        await send({"type": "http.response.start", "status": 200, "headers": []})

    guard = Guard(found, names=["localhost"])

    def ask(path: str) -> dict[str, object]:
        said: list[Message] = []

        async def send(message: Message) -> None:
            said.append(message)

        async def receive() -> Message:
            return {"type": "http.request"}

        scope = {"type": "http", "path": path, "client": ("10.0.0.1", 1), "headers": [(b"host", b"localhost")]}
        with suppress(StopIteration):  # nothing here waits, so one step is all
            guard(scope, receive, send).__await__().send(None)
        return dict(said[0])

    return ask


def test_a_class_behind_one_address_gets_every_file(asked: Callable[[str], dict[str, object]]) -> None:
    """A page that lacks one of its modules stays empty, so no visit may be refused one."""
    visit = ["/explorer", *(f"/static/{name}" for name in static_files())]
    assert {asked(path)["status"] for _ in range(CLASS) for path in visit} == {200}


def test_who_asks_too_much_is_told_to_wait_and_keeps_the_page(asked: Callable[[str], dict[str, object]]) -> None:
    assert {asked("/api/v1/bats")["status"] for _ in range(int(REQUESTS_AT_ONCE))} == {200}
    refused = asked("/api/v1/bats")
    assert refused["status"] == 429
    assert (b"retry-after", b"1") in refused["headers"]  # type: ignore[operator]
    assert asked("/explorer")["status"] == 200

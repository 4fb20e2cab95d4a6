"""A running server, programs that talk to it, and a real browser that looks at it.

``server`` is the address of one server for the whole run; ``page`` is a tab as good as new (no view opened yet:
``page.goto(f"{server}/modes")``, then ``answered(page)``, which waits for the drawn answer and counts them,
``settled(page)``, which waits for all that a view asks for, ``narrow(page)``, which makes it a phone's, or
``until(page, "script")``; the page's content policy forbids ``page.wait_for_function``). None waits for a time: the
machine may be three times slower than yours. What is pressed at coordinates may be drawn later than the answer, and
may still be moved by what comes above it: ``settled`` first. Where no Chromium is found browser tests are skipped and
say so; with CI=true in the environment that is a failure.
"""

from __future__ import annotations

import os
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from playwright.sync_api import Browser, BrowserContext, ConsoleMessage, Locator, Page, ViewportSize, expect
from playwright.sync_api import Error as PlaywrightError

from sweetspot.web import answers, jobs
from sweetspot.web.run_server import listening, server_for

LATE = 600.0
"""s after which something never comes: no machine is that late."""
PATIENCE = 1e3 * LATE
"""ms that a test waits for what it expects while the page works: reading a season compiles its kernels first."""
PRESSED = PATIENCE if os.environ.get("CI") == "true" else 60_000
"""ms that it waits for what is to be pressed: where nobody watches, as long."""
LOOKS, REST = 4, 5_000
"""A page that has nothing to do stays as it is: what is not there at so many looks, so many ms apart, is wrong."""
AT_REST = """(document.readyState === "complete" && !document.querySelector("#view")?.dataset.waiting
  && ![...document.querySelectorAll("progress, [aria-busy=true], #status")].some((one) => one.checkVisibility()))"""
"""Whether nothing is asked for, nothing is being worked on, and the line to the server is open."""
SIZE: ViewportSize = {"width": 1280, "height": 900}
LOOK = """new Promise((done, failed) => {{
  let busy = performance.now();
  const look = () => {{
    try {{
      const found = {script}, now = performance.now();
      if (!{at_rest}) busy = now;
      if (found || now > end || now > busy + {rest}) done(found);
      else setTimeout(look, 20);
    }} catch (error) {{
      failed(error);
    }}
  }};
  const end = performance.now() + {patience};
  look();
}})"""
"""Looks in the page, for asking it again and again from here would cost more than what it is waited for."""
NOTHING_ASKED = "!document.querySelector('#view').dataset.waiting.split(' ').includes('answer')"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Try a test in a browser, which may be starved on a busy machine, once more before it fails; both are reported."""
    for item in items:
        if "browser" in getattr(item, "fixturenames", ()):
            item.add_marker(pytest.mark.flaky(reruns=1))


@pytest.fixture(scope="session", autouse=True)
def _no_hurry() -> Iterator[None]:
    """A busy machine's server gives nobody up; what the limits do, tests of them say."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(answers, "TIME_LIMIT", LATE)
        patch.setattr(jobs, "UNWATCHED", LATE)
        yield


class Expected:
    """What is expected of a page or a part of it: waited for as long as the page works, and no longer."""

    def __init__(self, assertions: Any, page: Page) -> None:
        self._assertions, self._page = assertions, page

    def __getattr__(self, name: str) -> Callable[..., None]:
        check = getattr(self._assertions, name)

        def wait(*words: Any, timeout: float = PATIENCE, **options: Any) -> None:
            end, rested = time.monotonic() + timeout / 1000, 0
            while True:
                try:
                    check(*words, timeout=min(timeout, REST), **options)
                    return
                except AssertionError:
                    rested = rested + 1 if self._at_rest() else 0
                    if rested == LOOKS or time.monotonic() > end:
                        raise

        return wait

    def _at_rest(self) -> bool:
        try:
            return bool(self._page.evaluate(AT_REST))
        except PlaywrightError:  # it is left for another page, which is looked at next
            return False


@pytest.fixture(scope="session", autouse=True)
def _no_patience_with_a_page_at_rest() -> Iterator[None]:
    """A wrong word fails a test in seconds, and a slow machine none: `expect` asks whether the page still works."""
    usual = type(expect).__call__

    def patient(self: Any, actual: Any, message: str | None = None) -> Any:
        if isinstance(actual, (Page, Locator)):
            return Expected(usual(self, actual, message), actual if isinstance(actual, Page) else actual.page)
        return usual(self, actual, message)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(type(expect), "__call__", patient)
        yield


@pytest.fixture(scope="session")
def server() -> Iterator[str]:
    """The address of a running server."""
    opened = listening("127.0.0.1", 0)
    running = server_for()
    thread = threading.Thread(target=running.run, kwargs={"sockets": [opened]}, daemon=True)
    thread.start()
    deadline = time.monotonic() + 900  # without kept kernels they are compiled first
    while not (running.started and running.config.app.state.answers.prepared):  # type: ignore[union-attr]
        assert time.monotonic() < deadline
        time.sleep(0.01)
    yield f"http://127.0.0.1:{opened.getsockname()[1]}"
    running.should_exit = True
    thread.join(60)


@pytest.fixture
def client(server: str) -> Iterator[httpx.Client]:
    """A program that talks to the API."""
    with httpx.Client(base_url=server, timeout=LATE, verify=False) as opened:  # no certificates to load
        yield opened


@pytest.fixture(scope="session")
def visitor(browser: Browser, server: str) -> Iterator[BrowserContext]:
    """One visitor's browser, 1280 by 900, who has been here before; leaves before the server stops."""
    context = browser.new_context(viewport=SIZE)
    context.set_default_timeout(PRESSED)
    yield context
    context.close()


@pytest.fixture(scope="session")
def tabs() -> list[Page]:
    """Tabs that tests left as new, for the next ones: a new tab's first view costs twice the processor."""
    return []


@pytest.fixture
def page(visitor: BrowserContext, tabs: list[Page], server: str) -> Iterator[Page]:
    """A page that remembers nothing; what it complains about fails the test."""
    opened = tabs.pop() if tabs else visitor.new_page()
    complaints: list[str] = []

    def fail(error: PlaywrightError) -> None:
        complaints.append(str(error))

    def hear(said: ConsoleMessage) -> None:
        if said.type == "error":
            complaints.append(said.text)

    opened.on("pageerror", fail)
    opened.on("console", hear)
    yield opened
    if opened.url.startswith("http"):
        opened.evaluate("localStorage.clear(); sessionStorage.clear()")
    opened.remove_listener("pageerror", fail)
    opened.remove_listener("console", hear)
    opened.unroute_all()
    opened.goto(f"{server}/static/icon.svg")  # a site that is left ends its process
    opened.mouse.move(0, 0)
    opened.set_viewport_size(SIZE)
    opened.emulate_media(media="null", color_scheme="null", reduced_motion="null", forced_colors="null")
    tabs.append(opened)
    # lost connections and refusals, which tests ask for
    expected = ("WebSocket", "ERR_CONNECTION", "status of 4")
    surprises = [words for words in complaints if not any(part in words for part in expected)]
    assert not surprises, "\n".join(surprises)


def _told(page: Page) -> str:
    return " ".join(page.locator("body").inner_text().split())[:500]


@pytest.fixture
def until() -> Callable[[Page, str], Any]:
    """A function that waits until a script's value is true, and returns it."""

    def wait(page: Page, script: str) -> Any:
        look = LOOK.format(script=script, patience=PATIENCE, at_rest=AT_REST, rest=LOOKS * REST)
        deadline = time.monotonic() + LATE
        while True:
            try:
                found = page.evaluate(look)
                break
            except PlaywrightError as error:  # of a page that was left for another one, which is looked at next
                if "context was destroyed" not in str(error) or time.monotonic() > deadline:
                    raise
        assert found, f"never true: {script}\non a page that says: {_told(page)}"
        return found

    return wait


VIEW_OF = """async () => {{
  const {{ default: View }} = await (await import("/static/page.js")).$load("views/{name}.js");
  const {{ update }} = View.prototype, theme = document.querySelector("#theme");
  const view = await new Promise((found) => {{
    View.prototype.update = function (...answer) {{
      View.prototype.update = update;
      update.apply(this, answer);
      found(this);
    }};
    theme.click();  // a view is drawn anew in other colours
  }});
  theme.click();
  {script}
}}"""


@pytest.fixture
def in_view() -> Callable[[Page, str, str], Any]:
    """A function that runs a script in the page, with the view that is shown as `view`; returns what it returns."""
    return lambda page, name, script: page.evaluate(VIEW_OF.format(name=name, script=script))


@pytest.fixture
def answered(until: Callable[[Page, str], Any]) -> Callable[..., int]:
    """Return a function that waits until a view has drawn more than so many answers, and returns how many it has.

    The last of them is that to the latest question.
    """

    def wait(page: Page, more_than: int = 0) -> int:
        drawn = "Number(document.querySelector('#view')?.dataset.answered ?? 0)"
        until(page, f"{drawn} > {more_than} && {NOTHING_ASKED}")
        return int(page.evaluate(drawn))

    return wait


@pytest.fixture
def opened(request: pytest.FixtureRequest, page: Page, server: str, answered: Callable[..., int]) -> Page:
    """The page with the view that the test's module names, answered."""
    page.goto(f"{server}/{request.module.VIEW}")
    answered(page)
    return page


@pytest.fixture
def still(page: Page) -> Page:
    """A page for people who asked for less motion: nothing starts by itself."""
    page.emulate_media(reduced_motion="reduce")
    return page


@pytest.fixture
def settled(answered: Callable[..., int], until: Callable[[Page, str], Any]) -> Callable[[Page], None]:
    """Return a function that waits until nothing more comes: lists, words and parts come after a view's picture."""

    def wait(page: Page) -> None:
        answered(page)
        until(page, "document.querySelector('#view').dataset.waiting === ''")
        page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    return wait


@pytest.fixture
def narrow(until: Callable[[Page, str], Any]) -> Callable[[Page], None]:
    """Return a function that makes a page as narrow as a small phone, and waits until nothing is wider."""

    def wait(page: Page) -> None:
        page.set_viewport_size({"width": 360, "height": 740})
        until(page, "innerWidth === 360 && document.documentElement.scrollWidth <= 360")

    return wait


@pytest.fixture
def repainted(until: Callable[[Page, str], Any]) -> Callable[[Page, Callable[[], None]], None]:
    """Return a function that does something and waits until the view's canvases look different."""
    canvases = "[...document.querySelectorAll('#view canvas')].map((canvas) => canvas.toDataURL()).join()"

    def wait(page: Page, act: Callable[[], None]) -> None:
        page.evaluate(f"window.seen = {canvases}")
        act()
        until(page, f"window.seen !== {canvases}")

    return wait


@pytest.fixture(scope="session")
def taps(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A sound file of three taps of a bat 1 in from its tip, the last of which is doubled."""
    import numpy as np

    from sweetspot import catalog
    from sweetspot.calibration.recording import Recording, recording_bytes, synthesised
    from sweetspot.catalog.standard_hit import standard_conditions
    from sweetspot.dynamics.beam import beam_model
    from sweetspot.dynamics.reduction import all_modes
    from sweetspot.units import INCH

    bat = catalog.bat("r161-ash")
    modes = all_modes(beam_model(bat), standard_conditions(bat).ball, count=5)  # two free and three that ring
    place = bat.length - INCH
    sound = synthesised(modes, position=place, listened=place)
    samples = sound.samples.copy()
    blow, late = round(2.3 * sound.rate), round(0.1 * sound.rate)
    samples[blow + late :] += 0.7 * samples[blow:-late]
    path = tmp_path_factory.mktemp("taps") / "taps.wav"
    made = Recording("taps", 0.6 * samples / np.abs(samples).max(), sound.rate)
    path.write_bytes(recording_bytes(made, path))
    return path


@pytest.fixture(scope="session")
def balls(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small made-up season of six hitters as a public export has it."""
    import polars as pl

    from sweetspot import catalog
    from sweetspot.seasons.made_up import MadeSeason, made_season

    path = tmp_path_factory.mktemp("balls") / "my balls.csv"
    made = made_season(catalog.bat("r161-ash"), MadeSeason(players=6, balls=60))
    made.select(pl.exclude("^true_.*$")).write_csv(path)
    return path

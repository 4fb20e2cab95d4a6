"""The page as people feel it: start, first picture, slider to redraw, many at once, and memory."""

from __future__ import annotations

import asyncio
import json
import re
import statistics
import subprocess
import time
from collections.abc import Callable, Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import parse_qsl

import httpx
import pytest
from playwright.sync_api import sync_playwright
from websockets.asyncio.client import connect

from benchmarks.cases import QUICK, duration, measured
from benchmarks.test_speed_of_start import command
from sweetspot.web.bundle import LATER
from tests import browsers

Record = Callable[..., None]
Result = TypeVar("Result")
MOVES = 40 if QUICK else 200
CLIENTS, SECONDS = 50, 2.0 if QUICK else 10.0
PAUSE = 0.05
"""s between two moves of a dragged slider, as a hand makes them."""
UPDATES = 1000 if QUICK else 10_000
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
FOUR = 'compare?others=[{"bat":"corked-r161"},{"bat":"russell-b6"},{"bat":"mlb-a"}]'
DRAGS = {
    "Explorer": ("explorer", "pitch_speed_mph", 50, 90),
    "Explorer, hollow wall": ("explorer?bat=single-wall", "wall_factor", 0.8, 1.4),
    "Explorer, hole": ("explorer?bore_diameter_in=0.5", "bore_diameter_in", 0.3, 1.2),
    "Slow motion": ("hit", "pitch_speed_mph", 50, 90),
    "Modes, tap": ("modes", "tap_from_tip_in", 1, 20),
    "Modes, hollow wall": ("modes?bat=single-wall", "wall_factor", 0.8, 1.4),
    "Compare": ("compare", "pitch_speed_mph", 50, 90),
    "Compare of four": (FOUR, "pitch_speed_mph", 50, 90),
    "Compare, hole": ("compare?bore_diameter_in=0.5", "bore_diameter_in", 0.3, 1.2),
    "Flight": ("flight", "exit_speed_mph", 70, 110),
    "Flight from the swing": ("flight?start=swing", "pitch_speed_mph", 50, 90),
    "Best swing": ("optimum", "exit_speed_mph", 80, 110),
    "Player": ("player", "given_pitch_mph", 40, 90),
    "Own bat": ("own?weighed_oz=31", "weighed_oz", 30, 32),
    "Design": ("design", "contact_in", 4, 9),
    "Season": ("season?weight_oz=1", "weight_oz", 0.1, 4),
    "Every sport": ("sports", "swing_mph", 40, 90),
    "The paper": ("paper", "entry_angle_deg", 5, 30),
}
"""What is dragged: the view's address, and the field of its slider, from where to where."""
CROWDED = tuple(name for name in DRAGS if "," not in name or name == "Modes, tap")
"""What fifty people drag."""
DRAG = """async ({ field, least, most, moves, pauses }) => {
  const view = document.querySelector('#view');
  const range = document.querySelector(`[data-field=${field}] input[type=range]`);
  const times = [];
  for (let move = 0; move < moves; move += 1) {
    await new Promise((done) => setTimeout(done, 17 + pauses[move]));
    const start = performance.now();
    range.value = String(least + (most - least) * ((move * 0.381966) % 1));
    range.dispatchEvent(new Event('input', { bubbles: true }));
    await new Promise((done) => new MutationObserver((_, observer) => {
      observer.disconnect();
      requestAnimationFrame(() => {  // the frame that shows it; its message comes after the painting
        const channel = new MessageChannel();
        channel.port1.onmessage = done;
        channel.port2.postMessage(0);
      });
    }).observe(view, { attributes: true, attributeFilter: ['data-answered'] }));
    times.push(performance.now() - start);
  }
  return times;
}"""
FRAMES = """(milliseconds) => new Promise((done) => {
  const play = [...document.querySelectorAll('.transport button')].find((one) => one.textContent.includes('Play'));
  play?.click();
  let [frames, begun] = [0, null];
  const count = (now) => {
    begun ??= now;
    frames += 1;
    if (now - begun < milliseconds) requestAnimationFrame(count);
    else done((1000 * (frames - 1)) / (now - begun));
  };
  requestAnimationFrame(count);
})"""
FIRST = """() => new Promise((done) => {
  const look = () => document.querySelector('#view')?.dataset.answered ? done(performance.now()) : setTimeout(look, 5);
  look();
})"""


@dataclass(frozen=True)
class Running:
    """A server of its own process: its address, its process and how long it took until it answered, s."""

    address: str
    process: subprocess.Popen[str]
    start: float

    def memory(self) -> float:
        """Return the memory it holds in MiB."""
        status = Path(f"/proc/{self.process.pid}/status").read_text(encoding="ascii")
        return int(re.findall(r"VmRSS:\s+(\d+)", status)[0]) / 1024


@contextmanager
def started() -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Yield the address and the process of a server that has just said where it is."""
    process = subprocess.Popen(command("app", "--port", "0", "--no-browser"), stderr=subprocess.PIPE, text=True)
    assert process.stderr is not None
    try:
        yield re.findall(r"http://\S+", process.stderr.readline())[0].rstrip("/"), process
    finally:
        process.terminate()
        process.communicate(timeout=600)


@pytest.fixture(scope="module")
def running() -> Iterator[Running]:
    begin = time.perf_counter()
    with started() as (address, process):
        response = httpx.get(f"{address}/explorer", timeout=600)
        start = time.perf_counter() - begin
        assert response.status_code == 200
        apart(_warm(address))
        yield Running(address, process, start)


@pytest.fixture(scope="module")
def drawn(running: Running) -> Iterator[Any]:
    """A browser's page on the warm server, and when its first picture was drawn, s."""
    found = browsers.for_people()
    if found is None:
        pytest.skip("no Chromium found")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=found, args=FLAGS)
        firsts = []
        for _ in range(3):
            page = browser.new_page(viewport={"width": 1280, "height": 900})
            page.add_init_script("localStorage.setItem('guided', 'yes')")
            page.goto(f"{running.address}/explorer")
            firsts.append(page.evaluate(FIRST) / 1000)
        yield page, min(firsts)
        browser.close()


def test_start(benchmark: Any, record: Record, running: Running) -> None:
    measured(benchmark, lambda: httpx.get(f"{running.address}/explorer"), 3)
    record("sweetspot app, start to first page", duration(running.start), goal="3 s")


def test_first_picture(benchmark: Any, record: Record, drawn: Any) -> None:
    measured(benchmark, lambda: None, 1)
    record("the page, opened to first picture", duration(drawn[1]), goal="1.5 s")


def test_start_to_first_picture(benchmark: Any, record: Record, drawn: Any) -> None:
    """From the command to the picture in a browser that is open already: the server has answered nobody before."""
    browser = drawn[0].context.browser

    def first_picture() -> float:
        begin = time.perf_counter()
        with started() as (address, _):
            page = browser.new_page()
            page.goto(f"{address}/explorer")
            page.evaluate(FIRST)
            waited = time.perf_counter() - begin
            page.close()
        return waited

    waits = [first_picture() for _ in range(2 if QUICK else 5)]
    measured(benchmark, lambda: None, 1)
    record("sweetspot app, start to first picture", duration(min(waits)), goal="2.5 s")


@pytest.mark.parametrize("name", DRAGS)
def test_slider_to_redraw(benchmark: Any, record: Record, running: Running, drawn: Any, name: str) -> None:
    page, (view, field, least, most) = drawn[0], DRAGS[name]
    page.goto(f"{running.address}/{view}")
    page.evaluate(FIRST)
    page.evaluate("document.querySelectorAll('details').forEach((one) => (one.open = true))")
    pauses = [(move * 7919) % 16 for move in range(MOVES)]  # so that moves fall anywhere between two frames
    asked = {"field": field, "least": least, "most": most, "pauses": pauses}
    page.evaluate(DRAG, {**asked, "moves": 5})
    times = sorted(value / 1000 for value in page.evaluate(DRAG, {**asked, "moves": MOVES}))
    measured(benchmark, lambda: None, 1)
    record(f"{name}: slider to redraw, median", duration(statistics.median(times)), goal="30 ms")
    record(f"{name}: slider to redraw, 90 of 100", duration(times[int(0.9 * len(times))]), goal="50 ms")


@pytest.mark.parametrize("name", CROWDED)
def test_fifty_people_dragging(benchmark: Any, record: Record, running: Running, name: str) -> None:
    times = sorted(apart(_crowd(running.address, CLIENTS, SECONDS, DRAGS[name])))
    measured(benchmark, lambda: None, 1)
    record(f"{CLIENTS} people in {name}, 95 of 100", duration(times[int(0.95 * len(times))]), goal="250 ms",
           rival=f"{len(times) / SECONDS:,.0f} answers/s, median {duration(statistics.median(times))}")  # fmt: skip


def test_frames_of_the_film(benchmark: Any, record: Record, running: Running, drawn: Any) -> None:
    page = drawn[0]
    for name, address in (("wood", "hit?slowness=10000"), ("hollow", "hit?slowness=10000&bat=single-wall")):
        page.goto(f"{running.address}/{address}")
        page.evaluate(FIRST)
        record(f"frames of the film, {name} bat", f"{page.evaluate(FRAMES, 3000):.1f}/s", goal="55/s")
    measured(benchmark, lambda: None, 1)


def test_transfer_of_the_first_view(benchmark: Any, record: Record, running: Running, drawn: Any) -> None:
    """Every byte that the network carries, heads included, until all of the first view is there and drawn.

    The modules of the other views, fetched after it so that going there takes no time, are told apart.
    """
    context = drawn[0].context.browser.new_context()
    page = context.new_page()
    wire = context.new_cdp_session(page)
    asked: dict[str, str] = {}
    carried: list[tuple[str, float]] = []

    def frame(one: Any) -> None:
        carried.append(("", len(one["response"]["payloadData"])))

    wire.on("Network.requestWillBeSent", lambda one: asked.update({one["requestId"]: one["request"]["url"]}))
    wire.on("Network.loadingFinished", lambda one: carried.append((asked[one["requestId"]], one["encodedDataLength"])))
    wire.on("Network.webSocketFrameReceived", frame)
    wire.send("Network.enable")
    page.goto(running.address)
    page.evaluate(FIRST)
    page.wait_for_timeout(3000)  # lists and what comes apart
    context.close()
    measured(benchmark, lambda: None, 1)
    beside = sum(size for url, size in carried if url.endswith(LATER))
    whole = sum(size for _, size in carried)
    record("transfer of the first view", f"{(whole - beside) / 1000:.0f} kB", goal="120 kB",
           rival=f"the other views' modules: {beside / 1000:.0f} kB")  # fmt: skip
    record("requests of the first view", str(len(asked) - 1), goal="12")


def test_memory_of_the_server(benchmark: Any, record: Record, running: Running) -> None:
    if not Path("/proc/self/status").exists():
        pytest.skip("this system does not tell how much memory a process holds")
    apart(_updates(running.address, UPDATES // 2))
    before = running.memory()
    apart(_updates(running.address, UPDATES, first=UPDATES))
    after = running.memory()
    measured(benchmark, lambda: None, 1)
    record(
        f"memory of the server, {UPDATES:,} updates later",
        f"{after:.0f} MiB",
        goal="flat",
        rival=f"before: {before:.0f} MiB",
    )


def apart(work: Coroutine[Any, Any, Result]) -> Result:
    """Return what a coroutine does in a thread of its own; the browser's driver has the loop of this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, work).result()


async def _crowd(address: str, clients: int, seconds: float, dragged: tuple[str, str, float, float]) -> list[float]:
    """Return how long every question of many people took, s; each drags a slider and waits for the answer."""
    loop = asyncio.get_running_loop()
    address_of_view, field, least, most = dragged
    view, _, query = address_of_view.partition("?")
    fixed = {key: json.loads(value) if value[0] in "[0123456789" else value for key, value in parse_qsl(query)}
    end = loop.time() + seconds

    async def person(number: int) -> list[float]:
        times = []
        async with connect(address.replace("http", "ws") + "/ws", compression=None) as line:
            await asyncio.sleep(PAUSE * number / clients)
            move = 0
            while loop.time() < end:
                move += 1
                part = (0.381966 * move + number / 1009) % 1  # nobody asks what another asked
                state = {**fixed, field: least + (most - least) * part}
                begin = loop.time()
                await line.send(json.dumps({"id": move, "view": view, "state": state}))
                text = await line.recv(decode=False)
                times.append(loop.time() - begin)
                assert b'"answer"' in text[:60]
                await asyncio.sleep(max(0.0, PAUSE - times[-1]))
        return times

    found = await asyncio.gather(*(person(number) for number in range(clients)))
    return [value for times in found for value in times]


async def _warm(address: str) -> None:
    """Wait until the server has worked out its first answers: until then each answer follows a word about that."""
    async with connect(address.replace("http", "ws") + "/ws", compression=None) as line:
        while True:
            await line.send(json.dumps({"id": 1, "view": "explorer", "state": {}}))
            if b'"answer"' in (await line.recv(decode=False))[:60]:
                return
            await line.recv()
            await asyncio.sleep(0.2)


async def _updates(address: str, count: int, first: int = 0) -> None:
    async with connect(address.replace("http", "ws") + "/ws", compression=None) as line:
        for move in range(first, first + count):
            state = {"pitch_speed_mph": 40 + move / 1000, "choke_up_in": (move % 50) / 10}
            await line.send(json.dumps({"id": move, "view": "explorer", "state": state}))
            await line.recv()

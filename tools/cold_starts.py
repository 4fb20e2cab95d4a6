"""Start the laboratory in clean clones with nothing compiled, on a busy machine; time when a browser has its picture.

``python tools/cold_starts.py [TRIES] [BUSY]``: ten tries beside two busy processes. Each clones what is committed into
a folder of its own and runs ``make app`` there; a browser that is open already goes to the address as soon as it is
printed. Each try takes minutes. A try without a picture fails, and so does the tool.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from playwright.sync_api import Browser, sync_playwright
from playwright.sync_api import Error as BrowserError

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.browsers import for_people

HERE = Path(__file__).parents[1]
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
PATIENCE = 300.0
"""s that a browser waits for its picture once the address is printed."""
SPIN = "while True: pass"


def main(tries: int = 10, busy: int = 2) -> int:
    """Say for each try when the address was printed and how long the picture took from there."""
    missed = 0
    with sync_playwright() as playwright, busily(busy):
        browser = playwright.chromium.launch(executable_path=for_people(), args=FLAGS)
        for number in range(1, tries + 1):
            until_address, until_picture = one_start(browser)
            missed += until_picture is None
            picture = "no picture" if until_picture is None else f"picture {until_picture:.2f} s later"
            load = os.getloadavg()[0]
            print(f"{number:2d}: address after {until_address:.0f} s, {picture} (load {load:.1f})", flush=True)
        browser.close()
    print(f"{tries - missed} pictures of {tries} tries beside {busy} busy processes")
    return 1 if missed else 0


def one_start(browser: Browser) -> tuple[float, float | None]:
    """Return the seconds to the address in a clean clone, and from there to the picture; None: there was none."""
    with tempfile.TemporaryDirectory(prefix="clone-") as folder:
        subprocess.run(
            ["git", "-c", "advice.detachedHead=false", "clone", "-q", str(HERE), f"{folder}/tree"], check=True
        )
        hidden = ("NUMBA_CACHE_DIR", "VIRTUAL_ENV", "PYTHONPATH", "MAKEFLAGS")
        own = {"XDG_CACHE_HOME": f"{folder}/cache", "BROWSER": "true"}
        known = {name: value for name, value in os.environ.items() if name not in hidden}
        begin = time.perf_counter()
        making = subprocess.Popen(
            ["make", "app"], cwd=f"{folder}/tree", env={**known, **own},
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True,
        )  # fmt: skip
        try:
            address = printed_address(making)
            until_address = time.perf_counter() - begin
            return until_address, picture_time(browser, address)
        finally:
            os.killpg(making.pid, signal.SIGTERM)
            making.communicate()


def printed_address(making: subprocess.Popen[str]) -> str:
    """Return the address that the laboratory prints when it can be opened."""
    assert making.stderr is not None
    said = []
    for line in making.stderr:
        said.append(line)
        if found := re.search(r"http://[\d.]+:\d+", line):
            return found[0]
    raise SystemExit("make app ended without an address:\n" + "".join(said[-20:]))


def picture_time(browser: Browser, address: str) -> float | None:
    """Return the seconds from opening the page to its first drawn answer; None where it never came."""
    page = browser.new_page()
    begin = time.perf_counter()
    try:
        page.goto(address, timeout=1000 * PATIENCE)
        page.locator("#view[data-answered]").wait_for(timeout=1000 * PATIENCE)
        return time.perf_counter() - begin
    except BrowserError:
        return None
    finally:
        page.close()


@contextmanager
def busily(count: int) -> Iterator[None]:
    """Keep so many processors busy meanwhile."""
    spinning = [subprocess.Popen([sys.executable, "-c", SPIN]) for _ in range(count)]
    try:
        yield
    finally:
        for process in spinning:
            process.kill()
            process.wait()


if __name__ == "__main__":
    sys.exit(main(*(int(word) for word in sys.argv[1:3])))

"""Bats, balls and analyses that many tests share, and running the command line inside a test."""

from __future__ import annotations

import gc
import json
import os
import sys
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import HealthCheck, settings

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command line does; before anything loads the library
os.environ["SWEETSPOT_CONFIG"] = ""  # nobody's settings
os.environ.pop("COLUMNS", None)  # xdist's workers say 80; nobody reads a table there
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # what one program has compiled the next that a test starts need not

from sweetspot import catalog
from sweetspot.analysis.bat_analysis import Analysis, analyse
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.cli import UNTIDIED, main, output
from sweetspot.equipment.ball import Ball
from sweetspot.equipment.bat import Bat
from sweetspot.equipment.material import Material
from sweetspot.reports.pictures import style
from tests import browsers

if TYPE_CHECKING:
    from playwright.sync_api import Browser

FEWER_DOTS = 4
style.DOTS_PER_INCH //= FEWER_DOTS  # they take long, and one test asks how many there are
sys.dont_write_bytecode = False  # nor the next run
FLAGS = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"]
FLAGS += ["--in-process-gpu", "--enable-features=NetworkServiceInProcess2"]  # two processes fewer to talk to

gc.set_threshold(UNTIDIED, *gc.get_threshold()[1:])  # as the command line does
output.BEAT = output.PATIENCE = 1e6  # s: on a busy machine a command says that it takes long, which no test looks for
# how long examples take says how busy the machine is; every run tries the same ones, so none fails by luck
settings.register_profile("sweetspot", deadline=None, suppress_health_check=[HealthCheck.too_slow], derandomize=True)
settings.register_profile("few", settings.get_profile("sweetspot"), max_examples=8)  # `make coverage`: each branch once
settings.load_profile("sweetspot")


@pytest.fixture(scope="session")
def ash() -> Material:
    return catalog.material("white-ash")


@pytest.fixture(scope="session")
def baseball() -> Ball:
    return catalog.ball("baseball")


@pytest.fixture(scope="session")
def r161() -> Bat:
    return catalog.bat("r161-ash")


@pytest.fixture(scope="session")
def analysis(r161: Bat) -> Analysis:
    """The flagship: an R161-like ash bat under the standard conditions."""
    return analyse(r161, standard_conditions(r161))


@pytest.fixture
def cone(ash: Material) -> Bat:
    """A plain cone, 25 mm to 65 mm over 0.84 m."""
    return Bat(name="cone", length=0.84, material=ash, profile=((0.0, 0.025), (0.84, 0.065)))


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    """Return a function that runs a command and returns (exit code, stdout, stderr)."""

    def command(*arguments: str) -> tuple[int, str, str]:
        with pytest.raises(SystemExit) as stopped:
            main(list(arguments))
        captured = capsys.readouterr()
        return int(stopped.value.code or 0), captured.out, captured.err

    return command


@pytest.fixture
def run_json(run: Callable[..., tuple[int, str, str]]) -> Callable[..., Any]:
    """Return a function that runs a command with ``--format json`` and returns what it printed."""

    def command(*arguments: str) -> Any:
        code, out, err = run(*arguments, "--format", "json")
        assert code == 0, err
        return json.loads(out)

    return command


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """A real browser; the test is skipped where there is none."""
    found = browsers.for_tests()
    if found is None:
        words = "no Chromium found: install it (`make browser` does on Debian as root) to test the page in a browser"
        if os.environ.get("CI") == "true":
            pytest.fail(words)
        pytest.skip(words)
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        opened = playwright.chromium.launch(executable_path=found, args=FLAGS)
        yield opened
        opened.close()

"""Modules of the page that need no browser, by the test runner of Node: `tests/web/node`."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sweetspot.reports.quantity_table import quantity_data
from sweetspot.web.page_modules import FOLDER

TESTS = Path(__file__).parent / "node"
NODE = shutil.which("node", path=str(Path(sys.executable).parent)) or shutil.which("node")


@pytest.mark.skipif(NODE is None, reason="Node, which comes with the development requirements, is not here")
def test_modules_of_the_page_pass_their_own_tests() -> None:
    files = sorted(str(path) for path in TESTS.glob("*.test.mjs"))
    settings = os.environ | {"PAGE": FOLDER.as_uri(), "QUANTITIES": json.dumps(quantity_data())}
    run = subprocess.run(
        [str(NODE), "--import", (TESTS / "quantities.mjs").as_uri(), "--test", "--test-reporter=spec", *files],
        env=settings, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == 0, run.stdout + run.stderr
    assert re.search(r"^\S+ pass [1-9]\d+$", run.stdout, re.MULTILINE), run.stdout

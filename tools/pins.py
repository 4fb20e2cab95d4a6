"""Whether the pinned versions can be installed as wheels by every Python and on every system that is promised.

Run by `make pins`. Exit code 1 where a pin has no wheel or a needed package no pin; without a network nothing can be
asked, which is said and is no failure.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path

ROOT = Path(__file__).parents[1]
UV = Path(sys.executable).with_name("uv")
PYTHONS = ("3.11.0", "3.12", "3.13", "3.14")
SYSTEMS = {
    "Linux": "x86_64-manylinux_2_28",
    "Linux on ARM": "aarch64-manylinux_2_28",
    "macOS on Apple silicon": "aarch64-apple-darwin",
    "Windows": "x86_64-pc-windows-msvc",
}
"""Macs with an Intel processor are left out, as README says: llvmlite has no wheel for them any more."""
MACOS = {"MACOSX_DEPLOYMENT_TARGET": "14.0"}
"""Of 2023: the wheels of av for Apple silicon want it, and Apple mends no older one."""
UNANSWERED = 2
"""uv's exit code where it could not ask."""


def names(text: str) -> set[str]:
    """Return the packages that a file of requirements names."""
    return set(re.findall(r"^([A-Za-z0-9._-]+)==", text, flags=re.MULTILINE))


def fault(pins: Path, python: str, system: str) -> str | None:
    """Return what is wrong with the pins there, "" for nothing, None where nobody could be asked."""
    words = [
        str(UV), "pip", "compile", "-q", "--only-binary", ":all:", "--no-header", "--no-annotate",
        "--python-version", python, "--python-platform", SYSTEMS[system], str(pins),
    ]  # fmt: skip
    answer = subprocess.run(words, capture_output=True, text=True, check=False, cwd=ROOT, env=os.environ | MACOS)
    if answer.returncode == UNANSWERED:
        return None
    if answer.returncode:
        return answer.stderr.strip()
    missing = names(answer.stdout) - names(pins.read_text(encoding="utf-8"))
    return f"not pinned: {', '.join(sorted(missing))}" if missing else ""


def main() -> int:
    """Ask for every Python and system; return the exit code."""
    cases = [(ROOT / "requirements.txt", *case) for case in product(PYTHONS, SYSTEMS)]
    cases += [(ROOT / "requirements-dev.txt", python, "Linux") for python in PYTHONS]
    with ThreadPoolExecutor(4) as pool:
        faults = list(pool.map(lambda case: fault(*case), cases))
    for (pins, python, system), words in zip(cases, faults, strict=True):
        if words:
            print(f"{pins.name} by Python {python} on {system}: {words}")
    unasked = sum(words is None for words in faults)
    if unasked:
        print(f"{unasked} of {len(cases)} Pythons and systems could not be asked: no network")
    else:
        print(f"pins checked for {len(cases)} Pythons and systems")
    return 1 if any(faults) else 0


if __name__ == "__main__":
    sys.exit(main())

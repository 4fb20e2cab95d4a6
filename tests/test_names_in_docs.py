"""Files, modules and commands that CONTRIBUTING, the decisions, the pages and the Makefile name are there."""

from __future__ import annotations

import re
import subprocess
from functools import cache
from pathlib import Path
from pkgutil import resolve_name

import pytest

import sweetspot
from tests.documented import DOCS

ROOT = DOCS.parent
PACKAGE = Path(sweetspot.__file__).parent
GUIDE = ROOT / "CONTRIBUTING.md"
TEXTS = [GUIDE, *sorted(DOCS.rglob("*.md"))]
CODE = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
FILE = re.compile(r"(?:[\w.-]+/)*[\w.-]+\.(?:py|js|toml|ts|bib|txt|md|json)|(?:[\w.-]+/)+[\w.-]*")
MODULE = re.compile(r"(?:sweetspot\.)?[a-z_]+(?:\.[a-z_]+)+(?:\.[A-Z]\w*)?")
PLACEHOLDERS = re.compile(r"NAME|FOLDER|mine|own|my_|\.\.\.")
OF_USERS = {"bat.toml", "changelog.md"}


@cache
def paths() -> frozenset[str]:
    """Return every file and folder, from the root, the package and the documentation."""
    folders = (ROOT / name for name in ("src", "docs", "tests", "tools", "studies", "benchmarks", ".ci"))
    found = [ROOT / ".ci", *ROOT.glob("*"), *(path for folder in folders for path in folder.rglob("*"))]
    tails = set()
    for path in found:
        parts = path.relative_to(ROOT).parts
        tails |= {"/".join(parts[start:]) for start in range(len(parts))}
    return frozenset(tails)


def packages() -> set[str]:
    return {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").is_file()}


def is_module(name: str) -> bool:
    """Return whether a dotted name begins like one of the package."""
    return name.removeprefix("sweetspot.").split(".")[0] in packages() | {"units"}


@pytest.mark.parametrize("path", TEXTS, ids=lambda path: path.relative_to(ROOT).as_posix())
def test_what_a_page_names_is_there(path: Path) -> None:
    gone = []
    for name in CODE.findall(path.read_text(encoding="utf-8")):
        if PLACEHOLDERS.search(name) or name in OF_USERS or name.startswith("..") or name.rstrip("/") in paths():
            continue
        if MODULE.fullmatch(name) and is_module(name):
            try:
                resolve_name(f"sweetspot.{name.removeprefix('sweetspot.')}")
            except (ImportError, AttributeError):
                gone.append(name)
        elif FILE.fullmatch(name) and (path == GUIDE or path.parent.name == "decisions"):
            gone.append(name)
    assert not gone


def test_the_map_of_the_house_has_every_folder() -> None:
    table = GUIDE.read_text(encoding="utf-8").partition("## Where things are")[2].partition("\n## ")[0]
    named = {name.rstrip("/") for line in table.splitlines() if line.startswith("|") for name in CODE.findall(line)}
    assert packages() <= named


def test_every_command_of_make_is_one() -> None:
    targets = set(re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.MULTILINE))
    text = GUIDE.read_text(encoding="utf-8")
    named = set(re.findall(r"(?:^|`)make ([\w-]+)", text, flags=re.MULTILINE))
    assert len(named) > 10 and named <= targets


def test_what_the_makefile_runs_is_there() -> None:
    targets = re.findall(r"^\.PHONY: (.*)$", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE)[0].split()
    dry = [target for target in targets if target != "js"]  # which calls make, and a line that does is run even so
    told = subprocess.run(["make", "-n", *dry], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    named = set(re.findall(r"(?<![\w./-])(?:tests|tools|src|benchmarks|studies)/[\w./-]+", told))
    assert len(named) > 30
    assert not [name for name in sorted(named) if not (ROOT / name).exists()]

"""The documentation's examples run, its bat files are valid, its commands exist, and its links to figures resolve."""

from __future__ import annotations

import doctest
import re
import shlex
import tomllib
from pathlib import Path

import pytest

from sweetspot.catalog.files.implement import implement_from_table
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat

DOCS = Path(__file__).parents[1] / "docs"
PAGES = sorted(path for path in DOCS.rglob("*.md") if not {"_build", "_generated"} & set(path.relative_to(DOCS).parts))
NAMES = [str(path.relative_to(DOCS)) for path in PAGES]
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(page: Path, language: str) -> list[str]:
    return [found[2] for found in BLOCK.finditer(page.read_text(encoding="utf-8")) if found[1] == language]


def fences_blanked(text: str) -> str:
    """Return a page with its fences as empty lines, so that doctest sees where expected output ends."""
    return re.sub(r"^```.*$", "", text, flags=re.MULTILINE)


@pytest.mark.parametrize("page", [page for page in PAGES if ">>>" in page.read_text(encoding="utf-8")], ids=str)
def test_examples_of_a_page(page: Path) -> None:
    text = fences_blanked(page.read_text(encoding="utf-8"))
    test = doctest.DocTestParser().get_doctest(text, {}, page.name, str(page), 0)
    report: list[str] = []
    result = doctest.DocTestRunner().run(test, out=report.append)
    assert result.attempted > 0
    assert result.failed == 0, "".join(report)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "toml")], ids=str)
def test_bat_files_of_a_page(page: Path) -> None:
    for text in blocks(page, "toml"):
        made = implement_from_table(tomllib.loads(text), page.name)
        least = 0.5 if isinstance(made, Bat) else 0.05
        assert least < rigid_body(beam_model(made)).mass < 1.3, made.name


def command_lines() -> list[str]:
    lines = (line for page in PAGES for text in blocks(page, "console") for line in text.splitlines())
    return sorted({line.removeprefix("$ ") for line in lines if line.startswith("$ sweetspot ")})


@pytest.mark.parametrize("line", command_lines())
def test_commands_are_understood(line: str) -> None:
    """Each command line parses: command, options and the number of arguments exist. It is not run here."""
    from sweetspot.cli.app import app

    words = shlex.split(re.sub(r" (>|#).*", "", line))[1:]
    command, bound, _ = app.parse_args(words, exit_on_error=False, print_error=False)
    assert command.__name__.replace("_", "-") == words[0]
    assert bound.args or bound.kwargs or len(words) == 1


def test_every_page_is_reached_from_the_contents() -> None:
    contents = "\n".join((DOCS / name).read_text(encoding="utf-8") for name in ("index.md", "reference/index.md"))
    listed = {line.strip() for line in contents.splitlines()}
    missing = [name for name in NAMES if name != "index.md" and name.removesuffix(".md") not in listed]
    assert missing == []

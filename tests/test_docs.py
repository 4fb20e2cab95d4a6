"""The documentation's examples run, its bat files are valid, its commands exist, and its links to figures resolve."""

from __future__ import annotations

import doctest
import re
import shutil
import tomllib
from pathlib import Path
from pkgutil import resolve_name

import pytest

import sweetspot
from sweetspot import catalog, references
from sweetspot.catalog.balls import ball_of_text
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.cli import main
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.bat import Bat
from tests.documented import (
    DOCS,
    EXIT_CODES,
    LONG,
    NEEDS_ONE_S_OWN,
    PAGES,
    TUTORIALS,
    WITH_TUTORIAL,
    arguments,
    blocks,
    command_lines,
    is_parsed_only,
    name_of,
    tutorial,
    write_files,
)
from tests.golden.commands import commands as golden_commands
from tests.test_readme import COMMANDS as README_COMMANDS

NAMES = [str(path.relative_to(DOCS)) for path in PAGES]
RUN_ELSEWHERE = {*golden_commands(), *(line.removeprefix("sweetspot ") for line in README_COMMANDS)}
"""Command lines that other tests run: numbers that are kept, and the README."""


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
def test_files_of_a_page(page: Path) -> None:
    texts = blocks(page, "toml")
    balls = [text for text in texts if tomllib.loads(text).get("like") in catalog.ball_names()]
    for text in balls:
        assert ball_of_text(text).name == tomllib.loads(text)["name"]
    for text in texts:
        if text in balls:
            continue
        made = implement_from_table(tomllib.loads(text), page.name)
        least = 0.5 if isinstance(made, Bat) else 0.05
        assert least < rigid_body(beam_model(made)).mass < 1.3, made.name


WITH_COMMANDS = [page for page in PAGES if command_lines(page)]


def is_run_elsewhere(line: str) -> bool:
    return re.sub(r" --format json| [>#].*", "", line.removeprefix("sweetspot ")) in RUN_ELSEWHERE


@pytest.mark.parametrize("page", WITH_COMMANDS, ids=name_of)
def test_commands_of_a_page_run(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """One after the other, as a reader would; only those in `tests.documented` that name their reason are not run."""
    monkeypatch.chdir(tmp_path)
    write_files(tmp_path, page)
    for line in command_lines(page):
        if is_parsed_only(line) or is_run_elsewhere(line):
            continue
        with pytest.raises(SystemExit) as stopped:
            main(arguments(line))
        captured = capsys.readouterr()
        assert (stopped.value.code or 0) == EXIT_CODES.get(line.removeprefix("sweetspot "), 0), captured.err
        assert captured.out or "wrote" in captured.err, line


TUTORIAL_CODES = {"certify tested.toml --shots shots.csv": 1, "certify tested.toml --uncertainty": 1}
"""Of lines of tutorials that end otherwise than with 0: the laboratory's bat breaks a rule."""


@pytest.mark.parametrize("name", WITH_TUTORIAL)
def test_a_tutorial_from_beginning_to_end(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """With the files that it names and no others, line after line; every answer is the one that the page prints."""
    monkeypatch.chdir(shutil.copytree(TUTORIALS / name, tmp_path / name))
    monkeypatch.setenv("COLUMNS", "112")
    steps = tutorial(name)
    assert len(steps) > 3
    for line, parts in steps:
        with pytest.raises(SystemExit) as stopped:
            main(arguments(line))
        captured = capsys.readouterr()
        assert (stopped.value.code or 0) == TUTORIAL_CODES.get(line.removeprefix("sweetspot "), 0), captured.err
        answer, place = " ".join(captured.out.split()), 0
        for part in parts:
            words = " ".join(part.split())
            assert words in answer[place:], line
            place = answer.index(words, place) + len(words)


@pytest.mark.parametrize("name", WITH_TUTORIAL)
def test_a_tutorial_shows_its_tables_as_they_are(name: str) -> None:
    text = (DOCS / "users" / f"{name}.md").read_text(encoding="utf-8")
    shown = re.findall(r"^```text\n(.*?)```", text, re.MULTILINE | re.DOTALL)
    tables = [path.read_text(encoding="utf-8") for path in TUTORIALS.joinpath(name).glob("*.csv")]
    assert not tables or any(table.startswith(rows) for rows in shown for table in tables)


@pytest.mark.parametrize("line", sorted({one for page in PAGES for one in command_lines(page) if is_parsed_only(one)}))
def test_commands_that_are_not_run_are_understood(line: str) -> None:
    """Each parses: command, options and the number of arguments exist."""
    from sweetspot.cli.app import app

    words = arguments(line)
    command, bound, _ = app.parse_args(words, exit_on_error=False, print_error=False)
    assert command.__name__.replace("_", "-") == words[0]
    assert bound.args or bound.kwargs or len(words) == 1


def test_every_reason_not_to_run_a_command_is_used() -> None:
    lines = [line.removeprefix("sweetspot ") for page in PAGES for line in command_lines(page)]
    unused = [
        start for start in (*NEEDS_ONE_S_OWN, *LONG, *EXIT_CODES) if not any(line.startswith(start) for line in lines)
    ]
    assert not unused


def test_python_blocks_are_examples_that_run() -> None:
    """A block without ``>>>`` would be run by nobody."""
    assert not [(name_of(page), text) for page in PAGES for text in blocks(page, "python") if ">>>" not in text]


PACKAGE = Path(sweetspot.__file__).parent
DOTTED = re.compile(r"`([a-z]\w*(?:\.\w+)+)(?:\([^`]*\))?`")


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_names_of_the_package_exist(page: Path) -> None:
    """A dotted name in running text that begins with one of our folders is a module, or something in one."""
    folders = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    for name in DOTTED.findall(page.read_text(encoding="utf-8")):
        if name.split(".")[0] in folders and Path(name).suffix not in (".toml", ".py", ".json"):
            resolve_name(f"sweetspot.{name}")  # raises for a module that is not there, or does not have it


def test_every_page_is_reached_from_the_contents() -> None:
    contents = {"": "index.md", "reference/": "index.md", "decisions/": "index.md"}
    listed = {
        stem
        for folder, name in contents.items()
        for line in (DOCS / folder / name).read_text(encoding="utf-8").splitlines()
        for stem in (line.strip(), f"{folder}{line.strip()}")
    }
    missing = [name for name in NAMES if name != "index.md" and name.removesuffix(".md") not in listed]
    assert missing == []


@pytest.mark.parametrize("page", PAGES, ids=str)
def test_keys_of_sources_are_links(page: Path) -> None:
    bare = re.findall(r"\[([a-z][a-z0-9_]*(?:[,;] [^\]]*)?)\](?!\()", page.read_text(encoding="utf-8"))
    known = set(references.keys())
    assert not [text for text in bare if known & set(re.split(r"[;, ]+", text))]


def test_every_public_name_is_on_the_page_of_the_api() -> None:
    """Once, under the name that programs import; `docs/conf.py` looks whether the built inventory has it."""
    text = (DOCS / "api.md").read_text(encoding="utf-8")
    named = re.findall(r"^\.\. auto(?:function|class|module):: sweetspot\.(\w+)$", text, re.MULTILINE)
    assert sorted(named) == sorted(sweetspot.__all__)


def test_pages_are_found_in_both_spellings(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(DOCS / "_ext")
    from spellings import other_spellings  # type: ignore[import-not-found]

    assert other_spellings("An aluminum bat's center, two meters long") == ["aluminium", "centre", "metre"]
    assert other_spellings("The catalogue of colours") == ["catalog", "color"]
    assert not other_spellings("A bat")


def test_the_picture_of_the_house_has_every_layer(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is drawn from the imports, and none goes from a lower layer to an upper one."""
    monkeypatch.syspath_prepend(DOCS)
    from imports import arrows, layers  # type: ignore[import-not-found]

    rank = {name: number for number, row in enumerate(layers()) for name in row}
    found = arrows()
    assert len(found) > 100 and {name for pair in found for name in pair} == set(rank)
    assert [pair for pair in found if rank[pair[0]] > rank[pair[1]]] == []

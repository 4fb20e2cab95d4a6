"""Every command and every answer of the README is run and compared."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from sweetspot.cli import main
from tests.golden.commands import commands as golden_commands

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"```(\w+)\n(.*?)```", README, flags=re.DOTALL)
SHELL_LINES = [line for kind, text in BLOCKS if kind == "sh" for line in text.splitlines()]
ANSWERS = re.findall(r"<!-- answer: (sweetspot .*?) -->\n```text\n(.*?)```", README, flags=re.DOTALL)
COMMANDS = [line.split("#")[0].strip() for line in SHELL_LINES if line.startswith("sweetspot ")]
NUMBERS_KEPT = {f"sweetspot {command}" for command in golden_commands()}
"""Command lines that the test of the kept numbers runs."""


def block(kind: str) -> str:
    return next(str(text) for name, text in BLOCKS if name == kind)


def flat(text: str) -> str:
    return " ".join(text.split())


@pytest.mark.parametrize(("command", "answer"), ANSWERS)
def test_the_answer_is_the_one_it_prints(command: str, answer: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(shlex.split(command)[1:])
    assert not stopped.value.code
    assert flat(answer) in flat(capsys.readouterr().out)


def test_there_are_commands() -> None:
    assert len(COMMANDS) >= 15
    assert len(ANSWERS) == README.count("```text")


@pytest.mark.parametrize("command", [command for command in COMMANDS if command not in NUMBERS_KEPT])
def test_commands_run(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("my_bat.toml").write_text(block("toml"), encoding="utf-8")
    with pytest.raises(SystemExit) as stopped:
        main(shlex.split(command)[1:])
    captured = capsys.readouterr()
    assert not stopped.value.code, captured.err
    assert captured.out


def test_the_python_lines_print_what_they_say(capsys: pytest.CaptureFixture[str]) -> None:
    exec(compile(block("python"), "README.md", "exec"), {})
    assert f"prints `{capsys.readouterr().out.strip()}`" in README


def test_make_targets_exist() -> None:
    makefile = (Path(__file__).parents[1] / "Makefile").read_text(encoding="utf-8")
    for target in re.findall(r"`?make (\w+)", README):
        assert re.search(rf"^{target}:", makefile, flags=re.MULTILINE), target

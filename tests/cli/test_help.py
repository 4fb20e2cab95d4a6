"""What --help tells: every command's first examples, which run as they stand, and no option that nobody needs."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from sweetspot.cli import main
from sweetspot.cli.app import EVERY_COMMAND, EXAMPLES, GROUPS, PATHS, app
from tests.documented import DOCS, write_files
from tests.golden.commands import commands as golden_commands

Run = Callable[..., tuple[int, str, str]]
WORDS = [words for examples in EXAMPLES.values() for words in examples]
PARSED_ONLY = ("app", "prepare", "new", "design", "match", "validate", "optimum --show parks")
"""Beginnings of examples that do not end, ask, take long, or need a racket of the reader; tests run their like."""
RUN_ELSEWHERE = frozenset(golden_commands())
"""Examples whose numbers the golden test keeps."""


def test_every_command_has_examples_of_its_own() -> None:
    assert all(EXAMPLES.values())
    assert all(words.split()[0] == command for command, examples in EXAMPLES.items() for words in examples)


def test_examples_run_one_after_the_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """As a reader would type them, with files of the reader's own."""
    monkeypatch.chdir(tmp_path)
    write_files(tmp_path, DOCS / "start.md")
    for words in WORDS:
        if words.startswith(PARSED_ONLY) or words in RUN_ELSEWHERE:
            continue
        if words.startswith("show"):  # writes over nothing
            (tmp_path / "my-bat.toml").unlink()
        with pytest.raises(SystemExit) as stopped:
            main(shlex.split(words))
        captured = capsys.readouterr()
        assert not stopped.value.code, (words, captured.err)
        assert captured.out or "wrote" in captured.err, words


@pytest.mark.parametrize("words", [one for one in WORDS if one.startswith(PARSED_ONLY)])
def test_examples_that_are_not_run_are_understood(words: str) -> None:
    command, *_ = app.parse_args(shlex.split(words), exit_on_error=False, print_error=False)
    assert command.__name__.replace("_", "-") == words.split(maxsplit=1)[0]


@pytest.mark.parametrize("command", PATHS)
def test_help_of_a_command(run: Run, command: str) -> None:
    code, out, _ = run(command, "--help")
    text = " ".join(out.split())
    assert code == 0 and all(f"sweetspot {words}" in text for words in EXAMPLES[command])
    assert "--empty-" not in out  # of lists that may be given again: leaving them out is enough
    assert not [
        noise for noise in ("[default: None]", "[default: False]", '[default: ""]', "[default: ()]") if noise in text
    ]


def test_help_of_all_says_what_holds_for_every_command(run: Run) -> None:
    code, out, _ = run("--help")
    assert code == 0 and EVERY_COMMAND in " ".join(out.split())


def test_an_answer_of_one_form_says_so(run: Run) -> None:
    for command in ("prepare", "schema", "show"):
        code, _, err = run(command, *(["r161-ash"] if command == "show" else []), "--json")
        assert code == 2 and f"{command} has no --json: its answer has one form" in err


def test_help_and_version_are_commands_to_those_who_type_them_so(run: Run) -> None:
    whole, of_hit = run("--help")[1], run("hit", "--help")[1]
    assert run("help") == (0, whole, "") and run("help", "hit") == (0, of_hit, "")
    assert run("version")[1] == run("-V")[1] == run("--version")[1]


@pytest.mark.parametrize(
    ("columns", "commands"), [("1", EXAMPLES), *((columns, ["design"]) for columns in ("0", "2", "3", "10", "40"))]
)  # every command, and the one with most options
def test_help_ends_however_narrow_the_terminal(
    run: Run, monkeypatch: pytest.MonkeyPatch, columns: str, commands: Iterable[str]
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    for command in commands:
        assert run(command, "--help")[0] == 0


def test_every_command_stands_in_one_group_of_the_overall_help(run: Run) -> None:
    grouped = [command for commands in GROUPS.values() for command in commands]
    assert sorted(grouped) == sorted(PATHS)
    _, out, _ = run("--help")
    assert [title for title in GROUPS if title in out] == list(GROUPS)
    assert out.index("report") < out.index("hit") < out.index("calibrate") < out.index("validate")


def test_a_shell_learns_every_command_and_option(tmp_path: Path, run: Run) -> None:
    script = tmp_path / "completions"
    code, _, _ = run("--install-completion", "--shell", "zsh", "--output", str(script))
    text = script.read_text(encoding="utf-8")
    assert code == 0 and all(command in text for command in PATHS)
    assert all(option in text for option in ("--launch-angle", "--what-if", "--league", "--bat-speed"))

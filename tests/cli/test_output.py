"""Whatever stands at the other end of standard output, files are written and the last word is one clear line."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from sweetspot.cli import main
from sweetspot.cli.output import print_json

FLY = ["fly", "--exit-speed", "100mph", "--format", "csv"]


class Fails(io.StringIO):
    """A standard output that fails when it is written."""

    def __init__(self, error: OSError) -> None:
        super().__init__()
        self.error = error

    def write(self, text: str) -> int:  # noqa: ARG002 - a stream's signature
        raise self.error


@pytest.mark.parametrize(
    ("stream", "code", "said"),
    [
        (Fails(BrokenPipeError(32, "Broken pipe")), 0, ""),
        (
            Fails(OSError(28, "No space left on device")),
            2,
            "standard output cannot be written: no space left on device",
        ),
        (Fails(OSError(5, "Input/output error")), 2, "standard output cannot be written: input/output error"),
        (None, 2, "standard output is closed, so nothing could be printed"),
    ],
)
def test_files_are_written_whoever_reads(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    stream: io.StringIO | None,
    code: int,
    said: str,
) -> None:
    monkeypatch.setattr(sys, "stdout", stream)
    with pytest.raises(SystemExit) as stopped:
        main([*FLY, "--out", str(tmp_path / "out")])
    assert stopped.value.code == code
    assert {"fly.json", "fly.png", "fly.svg"} <= {path.name for path in (tmp_path / "out").iterdir()}
    lines = capsys.readouterr().err.splitlines()
    assert lines[-1].removeprefix("sweetspot: ") == said if said else lines[-1].startswith("sweetspot: wrote")


@pytest.mark.parametrize("encoding", ["ascii", "cp437", "cp1252", "latin-1"])
def test_signs_that_a_terminal_lacks_cost_a_question_mark(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], encoding: str
) -> None:
    profile = 'profile = [["0 in", "1 in"], ["33 in", "2.5 in"]]'
    text = f'name = "\u68d2 bat"\nlength = "33 in"\nmaterial = "white ash"\n{profile}\n'
    (tmp_path / "bat.toml").write_text(text, encoding="utf-8")
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding=encoding))
    with pytest.raises(SystemExit) as stopped:
        main(["certify", str(tmp_path / "bat.toml")])
    assert stopped.value.code in (0, 1)
    assert b"? bat" in raw.getvalue()
    assert f"characters that {encoding} does not have were printed as ?" in capsys.readouterr().err


def test_signs_of_numbers_are_spelled_where_a_terminal_lacks_them(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr(sys, "stdout", io.TextIOWrapper(raw, encoding="ascii"))
    with pytest.raises(SystemExit):
        main(["bats"])
    with pytest.raises(SystemExit):
        main(["fly", "--exit-speed", "100mph", "--launch-angle", "27deg"])
    printed = raw.getvalue().decode("ascii")
    rows = [line for line in printed.splitlines() if "+/-" in line and "oz in^2" in line]
    assert len(rows) > 10 and len({len(row.rstrip()) for row in rows}) == 1, "columns stay columns"
    assert "27.0deg up" in printed and "?" not in printed and "?" not in capsys.readouterr().err


@pytest.mark.parametrize(("columns", "widest"), [("80", 80), ("150", 150), ("", 110), ("many", 110)])
def test_a_piped_text_is_as_wide_as_columns_says(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], columns: str, widest: int
) -> None:
    monkeypatch.setenv("COLUMNS", columns)
    with pytest.raises(SystemExit):
        main(["report", "r161-ash"])
    lines = capsys.readouterr().out.splitlines()
    assert 0.9 * widest < max(map(len, lines)) <= widest


def test_no_column_is_narrower_than_its_words(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Of ten columns on a narrow screen the names stay whole, and the lines become longer than it."""
    monkeypatch.setenv("COLUMNS", "50")
    with pytest.raises(SystemExit):
        main(["sports"])
    printed = capsys.readouterr().out
    assert all(name in printed for name in ("baseball", "cricket", "tennis", "badminton", "specified", "measured"))
    assert "baseball          " in printed


def test_sentences_keep_to_a_narrow_screen_that_tables_need_more_than(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "40")
    with pytest.raises(SystemExit):
        main(["report", "r161-ash"])
    printed = capsys.readouterr().out
    sentences, tables = printed.split("Every sweet spot")
    assert max(len(line.rstrip()) for line in sentences.splitlines()) <= 40
    assert max(len(line.rstrip()) for line in tables.splitlines()) > 40


def test_a_command_that_fails_prints_nothing_on_standard_output(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main(["pendulum", "--mass", "31oz", "--balance-point", "2in", "--period", "1.5s"])
    assert capsys.readouterr().out == ""


def test_a_reader_that_has_enough_and_closed_ends(tmp_path: Path) -> None:
    """Real processes: a pipe that closes, standard output and standard error closed, a full device."""
    command = f"{sys.executable} -m sweetspot schema"
    for shell, code, said in (
        (f"{command} | head -c 10 > /dev/null; exit ${{PIPESTATUS[0]}}", 0, ""),
        (f"{command} >&- 2>&-", 2, ""),
        (f"{command} > /dev/full", 2, "sweetspot: standard output cannot be written: no space left on device"),
    ):
        result = subprocess.run(["bash", "-c", shell], capture_output=True, text=True, check=False, timeout=600)
        heard = result.stderr.splitlines()
        assert (result.returncode, "\n".join(heard).strip()) == (code, said), shell


def test_json_has_no_infinities(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(ValueError, match="Out of range"):
        print_json({"value": float("nan")})
    capsys.readouterr()
    print_json({"value": 1.5})
    assert json.loads(capsys.readouterr().out) == {"value": 1.5}


@pytest.mark.parametrize("command", [["play"], ["fly", "--exit-speed", "100mph"], ["compare", "mlb-a", "mlb-b"]])
def test_a_folder_that_cannot_be_is_refused_before_anything_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], command: list[str]
) -> None:
    def computed(*arguments: object, **options: object) -> None:
        raise AssertionError("computed first")

    for name in ("sweetspot.cli.output.present", "sweetspot.catalog.load_bat", "sweetspot.catalog.ball"):
        monkeypatch.setattr(name, computed)
    (tmp_path / "file").write_text("in the way")
    with pytest.raises(SystemExit) as stopped:
        main([*command, "--out", str(tmp_path / "file" / "folder")])
    assert stopped.value.code == 2
    assert "is not a folder; choose another place" in capsys.readouterr().err


def test_long_work_shows_on_a_terminal_how_long_it_takes_and_leaves_nothing(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    heard = ""

    def slow(*words: object, **options: object) -> str:
        nonlocal heard
        while heard.count("working, ") < 2:
            time.sleep(0.01)
            heard += capsys.readouterr().err
        return "done"

    monkeypatch.setattr("sweetspot.cli.output._shows_progress", lambda: True)
    monkeypatch.setattr("sweetspot.cli.output.PATIENCE", 0.02)
    monkeypatch.setattr("sweetspot.cli.output.BEAT", 0.02)
    monkeypatch.setattr("sweetspot.catalog.entries.entry_toml", slow)
    with pytest.raises(SystemExit) as stopped:
        main(["show", "r161-ash"])
    last = capsys.readouterr()
    assert stopped.value.code == 0
    assert last.out.endswith("done") and (heard + last.err).endswith("\r\033[K")
    assert not any(thread.name == "patience" and thread.is_alive() for thread in ended())


@pytest.mark.parametrize("quiet", [[], ["--quiet"], ["-q"]])
def test_nothing_goes_into_a_log_but_what_was_written_and_quiet_keeps_that_too(
    quiet: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sweetspot.cli.output.PATIENCE", 0.0)
    with pytest.raises(SystemExit):
        main(["show", "r161-ash", "--out", str(tmp_path / "mine.toml"), *quiet])
    assert capsys.readouterr().err == ("" if quiet else f"sweetspot: wrote {tmp_path / 'mine.toml'}\n")


def ended() -> list[threading.Thread]:
    """Threads that are left after those that end have had their time."""
    for thread in threading.enumerate():
        if thread.name == "patience":
            thread.join(20)
    return threading.enumerate()

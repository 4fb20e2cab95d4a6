"""Every command under every fault of disk, memory and system: one clear line, and the folder is as it was.

What a single file meets, call by call, stands in tests/reports/test_file_set.py.
"""

from __future__ import annotations

import errno
import os
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from sweetspot import validation
from sweetspot.cli import app
from sweetspot.errors import InputError
from sweetspot.reports import files
from sweetspot.reports.pictures import style
from sweetspot.validation.cases import sources
from sweetspot.validation.verdicts import judged
from tests.full_disk import no_file_beyond
from tests.seasons.conftest import made_up

Run = Callable[..., tuple[int, str, str]]
SWINGS = """bat_speed_mph,exit_speed_mph,launch_angle_deg,pitch_speed_mph
70,95,20,85
71,98,12,88
69,80,35,84
72,99,15,90
70,90,8,86
73,101,22,91
"""
BATS = """name,mass_oz,balance_point_in
A,31.00±0.05,22.05±0.05
B,31.00±0.05,22.15±0.05
"""
WEIGHED = ("--mass", "31oz", "--balance-point", "22in")
COMMANDS: dict[str, tuple[str, ...]] = {
    "bats": ("bats", "--out", "OUT"),
    "calibrate": ("calibrate", "r161-ash", *WEIGHED, "--out", "OUT"),
    "compare": ("compare", "r161-ash", "textbook", "--out", "OUT"),
    "calibrate-ball": ("calibrate-ball", "tennis", "--drop", "254cm:135cm±1cm", "--out", "OUT"),
    "certify": ("certify", "r161-ash", "--out", "OUT"),
    "design": ("design", "--population", "8", "--generations", "1", "--want", "exit-speed", "--out", "OUT"),
    "drop": ("drop", "--out", "OUT"),
    "fit-player": ("fit-player", "SWINGS", "--bat", "r161-ash", "--out", "OUT"),
    "fly": ("fly", "--exit-speed", "100mph", "--out", "OUT"),
    "hit": ("hit", "r161-ash", "--at", "6in-from-tip", "--out", "OUT"),
    "kit": ("kit", "r161-ash", "--out", "OUT"),
    "match": ("match", "tennis-racket", "tennis-racket", "--out", "OUT"),
    "materials": ("materials", "--out", "OUT"),
    "optimum": ("optimum", "--out", "OUT"),
    "outline": ("outline", "r161-ash", "--out", "OUT.toml", "--out", "OUT.svg"),
    "paper": ("paper", "--out", "OUT"),
    "parks": ("parks", "--out", "OUT"),
    "pendulum": ("pendulum", *WEIGHED, "--period", "1.55s", "--out", "OUT"),
    "plan-swings": ("plan-swings", "r161-ash", "--out", "OUT"),
    "play": ("play", "r161-ash", "--out", "OUT"),
    "rank": ("rank", "BATS", "--like", "r161-ash", "--same-speed", "--out", "OUT"),
    "report": ("report", "r161-ash", "--out", "OUT"),
    "show": ("show", "r161-ash", "--out", "OUT"),
    "sports": ("sports", "--out", "OUT"),
    "tap": ("tap", "--synthesise", "youth-30", "--out", "OUT.wav"),
    "validate": ("validate", "--out", "OUT"),
}
OTHERS = {"new", "schema", "prepare", "app", "season"}
"""Commands that write nothing people ask for, one that writes part by part, and one whose file has a few lines."""
FULL = OSError(errno.ENOSPC, "No space left on device")
MANY = OSError(errno.EMFILE, "Too many open files")
BROKEN = OSError(errno.EIO, "Input/output error")
FAULTS: dict[str, tuple[Any, str, BaseException]] = {
    "make": (Path, "mkdir", FULL),
    "open": (Path, "open", MANY),
    "fsync": (os, "fsync", BROKEN),
    "rename": (Path, "rename replace", FULL),
    "allocate": (files, "_write_to_disk", MemoryError()),
}
"""What is asked for, and how it fails."""


def words_of(command: str, folder: Path) -> list[str]:
    """A command's words, with the files that it reads written to a folder."""
    (folder / "swings.csv").write_text(SWINGS)
    (folder / "bats.csv").write_text(BATS, encoding="utf-8")
    places = {"SWINGS": "swings.csv", "BATS": "bats.csv"}
    return [
        str(folder / places.get(word, word.lower())) if word.isupper() or word.startswith("OUT") else word
        for word in COMMANDS[command]
    ]


@contextmanager
def fault(name: str, folder: Path) -> Iterator[None]:
    """Make one kind of call fail where it concerns a folder; "write" is the system's own refusal of large files."""
    with pytest.MonkeyPatch.context() as patch:
        if name == "write":
            with no_file_beyond(20):
                yield
            return
        owner, calls, error = FAULTS[name]
        for call in calls.split():
            patch.setattr(owner, call, failing(getattr(owner, call), error, folder))
        yield


def failing(real: Callable[..., Any], error: BaseException, folder: Path) -> Callable[..., Any]:
    """Return a call that fails for files in a folder, and for files that are known by number only."""

    def fails(*given: Any, **options: Any) -> Any:
        if isinstance(given[0], int) or folder in Path(given[0]).parents:
            raise error
        return real(*given, **options)

    return fails


def faulty(real: Callable[..., Any], folder: Path, met: list[str]) -> Callable[..., Any]:
    """Return a way to write files that meets every fault in turn, then lets the command hear of one."""

    def write(*given: Any, **options: Any) -> Any:
        before = sorted(folder.rglob("*"))
        for name in (*FAULTS, "write"):
            with fault(name, folder), pytest.raises((InputError, MemoryError)) as refused:
                real(*given, **options)
            if name != "allocate":
                assert isinstance(refused.value, InputError), name
                assert len(str(refused.value)) < 600
            assert sorted(folder.rglob("*")) == before, name
            met.append(name)
        with fault("fsync", folder):
            return real(*given, **options)

    return write


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_under_every_fault(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    """Computed once, without threads or processes to be had; what is to be written then meets each fault."""

    def refused(*given: object, **options: object) -> None:
        raise RuntimeError("can't start new thread")

    def some_cases() -> list[Any]:
        return [
            judged(row, case) for case in sources() for row in case.rows if row.computation == "exit_speed_from_besr"
        ]

    words = words_of(command, tmp_path)
    monkeypatch.setattr(style, "png_bytes", lambda _: b"a picture, which would take long and is not what fails")
    monkeypatch.setattr(style, "svg_bytes", lambda _: b'<svg xmlns="http://www.w3.org/2000/svg"/>')
    monkeypatch.setattr(validation, "results", some_cases)
    monkeypatch.setattr("sweetspot.designs.local_search.LOOKS", 3)  # a bat found sooner is written like any other
    monkeypatch.setattr(threading.Thread, "start", refused)
    monkeypatch.setattr(os, "fork", refused)
    before, met = sorted(tmp_path.rglob("*")), list[str]()
    for name in ("write_folder", "write_all"):
        monkeypatch.setattr(files, name, faulty(getattr(files, name), tmp_path, met))
    code, out, err = run(*words)
    assert (code, out) == (2, ""), err
    assert "Traceback" not in err and "input/output error" in err.splitlines()[-1]
    assert set(met) == {*FAULTS, "write"}
    assert sorted(tmp_path.rglob("*")) == before


def test_no_command_is_forgotten() -> None:
    assert app.PATHS.keys() == COMMANDS.keys() | OTHERS


@pytest.mark.parametrize("name", ["write", "make", "open", "rename"])
def test_a_season_under_every_fault(run: Run, tmp_path: Path, name: str) -> None:
    """Its answers are written part by part, by a library of its own: the next run starts anew or goes on."""
    table = tmp_path / "table.parquet"
    made_up(42).write_parquet(table)
    words = ["season", str(table), "--flight-only", "--out", str(tmp_path / "out")]
    with fault(name, tmp_path):
        code, out, err = run(*words)
    assert (code, out) == (2, ""), err
    assert "Traceback" not in err
    assert any(words in err.splitlines()[-1] for words in ("cannot be written", "no space left", "too many open files"))
    assert not (tmp_path / "out" / "season.json").exists()
    code, out, _ = run(*words, "--resume")
    assert code == 0 and "42 balls in play" in out

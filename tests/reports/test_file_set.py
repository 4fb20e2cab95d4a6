"""Files of one answer: together or not at all, whatever the disk does, and on the disk before they have their names."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sweetspot.errors import InputError
from sweetspot.reports import files
from sweetspot.reports.files import check_folder, write_all, write_folder

NEW = {"report.json": b"new json", "report.png": b"new png", "report.html": b"new html"}
CALLS = ("open", "write", "fsync", "mkdir", "rename", "replace", "link")
"""What the system is asked for; each is made to fail the first, second, third and fourth time."""


def tree(folder: Path) -> dict[str, str]:
    """Everything below a folder, hidden things too."""
    return {
        str(path.relative_to(folder)): "folder" if path.is_dir() else path.read_text() for path in folder.rglob("*")
    }


def failing(monkeypatch: pytest.MonkeyPatch, call: str, at: int) -> None:
    """Make the ``at``-th call of a kind fail as on a full disk."""
    places: dict[str, tuple[Any, str]] = {
        "open": (Path, "open"), "mkdir": (Path, "mkdir"), "rename": (Path, "rename"), "replace": (Path, "replace"),
        "fsync": (os, "fsync"), "link": (os, "link"), "write": (files, "_write_to_disk"),
    }  # fmt: skip
    owner, name = places[call]
    real: Callable[..., Any] = getattr(owner, name)
    count = 0

    def fails(*arguments: Any, **options: Any) -> Any:
        nonlocal count
        count += 1
        if count == at:
            raise OSError(28, "No space left on device")
        return real(*arguments, **options)

    monkeypatch.setattr(owner, name, fails)


@pytest.mark.parametrize("at", [1, 2, 3, 4])
@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("before", ["nothing", "folder", "old set"])
def test_a_failing_disk_leaves_all_or_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, before: str, call: str, at: int
) -> None:
    folder = tmp_path / "deep" / "report"
    if before != "nothing":
        folder.mkdir(parents=True)
        (folder / "notes.txt").write_text("mine")
    if before == "old set":
        for name in NEW:
            (folder / name).write_text("old")
    old = tree(tmp_path)
    complete = {**old, "deep": "folder", "deep/report": "folder"}
    complete |= {f"deep/report/{name}": content.decode() for name, content in NEW.items()}
    refusal: str | None = None
    with monkeypatch.context() as fault:
        failing(fault, call, at)
        try:
            write_folder(folder, NEW)
        except InputError as error:
            refusal = str(error)
    # without a refusal that many calls of the kind are not made, or the system can do without
    assert tree(tmp_path) == (complete if refusal is None else old)
    assert refusal is None or ("cannot be" in refusal and "no space left on device" in refusal)
    write_folder(folder, NEW)
    assert tree(tmp_path) == complete


@pytest.mark.parametrize("below", ["taken", "taken/below"])
def test_a_file_in_the_way_is_refused_and_left_alone(tmp_path: Path, below: str) -> None:
    (tmp_path / "taken").write_text("mine")
    with pytest.raises(InputError, match="is not a folder"):
        check_folder(tmp_path / below, list(NEW))
    with pytest.raises(InputError, match="cannot be"):
        write_folder(tmp_path / below, NEW)
    assert tree(tmp_path) == {"taken": "mine"}


def test_folders_that_cannot_be_written_to_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "report.json").mkdir()
    with pytest.raises(InputError, match=r"report\.json is a folder"):
        write_folder(tmp_path, NEW)
    with pytest.raises(InputError, match="cannot be made"):
        write_folder(tmp_path / "a" / ("x" * 300), NEW)
    monkeypatch.setattr("os.access", lambda *_: False)
    with pytest.raises(InputError, match="no permission"):
        check_folder(tmp_path / "new", list(NEW))
    assert tree(tmp_path) == {"report.json": "folder"}


def test_an_interruption_between_two_files_gives_the_old_ones_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in list(NEW)[1:]:
        (tmp_path / name).write_text("old")
    before, real = tree(tmp_path), Path.replace

    def interrupted(path: Path, target: Path) -> Path:
        if target.name == "report.html" and path.parent.name != "old":
            raise KeyboardInterrupt
        return real(path, target)

    monkeypatch.setattr(Path, "replace", interrupted)
    with pytest.raises(KeyboardInterrupt):
        write_folder(tmp_path, NEW)
    assert tree(tmp_path) == before


def test_links_are_replaced_and_not_followed(tmp_path: Path) -> None:
    """Neither a link in place of a file, nor one that somebody laid where a temporary file may be guessed."""
    outside = tmp_path / "outside"
    outside.write_text("precious")
    folder = tmp_path / "report"
    folder.mkdir()
    (folder / "report.json").symlink_to(outside)
    (folder / f".report.json.{os.getpid()}.part").symlink_to(outside)
    write_folder(folder, NEW)
    assert outside.read_text() == "precious"
    assert not (folder / "report.json").is_symlink()
    assert (folder / "report.json").read_bytes() == b"new json"


def test_a_new_folder_has_ordinary_permissions(tmp_path: Path) -> None:
    (tmp_path / "usual").mkdir()
    write_folder(tmp_path / "new", NEW)
    assert (tmp_path / "new").stat().st_mode == (tmp_path / "usual").stat().st_mode
    assert write_folder(tmp_path / "absent" / ".." / "other", NEW)[0].read_bytes() == b"new json"
    assert (tmp_path / "other" / "report.json").exists()


def test_what_a_killed_run_left_goes_with_time(tmp_path: Path) -> None:
    old, young = tmp_path / ".sweetspot-old", tmp_path / ".sweetspot-young"
    for left in (old, young):
        left.mkdir()
        (left / "report.png").write_text("part of a picture")
    os.utime(old, (time.time() - 2 * files.ABANDONED,) * 2)
    write_all({tmp_path / "report.json": b"new"})
    assert sorted(path.name for path in tmp_path.iterdir()) == [".sweetspot-young", "report.json"]


def test_killed_runs_leave_whole_files_and_whole_new_folders(tmp_path: Path) -> None:
    """Sets written over and over, killed at any moment: no torn file, no new folder with half of its files."""
    code = """
import sys
from pathlib import Path
from sweetspot.reports.files import write_folder
print("ready", flush=True)
for number in range(10**6):
    content = {name: str(number).encode() * 20000 for name in ("a", "b", "c")}
    write_folder(Path(sys.argv[1]) / "same", content)
    write_folder(Path(sys.argv[1]) / f"new{number}", content)
"""
    for kill in range(4):
        place = tmp_path / str(kill)
        place.mkdir()
        with subprocess.Popen([sys.executable, "-c", code, str(place)], stdout=subprocess.PIPE) as process:
            assert process.stdout is not None
            process.stdout.readline()
            time.sleep(0.05 + 0.013 * kill)
            process.send_signal(signal.SIGKILL)
        for folder in place.glob("[!.]*"):
            contents = [path.read_bytes() for path in sorted(folder.glob("[!.]*"))]
            assert len(contents) == 3
            for content in contents:
                number = content[: len(content) // 20000]
                assert content == number * 20000
            assert folder.name == "same" or len(set(contents)) == 1

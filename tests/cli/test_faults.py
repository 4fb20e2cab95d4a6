"""Every command under every fault of the disk and the memory: one clear line, and the folder is as it was.

What a single file meets, call by call, stands in tests/report/test_file_set.py.
"""

from __future__ import annotations

import errno
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

from sweetspot.report import file_set, files

Run = Callable[..., tuple[int, str, str]]
SWINGS = """bat_speed_mph,exit_speed_mph,launch_angle_deg,pitch_speed_mph
70,95,20,85
71,98,12,88
69,80,35,84
72,99,15,90
70,90,8,86
73,101,22,91
"""
COMMANDS: dict[str, tuple[str, ...]] = {
    "bats": ("bats",),
    "compare": ("compare", "r161-ash", "textbook"),
    "certify": ("certify", "r161-ash"),
    "drop": ("drop",),
    "fit-player": ("fit-player", "SWINGS", "--bat", "r161-ash"),
    "fly": ("fly", "--exit-speed", "100mph"),
    "hit": ("hit", "r161-ash", "--at", "6in"),
    "optimum": ("optimum",),
    "paper": ("paper",),
    "parks": ("parks",),
    "pendulum": ("pendulum", "--mass", "31oz", "--balance-point", "22in", "--period", "1.55s"),
    "play": ("play", "r161-ash"),
    "report": ("report", "r161-ash"),
    "sports": ("sports",),
}


@dataclass(frozen=True)
class Fault:
    """A call that fails where it concerns the answer's folder, how, and what is then said (a pattern)."""

    owner: Any
    name: str
    error: BaseException
    said: str

    def arrange(self, patch: pytest.MonkeyPatch, folder: Path) -> None:
        real = getattr(self.owner, self.name)

        def call(*given: Any, **options: Any) -> Any:
            if folder in Path(given[0]).parents:
                raise self.error
            return real(*given, **options)

        patch.setattr(self.owner, self.name, call)


FULL = OSError(errno.ENOSPC, "No space left on device")
FAULTS = {
    "write": Fault(file_set, "_write_to_disk", FULL, "written: no space left on device"),
    "rename": Fault(Path, "rename", FULL, "made: no space left on device"),
    "allocate": Fault(file_set, "_write_to_disk", MemoryError(), "there is not enough memory for this"),
}


def arguments(command: str, folder: Path) -> list[str]:
    """A command's words, with the files that it reads written to a folder."""
    (folder / "swings.csv").write_text(SWINGS)
    return [str(folder / "swings.csv") if word == "SWINGS" else word for word in COMMANDS[command]]


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_under_every_fault(
    run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    words = [*arguments(command, tmp_path), "--out", str(tmp_path / "out")]
    before = sorted(tmp_path.iterdir())
    monkeypatch.setattr(files, "png_bytes", lambda _: b"")  # drawing takes long and is not what fails here
    monkeypatch.setattr(files, "svg_bytes", lambda _: b"")
    for name, fault in FAULTS.items():
        with monkeypatch.context() as patch:
            fault.arrange(patch, tmp_path)
            code, out, err = run(*words)
        assert (name, code, out) == (name, 2, "")
        assert fault.said in err.splitlines()[-1], name
        assert "Traceback" not in err
        assert sorted(tmp_path.iterdir()) == before, name

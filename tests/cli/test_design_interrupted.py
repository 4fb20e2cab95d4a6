"""A search for a bat meets Ctrl-C and a full disk: the front is kept, nothing is torn, and it goes on."""

from __future__ import annotations

import json
import signal
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.full_disk import no_file_beyond

Run = Callable[..., tuple[int, str, str]]
WORDS = ("design", "mlb-a", "--contact", "8in", "--population", "8", "--generations", "5", "--want", "exit-speed")
ENDLESS = """
import sys
from sweetspot.cli import main
from sweetspot.designs import local_search, pareto

local_search.LOOKS, local_search.WAYS, local_search.POINTS = 2, 1, 5
real = pareto._next_generation

def generation(bench, question, ends, parents):
    while parents.number == {number}:
        print("generation", parents.number, "begins", file=sys.stderr, flush=True)
        real(bench, question, ends, parents)
    return real(bench, question, ends, parents)

pareto._next_generation = generation
main(sys.argv[1:])
"""
"""The command, whose search stays in one generation, computing, until somebody ends it."""


def interrupted(words: tuple[str, ...], *, number: int) -> tuple[int, str, str]:
    """Run the command, press Ctrl-C while it computes that generation, and return code and what it says."""
    program = [sys.executable, "-c", ENDLESS.format(number=number), *words]
    with subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        for line in process.stderr:
            if line.startswith(f"generation {number} begins"):
                break
        process.send_signal(signal.SIGINT)
        said, heard = process.communicate(timeout=1200)
    return process.returncode, said, heard


@pytest.fixture
def short_polish(monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in (("LOOKS", 2), ("WAYS", 1), ("POINTS", 5)):
        monkeypatch.setattr(f"sweetspot.designs.local_search.{name}", value)


@pytest.mark.usefixtures("short_polish")
def test_ctrl_c_keeps_the_front_and_a_full_disk_tears_nothing(run: Run, tmp_path: Path) -> None:
    out = tmp_path / "out"
    code, said, heard = interrupted((*WORDS, "--out", str(out)), number=2)
    assert code == 0, heard
    assert "Traceback" not in heard and "Stopped after 2 of 5 generations" in said
    files = {path.name: path.read_bytes() for path in out.iterdir()}
    assert json.loads(files["search.json"])["generation"] == 2 and "designed-bat.toml" in files
    again = (*WORDS, "--resume", str(out / "search.json"), "--out", str(out))
    with no_file_beyond(20):
        code, said, heard = run(*again)
    assert (code, said) == (2, "") and "Traceback" not in heard
    assert "cannot be written" in heard.splitlines()[-1]
    assert {path.name: path.read_bytes() for path in out.iterdir()} == files
    code, said, _ = run(*again)
    assert code == 0 and "Stopped after" not in said
    assert json.loads((out / "search.json").read_text(encoding="utf-8"))["generation"] == 5
    whole = tmp_path / "whole"
    code, _, _ = run(*WORDS, "--out", str(whole))
    first, second = (json.loads((one / "design.json").read_text(encoding="utf-8")) for one in (out, whole))
    assert first["measures"] == pytest.approx(second["measures"], rel=1e-9)

"""Without the extras everything about a bat, its rules and its hits still works; what does not says what to install."""

from __future__ import annotations

import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from sweetspot.errors import DISTRIBUTIONS, NO_QUESTION, MissingExtraError, missing_extras_named, smallest_extras
from tests.documented import TUTORIALS

ROOT = Path(__file__).parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
BROUGHT = {
    "soundfile",
    "av",
    "ezdxf",
    "pymoo",
    "polars",
    "fastapi",
    "starlette",
    "uvicorn",
    "websockets",
    "pyuff",
    "segno",
}
"""Modules that no dependency of the core brings either."""
WITHOUT = f"""
import sys
class Nowhere:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in {BROUGHT!r}:
            raise ModuleNotFoundError("No module named " + repr(name), name=name)
sys.meta_path.insert(0, Nowhere())
from sweetspot.cli import main
import shlex
for line in sys.argv[1:]:
    try:
        main(shlex.split(line))
    except SystemExit as stopped:
        print("exit", stopped.code or 0, line, file=sys.stderr)
"""
CORE = (
    "report r161-ash --out report",
    "hit r161-ash --at sweet-spot",
    "compare r161-ash mlb-a",
    "certify college-alloy",
    f"certify college-alloy --shots {TUTORIALS / 'laboratory' / 'shots.csv'}",
    "play r161-ash --park fenway",
    "fly --exit-speed 90mph:110mph:2 --launch-angle 25deg:30deg:2",
    "paper",
    "optimum --show launch",
    "drop --height 1m",
    "pendulum --mass 31oz --balance-point 22in --period 1.45s",
    "new mine.toml --built metal --length 33in --mass 30oz",
    "bats",
    "schema hit",
    f"fit-player {TUTORIALS / 'coach' / 'swings.csv'}",
)
EXTRA = {
    "season swings.csv": ("polars", "season"),
    f"tap {TUTORIALS / 'metal_bat' / 'taps.flac'} --bat college-alloy --at 1in-from-tip": ("soundfile", "sound"),
    "outline r161-ash --out bat.dxf": ("ezdxf", "drawings"),
    "app --no-browser --port 0": ("uvicorn", "page"),
}


def run(lines: list[str], folder: Path) -> str:
    """Return what the command lines say on standard error where no extra is installed."""
    words = [sys.executable, "-c", WITHOUT, *lines]
    done = subprocess.run(words, cwd=folder, capture_output=True, text=True, check=False, timeout=600)
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_the_core_answers_without_any_extra(tmp_path: Path) -> None:
    said = run(list(CORE), tmp_path)
    assert [line for line in CORE if f"exit 0 {line}\n" not in said] == []
    assert (tmp_path / "report" / "report.png").is_file()


def test_what_is_missing_is_one_line_with_the_command_that_installs_it(tmp_path: Path) -> None:
    (tmp_path / "swings.csv").write_text("exit_speed_mph,launch_angle_deg\n100,25\n", encoding="utf-8")
    said = run(list(EXTRA), tmp_path).splitlines()
    wanted = [
        line
        for words, (package, extra) in EXTRA.items()
        for line in (
            f"sweetspot: this needs {package}, which is not installed: pip install 'sweetspot[{extra}]'",
            f"exit 2 {words}",
        )
    ]
    assert said == wanted


def test_all_holds_every_extra_of_a_question() -> None:
    parts = PROJECT["optional-dependencies"]
    (whole,) = parts["all"]
    assert set(whole.partition("[")[2].rstrip("]").split(",")) == set(parts) - NO_QUESTION - {"cluster"}
    assert not {name.partition(">")[0] for name in PROJECT["dependencies"]} & set(smallest_extras())


def test_every_blocked_module_is_of_an_extra() -> None:
    assert {DISTRIBUTIONS.get(name, name).lower() for name in BROUGHT} <= set(smallest_extras())


def test_another_missing_module_stays_what_it_is() -> None:
    with pytest.raises(ModuleNotFoundError) as raised, missing_extras_named():
        import no_such_module  # type: ignore[import-not-found]  # noqa: F401
    assert not isinstance(raised.value, MissingExtraError)


def test_the_documentation_lists_every_extra_with_what_it_brings() -> None:
    text = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    rows = {cells[1].strip(" `"): cells[3] for line in text.splitlines() if len(cells := line.split("|")) == 5}
    parts = PROJECT["optional-dependencies"]
    for extra in set(parts) - NO_QUESTION:
        own = {
            requirement.partition(">")[0] for requirement in parts[extra] if not requirement.startswith("sweetspot[")
        }
        assert own <= set(rows[extra].strip().split(", "))

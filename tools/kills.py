"""Kill commands at random moments, run them again, and compare what lies there with what an undisturbed run writes.

    python tools/kills.py [--runs N] [--seed S] [--only COMMAND]

``season`` and ``design`` go on where they were (``--resume``), ``calibrate`` and ``fit-player`` begin anew over what
was left. Each file must be the undisturbed run's, byte for byte, but for the line that tells how it was asked; a run
that is refused with exit 2 and one line counts as well. Exit 1 where anything else came out.
"""

from __future__ import annotations

import argparse
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import polars as pl

ROOT = Path(__file__).resolve().parents[1]
REFUSED = 2
TOLD = ("--resume", "--out")
"""In a line of a page that tells how it was asked, which another run may be told in other words."""


@dataclass(frozen=True)
class Killed:
    """A command that is killed.

    ``words``: after the program's name; ``{out}``: where it writes. ``again``: what is added when it is run again;
    ``needs``: a file without which it is run again as at first.
    """

    words: tuple[str, ...]
    again: tuple[str, ...] = ()
    needs: str = ""


def commands(folder: Path) -> dict[str, Killed]:
    """Write the files that commands ask for into a folder; return the commands by name."""
    rng = np.random.default_rng(6)
    balls, swings = 400_000, 120
    pl.DataFrame({
        "launch_speed": rng.normal(88, 12, balls).round(1), "launch_angle": rng.normal(12, 25, balls).round(1),
        "batter": rng.integers(1, 30, balls), "game_date": ["2024-05-04"] * balls,
    }).write_csv(folder / "balls.csv")  # fmt: skip
    fast = rng.normal(70, 3, swings)
    pl.DataFrame({
        "bat_speed_mph": fast.round(1), "pitch_speed_mph": rng.normal(88, 2, swings).round(1),
        "exit_speed_mph": (17 + 1.15 * fast - rng.exponential(6, swings)).round(1),
    }).write_csv(folder / "swings.csv")  # fmt: skip
    return {
        "season": Killed(("season", str(folder / "balls.csv"), "--flight-only", "--out", "{out}"), ("--resume",)),
        "design": Killed(
            ("design", "mlb-a", "--contact", "8in", "--population", "8", "--generations", "4", "--want", "exit-speed",
             "--out", "{out}"),
            ("--resume", "{out}/search.json"), needs="search.json",
        ),
        "calibrate": Killed(
            ("calibrate", "r161-ash", "--mass", "31.2oz±0.1oz", "--tone", "bending-1:168Hz±2Hz", "--out", "{out}")
        ),
        "fit-player": Killed(("fit-player", str(folder / "swings.csv"), "--bat", "r161-ash", "--out", "{out}")),
    }  # fmt: skip


def run(words: tuple[str, ...], out: Path, *, until: float | None = None) -> tuple[int, str]:
    """Run a command, killed after so many seconds; return its exit code and what it said on standard error."""
    program = [sys.executable, "-m", "sweetspot", *(word.format(out=out) for word in words)]
    with subprocess.Popen(program, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, cwd=ROOT) as process:
        try:
            _, said = process.communicate(timeout=until)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            _, said = process.communicate()
    return process.returncode, said.decode(errors="replace")


def contents(out: Path) -> dict[str, bytes]:
    """Return every file of an answer, without lines that tell how it was asked; leftovers of writers are none of it."""
    found = {}
    for path in sorted(out.rglob("*")):
        if path.is_file():
            content = path.read_bytes()
            if path.suffix in (".html", ".json", ".toml"):
                lines = content.split(b"\n")
                content = b"\n".join(line for line in lines if not any(told.encode() in line for told in TOLD))
            found[str(path.relative_to(out))] = content
    return found


def outcome(killed: Killed, whole: dict[str, bytes], out: Path, *, after: float) -> str:
    """Return what came of one run that was killed after so many seconds and run again."""
    code, _ = run(killed.words, out, until=after)
    if code == 0:
        return "was done before"
    again = not killed.needs or (out / killed.needs).exists()
    code, said = run((*killed.words, *(killed.again if again else ())), out)
    if code == REFUSED and "Traceback" not in said:
        return "refused"
    if code != 0 or "Traceback" in said:
        return f"FAULT: exit {code}: {said[-300:]}"
    now = contents(out)
    other = sorted(name for name in {*now, *whole} if now.get(name) != whole.get(name))
    return f"FAULT: other: {', '.join(other)[:300]}" if other else "the same"


def main() -> int:
    """Kill and compare; print how often what came out."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--runs", type=int, default=500)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="this command only")
    options = parser.parse_args()
    chance = random.Random(options.seed)
    folder = Path(tempfile.mkdtemp(prefix="sweetspot-kills-"))
    counted: Counter[tuple[str, str]] = Counter()
    try:
        known = {name: each for name, each in commands(folder).items() if options.only in name}
        wholes, lasted = {}, {}
        for name, killed in known.items():
            run(killed.words, folder / "first")  # compiles, and warms the disk
            shutil.rmtree(folder / "first", ignore_errors=True)
            began = time.monotonic()
            code, said = run(killed.words, folder / name)
            if code != 0:
                raise SystemExit(f"{name} ends with {code} undisturbed: {said[-500:]}")
            lasted[name], wholes[name] = time.monotonic() - began, contents(folder / name)
        for number in range(options.runs):
            name = chance.choice(list(known))
            out = folder / f"run{number}"
            found = outcome(known[name], wholes[name], out, after=chance.uniform(0.05, 1.0) * lasted[name])
            shutil.rmtree(out, ignore_errors=True)
            counted[name, found.partition(":")[0]] += 1
            if found.startswith("FAULT"):
                print(f"{name} {number}: {found}", flush=True)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    for (name, found), times in sorted(counted.items()):
        print(f"{name:<12} {found:<16} {times}")
    return 1 if any(found == "FAULT" for _, found in counted) else 0


if __name__ == "__main__":
    sys.exit(main())

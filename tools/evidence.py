"""Make every constant of the physics a fifth too small, then a quarter too large, and list what rows notice.

    python tools/evidence.py [--only TEXT] [--workers N] [--minutes M] [--out FILE]

A constant is a number of the catalogue (materials, balls, the air on them, swings, rubbers) or of a module (`MODULES`).
Each is changed in a copy of the package, times `FACTORS`, and every row that depends on it is computed again, with
a few answers that people ask for (`answers`). A row *notices* if it held before and no longer does; rows that miss
with an explanation do not count, as what they must keep is a value of ours. Which rows depend on a number of the
catalogue is seen from what they read; on a module, by changing all its constants at once, each by a part of its own.

Results are kept in build/evidence.json and taken up again while package and rows are the same. A full run writes
docs/evidence.json, from which docs/validation.md has its table.
"""

from __future__ import annotations

import argparse
import ast
import gc
import json
import math
import re
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from datetime import date
from functools import _lru_cache_wrapper, cache, partial
from importlib import import_module
from pathlib import Path
from queue import SimpleQueue
from typing import Any, Literal

if not __package__:  # run as a program
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from tools.mutants import PACKAGE, ROOT, Runner, fingerprint_of, serve

WORK = ROOT / "build" / "evidence"
KEPT = ROOT / "build" / "evidence.json"
SAVED = ROOT / "docs" / "evidence.json"
COMMAND = "make evidence"
FACTORS = (0.8, 1.25)
CATALOGUE = (
    "materials.toml", "balls.toml", "aerodynamics.toml", "swing_laws.toml", "rubbers.toml", "racket_stiffness.toml",
)  # fmt: skip
"""Files below catalog/ whose records are constants of the physics; the others describe things and rules."""
MODULES = {
    "analysis/bat_analysis.py": ("TYPICAL_HAND.mass", "TYPICAL_HAND.stiffness", "TYPICAL_HAND.damping"),
    "collision/oblique_contact.py": ("FRICTION", "TANGENTIAL_RESTITUTION"),
    "dynamics/block.py": ("ROLLING_SHEAR",),
    "dynamics/local_compliance.py": ("ACROSS_POISSON", "ACROSS_RATIO"),
    "dynamics/patch.py": ("PATCH_SPEED", "PATCH_COMPRESSION", "RECOIL"),
    "equipment/racket.py": ("GYRATION", "SHEAR_OVER_BENDING", "OVAL", "HOOP"),
    "equipment/section.py": ("FLAT_SHEAR",),
    "flight/aerodynamics.py": ("REFERENCE_REYNOLDS", "VISCOSITY"),
    "flight/air.py": ("DRY_DENSITY", "PRESSURE_FALL", "VAPOUR_LIGHTNESS", "MEAN_BREEZE.speed"),
    "flight/batted_spin.py": (
        "TRACKED.backspin.0", "TRACKED.backspin.1", "TRACKED.backspin.2",
        "TRACKED.sidespin.0", "TRACKED.sidespin.1", "TRACKED.sidespin.2",
    ),
}  # fmt: skip
"""Constants in modules; of a dictionary, a call or a tuple by the name or number of their part."""
IMPLEMENTS = (
    "r161-ash", "mlb-d", "single-wall", "composite", "slow-pitch", "tennis-racket", "cricket-bat", "golf-driver",
    "hockey-stick", "table-tennis-racket", "badminton-racket",
)  # fmt: skip
TESTED = ("mlb-d", "single-wall", "composite")
RECORD = re.compile(r'^(\w+) = \{ value = "?(-?\d[\d.]*(?:e-?\d+)?)')
PUBLISHED = ("prediction about bats", "other prediction")


class StaleError(Exception):
    """A constant is no longer where it was."""


@dataclass(frozen=True)
class Constant:
    """One number of the package: its file below the package, its name there, and where in the text it stands."""

    file: str
    name: str
    value: str
    start: int
    end: int
    kind: str = ""
    source: str = ""

    def __str__(self) -> str:
        return f"{Path(self.file).name}: {self.name}"

    def scaled(self, factor: float) -> str:
        """Return the text of the number times a factor."""
        if self.file.endswith(".py"):
            return f"({factor!r} * ({self.value}))"
        return f"{float(self.value) * factor:.9g}"


def constants(package: Path = PACKAGE) -> list[Constant]:
    """Return every constant of the physics.

    Raises
    ------
    StaleError
        when one of `MODULES` is not there.
    """
    found = [constant for file in CATALOGUE for constant in _records(f"catalog/{file}", package)]
    return found + [constant for file, names in MODULES.items() for constant in _in_module(file, names, package)]


def _records(file: str, package: Path) -> Iterator[Constant]:
    """Yield the numbers of a catalogue file that are not zero, which no factor changes."""
    table, at = "", 0
    for line in (package / file).read_text("utf-8").splitlines(keepends=True):
        if head := re.match(r"\[([\w-]+)\]", line):
            table = head[1]
        elif (record := RECORD.match(line)) and float(record[2]):
            kind, source = (re.search(rf'{key} = "(\w+)"', line) for key in ("kind", "source"))
            start, end = (at + place for place in record.span(2))
            name = f"{table}.{record[1]}"
            yield Constant(file, name, record[2], start, end, kind[1] if kind else "", source[1] if source else "")
        at += len(line)


def _in_module(file: str, names: Sequence[str], package: Path) -> Iterator[Constant]:
    text = (package / file).read_text("utf-8")
    starts = [0, *(match.end() for match in re.finditer("\n", text))]
    values = {
        target.id: node.value
        for node in ast.parse(text).body
        if isinstance(node, ast.Assign)
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    for name in names:
        first, *parts = name.split(".")
        try:
            node: Any = values[first]
            for part in parts:
                node = _part(node, part)
        except (KeyError, IndexError, StopIteration, AttributeError):
            raise StaleError(f"{file} has no {name}; MODULES of tools/evidence.py must follow") from None
        start, end = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
        yield Constant(file, name, text[start:end], start, end)


def _part(node: ast.expr, name: str) -> ast.expr:
    """Return an element of a tuple, a value of a dictionary or an argument of a call."""
    match node:
        case ast.Tuple(elts=elements):
            return elements[int(name)]
        case ast.Dict(keys=keys, values=values):
            return next(value for key, value in zip(keys, values, strict=True) if getattr(key, "value", None) == name)
        case ast.Call(keywords=keywords):
            return next(keyword.value for keyword in keywords if keyword.arg == name)
    raise KeyError(name)


def changed(text: str, factors: Sequence[tuple[Constant, float]]) -> str:
    """Return the text of a file with constants of it times factors."""
    for constant, factor in sorted(factors, key=lambda pair: -pair[0].start):
        text = text[: constant.start] + constant.scaled(factor) + text[constant.end :]
    return text


# --- in a fork, with the changed copy of the package -----------------------------------------------------------------


def items() -> dict[str, Callable[[], Any]]:
    """Return what can be computed, by name: every published row that is no arithmetic, and answers."""
    validation, verdicts = import_module("sweetspot.validation"), import_module("sweetspot.validation.verdicts")
    rows = {
        row_name(case.source, row): partial(_row_number, verdicts, row)
        for case in validation.sources()
        for row in case.rows
        if row.evidence in (*PUBLISHED, "calibrated")
    }
    return {**rows, **answers()}


def row_name(source: str, row: Any) -> str:
    """Return the name of a published row, of which there is one."""
    return f"{source}: {row.name}: {row.quantity}"


def _row_number(verdicts: Any, row: Any) -> float:
    return float(verdicts.computed_number(row) / verdicts.UNITS[row.unit])


def answers(*, drawn: bool = False) -> dict[str, Callable[[], Any]]:
    """Return what people ask, by name; ``drawn``: with 90 % intervals."""
    sweetspot = import_module("sweetspot")

    @cache  # a cache of this module, which `forget` clears
    def report(name: str) -> Any:
        return sweetspot.report(name, uncertainty=drawn)

    def carry(angle: str) -> Any:
        return sweetspot.fly(exit_speed="100 mph", launch_angle=angle, uncertainty=drawn).carry

    def certified(name: str) -> Any:
        return sweetspot.certify(name, uncertainty=drawn).test.bbcor

    asked: dict[str, Callable[[], Any]] = {}
    for name in IMPLEMENTS:
        asked[f"exit speed, {name}"] = partial(lambda name: report(name).best_hit.exit_speed, name)
        asked[f"best place, {name}"] = partial(lambda name: report(name).sweet_spots.max_exit_speed, name)
        asked[f"tone, {name}"] = partial(lambda name: report(name).modes[0].frequency, name)
    asked |= {f"BBCOR, {name}": partial(certified, name) for name in TESTED}
    asked |= {f"carry, 100 mph at {angle}": partial(carry, angle) for angle in ("18 deg", "28 deg")}
    asked["carry of a played hit"] = lambda: sweetspot.play("r161-ash", uncertainty=drawn).flight.carry
    return asked


def compute(arguments: list[str]) -> int:
    """Compute the items that a file of JSON names, and write them there; those that are refused are texts."""
    job = Path(arguments[0])
    asked = json.loads(job.read_text("utf-8"))
    if asked["what"] == "reads":
        job.write_text(json.dumps(reads()), "utf-8")
        return 0
    drawn = asked["what"] == "intervals"
    doable = answers(drawn=True) if drawn else items()
    done: dict[str, Any] = {}
    for name in doable if asked["items"] is None else asked["items"]:
        try:
            number = doable[name]()
        except Exception as error:
            done[name] = f"{type(error).__name__}: {error}"[:200]
        else:
            ends = [number.low, number.high] if hasattr(number, "low") else [float(number)] * 2
            done[name] = ends if drawn else (float(number) if math.isfinite(number) else "not finite")
    job.write_text(json.dumps(done), "utf-8")
    return 0


def reads() -> dict[str, list[str]]:
    """Return which records of the catalogue each item reads, ``table.field``, by the item's name."""
    entries = import_module("sweetspot.catalog.records").Entry
    read: set[str] = set()
    plain = entries._has

    def noted(entry: Any, field: str) -> Any:
        read.add(f"{entry.key}.{field}")
        return plain(entry, field)

    entries._has = noted
    found, every = {}, warmed()
    caches = package_caches()
    for name, number in every.items():
        forget(caches)
        read.clear()
        with suppress(Exception):
            number()
        found[name] = sorted(read)
    return found


def warmed() -> dict[str, Callable[[], Any]]:
    """Return the items, each computed once, so that everything is imported and what is compiled is loaded."""
    found = items()
    for number in found.values():
        with suppress(Exception):
            number()
    return found


def package_caches() -> list[Any]:
    """Return every cache of functions of the package and of this module."""
    ours = ("sweetspot", "tools", "__main__")
    every = [thing for thing in gc.get_objects() if isinstance(thing, _lru_cache_wrapper)]
    return [cached for cached in every if cached.__module__.startswith(ours)]


def forget(caches: Sequence[Any]) -> None:
    """Clear caches, so that the catalogue is read again."""
    for cached in caches:
        cached.cache_clear()


# --- the runs --------------------------------------------------------------------------------------------------------


class Laboratory:
    """Copies of the package in which constants are changed, some side by side.

    For numbers of the catalogue the package is loaded before it is forked; for those of a module it is not.
    """

    def __init__(self, workers: int, *, cold: bool = True) -> None:
        self.free: dict[bool, SimpleQueue[Runner]] = {True: SimpleQueue(), False: SimpleQueue()}
        self.runners = []
        for number in range(workers):
            for warm in (True, False)[: 1 + cold]:
                runner = Runner(WORK / f"{'warm' if warm else 'cold'}{number}", __file__, *(["--warm"] if warm else []))
                self.runners.append(runner)
                self.free[warm].put(runner)

    def computed(
        self,
        factors: Sequence[tuple[Constant, float]],
        names: Sequence[str] | None,
        what: Literal["numbers", "intervals", "reads"] = "numbers",
    ) -> dict[str, Any]:
        """Return the items of those names, None for all, with constants of one file times factors."""
        free = self.free[not factors or factors[0][0].file.endswith(".toml")]
        runner = free.get()
        package = runner.home / "src" / "sweetspot"
        path = package / factors[0][0].file if factors else None
        before = path.read_text("utf-8") if path else ""
        job = runner.home / "job.json"
        job.write_text(json.dumps({"items": names, "what": what}), "utf-8")
        try:
            if path:
                path.write_text(changed(before, factors), "utf-8")
            code = runner.exit_code([str(job)])
            if code != 0:
                log = (runner.home / "tests.log").read_text()[-1500:]
                raise RuntimeError(f"the work ended with {code}: {factors}\n{log}")
            return dict(json.loads(job.read_text("utf-8")))
        finally:
            if path:
                path.write_text(before, "utf-8")
            free.put(runner)

    def close(self) -> None:
        """End the processes."""
        for runner in self.runners:
            runner.close()


def dependent(laboratory: Laboratory, group: Sequence[Constant], baseline: dict[str, Any]) -> list[str]:
    """Return the items that change with a module."""
    parts = [(constant, 0.97 - 0.15 * k / len(group)) for k, constant in enumerate(group)]
    now = laboratory.computed(parts, None)
    return [name for name, value in now.items() if _moved(value, baseline[name])]


def _moved(value: Any, before: Any) -> bool:
    if isinstance(value, str) or isinstance(before, str):
        return bool(value != before)
    return bool(abs(value - before) > 1e-9 * max(abs(before), 1e-6))


def findings(now: dict[str, Any], baseline: dict[str, Any], ends: dict[str, Any]) -> dict[str, Any]:
    """Return what one change does.

    noticed : rows that held and no longer do. refused : items that can no longer be computed. moved : the greatest
        change of an answer over half its 90 % interval, and which answer that is; None where none changes.
    """
    rows = _rows()
    noticed, moved = [], None
    for name, value in now.items():
        if isinstance(value, str):
            continue
        if name in rows:
            row = rows[name]
            low, high = row.allowed
            if not row.expected_miss and low <= baseline[name] <= high and not low <= value <= high:
                noticed.append(name)
        elif name in ends and not isinstance(ends[name], str) and _moved(value, baseline[name]):
            low, high = ends[name]
            half = (baseline[name] - low) if value < baseline[name] else (high - baseline[name])
            if high > low and half > 0:  # else it has no interval
                moved = max(moved or (0.0, ""), (abs(value - baseline[name]) / half, name))
    refused = [name for name, value in now.items() if isinstance(value, str) and not isinstance(baseline[name], str)]
    return {"noticed": sorted(noticed), "refused": len(refused), "moved": moved}


@cache
def _rows() -> dict[str, Any]:
    validation = import_module("sweetspot.validation")
    return {row_name(case.source, row): row for case in validation.sources() for row in case.rows}


def measure(
    only: str, *, workers: int, minutes: float, kept: Path = KEPT, chosen: Sequence[Constant] | None = None
) -> dict[str, Any] | None:
    """Return the findings of every constant whose description holds a text; None when time was up before the end."""
    every = [constant for constant in chosen or constants() if only in f"{constant.file}: {constant.name}"]
    start, stamp = time.monotonic(), fingerprint_of(PACKAGE) + fingerprint_of(Path(__file__))
    done = _kept(kept, stamp)
    laboratory = Laboratory(workers)
    try:
        if "baseline" not in done:
            done["baseline"] = laboratory.computed([], None)
            done["ends"] = laboratory.computed([], None, "intervals")
            done["reads"] = laboratory.computed([], None, "reads")
        kept.parent.mkdir(exist_ok=True)
        with ThreadPoolExecutor(workers) as pool:

            def affected(constant: Constant) -> list[str]:
                if constant.file.endswith(".toml"):
                    return [name for name, read in done["reads"].items() if constant.name in read]
                if constant.file not in done["modules"]:
                    group = [other for other in constants() if other.file == constant.file]
                    done["modules"][constant.file] = dependent(laboratory, group, done["baseline"])
                return list(done["modules"][constant.file])

            def work(constant: Constant) -> None:
                if str(constant) in done["constants"] or time.monotonic() - start > 60 * minutes:
                    return
                names = affected(constant)
                found = [
                    findings(
                        laboratory.computed([(constant, factor)], names) if names else {},
                        done["baseline"],
                        done["ends"],
                    )
                    for factor in FACTORS
                ]
                done["constants"][str(constant)] = found
                print(_line(constant, found), flush=True)
                kept.write_text(json.dumps({"fingerprint": stamp, **done}), "utf-8")

            list(pool.map(work, every))
    finally:
        laboratory.close()
    if any(str(constant) not in done["constants"] for constant in every):
        return None
    return summary(every, done)


def _kept(path: Path, stamp: str) -> dict[str, Any]:
    if path.exists() and (kept := json.loads(path.read_text("utf-8")))["fingerprint"] == stamp:
        return {key: value for key, value in kept.items() if key != "fingerprint"}
    return {"constants": {}, "modules": {}}


def summary(every: Sequence[Constant], done: dict[str, Any]) -> dict[str, Any]:
    """Return what is saved: by constant and factor the numbers that notice and the greatest move of an answer."""
    return {
        "measured": {"date": date.today().isoformat(), "command": COMMAND, "commit": _commit(), "factors": FACTORS},
        "constants": [
            {
                "file": constant.file, "name": constant.name, "value": constant.value,
                "kind": constant.kind, "source": constant.source,
                "found": [_counted(found) for found in done["constants"][str(constant)]],
            }
            for constant in every
        ],
    }  # fmt: skip


def as_text(found: dict[str, Any]) -> str:
    """Return what is saved as JSON with a line for each constant."""
    lines = ",\n".join(f"  {json.dumps(constant, ensure_ascii=False)}" for constant in found["constants"])
    return f'{{\n "measured": {json.dumps(found["measured"])},\n "constants": [\n{lines}\n ]\n}}\n'


def _counted(found: dict[str, Any]) -> dict[str, Any]:
    """Return findings with the rows as numbers of their sources: published and fitted, each number once."""
    rows, numbers = _rows(), {}
    for kind, kinds in (("bats", PUBLISHED[:1]), ("others", PUBLISHED[1:]), ("fitted", ("calibrated",))):
        noticed = [name for name in found["noticed"] if rows[name].evidence in kinds]
        numbers[kind] = sorted({f"{name.partition(':')[0]}: {rows[name].number_key.strip()}" for name in noticed})
    moved = found["moved"] and [round(found["moved"][0], 3), found["moved"][1]]
    return {**numbers, "rows": len(found["noticed"]), "refused": found["refused"], "moved": moved}


def _commit() -> str:
    asked = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    return asked.stdout.strip()


def _line(constant: Constant, found: Sequence[dict[str, Any]]) -> str:
    cells = [
        f"x {factor:g}: {len(part['noticed'])} rows, moves {part['moved'][0]:.2f} ({part['moved'][1]})"
        if part["moved"]
        else f"x {factor:g}: {len(part['noticed'])} rows"
        for factor, part in zip(FACTORS, found, strict=True)
    ]
    return f"{constant!s:60} {'; '.join(cells)}"


def main(words: Sequence[str] | None = None) -> int:
    """Change the constants that are not yet tried; save what rows notice when all are."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--only", default="", help="only constants whose file and name hold this text; saves nothing")
    parser.add_argument("--workers", type=int, default=2, help="copies of the package side by side")
    parser.add_argument("--minutes", type=float, default=60.0, help="begin no further constant after so long")
    parser.add_argument("--out", type=Path, default=SAVED, help="file of a full run")
    parser.add_argument("--serve", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--warm", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args(words)
    if options.serve:
        if options.warm:
            warmed()
            forget(package_caches())
        serve(options.serve, compute)
        return 0
    found = measure(options.only, workers=options.workers, minutes=options.minutes)
    if found is None:
        print("not all are tried yet; the same command goes on")
        return 1
    if not options.only:
        options.out.write_text(as_text(found), "utf-8")
        print(f"wrote {options.out}: {len(found['constants'])} constants")
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Try deliberate mistakes in physics and catalogue, and print those that no test notices.

    python tools/mutants.py [--only TEXT] [--workers N] [--minutes M]

The mistakes are in `mutations.toml`: text replaced in a named function, class, constant or catalogue table. Each is
made in a copy of the package, and its group's tests run against the copy, which should fail. Each worker has the third
parties imported and forks for every mistake; the copies bring along what is compiled. Results are kept in
build/mutants.json and taken up again as long as package, tests and mistake are the same, so that a broken-off run goes
on. Exit 0 when at least `GOAL` of the mistakes in code and catalogue each were noticed; 1 otherwise.
"""

from __future__ import annotations

import argparse
import ast
import hashlib
import importlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import tomllib
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from queue import SimpleQueue

ROOT = Path(__file__).resolve().parents[1]
PACKAGE = ROOT / "src" / "sweetspot"
TESTS = ROOT / "tests"
WORK = ROOT / "build" / "mutants"
RESULTS = ROOT / "build" / "mutants.json"
GOAL = 0.97
THIRD_PARTIES = (
    "matplotlib", "numba", "numpy", "pint", "polars", "pydantic", "pytest", "scipy.integrate", "scipy.interpolate",
    "scipy.linalg", "scipy.optimize", "scipy.sparse.linalg", "scipy.stats", "skfem",
)  # fmt: skip
"""What every test needs; no plugins of pytest, which it wants to import itself."""
PATIENCE = 600
"""s for the tests of one mistake; what takes longer, on a busy machine or for ever, counts as not tried."""


class StaleError(Exception):
    """The mistake's place or text is no longer in the package."""


@dataclass(frozen=True)
class Mutation:
    """One mistake: the text ``old`` of the place ``where`` becomes ``new``; ``tests`` should notice."""

    where: str
    old: str
    new: str
    tests: tuple[str, ...]

    @property
    def in_catalogue(self) -> bool:
        """Whether it is a wrong value, not wrong code."""
        return ".toml:" in self.where

    def __str__(self) -> str:
        return f"{self.where}: {self.old.strip()!r} -> {self.new.strip()!r}"


def mutations() -> list[Mutation]:
    """Return every mistake of `mutations.toml`."""
    groups = tomllib.loads(Path(__file__).with_suffix("").with_name("mutations.toml").read_text("utf-8"))["group"]
    return [
        Mutation(where, old, new, tuple(group["tests"])) for group in groups for where, old, new in group["mutations"]
    ]


def applied(mutation: Mutation, package: Path = PACKAGE) -> tuple[Path, str]:
    """Return the file that a mistake changes, below the package, and its changed text.

    Raises
    ------
    StaleError
        when the place or the old text is not there exactly once.
    """
    spans = list((_catalogue_spans if mutation.in_catalogue else _code_spans)(mutation.where, package))
    hits = [(path, text, at) for path, text, start, end in spans for at in _found(text, mutation.old, start, end)]
    if len(hits) != 1:
        raise StaleError(f"{mutation}: {len(spans)} places of that name, the text is there {len(hits)} times")
    ((path, text, at),) = hits
    return path.relative_to(package), text[:at] + mutation.new + text[at + len(mutation.old) :]


def _found(text: str, old: str, start: int, end: int) -> Iterator[int]:
    at = text.find(old, start, end)
    while at >= 0:
        yield at
        at = text.find(old, at + 1, end)


def _code_spans(name: str, package: Path) -> Iterator[tuple[Path, str, int, int]]:
    """Yield (file, text, start, end) of every definition of a name; of a function, without its docstring."""
    outer, _, inner = name.partition(".")
    for path, text in _texts(package):
        if outer not in text:
            continue
        starts = [0, *(match.end() for match in re.finditer("\n", text))]
        for node in _named(_body(text), outer):
            for one in _named(node.body, inner) if inner and isinstance(node, ast.ClassDef) else [node]:
                body = getattr(one, "body", None)
                first = body[0] if body and ast.get_docstring(one) is None else body[1] if body else one  # type: ignore[arg-type]
                yield path, text, starts[first.lineno - 1], starts[min(one.end_lineno or 0, len(starts) - 1)]


@lru_cache(maxsize=1)
def _texts(package: Path) -> list[tuple[Path, str]]:
    return [(path, path.read_text("utf-8")) for path in sorted(package.rglob("*.py"))]


@lru_cache(maxsize=512)
def _body(text: str) -> list[ast.stmt]:
    return ast.parse(text).body


def _named(body: list[ast.stmt], name: str) -> Iterator[ast.stmt]:
    for node in body:
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        names = {getattr(node, "name", None), *(getattr(target, "id", None) for target in targets)}
        if name in names:
            yield node


def _catalogue_spans(where: str, package: Path) -> Iterator[tuple[Path, str, int, int]]:
    """Yield (file, text, start, end) of a table of a catalogue file, or of its part before the first table."""
    file, _, table = where.partition(":")
    for path in package.rglob(file):
        text = path.read_text("utf-8")
        head = re.search(rf"^\[{re.escape(table)}\]$", text, re.MULTILINE) if table else re.match("", text)
        if head is not None:
            following = re.compile(rf"^\[(?!\[?{re.escape(table)}\.)" if table else r"^\[", re.MULTILINE)
            end = following.search(text, head.end() + 1)
            yield path, text, head.end(), end.start() if end else len(text)


class Runner:
    """A process with the third parties imported, which works on a copy of the package in forks of itself: runs tests.

    ``program``: what it runs, with ``--serve LOG``; its `serve` says what the work is.
    """

    def __init__(self, home: Path, program: str = __file__, *options: str) -> None:
        self.home = home
        shutil.rmtree(home / "src", ignore_errors=True)
        shutil.copytree(ROOT / "src", home / "src")  # with times: what is compiled stays valid
        environment = {**os.environ, "PYTHONPATH": str(home / "src"), "OPENBLAS_NUM_THREADS": "1"}
        self.process = subprocess.Popen(
            [sys.executable, program, "--serve", str(home / "tests.log"), *options],
            cwd=ROOT, env=environment, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
        )  # fmt: skip

    def exit_code(self, arguments: list[str]) -> int | None:
        """Return how the work ends; None when it takes longer than `PATIENCE`."""
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.write(json.dumps(arguments) + "\n")
        self.process.stdin.flush()
        code: int | None = json.loads(self.process.stdout.readline())
        return code

    def close(self) -> None:
        """End the process."""
        assert self.process.stdin is not None and self.process.stdout is not None
        self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()


def pytest_main(arguments: list[str]) -> int:
    """Run pytest."""
    return int(importlib.import_module("pytest").main(arguments))


def serve(log: Path, work: Callable[[list[str]], int] = pytest_main) -> None:
    """Do the work with the arguments of each line of standard input, in a fork; print the exit codes."""
    for module in THIRD_PARTIES:
        importlib.import_module(module)
    for line in sys.stdin:
        child = os.fork()
        if child == 0:
            os.setsid()
            with log.open("w") as file:
                os.dup2(file.fileno(), 1)
                os.dup2(file.fileno(), 2)
                code = work(json.loads(line))
                sys.stdout.flush()
            os._exit(code)
        until, ended, status = time.monotonic() + PATIENCE, 0, 0
        while not ended and time.monotonic() < until:
            time.sleep(0.02)
            ended, status = os.waitpid(child, os.WNOHANG)
        if not ended:
            os.killpg(child, signal.SIGKILL)
            os.waitpid(child, 0)
        print(json.dumps(os.waitstatus_to_exitcode(status) if ended else None), flush=True)


def noticed(mutation: Mutation, runner: Runner) -> bool:
    """Return whether the tests fail when the mistake is made in a runner's copy of the package.

    Raises
    ------
    TimeoutError
        when they take longer than `PATIENCE`.
    """
    package = runner.home / "src" / "sweetspot"
    relative, text = applied(mutation, package)
    changed = package / relative
    before, stat = changed.read_bytes(), changed.stat()
    changed.write_text(text, encoding="utf-8")
    tests = sorted(mutation.tests, key=lambda name: Path(name).stem != f"test_{relative.stem}")  # its own ones first
    try:
        return fail(tests, runner)
    finally:
        changed.write_bytes(before)
        os.utime(changed, ns=(stat.st_atime_ns, stat.st_mtime_ns))


def fail(tests: Sequence[str], runner: Runner, *, doctests: Sequence[Path] = ()) -> bool:
    """Return whether tests, and the examples of files of the copy, fail against a runner's copy of the package.

    Raises
    ------
    TimeoutError
        when they take longer than `PATIENCE`.
    """
    options = ["-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "--no-header", "--hypothesis-profile=few"]
    examples = ["--doctest-modules", *map(str, doctests)] if doctests else []
    code = runner.exit_code([*options, *(str(TESTS / name) for name in tests), *examples])
    if code is None:
        raise TimeoutError(" ".join(tests))
    if code not in (0, 1, 2):  # 2: the tests could not even be collected
        raise RuntimeError(f"{tests}: pytest ended with {code}: {(runner.home / 'tests.log').read_text()[-800:]}")
    return code != 0


def fingerprint_of(*folders: Path) -> str:
    """Return a hash of everything a result depends on: code and tables in folders, and single files."""
    digest = hashlib.sha256()
    paths = [path for folder in folders for end in ("py", "toml", "csv") for path in folder.rglob(f"*.{end}")]
    for path in sorted([*paths, *(folder for folder in folders if folder.is_file())]):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def _known(fingerprint: str) -> dict[str, bool]:
    """Return the kept results, if they are of these files."""
    if RESULTS.exists():
        kept = json.loads(RESULTS.read_text("utf-8"))
        if kept["fingerprint"] == fingerprint:
            return dict(kept["noticed"])
    return {}


def main() -> int:
    """Try the mistakes that are not yet tried; print survivors and rates."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("--only", default="", help="only mistakes whose description holds this text")
    parser.add_argument("--workers", type=int, default=2, help="mistakes tried side by side")
    parser.add_argument("--minutes", type=float, default=60.0, help="begin no further mistake after so long")
    parser.add_argument("--serve", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.serve:
        serve(options.serve)
        return 0
    chosen = [mutation for mutation in mutations() if options.only in str(mutation)]
    fingerprint = fingerprint_of(PACKAGE, TESTS)
    known, stale = _known(fingerprint), []
    for mutation in chosen:
        try:
            applied(mutation)
        except StaleError as error:
            stale.append(str(error))
    fresh = [mutation for mutation in chosen if str(mutation) not in known]
    runners = [Runner(WORK / str(number)) for number in range(options.workers)]
    free: SimpleQueue[Runner] = SimpleQueue()
    for runner in runners:
        free.put(runner)
    start = time.monotonic()

    def refuse_broken(tests: tuple[str, ...]) -> None:
        runner = free.get()
        try:
            if fail(tests, runner):
                told = (runner.home / "tests.log").read_text()[-1500:]
                raise SystemExit(f"these tests fail without any mistake and can notice none: {' '.join(tests)}\n{told}")
        finally:
            free.put(runner)

    def tried(mutation: Mutation) -> None:
        if time.monotonic() - start > 60 * options.minutes:
            return
        runner = free.get()
        began = time.monotonic()
        try:
            known[str(mutation)] = noticed(mutation, runner)
        except StaleError:
            return
        except TimeoutError:
            print(f"TOO LONG {PATIENCE:5.0f} s  {mutation}", flush=True)
            return
        finally:
            free.put(runner)
        word = "noticed " if known[str(mutation)] else "SURVIVED"
        print(f"{word} {time.monotonic() - began:5.1f} s  {mutation}", flush=True)
        RESULTS.write_text(json.dumps({"fingerprint": fingerprint, "noticed": dict(known)}, indent=1), "utf-8")

    with ThreadPoolExecutor(options.workers) as pool:
        list(pool.map(refuse_broken, dict.fromkeys(mutation.tests for mutation in fresh)))
        list(pool.map(tried, fresh))
    for runner in runners:
        runner.close()
    print(f"tried for {(time.monotonic() - start) / 60:.1f} min, {_processor_minutes():.1f} min of a processor")
    return _told(chosen, known, stale)


def _processor_minutes() -> float:
    """Return the time of processors that the runners and their forks have used."""
    used = os.times()
    return (used.children_user + used.children_system) / 60


def _told(chosen: list[Mutation], known: dict[str, bool], stale: list[str]) -> int:
    """Print survivors, stale mistakes and rates; return the exit code."""
    good = not stale
    for text in stale:
        print(f"STALE    {text}")
    for what, in_catalogue in (("code", False), ("catalogue", True)):
        own = [mutation for mutation in chosen if mutation.in_catalogue is in_catalogue and str(mutation) in known]
        left = [str(mutation) for mutation in own if not known[str(mutation)]]
        print(f"{what}: {len(own) - len(left)} of {len(own)} noticed", *left, sep="\n  survived: ")
        good &= not own or len(left) <= (1 - GOAL) * len(own)
    untried = sum(str(mutation) not in known for mutation in chosen) - len(stale)
    print(f"not tried yet: {untried}; the same command goes on" if untried else "all tried")
    return 0 if good and not untried else 1


if __name__ == "__main__":
    sys.exit(main())

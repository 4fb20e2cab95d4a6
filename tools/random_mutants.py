"""Make mistakes at places of the package chosen by chance, and print those that the nearest tests do not notice.

    python -m tools.random_mutants N [--seed S] [--workers W] [--minutes M]

Where `mutants.py` has a list made by hand, nobody chose these: every comparison, operation, number and `not` of the
package is as probable as any other. The nearest tests are the module's own, those that import it, and its doctests.
Not every mistake can be noticed: a survivor may leave all answers as they are. Exit 0 when at least `GOAL` are noticed.
"""

from __future__ import annotations

import argparse
import ast
import os
import random
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from queue import SimpleQueue

from tools.mutants import PACKAGE, ROOT, TESTS, WORK, Runner, fail

GOAL = 0.85
NEAREST = 7
"""Most test files that are run for one mistake."""
FORCED = 1.25
"""What a number is multiplied by; a whole one is one more instead."""
OPERATORS: dict[type[ast.AST], tuple[str, str]] = {
    ast.Lt: ("<", "<="), ast.LtE: ("<=", "<"), ast.Gt: (">", ">="), ast.GtE: (">=", ">"), ast.Eq: ("==", "!="),
    ast.NotEq: ("!=", "=="), ast.Add: ("+", "-"), ast.Sub: ("-", "+"), ast.Mult: ("*", "/"), ast.Div: ("/", "*"),
    ast.Pow: ("**", "*"), ast.And: ("and", "or"), ast.Or: ("or", "and"), ast.Not: ("not", ""), ast.USub: ("-", ""),
}  # fmt: skip
"""How each is written, and what stands there instead."""


@dataclass(frozen=True)
class Mistake:
    """A piece of a file, below the package, from byte ``start`` to ``end`` that becomes ``new``."""

    path: Path
    line: int
    start: int
    end: int
    old: str
    new: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line}: {self.old} -> {self.new}"


def every_mistake() -> list[Mistake]:
    """Return all mistakes that can be made in the package."""
    return [mistake for path in sorted(PACKAGE.rglob("*.py")) for mistake in mistakes_in(path)]


def mistakes_in(path: Path) -> Iterator[Mistake]:
    """Yield the mistakes that can be made in one file; texts, annotations and what only raises are left out."""
    source = path.read_bytes()
    begins = [0]
    for line in source.splitlines(keepends=True):
        begins.append(begins[-1] + len(line))

    def at(line: int | None, column: int | None) -> int:
        assert line is not None and column is not None  # every node of a parsed file has its place
        return begins[line - 1] + column

    for node in _computing(ast.parse(source)):
        start, end = at(node.lineno, node.col_offset), at(node.end_lineno, node.end_col_offset)
        operator: ast.AST | None = None
        if isinstance(node, ast.Constant):
            yield Mistake(path.relative_to(PACKAGE), node.lineno, start, end, source[start:end].decode(), _other(node))
        elif isinstance(node, ast.UnaryOp):
            operator, end = node.op, at(node.operand.lineno, node.operand.col_offset)
        elif isinstance(node, ast.Compare) and len(node.ops) == 1:
            (operator,), (right,) = node.ops, node.comparators
            start, end = at(node.left.end_lineno, node.left.end_col_offset), at(right.lineno, right.col_offset)
        elif isinstance(node, ast.BoolOp) and len(node.values) == 2:  # between three, the other one binds differently
            left, right = node.values
            operator = node.op
            start, end = at(left.end_lineno, left.end_col_offset), at(right.lineno, right.col_offset)
        elif isinstance(node, ast.BinOp) and not _is_text(node):
            operator = node.op
            start, end = (
                at(node.left.end_lineno, node.left.end_col_offset),
                at(node.right.lineno, node.right.col_offset),
            )
        old, new = ("", "") if operator is None else OPERATORS.get(type(operator), ("", ""))
        if old and b"#" not in source[start:end]:
            start = source.index(old.encode(), start, end)  # brackets may stand beside it
            yield Mistake(path.relative_to(PACKAGE), node.lineno, start, start + len(old), old, new)


def _computing(node: ast.AST) -> Iterator[ast.expr]:
    """Yield the expressions below a node that decide or compute."""
    if isinstance(node, (ast.Raise, ast.JoinedStr, ast.Assert, ast.arg, ast.Import, ast.ImportFrom)):
        return
    number = isinstance(node, ast.Constant) and type(node.value) in (int, float)
    if number or isinstance(node, (ast.Compare, ast.BinOp, ast.BoolOp, ast.UnaryOp)):
        assert isinstance(node, ast.expr)
        yield node
    for name, value in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "type_comment"):
            continue
        for child in value if isinstance(value, list) else [value]:
            if isinstance(child, ast.AST):
                yield from _computing(child)


def _other(node: ast.Constant) -> str:
    """Return another number."""
    assert isinstance(node.value, (int, float))
    return repr(node.value + 1 if isinstance(node.value, int) else node.value * FORCED or 1.0)


def _is_text(node: ast.BinOp) -> bool:
    return any(isinstance(each, ast.Constant) and isinstance(each.value, str) for each in (node.left, node.right))


@cache
def _imports() -> dict[Path, set[str]]:
    """Return the modules of the package that every test file imports from."""
    found = {}
    for path in sorted(TESTS.rglob("test_*.py")):
        nodes = ast.walk(ast.parse(path.read_text("utf-8")))
        found[path] = {node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.module}
    return found


def nearest_tests(mistake: Mistake) -> list[str]:
    """Return the tests of a mistake's module, below the folder of tests, its own first: by name, import and folder."""
    module = ".".join(["sweetspot", *mistake.path.with_suffix("").parts])
    package = module.rpartition(".")[0]

    def distance(path: Path) -> tuple[int, int, str]:
        folder = path.relative_to(TESTS).parent == mistake.path.parent
        by_name = path.stem == f"test_{mistake.path.stem}"
        by_import = module in _imports()[path] or (mistake.path.stem == "__init__" and package in _imports()[path])
        page = "web" in path.relative_to(TESTS).parts and mistake.path.parts[0] != "web"  # a browser takes long
        return (0 if by_name and folder else 1 if by_import else 2 if by_name else 3 if folder else 9, page, str(path))

    ranked = sorted((distance(path), path) for path in _imports())
    return [path.relative_to(TESTS).as_posix() for (far, *_), path in ranked[:NEAREST] if far < 9]


def noticed(mistake: Mistake, runner: Runner) -> bool:
    """Return whether the nearest tests fail with the mistake made in a runner's copy of the package."""
    file = runner.home / "src" / "sweetspot" / mistake.path
    before, stat = file.read_bytes(), file.stat()
    file.write_bytes(before[: mistake.start] + f" {mistake.new} ".encode() + before[mistake.end :])
    try:
        return fail(nearest_tests(mistake), runner, doctests=[file] if b">>>" in before else [])
    finally:
        file.write_bytes(before)
        os.utime(file, ns=(stat.st_atime_ns, stat.st_mtime_ns))


def main() -> int:
    """Try mistakes chosen by chance; print each, and the part that was noticed."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else None)
    parser.add_argument("count", type=int, help="how many mistakes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2, help="mistakes tried side by side")
    parser.add_argument("--minutes", type=float, default=60.0, help="begin no further mistake after so long")
    options = parser.parse_args()
    every = every_mistake()
    chosen = random.Random(options.seed).sample(every, options.count)
    free: SimpleQueue[Runner] = SimpleQueue()
    runners = [
        Runner(WORK / f"random-{number}", str(ROOT / "tools" / "mutants.py")) for number in range(options.workers)
    ]
    for runner in runners:
        free.put(runner)
    start, results = time.monotonic(), dict[Mistake, bool]()

    def tried(mistake: Mistake) -> None:
        runner = free.get()
        try:
            if time.monotonic() - start < 60 * options.minutes and nearest_tests(mistake):
                results[mistake] = noticed(mistake, runner)
                print("noticed " if results[mistake] else "SURVIVED", mistake, flush=True)
        except TimeoutError:
            print("TOO LONG", mistake, flush=True)
        finally:
            free.put(runner)

    with ThreadPoolExecutor(options.workers) as pool:
        list(pool.map(tried, chosen))
    for runner in runners:
        runner.close()
    part = sum(results.values()) / max(len(results), 1)
    print(f"{sum(results.values())} of {len(results)} noticed, {100 * part:.0f} %; {len(every):,} can be made in all")
    return 0 if part >= GOAL else 1


if __name__ == "__main__":
    raise SystemExit(main())

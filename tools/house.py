"""Measure the house: how much there is of what should be little.

Run: make house

What needs a reader is not counted: how many "where is" questions are guessed from names alone, whether a word is one
of the field's, whether two functions do the same by other means.
"""

from __future__ import annotations

import ast
import io
import re
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import redirect_stdout
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from types import FrameType

from sweetspot.cli import main as run
from sweetspot.equipment.implement import Implement

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "src" / "sweetspot"
STATIC = PACKAGE / "web" / "static"
LONG_FILE, LONG_FUNCTION = 400, 80
"""Lines."""
BANNED = frozenset({"told", "said", "shown", "known", "done", "met", "own", "one", "kept"})
"""Names of variables and parameters that do not say what they hold."""
DIALECT = re.compile(r"\b(told|gives? way|giving way|nobody|(?:is|are) meant|Return (?:how far|what|whose|where))\b")
"""Words of docstrings and messages for which the field has plainer ones: given, deflects, no one, intended, ..."""
UNITS = frozenset({"mph", "in", "cm", "mm", "ft", "deg", "degf", "oz", "lb", "kg", "m", "m/s", "km/h", "kmh", "rpm"})
OF_A_HIT = ("exit_speed", "collision_efficiency", "closing_speed", "contact_time", "bbcor", "launch_angle")
BORDER = frozenset({"reports", "web", "cli"})
"""Packages that answer people."""
SPEED_LIMIT = re.compile(r"(FASTEST|SLOWEST|POSSIBLE|LARGEST|HIGHEST|MOST|SPEEDS?_(RANGE|LIMITS?)|BOUNDS)")


@dataclass(frozen=True)
class Measure:
    """One line of the table.

    Parameters
    ----------
    name : what is counted.
    value : how much there is.
    goal : the most that there should be; None: nothing is aimed at.
    """

    name: str
    value: int
    goal: int | None = None

    @property
    def verdict(self) -> str:
        """Return whether the goal is met."""
        return "" if self.goal is None else "met" if self.value <= self.goal else f"{self.value - self.goal:,} too many"


@cache
def texts(folder: Path, pattern: str = "*.py") -> Mapping[Path, str]:
    """Return every file of a folder as text; what others wrote and what was generated is left out."""
    return {
        path: path.read_text("utf-8")
        for path in sorted(folder.rglob(pattern))
        if not {"vendor", "__pycache__", "_build", "_generated"} & set(path.parts)
    }


parsed = cache(ast.parse)


def lines(folder: Path, pattern: str = "*.py") -> int:
    """Return the number of lines in a folder."""
    return sum(text.count("\n") for text in texts(folder, pattern).values())


def lines_by_package() -> dict[str, int]:
    """Return the lines of Python in every package and module at the top of sweetspot."""
    counted: Counter[str] = Counter()
    for path, text in texts(PACKAGE).items():
        counted[path.relative_to(PACKAGE).with_suffix("").parts[0]] += text.count("\n")
    return dict(counted)


def nodes(folder: Path = PACKAGE) -> Iterator[tuple[Path, ast.AST]]:
    """Yield every node of every Python file of a folder."""
    for path, text in texts(folder).items():
        yield from ((path, node) for node in ast.walk(parsed(text)))


def classes_with_several_meanings() -> dict[str, list[str]]:
    """Return the class names that more than one file defines, with the files."""
    places: dict[str, list[str]] = {}
    for path, node in nodes():
        if isinstance(node, ast.ClassDef):
            places.setdefault(node.name, []).append(path.relative_to(PACKAGE).as_posix())
    return {name: where for name, where in sorted(places.items()) if len(where) > 1}


def untyped_dictionaries() -> dict[str, int]:
    """Return how often `dict[str, Any]` stands in every package."""
    counted: Counter[str] = Counter()
    for path, text in texts(PACKAGE).items():
        counted[path.relative_to(PACKAGE).with_suffix("").parts[0]] += len(re.findall(r"dict\[str, Any\]", text))
    return {name: count for name, count in sorted(counted.items()) if count}


def conditional_asserts(folder: Path = ROOT / "tests") -> dict[str, int]:
    """Return the tests whose asserts may not run, as an `if` decides: path and name, with how many there are."""
    found: dict[str, int] = {}
    for path, node in nodes(folder):
        if isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            under = [inner for statement in node.body for inner in _asserts_under_if(statement)]
            if under:
                found[f"{path.relative_to(folder).as_posix()}::{node.name}"] = len(under)
    return found


def _asserts_under_if(statement: ast.stmt, *, under: bool = False) -> Iterator[ast.Assert]:
    if isinstance(statement, ast.Assert) and under:
        yield statement
    for name in ("body", "orelse", "finalbody", "handlers", "cases"):
        for inner in getattr(statement, name, []):
            yield from _asserts_under_if(inner, under=under or isinstance(statement, ast.If))


def banned_bindings() -> dict[str, int]:
    """Return how often a variable or parameter of every package has a name that does not say what it holds."""
    counted: Counter[str] = Counter()
    for path, node in nodes():
        stored = isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store) and node.id in BANNED
        if stored or (isinstance(node, ast.arg) and node.arg in BANNED):
            counted[path.relative_to(PACKAGE).with_suffix("").parts[0]] += 1
    return dict(sorted(counted.items()))


def house_words() -> dict[str, int]:
    """Return how often the texts of every package speak the house's dialect and not the field's language."""
    counted: Counter[str] = Counter()
    for path, node in nodes():
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            counted[path.relative_to(PACKAGE).with_suffix("").parts[0]] += len(DIALECT.findall(node.value))
    return {name: count for name, count in sorted(counted.items()) if count}


def long_functions() -> list[str]:
    """Return the functions that are longer than `LONG_FUNCTION` lines."""
    return [
        f"{path.relative_to(PACKAGE)}:{node.name}"
        for path, node in nodes()
        if isinstance(node, ast.FunctionDef) and (node.end_lineno or 0) - node.lineno >= LONG_FUNCTION
    ]


def heading_parsers() -> set[str]:
    """Return the files with a dictionary of units of their own beside words about headings."""
    return {
        path.relative_to(PACKAGE).as_posix()
        for path, node in nodes()
        if isinstance(node, ast.Dict)
        and not any(isinstance(value, ast.Tuple) for value in node.values)
        and len({key.value for key in node.keys if isinstance(key, ast.Constant)} & UNITS) > 1
        and texts(PACKAGE)[path].count("heading") > 2
    }


def speed_limits() -> set[str]:
    """Return the files beside the one table that bound a speed: by a constant with such a name, made of `MPH`."""
    found = set()
    for path, text in texts(PACKAGE).items():
        for node in parsed(text).body:
            target = node.targets[0] if isinstance(node, ast.Assign) else getattr(node, "target", None)
            if target is not None and SPEED_LIMIT.search(ast.unparse(target)) and "MPH" in ast.unparse(node):
                found.add(path.relative_to(PACKAGE).as_posix())
    return found


def dictionaries_of_a_hit() -> set[str]:
    """Return where a dictionary is written by hand that holds three or more quantities of one hit."""
    found = set()
    for path, node in nodes():
        if isinstance(node, ast.Dict) and path.relative_to(PACKAGE).parts[0] in BORDER:
            if all(isinstance(value, ast.Constant) for value in node.values):
                continue
            keys = [str(key.value) for key in node.keys if isinstance(key, ast.Constant)]
            if sum(any(key.startswith(name) for key in keys) for name in OF_A_HIT) > 2:
                found.add(f"{path.relative_to(PACKAGE).as_posix()}:{node.lineno}")
    return found


def steps_of_a_bat(words: list[str]) -> tuple[int, int]:
    """Return how many functions are handed the bat while a command answers, and how many of these calls climb a layer.

    The bat's own methods and properties are not counted: nobody hands it to itself. A call climbs where the function
    that takes the bat stands in a higher layer of `LAYERS` in tests/test_architecture.py than the one that calls it.
    """
    steps: set[tuple[str, str]] = set()
    climbs: set[tuple[str, str]] = set()

    def look(frame: FrameType, event: str, _: object) -> None:
        code = frame.f_code
        if event != "call" or not code.co_filename.startswith(str(PACKAGE)):
            return
        handed = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
        if not handed or isinstance(frame.f_locals.get("self"), Implement):
            return
        if any(isinstance(frame.f_locals.get(name), Implement) for name in handed):
            step = (code.co_filename, code.co_qualname)
            steps.add(step)
            caller = frame.f_back
            while caller is not None and not caller.f_code.co_filename.startswith(str(PACKAGE)):
                caller = caller.f_back
            if caller is not None and _layer(code.co_filename) < _layer(caller.f_code.co_filename):
                climbs.add(step)

    sys.setprofile(look)
    try:
        with redirect_stdout(io.StringIO()):
            run(words)
    except SystemExit:
        pass
    finally:
        sys.setprofile(None)
    return len(steps), len(climbs)


def _layer(path: str) -> int:
    """Return the place of a file of the package in the list of layers, from the top down."""
    name = Path(path).relative_to(PACKAGE).with_suffix("").parts[0]
    return next((rank for rank, layer in enumerate(_layers()) if name in layer), len(_layers()))


@cache
def _layers() -> list[set[str]]:
    """Return the layers of the package as the test of its imports has them."""
    tree = parsed((ROOT / "tests" / "test_architecture.py").read_text("utf-8"))
    listed = (
        node.value for node in tree.body if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "LAYERS"
    )
    layers: list[set[str]] = ast.literal_eval(next(listed))
    return layers


def measures() -> Iterator[Measure]:
    """Yield every line of the table."""
    source, tests = texts(PACKAGE), texts(ROOT / "tests")
    yield Measure("Python in src, lines", lines(PACKAGE), 66_000)
    yield Measure("Python in src, files", len(source), 480)
    yield Measure("JavaScript, lines", lines(STATIC, "*.js"), 11_000)
    any_types = sum(len(re.findall(r"\{[^}\n]*\bany\b[^}\n]*\}", text)) for text in texts(STATIC, "*.js").values())
    yield Measure("JavaScript, types that are `any`", any_types, 0)
    yield Measure("tools, lines", lines(ROOT / "tools"), 2_500)
    yield Measure("studies, lines", lines(ROOT / "studies"))
    yield Measure("tests, lines", lines(ROOT / "tests"), 33_000)
    yield Measure("parsers of table headings", len(heading_parsers()), 1)
    yield Measure("files beside `plausibility` that bound a speed", len(speed_limits()), 0)
    yield Measure("dictionaries of one hit written by hand", len(dictionaries_of_a_hit()), 1)
    yield Measure("class names with several meanings", len(classes_with_several_meanings()), 0)
    yield Measure("`# fmt: skip` in src", sum(text.count("# fmt: skip") for text in source.values()), 150)
    yield Measure("`# fmt: skip` in tests", sum(text.count("# fmt: skip") for text in tests.values()))
    yield Measure("`dict[str, Any]` in src", sum(untyped_dictionaries().values()), 0)
    yield Measure(f"files over {LONG_FILE} lines", sum(text.count("\n") > LONG_FILE for text in source.values()), 0)
    yield Measure(f"functions over {LONG_FUNCTION} lines", len(long_functions()), 0)
    yield Measure("tests with asserts under an `if`", len(conditional_asserts()), 0)
    yield Measure(f"bindings named {', '.join(sorted(BANNED))}", sum(banned_bindings().values()), 0)
    yield Measure("words of the house's dialect in its texts", sum(house_words().values()), 0)
    for goal, words in ((25, ["report", "r161-ash"]), (12, ["hit", "r161-ash", "--at", "6in-from-tip"])):
        steps, climbs = steps_of_a_bat(words)
        yield Measure(f"functions that `{words[0]}` hands its bat to", steps, goal)
        yield Measure(f"layers that the bat of `{words[0]}` climbs", climbs, 3)


def main() -> None:
    """Print the table."""
    print(f"{'measure':<72} {'today':>8} {'goal':>8}  verdict")
    for measure in measures():
        goal = "" if measure.goal is None else f"{measure.goal:,}"
        print(f"{measure.name:<72} {measure.value:>8,} {goal:>8}  {measure.verdict}", flush=True)
    print("\nNot counted by a program: which questions of where something is names alone answer; whose words they are.")


if __name__ == "__main__":
    main()

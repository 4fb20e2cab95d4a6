"""The house: who may import whom, where third parties live, and what a module may be called."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path

import pytest

import sweetspot
from tools import house

ROOT = Path(sweetspot.__file__).parent

LAYERS = [
    {"__main__"},
    {"front_door"},
    {"cli"},
    {"web"},
    {"reports"},
    {"answers"},
    {"validation"},
    {"uncertainty"},
    {"papers", "player", "seasons", "calibration", "designs"},
    {"catalog"},
    {"analysis"},
    {"collision", "flight"},
    {"dynamics"},
    {"motion"},
    {"equipment"},
    {"tables"},
    {"plausibility"},
    {"numerics"},
    {"errors", "units", "references"},
]
"""From the top of the house down; a line may import every lower one, never a neighbour."""
RANK = {name: rank for rank, layer in enumerate(LAYERS) for name in layer}
NEIGHBOURS = {("references", "errors"), ("units", "errors")}
"""The only two arrows inside a line."""

HOMES = {
    "numba": ("numerics/", "collision/compiled.py", "flight/compiled.py", "player/likelihood.py"),
    "llvmlite": ("numerics/vector_math.py",),
    "matplotlib": ("reports/",),
    "rich": ("reports/", "cli/"),
    "cyclopts": ("cli/",),
    "fastapi": ("web/",),
    "starlette": ("web/",),
    "uvicorn": ("web/",),
    "jinja2": ("reports/",),
    "pint": ("units/",),
    "tomllib": ("catalog/", "tables/", "seasons/", "validation/", "references.py", "reports/drawings/lathe.py"),
    "skfem": (),  # it sets the level of its logger for the whole process
    "emcee": (),  # the tests check draws with it
    "pymoo": ("designs/",),
    "ezdxf": ("reports/drawings/dxf.py", "calibration/outline/"),
    "fontTools": ("calibration/outline/",),
    "pyuff": ("calibration/response_file.py",),
    "segno": ("reports/kit.py",),
    "PIL": ("calibration/outline/photo/",),
    "polars": ("answers/", "seasons/", "reports/season/", "player/swing_table.py", "numerics/whole_parquet.py"),
    "distributed": ("seasons/cluster.py",),
}
"""Third parties and the places that may import them."""


@cache
def sources() -> dict[Path, str]:
    """Return the text of every file of the package; the front door, which may name all, is not among them."""
    return {
        path: path.read_text(encoding="utf-8") for path in sorted(ROOT.rglob("*.py")) if path != ROOT / "__init__.py"
    }


parsed = cache(ast.parse)
MODULE_NAME = re.compile(rf"({ROOT.name}(?:\.\w+)+)(?::\w+)?")
"""A string that is the name of a module of the package, or of what it holds: somebody is going to load it."""


def dotted(path: Path) -> tuple[str, ...]:
    """Return a file's module name below the package; a package is known by its folder."""
    parts = path.relative_to(ROOT).with_suffix("").parts
    return parts[:-1] if parts[-1] == "__init__" else parts


def imports(source: str, folder: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Yield every import of a source text as full dotted parts, names included.

    Imports for type checkers count, and so do modules that are loaded by a name in a string.
    """
    home = [ROOT.name, *folder]
    for node in ast.walk(parsed(source)):
        if isinstance(node, ast.Import):
            yield from (tuple(alias.name.split(".")) for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            base = home[: len(home) + 1 - node.level] if node.level else []
            stem = [*base, *(node.module or "").split(".")] if node.module else base
            yield from ((*stem, alias.name) for alias in node.names)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            if named := MODULE_NAME.fullmatch(node.value):
                yield tuple(named[1].split("."))
        elif isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] in {"import_module", "__import__"}:
            match node.args:
                case [ast.Constant(value=str(name)), *_] if not name.startswith("."):
                    yield tuple(name.split("."))
                case _:
                    yield ROOT.name, "a module that only a run can name"


def wrong_imports(source: str, here: str, folder: tuple[str, ...] = ()) -> list[str]:
    """Return the parts that a file of part ``here`` must not import but does."""
    parts = {target[1] for target in imports(source, folder) if target[0] == ROOT.name and len(target) > 1}
    parts -= {here, "__version__"} | {there for mine, there in NEIGHBOURS if mine == here}
    return sorted(part for part in parts if RANK.get(part, -1) <= RANK[here])


def test_imports_point_down() -> None:
    wrong = []
    for path, source in sources().items():
        place = path.relative_to(ROOT)
        here = place.with_suffix("").parts[0]
        faults = wrong_imports(source, here, place.parent.parts)
        wrong += [f"{place} imports {there}" for there in faults]
    assert not wrong, "\n".join(wrong)


def arrows() -> dict[tuple[str, ...], set[tuple[str, ...]]]:
    """Return for every module the modules of the package that it imports, `TYPE_CHECKING` included."""
    modules = {dotted(path): path for path in sources()}
    graph: dict[tuple[str, ...], set[tuple[str, ...]]] = {}
    for module, path in modules.items():
        targets = set()
        for target in imports(sources()[path], path.relative_to(ROOT).parent.parts):
            name = target[1:] if target[0] == ROOT.name else ()
            while name and name not in modules:
                name = name[:-1]
            if name and name != module:
                targets.add(name)
        graph[module] = targets
    return graph


def cycles(graph: dict[tuple[str, ...], set[tuple[str, ...]]]) -> list[str]:
    """Return one line for each import cycle that a walk through the graph meets."""
    state: dict[tuple[str, ...], int] = {}
    rings = []

    def visit(module: tuple[str, ...], trail: list[tuple[str, ...]]) -> None:
        state[module] = 1
        for target in sorted(graph.get(module, ())):
            if state.get(target) == 1:
                ring = [*trail[trail.index(target) :], target] if target in trail else [module, target]
                rings.append(" > ".join(".".join(part) for part in ring))
            elif target not in state:
                visit(target, [*trail, target])
        state[module] = 2

    for module in sorted(graph):
        if module not in state:
            visit(module, [module])
    return rings


def test_there_is_no_cycle() -> None:
    rings = cycles(arrows())
    assert not rings, "\n".join(rings)


def test_third_parties_live_where_they_should() -> None:
    wrong = []
    for path, source in sources().items():
        place = path.relative_to(ROOT).as_posix()
        names = {target[0] for target in imports(source) if target}
        wrong += [f"{place} imports {name}" for name in names & HOMES.keys() if not place.startswith(HOMES[name])]
    assert not wrong, "\n".join(wrong)


SLOW_TO_LOAD = {"scipy"}
"""Its parts cost a first answer a tenth of a second to half of one each: a function that needs one loads it."""


def test_no_module_loads_what_is_slow_to_load() -> None:
    wrong = []
    for path, source in sources().items():
        for node in parsed(source).body:
            if isinstance(node, ast.Import):
                names = {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                names = {node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)}
            else:
                continue
            wrong += [f"{path.relative_to(ROOT)} loads {name}" for name in names if name.split(".")[0] in SLOW_TO_LOAD]
    assert not wrong, "\n".join(wrong)


def test_no_module_is_named_like_its_function() -> None:
    """`from sweetspot.analysis import play` must never be a question of which one."""
    wrong = []
    for path, source in sources().items():
        names = {node.name for node in parsed(source).body if isinstance(node, ast.FunctionDef)}
        if path.stem in names:
            wrong.append(path.relative_to(ROOT).as_posix())
    assert not wrong, "\n".join(wrong)


MOST_PARAMETERS = 7
KERNELS = {"compiled", "inner", "_inlined"}
"""Marks of compiled functions, which take their arrays one by one."""


def public_functions(tree: ast.AST) -> Iterator[ast.FunctionDef]:
    """Yield the public functions of a file and the public methods of its public classes."""
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            yield node
        elif isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            yield from public_functions(node)


def parameters(function: ast.FunctionDef) -> int:
    """Return how many parameters a function has; ``self`` and ``cls`` are none."""
    given = function.args
    names = [one.arg for one in (*given.posonlyargs, *given.args, *given.kwonlyargs)]
    return len([name for name in names if name not in {"self", "cls"}])


def long_trains(source: str) -> list[str]:
    """Return the public functions of a source text that take more than `MOST_PARAMETERS`; kernels may."""
    trains = []
    for function in public_functions(parsed(source)):
        marks = {ast.unparse(mark).split("(")[0] for mark in function.decorator_list}
        if not marks & KERNELS and parameters(function) > MOST_PARAMETERS:
            trains.append(f"{function.name} takes {parameters(function)}")
    return trains


def test_nothing_public_takes_a_train_of_arguments() -> None:
    """Values (`Contact`, `FlightConditions`, ...) take their place."""
    wrong = [
        f"{path.relative_to(ROOT)}: {train}" for path, source in sources().items() for train in long_trains(source)
    ]
    assert not wrong, "\n".join(wrong)


def test_planted_trains_are_seen() -> None:
    eight = ", ".join("abcdefgh")
    assert long_trains(f"class A:\n    def f(self, {eight}): ...\ndef g(*, {eight}): ...") == ["f takes 8", "g takes 8"]
    assert not long_trains(f"def _f({eight}): ...\n@compiled()\ndef g({eight}): ...\ndef h({eight[:-3]}): ...")


def test_the_house_has_few_rooms() -> None:
    names = {path.name for path in ROOT.iterdir() if not path.name.startswith((".", "__pycache__"))}
    doors = {"py.typed", "references.bib", "__init__.py", "__init__.pyi", "__main__.py", "front_door.py"}
    assert len(names - doors) <= 24, sorted(names)  # the layers above, nothing else
    assert {dotted(path)[0] for path in sources()} <= set(RANK)


@pytest.mark.parametrize(
    ("source", "here", "faults"),
    [
        (
            "from sweetspot.catalog import bat\nimport sweetspot.analysis.strain\nfrom . import cli",
            "dynamics",
            ["analysis", "catalog", "cli"],
        ),
        ("from sweetspot import analyse", "dynamics", ["analyse"]),
        ("from sweetspot.flight.air import Air", "collision", ["flight"]),
        ("from sweetspot.equipment.bat import Bat\nimport numpy", "dynamics", []),
        ("def f():\n    import_module('sweetspot.reports.notebook').html_of(3)", "numerics", ["reports"]),
        ("later = 'sweetspot.reports.notebook'\ndef f():\n    return load(later)", "numerics", ["reports"]),
        ("importlib.import_module(f'sweetspot.{name}')", "cli", ["a module that only a run can name"]),
        ("later = 'sweetspot.reports.notebook:html_of'", "numerics", ["reports"]),
        ("if TYPE_CHECKING:\n    from sweetspot.reports.document import Document", "numerics", ["reports"]),
        ("import_module('fcntl')", "numerics", []),
    ],
)
def test_planted_faults_are_seen(source: str, here: str, faults: list[str]) -> None:
    """Upward, through the front door, to a neighbour, and by a name in a string; downward is allowed."""
    assert wrong_imports(source, here) == faults


def test_planted_cycles_are_seen() -> None:
    assert cycles({("a",): {("b",)}, ("b",): {("a",)}})
    assert not cycles({("a",): {("b",), ("c",)}, ("b",): {("c",)}, ("c",): set()})


def test_the_front_door_opens() -> None:
    for name in sweetspot.__all__:
        assert getattr(sweetspot, name) is not None
    assert {"play", "compare", "certify", "analyse"} <= set(sweetspot.__all__)


BUDGET = {
    "__init__": 150, "__main__": 50, "analysis": 3_900, "answers": 12_500, "calibration": 7_400, "catalog": 4_080,
    "cli": 4_200, "collision": 4_000, "designs": 2_750, "dynamics": 5_350, "equipment": 3_950, "errors": 200,
    "flight": 3_500, "front_door": 450, "motion": 750, "numerics": 2_000, "papers": 850, "plausibility": 800,
    "player": 4_520, "references": 150, "reports": 16_750, "seasons": 7_200, "tables": 1_000, "uncertainty": 2_050,
    "units": 800, "validation": 3_100, "web": 11_000,
}  # fmt: skip
"""Lines of Python that each package may have: a little more than it has. Raised only in a commit that says why; a
package that shrinks gives its lines back."""
SLACK = 500
"""Lines that a budget may be above what is there; `answers` is being filled."""


def test_each_package_keeps_to_its_budget() -> None:
    lines = house.lines_by_package()
    over = [
        f"{name}: {count} lines, allowed {BUDGET.get(name, 0)}"
        for name, count in lines.items()
        if count > BUDGET.get(name, 0)
    ]
    assert not over, f"make it smaller, or raise the budget and say why in the commit: {over}"
    idle = [name for name, most in BUDGET.items() if name != "answers" and most - lines.get(name, 0) > SLACK]
    assert not idle, f"lower the budget of {idle}"


SEVERAL_MEANINGS: dict[str, int] = {}
"""Class names that still mean several things, and how many. Nothing is added, and what is mended is taken out."""
UNTYPED = {
    "answers": 1,
}  # fmt: skip
"""How often `dict[str, Any]` may stand in a package. It only goes down: what crosses a border gets a type."""
RIDDLES = {
    "answers": 1, "web": 1,
}  # fmt: skip
"""How many variables and parameters of a package may still have a name that does not say what they hold."""
DIALECT: dict[str, int] = {}
"""How many words of the house's dialect may still stand in a package's texts."""


@pytest.mark.parametrize(
    ("found", "allowed", "mend"),
    [
        pytest.param(
            lambda: {name: len(places) for name, places in house.classes_with_several_meanings().items()},
            SEVERAL_MEANINGS,
            "give each meaning a name of its own",
            id="class names",
        ),
        pytest.param(house.untyped_dictionaries, UNTYPED, "give it a type", id="untyped dictionaries"),
        pytest.param(house.banned_bindings, RIDDLES, f"name what it holds, not {sorted(house.BANNED)}", id="bindings"),
        pytest.param(house.house_words, DIALECT, "say it in the field's words", id="words"),
        pytest.param(house.conditional_asserts, {}, "demand that it is there, then assert", id="conditional asserts"),
    ],
)
def test_what_should_go_only_shrinks(found: Callable[[], dict[str, int]], allowed: dict[str, int], mend: str) -> None:
    now = found()
    more = {name: count for name, count in now.items() if count > allowed.get(name, 0)}
    assert not more, f"{mend}: {more}"
    fewer = {name: now.get(name, 0) for name, count in allowed.items() if now.get(name, 0) < count}
    assert not fewer, f"there are fewer now, so allow no more than {fewer}"

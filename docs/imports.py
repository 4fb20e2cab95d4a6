"""What imports what inside the package, read from its source."""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import sweetspot

PACKAGE = Path(sweetspot.__file__).parent
ROOT = PACKAGE.parents[1]
USERS = ("docs", "examples", "studies", "benchmarks")
"""Folders beside the package that use it as readers do."""


def names_used_elsewhere() -> dict[str, set[str]]:
    """Return for each module the names that other folders of the package, examples or studies import from it."""
    used: dict[str, set[str]] = {}
    for file, module, name in _imports():
        if _folder(module) != _folder(_module(file)):
            used.setdefault(module, set()).add(name)
    return used


def arrows() -> Counter[tuple[str, str]]:
    """Return how many imports go from each folder of the package to each other one."""
    found: Counter[tuple[str, str]] = Counter()
    for file, module, _ in _imports():
        pair = (_folder(_module(file)), _folder(module))
        if file.is_relative_to(PACKAGE) and pair[0] != pair[1] and all(pair):
            found[pair] += 1
    return found


def layers() -> list[list[str]]:
    """Return the folders from the top layer down, as the table in CONTRIBUTING has them."""
    guide = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    table = guide.partition("## Where things are")[2].partition("\n## ")[0]
    cells = [line.split("|")[1] for line in table.splitlines() if line.startswith("| `")]
    return [re.findall(r"`(\w+)(?:/|\.py)`", cell) for cell in cells]


@cache
def _imports() -> tuple[tuple[Path, str, str], ...]:
    """Return (file, module of the package, name) of every import from the package."""
    files = [path for folder in (PACKAGE, *(ROOT / name for name in USERS)) for path in sorted(folder.rglob("*.py"))]
    return tuple((file, module, name) for file in files for module, name in _of(file))


def _of(file: Path) -> Iterator[tuple[str, str]]:
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("sweetspot."):
            yield from ((node.module, alias.name) for alias in node.names)


def _module(file: Path) -> str:
    if not file.is_relative_to(PACKAGE):
        return ""
    return ".".join((PACKAGE.name, *file.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__")


def _folder(module: str) -> str:
    """Return the folder of a module, or its name where it stands alone; the front door and users have none."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 and parts[1] not in ("front_door", "__main__") else ""

"""One page of reference for each folder of the package: what other folders, examples or studies use of it."""

from __future__ import annotations

import ast
from pathlib import Path

from imports import PACKAGE, names_used_elsewhere

FOLDERS = (
    "numerics", "plausibility", "tables", "equipment", "motion", "dynamics", "collision", "flight", "analysis",
    "catalog", "papers", "player", "seasons", "calibration", "designs", "uncertainty", "validation", "answers",
)  # fmt: skip
"""In the order of the imports; the faces (reports, web, cli) are no library."""
FILES = ("errors.py", "references.py", "units")


def reference_pages() -> dict[str, str]:
    """Return every page as reStructuredText by the name of its folder."""
    pages = {name: _page(name, sorted((PACKAGE / name).rglob("*.py"))) for name in FOLDERS}
    low = [path for name in FILES for path in ((PACKAGE / name).rglob("*.py") if "." not in name else [PACKAGE / name])]
    return pages | {"foundations": _page("foundations", sorted(low))}


def _page(name: str, files: list[Path]) -> str:
    front = PACKAGE / name / "__init__.py"
    docstring = ast.get_docstring(ast.parse(front.read_text(encoding="utf-8"))) if front.exists() else None
    parts = [_titled(name, "="), *([docstring] if docstring else [])]
    for file in files:
        module = ".".join((PACKAGE.name, *file.relative_to(PACKAGE).with_suffix("").parts))
        if file.name.startswith("ask_"):
            continue  # on the page of the API
        if public := _public(file, names_used_elsewhere().get(module, set())):
            parts.append(f"{_titled(module, '-')}\n\n.. automodule:: {module}\n   :members: {', '.join(public)}")
    return "\n\n".join(parts) + "\n"


def _public(file: Path, used: set[str]) -> list[str]:
    """Return the functions and classes of a file that are used elsewhere, in their order."""
    body = ast.parse(file.read_text(encoding="utf-8")).body
    return [node.name for node in body if isinstance(node, ast.FunctionDef | ast.ClassDef) and node.name in used]


def _titled(title: str, line: str) -> str:
    return f"{title}\n{line * len(title)}"

"""One page of reference for each folder of the package, made from the folders: a new module has its place by itself."""

from __future__ import annotations

import ast
from pathlib import Path

import sweetspot

ROOT = Path(sweetspot.__file__).parent
FOLDERS = (
    "numerics", "equipment", "motion", "dynamics", "collision", "flight", "analysis", "catalog", "papers", "player",
    "seasons", "calibration", "designs", "validation",
)  # fmt: skip
"""In the order of the imports; the faces (reports, web, cli) are no library."""
FILES = ("units", "errors", "references")


def reference_pages() -> dict[str, str]:
    """Return every page as reStructuredText by the name of its folder."""
    pages = {name: _page(name, sorted((ROOT / name).rglob("*.py"))) for name in FOLDERS if (ROOT / name).is_dir()}
    return pages | {"foundations": _page("foundations", [ROOT / f"{name}.py" for name in FILES])}


def _page(name: str, files: list[Path]) -> str:
    front = ROOT / name / "__init__.py"
    docstring = ast.get_docstring(ast.parse(front.read_text(encoding="utf-8"))) if front.exists() else None
    parts = [_titled(name, "="), *([docstring] if docstring else [])]
    for file in files:
        place = file.relative_to(ROOT).with_suffix("").parts
        if place[-1] != "__init__" and not any(part.startswith("_") for part in place):
            module = ".".join((ROOT.name, *place))
            parts.append(f"{_titled(module, '-')}\n\n.. automodule:: {module}\n   :members:")
    return "\n\n".join(parts) + "\n"


def _titled(title: str, line: str) -> str:
    return f"{title}\n{line * len(title)}"

"""Write `src/sweetspot/__init__.pyi`: every public name as type checkers see it, questions with all their parameters.

Run: python -m tools.stub
"""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import sweetspot
from sweetspot.units.quantities import KIND_OF

STUB = Path(sweetspot.__file__).with_suffix(".pyi")
HEAD = '''"""The public front door as type checkers see it; `python -m tools.stub` writes this file."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Literal

from pint import Quantity

from .analysis.certification.shots import Shots
from .catalog.implements import Loaded
'''
ALIASES = "Tool = Implement | Analysis | Loaded | str | Path\nAmount = float | str | Quantity[float] | Measured"
WRITTEN = re.compile(r"\b(Written|Exact|Place|ExactPlace)\b")
PUBLIC = {
    "Loaded": "Tool",
    "Loaded | None": "Tool | None",
    "Mapping[str, ArrayLike]": "Mapping[str, Sequence[Amount]]",
    "BatCell": 'Literal["exit_speed", "collision_efficiency", "bbcor", "bat_speed", "mass", "balance_point", "moi", '
    '"frequency"]',
    "FlightCell": 'Literal["carry", "hang_time", "apex", "landing_angle", "landing_speed"]',
    "GoalName": 'Literal["exit-speed", "carry", "line"]',
    "tuple[str, ...]": "str | Sequence[str]",
    "tuple[float, ...]": "Sequence[Amount]",
    "Sequence[Searched]": 'Sequence[Literal["swing", "launch", "parks"]]',
    "Side": 'Literal["right", "left"]',
    "Support": 'Literal["clamped", "floor", "free"]',
    "Material | None": "Material | str | None",
    "Shots | None": "Shots | str | Path | None",
}
"""Annotations of what is given inside by those of what is taken at the door."""


def stub() -> str:
    """Return the text of the file."""
    homes = {home: names.split() for home, names in vars(sweetspot)["_HOMES"].items()}
    lines, definitions = [], []
    for home, names in sorted(homes.items()):
        if home.startswith("answers.ask_"):
            definitions += [_definition(name) for name in names]
            continue
        listed = ", ".join(f"{name} as {name}" for name in names)
        lines.append(f"from .{home} import {listed}")
    names = "".join(f'    "{name}",\n' for name in sweetspot.__all__)
    parts = ["\n".join(lines), f"__version__: str\n\n__all__ = [\n{names}]", ALIASES, "\n".join(sorted(definitions))]
    return HEAD + "\n\n".join(parts) + "\n"


def _definition(name: str) -> str:
    signature = inspect.signature(getattr(sweetspot, name))
    words, starred = [], False
    for each in signature.parameters.values():
        if each.kind is each.VAR_POSITIONAL:
            words.append(f"*{each.name}: {_public(each)}")
            starred = True
            continue
        if each.kind is each.KEYWORD_ONLY and not starred:
            words.append("*")
            starred = True
        default = "" if each.default is each.empty else f" = {_default(each.default)}"
        words.append(f"{each.name}: {_public(each)}{default}")
    listed = "".join(f"    {word},\n" for word in words)
    return f"def {name}(\n{listed}) -> {signature.return_annotation}: ..."


def _public(parameter: inspect.Parameter) -> str:
    kind = str(parameter.annotation)
    if kind in PUBLIC:
        return PUBLIC[kind]
    if WRITTEN.search(kind) or (kind.startswith("float") and parameter.name in KIND_OF):
        return "Amount | None" if "None" in kind else "Amount"
    return kind


def _default(value: object) -> str:
    return repr(value) if isinstance(value, (str, int, float, bool, type(None))) else "..."


if __name__ == "__main__":
    STUB.write_text(stub(), encoding="utf-8")

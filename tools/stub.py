"""Write `src/sweetspot/__init__.pyi`: every public name as type checkers see it, functions as the door takes them.

Run: python -m tools.stub
"""

from __future__ import annotations

import inspect
import re
import typing
from pathlib import Path
from types import FunctionType

import sweetspot
from sweetspot.units.quantities import KIND_OF

STUB = Path(sweetspot.__file__).with_suffix(".pyi")
HEAD = '''"""The public front door as type checkers see it; `python -m tools.stub` writes this file."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Literal, overload

from numpy.typing import ArrayLike
from pint import Quantity

'''
ALIASES = """Tool = Implement | Analysis[Implement] | ReducedBat[Implement] | BeamModel | Loaded | str | Path
Amount = float | str | Quantity[float] | Measured
Amounts = ArrayLike | Sequence[Amount] | Quantity[float] | str"""
WRITTEN = re.compile(r"\b(Written|Exact|Place|ExactPlace)\b")
PUBLIC = {
    "Loaded": "Tool",
    "Implement": "Tool",
    "Implement | str | Path": "Tool",
    "Analysis": "Tool",
    "BeamModel": "Tool",
    "RigidBody": "RigidBody | Tool",
    "Modes": "Modes | Tool",
    "ReducedBat[Bat]": "Tool",
    "Ball": "Ball | str",
    "Contact": "Contact | tuple[Amount, Amount]",
    "Iterable[Park]": "Iterable[Park | str]",
    "Loaded | None": "Tool | None",
    "Mapping[str, ArrayLike]": "Mapping[str, Sequence[Amount]]",
    "BatCell": 'Literal["exit_speed", "collision_efficiency", "bbcor", "bat_speed", "mass", "balance_point", "moi", '
    '"frequency"]',
    "FlightCell": 'Literal["carry", "hang_time", "apex", "landing_angle", "landing_speed"]',
    "Aim": 'Literal["exponent", "position"]',
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
    imported = {
        "analysis.certification.shots": {"Shots"},
        "catalog.implements": {"Loaded"},
        "numerics.arrays": {"Array"},
    }
    definitions = []
    for home, names in vars(sweetspot)["_HOMES"].items():
        for name in names.split():
            function = inspect.unwrap(getattr(sweetspot, name))
            if isinstance(function, FunctionType):
                definitions += _definitions(name, function, imported)
            else:
                imported.setdefault(home, set()).add(f"{name} as {name}")
    lines = [f"from .{home} import {', '.join(sorted(names))}" for home, names in sorted(imported.items())]
    names = "".join(f'    "{name}",\n' for name in sweetspot.__all__)
    parts = ["\n".join(lines), f"__version__: str\n\n__all__ = [\n{names}]", ALIASES, "\n".join(sorted(definitions))]
    return HEAD + "\n\n".join(parts) + "\n"


def _definitions(name: str, function: FunctionType, imported: dict[str, set[str]]) -> list[str]:
    """Return a function as the door takes it, each of its overloads; ``imported`` gets the types that it names."""
    signature, overloads = inspect.signature(getattr(sweetspot, name)), typing.get_overloads(function)
    forms = [(_parameters(form), str(form.return_annotation)) for form in map(inspect.signature, overloads)]
    if signature.return_annotation == "Real":
        typed = _parameters(signature)
        forms = [(typed.replace("Amounts", "Amount"), "float"), (typed, "float | Array")]
    if not forms and any(each.annotation == "Given" for each in signature.parameters.values()):
        typed, answer = _parameters(signature), str(signature.return_annotation)
        forms = [(typed, answer), (typed.replace("Given", "Tool"), answer.replace("Given", "Implement"))]
    written = [
        f"def {name}(\n{parameters}) -> {answer}: ..."
        for parameters, answer in forms or [(_parameters(signature), signature.return_annotation)]
    ]
    for word in set(re.findall(r"\b[A-Z]\w+", " ".join(written))):
        found = function.__globals__.get(word)
        home = getattr(found, "__module__", "")
        if home.startswith("sweetspot.") and word not in sweetspot.__all__:
            imported.setdefault(home.removeprefix("sweetspot."), set()).add(word)
    return ["\n".join(f"@overload\n{each}" for each in written)] if len(written) > 1 else written


def _parameters(signature: inspect.Signature) -> str:
    words, starred = [], False
    for each in signature.parameters.values():
        star = "*" if each.kind is each.VAR_POSITIONAL else "**" if each.kind is each.VAR_KEYWORD else ""
        if each.kind is each.KEYWORD_ONLY and not starred:
            words.append("*")
        starred = starred or each.kind in (each.KEYWORD_ONLY, each.VAR_POSITIONAL)
        default = "" if each.default is each.empty else f" = {_default(each.default)}"
        words.append(f"{star}{each.name}: {_public(each)}{default}")
    return "".join(f"    {word},\n" for word in words)


def _public(parameter: inspect.Parameter) -> str:
    kind = str(parameter.annotation)
    if kind in PUBLIC:
        return PUBLIC[kind]
    is_amount = parameter.name in KIND_OF or parameter.kind is parameter.VAR_KEYWORD
    if kind in ("ArrayLike", "Real") and is_amount:
        return "Amounts"
    if WRITTEN.search(kind) or (kind.startswith("float") and is_amount):
        return "Amount | None" if "None" in kind else "Amount"
    return kind


def _default(value: object) -> str:
    return repr(value) if isinstance(value, (str, int, float, bool, type(None))) else "..."


if __name__ == "__main__":
    STUB.write_text(stub(), encoding="utf-8")

"""The glossary is the law for names: every public parameter and field of the package stands in it, and nothing else."""

from __future__ import annotations

import inspect
import pkgutil
import re
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import is_dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from pydantic import BaseModel

import sweetspot

GLOSSARY = Path(__file__).parents[1] / "docs" / "glossary.md"
FACES = ("cli", "web", "reports", "validation", "__main__")
"""Not physics: they take options and figures, whose names their own help explains."""


def modules() -> Iterator[ModuleType]:
    for found in pkgutil.walk_packages(sweetspot.__path__, "sweetspot."):
        if found.name.split(".")[1] not in FACES:
            yield import_module(found.name)


def public_things(module: ModuleType) -> Iterator[tuple[str, Any]]:
    """Yield the public classes and functions that a module itself defines, with the public methods of its classes."""
    for name, thing in vars(module).items():
        if name.startswith("_") or getattr(thing, "__module__", None) != module.__name__:
            continue
        if inspect.isclass(thing):
            yield f"{module.__name__}.{name}", thing
            for method_name, method in vars(thing).items():
                function = getattr(method, "__func__", method)
                if not method_name.startswith("_") and inspect.isfunction(function):
                    yield f"{module.__name__}.{name}.{method_name}", function
        elif inspect.isfunction(inspect.unwrap(thing)):
            yield f"{module.__name__}.{name}", inspect.unwrap(thing)


def names_of(thing: Any) -> list[str]:
    if inspect.isclass(thing):
        if issubclass(thing, BaseModel):
            return list(thing.model_fields)
        return list(thing.__dataclass_fields__) if is_dataclass(thing) else []
    return [name for name in inspect.signature(thing).parameters if name not in ("self", "cls")]


@cache
def used_names() -> dict[str, list[str]]:
    """Return every public name with the places that use it."""
    found: dict[str, list[str]] = defaultdict(list)
    for module in modules():
        for place, thing in public_things(module):
            for name in names_of(thing):
                found[name].append(place)
    return dict(found)


@cache
def terms() -> list[tuple[str, str, str]]:
    """Return (name, meaning, unit) of every row whose first cell is a name in code type."""
    rows = []
    for line in GLOSSARY.read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and len(cells) == 4 and (match := re.fullmatch(r"`(\w+)`", cells[0])):
            rows.append((match[1], cells[1], cells[2]))
    return rows


def test_every_public_name_is_in_the_glossary() -> None:
    known = {name for name, _, _ in terms()}
    missing = {name: places[0] for name, places in used_names().items() if name not in known}
    assert not missing, f"explain these in docs/glossary.md: {missing}"


def test_the_glossary_explains_no_name_that_is_gone() -> None:
    assert sorted({name for name, _, _ in terms()} - set(used_names())) == []


def test_every_name_stands_once_with_meaning_and_unit() -> None:
    names = [name for name, _, _ in terms()]
    assert sorted({name for name in names if names.count(name) > 1}) == []
    assert [name for name, meaning, unit in terms() if not meaning or not unit] == []


OUT_IN = {"out_in", "expected_out_in"}
"""How many parks a ball is out in: no inches."""


@pytest.mark.parametrize("ending", ["_mph", "_in", "_m", "_kg", "_hz", "_ms", "_deg", "_oz", "_mm"])
def test_no_name_inside_the_package_carries_a_unit(ending: str) -> None:
    assert [name for name in used_names() if name.endswith(ending) and name not in OUT_IN] == []

"""Write `answers.d.ts`, the types of the page's states and answers, from what the views take and return.

A view's ``answer``, and each of its asides and jobs, returns a frozen dataclass as `answers.records` describes
it: `Speed`, `Annotated[Array, LENGTH]`, records, tuples, literals; `GRID` marks arrays of rows, `GAPS` curves with nan.

Run: python tools/answer_types.py, after a change of such a record; `--check` (in `make js`) fails where that was
forgotten. JavaScript has them by ``@import { ExplorerAnswer } from "../answers.js"`` and ``View<"explorer">``.
"""

from __future__ import annotations

import inspect
import sys
import types
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import is_dataclass
from pathlib import Path
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np
from fastapi import APIRouter
from fastapi.routing import APIRoute
from pydantic import BaseModel

from sweetspot.answers.records import GAPS, GRID, NESTED, visible_fields
from sweetspot.numerics.interval import Band, Interval
from sweetspot.units.dimensions import Dimension
from sweetspot.web.catalogue import catalogue_routes
from sweetspot.web.page_modules import FOLDER
from sweetspot.web.views import VIEWS

FILE = FOLDER / "answers.d.ts"
PLAIN = {float: "number", int: "number", str: "string", bool: "boolean", type(None): "null", Interval: "number"}
NUMBERS = {np.floating: "number", np.integer: "number", np.bool_: "boolean", np.str_: "string"}
HEAD = "// What the views take and answer. Written by tools/answer_types.py; do not edit.\n"


class Interfaces:
    """The interfaces that types name, each written once."""

    def __init__(self) -> None:
        self.texts: dict[str, str] = {}
        self._kinds: dict[str, type] = {}

    def written(self, hint: Any, marks: tuple[Any, ...] = ()) -> str:  # noqa: PLR0911 - one for each kind of type
        """Return a type as TypeScript."""
        origin, parts = get_origin(hint), get_args(hint)
        if origin is Annotated:
            return self.written(parts[0], (*marks, *parts[1:]))
        if hint in PLAIN:
            return PLAIN[hint]
        if hint is Any:
            return "any"
        if origin is Literal:
            return " | ".join(f'"{part}"' if isinstance(part, str) else str(part).lower() for part in parts)
        if origin in (Union, types.UnionType):
            return " | ".join(dict.fromkeys(self.written(part, marks) for part in parts))
        if hint is Band:
            return self._list("number", marks)
        if origin is np.ndarray:
            number = get_args(parts[1])[0] if get_args(parts[1]) else np.floating
            return self._list(next((text for kind, text in NUMBERS.items() if issubclass(number, kind)), "any"), marks)
        if isinstance(origin, type) and issubclass(origin, Mapping):
            return self._by_name(parts[0], self.written(parts[1], marks))
        if origin is tuple and parts[-1] is not Ellipsis:
            return f"[{', '.join(self.written(part, marks) for part in parts)}]"
        if isinstance(origin, type) and issubclass(origin, Sequence):
            return self._list(self.written(parts[0], marks), ())
        if isinstance(hint, type):
            return self._named(hint)
        raise TypeError(f"no TypeScript is known for {hint!r}")

    def function(self, answer: Callable[..., Any]) -> str:
        """Return what a function returns."""
        return self.written(get_type_hints(answer, include_extras=True)["return"])

    def _list(self, item: str, marks: tuple[Any, ...]) -> str:
        item = f"{item} | null" if GAPS in marks else item
        item = f"({item})" if "|" in item else item
        return f"{item}[]" + ("[]" if GRID in marks else "")

    def _by_name(self, key: Any, value: str) -> str:
        return f"Record<{self.written(key)}, {value}>"

    def _named(self, kind: type) -> str:
        name = kind.__name__
        if self._kinds.setdefault(name, kind) is not kind:
            raise TypeError(f"two classes are called {name}: {kind.__module__}, {self._kinds[name].__module__}")
        if name not in self.texts:
            self.texts[name] = ""  # a record may hold others of its own kind
            self.texts[name] = self._interface(name, kind)
        return name

    def _interface(self, name: str, kind: type) -> str:
        if is_dataclass(kind):
            lines = [line for entry in visible_fields(kind) for line in self._entries(*entry)]
        elif issubclass(kind, BaseModel):
            hints = get_type_hints(kind, include_extras=True)
            lines = [f"{field}: {self.written(hints[field])};" for field in kind.model_fields]
        elif issubclass(kind, tuple):  # with names, which JSON does not have
            return f"export type {name} = [{', '.join(map(self.written, get_type_hints(kind).values()))}];\n"
        else:
            raise TypeError(f"no TypeScript is known for {kind!r}")
        words = (inspect.getdoc(kind) or "").partition("\n\n")[0].replace("\n", " ")
        return "\n".join([f"/** {words} */", f"export interface {name} {{", *(f"  {line}" for line in lines), "}", ""])

    def _entries(self, field: Any, hint: Any, dimension: Dimension) -> Iterator[str]:
        marks = get_args(hint)[1:] if get_origin(hint) is Annotated else ()
        inner = get_args(hint)[0] if marks else hint
        members = [*get_args(inner)] if get_origin(inner) in (Union, types.UnionType) else [inner]
        absent = field.default is None
        if absent:
            members = [member for member in members if member is not type(None)]
            inner = Union[tuple(members)]  # noqa: UP007 - its members are known only here
        optional = "?" if absent else ""
        key = dimension.key(field.name, "si")
        flat = {
            part for member in members for part in (member, *get_args(member), *get_args((get_args(member) or (0,))[0]))
        }
        if NESTED in marks:
            yield f"{key}{optional}: {{ value: number; low: number; high: number }};"
            return
        line = f"{key}{optional}: {self.written(inner, marks)};"
        if {Interval, Band} & flat:
            kind = "number" if Interval in flat else "number[]"
            ends = (dimension.key(f"{field.name}_{end}", "si") for end in ("low", "high"))
            line += "".join(f" {end}?: {kind};" for end in ends)
        yield line


def text() -> str:
    """Return the file."""
    found = Interfaces()
    states = [f"{view.name}: {found.written(view.state)};" for view in VIEWS.values()]
    answers = [f"{view.name}: {found.function(view.answer)};" for view in VIEWS.values()]
    asides = [
        _entry(view.name, {name: found.function(ask) for name, ask in view.asides.items()}) for view in VIEWS.values()
    ]
    jobs = [
        _entry(view.name, {name: found.function(job.work) for name, job in view.jobs.items()})
        for view in VIEWS.values()
    ]
    tables = {
        "States": ("The controls of every view.", states),
        "Answers": ("What every view answers.", answers),
        "Asides": ("What is asked apart, by view and name.", asides),
        "Jobs": ("What long work gives, by view and name.", jobs),
        "Catalogue": ("The lists of the catalogue.", [*_lists(found)]),
    }
    blocks = [
        "\n".join([f"/** {words} */", f"export interface {name} {{", *(f"  {line}" for line in lines), "}", ""])
        for name, (words, lines) in tables.items()
    ]
    return "\n".join([HEAD, *blocks, *(found.texts[name] for name in sorted(found.texts))])


def _lists(found: Interfaces) -> Iterator[str]:
    """Yield the type of every list of the catalogue's routes."""
    api = APIRouter()
    catalogue_routes(api)
    for route in api.routes:
        if isinstance(route, APIRoute) and get_origin(route.response_model) is list:
            yield f"{route.name}: {found.written(route.response_model)};"


def _entry(name: str, members: dict[str, str]) -> str:
    return f"{name}: {{ {' '.join(f'{key}: {kind};' for key, kind in members.items())} }};"


def main(words: list[str]) -> int:
    """Write the file, or say that it is stale."""
    if words != ["--check"]:
        FILE.write_text(text(), encoding="utf-8")
    elif FILE.read_text(encoding="utf-8") != text():
        print(f"{FILE.relative_to(Path.cwd())} is stale: python tools/answer_types.py writes it anew")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

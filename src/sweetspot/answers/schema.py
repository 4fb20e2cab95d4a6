"""JSON Schema of every answer, from its type, as `answers.records.to_dict` writes it."""

from __future__ import annotations

import inspect
import re
import types
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import is_dataclass
from enum import Enum
from typing import Annotated, Any, Literal, NamedTuple, Union, get_args, get_origin, get_type_hints

import numpy as np

from sweetspot.answers.records import GRID, INLINE, NESTED, OF_RECORD, PLAIN_ENDS, PlainTable, visible_fields
from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.numerics.interval import Band, Interval
from sweetspot.units.dimensions import Dimension, System

DRAFT = "https://json-schema.org/draft/2020-12/schema"
NUMBER: PlainTable = {"type": ["number", "null"]}
"""What is not finite is null."""
PLAIN: Mapping[Any, PlainTable] = {
    float: NUMBER,
    int: {"type": "integer"},
    str: {"type": "string"},
    bool: {"type": "boolean"},
    type(None): {"type": "null"},
    Any: {},
    object: {},
}
ITEMS: Mapping[type, PlainTable] = {
    np.floating: NUMBER,
    np.integer: {"type": "integer"},
    np.bool_: {"type": "boolean"},
    np.str_: {"type": "string"},
}
SIDES: PlainTable = {
    "type": "object",
    "properties": dict.fromkeys(("value", "low", "high"), NUMBER),
    "required": ["value", "low", "high"],
}
"""A number whose interval stands below its name."""
MADE_WITH: PlainTable = {
    "type": "object",
    "properties": {"version": {"type": "string"}, "commit": {"type": ["string", "null"]}},
}
"""What the command line adds to an answer: the program that made it."""


class Field(NamedTuple):
    """The keys of one field of a record: whether they are always there, and what they hold."""

    key: str
    needed: bool
    schema: PlainTable


def answer_names() -> dict[str, str]:
    """Return the public names of the types of answers by the names of their questions.

    >>> answer_names()["fit-player"]
    'FitPlayerAnswer'
    """
    import sweetspot

    names = [name for name in sweetspot.__all__ if name.endswith("Answer")]
    return {re.sub(r"(?<=.)(?=[A-Z])", "-", name.removesuffix("Answer")).lower(): name for name in names}


def answer_type(question: str) -> type:
    """Return the type of the answer to a question by its name."""
    import sweetspot

    found: type = getattr(sweetspot, answer_names()[question])
    return found


def answer_schema(kind: type, system: System = "si") -> PlainTable:
    """Return the JSON Schema of an answer, as ``to_dict(system)`` and ``--format json`` write it."""
    found = _Definitions(system)
    top = found.record(kind)
    top["properties"] = {**top["properties"], "made_with": MADE_WITH}
    return {"$schema": DRAFT, "title": kind.__name__, **top, "$defs": dict(sorted(found.definitions.items()))}


class _Definitions:
    """The schemas of the records that an answer holds, each written once."""

    def __init__(self, system: System) -> None:
        self.system = system
        self.definitions: dict[str, PlainTable] = {}

    def record(self, kind: type) -> PlainTable:
        """Return the schema of a record."""
        properties: dict[str, PlainTable] = {}
        patterns: dict[str, PlainTable] = {}
        needed: list[str] = []
        more: Any = False
        for field, hint, dimension in visible_fields(kind):
            inner, marks = _unwrapped(hint)
            absent = field.default is None
            if INLINE in marks:
                spread: Any = _members(inner)[0]
                if isinstance(spread, type):
                    part = self.record(spread)
                    properties |= part["properties"]
                    needed += [] if absent else part["required"]
                else:
                    more = self.of(get_args(spread)[1])
                continue
            if OF_RECORD in marks:
                ends = "low|high|" if PLAIN_ENDS in marks else ""
                value = (
                    _sides(inner) if NESTED in marks else NUMBER if Measured in _parts(inner) else self.of(inner, marks)
                )
                patterns[f"^({ends}{field.name}(_low|_high|_error)?)(_\\w+)?$"] = value
                continue
            for each in self._fields(field.name, inner, marks, dimension, absent=absent):
                properties[each.key] = each.schema
                needed += [each.key] if each.needed else []
        table: PlainTable = {"type": "object", "properties": properties, "required": list(dict.fromkeys(needed))}
        words = (inspect.getdoc(kind) or "").partition("\n\n")[0].replace("\n", " ")
        return {
            **({"description": words} if words else {}),
            **table,
            **({"patternProperties": patterns} if patterns else {}),
            "additionalProperties": more,
        }

    def of(self, hint: Any, marks: tuple[Any, ...] = ()) -> PlainTable:  # noqa: PLR0911 - one for each kind of type
        """Return the schema of a type."""
        inner, further = _unwrapped(hint)
        marks = (*marks, *further)
        origin, parts = get_origin(inner), get_args(inner)
        if inner in PLAIN:
            return PLAIN[inner]
        if inner is Interval:
            return NUMBER
        if inner is Band:
            return _listed(NUMBER, marks)
        if origin is Literal:
            return {"enum": list(parts)}
        if _is_union(inner):
            schemas = [self.of(part, marks) for part in parts]
            schemas = [each for number, each in enumerate(schemas) if each not in schemas[:number]]
            return schemas[0] if len(schemas) == 1 else {"anyOf": schemas}
        if origin is np.ndarray:
            number = get_args(parts[1])[0] if get_args(parts[1]) else np.floating
            return _listed(next((each for kind, each in ITEMS.items() if issubclass(number, kind)), {}), marks)
        if isinstance(origin, type) and issubclass(origin, Mapping):
            return {"type": "object", "additionalProperties": self.of(parts[1], marks)}
        if origin is tuple and parts[-1] is not Ellipsis:
            return _fixed([self.of(part, marks) for part in parts])
        if isinstance(origin, type) and issubclass(origin, Sequence):
            return {"type": "array", "items": self.of(parts[0], marks)}
        if isinstance(inner, type):
            return self._named(inner)
        raise TypeError(f"no JSON schema is known for {inner!r}")

    def _named(self, kind: type) -> PlainTable:
        if issubclass(kind, Enum):
            return {"enum": [member.value for member in kind]}
        if issubclass(kind, tuple):
            return _fixed([self.of(hint) for hint in get_type_hints(kind, include_extras=True).values()])
        if not is_dataclass(kind):
            raise TypeError(f"no JSON schema is known for {kind!r}")
        if kind.__name__ not in self.definitions:
            self.definitions[kind.__name__] = {}  # a record may hold others of its own kind
            self.definitions[kind.__name__] = self.record(kind)
        return {"$ref": f"#/$defs/{kind.__name__}"}

    def _fields(
        self, name: str, hint: Any, marks: tuple[Any, ...], dimension: Dimension, *, absent: bool
    ) -> Iterator[Field]:
        members = _members(hint) if absent else [*get_args(hint)] if _is_union(hint) else [hint]
        kinds = {part for member in members for part in _parts(member)}
        key = dimension.key(name, self.system)
        if NESTED in marks:
            yield Field(key, not absent, SIDES if absent else _sides(hint))
            return
        if CalibratedValue in kinds:
            inner = {each.key: each.schema for each in self._fields(name, Measured, (), dimension, absent=False)}
            entries = {"kind": {"type": "string"}, **inner}
            table = {"type": "object", "properties": entries, "required": list(entries)}
            yield Field(name, not absent, {"anyOf": [table, PLAIN[type(None)]]} if type(None) in members else table)
            return
        plain = [self.of(member, marks) for member in members if member is not Measured]
        plain += [NUMBER] if Measured in kinds else []
        plain = [each for number, each in enumerate(plain) if each not in plain[:number]]
        yield Field(key, not absent, plain[0] if len(plain) == 1 else {"anyOf": plain})
        if {Interval, Band, Measured} & kinds:
            ends = ("low", "high") if PLAIN_ENDS in marks else (f"{name}_low", f"{name}_high")
            end = _listed(NUMBER, marks) if Band in kinds else NUMBER
            sure = members == [Measured] and not absent
            yield from (Field(dimension.key(each, self.system), sure, end) for each in ends)
            if Measured in kinds:
                yield Field(dimension.key(f"{name}_error", self.system), sure, NUMBER)


def _unwrapped(hint: Any) -> tuple[Any, tuple[Any, ...]]:
    return (get_args(hint)[0], get_args(hint)[1:]) if get_origin(hint) is Annotated else (hint, ())


def _sides(hint: Any) -> PlainTable:
    """Return the schema of a number whose interval stands below its name, and which may be missing."""
    return {"anyOf": [SIDES, PLAIN[type(None)]]} if type(None) in _parts(hint) else SIDES


def _is_union(hint: Any) -> bool:
    return get_origin(hint) in (Union, types.UnionType)


def _members(hint: Any) -> list[Any]:
    """Return the members of a union but for None; of another type itself."""
    return [part for part in get_args(hint) if part is not type(None)] if _is_union(hint) else [hint]


def _parts(hint: Any) -> Iterator[Any]:
    """Yield a type and the members of its unions, whatever they are annotated with."""
    inner, _ = _unwrapped(hint)
    yield inner
    if _is_union(inner):
        for part in get_args(inner):
            yield from _parts(part)


def _listed(item: PlainTable, marks: Sequence[Any]) -> PlainTable:
    """Return the schema of an array of numbers, which may have gaps; of rows where it is a grid."""
    row: PlainTable = {"type": "array", "items": item}
    return {"type": "array", "items": row} if GRID in marks else row


def _fixed(items: Sequence[PlainTable]) -> PlainTable:
    return {"type": "array", "prefixItems": list(items), "minItems": len(items), "maxItems": len(items)}

"""Base of all equipment: frozen, validated at construction, all values in SI."""

from __future__ import annotations

import sys
import unicodedata
from collections.abc import Sequence
from difflib import get_close_matches
from functools import cache
from inspect import Parameter, Signature
from threading import RLock
from types import NoneType
from typing import TYPE_CHECKING, Annotated, Any, Self, TypeVar, cast, get_args, get_origin

import numpy as np
from numpy.typing import NDArray
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StringConstraints, ValidationError
from pydantic_core import ErrorDetails

from sweetspot.errors import ALMOST, InputError
from sweetspot.units import format_mass
from sweetspot.units.quantities import KIND_OF, PLAIN, in_si

if TYPE_CHECKING:
    from pydantic._internal._model_construction import ModelMetaclass
else:
    ModelMetaclass = type(BaseModel)  # what pydantic makes its classes by has no public name

Real = TypeVar("Real", float, NDArray[np.float64])
"""One number or an array of them; what comes out has the shape of what went in."""
Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]
Fraction = Annotated[float, Field(ge=0, le=1)]


def _readable(text: str) -> str:
    """Refuse a name that is blank, or that a terminal or a browser would obey instead of showing."""
    if not text.strip():
        raise ValueError("a name of blanks says nothing; give the name that people use")
    if any(unicodedata.category(letter) in UNSEEN for letter in text if letter not in JOINERS):
        raise ValueError("it holds control or formatting characters; write letters, digits and signs only")
    return text


UNSEEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
"""Kinds of characters that are commands: controls, formats, line ends."""
JOINERS = "\u200c\u200d"
"""Format characters that some scripts are written with."""
Name = Annotated[str, StringConstraints(min_length=1, max_length=100), AfterValidator(_readable)]
"""Display name: it is printed, written into tables and drawn."""
MACHINERY = {name for name in (*dir(BaseModel), *vars(BaseModel)) if name not in dir(object)}
"""Names inherited from pydantic; they work, and are not documented here."""
MOST_FAULTS, LONGEST_INPUT = 5, 80
"""Faults reported together, and letters of the input that a message repeats."""
UNIT_OF = {
    "mass": "oz",
    "wall": "mm",
    "tension": "lb",
    "frequency": "Hz",
    "moi": "oz*in^2",
    "density": "kg/m^3",
    "modulus": "GPa",
    "angle": "deg",
}
"""Unit that an example of a value is written with, by how its key ends; of all others inches."""


class _Readable(ModelMetaclass):
    """Restricts `dir` and `help` of a class to its own members, without the machinery that checks its fields."""

    @property
    def __signature__(self) -> Signature:
        """Return the fields by name with their defaults: the docstring gives types and bounds of each."""
        fields = cast("type[BaseModel]", self).model_fields
        return Signature(
            [
                Parameter(
                    name,
                    Parameter.KEYWORD_ONLY,
                    default=Parameter.empty if field.is_required() else field.get_default(),
                )
                for name, field in fields.items()
            ]
        )

    @__signature__.setter
    def __signature__(self, spelled_out: object) -> None:
        """Pass over pydantic's own, in which every bound of every type is spelled out."""

    def __dir__(self) -> list[str]:
        names = (name for name in super().__dir__() if name not in MACHINERY)
        return [name for name in names if not name.startswith(("__pydantic", "__private", "__class_vars", "__weakref"))]


class Validated(BaseModel, metaclass=_Readable):  # noqa: PLW1641  # pydantic hashes what is frozen
    """An immutable, validated value; a wrong one raises `InputError` with one clear message."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False, defer_build=True)

    def __init__(self, **values: Any) -> None:
        """Take fields by name, in SI or with their units; raises `InputError` that says what is wrong with them."""
        for name, value in values.items():
            if type(value) not in PLAIN and name in KIND_OF and _is_number(type(self), name):
                values[name] = in_si(value, name)
        if not self.__pydantic_complete__:
            _build(type(self))
        try:
            super().__init__(**values)
        except ValidationError as error:
            raise InputError(explain(error, type(self).__name__, names=tuple(type(self).model_fields))) from None

    def __eq__(self, other: object) -> bool:
        """Return whether the other is of the same kind with the same fields, whatever either has worked out since."""
        if not isinstance(other, Validated) or type(other) is not type(self):
            return NotImplemented
        return self is other or all(getattr(self, name) == getattr(other, name) for name in type(self).model_fields)

    def __dir__(self) -> list[str]:
        """Return the names of fields and methods, for help and for completion in notebooks."""
        return sorted({*type(self).model_fields, *dir(type(self))})

    def replaced(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, validated like a new one.

        >>> from sweetspot import Pitch
        >>> Pitch(speed=40.0).replaced(speed=35.0).speed
        35.0
        """
        values = {name: getattr(self, name) for name in type(self).model_fields}
        return type(self)(**{**values, **changes})

    def unchecked(self, **changes: Any) -> Self:
        """Return a copy with some fields changed that is not validated: for many copies hardly unlike a valid one."""
        copy = self.model_copy(update=changes)
        for name in vars(copy).keys() - type(self).model_fields.keys():  # what the first has worked out since
            del vars(copy)[name]
        return copy


_building = RLock()
"""Held by the thread that builds a validator: pydantic's own building is not for two threads at once."""


def _build(kind: type[Validated]) -> None:
    """Build the validator of a kind when the first of it is made: a tenth of a first answer's time for all kinds."""
    with _building:
        kind.model_rebuild()


@cache
def _is_number(kind: type[Validated], name: str) -> bool:
    """Return whether a field holds one number, or may hold none."""
    field = kind.model_fields.get(name)
    return field is not None and _types_of(field.annotation) <= {float, NoneType}


def _types_of(annotation: Any) -> set[Any]:
    """Return the types that an annotation allows, without their bounds."""
    if get_origin(annotation) is Annotated:
        return _types_of(get_args(annotation)[0])
    return {kind for part in get_args(annotation) for kind in _types_of(part)} or {annotation}


def explain(error: ValidationError, name: str, *, names: Sequence[str] = ()) -> str:
    """Return one line per fault: what was given, what is allowed and what to do."""
    faults: list[ErrorDetails] = []
    no_texts: set[object] = set()
    for fault in error.errors(include_url=False):
        repeated = fault["type"] == "string_type" and fault["loc"][:1] in no_texts
        if not _is_other_branch(fault) and not repeated and not _is_number_for_pairs(fault):
            faults.append(fault)
            if fault["type"] == "string_type":
                no_texts.add(fault["loc"][:1])
    lines = list(dict.fromkeys(_fault(fault, names) for fault in faults[:MOST_FAULTS]))
    named = next((line for line in lines if names and line.endswith(_all_known(names))), "")
    lines = [line if line == named else line.removesuffix(_all_known(names)) for line in lines]
    meant = [name for name in names if any(f"did you mean {name!r}?" in line for line in lines)]
    lines = [line for line in lines if not any(line == f"{name} is missing" for name in meant)]
    if len(faults) > MOST_FAULTS:
        lines.append(f"and {len(faults) - MOST_FAULTS} more")
    words = "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in name).strip()
    return f"{words}: " + "; ".join(lines)


BOUNDS = {
    "greater_than": ("more than", "gt"),
    "greater_than_equal": ("at least", "ge"),
    "less_than": ("less than", "lt"),
    "less_than_equal": ("at most", "le"),
}
"""By the kind of fault: words for its limit, and pydantic's name of the limit."""


def _allowed(fault: ErrorDetails) -> str:
    words, key = BOUNDS[fault["type"]]
    return f"Allowed is {words} {fault.get('ctx', {})[key]:.4g}"


def _is_other_branch(fault: ErrorDetails) -> bool:
    """Return whether a fault says only that a table is no text: then the table's own faults say more."""
    return fault["type"] == "string_type" and fault["loc"][-1:] == ("str",) and isinstance(fault["input"], dict)


def _is_number_for_pairs(fault: ErrorDetails) -> bool:
    """Return whether a fault says that a bare number is no list of pairs: that it lacks a unit is said beside it."""
    return "tuple[" in "".join(map(str, fault["loc"])) and isinstance(fault["input"], (int, float))


def _all_known(names: Sequence[str]) -> str:
    """Return the end of a message that lists the names."""
    return f"; known are {', '.join(names)}" if names else ""


OTHER_NAMES = {
    "weight": "mass",
    "wood": "material",
    "balance": "balance_point",
    "inertia": "moi",
    "outline": "profile",
    "tension": "strings",
    "string_tension": "strings",
}
"""Of a field, as people call it."""


def _meant(key: str, names: Sequence[str]) -> str:
    """Return the known name that somebody most likely meant by a key; "": none is near."""
    others = {other: name for other, name in OTHER_NAMES.items() if name in names}
    close = get_close_matches(key, [*names, *others], n=1, cutoff=ALMOST)
    return others.get(close[0], close[0]) if close else ""


def _fault(fault: ErrorDetails, names: Sequence[str]) -> str:
    parts = [str(part) for part in fault["loc"] if not (isinstance(part, str) and part.endswith("Table"))]
    place, text = ".".join(parts), fault["msg"].removeprefix("Value error, ")
    given = repr(fault["input"])[:LONGEST_INPUT]
    match fault["type"]:
        case "extra_forbidden":
            close = _meant(parts[-1][:LONGEST_INPUT].lower(), names)
            meant = f": did you mean {close!r}?" if close else _all_known(names) if len(parts) == 1 else ""
            return f"unknown key {place[:LONGEST_INPUT]!r}{meant}"
        case "missing":
            meant = ': write like = "..." with a name of the catalogue, of which the rest is kept'
            return f"{place} is missing{meant if parts[-1] == 'like' else ''}"
        case "string_too_short":
            return f"{place} is empty; write what people call it"
        case "value_error":
            return f"{place}: {text}" if place else text
        case "string_type" if isinstance(fault["input"], (int, float)):
            unit = next((unit for ending, unit in UNIT_OF.items() if parts[0].endswith(ending)), "in")
            return f'{parts[0]} was given as {given}: write the unit too, in quotes, as in "{given} {unit}"'
        case "greater_than" | "greater_than_equal" | "less_than" | "less_than_equal" if isinstance(
            fault["input"], (int, float)
        ):
            text = _allowed(fault)
            if abs(fault["input"]) <= sys.float_info.max:  # beyond, a whole number has no short form
                given = f"{fault['input']:.4g}"
            if parts[-1:] == ["mass"]:
                given = format_mass(fault["input"])
        case "tuple_type" if isinstance(fault["input"], str):
            text += f': write pairs of position and size, as in [["0 in", {given}], ...]'
    return f"{place} was given as {given}: {text[0].lower()}{text[1:]}"

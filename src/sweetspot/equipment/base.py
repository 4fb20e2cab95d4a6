"""The base of every thing: frozen, validated at construction, all values in SI."""

from __future__ import annotations

import unicodedata
from typing import Annotated, Any, Self, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StringConstraints, ValidationError

from sweetspot.errors import InputError

Real = TypeVar("Real", float, NDArray[np.float64])
"""One number or an array of them; what comes out has the shape of what went in."""
Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]
Fraction = Annotated[float, Field(ge=0, le=1)]


def _readable(text: str) -> str:
    """Refuse a name that is blank, or that a terminal or a browser would obey instead of showing."""
    if not text.strip():
        raise ValueError("a name of blanks tells nobody anything; give the name that people use")
    if any(unicodedata.category(letter) in UNSEEN for letter in text if letter not in JOINERS):
        raise ValueError("it holds control or formatting characters; write letters, digits and signs only")
    return text


UNSEEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}
"""Kinds of characters that are commands: controls, formats, line ends."""
JOINERS = "\u200c\u200d"
"""Format characters that some scripts are written with."""
Name = Annotated[str, StringConstraints(min_length=1, max_length=100), AfterValidator(_readable)]
"""What people call a thing: it is printed, written into tables and drawn."""
MOST_FAULTS, LONGEST_INPUT = 5, 80
"""Faults told of at once, and letters of what was given that are repeated."""


class Validated(BaseModel):
    """An immutable, validated value; a wrong one raises `InputError` with one clear message."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    def __init__(self, **values: Any) -> None:
        try:
            super().__init__(**values)
        except ValidationError as error:
            raise InputError(explain(error, type(self).__name__)) from None

    def replaced(self, **changes: Any) -> Self:
        """Return a copy with some fields changed, validated like a new one."""
        kept = {name: getattr(self, name) for name in type(self).model_fields}
        return type(self)(**{**kept, **changes})


def explain(error: ValidationError, name: str) -> str:
    """Say in one line per fault what was given and what is allowed.

    Parameters
    ----------
    error : the validation error.
    name : what was being made, for the beginning of the message.
    """
    lines = []
    faults = error.errors(include_url=False)
    for fault in faults[:MOST_FAULTS]:
        place = ".".join(str(part) for part in fault["loc"])
        text = fault["msg"].removeprefix("Value error, ")
        if fault["type"] == "extra_forbidden":
            lines.append(f"unknown key {place[:LONGEST_INPUT]!r}")
        elif fault["type"] == "missing":
            lines.append(f"{place} is missing")
        elif fault["type"] == "value_error":
            lines.append(f"{place}: {text}" if place else text)
        else:
            text = text[0].lower() + text[1:]
            lines.append(f"{place} was given as {repr(fault['input'])[:LONGEST_INPUT]}: {text}")
    if len(faults) > MOST_FAULTS:
        lines.append(f"and {len(faults) - MOST_FAULTS} more")
    return f"{name.lower()}: " + "; ".join(lines)

"""The base of every thing: frozen, validated at construction, all values in SI."""

from __future__ import annotations

from typing import Annotated, Any, Self, TypeVar

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sweetspot.errors import InputError

Real = TypeVar("Real", float, NDArray[np.float64])
"""One number or an array of them; what comes out has the shape of what went in."""
Positive = Annotated[float, Field(gt=0)]
NonNegative = Annotated[float, Field(ge=0)]
Fraction = Annotated[float, Field(ge=0, le=1)]


class Thing(BaseModel):
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
    for fault in error.errors(include_url=False):
        place = ".".join(str(part) for part in fault["loc"])
        text = fault["msg"].removeprefix("Value error, ")
        if fault["type"] == "extra_forbidden":
            lines.append(f"unknown key {place!r}")
        elif fault["type"] == "missing":
            lines.append(f"{place} is missing")
        elif fault["type"] == "value_error":
            lines.append(f"{place}: {text}" if place else text)
        else:
            text = text[0].lower() + text[1:]
            lines.append(f"{place} was given as {fault['input']!r}: {text}")
    return f"{name.lower()}: " + "; ".join(lines)

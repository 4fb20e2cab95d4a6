"""Faults of a request from a browser or a program, in plain words beside the field that they concern."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from fastapi.exceptions import RequestValidationError
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sweetspot.errors import InputError, SweetspotError
from sweetspot.units.dimensions import System
from sweetspot.web.documents import in_one_system

MOST_FAULTS = 20
LONGEST_MESSAGE = 500
"""Letters of a message; longer input is cut."""


class Fault(BaseModel):
    """A fault: the control that it concerns, empty for the whole message, and a sentence."""

    model_config = ConfigDict(frozen=True)

    field: str
    message: str
    words: Mapping[System, str] | None = Field(None, description="the message for readers of either system of units")
    more: tuple[Fault, ...] = Field((), description="what else is wrong, where several controls are")
    again: bool = Field(False, description="the answer is still being worked out, and there when asked for again")

    def plain(self) -> dict[str, object]:
        """Return the fields that are not empty."""
        return self.model_dump(exclude_defaults=True)


class Refusal(BaseModel):
    """The body of every 4xx and 5xx answer."""

    error: Fault


class FieldError(InputError):
    """An input error that knows which control it belongs to; an empty field is the whole message."""

    def __init__(self, field: str, message: str, more: tuple[Fault, ...] = ()) -> None:
        super().__init__(message)
        self.field, self.more = field, more


class FullDiskError(FieldError):
    """What was handed in could not be kept on this machine's disk."""


@contextmanager
def about(field: str) -> Iterator[None]:
    """Assign every input error raised inside to ``field``, unless it names one itself."""
    try:
        yield
    except FieldError:
        raise
    except SweetspotError as error:
        raise FieldError(field, str(error)) from None


def fault(error: SweetspotError | ValidationError | RequestValidationError) -> Fault:
    """Return the fault, short enough to show: the first fault, with the rest as ``more``."""
    if isinstance(error, ValidationError):
        return _together([_of_problem(problem) for problem in error.errors(include_url=False)])
    if isinstance(error, RequestValidationError):  # the first part of a place says that it stood in the body
        return _together([_of_problem({**problem, "loc": problem["loc"][1:]}) for problem in error.errors()])
    field, more = (error.field, error.more) if isinstance(error, FieldError) else ("", ())
    words = {system: shortened(text) for system, text in in_one_system(str(error)).items()}
    both = None if words["us"] == words["si"] else words
    return _together([Fault(field=field, message=shortened(str(error)), words=both), *more])


def shortened(message: str) -> str:
    """Return a message on one line, cut where it is longer than anyone reads."""
    words = " ".join(message.split())
    return words if len(words) <= LONGEST_MESSAGE else words[: LONGEST_MESSAGE - 1] + "…"


def _together(faults: list[Fault]) -> Fault:
    first, *rest = faults[:MOST_FAULTS]
    return first.model_copy(update={"more": tuple(rest)})


def _of_problem(problem: Any) -> Fault:
    place = problem["loc"] if problem["loc"][:1] == ("others",) else problem["loc"][:1]  # whose items have controls
    field = ".".join(str(part) for part in place)
    if problem["type"] == "json_invalid":  # its place is a number of letters, and no control
        return Fault(field="", message=NO_OBJECT)
    if problem["type"] in ("model_attributes_type", "model_type", "dict_type", "missing") and not field:
        return Fault(field="", message=NO_OBJECT)
    return Fault(field=field, message=shortened(_sentence(problem)))


def _sentence(problem: Any) -> str:
    """Return one of pydantic's complaints in our words."""
    words = _WORDS.get(problem["type"])
    text = problem["msg"].removeprefix("Value error, ")
    text = text[0].lower() + text[1:] if words is None else words.format(**problem.get("ctx", {}))
    given = problem.get("input")
    return f"{text}; given was {str(given)[:60]!r}" if isinstance(given, str | int | float) else text


NO_OBJECT = "the message must be one JSON object, sent as application/json"
_WORDS = {
    "extra_forbidden": "there is no such control",
    "missing": "this field is required",
    "greater_than_equal": "allowed is {ge:g} or more",
    "less_than_equal": "allowed is {le:g} or less",
    "greater_than": "allowed is more than {gt:g}",
    "less_than": "allowed is less than {lt:g}",
    "finite_number": "give a finite number",
    "float_type": "give a number",
    "float_parsing": "give a number",
    "int_type": "give a whole number",
    "int_parsing": "give a whole number",
    "int_from_float": "give a whole number",
    "bool_parsing": "give true or false",
    "literal_error": "allowed is {expected}",
    "bool_type": "give true or false",
    "string_type": "give a text",
    "tuple_type": "give a list",
    "list_type": "give a list",
    "dict_type": "give names and values",
    "model_type": "give names and values",
    "model_attributes_type": "give names and values",
    "too_short": "give at least {min_length}; given were {actual_length}",
    "too_long": "give at most {max_length}; given were {actual_length}",
    "string_too_short": "give at least one letter",
    "string_pattern_mismatch": "this names nothing that was handed in here",
    "string_too_long": "this is longer than the {max_length} letters allowed",
}

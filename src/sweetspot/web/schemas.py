"""Models of the API besides answers."""

from __future__ import annotations

from typing import Any, Literal

from pydantic import BaseModel, Field
from pydantic.json_schema import models_json_schema


class Fault(BaseModel):
    """A fault: the control that it concerns, empty for the whole message, and a sentence."""

    field: str
    message: str
    more: list[dict[str, str]] = Field([], description="what else is wrong, where several controls are")


class Refusal(BaseModel):
    """The body of every 4xx answer."""

    error: Fault


class Later(Fault):
    """Why there is no answer yet."""

    again: bool


class Unfinished(BaseModel):
    """The body of an answer that takes long: it is being worked out, and there when asked for again."""

    error: Later


class BatText(BaseModel):
    """A bat file's text."""

    toml: str = Field(max_length=20_000)


class Described(BatText):
    """A file that answers made, and what was changed of its pattern so that it weighs what was said; "": nothing.

    The words are for readers of either system.
    """

    told: dict[Literal["us", "si"], str]


class Choice(BaseModel):
    """One of a list: what programs call it, and what people do."""

    key: str
    name: str


class Tool(Choice):
    """Something that one hits a ball with, and in which sport."""

    sport: str


class Meaning(BaseModel):
    """The meaning of a word: the names under which it is listed, the explanation in either system, and its source."""

    names: list[str]
    words: dict[Literal["us", "si"], str]
    source: str


class BatFacts(BaseModel):
    """A bat in a list."""

    key: str
    name: str
    length_m: float
    mass_kg: float
    balance_point_m: float
    moi_6in_kg_m2: float
    hollow: bool
    sport: str


REFUSALS = {
    400: "The message is not JSON.",
    403: "Asked by a page of another server.",
    413: "The message is too large.",
    421: "The server is not called that.",
    422: "A control has a value that does not work.",
}
"""The status codes with which every route may answer a `Refusal`, and why."""
UNFINISHED: dict[int | str, dict[str, Any]] = {
    503: {
        "model": Unfinished,
        "description": "This takes long and is still being worked out: ask again after the seconds of Retry-After.",
        "headers": {"retry-after": {"description": "s", "schema": {"type": "integer"}}},
    }
}


def with_refusals(document: dict[str, Any]) -> dict[str, Any]:
    """Return an OpenAPI document in which every route may refuse; routes that say it themselves each check it anew."""
    place = "#/components/schemas/{model}"
    body = {"application/json": {"schema": {"$ref": place.format(model=Refusal.__name__)}}}
    refusals = {str(code): {"description": words, "content": body} for code, words in REFUSALS.items()}
    for routes in document["paths"].values():
        for route in routes.values():
            route["responses"] |= refusals
    schemas = document["components"]["schemas"]
    schemas |= models_json_schema([(Refusal, "serialization")], ref_template=place)[1]["$defs"]
    for name in ("HTTPValidationError", "ValidationError"):  # what the framework says of 422
        schemas.pop(name, None)
    return document

"""Models of the catalogue over the API."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field


class BatText(BaseModel):
    """A bat file's text."""

    toml: str = Field(max_length=20_000)


class Described(BatText):
    """A file that answers made, what was changed of its pattern to weigh as it does, and what was assumed.

    The words are for readers of either system.
    """

    told: dict[Literal["us", "si"], str]
    assumed: dict[Literal["us", "si"], list[str]]


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
    """A bat in a list; ``use`` is the heading under which people look for it."""

    key: str
    name: str
    length_m: float
    mass_kg: float
    balance_point_m: float
    moi_6in_kg_m2: float
    hollow: bool
    sport: str
    use: str

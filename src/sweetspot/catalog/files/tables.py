"""Tables of a TOML file: each field says what quantity, name or part it is, for reading and for writing alike."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Container, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Annotated, Literal, TypeVar

from pydantic import ConfigDict, Field, PositiveFloat
from pydantic.fields import FieldInfo

from sweetspot.catalog.records import FOLDER, canonical, read_table
from sweetspot.equipment.base import Validated
from sweetspot.equipment.material import Material
from sweetspot.equipment.shell import check_count
from sweetspot.errors import InputError
from sweetspot.plausibility import check, parse
from sweetspot.units import Kind

Part = TypeVar("Part", bound=Validated)


@dataclass(frozen=True)
class Of:
    """Kind of quantity of a field's text."""

    kind: Kind


@dataclass(frozen=True)
class PairsOf:
    """Kinds of quantity of the two texts of every pair in a field."""

    first: Kind
    second: Kind


@dataclass(frozen=True)
class NameOf:
    """Loader of what a field's text names in the catalogue; ``of_body``: where it names none, the bat's material."""

    function: Callable[[str], object]
    of_body: bool = False


@dataclass(frozen=True)
class Made:
    """Part that a field's table describes, or each of its tables, and what holds these parts together."""

    part: type[Validated]
    table: type[FileTable]
    whole: Callable[[tuple[Validated, ...]], object] = tuple


@dataclass(frozen=True)
class Called:
    """Name of a field in the thing, where it is not that in the file."""

    name: str


Meaning = Of | PairsOf | NameOf | Made
LENGTH, MASS, MOI, FORCE = Of("length"), Of("mass"), Of("moi"), Of("force")
FREQUENCY, STIFFNESS, LINEAR_DENSITY = Of("frequency"), Of("stiffness"), Of("linear density")
ANGLE, DENSITY, PRESSURE = Of("angle"), Of("density"), Of("pressure")
AREAL_DENSITY, TIME = Of("areal density"), Of("time")
SIZES = PairsOf("length", "length")
Length = Annotated[str, LENGTH]
Mass = Annotated[str, MASS]
Sizes = Annotated[tuple[tuple[str, str], ...], SIZES]
"""Pairs of position from the butt end and size."""
Parts = Annotated[tuple[tuple[str, float], ...] | None, PairsOf("length", "ratio")]
"""Pairs of position from the butt end and a ratio, or None."""


class FileTable(Validated):
    """A table of a file: text with units, as people write it."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False, defer_build=True)


def meaning_of(field: FieldInfo) -> Meaning | None:
    """Return the meaning of a field; None: a text, a number or a table as it is."""
    return next((mark for mark in field.metadata if isinstance(mark, Meaning)), None)


def called(name: str, field: FieldInfo) -> str:
    """Return the name in the thing of a file's field."""
    return next((mark.name for mark in field.metadata if isinstance(mark, Called)), name)


def in_si(text: str, kind: Kind, what: str, implement: str) -> float:
    """Return a quantity of a file in SI; one far from usual for this kind of implement is refused."""
    value = parse(text, kind, what)
    check(value, what, text, quantity=f"{implement} {what}")
    return value


def made(
    part: type[Part],
    table: FileTable,
    what: str = "",
    *,
    implement: str,
    body: Material | None = None,
    given: Mapping[str, object] = MappingProxyType({}),
) -> Part:
    """Return the thing or the part that a table describes: texts become numbers in SI, names and tables what they mean.

    Parameters
    ----------
    what : the table's name in its file, for messages.
    """
    values = values_in_si(table, what, implement=implement, body=body, left_out=given.keys())
    return part(**{name: value for name, value in values.items() if name in part.model_fields}, **given)


def values_in_si(
    table: FileTable, what: str = "", *, implement: str, body: Material | None = None, left_out: Container[str] = ()
) -> dict[str, object]:
    """Return the meanings of a table's fields, by their names in the thing, known ones left out; see `made`."""
    return {
        called(name, field): _meant(
            getattr(table, name), meaning_of(field), f"{what}.{name}" if what else name, implement, body
        )
        for name, field in type(table).model_fields.items()
        if called(name, field) not in left_out
    }


def _meant(value: object, meaning: Meaning | None, label: str, implement: str, body: Material | None) -> object:
    """Return the meaning of a field's value."""
    match value, meaning:
        case None, NameOf(of_body=True):
            value = body
        case str(), Of():
            value = in_si(value, meaning.kind, label, implement)
        case str(), NameOf():
            value = meaning.function(value)
        case tuple(), PairsOf():
            value = _pairs(value, meaning, label, implement)
        case FileTable(), Made():
            value = made(meaning.part, value, label, implement=implement, body=body)
        case tuple(), Made():
            parts = (made(meaning.part, table, label, implement=implement, body=body) for table in value)
            value = meaning.whole(tuple(parts))
    return value


def _pairs(
    value: tuple[tuple[str, str | float], ...], meaning: PairsOf, label: str, implement: str
) -> tuple[tuple[float, float], ...]:
    check_count(value, label)
    pairs = tuple(
        (parse(first, meaning.first, f"{label} position"), parse(second, meaning.second, f"{label} size"))
        for first, second in value
    )
    for (_, size), (_, text) in zip(pairs, value, strict=True):
        check(size, label, text, quantity=f"{implement} {label}")
    return pairs


class MeasuredTable(FileTable):
    """[[calibration.value]]: one thing that was measured on this bat, SI."""

    quantity: Literal["mass", "balance_point", "moi", "period", "frequency"]
    measured: float
    error: PositiveFloat = Field(description="one standard error")
    axis: float = Field(0.0, description="of a moment of inertia or a period, m from the knob end")
    family: Literal["bending", "hoop", "face"] | None = Field(None, description="of the mode whose frequency it is")
    harmonic: int = Field(1, description="of that mode")


class CalibrationTable(FileTable):
    """[calibration]: what `sweetspot calibrate` leaves unknown about this bat."""

    measured: tuple[str, ...] = Field(description="names of what was measured")
    value: tuple[MeasuredTable, ...] = Field((), description="what was measured, but for shots")
    unknowns: tuple[str, ...] = Field(description="names of what is not known exactly")
    covariance: tuple[tuple[float, ...], ...] = Field(
        description="of the unknowns' deviations: of logarithms, and of the density gradient itself"
    )


def check_sport(sport: str, *, kind: str) -> None:
    """Refuse a sport of the catalogue that is played with other things.

    Parameters
    ----------
    sport : as a file has it.
    kind : of what the file describes: ``bat``, ``racket``, ...

    Raises
    ------
    InputError
        naming the sports that such a thing may have.

    >>> check_sport("tennis", kind="bat")
    Traceback (most recent call last):
    ...
    sweetspot.errors.InputError: sport was given as 'tennis', and that is played with a racket, not with a bat; \
allowed for a bat: baseball, slow-pitch, softball, youth-baseball
    """
    kinds = _kinds()
    played_with = kinds.get(canonical(sport))
    if played_with is not None and kind not in played_with:
        allowed = ", ".join(sorted(kind_of_tool for kind_of_tool, played in kinds.items() if kind in played))
        with_what = " or ".join(f"a {kind_of_tool.replace('-', ' ')}" for kind_of_tool in sorted(played_with))
        raise InputError(
            f"sport was given as {sport!r}, and that is played with {with_what}, not with a "
            f"{kind.replace('-', ' ')}; allowed for a {kind.replace('-', ' ')}: {allowed}"
        )


@cache
def _kinds() -> dict[str, frozenset[str]]:
    """Return the kinds of implements that the catalogue has for each sport, its own and borrowed ones."""
    kinds: dict[str, set[str]] = {}
    kind_of: dict[str, str] = {}
    for folder in ("bats", "implements"):
        for path in (FOLDER / folder).glob("*.toml"):
            table = tomllib.loads(path.read_text(encoding="utf-8"))
            kind_of[path.stem] = str(table.get("kind", "bat"))
            kinds.setdefault(canonical(str(table.get("sport", "baseball"))), set()).add(kind_of[path.stem])
    for sport, entry in read_table("sports.toml").items():
        kinds.setdefault(canonical(sport), set()).update(kind_of[name] for name in entry.texts("implements"))
    return {sport: frozenset(those) for sport, those in kinds.items() if those}

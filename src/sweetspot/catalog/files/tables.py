"""Tables of a TOML file whose fields say what quantity each text is, and become numbers in SI by themselves."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import ConfigDict

from sweetspot.equipment.base import Validated
from sweetspot.equipment.shell import check_count
from sweetspot.plausibility import check, parse
from sweetspot.units import Kind


@dataclass(frozen=True)
class Of:
    """What quantity a field's text is."""

    kind: Kind


@dataclass(frozen=True)
class PairsOf:
    """What quantities the two texts of every pair in a field are."""

    first: Kind
    second: Kind


LENGTH, MASS, MOI, FORCE = Of("length"), Of("mass"), Of("moi"), Of("force")
FREQUENCY, STIFFNESS, LINEAR_DENSITY = Of("frequency"), Of("stiffness"), Of("linear density")
Length = Annotated[str, LENGTH]
Mass = Annotated[str, MASS]
Sizes = Annotated[tuple[tuple[str, str], ...], PairsOf("length", "length")]
"""Pairs of position from the butt end and size."""
Parts = Annotated[tuple[tuple[str, float], ...] | None, PairsOf("length", "ratio")]
"""Pairs of position from the butt end and a ratio, or None."""


class FileTable(Validated):
    """A table of a file: text with units, as people write it."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=False)


def parsed(text: str, kind: Kind, what: str, implement: str) -> float:
    """Return a quantity of a file in SI; one far from usual for this kind of implement is refused."""
    value = parse(text, kind, what)
    check(value, what, text, quantity=f"{implement} {what}")
    return value


def in_si(table: FileTable, what: str = "", *, implement: str) -> dict[str, Any]:
    """Return the fields of a table with every text that is a quantity as a number in SI; None where there is none.

    Parameters
    ----------
    table : its fields are annotated with `Of` or `PairsOf`; others, tables among them, are left as they are.
    what : the table's name in its file, for messages.
    implement : its kind, whose sizes are known to be usual or not.
    """
    values: dict[str, Any] = {}
    for name, field in type(table).model_fields.items():
        value, label = getattr(table, name), f"{what}.{name}" if what else name
        for meaning in field.metadata:
            if value is not None and isinstance(meaning, Of):
                value = parsed(value, meaning.kind, label, implement)
            elif value is not None and isinstance(meaning, PairsOf):
                check_count(value, label)
                pairs = [
                    (parse(first, meaning.first, f"{label} position"), parse(second, meaning.second, f"{label} size"))
                    for first, second in value
                ]
                for (_, size), (_, text) in zip(pairs, value, strict=True):
                    check(size, label, text, quantity=f"{implement} {label}")
                value = tuple(pairs)
        values[name] = value
    return values

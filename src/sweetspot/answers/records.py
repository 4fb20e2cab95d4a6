"""An answer's fields for other programs: names with units, intervals beside numbers, and how draws put them there.

A record is a frozen dataclass of `Number`, `Curve`, texts, further records and tuples of them. The type of a field says
its dimension, ``Annotated[Number, SPEED]``, or that it is for the package alone, ``Annotated[Impact, INTERNAL]``. A
field that is None and may be absent (its default is None) has no key.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import Field, fields, is_dataclass, replace
from functools import cache
from types import UnionType
from typing import Annotated, Any, Final, TypeVar, Union, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import NDArray

from sweetspot.calibration.measured import CalibratedValue, Measured
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Band, Curve, Interval, Number, interval_of
from sweetspot.uncertainty.intervals import Reach
from sweetspot.units.dimensions import (
    ANGLE,
    DISTANCE,
    ENERGY,
    FORCE,
    FREQUENCY,
    IMPULSE,
    LENGTH,
    MASS,
    MOI,
    RATIO,
    SPEED,
    SPIN,
    TIME,
    Dimension,
    System,
)

INTERNAL: Final = "internal"
"""Mark of a field that other programs do not see."""
NESTED: Final = "nested"
"""Mark of a number whose interval other programs see below its own name, {"value", "low", "high"}."""
GRID: Final = "grid"
"""Mark of an array of rows, shape (m, n); one without it has one dimension."""
GAPS: Final = "gaps"
"""Mark of an array some of whose values may be nan, which other programs see as None."""

OF_RECORD: Final = "dimension of the record"
"""Mark of a number whose dimension its record says, in a property ``dimension``."""
PLAIN_ENDS: Final = "plain ends"
"""Mark of a number the ends of whose interval are called just ``low`` and ``high``."""
INLINE: Final = "inline"
"""Mark of a record or mapping whose entries stand among those of the record that has it."""

Speed = Annotated[Number, SPEED]
Length = Annotated[Number, LENGTH]
Distance = Annotated[Number, DISTANCE]
Mass = Annotated[Number, MASS]
MomentOfInertia = Annotated[Number, MOI]
Time = Annotated[Number, TIME]
Force = Annotated[Number, FORCE]
Impulse = Annotated[Number, IMPULSE]
Energy = Annotated[Number, ENERGY]
Angle = Annotated[Number, ANGLE]
Spin = Annotated[Number, SPIN]
Frequency = Annotated[Number, FREQUENCY]
Ratio = Number

PlainTable = dict[str, Any]
"""What JSON holds: plain numbers, texts, lists and such tables, by names with units."""
Columns = Mapping[str, "Array | Columns | Sequence[Columns]"]
"""By a field's name what draws answer, shape (draws,) or (draws, n); a record's columns, or a tuple of such."""
Record = TypeVar("Record")


def visible_fields(kind: type) -> Iterator[tuple[Field[Any], Any, Dimension]]:
    """Yield the fields that other programs see, each with its type and its dimension."""
    hints = _hints(kind)
    for field in fields(kind):
        marks = list(_marks(hints[field.name]))
        if INTERNAL not in marks:
            yield field, hints[field.name], next((mark for mark in marks if isinstance(mark, Dimension)), RATIO)


def _marks(hint: Any) -> Iterator[Any]:
    """Yield what a type is annotated with, that of a part of a union included."""
    if get_origin(hint) is Annotated:
        yield from get_args(hint)[1:]
    elif get_origin(hint) in (Union, UnionType):
        for part in get_args(hint):
            yield from _marks(part)


@cache
def _hints(kind: type) -> Mapping[str, Any]:
    return get_type_hints(kind, include_extras=True)


def to_dict(record: Any, system: System = "si") -> PlainTable:
    """Return a record as plain numbers, texts, lists and dictionaries, with the unit in every key.

    The ends of an interval stand beside its number, ``exit_speed_low_m_s`` and ``exit_speed_high_m_s``; what is not
    finite is None. A measured value has its standard error too, ``mass_error_kg``.

    ``record``: a dataclass as this module describes. ``system``: of units; angles in radians or degrees.
    """
    table: PlainTable = {}
    for field, hint, dimension in visible_fields(type(record)):
        value = getattr(record, field.name)
        if value is None and field.default is None:
            continue
        marks = list(_marks(hint))
        if INLINE in marks:
            table |= _plain(value, dimension, system)
            continue
        counted_in = record.dimension if OF_RECORD in marks else dimension
        table |= _entries(field.name, value, counted_in, system, marks=marks)
    return table


def plain_data(value: Any, system: System = "si") -> Any:
    """Return the contents of an answer, records included, as plain numbers, texts, lists and dictionaries."""
    return _plain(value, RATIO, system)


def _entries(name: str, value: Any, dimension: Dimension, system: System, *, marks: Sequence[Any]) -> PlainTable:
    """Return one field's keys and values."""
    if NESTED in marks and value is not None:
        number = interval_of(value)
        sides = {"value": number.value, "low": number.low, "high": number.high}
        return {dimension.key(name, system): _plain(sides, dimension, system)}
    if isinstance(value, CalibratedValue):
        return {name: {"kind": value.kind, **_entries(name, value.value, dimension, system, marks=marks)}}
    if isinstance(value, (Interval, Band, Measured)):
        low, high = ("low", "high") if PLAIN_ENDS in marks else (f"{name}_low", f"{name}_high")
        ends = {name: value.value, low: value.low, high: value.high}
        if isinstance(value, Measured):
            ends[f"{name}_error"] = value.error
        return {dimension.key(key, system): _plain(end, dimension, system) for key, end in ends.items()}
    return {dimension.key(name, system): _plain(value, dimension, system)}


def _plain(value: Any, dimension: Dimension, system: System) -> Any:  # noqa: PLR0911 - one for each kind of value
    value = value.item() if isinstance(value, np.generic) else value
    if is_dataclass(value):
        if dimension is RATIO:
            return to_dict(value, system)
        # its fields have the unit that stands in the key above them
        return {key: _plain(number, dimension, system) for key, number in to_dict(value).items()}
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        counted = dimension.counted(value, system)
        return (counted if np.isfinite(counted).all() else _with_none(counted)).tolist()
    if isinstance(value, Mapping):
        return {key: _plain(item, dimension, system) for key, item in value.items()}
    if isinstance(value, (np.ndarray, list, tuple)):
        items = value.tolist() if isinstance(value, np.ndarray) else value
        return [_plain(item, dimension, system) for item in items]
    if isinstance(value, float):
        return dimension.counted(value, system) if math.isfinite(value) else None
    return value


def _with_none(values: Array) -> NDArray[np.object_]:
    """Return an array with None in the place of what is not finite."""
    items = values.astype(object)
    items[~np.isfinite(values)] = None
    return items


def with_intervals(record: Record, drawn: Columns, reach: Callable[[Array], Reach]) -> Record:
    """Return a record whose numbers have intervals.

    ``record``: the answer as described. ``drawn``: what draws answer, by the record's fields; the first draw is
    everything as described. ``reach``: from all draws of a number to how far its interval goes below and above the
    first of them.
    """
    changed: dict[str, object] = {}
    for name, column in drawn.items():
        value = getattr(record, name)
        if value is None:
            continue
        if isinstance(column, Mapping):
            changed[name] = with_intervals(value, column, reach)
        elif isinstance(column, np.ndarray):
            changed[name] = _around(value, reach(column))
        else:
            changed[name] = tuple(with_intervals(*pair, reach) for pair in zip(value, column, strict=True))
    return replace(record, **changed)  # type: ignore[type-var]


def _around(value: Any, reach: Reach) -> Number | Curve:
    """Return a number or curve with its interval; as it is where no end is known."""
    centre = value.value if isinstance(value, (Interval, Band)) else value
    low, high = centre - reach.below, centre + reach.above
    if isinstance(centre, np.ndarray):
        return Band(centre, low, high)
    if not (math.isfinite(low) and math.isfinite(high)):
        return float(centre)
    return Interval(float(centre), float(low), float(high))

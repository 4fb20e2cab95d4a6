"""A document whose numbers carry intervals: every slot that says where it is in the data, and the data itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from sweetspot.report.document import Document
from sweetspot.report.json_shapes import cleaned
from sweetspot.report.quantities import SCALES
from sweetspot.report.sentences import Bounds, Doubtful, Sentence, Slot
from sweetspot.uncertainty.intervals import Reach

ENDINGS = sorted({scale.ending for scale in SCALES.values() if scale.ending}, key=len, reverse=True)


def with_intervals(document: Document, reaches: Mapping[str, Reach]) -> Document:
    """Return a document with an interval beside each number that one is known of.

    Parameters
    ----------
    reaches : by the number's name in the document's data, "best_hit.exit_speed_m_s"; see `Slot.of`.
    """
    data = with_ends(document.data, reaches)
    curves = {"position": np.asarray(_found(document.data, "scan.position_m"), float)}

    def changed(part: Any) -> Any:
        if isinstance(part, (Slot, Doubtful)):
            return _slot(part, reaches, curves)
        if isinstance(part, Sentence):
            own = [changed(one) for one in part.parts]
            gone = {index + 1 for index, (old, new) in enumerate(zip(part.parts, own, strict=True)) if new is not old}
            # an interval that a number had gives way
            return Sentence(
                tuple(one for index, one in enumerate(own) if not (index in gone and isinstance(one, Bounds)))
            )
        if isinstance(part, (list, tuple)):
            return type(part)(changed(one) for one in part)
        if is_dataclass(part) and not isinstance(part, type):
            values = {field.name: getattr(part, field.name) for field in fields(part) if field.init}
            new = {name: changed(value) for name, value in values.items() if isinstance(value, (list, tuple))
                   or (is_dataclass(value) and not isinstance(value, type))}  # fmt: skip
            return replace(part, **new) if any(new[name] is not values[name] for name in new) else part
        return part

    return replace(
        document, title=changed(document.title), subtitle=changed(document.subtitle), blocks=changed(document.blocks),
        details=changed(document.details), data=data, rows=_rows(document.rows, reaches),
    )  # fmt: skip


def reached(slot: Slot, reaches: Mapping[str, Reach]) -> Slot:
    """Return a number with its interval, where one is known, as pictures write it."""
    value = _slot(slot, reaches, {})
    assert isinstance(value, Slot)
    return value


def _found(data: Any, path: str) -> Any:
    for key in path.split("."):
        data = data.get(key) if isinstance(data, Mapping) else None
    return [] if data is None else data


def _slot(slot: Slot | Doubtful, reaches: Mapping[str, Reach], curves: Mapping[str, Any]) -> Slot | Doubtful:
    name, _, place = slot.of.removeprefix("-").partition("@")
    reach = reaches.get(name)
    below, above = _one_of_many(name, reaches) if reach is None else (reach.below, reach.above)
    if below is None or above is None:
        return slot
    if place:
        at = float(place)
        below, above = (np.asarray(np.interp(at, curves["position"], side)) for side in (below, above))
    sides = (float(below), float(above))
    if isinstance(slot, Doubtful):
        return Slot(slot.value, slot.scale, of=slot.of, reach=sides)
    return replace(slot, reach=sides[::-1] if slot.of.startswith("-") else sides)


def _one_of_many(name: str, reaches: Mapping[str, Reach]) -> tuple[Any, Any]:
    """Return how far the interval of one number of a list goes, "modes.0.nodes_m.2"; None where it is in none."""
    stem, _, number = name.rpartition(".")
    reach = reaches.get(stem)
    if reach is None or not number.isdigit() or int(number) >= np.size(reach.below):
        return None, None
    return reach.below[int(number)], reach.above[int(number)]


def with_ends(data: Mapping[str, Any], reaches: Mapping[str, Reach]) -> dict[str, Any]:
    """Return data with the ends of intervals beside their numbers: ``exit_speed_low_m_s``, ``exit_speed_high_m_s``.

    A number that has ends already, {"value", "low", "high"}, gets new ones.
    """
    made = cleaned(dict(data))
    for path, reach in reaches.items():
        *way, key = path.split(".")
        parent: Any = made
        for step in way:
            if isinstance(parent, list):
                parent = parent[int(step)] if step.isdigit() and int(step) < len(parent) else None
            else:
                parent = parent.get(step) if isinstance(parent, dict) else None
        if not isinstance(parent, dict) or parent.get(key) is None:
            continue
        value = parent[key]
        if isinstance(value, dict) and "value" in value:
            low, high = value["value"] - reach.below, value["value"] + reach.above
            value |= cleaned({"low": float(low), "high": float(high)})
        else:
            parent |= _ends(key, value, reach)
    return made


def _ends(key: str, value: Any, reach: Reach) -> dict[str, Any]:
    """Return the ends of an interval under the number's name with _low and _high before its unit."""
    centre = np.array([np.nan if one is None else one for one in value] if isinstance(value, list) else value, float)
    ending = next((one for one in ENDINGS if key.endswith(one)), "")
    stem = key.removesuffix(ending)
    ends = {f"{stem}_low{ending}": centre - reach.below, f"{stem}_high{ending}": centre + reach.above}
    return cleaned({name: end if end.ndim else float(end) for name, end in ends.items()})


def _rows(rows: Mapping[str, Sequence[Any]], reaches: Mapping[str, Reach]) -> dict[str, Sequence[Any]]:
    """Return columns, those of curves with the ends of their intervals behind them."""
    columns: dict[str, Sequence[Any]] = {}
    for key, values in rows.items():
        columns[key] = values
        reach = reaches.get(f"scan.{key}")
        if reach is not None and np.shape(reach.below) == (len(values),):
            columns |= _ends(key, list(values), reach)
    return columns

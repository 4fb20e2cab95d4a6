"""How many slips of units are noticed: every size in every file of the catalogue, ten times, a tenth, in for cm.

A slip is one number with its unit in a catalogue file multiplied by ten, divided by ten, or with inch and centimetre
exchanged. It is noticed when the file is refused or warned about by name. Only a slip that changes the answer matters:
the greatest exit speed of a standard hit, the balance point, or the moment of inertia, by more than 10 %.

Run: .venv/bin/python tools/unit_slips.py [EVERY]   (EVERY: take each EVERY-th slip only)
"""

from __future__ import annotations

import copy
import os
import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.catalog.files.implement import implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.usual_bodies import doubts
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.equipment.implement import Implement
from sweetspot.errors import SweetspotError

NUMBER = re.compile(r"^(-?[\d.]+(?:e-?\d+)?)(\s*)(\S.*)$")
EXCHANGED = {"in": "cm", "cm": "in", "mm": "in"}
MATTERS = 0.1
PLACES = 25


@dataclass(frozen=True)
class Slip:
    """A number of a file, where it stands, and what was written instead."""

    name: str
    path: tuple[str | int, ...]
    before: str
    after: str

    def table(self, tables: dict[str, dict[str, Any]]) -> dict[str, Any]:
        """Return the file's table with the slip in it."""
        table = copy.deepcopy(tables[self.name])
        place: Any = table
        for key in self.path[:-1]:
            place = place[key]
        place[self.path[-1]] = self.after
        return table

    def __str__(self) -> str:
        return f"{self.name}: {'.'.join(map(str, self.path))} = {self.before} -> {self.after}"


def slips(tables: dict[str, dict[str, Any]]) -> Iterator[Slip]:
    """Yield every slip of every number with a unit; of a long list the middle entry stands for all."""
    for name, table in tables.items():
        for path, text in _texts(table):
            found = NUMBER.match(text)
            if found is None or path[-1] in ("source", "where", "note", "name", "kind", "spread"):
                continue
            number, gap, unit = found.groups()
            changed = [f"{10 * float(number):g}{gap}{unit}", f"{float(number) / 10:g}{gap}{unit}"]
            if unit in EXCHANGED:
                changed.append(f"{number}{gap}{EXCHANGED[unit]}")
            yield from (Slip(name, path, text, after) for after in changed)


def answers(implement: Implement) -> np.ndarray:
    """Return greatest exit speed m/s, balance point m and moment of inertia about it kg m^2."""
    conditions = standard_conditions(implement)
    reduced = reduced_bat(implement, ball=conditions.ball)
    places = np.linspace(0.45, 0.98, PLACES) * implement.length
    if (outline := implement.outline) is not None:
        places = np.linspace(outline.start, outline.end, PLACES)
    hit = scan(implement, body=reduced.body, modes=reduced.modes, conditions=conditions, positions=places)
    return np.array([np.nanmax(hit.exit_speed), reduced.body.balance_point, reduced.body.moi_cm])


def outcome(table: dict[str, Any], true: np.ndarray) -> str:
    """Return what became of a file: refused, warned, harmless, or silent."""
    try:
        implement = implement_from_table(table, "slip")
        found = answers(implement)
    except SweetspotError:
        return "refused"
    if doubts(implement):
        return "warned"
    return "silent" if (np.abs(found / true - 1) > MATTERS).any() else "harmless"


def main(every: int) -> None:
    tables = implement_tables()
    true = {name: answers(implement_from_table(table, name)) for name, table in tables.items()}
    counts = dict.fromkeys(("refused", "warned", "harmless", "silent"), 0)
    for number, slip in enumerate(slips(tables)):
        if number % every:
            continue
        became = outcome(slip.table(tables), true[slip.name])
        counts[became] += 1
        if became == "silent":
            print(slip, flush=True)
    noticed = counts["refused"] + counts["warned"]
    share = counts["silent"] / max(1, counts["silent"] + noticed)
    print(f"{sum(counts.values())} slips: {counts}; {share:.1%} of what matters or was noticed is silent")


def _texts(value: Any, path: tuple[str | int, ...] = ()) -> Iterator[tuple[tuple[str | int, ...], str]]:
    if isinstance(value, str):
        yield path, value
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from _texts(inner, (*path, key))
    elif isinstance(value, list) and value:
        middle = len(value) // 2 if all(isinstance(row, list) for row in value) else None
        for index, inner in enumerate(value):
            if middle is None or index == middle:
                yield from _texts(inner, (*path, index))


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 1)

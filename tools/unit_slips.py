"""How many slips of units are noticed: every size in every file of the catalogue, ten times, a tenth, in for cm.

A slip is one number with its unit in a catalogue file multiplied by ten, divided by ten, or with inch and centimetre
exchanged. It is noticed when the file is refused or warned about by name. Only a slip that changes the answer matters:
the greatest exit speed of a standard hit, the balance point, or the moment of inertia, by more than 10 %.

The bounds that notice slips were set with the catalogue in view. `--held-out` tries files that nobody had in view:
those printed in the documentation, every file of the catalogue with all its sizes changed at random by up to 8 %, bats
drawn at random with weight, balance point and moment of inertia measured on them, in other units, and files that say
what they are like.

Run: .venv/bin/python tools/unit_slips.py [--held-out] [EVERY]   (EVERY: take each EVERY-th slip only)
"""

from __future__ import annotations

import copy
import os
import random
import re
import sys
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only get in each other's way

import numpy as np

from sweetspot.analysis.position_scan import scan
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.implements import implement_tables
from sweetspot.catalog.records import unwrapped
from sweetspot.catalog.standard_hit import standard_conditions
from sweetspot.catalog.usual_bodies import doubts
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.equipment.implement import Implement
from sweetspot.errors import SweetspotError
from sweetspot.units import INCH, parse

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tools"))

from measured_bats import random_bat  # noqa: E402

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


def held_out_tables(seed: int = 1) -> dict[str, dict[str, Any]]:
    """Return files that the bounds were not set with, by a name."""
    chance = random.Random(seed)
    tables: dict[str, dict[str, Any]] = {}
    for page in sorted((ROOT / "docs").rglob("*.md")):
        for number, text in enumerate(re.findall(r"^```toml\n(.*?)^```", page.read_text("utf-8"), re.S | re.M)):
            tables[f"{page.stem} {number}"] = tomllib.loads(text)
    for name, table in implement_tables().items():
        tables[f"{name} varied"] = _varied(unwrapped(table), chance)
    drawn = np.random.default_rng(seed)
    for number in range(12):
        tables[f"measured {number}"] = _measured_table(drawn, *UNITS[number % len(UNITS)])
    tables["like r161"] = {"like": "r161-ash", "mass": "30.2 oz", "balance_point": "55.4 cm"}
    tables["like racket"] = {"like": "tennis-racket", "mass": "310 g", "balance_point": "33.1 cm"}
    tables["like youth"] = {"like": "youth-30", "length": "29 in", "mass": "560 g"}
    return {name: table for name, table in tables.items() if _is_whole(table, name)}


UNITS = (("in", "oz", "oz*in^2"), ("cm", "g", "kg*m^2"), ("mm", "kg", "kg*cm^2"))


def _measured_table(drawn: np.random.Generator, length: str, mass: str, moi: str) -> dict[str, Any]:
    """Return the file of a bat drawn at random, measured with 0.1 in and 1 % noise."""
    bat = random_bat(drawn)
    body = rigid_body(beam_model(bat))
    metre, kilogram, inertia = (1 / parse(f"1 {unit}", kind) for unit, kind in
                                ((length, "length"), (mass, "mass"), (moi, "moi")))  # fmt: skip
    balance = body.balance_point + drawn.normal(0, 0.1) * INCH
    return {
        "name": "measured",
        "length": f"{bat.length * metre:.4g} {length}", "mass": f"{body.mass * kilogram:.4g} {mass}",
        "balance_point": f"{balance * metre:.4g} {length}", "material": bat.material.name,
        "moi": f"{body.moi(bat.moi_axis) * (1 + drawn.normal(0, 0.01)) * inertia:.4g} {moi}",
        "profile": [[f"{at * metre:.5g} {length}", f"{across * metre:.4g} {length}"] for at, across in bat.profile],
    }  # fmt: skip


def _varied(table: Any, chance: random.Random) -> Any:
    """Return a table with every size changed a little, but lengths that must fit together alike."""
    together = chance.uniform(0.95, 1.05)

    def changed(value: Any, key: str) -> Any:
        if isinstance(value, dict):
            return {name: changed(inner, name) for name, inner in value.items()}
        if isinstance(value, list):
            return [changed(inner, key) for inner in value]
        found = NUMBER.match(value) if isinstance(value, str) and key not in ("name", "note", "material") else None
        if found is None:
            return value
        size = together if found[3] in EXCHANGED or found[3] == "m" else chance.uniform(0.92, 1.08)
        return f"{float(found[1]) * size:.5g} {found[3]}"

    return changed(table, "")


def _is_whole(table: dict[str, Any], name: str) -> bool:
    """Return whether a file describes something usual as it is; parts of files are printed too."""
    try:
        return not doubts(implement_from_table(table, name))
    except SweetspotError:
        return False


def main(every: int, *, held_out: bool) -> None:
    tables = held_out_tables() if held_out else implement_tables()
    print(f"{len(tables)} files", flush=True)
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
    words = [word for word in sys.argv[1:] if word != "--held-out"]
    main(int(words[0]) if words else 1, held_out="--held-out" in sys.argv)

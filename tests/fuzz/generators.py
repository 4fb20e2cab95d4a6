"""Inputs nobody would write, near enough to those people do: files, quantities and tables with one thing or more wrong.

Every input follows from its kind and its number alone, so a fault is named by the two. A kind is a generator of inputs,
which are texts, and a target that takes one: it may answer, or refuse with `InputError`, and nothing else.
"""

from __future__ import annotations

import gzip
import json
import math
import os
import random
import tempfile
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from sweetspot import catalog
from sweetspot.analysis.certification.shot_statistics import measure
from sweetspot.analysis.certification.shots import read_shots
from sweetspot.catalog.bats import bat_tables, other_tables
from sweetspot.catalog.files.bat import table_of_text
from sweetspot.catalog.files.read import implement_from_table
from sweetspot.catalog.records import TomlTable, unwrapped
from sweetspot.dynamics.beam import beam_model
from sweetspot.dynamics.reduction import bending_modes
from sweetspot.dynamics.rigid import rigid_body
from sweetspot.plausibility import parse
from sweetspot.player.swings import read_swings
from sweetspot.units import SI

NUMBERS = ("0", "-1", "1e-320", "1e308", "1e400", "nan", "inf", "1e-9", "0.5", "1e6", "33 1/2", "2 ft 9.5", "9" * 400)
STRANGERS: tuple[Any, ...] = (None, True, -1, 0, 1e308, 10**400, [], {}, ["racket"], "x" * 3000, "", "\0")
"""Values of kinds that do not belong there."""
COLUMNS = ("bat_speed_mph", "exit_speed_mph", "pitch_speed_mph", "launch_angle_deg", "bat", "position_in_from_tip")
LINES = (
    'name = "bat"', 'length = "33 in"', 'mass = "31 oz"', 'material = "white ash"',
    'profile = [["0 in", "1 in"], ["33 in", "2.5 in"]]', "[cup]", 'diameter = "1 in"', 'depth = "1 in"',
)  # fmt: skip
UNITS = ("in", "mm", "m", "oz", "g", "kg", "mph", "deg", "oz*in^2", "kg*m^2", "Hz", "GPa", "kg/m^3", "%", "furlong", "")
MODES_EVERY = 1
"""Of so many tables one rings; its modes cost more than all else."""
SIGNS = "0123456789.eE+-*/^() \t\n\0\"'=[]{},;:#_~@é棒½²\u202e\x1b"


@dataclass(frozen=True)
class Fuzz:
    """A kind of input: how one is made of random numbers, and what takes it."""

    make: Callable[[random.Random], str]
    take: Callable[[str], None]


def quantity(chance: random.Random) -> str:
    text = chance.choice([chance.choice(NUMBERS), repr(chance.uniform(-100, 100)), "".join(chance.choices(SIGNS, k=5))])
    return text + chance.choice(["", " "]) + chance.choice(UNITS)


def take_quantity(text: str) -> None:
    kinds, first = list(SI), zlib.crc32(text.encode("utf-8", "surrogatepass"))
    for kind in (kinds * 2)[first % len(kinds) :][:4]:
        _quietly(lambda kind=kind: _finite(parse(text, kind)))  # type: ignore[misc]


def bat(chance: random.Random) -> str:
    return json.dumps(_damaged(chance, chance.choice(list(bat_tables().values()))))


def implement(chance: random.Random) -> str:
    return json.dumps(_damaged(chance, chance.choice(list(other_tables().values()))))


def take_table(text: str) -> None:
    """Describe it, reduce it, and let it ring."""
    described = implement_from_table(json.loads(text), "fuzz")
    beam = beam_model(described)
    body = rigid_body(beam)
    _finite(body.mass, body.balance_point, body.moi_cm, body.roll_moi)
    assert body.mass > 0 and body.moi_cm > 0
    if zlib.crc32(text.encode("utf-8", "surrogatepass")) % MODES_EVERY == 0:
        _finite(*bending_modes(beam, count=3).frequency)


def toml(chance: random.Random) -> str:
    """A bat file with letters changed, doubled, lost or moved."""
    return _mangled(chance, "\n".join(LINES))


def take_toml(text: str) -> None:
    implement_from_table(table_of_text(text, "fuzz"), "fuzz")


def swings(chance: random.Random) -> str:
    return _table(chance, chance.sample(COLUMNS, 4))


def take_swings(text: str) -> None:
    for ending in (".csv", ".csv.gz"):
        _quietly(lambda ending=ending: read_swings(_file(text, ending), length=0.84, pitch_speed=36.0))  # type: ignore[misc]


def shots(chance: random.Random) -> str:
    optional = chance.sample(["bat_speed_mph", "ball_cor", "ball_stiffness_n_m", "ball_mass_oz"], chance.randint(0, 3))
    return _table(chance, ["ball_in_mph", "ball_out_mph", "position_in_from_tip", *optional])


def take_shots(text: str) -> None:
    measured_bat = catalog.bat("r161-ash")
    found = measure(
        read_shots(_file(text, ".csv"), length=measured_bat.length).shots,
        bat=measured_bat,
        body=rigid_body(beam_model(measured_bat)),
        ball=catalog.ball(),
    )
    _finite(found.bbcor.mean, found.bbcor.standard_error, found.efficiency.mean, found.best_position)
    assert -1 < found.bbcor.mean < 1


KINDS = {
    "quantity": Fuzz(quantity, take_quantity),
    "bat": Fuzz(bat, take_table),
    "implement": Fuzz(implement, take_table),
    "toml": Fuzz(toml, take_toml),
    "swings": Fuzz(swings, take_swings),
    "shots": Fuzz(shots, take_shots),
}


def text_of(kind: str, number: int) -> str:
    """Return the input of a kind with a number."""
    return KINDS[kind].make(random.Random(f"{kind} {number}"))


def _quietly(call: Callable[[], object]) -> None:
    from contextlib import suppress

    from sweetspot.errors import InputError

    with suppress(InputError):
        call()


def _finite(*values: float) -> None:
    assert all(math.isfinite(value) for value in np.asarray(values, dtype=float)), f"not finite: {values}"


def _file(text: str, ending: str) -> Path:
    """Write a text where the next one of this process replaces it; packed, a letter in a hundred files is damaged."""
    path = Path(tempfile.gettempdir()) / f"sweetspot-fuzz-{os.getpid()}{ending}"
    content = text.encode("utf-8", "surrogateescape")
    if ending.endswith(".gz"):
        packed = bytearray(gzip.compress(content))
        at = len(text) * 7919 % len(packed)
        packed[at] ^= len(text) % 3 and 0x5A
        content = bytes(packed)
    path.write_bytes(content)
    return path


def _places(table: Any) -> Iterator[tuple[Any, Any]]:
    """Yield every (container, key) in nested tables and lists."""
    for key in list(table) if isinstance(table, dict) else range(len(table)):
        yield table, key
        if isinstance(table[key], (dict, list)):
            yield from _places(table[key])


def _damaged(chance: random.Random, table: TomlTable) -> Any:
    """Return a table of the catalogue with one to three values scaled, changed, lost or of another kind."""
    copy = json.loads(json.dumps(unwrapped(table)))
    for _ in range(chance.randint(1, 3)):
        container, key = chance.choice(list(_places(copy)))
        value, way = container[key], chance.random()
        if isinstance(value, str) and value[:1].isdigit() and way < 0.8:
            number, _, unit = value.partition(" ")
            container[key] = f"{_number(number) * chance.choice([0.1, 0.5, 0.9, 1.1, 1.5, 2.54, 10])!r} {unit}"
        elif way < 0.84:
            container[key] = quantity(chance)
        elif way < 0.88:
            container[key] = chance.choice(STRANGERS)
        elif way < 0.92 and isinstance(container, dict):
            del container[key]
        elif isinstance(container, list):
            container.insert(key, value)
    return copy


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return 1.0


def _mangled(chance: random.Random, text: str) -> str:
    letters = list(text)
    for _ in range(chance.randint(1, 6)):
        at = chance.randrange(len(letters))
        letters[at : at + chance.randint(0, 3)] = chance.choices(SIGNS, k=chance.randint(0, 3))
    return "".join(letters)


def _table(chance: random.Random, names: list[str]) -> str:
    """Return a file of rows with these columns, most of them near what laboratories and players write."""

    def cell(name: str) -> str:
        if chance.random() < 0.01:
            return quantity(chance)
        return f"{USUAL[name] * chance.choice([1.0, 1.0, 1.0, chance.uniform(0.8, 1.2), chance.uniform(0.1, 3)]):.4g}"

    rows = [[cell(name) for name in names] for _ in range(chance.randint(0, 12))]
    text = "\n".join(",".join(row + ["1"] * (chance.random() < 0.01)) for row in [names, *rows])
    return _mangled(chance, text) if chance.random() < 0.3 else text


USUAL = {
    "ball_in_mph": 136.0, "ball_out_mph": 30.0, "ball_cor": 0.5, "ball_stiffness_n_m": 1e6, "ball_mass_oz": 5.1,
    "bat_speed_mph": 70.0, "exit_speed_mph": 95.0, "pitch_speed_mph": 85.0, "launch_angle_deg": 15.0,
    "position_in_from_tip": 6.0, "bat": 1.0,
}  # fmt: skip

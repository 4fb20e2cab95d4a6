"""The outline that a lathe's program (G-code) leaves: the least radius that any of its cuts reaches at each place."""

from __future__ import annotations

import itertools
import math
import re
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from sweetspot.calibration.outline.measured_outline import BARREL, HANDLE, MeasuredOutline
from sweetspot.calibration.outline.meridian import outline_of_pieces
from sweetspot.errors import InputError
from sweetspot.numerics.text_files import read_text
from sweetspot.units import INCH

LARGEST, MOST_MOVES = 20_000_000, 200_000
"""Bytes of a program, and its moves."""
COMMENT = re.compile(r"\([^)]*\)|;.*|^\s*%.*|^\s*/.*")
WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
REACH = 1e6
"""Units that the tool goes to at most."""
ARC = 64
"""Straight pieces of an arc."""


@dataclass(frozen=True)
class _State:
    """Where the tool is and how words count: ``across`` is 1 where X is a radius, 1/2 where it is a diameter."""

    z: float = math.nan
    x: float = math.nan
    move: int = 0
    unit: float | None = None
    across: float | None = None
    relative: bool = False


def program_outline(path: Path, *, length: float | None = None) -> MeasuredOutline:
    """Return the outline that a program with Z along and X across the axis leaves of the wood.

    Rapid moves cut nothing; of roughing and finishing passes the deepest counts. X is a diameter after G7 and a radius
    after G8; without either it is whichever makes a bat. G20 and G21 say inch and mm; without them the length does.
    """
    text = read_text(path, most=LARGEST, advice="give the program of one bat")
    state = _State()
    pieces: list[list[tuple[float, float]]] = []
    for number, line in enumerate(text.upper().splitlines(), start=1):
        try:
            state, cut = _block(WORD.findall(COMMENT.sub("", line)), state)
        except ValueError as error:
            raise InputError(f"{path}, line {number}: {error}") from None
        pieces += [list(pair) for pair in itertools.pairwise(cut)]
        if len(pieces) > MOST_MOVES:
            raise InputError(f"{path} has more than {MOST_MOVES} moves; give the program of one bat")
    cuts = np.array([piece for piece in pieces if np.isfinite(piece).all()], float).reshape(-1, 2, 2)
    if not len(cuts):
        raise InputError(f"{path} has no cut, G1, G2 or G3 with Z and X; give the program of a lathe")
    cuts[:, :, 1] = np.abs(cuts[:, :, 1])
    read = {}
    for name, across in (("diameters", 0.5), ("radii", 1.0)):
        if state.across in (None, across):
            scaled = cuts * [1.0, across]
            read[name] = outline_of_pieces(scaled, str(path), unit=state.unit, length=length, pick="innermost")
    if len(read) == 1:
        return next(iter(read.values()))
    name = "radii" if _like_a_bat(read["radii"]) and not _like_a_bat(read["diameters"]) else "diameters"
    note = f"The program does not say whether X is a diameter (G7) or a radius (G8): taken as {name}."
    return replace(read[name], notes=(*read[name].notes, note))


def _block(words: list[tuple[str, str]], state: _State) -> tuple[_State, list[tuple[float, float]]]:
    """Return the state after a block, and the points (z, x) of its cut with its beginning; none: it cuts nothing."""
    values = {letter: float(number) for letter, number in words if letter != "G"}
    machine = False
    for letter, number in words:
        code = float(number) if letter == "G" else -1.0
        if code in (0, 1, 2, 3):
            state = replace(state, move=int(code))
        elif code in (20, 21):
            state = replace(state, unit=INCH if code == 20 else 1e-3)
        elif code in (7, 8):
            state = replace(state, across=0.5 if code == 7 else 1.0)
        elif code in (90, 91):
            state = replace(state, relative=code == 91)
        elif code in (28, 30, 50, 53, 92, 4, 10):
            machine = True  # places of the machine, a dwell, an offset
    if machine or not values.keys() & set("ZXWU"):
        return state, []
    z = (
        values.get("Z", 0.0 if state.relative else state.z)
        + (state.z if state.relative else 0.0)
        + values.get("W", 0.0)
    )
    x = (
        values.get("X", 0.0 if state.relative else state.x)
        + (state.x if state.relative else 0.0)
        + values.get("U", 0.0)
    )
    if max(np.nan_to_num([abs(z), abs(x)])) > REACH:
        raise ValueError(f"the tool goes to Z{z:g} X{x:g}")
    after = replace(state, z=z, x=x)
    if state.move == 0:
        return after, []
    start, end = (state.z, state.x), (z, x)
    return after, [start, end] if state.move == 1 else _arc(start, end, values, state)


def _arc(
    start: tuple[float, float], end: tuple[float, float], values: dict[str, float], state: _State
) -> list[tuple[float, float]]:
    """Return points along an arc in (z, x); its centre is given by I, K or R, always radii."""
    across = state.across or 0.5
    (z0, r0), (z1, r1) = ((z, across * x) for z, x in (start, end))
    turn = 1.0 if state.move == 3 else -1.0  # seen with Z to the right and X upward
    if "R" in values:
        chord, radius = math.hypot(z1 - z0, r1 - r0), values["R"]
        if not 0 < chord <= 2 * abs(radius) * (1 + 1e-6):
            raise ValueError(f"no arc of radius {radius:g} reaches from one end to the other")
        rise = turn * math.copysign(math.sqrt(max(radius**2 - chord**2 / 4, 0.0)), radius)
        zc, rc = (z0 + z1) / 2 - rise * (r1 - r0) / chord, (r0 + r1) / 2 + rise * (z1 - z0) / chord
    else:
        zc, rc = z0 + values.get("K", 0.0), r0 + values.get("I", 0.0)
    first, last = math.atan2(r0 - rc, z0 - zc), math.atan2(r1 - rc, z1 - zc)
    if not math.isfinite(first + last):
        return [start, end]
    sweep = turn * ((turn * (last - first)) % (2 * math.pi))
    angle = first + sweep * np.linspace(0, 1, ARC + 1)[1:-1]
    radius = math.hypot(z0 - zc, r0 - rc)
    between = zip(
        (zc + radius * np.cos(angle)).tolist(), ((rc + radius * np.sin(angle)) / across).tolist(), strict=True
    )
    return [start, *between, end]


def _like_a_bat(outline: MeasuredOutline) -> bool:
    place, size = np.array(outline.profile).T
    middle = (place > 0.06 * place[-1]) & (place < 0.95 * place[-1])
    thin, thick = float(size[middle].min()), float(size[middle].max())
    return HANDLE[0] <= thin <= HANDLE[1] and BARREL[0] <= thick <= BARREL[1]

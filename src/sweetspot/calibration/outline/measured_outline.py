"""An outline as it was measured, closed at both ends, knob end first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sweetspot.catalog.files.turned import TIP
from sweetspot.equipment.shell import MOST_STATIONS, Stations
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.units import INCH

NEAR_END = 1.6 * INCH
"""m from an end within which the nearest station must lie."""
HANDLE, BARREL, KNOB = (0.015, 0.031), (0.040, 0.071), 1.25
"""m, how thick the handle and the barrel of bats are, and how many times as thick as the handle a knob is at least: the
catalogue's bats, with room (but for one with an uncommon handle)."""
HANDLE_FROM, HANDLE_TO, KNOB_TO = 0.06, 0.6, 0.05
"""Of the length from the knob end: where the handle is thinnest, and as far as a knob reaches."""
TOLERANCE = 1e-5
"""m of diameter, by which fewer stations may differ from what was drawn."""
USUAL_LENGTH = (0.3, 1.3)
"""m; a drawing without units whose size is not this long has no scale."""


@dataclass(frozen=True)
class MeasuredOutline:
    """An outline as it was measured.

    ``profile``: (position, diameter) stations from 0 to the bat's length, m. ``assumed``: positions in m of the
    stations that no one measured, at the ends.
    """

    profile: Stations
    assumed: tuple[float, ...] = ()
    notes: tuple[str, ...] = ()


def closed(stations: Sequence[tuple[float, float]], length: float, what: str) -> MeasuredOutline:
    """Return the outline with a station at either end; the tip is rounded as turned bats are."""
    stations = list(stations)
    if stations[0][0] < 0 or stations[-1][0] > length * (1 + 1e-6):
        raise InputError(f"{what} has stations off the bat, which is {length:.4g} m long; check --length and the units")
    if stations[0][0] > NEAR_END or length - stations[-1][0] > NEAR_END:
        raise InputError(
            f"{what} reaches from {stations[0][0]:.4g} m to {stations[-1][0]:.4g} m of a bat of {length:.4g} m; "
            "measure to within an inch and a half of both ends, and check --length"
        )
    assumed = []
    if stations[0][0] > 0:
        stations = [(0.0, stations[0][1]), *stations]
        assumed.append(0.0)
    last, thick = stations[-1]
    if length - last > 1e-6 * length:
        round_end = [
            (length - inches * INCH, part * thick) for inches, part in TIP if length - inches * INCH > last + 1e-6
        ]
        stations = [*stations, *round_end]
        assumed += [place for place, _ in round_end]
    return MeasuredOutline(tuple(stations), tuple(assumed))


def knob_first(place: Array, diameter: Array) -> tuple[Array, Array]:
    """Return stations so that the thicker half, the barrel, comes last."""
    middle = (place[0] + place[-1]) / 2
    near, far = diameter[place < middle].mean(), diameter[place > middle].mean()
    return (place, diameter) if near <= far else ((place[0] + place[-1] - place)[::-1], diameter[::-1])


def simplified(place: Array, diameter: Array, tolerance: float) -> Stations:
    """Return the fewest stations from which no diameter is farther off than ``tolerance`` (Douglas-Peucker)."""
    chosen = np.zeros(len(place), bool)
    chosen[[0, -1]] = True
    open_pieces = [(0, len(place) - 1)]
    while open_pieces:
        first, last = open_pieces.pop()
        inside = np.arange(first + 1, last)
        if not len(inside):
            continue
        straight = np.interp(place[inside], place[[first, last]], diameter[[first, last]])
        off = np.abs(diameter[inside] - straight)
        farthest = int(np.argmax(off))
        if off[farthest] > tolerance:
            middle = int(inside[farthest])
            chosen[middle] = True
            open_pieces += [(first, middle), (middle, last)]
    return tuple(zip(place[chosen].tolist(), diameter[chosen].tolist(), strict=True))


def fewest_stations(place: Array, diameter: Array, tolerance: float = TOLERANCE) -> Stations:
    """Return `simplified` stations, no more than a bat file may have: where these do not do, a little farther off."""
    while len(profile := simplified(place, diameter, tolerance)) > MOST_STATIONS:
        tolerance *= 1.25
    return profile


def unlike_bats(profile: Stations) -> tuple[str, ...]:
    """Return in words the features of an outline that no bat has; none for a bat's.

    >>> unlike_bats(((0.0, 0.033), (0.84, 0.064)))
    ('Unlike a bat: handle 35 mm thick (bats have 15 to 31 mm); no knob. It was taken as round, turned and whole.',)
    """
    position, diameter = np.array(profile).T
    place = np.linspace(0, 1, 501)
    width = np.interp(place * position[-1], position, diameter)
    handle = float(width[(place >= HANDLE_FROM) & (place <= HANDLE_TO)].min())
    knob, barrel = float(width[place <= KNOB_TO].max()), float(width.max())
    faults = [
        f"{what} {1e3 * size:.0f} mm thick (bats have {1e3 * low:.0f} to {1e3 * high:.0f} mm)"
        for what, size, (low, high) in (("handle", handle, HANDLE), ("barrel", barrel, BARREL))
        if not low <= size <= high
    ]
    faults += ["no knob"] * (knob < KNOB * handle)
    return (f"Unlike a bat: {'; '.join(faults)}. It was taken as round, turned and whole.",) if faults else ()

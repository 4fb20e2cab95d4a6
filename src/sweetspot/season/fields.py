"""Where a ball was hit: the park of a club in a season, its air, and the thirty parks of that season."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from dataclasses import fields as dataclass_fields
from functools import cache

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.catalog.aerodynamic_laws import aerodynamics_in
from sweetspot.catalog.ballparks import park, parks_of_season
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air, Airs
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.numerics.arrays import Array
from sweetspot.season.rows import coded
from sweetspot.units import DEGREE

ELSEWHERE = ("S", "E", "A")
"""Kinds of games that are not played in the home club's own park: spring training, exhibition, All-Star Game."""
ASIDE = 5 * DEGREE
"""rad by which a ball may pass a fence beside where it comes down."""


@dataclass(frozen=True)
class Fields:
    """The parks of many balls.

    Parameters
    ----------
    parks : those that occur.
    index : which of them each ball was hit in, -1 where not known, shape (n,).
    unknown : clubs whose park is not known, with how many balls.
    """

    parks: tuple[Park, ...]
    index: NDArray[np.int64]
    unknown: dict[str, int]

    def airs(self, air: Air, rows: pl.DataFrame | None = None) -> Airs:
        """Return the air of every ball: at the park's elevation, and of the weather that its row gives.

        Parameters
        ----------
        air : stands in for what is missing; its elevation where neither the park's nor the row's is known.
        rows : that went through `rows_of`; columns named as the fields of `Airs` count. None: no weather is given.
        """
        given = {}
        for one in dataclass_fields(Airs):
            values = np.full(len(self.index), np.nan)
            if rows is not None and one.name in rows.columns:
                values = rows[one.name].cast(pl.Float64).fill_null(np.nan).to_numpy()
            given[one.name] = np.where(np.isnan(values), getattr(air, one.name), values)
        parks = np.array([*(one.elevation for one in self.parks), 0.0])[self.index]
        return Airs(**given | {"elevation": np.where(self.index < 0, given["elevation"], parks)})

    def laws(self, law: Aerodynamics, part: slice = slice(None)) -> Iterator[tuple[Aerodynamics, NDArray[np.intp]]]:
        """Yield every law that balls fly by, and which of a part fly by it.

        Parameters
        ----------
        law : in the open; under a roof that never opens `aerodynamics_in` holds.
        """
        each = [*(aerodynamics_in(park, law) for park in self.parks), law]
        number = np.array([each.index(one) for one in each])[self.index[part]]
        for one in np.unique(number):
            yield each[one], (part.start or 0) + np.flatnonzero(number == one)


def fields_of(clubs: pl.Series | Sequence[str | None], seasons: NDArray[np.int64]) -> Fields:
    """Return where balls were hit.

    Parameters
    ----------
    clubs : the home club's letters or name, None where not known.
    seasons : year, 0 where not known: the park of today.
    """
    number, known = coded(pl.Series("club", clubs, dtype=pl.String))
    names = [*known, None]
    club = number.fill_null(len(known)).to_numpy()
    fields: dict[Park, int] = {}
    unknown: dict[str, int] = {}
    places = np.full(len(seasons), -1, np.int64)
    for year in pl.Series(seasons).unique().sort():
        mine = seasons == year
        here = np.full(len(names), -1, np.int64)
        for one in np.flatnonzero(np.bincount(club[mine], minlength=len(names))).tolist():
            found = home_park(names[one], year or None) if names[one] else None
            if found is None:
                word = names[one] or "no home team"
                unknown[word] = unknown.get(word, 0) + int((club[mine] == one).sum())
            else:
                here[one] = fields.setdefault(found, len(fields))
        np.copyto(places, here[club], where=mine)
    return Fields(tuple(fields), places, unknown)


def nearest_fences(parks: tuple[Park, ...], bearing: Array) -> Array:
    """Return how far the nearest fence of any park is within `ASIDE` of where balls come down, m, shape (n,).

    Parameters
    ----------
    bearing : rad from centre field, shape (n,); NaN: the nearest fence of all.
    """
    every, least = _nearest(parks), np.isnan(bearing)
    at = np.clip(np.rint((np.where(least, 0.0, bearing) + FOUL_LINE) / DEGREE), 0, len(every) - 1).astype(np.int64)
    return np.where(least, every.min(), every[at])


@cache
def _nearest(parks: tuple[Park, ...]) -> Array:
    """Return the nearest fences for every degree from one foul line to the other."""
    ways = np.arange(-FOUL_LINE, FOUL_LINE + DEGREE / 2, DEGREE)
    aside = np.linspace(-ASIDE, ASIDE, 41)
    return np.asarray(np.min([fence_at(park, np.clip(ways[:, None] + aside, -FOUL_LINE, FOUL_LINE))[0].min(axis=1)
                              for park in parks], axis=0))  # fmt: skip


@cache
def home_park(club: str, season: int | None) -> Park | None:
    """Return the park of a club in a season, None for an unknown club."""
    try:
        return park(club, season)
    except InputError:
        return None


@cache
def thirty_parks(season: int) -> tuple[Park, ...]:
    """Return the parks of all clubs in a season; 0: those of today."""
    return parks_of_season(season or None)

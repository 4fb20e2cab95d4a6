"""Balls in play as arrays in SI, from rows of a table, and where each was hit: its park, air and season."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from dataclasses import fields as dataclass_fields
from functools import cache

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.catalog.aerodynamic_laws import aerodynamics, aerodynamics_in
from sweetspot.catalog.ballparks import park, parks_of_season
from sweetspot.catalog.balls import ball
from sweetspot.errors import InputError
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air, Airs
from sweetspot.flight.bearing import bearing_of_place
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.flight.pitch.home_plate import PLATE, PLATE_OVER_RELEASE, REFERENCE
from sweetspot.flight.pitch.spin import spin_from_movement
from sweetspot.flight.pitch.tracked import NineParameters, nine_parameters
from sweetspot.numerics.arrays import Array, vectors
from sweetspot.seasons.rows import coded
from sweetspot.units import DEGREE, INCH

ELSEWHERE = ("S", "E", "A")
"""Kinds of games that are not played in the home club's own park: spring training, exhibition, All-Star Game."""
ASIDE = 5 * DEGREE
"""rad by which a ball may pass a fence beside where it comes down."""


@dataclass(frozen=True)
class Fields:
    """The parks of many balls.

    ``index``: which of them each ball was hit in, -1 where not known, shape (n,).
    """

    parks: tuple[Park, ...]
    index: NDArray[np.int64]

    def airs(self, air: Air, rows: pl.DataFrame | None = None) -> Airs:
        """Return the air of every ball: at the park's elevation, and of the weather that its row gives.

        ``air``: stands in for what is missing; its elevation where neither the park's nor the row's is known. ``rows``:
        that went through `rows_of`; columns named as the fields of `Airs` count. None: no weather is given.
        """
        given = {}
        for field in dataclass_fields(Airs):
            values = np.full(len(self.index), np.nan)
            if rows is not None and field.name in rows.columns:
                values = rows[field.name].cast(pl.Float64).fill_null(np.nan).to_numpy()
            given[field.name] = np.where(np.isnan(values), getattr(air, field.name), values)
        parks = np.array([*(park.elevation for park in self.parks), 0.0])[self.index]
        return Airs(**given | {"elevation": np.where(self.index < 0, given["elevation"], parks)})

    def laws(self, law: Aerodynamics, part: slice = slice(None)) -> Iterator[tuple[Aerodynamics, NDArray[np.intp]]]:
        """Yield every law that balls fly by, and which of a part fly by it.

        ``law``: in the open; under a roof that never opens `aerodynamics_in` holds.
        """
        each = [*(aerodynamics_in(park, law) for park in self.parks), law]
        number = np.array([each.index(flown_by) for flown_by in each])[self.index[part]]
        for index in np.unique(number):
            yield each[index], (part.start or 0) + np.flatnonzero(number == index)


def fields_of(
    clubs: pl.Series | Sequence[str | None], seasons: NDArray[np.int64], *, otherwise: Park | None = None
) -> Fields:
    """Return the fields on which balls were hit.

    ``clubs``: the home club's letters or name, or the park's name, None where not known. ``seasons``: year, 0 where not
    known: the park of today. ``otherwise``: where balls were hit whose park is not known.
    """
    number, spelled = coded(pl.Series("club", clubs, dtype=pl.String))
    names = [*spelled, None]
    club = number.fill_null(len(spelled)).to_numpy()
    fields: dict[Park, int] = {}
    places = np.full(len(seasons), -1, np.int64)
    for year in pl.Series(seasons).unique().sort():
        mine = seasons == year
        here = np.full(len(names), -1, np.int64)
        for place in np.flatnonzero(np.bincount(club[mine], minlength=len(names))).tolist():
            found = home_park(names[place], year or None) if names[place] else None
            if found is not None:
                here[place] = fields.setdefault(found, len(fields))
        np.copyto(places, here[club], where=mine)
    if otherwise is not None:
        places[places < 0] = fields.setdefault(otherwise, len(fields))
    return Fields(tuple(fields), places)


def nearest_fences(parks: tuple[Park, ...], bearing: Array) -> Array:
    """Return the distance of the nearest fence of any park within `ASIDE` of each landing direction, m, shape (n,).

    ``bearing``: rad from centre field, shape (n,); NaN: the nearest fence of all.
    """
    every, least = _nearest(parks), np.isnan(bearing)
    at = np.clip(np.rint((np.where(least, 0.0, bearing) + FOUL_LINE) / DEGREE), 0, len(every) - 1).astype(np.int64)
    return np.where(least, every.min(), every[at])


@cache
def _nearest(parks: tuple[Park, ...]) -> Array:
    """Return the nearest fences for every degree from one foul line to the other."""
    ways = np.arange(-FOUL_LINE, FOUL_LINE + DEGREE / 2, DEGREE)
    aside = np.linspace(-ASIDE, ASIDE, 41)
    return np.asarray(
        np.min(
            [fence_at(park, np.clip(ways[:, None] + aside, -FOUL_LINE, FOUL_LINE))[0].min(axis=1) for park in parks],
            axis=0,
        )
    )


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


MIDDLE_OF_PLATE = 8.5 * INCH
"""m in front of the plate's tip, where the league's plate_x and plate_z are given from 2026 on."""
FIRST_MIDDLE_SEASON = 2026
USUAL_DESCENT = np.radians(6.6)
"""Of a pitch at the plate, mean of 2507 [savant_2020day]."""


@dataclass(frozen=True)
class Balls:
    """Balls in play, every array of shape (n,), NaN where not measured.

    Parameters
    ----------
    exit_speed, launch_angle : m/s and rad as the ball leaves the bat.
    bearing, launch_direction : rad from centre field, positive to right: where it came down, and where it set out.
    distance : m, as tracked.
    bat_speed, attack_angle, attack_direction, tilt : of the swing; the direction negative to the pull side.
    axial_offset : m from the sweet spot along the bat towards the tip, where it was measured.
    plate_speed : m/s of the pitch over the front edge of the plate.
    descent, crossing : rad below the level, and rad to the right as the catcher sees it, of the pitch there.
    spin : rad/s, active spin that makes the pitch move as it does, shape (n, 3); 0 where not known.
    outside, plate_height : m of the pitch over the front edge of the plate, away from the batter and above the ground.
    left : whether the batter bats left-handed; False where not known.
    sided : whether the batter's side is known.
    season : year, 0 where not known.
    moved : whether the pitch was flown from the middle of the plate to its front edge.
    """

    exit_speed: Array
    launch_angle: Array
    bearing: Array
    launch_direction: Array
    distance: Array
    bat_speed: Array
    attack_angle: Array
    attack_direction: Array
    tilt: Array
    axial_offset: Array
    plate_speed: Array
    descent: Array
    crossing: Array
    spin: Array
    outside: Array
    plate_height: Array
    left: NDArray[np.bool_]
    sided: NDArray[np.bool_]
    season: NDArray[np.int64]
    moved: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.exit_speed)


def together(several: Sequence[Balls]) -> Balls:
    """Return the balls of several tables, one after another."""
    return Balls(**{name: np.concatenate([vars(balls)[name] for balls in several]) for name in vars(several[0])})


def taken(balls: Balls, rows: NDArray[np.int64] | NDArray[np.bool_] | slice) -> Balls:
    """Return some balls."""
    return Balls(**{name: values[rows] for name, values in vars(balls).items()})


AS_THEY_ARE = (
    *("exit_speed", "launch_angle", "launch_direction", "distance", "bat_speed", "attack_angle", "tilt"),
    "axial_offset",
)
"""Columns of rows that are taken as they are."""


def balls_of(rows: pl.DataFrame, *, pitches: bool = True) -> Balls:
    """Return the balls of rows from `rows_of`, those that are used or any others.

    ``pitches``: whether how they were pitched is wanted; flights do not ask.
    """
    numbers = [name for name, kind in rows.schema.items() if kind.is_numeric()]
    columns = rows.select(pl.col(numbers).cast(pl.Float64).fill_null(np.nan)).to_dict()

    def column(name: str) -> Array:
        return columns[name].to_numpy() if name in columns else np.full(len(rows), np.nan)

    left = rows["left"].fill_null(value=False).to_numpy()
    season = rows["season"].fill_null(0).cast(pl.Int64).to_numpy()
    bearing = column("bearing")
    if "map_x" in rows.columns and "map_y" in rows.columns:
        bearing = np.where(np.isnan(bearing), bearing_of_place(column("map_x"), column("map_y")), bearing)
    speed, descent, crossing, spin, side, height, moved = (_pitch if pitches else _no_pitch)(column, season)
    attack_direction = column("attack_direction")
    to_right = column("attack_to_right")
    attack_direction = np.where(np.isnan(attack_direction), np.where(left, -to_right, to_right), attack_direction)
    return Balls(
        **{name: column(name) for name in AS_THEY_ARE},
        **{"bearing": bearing, "attack_direction": attack_direction},
        **{"plate_speed": speed, "descent": descent, "crossing": crossing, "spin": spin, "plate_height": height},
        outside=np.where(left, -side, side),
        left=left,
        sided=rows["left"].is_not_null().to_numpy(),
        season=season,
        moved=moved,
    )


def _pitch(
    column: Callable[[str], Array], season: NDArray[np.int64]
) -> tuple[Array, Array, Array, Array, Array, Array, NDArray[np.bool_]]:
    """Return speed, descent, crossing, spin, side, height of pitches over the front edge, and which were flown there.

    The nine parameters are flown to an explicit distance; without them the speed is 0.92 of that at release, and the
    place stays where the table has it.
    """
    velocity = vectors(*(column(f"velocity_{axis}") for axis in "xyz"))
    push = vectors(*(column(f"acceleration_{axis}") for axis in "xyz"))
    side, height = column("plate_side"), column("plate_height")
    pitch = nine_parameters(velocity, acceleration=push, side=0.0, height=0.0)
    place, arriving = pitch.at(PLATE)
    tracked = np.asarray(np.isfinite(arriving).all(axis=-1))
    moved = tracked & (season >= FIRST_MIDDLE_SEASON)
    if moved.any():
        middle, _ = pitch.at(MIDDLE_OF_PLATE)
        side = np.where(moved, side + place[:, 0] - middle[:, 0], side)
        height = np.where(moved, height + place[:, 2] - middle[:, 2], height)
    speed = np.where(tracked, np.linalg.norm(arriving, axis=-1), column("plate_speed"))
    speed = np.where(np.isnan(speed), PLATE_OVER_RELEASE * column("release_speed"), speed)
    across, out, up = np.moveaxis(arriving, -1, 0)
    descent = np.where(tracked, np.arctan2(-up, -out), USUAL_DESCENT)
    crossing = np.where(tracked, np.arctan2(across, -out), 0.0)
    return speed, descent, crossing, _spin(pitch, tracked), side, height, moved


def _no_pitch(
    _: Callable[[str], Array], season: NDArray[np.int64]
) -> tuple[Array, Array, Array, Array, Array, Array, NDArray[np.bool_]]:
    none, count = np.full(len(season), np.nan), len(season)
    return none, none, none, np.zeros((count, 3)), none, none, np.zeros(count, np.bool_)


def _spin(pitch: NineParameters, tracked: NDArray[np.bool_]) -> Array:
    """Return the active spin of pitches, inferred from their movement half-way; 0 where that is not known."""
    if not tracked.any():
        return np.zeros_like(pitch.velocity)
    _, velocity = pitch.at((REFERENCE + PLATE) / 2)
    spin = spin_from_movement(
        velocity,
        acceleration=pitch.acceleration,
        ball=ball(),
        aerodynamics=aerodynamics("pitched-baseball"),
        density=np.full(len(tracked), Air().density),
    )
    return np.where(tracked[:, None] & np.isfinite(spin), spin, 0.0)

"""A made-up season with known truth: what players meant, where each ball was met, and what was measured of it.

Every hit is the collision kernel's own (not a bat's table), every flight the flight kernel's, and measurements carry
the stated errors; so whatever `season_table` says of such a season can be held against what was put in.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import polars as pl
from numpy.typing import NDArray

from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.catalog.ballparks import parks_of_season
from sweetspot.catalog.balls import ball as catalogue_ball
from sweetspot.collision.hit_in_space import Contact, Strikes, strikes
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.equipment.bat import Bat
from sweetspot.flight.air import USUAL_AIR, air_density
from sweetspot.flight.bearing import HOME_X, HOME_Y
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.flight.park import FOUL_LINE, Park, fence_at
from sweetspot.motion.ball_motion import USUAL_CONTACT, BallMotions, launch_angles
from sweetspot.motion.swing import SPEED_FROM_TIP
from sweetspot.motion.swing_path import Swings, path_axes, steep_enough
from sweetspot.numerics.arrays import Array
from sweetspot.seasons.swings import USUAL_ERRORS, Errors
from sweetspot.units import DEGREE, FOOT, INCH, MPH

CLUBS = ("BOS", "NYY", "COL", "TB", "SEA", "SF", "CHC", "HOU")
MAP_SCALE = 2.5
"""ft of the field per unit of Statcast's map, about."""
LOWEST = 40 * MPH
"""m/s; slower balls in play are left out (our choice)."""
BAT_SPEED, CHECKED_SWING = 71.5 * MPH, 45 * MPH
"""m/s, the mean of tracked swings [sure2026], and below which swings are left out (our choice)."""
FARTHEST = 13.9 * INCH
"""m from the tip, beyond which contacts are left out (our choice): there are the hands."""
PLATE_SPEED = 0.92
"""Of a pitch's speed at release, at the plate [statcast]."""
DESCENT = 6.6 * DEGREE
"""rad, of a pitch at the plate (assumed)."""


def normal_scatter(rng: np.random.Generator, count: int) -> Array:
    """Return normal numbers, of mean 0 and variance 1."""
    return rng.normal(0, 1, count)


@dataclass(frozen=True)
class MadeSeason:
    """The parameters of a made-up season.

    Parameters
    ----------
    players, balls : how many players, and balls in play of each before foul and missed ones are left out.
    place, place_spread : m from the tip, mean over players, and scatter of single contacts.
    per_outside : m of place for each m that a pitch is further outside.
    between : standard deviation of players' mean places, m, of their bat speeds, m/s, and of the logarithms of their
        scatter along the bat.
    wilder : what the logarithm of a player's scatter along the bat grows by for a standard deviation of bat speed.
    speed_spread : m/s, scatter of one player's bat speeds.
    offset_spread : m, scatter of the ball's centre above the bat's axis.
    offset_between : standard deviation over players of that scatter's logarithm.
    level_between : standard deviation over players of exit speeds beside the bat's, as a part: bats that differ.
    noise : m/s that exit speeds scatter beside measuring errors.
    drag : all flights' drag over the law's.
    scatter : gives how contacts scatter along the bat, in `place_spread`.
    """

    players: int = 40
    balls: int = 120
    place: float = 6.2 * INCH
    place_spread: float = 1.8 * INCH
    per_outside: float = -0.25
    between: tuple[float, float, float] = (0.4 * INCH, 2.5 * MPH, 0.25)
    wilder: float = 0.0
    speed_spread: float = 4 * MPH
    offset_spread: float = 0.9 * INCH
    offset_between: float = 0.0
    level_between: float = 0.0
    noise: float = 1.5 * MPH
    drag: float = 1.0
    errors: Errors = USUAL_ERRORS
    scatter: Callable[[np.random.Generator, int], Array] = normal_scatter


LIKE_THE_LEAGUE = MadeSeason(
    *(209, 80, 6.26 * INCH, 2.07 * INCH, -0.278),
    between=(0.48 * INCH, 2.74 * MPH, 0.02),
    wilder=0.2,
    speed_spread=4.57 * MPH,
    offset_spread=1.19 * INCH,
    offset_between=0.15,
    level_between=0.01,
    noise=1.65,
)
"""Swings that scatter as tracked ones do [sure2026], of players who differ by what makes exit speed, the league's rate
of squared-up balls and that of blasts as reliable at 34 balls as the league's; `studies/reliability.py` finds it."""


def made_season(bat: Bat, made: MadeSeason | None = None, *, year: int = 2024, seed: int = 1) -> pl.DataFrame:
    """Return a season of one bat in Statcast's names, with the truth in columns that begin with ``true_``.

    ``bat``: everybody's. ``made``: how; None: the usual.
    """
    how = made or MadeSeason()
    rng = np.random.default_rng(seed)
    who = np.repeat(np.arange(how.players), how.balls)
    count = len(who)
    own_place, own_speed = rng.normal(0, how.between[0], how.players), rng.normal(0, how.between[1], how.players)
    faster = own_speed / how.between[1] if how.between[1] else own_speed
    own_spread = how.place_spread * np.exp(rng.normal(0, how.between[2], how.players) + how.wilder * faster)
    left = rng.random(how.players)[who] < 0.4
    speed = BAT_SPEED + own_speed[who] + rng.normal(0, how.speed_spread, count)
    attack, direction = rng.normal(9, 7, count) * DEGREE, rng.normal(-2, 9, count) * DEGREE
    tilt = steep_enough(np.clip(rng.normal(32, 5, count), 15, 50) * DEGREE, attack)
    outside, height = rng.normal(0.02, 0.17, count), np.clip(rng.normal(0.75, 0.16, count), 0.3, 1.2)
    pitch = rng.normal(83, 4, count) * MPH
    place = how.place + own_place[who] + how.per_outside * outside + own_spread[who] * how.scatter(rng, count)
    own_offset, own_level = _more_of_players(how, seed)
    offset = 0.15 * INCH + rng.normal(0, how.offset_spread, count) * own_offset[who]
    in_play = (place > 0) & (place < FARTHEST) & (speed > CHECKED_SWING)
    struck = _struck(bat, speed, (attack, direction, tilt, left), pitch, np.clip(place, 0, FARTHEST), offset)
    launch, _, _ = launch_angles(struck.velocity, struck.spin)
    exit_speed = own_level[who] * struck.exit_speed + rng.normal(0, how.noise, count)
    velocity = struck.velocity * (exit_speed / struck.exit_speed)[:, None]
    in_play &= np.isfinite(exit_speed) & (exit_speed > LOWEST) & (np.abs(launch) < 70 * DEGREE)
    parks = parks_of_season(year)
    club = rng.integers(0, len(CLUBS), count)
    table = pl.DataFrame({
        "game_date": [f"{year}-{4 + day // 28:02d}-{1 + day % 28:02d}" for day in rng.integers(0, 168, count).tolist()],
        "game_pk": 700_000 + rng.integers(0, 800, count), "batter": 600_000 + who, "pitcher": 500_000 + who[::-1],
        "stand": np.where(left, "L", "R"), "home_team": np.array(CLUBS)[club], "pitch_type": "FF",
        "at_bat_number": np.arange(count), "pitch_number": 1, "description": "hit_into_play",
        "plate_x": np.where(left, -outside, outside) / FOOT, "plate_z": height / FOOT,
        "release_speed": pitch / PLATE_SPEED / MPH,
        "bat_speed": (speed + rng.normal(0, how.errors.bat_speed, count)) / MPH,
        "attack_angle": (attack + rng.normal(0, how.errors.attack_angle, count)) / DEGREE,
        "attack_direction": direction / DEGREE, "swing_path_tilt": tilt / DEGREE,
        "launch_speed": (exit_speed + rng.normal(0, how.errors.exit_speed, count)) / MPH,
        "launch_angle": (launch + rng.normal(0, how.errors.launch_angle, count)) / DEGREE,
        "true_from_tip_in": place / INCH, "true_offset_in": offset / INCH, "true_exit_speed_mph": exit_speed / MPH,
        "true_mean_from_tip_in": (how.place + own_place[who]) / INCH,
        "true_mean_bat_speed_mph": (BAT_SPEED + own_speed[who]) / MPH,
    })  # fmt: skip
    flown = _flown(velocity, struck.spin, how, np.array([_elevation(parks, name) for name in CLUBS])[club], rng)
    in_play &= flown[0] & (np.abs(flown[1]) < FOUL_LINE)
    bearing, carry = flown[1], flown[2]
    out = _out_of_park(parks, club, bearing, carry, flown[3])
    on_map = carry / FOOT / MAP_SCALE
    return table.with_columns(
        hc_x=pl.Series(HOME_X + on_map * np.sin(bearing)),
        hc_y=pl.Series(HOME_Y - on_map * np.cos(bearing)),
        hit_distance_sc=pl.Series(carry / FOOT),
        events=pl.Series(np.where(out, "home_run", "field_out")),
    ).filter(pl.Series(in_play))


def _more_of_players(how: MadeSeason, seed: int) -> tuple[Array, Array]:
    """Return the factors of each player's scatter of offsets over the usual, and of exit speeds over this bat's."""
    rng = np.random.default_rng([seed, how.players])
    offsets = rng.normal(0, 1, how.players)
    return np.exp(how.offset_between * offsets), 1 + how.level_between * rng.normal(0, 1, how.players)


def _struck(
    bat: Bat,
    speed: Array,
    path: tuple[Array, Array, Array, NDArray[np.bool_]],
    pitch: Array,
    place: Array,
    offset: Array,
) -> Strikes:
    """Return every hit by the collision kernel, of balls without spin that come down by `DESCENT`."""
    attack, direction, tilt, left = path
    arm = bat.length - bat.choke
    there = speed * (arm - place) / (arm - SPEED_FROM_TIP)
    coming = pitch[:, None] * np.array([0.0, -np.cos(DESCENT), -np.sin(DESCENT)])
    ball = catalogue_ball()
    return strikes(
        reduced_bat(bat, ball=ball),
        ball=ball,
        swings=Swings(there, path_axes(attack, direction, tilt=tilt, left=left), bat.choke),
        pitches=BallMotions(velocity=coming, spin=np.zeros(3)),
        contact=Contact(bat.length - place, offset),
    )


def _flown(
    velocity: Array, spin: Array, how: MadeSeason, elevation: Array, rng: np.random.Generator
) -> tuple[NDArray[np.bool_], Array, Array, Array]:
    """Return a mask of balls that landed, bearings, carries with the scatter of single flights, and descent angles."""
    law = aerodynamics()
    names = [name for name in type(law).model_fields if name.startswith("drag")]
    changed = law.replaced(**{name: getattr(law, name) * how.drag for name in names})
    air = USUAL_AIR
    density = air_density(air.temperature, pressure=air.pressure, humidity=air.humidity, elevation=elevation)
    flown = flights(
        BallMotions(velocity=np.nan_to_num(velocity), spin=np.nan_to_num(spin), position=USUAL_CONTACT),
        FlightConditions(ball=catalogue_ball(), aerodynamics=changed, air=density),
    )
    carry = flown.carry + rng.normal(0, 3.0, len(elevation)) * (flown.hang_time > 1)
    return flown.landed, flown.bearing, carry, flown.landing_angle


def _out_of_park(
    parks: Sequence[Park], club: NDArray[np.int64], bearing: Array, carry: Array, fall: Array
) -> NDArray[np.bool_]:
    """Return a mask of balls that clear the fence of their park, each of `CLUBS` by its number.

    ``fall``: angle of the fall below the level, rad; on straight lines at it a little too many go out, the way is bent.
    """
    out = np.zeros(len(club), bool)
    for number, name in enumerate(CLUBS):
        mine = club == number
        far, high = fence_at(_park(parks, name), np.clip(bearing[mine], -FOUL_LINE, FOUL_LINE))
        out[mine] = (carry[mine] - far) * np.tan(fall[mine]) > high
    return out


def _park(parks: Sequence[Park], club: str) -> Park:
    from sweetspot.catalog.ballparks import park

    team = park(club).team
    return next(candidate for candidate in parks if candidate.team == team)


def _elevation(parks: Sequence[Park], club: str) -> float:
    return _park(parks, club).elevation

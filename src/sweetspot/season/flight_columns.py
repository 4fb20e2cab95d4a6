"""What each ball's flight was: where it set out, how far it carries and how surely, and how likely it is a home run.

The tracked direction is where a ball came down; the direction in which it set out is solved for. How surely a carry is
known is told by `carry_scatter`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.carry_scatter import MORE_DRAG, SPIN_SCATTER, LaunchErrors, braked, carry_errors, usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL, home_run_chances
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.numerics.arrays import Array
from sweetspot.season.balls import Balls
from sweetspot.season.fields import Fields, thirty_parks
from sweetspot.season.launch_bend import first_directions
from sweetspot.season.swings import USUAL_ERRORS, Errors
from sweetspot.units import FOOT

ROUNDS, CLOSE = 5, 5e-4
"""Most flights of a ball in search of its direction, and rad by which it may come down beside: 0.2 ft at 400 ft."""
SHORTEST = 80.0
"""m; a ball that does not carry so far is no home run anywhere: no fence is nearer than 90."""
GLOVE = 5 * FOOT
"""m above the ground, where caught balls end."""


@dataclass(frozen=True)
class FlightSetting:
    """What all balls of a table share.

    Parameters
    ----------
    ball : of the catalogue.
    aerodynamics : its law.
    air : temperature, humidity and pressure at sea level; its elevation where the park is not known.
    parks : whether chances of home runs are wanted.
    errors : of the measurements.
    spin_scatter : standard deviation of backspin about the usual line, rad/s.
    threads : workers; None: one per core.
    """

    ball: Ball
    aerodynamics: Aerodynamics
    air: Air
    parks: bool = True
    errors: Errors = USUAL_ERRORS
    spin_scatter: float = SPIN_SCATTER
    threads: int | None = None


@dataclass(frozen=True)
class FlightColumns:
    """Answers for n balls; NaN where there is none.

    Parameters
    ----------
    launch_direction : rad from centre field, positive to right field.
    carry, carry_spread : m to the ground and its standard deviation.
    hang_time, apex_height, landing_angle : s, m, rad.
    carry_per_drag : m by which the carry grows with the logarithm of drag; negative.
    home_run_here : chance in the park it was hit in.
    home_runs : expected number over the thirty parks of the season.
    home_run_parks : in how many of them the mean ball is out.
    """

    launch_direction: Array
    carry: Array
    carry_spread: Array
    hang_time: Array
    apex_height: Array
    landing_angle: Array
    carry_per_drag: Array
    home_run_here: Array
    home_runs: Array
    home_run_parks: Array


def flown_balls(balls: Balls, fields: Fields, setting: FlightSetting, *, temperature: Array) -> FlightColumns:
    """Return the flights of balls.

    Balls with neither a bearing nor a launch direction fly as if to centre field, and have no chances.

    Parameters
    ----------
    fields : where they were hit.
    temperature : degC of every ball, NaN: the setting's.
    """
    density = fields.density(setting.air, temperature)
    solved, flown, known = _launched(balls, density, setting)
    away = flown.carry > SHORTEST
    per_drag = np.full(len(balls), np.nan)
    flying = flown.landed & (balls.launch_angle > 0)
    if flying.any():
        again = _flown(balls, solved, density, setting, flying, braked(setting.aerodynamics))
        per_drag[flying] = (again.carry - flown.carry[flying]) / np.log1p(MORE_DRAG)
    per_drag = np.where(flown.landed & ~flying, 0.0, per_drag)
    shift, spread = np.array([*(USUAL.of(park) for park in fields.parks), (0.0, USUAL.open)]).T[:, fields.index]
    errors = LaunchErrors(setting.errors.exit_speed, setting.errors.launch_angle)
    doubt = carry_errors(
        setting.ball, setting.aerodynamics, setting.air, errors=errors, spin_scatter=setting.spin_scatter
    )  # fmt: skip
    carry_spread = doubt.spread(balls.exit_speed, balls.launch_angle, per_drag=per_drag, scatter=spread)
    here, everywhere, count = _chances(balls, solved, fields, setting, away & known)
    return FlightColumns(
        launch_direction=np.where(known, solved, np.nan), carry=flown.carry + shift * per_drag,
        carry_spread=carry_spread, hang_time=flown.hang_time, apex_height=flown.apex_height,
        landing_angle=flown.landing_angle, carry_per_drag=per_drag,
        home_run_here=np.where(known & flown.landed & (fields.index >= 0), here, np.nan),
        home_runs=np.where(known & flown.landed, everywhere, np.nan),
        home_run_parks=np.where(known & flown.landed, count, np.nan),
    )  # fmt: skip


def _launched(balls: Balls, density: Array, setting: FlightSetting) -> tuple[Array, Flights, np.ndarray]:
    """Return launch directions, flights, and of which balls the direction is known.

    The first direction is a table's; from there it moves by what the landing misses, with the slope learnt on the way.
    Half of the balls need a second flight, few a third.
    """
    wanted, told = balls.bearing, balls.launch_direction
    given = np.isfinite(told)
    known = given | np.isfinite(wanted)
    spray = np.where(given, told, first_directions(
        balls, np.nan_to_num(wanted), ball=setting.ball, aerodynamics=setting.aerodynamics, air=setting.air,
        density=density,
    ))  # fmt: skip
    everyone = np.ones(len(balls), bool)
    flown = _flown(balls, spray, density, setting, everyone, setting.aerodynamics)
    open_rows = np.flatnonzero(known & ~given & flown.landed)
    slope = np.ones(len(balls))
    miss = np.zeros(len(balls))
    miss[open_rows] = _wrapped(flown.bearing[open_rows] - wanted[open_rows])
    open_rows = open_rows[np.abs(miss[open_rows]) > CLOSE]
    for _ in range(ROUNDS - 1):
        if not len(open_rows):
            break
        step = -miss[open_rows] / slope[open_rows]
        spray[open_rows] += np.clip(step, -0.5, 0.5)
        mask = np.zeros(len(balls), bool)
        mask[open_rows] = True
        again = _flown(balls, spray, density, setting, mask, setting.aerodynamics)
        flown = _replaced(flown, open_rows, again)
        before = miss[open_rows]
        miss[open_rows] = _wrapped(again.bearing - wanted[open_rows])
        with np.errstate(divide="ignore", invalid="ignore"):
            learnt = (miss[open_rows] - before) / step
        slope[open_rows] = np.where((learnt > 0.2) & (learnt < 5), learnt, 1.0)
        open_rows = open_rows[np.abs(miss[open_rows]) > CLOSE]
    known &= ~(np.abs(miss) > 20 * CLOSE)
    return spray, flown, known


def _flown(
    balls: Balls, spray: Array, density: Array, setting: FlightSetting, rows: np.ndarray, law: Aerodynamics
) -> Flights:
    conditions = FlightConditions(ball=setting.ball, aerodynamics=law, air=density[rows])
    return flights(_launch(balls, spray, rows), conditions, threads=setting.threads)


def _launch(balls: Balls, spray: Array, rows: np.ndarray) -> BallMotions:
    up, aside = balls.launch_angle[rows], spray[rows]
    return usual_launch(balls.exit_speed[rows], up, aside, left=balls.left[rows])


def _replaced(flown: Flights, rows: np.ndarray, again: Flights) -> Flights:
    for name in ("outcome", "carry", "hang_time", "apex_height", "apex_time", "landing_position", "landing_velocity"):
        getattr(flown, name)[rows] = getattr(again, name)
    return flown


def _chances(
    balls: Balls, spray: Array, fields: Fields, setting: FlightSetting, rows: np.ndarray
) -> tuple[Array, Array, Array]:
    """Return the chance here, the expected number over thirty parks, and in how many the mean ball is out."""
    here, everywhere, count = np.zeros((3, len(balls)))
    if not setting.parks:
        return np.full((3, len(balls)), np.nan)[0], *np.full((2, len(balls)), np.nan)
    for season in np.unique(balls.season[rows]).tolist():
        mine = np.flatnonzero(rows & (balls.season == season))
        thirty = thirty_parks(season)
        extra = [park for park in fields.parks if park not in thirty]
        mask = np.zeros(len(balls), bool)
        mask[mine] = True
        conditions = FlightConditions(ball=setting.ball, aerodynamics=setting.aerodynamics, air=setting.air)
        found = home_run_chances(
            _launch(balls, spray, mask), conditions, parks=(*thirty, *extra), threads=setting.threads
        )
        everywhere[mine] = found.chance[:, : len(thirty)].sum(axis=1)
        count[mine] = (found.clearance[:, : len(thirty)] > 0).sum(axis=1)
        place = {park: number for number, park in enumerate((*thirty, *extra))}
        columns = np.array([*(place[park] for park in fields.parks), 0])[fields.index[mine]]
        here[mine] = found.chance[np.arange(len(mine)), columns]
    return here, everywhere, count


def _wrapped(angle: Array) -> Array:
    return np.arctan2(np.sin(angle), np.cos(angle))

"""The flight of each ball: launch direction, carry with its error, and the probability of a home run.

The tracked direction is where a ball came down; the direction in which it set out is solved for. How surely a carry is
known is given by `carry_scatter`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from dataclasses import fields as dataclass_fields
from functools import lru_cache

import numpy as np

from sweetspot.equipment.ball import Ball
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import USUAL_AIR, Air, Airs
from sweetspot.flight.batted_spin import TRACKED, SpinLine
from sweetspot.flight.carry_scatter import (
    MORE_DRAG,
    SPEEDS,
    CarryErrors,
    LaunchErrors,
    braked,
    carry_errors,
    usual_launch,
)
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import LIKELY, USUAL, home_run_chances
from sweetspot.flight.kernel import Flights, flights
from sweetspot.flight.park import Park
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.numerics.arrays import Array, IntArray
from sweetspot.numerics.kernel_cache import compiled, inner
from sweetspot.numerics.threads import in_parts
from sweetspot.seasons.balls import Balls, Fields, nearest_fences, taken, thirty_parks
from sweetspot.seasons.swings import USUAL_ERRORS, Errors
from sweetspot.units import DEGREE, FOOT


@compiled(nogil=True, error_model="numpy")
def fill_between(axes: tuple[Array, Array, Array], table: Array, asked: Array, part: Array, values: Array) -> None:
    """Fill what stands in a table between its nodes, in straight lines; beyond its ends the nearest counts.

    ``table``: shape (nodes of each axis, 6), three values in thin air and the same in thick. ``asked``: (3, n); NaN
    counts as the first node. ``part``: (n,), how far on each ball's air is from the thin one to the thick.
    """
    first, second, third = axes
    for i in range(len(part)):
        a, x = _place(first, asked[0, i])
        b, y = _place(second, asked[1, i])
        c, z = _place(third, asked[2, i])
        bend, two, three = 0.0, 0.0, 0.0
        thin, thick = 1 - part[i], part[i]
        for corner in range(8):
            p, q, r = corner >> 2, (corner >> 1) & 1, corner & 1
            weight = (x if p else 1 - x) * (y if q else 1 - y) * (z if r else 1 - z)
            node = table[a + p, b + q, c + r]
            bend += weight * (thin * node[0] + thick * node[3])
            two += weight * (thin * node[1] + thick * node[4])
            three += weight * (thin * node[2] + thick * node[5])
        values[0, i], values[1, i], values[2, i] = bend, two, three


@inner(forceinline=True, error_model="numpy")
def _place(nodes: Array, value: float) -> tuple[int, float]:
    last = len(nodes) - 1.0
    at = (value - nodes[0]) / (nodes[1] - nodes[0])
    at = min(max(at, 0.0), last) if math.isfinite(at) else 0.0
    low = min(int(at), len(nodes) - 2)
    return low, at - low


ANGLES: Array = np.arange(-85.0, 86.0, 2.5) * DEGREE
SPRAYS: Array = np.arange(-110.0, 111.0, 5.0) * DEGREE
BEARINGS: Array = np.arange(-90.0, 91.0, 5.0) * DEGREE
APART = 0.2
"""Of the usual air's density: steps between the airs that are tabled; others lie on straight lines between."""


@dataclass(frozen=True)
class Expected:
    """The expectations from a table for n balls, every array of shape (n,).

    ``direction``: rad from centre field, positive to right field: about which way they set out. ``turn``: by how much
    that changes with the bearing. ``carry_per_drag``: m by which the carry grows with the logarithm of drag; negative.
    """

    direction: Array
    turn: Array
    carry_per_drag: Array


def expected_of(
    balls: Balls, bearing: Array, *, ball: Ball, aerodynamics: Aerodynamics, density: Array, line: SpinLine = TRACKED
) -> Expected:
    """Return the expected quantities of flights that come down in some direction.

    ``bearing``: where they come down, rad from centre field, shape (n,); 0 where it is not known. ``density``: of the
    air that each ball flies through, kg/m^3, shape (n,). ``line``: of the usual spin.
    """
    side = np.where(balls.left, -1.0, 1.0)  # a left-handed batter's ball is a right-handed one's in a mirror
    asked = np.stack([balls.exit_speed, balls.launch_angle, side * bearing])
    steps = density / (APART * USUAL_AIR.density)
    below = np.maximum(np.ceil(steps) - 1, 0)  # the usual air itself is the upper end of its band
    bend, turn, per_drag = values = np.empty((3, len(balls)))
    for thin in np.unique(below):
        mine = below == thin
        between = np.empty((3, int(mine.sum())))
        table = _table(ball, aerodynamics, line, int(thin))
        fill_between((SPEEDS, ANGLES, BEARINGS), table, asked[:, mine], steps[mine] - thin, between)
        values[:, mine] = between
    return Expected(bearing + side * bend, turn, per_drag)


@lru_cache(maxsize=16)
def _table(ball: Ball, aerodynamics: Aerodynamics, line: SpinLine, thin: int) -> Array:
    """Return the table for right-handed batters between two airs, shape (speeds, angles, bearings, 6)."""
    return np.ascontiguousarray(
        np.concatenate([_values(ball, aerodynamics, line, step) for step in (thin, thin + 1)], axis=-1)
    )


@lru_cache(maxsize=16)
def _values(ball: Ball, aerodynamics: Aerodynamics, line: SpinLine, step: int) -> Array:
    density = step * APART * USUAL_AIR.density
    speed, angle, spray = (grid.ravel() for grid in np.meshgrid(SPEEDS, ANGLES, SPRAYS, indexing="ij"))
    launch = usual_launch(speed, angle, spray, left=np.zeros(len(speed), bool), line=line)
    shape = (len(SPEEDS), len(ANGLES), len(SPRAYS))
    flown, again = (
        flights(launch, FlightConditions(ball=ball, aerodynamics=law, air=np.full(len(speed), density)))
        for law in (aerodynamics, braked(aerodynamics))
    )
    landed = np.unwrap(np.nan_to_num(flown.bearing).reshape(shape), axis=2)
    longer = np.nan_to_num((again.carry - flown.carry) / np.log1p(MORE_DRAG)).reshape(shape)
    bend, turn, per_drag = np.empty((3, len(SPEEDS), len(ANGLES), len(BEARINGS)))
    for place in np.ndindex(*shape[:2]):
        bend[place] = np.interp(BEARINGS, landed[place], SPRAYS - landed[place])
        turn[place] = 1 + np.gradient(bend[place], BEARINGS)
        per_drag[place] = np.interp(BEARINGS, landed[place], longer[place])
    return np.stack([bend, turn, per_drag], axis=-1)


ROUNDS, CLOSE = 5, 5e-4
"""Most flights of a ball in search of its direction, and rad by which it may come down beside: 0.2 ft at 400 ft."""
TURNED = 3e-3
"""rad that a ball's direction is turned by, for what its landing missed, without another flight: 9,996 of 10,000 come
down closer than `CLOSE` then, and carries change by 0.2 ft in one of a hundred, 0.4 ft at most."""
STEEP = 60 * DEGREE
"""Launch angle above which what drag does to a carry is no smooth function of bearings, and such balls are flown
again; below it the table's is right to 1.5 ft in 35 ft for 99 of 100 balls."""
THINNER, SURE = 1.02, 5.0
"""A ball that, in thinner air and with its drag so many standard deviations off, still comes down before every fence on
its way is no home run anywhere; so chances below about 1e-7 are taken as none."""
Rows = IntArray | slice
"""Which balls of all."""
STEP = 0.4
"""s of a flight's steps, twice those of single flights: 99 of 100 carries are within 0.02 ft, all within 0.15."""
CHUNK = 32_768
"""Balls that are flown together: what is made of them on the way stays in a core's own memory."""
GLOVE = 5 * FOOT
"""m above the ground, where caught balls end."""


@dataclass(frozen=True)
class FlightSetting:
    """The parameters that all balls of a table share.

    ``aerodynamics``: its law in the open; under a roof that never opens `aerodynamics_in` holds. ``air``: of balls
    whose table gives no weather; its elevation where neither the park's nor the table's is known. ``parks``: whether
    chances of home runs are wanted. ``drag``: that the balls fly with, over that of the law; None: what a season's own
    distances say, and 1 where no season is read. ``line``: of the usual spin. ``field``: where balls were hit whose
    table names no park that is known; None: unknown. ``major``: whether chances in the thirty parks are wanted.
    ``threads``: workers; None: one per core.
    """

    ball: Ball
    aerodynamics: Aerodynamics
    air: Air
    parks: bool = True
    errors: Errors = USUAL_ERRORS
    drag: float | None = None
    line: SpinLine = TRACKED
    field: Park | None = None
    major: bool = True
    threads: int | None = None

    def dragged(self, law: Aerodynamics) -> Aerodynamics:
        """Return a law with the drag that the balls fly with."""
        return law if self.drag in (None, 1.0) else law.with_drag(self.drag)


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
    home_run_parks : in how many of them it is likelier a home run than not.
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


def flown_balls(balls: Balls, fields: Fields, setting: FlightSetting, *, airs: Airs) -> FlightColumns:
    """Return the flights of balls.

    Balls with neither a bearing nor a launch direction fly as if to centre field, and have no chances.
    """
    columns = FlightColumns(*np.empty((len(dataclass_fields(FlightColumns)), len(balls))))
    alone = replace(setting, threads=1)

    def work(part: slice) -> None:
        for law, rows in fields.laws(setting.aerodynamics, part):
            here = replace(fields, index=fields.index[rows])
            columns_here = _flown_balls(taken(balls, rows), here, alone, airs.at(rows), setting.dragged(law))
            for name, values in vars(columns_here).items():
                getattr(columns, name)[rows] = values

    in_parts(work, len(balls), size=CHUNK, threads=setting.threads)
    return columns


def _flown_balls(balls: Balls, fields: Fields, setting: FlightSetting, airs: Airs, law: Aerodynamics) -> FlightColumns:
    """Return the flights of balls that fly by one law; chances start from the setting's, which is that in the open."""
    density, there = airs.density, replace(setting, aerodynamics=law)
    bearing = np.nan_to_num(balls.bearing)
    expected = expected_of(balls, bearing, ball=setting.ball, aerodynamics=law, density=density, line=setting.line)
    solved, flown, directed = _launched(balls, density, expected, there)
    per_drag = _per_drag(balls, solved, density, flown, expected, there)
    spread = np.array([*(USUAL.drag(park) for park in fields.parks), USUAL.open])[fields.index]
    errors = LaunchErrors(setting.errors.exit_speed, setting.errors.launch_angle)
    doubt = _carry_errors(setting.ball, law, errors)
    carry_spread = doubt.spread(balls.exit_speed, balls.launch_angle, per_drag=per_drag, scatter=spread)
    reach = THINNER * flown.carry - SURE * USUAL.open * per_drag
    reach = np.where(directed, reach, 0.0)
    here, everywhere, count = _chances(balls, solved, fields, airs, setting, bearing=flown.bearing, reach=reach)
    return FlightColumns(
        launch_direction=np.where(directed, solved, np.nan),
        carry=flown.carry,
        carry_spread=carry_spread,
        hang_time=flown.hang_time,
        apex_height=flown.apex_height,
        landing_angle=flown.landing_angle,
        carry_per_drag=per_drag,
        home_run_here=np.where(directed & flown.landed & (fields.index >= 0), here, np.nan),
        home_runs=np.where(directed & flown.landed, everywhere, np.nan),
        home_run_parks=np.where(directed & flown.landed, count, np.nan),
    )


@lru_cache(maxsize=8)
def _carry_errors(ball: Ball, law: Aerodynamics, errors: LaunchErrors) -> CarryErrors:
    return carry_errors(ball, law, USUAL_AIR, errors=errors)


def _launched(
    balls: Balls, density: Array, expected: Expected, setting: FlightSetting
) -> tuple[Array, Flights, np.ndarray]:
    """Return launch directions, flights, and of which balls the direction is known.

    The first direction is the table's, turned for what the landing misses; where that is much, the ball is flown again,
    with the change learnt on the way.
    """
    wanted, tracked = balls.bearing, balls.launch_direction
    given = np.isfinite(tracked)
    directed = given | np.isfinite(wanted)
    spray = np.where(given, tracked, expected.direction)
    flown = _flown(balls, spray, density, setting, slice(None), setting.aerodynamics)
    open_rows = np.flatnonzero(directed & ~given & flown.landed)
    miss = np.zeros(len(balls))
    miss[open_rows] = _wrapped(flown.bearing[open_rows] - wanted[open_rows])
    near = open_rows[np.abs(miss[open_rows]) <= TURNED]
    spray[near] -= miss[near] * expected.turn[near]
    open_rows = open_rows[np.abs(miss[open_rows]) > TURNED]
    turn = expected.turn[open_rows]
    for _ in range(ROUNDS - 1):
        if not len(open_rows):
            break
        step = np.clip(-miss[open_rows] * turn, -0.5, 0.5)
        spray[open_rows] += step
        again = _flown(balls, spray, density, setting, open_rows, setting.aerodynamics)
        flown = _replaced(flown, open_rows, again)
        before = miss[open_rows]
        miss[open_rows] = _wrapped(again.bearing - wanted[open_rows])
        with np.errstate(divide="ignore", invalid="ignore"):
            learnt = step / (miss[open_rows] - before)
        further = np.abs(miss[open_rows]) > CLOSE
        turn = np.where((learnt > 0.2) & (learnt < 5), learnt, 1.0)[further]
        open_rows = open_rows[further]
    directed &= ~(np.abs(miss) > 20 * CLOSE)
    return spray, flown, directed


def _per_drag(
    balls: Balls, spray: Array, density: Array, flown: Flights, expected: Expected, setting: FlightSetting
) -> Array:
    """Return the slope of carry by the logarithm of drag, m; 0 for balls that were hit down."""
    per_drag = np.where(balls.launch_angle > 0, expected.carry_per_drag, 0.0)
    steep = np.flatnonzero(flown.landed & (balls.launch_angle > STEEP))
    if len(steep):
        again = _flown(balls, spray, density, setting, steep, braked(setting.aerodynamics))
        per_drag[steep] = (again.carry - flown.carry[steep]) / np.log1p(MORE_DRAG)
    return np.where(flown.landed, per_drag, np.nan)


def _flown(
    balls: Balls, spray: Array, density: Array, setting: FlightSetting, rows: Rows, law: Aerodynamics
) -> Flights:
    conditions = FlightConditions(ball=setting.ball, aerodynamics=law, air=density[rows])
    return flights(_launch(balls, spray, rows, setting.line), conditions, step=STEP, threads=setting.threads)


def _launch(balls: Balls, spray: Array, rows: Rows, line: SpinLine) -> BallMotions:
    up, aside = balls.launch_angle[rows], spray[rows]
    return usual_launch(balls.exit_speed[rows], up, aside, left=balls.left[rows], line=line)


def _replaced(flown: Flights, rows: np.ndarray, again: Flights) -> Flights:
    for name in ("outcome", "carry", "hang_time", "apex_height", "apex_time", "landing_position", "landing_velocity"):
        getattr(flown, name)[rows] = getattr(again, name)
    return flown


def _chances(
    balls: Balls, spray: Array, fields: Fields, airs: Airs, setting: FlightSetting, *, bearing: Array, reach: Array
) -> tuple[Array, Array, Array]:
    """Return the chance here, the expected number over thirty parks, and in how many it is above one half.

    Balls that come down at a bearing and reach no farther than the fences there have none.
    """
    here, everywhere, count = np.zeros((3, len(balls)))
    if not setting.parks:
        return np.full((3, len(balls)), np.nan)[0], *np.full((2, len(balls)), np.nan)
    for season in np.unique(balls.season[reach > 0]).tolist():
        thirty = thirty_parks(season) if setting.major else ()
        extra = [park for park in fields.parks if park not in thirty]
        if not (thirty or extra):
            continue
        near = nearest_fences((*thirty, *extra), bearing)
        mine = np.flatnonzero((reach > near) & (balls.season == season))
        if not len(mine):
            continue
        law = setting.dragged(setting.aerodynamics)
        conditions = FlightConditions(ball=setting.ball, aerodynamics=law, air=airs.at(mine))
        chances = home_run_chances(
            _launch(balls, spray, mine, setting.line),
            conditions,
            parks=(*thirty, *extra),
            step=STEP,
            threads=setting.threads,
        )
        everywhere[mine] = chances.chance[:, : len(thirty)].sum(axis=1)
        count[mine] = (chances.chance[:, : len(thirty)] > LIKELY).sum(axis=1)
        place = {park: number for number, park in enumerate((*thirty, *extra))}
        columns = np.array([*(place[park] for park in fields.parks), 0])[fields.index[mine]]
        here[mine] = chances.chance[np.arange(len(mine)), columns]
    if not setting.major:
        everywhere, count = np.full((2, len(balls)), np.nan)
    return here, everywhere, count


def _wrapped(angle: Array) -> Array:
    return angle - 2 * np.pi * np.rint(angle / (2 * np.pi))

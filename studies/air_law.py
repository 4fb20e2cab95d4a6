"""Fit drag, lift and usual spin of batted baseballs together: ``python -m studies.air_law ../shared/data``.

Two tables take part. A college club's hits have launch direction, spin rate and axis, bearing, hang time, apex and a
trajectory. Contact of 2022 has distances and bearings, half of them under one roof. One law is fitted to both at once,
each ball with its level of drag; which parts the two balls share is tested. A game is a cluster: standard errors and
halves go by games.

A caught ball's distance ends at the glove and a fence or the ground ends another's, so plain distances choose their
balls: those of the league are used from 25 deg up only, where they hardly do.
"""

from __future__ import annotations

import argparse
import io
from collections.abc import Iterable, Mapping, Sequence
from contextlib import redirect_stdout
from dataclasses import dataclass, fields, replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import polars as pl
from numpy.typing import NDArray
from scipy.optimize import least_squares

from sweetspot import catalog
from sweetspot.catalog.aerodynamic_laws import drag_spread, usual_spin_line
from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import SpinLine, backspin_scatter, batted_ball_spin
from sweetspot.flight.bearing import bearing_of_place, launched_to
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import Flights, flights
from sweetspot.motion.ball_motion import BallMotions, spin_axes
from sweetspot.seasons.flight_columns import GLOVE
from sweetspot.units import DEGREE, FOOT, MPH, RPM

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

COLLEGE, LEAGUE = "trackman_2025_college_hits.csv.gz", "savant_2022_contact_sample.csv.gz"
ROOF = "TB"
"""Whose games were under a roof at a known temperature."""
INDOORS, EVENING = Air(temperature=40 / 1.8), Air(temperature=27.0, elevation=10.0)
"""72 degF, and a summer evening near Sacramento (assumed; its level of drag is free)."""
CAUGHT = ("field_out", "sac_fly", "double_play", "sac_fly_double_play")
PARTS = (1 / 3, 2 / 3, 1.0)
"""Of the hang time, at which a ball's place is compared."""
POINTS = 61
KRPM = 1000 * RPM
ANGLES, LEAST, FLIES = (10 * DEGREE, 50 * DEGREE), 15 * DEGREE, 25 * DEGREE
SLOWEST, SLOWEST_LEAGUE = 75 * MPH, 80 * MPH
ROUNDS = 50
HUBER = 1.5
"""Standard deviations beyond which a residual counts in proportion only."""


@dataclass(frozen=True)
class Balls:
    """Tracked balls, SI, shape (n,) unless said; NaN where something was not measured.

    Parameters
    ----------
    side : 1 for right-handed batters, -1 for left-handed ones.
    direction : of the launch, rad from centre field.
    backspin, sidespin : from rate and axis, rad/s; `backspin` lifts, `sidespin` bends to the left.
    height : where the ball ended, above the ground.
    track : places at `PARTS` of the hang time, shape (n, parts, 3).
    start : place of contact, shape (n, 3).
    ball : 0 league under the roof, 1 league in the open, 2 college.
    """

    speed: Array
    angle: Array
    side: Array
    direction: Array
    backspin: Array
    sidespin: Array
    bearing: Array
    distance: Array
    hang: Array
    apex: Array
    height: Array
    density: Array
    track: Array
    start: Array
    game: NDArray[np.str_]
    park: NDArray[np.str_]
    ball: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.speed)

    def where(self, rows: Flags) -> Balls:
        """Return some of the balls."""
        return Balls(**{field.name: getattr(self, field.name)[rows] for field in fields(self)})

    @property
    def pulled(self) -> Array:
        """Bearing to the pull side, rad."""
        return -self.side * self.bearing

    @property
    def words(self) -> NDArray[np.str_]:
        """Side of each batter in words."""
        return np.where(self.side > 0, "right", "left")


def college_rows(path: Path) -> pl.DataFrame:
    """Return the college hits whose launch and landing are surely tracked; raises `OSError` for a missing file."""
    table = pl.read_csv(path, infer_schema_length=None)
    sides = table.filter(pl.col("BatterSide").is_in(["Right", "Left"])).group_by("Batter").agg(
        usual=pl.col("BatterSide").mode().first()
    )  # fmt: skip
    named = pl.when(pl.col("BatterSide").is_in(["Right", "Left"])).then(pl.col("BatterSide")).otherwise(pl.col("usual"))
    table = table.join(sides, on="Batter", how="left", maintain_order="left").with_columns(hand=named)
    return table.filter(
        (pl.col("HitLaunchConfidence") == "High")
        & pl.col("HitLandingConfidence").is_in(["High", "Medium"])
        & pl.col("hand").is_not_null()
        & (pl.col("Angle") * DEGREE).is_between(*ANGLES)
        & (pl.col("ExitSpeed") * MPH >= SLOWEST)
    )


def college_balls(table: pl.DataFrame) -> Balls:
    """Return the rows of `college_rows` as balls."""

    def column(name: str, unit: float = 1.0) -> Array:
        return table[name].cast(pl.Float64).fill_null(np.nan).to_numpy() * unit

    tilt, rate, hang = column("HitSpinAxis", DEGREE) - np.pi, column("HitSpinRate", RPM), column("HangTime")
    time = np.outer(hang, PARTS)
    powers = time[..., None] ** np.arange(9)
    right, out, up = (
        FOOT * (powers * np.nan_to_num([column(f"HitTrajectory{axis}c{k}") for k in range(9)]).T[:, None, :]).sum(-1)
        for axis in "ZXY"
    )
    count = len(table)
    return Balls(
        speed=column("ExitSpeed", MPH), angle=column("Angle", DEGREE),
        side=np.where(table["hand"] == "Right", 1.0, -1.0), direction=column("Direction", DEGREE),
        backspin=rate * np.cos(tilt), sidespin=-rate * np.sin(tilt), bearing=column("Bearing", DEGREE),
        distance=column("Distance", FOOT), hang=hang, apex=column("MaxHeight", FOOT), height=np.zeros(count),
        density=np.full(count, EVENING.density), track=np.stack([right, out, up], axis=-1),
        start=FOOT * np.stack([column(f"ContactPosition{axis}") for axis in "ZXY"], axis=-1),
        game=np.array([f"college {game}" for game in table["game"]]), park=np.full(count, "college"),
        ball=np.full(count, 2),
    )  # fmt: skip


def read_league(path: Path) -> Balls:
    """Return the flies and line drives of the league's table; raises `OSError` for a missing file."""
    table = pl.read_csv(path, infer_schema_length=None).filter(
        pl.col("bb_type").is_in(["fly_ball", "line_drive"])
        & (pl.col("launch_speed") * MPH >= SLOWEST_LEAGUE)
        & (pl.col("launch_angle") * DEGREE).is_between(15 * DEGREE, 45 * DEGREE)
        & pl.all_horizontal(pl.col("hit_distance_sc", "hc_x", "hc_y").is_not_null())
    )
    count, home = len(table), table["home_team"].to_numpy().astype(str)
    elevations = {name: catalog.park(name).elevation for name in np.unique(home)}
    nothing = np.full(count, np.nan)
    return Balls(
        speed=table["launch_speed"].to_numpy() * MPH, angle=table["launch_angle"].to_numpy() * DEGREE,
        side=np.where(table["stand"] == "R", 1.0, -1.0), direction=nothing, backspin=nothing, sidespin=nothing,
        bearing=bearing_of_place(table["hc_x"].to_numpy(), table["hc_y"].to_numpy()),
        distance=table["hit_distance_sc"].to_numpy() * FOOT, hang=nothing, apex=nothing,
        height=np.where(table["events"].is_in(CAUGHT), GLOVE, 0.0),
        density=np.array([INDOORS.replaced(elevation=elevations[name]).density for name in home]),
        track=np.full((count, len(PARTS), 3), np.nan), start=np.tile([0.0, 2 * FOOT, 3 * FOOT], (count, 1)),
        game=np.array([f"league {game}" for game in table["game_pk"]]), park=home,
        ball=np.where(home == ROOF, 0, 1),
    )  # fmt: skip


@dataclass(frozen=True)
class Law:
    """Everything that is fitted; angles in degrees and spins in rpm, as people write the line of usual spin.

    Parameters
    ----------
    roof, open, college : Cd without spin, by ball and place.
    per_spin : growth of Cd per 1000 rpm of active spin.
    lift : scale of Cl over `trajectory-calculator`'s shape S / (0.583 + 2.333 S).
    per_slowness : growth of Cd with 90 mph / v - 1, at any density.
    per_thinness : growth of Cd with 1.2 kg/m^3 / rho - 1, at any speed.
    back, back_angle, back_spray : backspin at 27 deg, per degree of launch angle and of spray to the opposite side.
    side, side_angle, side_spray : sidespin of a right-hander at 27 deg, per degree of launch angle and of spray.
    turned : sidespin of every college ball, whoever hit it: the park's cross wind or a turned radar.
    wind_right, wind_out : of the college park, m/s.
    college_per_spin, college_lift : what the college ball has more of the two.
    """

    roof: float = 0.315
    open: float = 0.330
    college: float = 0.360
    per_spin: float = 0.028
    lift: float = 1.03
    per_slowness: float = 0.0
    per_thinness: float = 0.0
    back: float = 2540.0
    back_angle: float = 115.0
    back_spray: float = 16.0
    side: float = -950.0
    side_angle: float = -20.0
    side_spray: float = -90.0
    turned: float = 0.0
    wind_right: float = 0.0
    wind_out: float = 0.0
    college_per_spin: float = 0.0
    college_lift: float = 0.0

    @property
    def line(self) -> SpinLine:
        """The line of usual spin."""
        zero = self.back - 27 * self.back_angle
        return SpinLine((zero, self.back_angle, self.back_spray), (self.side, self.side_spray, self.side_angle))

    def levels(self) -> tuple[float, float, float]:
        """Return Cd without spin by `Balls.ball`."""
        return self.roof, self.open, self.college

    def aerodynamics(self, ball: int, density: float) -> Aerodynamics:
        """Return the law of a kind of ball, in air of a density, kg/m^3."""
        college = ball == 2
        usual = catalog.aerodynamics("trajectory-calculator")
        viscous = self.per_slowness * density / 1.2  # Re_0 / Re is 90 mph / v at 1.2 kg/m^3, to 2 %
        return usual.replaced(
            drag=max(self.levels()[ball] + self.per_thinness * (1.2 / density - 1), viscous),
            drag_per_spin=0.0,
            drag_per_active_spin=(self.per_spin + college * self.college_per_spin) / KRPM,
            drag_per_inverse_reynolds=max(viscous, 0.0),
            lift_scale=self.lift + college * self.college_lift,
        )


SCALES: Mapping[str, float] = {
    "roof": 0.005, "open": 0.005, "college": 0.005, "per_spin": 0.002, "lift": 0.03, "per_slowness": 0.02,
    "per_thinness": 0.02, "back": 60.0, "back_angle": 6.0, "back_spray": 3.0, "side": 60.0, "side_angle": 8.0,
    "side_spray": 4.0, "turned": 60.0, "wind_right": 0.5, "wind_out": 0.5, "college_per_spin": 0.003,
    "college_lift": 0.03,
}  # fmt: skip
"""Sizes of steps, about the standard errors."""
USED = (
    "roof", "open", "college", "per_spin", "lift", "back", "back_angle", "back_spray", "side", "side_angle",
    "side_spray", "turned", "wind_right",
)  # fmt: skip
"""What the law in use leaves free."""


def kinds(balls: Balls) -> Iterable[tuple[int, float, Flags]]:
    """Yield each kind of ball and air with its rows: in one air at a time, a term in density is a level."""
    for ball, density in sorted(set(zip(balls.ball.tolist(), balls.density.tolist(), strict=True))):
        yield ball, density, (balls.ball == ball) & (balls.density == density)


def conditions_of(law: Law, ball: int, density: float, count: int) -> FlightConditions:
    """Return what balls of a kind fly through."""
    wind = [law.wind_right, law.wind_out] if ball == 2 else [0.0, 0.0]
    return FlightConditions(
        ball=catalog.ball(), aerodynamics=law.aerodynamics(ball, density), air=np.full(count, density),
        wind=np.tile(wind, (count, 1)),
    )  # fmt: skip


def usual_spin(balls: Balls, direction: Array, law: Law) -> tuple[Array, Array]:
    """Return backspin and sidespin by the line, rad/s."""
    back, side = batted_ball_spin(balls.angle, direction, bats=balls.words, line=law.line)
    return back, side + np.where(balls.ball == 2, law.turned * RPM, 0.0)


def flown(balls: Balls, law: Law, direction: Array, spin: tuple[Array, Array]) -> tuple[Array, Flights]:
    """Return the places at `PARTS` of the measured hang times, m, and the flights of balls of one kind."""
    axes = spin_axes(balls.angle, direction)
    motions = BallMotions(
        velocity=balls.speed[:, None] * axes[2],
        spin=spin[0][:, None] * axes[0] + spin[1][:, None] * axes[1],
        position=balls.start,
    )
    through = conditions_of(law, int(balls.ball[0]), float(balls.density[0]), len(balls))
    result = flights(motions, through, path_points=POINTS)
    return places_at(np.outer(balls.hang, PARTS), result), result


def places_at(time: Array, result: Flights) -> Array:
    """Return where balls are at times of shape (n, k), m; after the landing they go on as they landed."""
    last = result.times[:, -1:]
    at = np.clip(time / np.maximum(last, 1e-9) * (POINTS - 1), 0, POINTS - 1.001)
    low = np.nan_to_num(at).astype(np.int64)
    part = (np.nan_to_num(at) - low)[..., None]
    rows = np.arange(len(time))[:, None]
    place = (1 - part) * result.positions[rows, low] + part * result.positions[rows, low + 1]
    after = np.maximum(np.nan_to_num(time - last), 0.0)[..., None] * result.landing_velocity[:, None, :]
    return np.asarray(place + after)


Residuals = dict[str, Array]
"""By what was measured: computed less measured for every ball, NaN where it was not, SI."""


def residuals(balls: Balls, law: Law) -> tuple[Residuals, Residuals]:
    """Return residuals of balls with the spin that was measured, where it was, and with the usual one.

    ``distance``: at the end, a glove's for caught balls. ``along``, ``across``, ``up``: at `PARTS` of the measured hang
    time, shape (n, parts), so ``along`` at the last is the distance at the measured hang time. ``direction``: of the
    launch, solved from the bearing. ``backspin``, ``sidespin``: of the line less those by rate and axis.
    """
    measured: Residuals = {}
    usual: Residuals = {}
    for ball, density, rows in kinds(balls):
        mine = balls.where(rows)
        through = conditions_of(law, ball, density, len(mine))
        spins = law.line
        if ball == 2:
            line = usual_spin(mine, mine.direction, law)
            found = {"backspin": line[0] - mine.backspin, "sidespin": line[1] - mine.sidespin}
            put(usual, rows, found | compared(mine, *flown(mine, law, mine.direction, line)))
            put(measured, rows, compared(mine, *flown(mine, law, mine.direction, (mine.backspin, mine.sidespin))))
            continue
        direction, result = launched_to(
            mine.bearing, exit_speed=mine.speed, launch_angle=mine.angle, bats=mine.words, spins=spins,
            conditions=through,
        )  # fmt: skip
        short = mine.height / np.tan(np.maximum(result.landing_angle, 0.05))
        put(usual, rows, {"distance": np.where(np.isfinite(direction), result.carry - short - mine.distance, np.nan)})
    return measured, usual


def put(into: Residuals, rows: Flags, values: Residuals) -> None:
    """Write the residuals of some rows beside those of the others."""
    for name, some in values.items():
        every = into.setdefault(name, np.full((len(rows), *some.shape[1:]), np.nan))
        every[rows] = some


def compared(balls: Balls, places: Array, result: Flights) -> Residuals:
    """Return what flights have more than measured ones."""
    apart = places - balls.track
    outwards = np.stack([np.sin(balls.bearing), np.cos(balls.bearing)], axis=-1)[:, None, :]
    turn = result.bearing - balls.bearing
    return {
        "distance": result.carry - balls.distance,
        "hang": result.hang_time - balls.hang,
        "apex": result.apex_height - balls.apex,
        "bearing": np.arctan2(np.sin(turn), np.cos(turn)),
        "along": (apart[..., :2] * outwards).sum(-1),
        "across": apart[..., 0] * outwards[..., 1] - apart[..., 1] * outwards[..., 0],
        "up": apart[..., 2],
    }


WEIGHTS: Mapping[str, tuple[Array, Array]] = {
    "along": (np.array([0.42, 1.2, 2.2]), np.array([0.51, 1.35, 2.4])),
    "across": (np.array([0.26, 0.92, 1.66]), np.array([0.84, 2.7, 4.9])),
    "up": (np.array([0.23, 0.74, 1.4]), np.array([0.50, 1.6, 2.9])),
}
"""m: standard deviations of what is left at `PARTS` with the measured spin and with the usual one (robust, of a first
fit)."""
SIDESPIN_ERROR = 880 * RPM
LEAGUE_ERRORS = FOOT * np.array([[22.0, 22.0], [17.0, 19.0], [8.7, 12.0]])
"""m: of the league's distances under the roof and in the open, below 20 deg, to 25 deg and above."""


def standardised(balls: Balls, law: Law) -> tuple[Array, NDArray[np.str_]]:
    """Return all residuals that the fit looks at, in standard deviations, and the game of each.

    Three coordinates at three times are one flight: each counts a third. A ball's flight is used with its measured
    spin, and the line meets the spin itself; only a ball without rate or axis is flown with the line.
    """
    measured, usual = residuals(balls, law)
    parts: list[Array] = []
    games: list[NDArray[np.str_]] = []

    def add(values: Array, rows: Flags) -> None:
        good = rows & np.isfinite(values)
        parts.append(np.where(good, values, 0.0)[rows])
        games.append(balls.game[rows])

    spun = np.isfinite(balls.backspin)
    college = balls.ball == 2
    if college.any():
        for name, (known, guessed) in WEIGHTS.items():
            for k in range(len(PARTS)):
                add(measured[name][:, k] / known[k] / np.sqrt(3), college & spun)
                add(usual[name][:, k] / guessed[k] / np.sqrt(3), college & ~spun)
        add(usual["backspin"] / backspin_scatter(balls.angle), college & spun)
        add(usual["sidespin"] / SIDESPIN_ERROR, college & spun)
    league = (balls.ball < 2) & (balls.angle >= LEAST)
    if league.any():
        add(
            usual["distance"]
            / LEAGUE_ERRORS[np.digitize(balls.angle, [20 * DEGREE, 25 * DEGREE]), np.minimum(balls.ball, 1)],
            league,
        )
    return np.concatenate(parts), np.concatenate(games)


@dataclass(frozen=True)
class Fit:
    """A law with standard errors by games, and its cost.

    ``cost``: half the sum of Huber's squares. ``covariance``: of the free numbers, in `names`' order.
    """

    law: Law
    names: tuple[str, ...]
    covariance: Array
    cost: float

    def error(self, name: str) -> float:
        """Return the standard error of a number; 0 where it was held."""
        return float(np.sqrt(self.covariance[(at := self.names.index(name)), at])) if name in self.names else 0.0


def moved(law: Law, names: Sequence[str], steps: Array) -> Law:
    """Return a law with numbers moved by so many of their `SCALES`."""
    return replace(law, **{name: getattr(law, name) + SCALES[name] * by for name, by in zip(names, steps, strict=True)})


MIDDLE = 10.0
"""Where the search starts, in `SCALES`: its steps are parts of the place, and zero would have none."""


def fitted(balls: Balls, names: Sequence[str] = USED, start: Law | None = None) -> Fit:
    """Return the law that fits best; errors are sandwiches over games."""
    first = start or Law()
    names = tuple(name for name in names if name not in unused(balls))

    def left_over(places: Array) -> Array:
        return standardised(balls, moved(first, names, places - MIDDLE))[0]

    found = least_squares(
        left_over, np.full(len(names), MIDDLE), loss="huber", f_scale=HUBER, diff_step=[0.01] * len(names), xtol=1e-5
    )
    law = moved(first, names, found.x - MIDDLE)
    left, game = standardised(balls, law)
    slopes = np.stack(
        [
            (standardised(balls, moved(law, names, row))[0] - standardised(balls, moved(law, names, -row))[0]) / 0.2
            for row in 0.1 * np.eye(len(names))
        ],
        axis=-1,
    )
    inside = np.abs(left) < HUBER
    clipped = np.clip(left, -HUBER, HUBER)
    bread = np.linalg.inv((slopes * inside[:, None]).T @ slopes)
    group = np.unique(game, return_inverse=True)[1]
    sums = np.stack([np.bincount(group, clipped * side) for side in slopes.T], axis=-1)
    scale = np.array([SCALES[name] for name in names])
    return Fit(law, names, bread @ sums.T @ sums @ bread * np.outer(scale, scale), float(found.cost))


def unused(balls: Balls) -> set[str]:
    """Return the numbers that a table says nothing of."""
    college = {"college", "turned", "wind_right", "wind_out", "college_per_spin", "college_lift"}
    nothing = set[str]() if (balls.ball == 2).any() else college
    return nothing | {name for ball, name in ((0, "roof"), (1, "open")) if not (balls.ball == ball).any()}


SPRAYED = ("side", "side_angle", "side_spray", "back_spray")
"""What is fitted without the league's liners: pulled ones that fall in or meet a wall are their long ones, which least
squares would turn into sidespin that changes with launch angle."""


def joint(balls: Balls, names: Sequence[str] = USED) -> Fit:
    """Return the law in two steps: the spray parts of the line from flies and measured spin, then the rest from all."""
    first = fitted(balls.where((balls.ball == 2) | (balls.angle >= FLIES)), names)
    rest = tuple(name for name in names if name not in SPRAYED)
    second = fitted(balls, rest, first.law)
    both = (*rest, *SPRAYED)
    errors = [second.error(name) or first.error(name) for name in both]
    return Fit(second.law, both, np.diag(np.square(errors)), second.cost)


def lines_by_rates(balls: Balls) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
    """Return the lines of backspin and of sidespin by rate and axis alone, rpm, with standard errors by games.

    Backspin at 27 deg, per degree of launch angle and of spray to the opposite side; sidespin of a right-hander at 27
    deg, per degree of launch angle and of spray, and what both hands share.
    """
    good = np.isfinite(balls.backspin) & (balls.angle <= 45 * DEGREE)
    mine = balls.where(good)
    above, spray, one = mine.angle / DEGREE - 27, mine.direction / DEGREE, np.ones(len(mine))
    group = np.unique(mine.game, return_inverse=True)[1]
    found = []
    for spin, scale, columns in (
        (mine.backspin, 700.0, (one, above, mine.side * spray)),
        (mine.sidespin, 880.0, (mine.side, mine.side * above, spray, one)),
    ):
        known, wanted = np.stack(columns, axis=-1) / scale, spin / RPM / scale
        answer: Array = np.zeros(known.shape[1])
        for _ in range(ROUNDS):  # least squares with Huber's weights
            weight = np.minimum(1, HUBER / np.maximum(np.abs(known @ answer - wanted), 1e-9))[:, None]
            root = np.sqrt(weight)
            answer = np.asarray(np.linalg.lstsq(known * root, wanted * root[:, 0], rcond=None)[0], float)
        left = known @ answer - wanted
        bread = np.linalg.inv((known * (np.abs(left) < HUBER)[:, None]).T @ known)
        sums = np.stack([np.bincount(group, np.clip(left, -HUBER, HUBER) * side) for side in known.T], axis=-1)
        found.append((answer, np.sqrt(np.diag(bread @ sums.T @ sums @ bread))))
    return found[0], found[1]


def show(title: str, fit: Fit, base: Fit | None = None) -> None:
    """Print a law with its standard errors."""
    better = "" if base is None else f" ({fit.cost - base.cost:+.1f})"
    numbers = ", ".join(f"{name} {getattr(fit.law, name):.4g} +- {fit.error(name):.2g}" for name in fit.names)
    print(f"{title}: cost {fit.cost:.1f}{better}; {numbers}")


@dataclass(frozen=True)
class Bar:
    """What a figure may be at most, in the unit of its name."""

    name: str
    value: float
    most: float

    @property
    def missed(self) -> bool:
        """Whether the figure is beyond its bar."""
        return not abs(self.value) <= self.most


FEW = 20
"""Balls below which a group has no mean worth a bar."""


def groups_of(balls: Balls) -> dict[str, tuple[Array, Sequence[float] | Array]]:
    """Return what residuals are broken down by: values and edges."""
    spin = np.hypot(balls.backspin, balls.sidespin) / RPM

    def sixths(values: Array) -> Array:
        return np.quantile(values, np.linspace(0, 1, 7))

    return {
        "pull, deg": (balls.pulled / DEGREE, sixths(balls.pulled / DEGREE)),
        "launch angle, deg": (balls.angle / DEGREE, sixths(balls.angle / DEGREE)),
        "exit speed, mph": (balls.speed / MPH, sixths(balls.speed / MPH)),
        "spin, rpm": (spin, (0, 1000, 1500, 2000, 2500, 3000, 3500, 6000)),
        "air, kg/m^3": (balls.density, (0.9, 1.1, 1.17, 1.19, 1.3)),
    }


def broken_down(balls: Balls, apart: Array, title: str) -> list[Bar]:
    """Print residuals of a length by all that a ball is known by; return sixths as bars of 5 ft."""
    bars = []
    print(
        f"  {title}: {np.nanmean(apart) / FOOT:+.1f} ft, SD {np.nanstd(apart) / FOOT:.1f}, n {np.isfinite(apart).sum()}"
    )
    for name, (values, edges) in groups_of(balls).items():
        cells = []
        for low, high in pairwise(edges):
            group = (values >= low) & ((values < high) | ((values == high) & (high == edges[-1]))) & np.isfinite(apart)
            if group.sum() >= FEW:
                mean = float(apart[group].mean()) / FOOT
                cells.append(f"{low:.4g}: {mean:+.1f} ({group.sum()})")
                if "deg" in name or "mph" in name:
                    bars.append(Bar(f"{title}, {name} from {low:.0f}", mean, 5.0))
        if cells:
            print(f"    {name:18}", "  ".join(cells))
    for park in np.unique(balls.park):
        group = (balls.park == park) & np.isfinite(apart)
        if FEW <= group.sum() < len(balls):
            print(f"    {park} {apart[group].mean() / FOOT:+.1f} ({group.sum()})", end="")
    print()
    return bars


def solved_direction(balls: Balls, law: Law) -> Array:
    """Return launch directions solved from bearings less the measured ones, rad, as a program without wind has them."""
    direction, _ = launched_to(
        balls.bearing, exit_speed=balls.speed, launch_angle=balls.angle, bats=balls.words, spins=law.line,
        conditions=conditions_of(replace(law, wind_right=0.0, wind_out=0.0), 2, float(balls.density[0]), len(balls)),
    )  # fmt: skip
    return np.asarray(direction - balls.direction)


def checked(balls: Balls, law: Law, title: str) -> list[Bar]:
    """Print how a law meets balls, broken down by everything; return the figures that have bars."""
    print(title)
    measured, usual = residuals(balls, law)
    bars: list[Bar] = []
    league = balls.ball < 2
    if league.any():
        mine, apart = balls.where(league), usual["distance"][league]
        bars += broken_down(mine, apart, "league, carry")
        bars.append(Bar("league, carry, ft", float(np.nanmean(apart)) / FOOT, 3.0))
        roof = (mine.ball == 0) & (mine.angle >= FLIES)
        if roof.any():
            bars.append(Bar("roof from 25 deg, SD, ft", float(np.nanstd(apart[roof])) / FOOT, 9.0))
    if not league.all():
        mine = balls.where(~league)
        at_hang = usual["along"][~league][:, -1]
        bars += broken_down(mine, at_hang, "college, distance at the measured hang time")
        for name, values in usual.items():
            both = [
                f"{np.nanmean(some[~league], axis=0)} (SD {np.nanstd(some[~league], axis=0)})"
                for some in (values, *([measured[name]] if name in measured else []))
            ]
            print(f"    {name}, SI: by the line {both[0]}" + (f", measured spin {both[1]}" if both[1:] else ""))
        direction = solved_direction(mine, law) / DEGREE
        print(f"    direction solved from bearing {np.nanmean(direction):+.2f} deg, SD {np.nanstd(direction):.2f}")
        bars += [
            Bar("college, distance at hang time, ft", float(np.nanmean(at_hang)) / FOOT, 2.0),
            Bar("college, the same, SD, ft", float(np.nanstd(at_hang)) / FOOT, 12.0),
            Bar("college, direction, SD, deg", float(np.nanstd(direction)), 3.2),
        ]
    return bars


def together(*parts: Balls) -> Balls:
    """Return balls of several tables."""
    return Balls(
        **{field.name: np.concatenate([getattr(part, field.name) for part in parts]) for field in fields(Balls)}
    )


def made_up(law: Law, random: np.random.Generator, count: int) -> Balls:
    """Return balls that a law flies exactly, half of them college's, with spins that scatter about its line."""
    college = np.arange(count) % 2 == 0
    nothing, place = np.full(count, np.nan), np.full((count, len(PARTS), 3), np.nan)
    balls = Balls(
        speed=random.uniform(85, 110, count) * MPH, angle=random.uniform(16, 42, count) * DEGREE,
        side=np.where(random.random(count) < 0.6, 1.0, -1.0), direction=random.uniform(-35, 35, count) * DEGREE,
        backspin=nothing, sidespin=nothing, bearing=nothing, distance=nothing, hang=np.full(count, 4.0), apex=nothing,
        height=np.zeros(count), density=np.where(college, EVENING.density, INDOORS.density), track=place,
        start=np.tile([0.0, 2 * FOOT, 3 * FOOT], (count, 1)), game=np.array([f"{k % 24}" for k in range(count)]),
        park=np.where(college, "college", ROOF), ball=np.where(college, 2, np.arange(count) // 2 % 2),
    )  # fmt: skip
    back, side = usual_spin(balls, balls.direction, law)
    back = back + college * random.normal(0, backspin_scatter(balls.angle))
    side = side + college * random.normal(0, SIDESPIN_ERROR, count)
    bearing, distance, hang, apex = np.empty((4, count))
    track = np.empty_like(place)
    for _, _, rows in kinds(balls):
        _, result = flown(balls.where(rows), law, balls.direction[rows], (back[rows], side[rows]))
        bearing[rows], distance[rows] = result.bearing, result.carry
        hang[rows], apex[rows] = result.hang_time, result.apex_height
        track[rows] = places_at(np.outer(result.hang_time, PARTS), result)
    known = np.where(college, 1.0, np.nan)
    return replace(
        balls, backspin=back * known, sidespin=side * known, bearing=bearing, distance=distance, hang=hang * known,
        apex=apex * known, track=track * known[:, None, None], direction=balls.direction * known,
    )  # fmt: skip


def in_use() -> Law:
    """Return the catalogue's law and line, as this study writes them."""
    still, hits, college = (
        catalog.aerodynamics(name) for name in ("baseball-in-still-air", "baseball", "college-baseball")
    )
    line = usual_spin_line()
    per_spin = hits.drag_per_active_spin * KRPM
    return Law(
        roof=still.drag, open=hits.drag, college=college.drag, per_spin=per_spin, lift=hits.lift_scale,
        back=line.backspin[0] + 27 * line.backspin[1], back_angle=line.backspin[1], back_spray=line.backspin[2],
        side=line.sidespin[0], side_angle=line.sidespin[2], side_spray=line.sidespin[1],
        college_per_spin=college.drag_per_active_spin * KRPM - per_spin,
        college_lift=college.lift_scale - hits.lift_scale,
    )  # fmt: skip


TESTED: Mapping[str, tuple[str, ...]] = {
    "a term in speed": ("per_slowness",), "a term in density": ("per_thinness",),
    "a wind in or out at the college": ("wind_out",), "growth with spin of each ball": ("college_per_spin",),
    "lift of each ball": ("college_lift",), "both": ("college_per_spin", "college_lift"),
}  # fmt: skip


def main(arguments: Sequence[str] | None = None) -> int:
    """Fit, test what is shared, hold games out, check the law in use; return 1 where a bar is missed."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("folder", type=Path, nargs="?", help="folder of the public tables; none: made-up balls")
    options.add_argument("--balls", type=int, default=400, help="how many are made up")
    options.add_argument("--check", action="store_true", help="only the law in use and its bars")
    given = options.parse_args(arguments)
    if given.folder is None:
        balls = made_up(in_use(), np.random.default_rng(3), given.balls)
    else:
        balls = together(college_balls(college_rows(given.folder / COLLEGE)), read_league(given.folder / LEAGUE))
    if not given.check:
        fit = joint(balls)
        show("joint", fit)
        for name, (rate, error) in zip(("backspin", "sidespin"), lines_by_rates(balls), strict=True):
            print(
                f"by rate and axis alone, {name}:",
                ", ".join(f"{a:.0f} +- {b:.0f}" for a, b in zip(rate, error, strict=True)),
            )
        for title, extra in TESTED.items():
            show(f"with {title}", fitted(balls, (*USED, *extra), fit.law), fitted(balls, USED, fit.law))
        show("college alone", fitted(balls.where(balls.ball == 2), USED, fit.law))
        show("league alone, lift held", fitted(balls.where(balls.ball < 2), [n for n in USED if n != "lift"], fit.law))
        even = np.array([sum(game.encode()) % 2 == 0 for game in balls.game])
        for half, title in ((even, "even"), (~even, "odd")):
            fit = joint(balls.where(half), (*USED, "college_per_spin"))
            show(f"games of {title} number", fit)
            checked(balls.where(~half), fit.law, "  on the others")
    bars = checked(balls, in_use(), "the law in use, on all games")
    show_missed("bars missed", bars)
    if any(bar.missed and bar.name.startswith("college") for bar in bars):
        law, part = in_use(), drag_spread(catalog.aerodynamics("college-baseball"))
        for sign in (-1, 1):
            with redirect_stdout(io.StringIO()):
                others = checked(balls, replace(law, college=law.college * (1 + sign * part)), "")
            show_missed(f"with the college ball's level {sign:+d} standard error ({part:.1%}), bars missed", others)
    return int(any(bar.missed for bar in bars))


def show_missed(title: str, bars: Sequence[Bar]) -> None:
    """Print which of some bars are missed, and by how much."""
    missed = [bar for bar in bars if bar.missed]
    words = "; ".join(f"{bar.name}: {bar.value:+.2f} for {bar.most:g}" for bar in missed) or "none"
    print(f"{title}, {len(missed)} of {len(bars)}: {words}")


if __name__ == "__main__":
    raise SystemExit(main())

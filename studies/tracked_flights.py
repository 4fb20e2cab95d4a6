"""Compare flights with tables of tracked balls: ``python -m studies.tracked_flights FILES``.

Prints how distances come out by launch angle, what scatter of backspin line drives tell (all games, and halves of them
apart, each shown on the other), and, where a table has hang times, how flights agree with them and whether the bars are
met.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import polars as pl
from numpy.typing import NDArray
from scipy.optimize import brentq

from studies.measured_hang import hang_check
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import backspin_scatter
from sweetspot.flight.carry_scatter import TRACKED, CarryErrors, LaunchErrors, carry_errors
from sweetspot.flight.home_runs import USUAL
from sweetspot.seasons.balls import balls_of, fields_of
from sweetspot.seasons.flight_choice import FlightChoice
from sweetspot.seasons.flight_columns import GLOVE, FlightSetting, flown_balls
from sweetspot.seasons.pooling import REACHES
from sweetspot.seasons.rows import USED, rows_of
from sweetspot.seasons.season_table import season_setting
from sweetspot.seasons.table_file import open_table
from sweetspot.units import DEGREE, FOOT, MPH, RPM

Array = NDArray[np.float64]
CAUGHT = ["field_out", "sac_fly", "double_play", "sac_fly_double_play", "out", "sacrifice"]
LINERS = (10.0, 25.0)
"""deg: what the league calls line drives."""
LINERS_SCATTER = float(backspin_scatter(LINERS[0] * DEGREE))
"""rad/s; the scatter of backspin in use for most of them."""
BOOTSTRAPS = 40


def table_of(path: Path) -> pl.DataFrame:
    """Return the used rows of a table."""
    with TemporaryDirectory() as folder:
        table = open_table(path, staging=Path(folder))
        rows = rows_of(table.part(0, table.rows), table.headings)
    return rows.filter(pl.col("reason") == USED)


def compared(rows: pl.DataFrame, setting: FlightSetting) -> tuple[pl.DataFrame, NDArray[np.bool_]]:
    """Return balls of 80 mph and more with what their computed distance has too much, and which rows were caught."""
    balls = balls_of(rows)
    fields = fields_of(rows["home_team"] if "home_team" in rows.columns else [None] * len(rows), balls.season)
    flown = flown_balls(balls, fields, setting, airs=fields.airs(setting.air, rows))
    caught = rows["event"].str.to_lowercase().is_in(CAUGHT).fill_null(value=False).to_numpy()
    glove = caught * GLOVE / np.tan(np.maximum(flown.landing_angle, 0.05))
    scatter = np.array([*(USUAL.of(park)[1] for park in fields.parks), USUAL.open])[fields.index]
    found = pl.DataFrame({
        "speed": balls.exit_speed, "angle": balls.launch_angle / DEGREE, "bearing": balls.bearing / DEGREE,
        "left": balls.left, "long": flown.carry - glove - balls.distance, "per_drag": flown.carry_per_drag,
        "scatter": scatter, "caught": caught, "game": rows["game"],
        "roof": [fields.parks[index].roof == "fixed" if index >= 0 else False for index in fields.index.tolist()],
    })  # fmt: skip
    good = (balls.exit_speed >= 80 * MPH) & (balls.distance > 0) & np.isfinite(flown.carry)
    return found.filter(good), caught


def spin_scatter(balls: pl.DataFrame, launch: CarryErrors, spin: CarryErrors) -> float:
    """Return the standard deviation of backspin that makes distances scatter as they do, rad/s."""
    fast, steep = balls["speed"].to_numpy(), balls["angle"].to_numpy() * DEGREE
    long, per_drag = balls["long"].to_numpy(), balls["per_drag"].to_numpy()
    known = launch.spread(fast, steep, per_drag=per_drag, scatter=balls["scatter"].to_numpy()) ** 2
    of_spin = spin.spread(fast, steep, per_drag=np.zeros(len(fast)), scatter=np.zeros(len(fast))) ** 2

    def pull(size: float) -> float:
        variance = known + of_spin * size**2
        middle = np.sum(long / variance) / np.sum(1 / variance)
        return float(np.mean((long - middle) ** 2 / variance) - 1)

    return float(brentq(pull, 0, 4)) * LINERS_SCATTER if pull(0) > 0 else 0.0


def spins(balls: pl.DataFrame, setting: FlightSetting) -> None:
    """Print the scatter of backspin by all balls, halves of them, and its standard error."""
    liners = balls.filter(pl.col("angle").is_between(*LINERS))
    tables = [
        carry_errors(setting.ball, setting.aerodynamics, setting.air, errors=errors, spin_scatter=size)
        for errors, size in ((TRACKED, 0.0), (LaunchErrors(0.0, 0.0), LINERS_SCATTER))
    ]
    even = pl.col("game").cast(pl.Int64, strict=False) % 2 == 0
    for name, rows in (("all", pl.lit(value=True)), ("games of even number", even), ("of odd number", ~even),
                       ("roof", pl.col("roof")), ("open", ~pl.col("roof")),
                       ("caught", pl.col("caught")), ("not caught", ~pl.col("caught"))):  # fmt: skip
        mine = liners.filter(rows)
        if len(mine) > 50:
            print(f"  scatter of backspin, {name}: {spin_scatter(mine, *tables) / RPM:.0f} rpm, n {len(mine)}")
    games = liners.partition_by("game")
    random = np.random.default_rng(1)
    many = [
        spin_scatter(pl.concat([games[i] for i in random.integers(len(games), size=len(games))]), *tables)
        for _ in range(BOOTSTRAPS)
    ]
    print(f"  standard error by games drawn anew: {np.std(many) / RPM:.0f} rpm")
    for name, one, other in (("odd games, told by even ones", even, ~even), ("even, told by odd", ~even, even)):
        if len(liners.filter(one)) > 50 and len(liners.filter(other)) > 50:
            print(f"  {name}:")
            held_out(balls.filter(other), setting, spin_scatter(liners.filter(one), *tables))
    print("  by the scatter in use:")
    held_out(balls, setting, LINERS_SCATTER)
    held_out(balls.filter(~even), setting, LINERS_SCATTER)


def held_out(balls: pl.DataFrame, setting: FlightSetting, spin: float) -> None:
    """Print how many distances lie within the intervals that a scatter of backspin makes, which was set elsewhere."""
    for low, high in (LINERS, (15.0, 25.0)):
        mine = balls.filter(pl.col("angle").is_between(low, high))
        if mine.is_empty():
            continue
        told = carry_errors(setting.ball, setting.aerodynamics, setting.air, errors=TRACKED, spin_scatter=spin)
        spread = told.spread(
            mine["speed"].to_numpy(), mine["angle"].to_numpy() * DEGREE, per_drag=mine["per_drag"].to_numpy(),
            scatter=mine["scatter"].to_numpy(),
        )  # fmt: skip
        long = mine["long"].to_numpy()
        apart = np.abs(long - np.sum(long / spread**2) / np.sum(1 / spread**2)) / spread
        print(
            f"    with {spin / RPM:.0f} rpm, {low:g} to {high:g} deg: {100 * np.mean(apart < REACHES[50]):.1f} and "
            f"{100 * np.mean(apart < REACHES[90]):.1f} % within the intervals of 50 and 90 %, n {len(mine)}"
        )


def angles(balls: pl.DataFrame) -> None:
    """Print by how much computed distances are too long by launch angle, and how they scatter."""
    for low, high in pairwise((0, 4, 8, 12, 16, 20, 25, 30, 35, 40, 46)):
        here = pl.col("angle").is_between(low, high, closed="left")
        for name, rows in (("caught", pl.col("caught")), ("not caught", ~pl.col("caught"))):
            long = balls.filter(here & rows)["long"].to_numpy() / FOOT
            if len(long) > 9:
                print(f"  {low:2} to {high} deg, {name}: {long.mean():+5.1f} ft, SD {long.std():4.1f}, n {len(long)}")


def main(arguments: Sequence[str] | None = None) -> int:
    """Read, fly, compare; return 1 where a table with hang times misses a bar."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("files", type=Path, nargs="+", help="tables of tracked balls")
    options.add_argument("--temperature", type=float, default=72.0, help="degF, of balls that a table has none of")
    options.add_argument("--law", default=None, help="of drag and lift; none: the baseball's")
    options.add_argument("--drag", type=float, default=1.0, help="over that of the law")
    given = options.parse_args(arguments)
    air = Air(temperature=(given.temperature - 32) * 5 / 9)
    setting = replace(
        season_setting(contact=False, air=air, flights=FlightChoice(law=given.law, drag=given.drag)).flight, parks=False
    )
    missed = 0
    for path in given.files:
        rows = table_of(path)
        balls, caught = compared(rows, setting)
        print(f"{path.name}: {len(balls)} balls of 80 mph and more")
        angles(balls)
        if len(balls.filter(pl.col("angle").is_between(*LINERS))) > 50:
            spins(balls, setting)
        check = hang_check(rows, setting, caught=caught)
        if check is None:
            print("  no hang times")
            continue
        print(
            f"  hang times of {check.balls} balls: {check.hang_bias:+.3f} s (SD {check.hang_spread:.2f}); distance at "
            f"them {check.distance_bias / FOOT:+.1f} ft (SD {check.distance_spread / FOOT:.1f}); by sixths "
            + " ".join(f"{value / FOOT:+.1f}" for value in check.sixths)
        )
        print(f"  bars missed: {', '.join(check.missed) or 'none'}")
        missed += len(check.missed)
    return int(missed > 0)


if __name__ == "__main__":
    raise SystemExit(main())

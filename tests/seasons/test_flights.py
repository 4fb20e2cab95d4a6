"""Launch directions are solved for, drag does to a carry what the kernel says, and what is left over is told."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import polars as pl
from polars.testing import assert_frame_equal

from sweetspot.flight.aerodynamics import Aerodynamics
from sweetspot.flight.carry_scatter import MORE_DRAG, braked, usual_launch
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import STEP as FINE
from sweetspot.flight.kernel import flights
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.numerics.arrays import Array
from sweetspot.reports.quantities import US
from sweetspot.reports.season.words import left_over_words
from sweetspot.seasons.balls import balls_of, fields_of
from sweetspot.seasons.flight_columns import CLOSE, STEP, flown_balls
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.rows import rows_of
from sweetspot.seasons.season_drag import EDGES, left_over_by
from sweetspot.seasons.season_table import season_setting
from sweetspot.units import DEGREE, FOOT, MPH
from tests.seasons.conftest import made_up


def test_balls_set_out_so_that_they_come_down_where_they_did() -> None:
    """Flown anew as told, 997 of 1,000 land where they were tracked, and drag does to them what the table says.

    Agreement: the steps that a season takes against eight times as many, 0.02 ft for 99 of 100 carries.
    """
    frame = made_up(3000, seed=4)
    rows = rows_of(frame, headings_of(frame.columns))
    balls, setting = balls_of(rows), replace(season_setting(contact=False).flight, parks=False, threads=1)
    fields = fields_of(rows["home_team"], balls.season)
    airs = fields.airs(setting.air)
    found = flown_balls(balls, fields, setting, airs=airs)
    assert np.isfinite(found.launch_direction).mean() > 0.97  # choppers come down beside the plate
    launch = usual_launch(balls.exit_speed, balls.launch_angle, np.nan_to_num(found.launch_direction), left=balls.left)

    def flown(change: Callable[[Aerodynamics], Aerodynamics], step: float = FINE) -> tuple[Array, Array, Array]:
        """Carry, bearing and landing angle, each ball by the law of its park."""
        found = np.empty((3, len(balls)))
        for law, rows in fields.laws(setting.aerodynamics):
            velocity, spin = np.asarray(launch.velocity)[rows], np.asarray(launch.spin)[rows]
            own = BallMotions(velocity=velocity, spin=spin, position=launch.position)
            through = FlightConditions(ball=setting.ball, aerodynamics=change(law), air=airs.at(rows))
            one = flights(own, through, step=step, threads=1)
            found[:, rows] = one.carry, one.bearing, one.landing_angle
        return found[0], found[1], found[2]

    def same(law: Aerodynamics) -> Aerodynamics:
        return law

    (carry, bearing, _), (slower, _, _) = flown(same), flown(braked)
    known = np.isfinite(found.launch_direction)
    missed = np.abs(bearing - balls.bearing)[known]
    assert (missed < CLOSE).mean() > 0.997
    up = known & (balls.launch_angle > 0)
    coarse, fine = flown(same, STEP), flown(same, STEP / 8)
    off = np.abs(coarse[0] - fine[0])[known]
    assert np.quantile(off, 0.99) < 0.02 * FOOT and off.max() < 0.15 * FOOT
    off = np.abs(coarse[2] - fine[2])[known]
    assert off.max() < 0.1 * DEGREE
    exact = (slower - carry) / np.log1p(MORE_DRAG)
    off = np.abs(found.carry_per_drag - exact)[up]
    assert np.quantile(off, 0.99) < 0.6  # m, of 20 to 50


def test_what_distances_leave_over_is_put_into_words() -> None:
    """Balls of one park 3 m too long, steep ones of another 2 m too short; by exit speed nothing but chance."""
    rng = np.random.default_rng(3)
    count = 4000
    steep = rng.uniform(15, 45, count)
    park = np.array(["Here", "There"])[rng.integers(0, 2, count)]
    above = rng.normal(0, 1, count) + np.where(park == "Here", 3.0, -2.0 * (steep > 39))
    counted = pl.DataFrame({
        "launch_angle": steep * DEGREE, "exit_speed": rng.uniform(80, 112, count) * MPH, "park": park,
        "bearing": rng.uniform(-45, 45, count) * DEGREE, "carry_above": above,
    }).lazy()  # fmt: skip
    angle, speed, _, place = (
        sentence.read(US) for sentence in left_over_words({kind: left_over_by(counted, kind) for kind in EDGES})
    )
    assert angle.startswith("By launch angle: from +") and ("at 40° to" in angle or "at 44° to" in angle)
    assert speed.endswith(", which chance alone could do.")
    assert re.fullmatch(r"By park: from -1\.\d ± 0\.2 ft at There to \+9\.[789] ± 0\.1 ft at Here\.", place)


def test_what_is_left_over_is_the_same_to_the_last_digit_however_balls_lie_in_memory() -> None:
    rng = np.random.default_rng(4)
    frame = pl.DataFrame(
        {
            "park": np.array(["Here", "There", "Elsewhere", None])[rng.integers(0, 4, 90_000)],
            "launch_angle": rng.uniform(0, 1, 90_000),
            "carry_above": rng.normal(0, 8, 90_000),
        }
    )
    several = pl.concat([frame[start : start + 999] for start in range(0, len(frame), 999)], rechunk=False)
    for kind in ("park", "launch_angle"):
        assert left_over_by(frame.lazy(), kind) == left_over_by(several.lazy(), kind)
    told = (
        frame.drop_nulls()
        .group_by("park")
        .agg(mean=pl.col("carry_above").mean(), error=pl.col("carry_above").std() / pl.len().sqrt(), balls=pl.len())
    )
    assert_frame_equal(
        pl.DataFrame(left_over_by(frame.lazy(), "park")).drop("middle").rename({"name": "park"}),
        told.sort("mean"),
        check_dtypes=False,
        check_column_order=False,
        rel_tol=1e-10,
    )

"""How surely a carry is known: the table against drawn flights, its limits, and tracked balls."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl
import pytest

from sweetspot import catalog
from sweetspot.flight.air import Air
from sweetspot.flight.batted_spin import backspin_scatter
from sweetspot.flight.carry_scatter import (
    HOME_RUN,
    MORE_DRAG,
    TRACKED,
    LaunchErrors,
    braked,
    carry_errors,
    carry_spread,
    usual_launch,
)
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.kernel import flights
from sweetspot.flight.sweep import BattedBall
from sweetspot.numerics.arrays import Array
from sweetspot.seasons.season_table import analyse_season, season_setting
from sweetspot.units import DEGREE, MPH
from tests.real_data import real_file

AIR, SCATTER, DRAWS = Air(temperature=22.2), 0.065, 3000
HALF, MOST = 0.6745, 1.6449
"""Standard deviations within which 50 and 90 % of a normal distribution lie."""


def carried(speed: Array, angle: Array, spin: float | Array = 0.0, drag: float = 1.0) -> Array:
    law = catalog.aerodynamics()
    names = [name for name in type(law).model_fields if name.startswith("drag")]
    changed = law.replaced(**{name: getattr(law, name) * drag for name in names})
    nobody = np.zeros(len(speed))
    motions = usual_launch(speed, angle, nobody, left=nobody > 0, more_spin=spin)
    return flights(motions, FlightConditions(ball=catalog.ball(), aerodynamics=changed, air=AIR)).carry


def per_drag(speed: float, angle: float) -> float:
    fast, up = np.array([speed]), np.array([angle])
    motions = usual_launch(fast, up, np.zeros(1), left=np.zeros(1, bool))
    through = FlightConditions(ball=catalog.ball(), aerodynamics=braked(catalog.aerodynamics()), air=AIR)
    return float(((flights(motions, through).carry - carried(fast, up)) / np.log1p(MORE_DRAG))[0])


def told(speed: float, angle: float, errors: LaunchErrors = TRACKED, spin: float | None = None) -> float:
    table = carry_errors(catalog.ball(), catalog.aerodynamics(), AIR, errors=errors, spin_scatter=spin)
    found = table.spread(
        np.array([speed]), np.array([angle]), per_drag=np.array([per_drag(speed, angle)]), scatter=np.array([SCATTER])
    )
    return float(found[0])


@pytest.mark.parametrize(("speed", "angle"), [(95 * MPH, 15 * DEGREE), (100 * MPH, 20 * DEGREE), HOME_RUN])
def test_drawn_flights_scatter_as_told(speed: float, angle: float) -> None:
    """Launches and spins drawn with their errors, flown one by one; what is left of a home run's scatter is drag."""
    rng = np.random.default_rng(3)
    fast = speed + rng.normal(0, TRACKED.exit_speed, DRAWS)
    up = angle + rng.normal(0, TRACKED.launch_angle, DRAWS)
    launched = float(carried(fast, up, rng.normal(0, backspin_scatter(up), DRAWS)).std())
    table = carry_errors(catalog.ball(), catalog.aerodynamics(), AIR, errors=TRACKED)
    drag = per_drag(speed, angle) * np.sqrt(SCATTER**2 - table.home_run)
    assert told(speed, angle) == pytest.approx(np.hypot(launched, drag), rel=0.1)


def test_without_errors_only_drag_is_left_and_a_tracked_home_run_has_all_of_it() -> None:
    none = LaunchErrors(exit_speed=0.0, launch_angle=0.0)
    share = carry_errors(catalog.ball(), catalog.aerodynamics(), AIR, errors=none).home_run
    for speed, angle in ((95 * MPH, 15 * DEGREE), (90 * MPH, 38 * DEGREE), HOME_RUN):
        alone = abs(per_drag(speed, angle)) * np.sqrt(SCATTER**2 - share)
        assert told(speed, angle, none, 0.0) == pytest.approx(alone, rel=1e-9)
        assert told(speed, angle) > alone
    assert told(*HOME_RUN) == pytest.approx(abs(per_drag(*HOME_RUN)) * SCATTER, rel=0.02)


@pytest.mark.parametrize("angle", [14 * DEGREE, 28 * DEGREE, 40 * DEGREE])
def test_one_flight_and_a_season_scatter_by_one_rule(angle: float) -> None:
    """A ball hit alike, without measuring errors, by both: half of a difference against the slope, to 2 %."""
    hit = BattedBall(exit_speed=100 * MPH, launch_angle=angle)
    motion = hit.motion
    alone = carry_spread(
        motion,
        FlightConditions(ball=catalog.ball(), aerodynamics=catalog.aerodynamics(), air=AIR),
        drag_scatter=SCATTER,
    )
    assert alone == pytest.approx(told(100 * MPH, angle, LaunchErrors(0.0, 0.0)), rel=0.02)


def test_tracked_distances_fall_into_the_intervals(tmp_path: Path) -> None:
    """Flies as the intervals say; the distances of liners scatter a fifth less than rates and hang times ask for.

    A glove ends the long and the short ones near one another; 90 % intervals of them hold 93 to 97 %.
    """
    tracked = real_file("savant_2022_contact_sample.csv.gz")
    season = analyse_season([tracked], setting=season_setting(contact=False), folder=tmp_path)
    balls = season.balls().filter((pl.col("carry_spread_ft") > 0) & (pl.col("hit_distance_sc") > 150))
    table = balls.select(
        "launch_angle", odd=pl.col("game_pk") % 2 == 1, off=(pl.col("carry_above_ft") / pl.col("carry_spread_ft")).abs()
    )
    known = table.drop_nulls().collect()
    for low, high, least, half, most in ((15, 25, 200, 0.67, 0.98), (25, 40, 500, 0.6, 0.95)):
        here = (pl.col("launch_angle") >= low) & (pl.col("launch_angle") < high)
        mine = known.filter(here & (pl.col("odd") | (low >= 25)))["off"].to_numpy()
        assert len(mine) > least
        assert 0.44 < (mine < HALF).mean() < half
        assert 0.87 < (mine < MOST).mean() < most

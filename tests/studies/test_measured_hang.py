"""Hang times: the usual names are read, and flights are compared at the measured moment."""

from __future__ import annotations

import numpy as np
import polars as pl
import pytest

from studies.measured_hang import HangCheck, hang_check
from sweetspot.seasons.headings import headings_of
from sweetspot.seasons.rows import rows_of
from sweetspot.seasons.season_table import season_columns, season_setting
from sweetspot.units import FOOT

SETTING = season_setting(contact=False)
COUNT = 400


def flies(extra: float = 0.0, factor: float = 1.0) -> pl.DataFrame:
    """Return made-up flies whose tracked distances and hang times are our own, but for what is put in."""
    rng = np.random.default_rng(5)
    table = pl.DataFrame({
        "launch_speed": rng.uniform(85, 108, COUNT), "launch_angle": rng.uniform(20, 42, COUNT),
        "stand": rng.choice(["R", "L"], COUNT), "hc_x": 125.42 + 60 * rng.uniform(-1, 1, COUNT),
        "hc_y": np.full(COUNT, 70.0), "game_date": ["2024-05-01"] * COUNT,
    })  # fmt: skip
    flown = season_columns(table, setting=SETTING).collect()
    return table.with_columns(hit_distance_sc=flown["carry_ft"] * factor, hang_time=flown["hang_time_s"] + extra)


def checked(table: pl.DataFrame, *, caught: bool = False) -> HangCheck | None:
    rows = rows_of(table, headings_of(table.columns))
    return hang_check(rows, SETTING.flight, caught=np.full(len(rows), caught))


def test_our_own_flights_pass_and_what_is_put_in_comes_out() -> None:
    own = checked(flies())
    assert own is not None and own.balls == COUNT and not own.missed
    assert abs(own.hang_bias) < 1e-3 and abs(own.distance_bias) < 0.05 and own.distance_spread < 0.1
    late = checked(flies(extra=-0.2))
    assert late is not None and late.hang_bias == pytest.approx(0.2, abs=1e-3)
    assert late.distance_bias < -3 and {"hang_bias", "distance_bias"} <= set(late.missed)  # 0.2 s of 20 m/s too early
    short = checked(flies(factor=0.98))
    assert short is not None and abs(short.hang_bias) < 1e-3
    assert short.distance_bias == pytest.approx(0.02 * 340 * FOOT, abs=0.5) and "distance_bias" in short.missed
    assert np.nanmax(np.abs(np.array(short.sixths) - short.distance_bias)) < 0.5
    caught = checked(flies(), caught=True)
    assert caught is not None and -0.12 < caught.hang_bias < -0.04  # 5 ft of fall


@pytest.mark.parametrize("name", ["hang_time", "HangTime", "hangtime", "hit_hang_time", "hang_time_s"])
def test_usual_names_of_hang_time(name: str) -> None:
    for speed, angle in (("launch_speed", "launch_angle"), ("ExitSpeed", "Angle"), ("exit_speed_mph", "angle_deg")):
        column = headings_of([speed, angle, name]).columns["hang_time"]
        assert (column.heading, column.factor) == (name, 1.0)


def test_without_hang_times_nothing_is_said() -> None:
    assert checked(flies().drop("hang_time")) is None

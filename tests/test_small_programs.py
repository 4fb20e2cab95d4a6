"""The programs that people write first, short: frames in, frames out, and nothing to look up."""

from __future__ import annotations

from typing import Any

import numpy as np
import polars as pl
import pytest

import sweetspot
from sweetspot.units import MPH, OUNCE

door: Any = sweetspot
"""The same without its types: names, texts and columns are taken everywhere."""


def test_many_bats_to_a_frame() -> None:
    bats = [door.bat("r161-ash").with_mass(ounces * OUNCE) for ounces in (29, 31)]
    frame = pl.concat(door.report(bat).to_frame("us") for bat in bats)
    speeds = frame["best_hit.exit_speed_mph"]
    assert len(frame) == 2 and speeds[1] > speeds[0] > 95


def test_many_hits_on_columns() -> None:
    """Half a millisecond of processor each would take a minute; all together take none."""
    speeds = pl.Series(np.linspace(60, 90, 100_000) * MPH)
    found = door.hits("r161-ash", position="27 in", closing_speed=speeds.to_numpy() + 70 * MPH)
    assert len(found.collision_efficiency) == 100_000 and np.ptp(found.collision_efficiency) > 0.01


def test_flights_of_a_frame_with_a_hole() -> None:
    frame = pl.DataFrame({"speed": [100.0, None, 90.0], "angle": [28.0, 25.0, 30.0]})
    balls = door.batted_ball(
        speed=frame["speed"].to_numpy() * MPH, launch_angle=np.radians(frame["angle"].to_numpy()), backspin="2200 rpm"
    )
    carry = door.trajectory(balls, door.standard_flight()).carry
    assert carry[0] > carry[2] > 90 and np.isnan(carry[1])


def test_what_is_not_known() -> None:
    hit = door.hit("r161-ash", at="6in-from-tip", bat_speed="70 mph ± 2 mph", uncertainty=True)
    table, shares = hit.to_dict("us"), hit.uncertainty
    assert table["exit_speed_low_mph"] < table["exit_speed_mph"] < table["exit_speed_high_mph"]
    assert shares is not None and shares.shares["swing"] > 0


def test_a_pitch_that_is_hit() -> None:
    home = door.play("r161-ash", pitch="curve", park="fenway", bat_speed="75 mph")
    assert home.flight is not None and home.flight.carry > 90
    assert home.to_frame("us")["exit_speed_mph"].item() == pytest.approx(float(home.exit_speed or 0) / MPH)

"""A table's weather is the air that all of a ball's answers are told in, those of its home runs too."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import polars as pl
import pytest
from polars.testing import assert_frame_equal

from sweetspot.cli import main
from sweetspot.flight.air import USUAL_AIR
from sweetspot.seasons.season_table import season_columns, season_setting
from sweetspot.tables.headings import GivenColumns
from tests.seasons.conftest import made_up

COLUMNS = {
    "temperature_degC": ("temperature", 1.0, (4.0, 12.0, 22.2, 35.0)),
    "pressure_hPa": ("pressure", 100.0, (985.0, 1013.0, 1040.0)),
    "humidity_%": ("humidity", 0.01, (0.0, 40.0, 100.0)),
    "elevation_m": ("elevation", 1.0, (0.0, 500.0, 1600.0)),
}
ANSWERS = ("carry_ft", "home_run_here", "home_runs_in_30", "home_run_parks")
OPTIONS = {
    "temperature_f": ("--temperature", "48", "48degF"),
    "pressure_hPa": ("--pressure", "1031", "1031hPa"),
    "humidity_%": ("--humidity", "90", "0.9"),
    "elevation_ft": ("--elevation", "4000", "4000ft"),
}


@pytest.mark.parametrize("heading", COLUMNS)
def test_a_column_of_one_value_says_what_the_setting_says(heading: str) -> None:
    """To the last digit, in every column, in known parks and in unknown ones."""
    name, size, values = COLUMNS[heading]
    frame = made_up(400, seed=6).with_columns(home_team=pl.col("home_team").replace("COL", "NOWHERE"))
    for value in values:
        column = season_columns(frame.with_columns(pl.lit(value).alias(heading)), setting=season_setting())
        air = USUAL_AIR.replaced(**{name: value * size})
        setting = season_columns(frame, setting=season_setting(air=air))
        assert_frame_equal(column.drop(heading).collect(), setting.collect(), check_exact=True)


@pytest.mark.parametrize("heading", COLUMNS)
@pytest.mark.parametrize("club", ["CHC", None])
def test_thinner_air_never_takes_a_home_run_away(heading: str, club: str | None) -> None:
    """Of one ball through ever thinner air each chance grows with the carry; a known park keeps its elevation."""
    _, _, values = COLUMNS[heading]
    thinner = sorted(values, reverse=heading == "pressure_hPa")
    count = len(thinner)
    frame = pl.DataFrame({
        "launch_speed": [103.0] * count, "launch_angle": [28.0] * count, "bearing_deg": [0.0] * count,
        "home_team": pl.Series([club] * count, dtype=pl.String), heading: thinner,
    })  # fmt: skip
    found = season_columns(frame, setting=season_setting(contact=False)).select(ANSWERS).collect()
    signs = {name: {*np.sign(np.diff(found[name].to_numpy()))} for name in (ANSWERS if club else ("carry_ft",))}
    grows = {0.0} if heading == "elevation_m" and club else {1.0}
    assert signs.pop("home_run_parks", grows) <= grows | {0.0}
    assert signs == dict.fromkeys(signs, grows)


def test_weather_moves_chances_as_far_as_measured() -> None:
    """From 40 to 95 degF at Wrigley the ball of 103 mph gains two home runs in ten, as flown park by park."""
    from sweetspot import catalog
    from sweetspot.flight.carry_scatter import usual_launch
    from sweetspot.flight.conditions import FlightConditions
    from sweetspot.flight.home_runs import home_run_chances
    from sweetspot.units import MPH

    degrees = np.array([40.0, 60.0, 72.0, 95.0])
    frame = pl.DataFrame({
        "launch_speed": [103.0] * 4, "launch_angle": [28.0] * 4, "direction_deg": [0.0] * 4, "home_team": ["CHC"] * 4,
        "game_date": ["2025-06-01"] * 4, "temperature_f": degrees,
    })  # fmt: skip
    found = season_columns(
        frame, setting=season_setting(contact=False), given=GivenColumns({"launch_direction": "direction_deg:deg"})
    ).collect()
    park = catalog.park("CHC", 2025)
    ball = usual_launch(np.array([103 * MPH]), np.radians([28.0]), np.zeros(1), left=np.zeros(1, bool))
    alone = [
        home_run_chances(
            ball,
            FlightConditions(
                ball=catalog.ball(),
                aerodynamics=catalog.aerodynamics(),
                air=USUAL_AIR.replaced(temperature=(one - 32) / 1.8),
            ),
            parks=[park],
        ).chance[0, 0]
        for one in degrees
    ]
    assert found["home_run_here"].to_numpy() == pytest.approx(alone, abs=0.005)
    assert 0.15 < alone[-1] - alone[0] < 0.3


@pytest.mark.parametrize("heading", OPTIONS)
def test_each_column_has_its_option(heading: str, tmp_path: Path) -> None:
    option, written, typed = OPTIONS[heading]
    frame = made_up(60, seed=2).with_columns(home_team=pl.col("home_team").replace("COL", "NOWHERE"))
    frame.write_csv(tmp_path / "plain.csv")
    frame.with_columns(pl.lit(written).alias(heading)).write_csv(tmp_path / "column.csv")
    told = {}
    for name, more in (("plain", [option, typed]), ("column", [])):
        with pytest.raises(SystemExit, match=r"^0$"):
            main(["season", str(tmp_path / f"{name}.csv"), "--flight-only", "--out", str(tmp_path / name), *more])
        told[name] = pl.read_parquet(tmp_path / name / "balls").drop("table")
    assert_frame_equal(told["column"].drop(heading), told["plain"], check_exact=False, rel_tol=1e-5)
    assert told["plain"]["carry_ft"].count() > 50

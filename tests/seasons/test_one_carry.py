"""A ball has one flight: a table says of it what `fly` says, under a roof too, and words follow its chances."""

from __future__ import annotations

import polars as pl
import pytest

from sweetspot import catalog
from sweetspot.answers.fly import FlyQuestion, fly_answer
from sweetspot.catalog.aerodynamic_laws import aerodynamics
from sweetspot.flight.air import USUAL_AIR
from sweetspot.flight.fence import landing
from sweetspot.flight.sweep import BattedBall
from sweetspot.reports.document import Paragraph
from sweetspot.reports.flight.document import fly_document
from sweetspot.reports.quantities import US
from sweetspot.reports.sentences import Sentence
from sweetspot.seasons.season_table import season_columns, season_setting
from sweetspot.units import DEGREE, FOOT, MPH


@pytest.mark.parametrize(("club", "name", "year"), [
    ("CHC", "wrigley", 2025), ("BOS", "fenway", 2025), ("TB", "tropicana", 2023), ("COL", "coors", 2025),
    ("HOU", "daikin", 2025),
])  # fmt: skip
def test_a_table_says_what_fly_says_of_the_same_ball(club: str, name: str, year: int) -> None:
    """Agreement: the direction of the launch is solved to 0.03 degrees, steps are 0.4 s for 0.2, chances 0.01."""
    park = catalog.park(name)
    frame = pl.DataFrame({
        "launch_speed": [103.0], "launch_angle": [28.0], "bearing_deg": [0.0], "stand": ["R"], "home_team": [club],
        "game_date": [f"{year}-06-01"],
    })  # fmt: skip
    row = season_columns(frame, setting=season_setting(contact=False)).collect().row(0, named=True)
    hit = BattedBall(
        exit_speed=103 * MPH,
        launch_angle=28 * DEGREE,
        bearing=0.0,
        temperature=USUAL_AIR.temperature,
        elevation=park.elevation,
    )
    flown = fly_answer(FlyQuestion(hit, catalog.ball(), catalog.sport("baseball"), aerodynamics(), park))
    flight = flown.flight
    assert row["carry_ft"] == pytest.approx(flight.carry / FOOT, abs=0.2)
    assert row["hang_time_s"] == pytest.approx(flight.hang_time, abs=0.005)
    assert row["apex_ft"] == pytest.approx(flight.apex_height / FOOT, abs=0.2)
    assert row["home_run_here"] == pytest.approx(flown.home_run_chance, abs=0.01)


def test_no_home_run_is_called_one_that_has_a_chance_below_a_half() -> None:
    """The mean ball passes 29 in over the fence of Wrigley Field, and 48 of a hundred like it go out."""
    park = catalog.park("wrigley")
    hit = BattedBall(
        exit_speed=104 * MPH, launch_angle=28 * DEGREE, bearing=0.0, temperature=22.2, elevation=park.elevation
    )
    flown = fly_answer(FlyQuestion(hit, catalog.ball(), catalog.sport("baseball"), aerodynamics(), park))
    assert flown.home_run_chance is not None and flown.out_in is not None
    assert landing(flown.flight.positions, park).outcome == "home run" and 0.2 < flown.home_run_chance < 0.5
    first = fly_document(flown).blocks[0]
    assert isinstance(first, Paragraph) and isinstance(first.words, Sentence)
    said = first.words.read(US)
    assert "top: such balls stay in more often than not" in said and "home run." not in said.split("likelier")[0]
    counted = season_columns(
        pl.DataFrame({"launch_speed": [104.0], "launch_angle": [28.0], "bearing_deg": [0.0], "home_team": ["CHC"]}),
        setting=season_setting(contact=False),
    ).collect()
    assert abs(flown.out_in - counted["home_run_parks"][0]) <= 1  # thirty parks at once are right to two points

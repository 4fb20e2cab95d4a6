"""Balls fly with their season's own drag, law and field, as far as tables or people tell them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from sweetspot.answers.season import season_answer
from sweetspot.answers.season_question import SeasonQuestion
from sweetspot.catalog.ballparks import fenced_field
from sweetspot.cli import main
from sweetspot.errors import InputError
from sweetspot.seasons.flight_choice import FlightChoice
from sweetspot.seasons.season_table import Season, analyse_season, season_columns, season_setting
from sweetspot.units import FOOT

COUNT = 600


def _hits(seed: int = 1) -> pl.DataFrame:
    rng = np.random.default_rng(seed)
    return pl.DataFrame({
        "game_pk": np.arange(COUNT) // 30, "launch_speed": rng.uniform(90, 110, COUNT),
        "launch_angle": rng.uniform(20, 40, COUNT), "bearing_deg": rng.uniform(-40, 40, COUNT),
        "events": ["field_out"] * COUNT,
    })  # fmt: skip


def _tracked(drag: float) -> pl.DataFrame:
    """Return hits with the distances that they carry with so much drag over the law's, caught at a glove."""
    flown = season_columns(_hits(), setting=season_setting(contact=False, flights=FlightChoice(drag=drag))).collect()
    short = pl.when(pl.col("home_run_parks") > 0).then(0.0).otherwise(5 / pl.col("landing_angle_deg").radians().tan())
    noise = pl.Series(np.random.default_rng(2).normal(0, 8, COUNT))
    return _hits().with_columns(hit_distance_sc=flown.select(pl.col("carry_ft") - short).to_series() + noise)


def _season(frame: pl.DataFrame, folder: Path, **options: Any) -> Season:
    folder.mkdir(exist_ok=True)
    frame.write_parquet(folder / "table.parquet")
    setting = season_setting(contact=False, flights=FlightChoice(**options))
    return analyse_season([folder / "table.parquet"], setting=setting, folder=folder / "out")


@pytest.mark.parametrize("drag", [0.93, 1.0, 1.08])
def test_the_drag_of_the_distances_is_the_one_that_balls_fly_with(drag: float, tmp_path: Path) -> None:
    season = _season(_tracked(drag), tmp_path)
    assert season.own_drag is not None and season.own_drag.error < 0.006
    assert season.own_drag.drag == pytest.approx(drag, abs=4 * season.own_drag.error)
    setting = season_setting(contact=False, flights=FlightChoice(drag=drag))
    wanted = season_columns(_hits(), setting=setting).collect()["carry_ft"]
    carry = season.balls().select("carry_ft").collect()["carry_ft"]
    assert float((carry - wanted).abs().max()) < 5.0  # type: ignore[arg-type]


def test_a_given_drag_counts_and_few_or_foreign_distances_do_not(tmp_path: Path) -> None:
    frame = _tracked(1.08)
    given = _season(frame, tmp_path / "given", drag=1.0)
    assert given.own_drag is None and given.setting.flight.drag == 1.0
    assert _season(frame.head(10), tmp_path / "few").own_drag is None
    picked_up = frame.with_columns(hit_distance_sc=pl.col("hit_distance_sc") * 0.5)
    assert _season(picked_up, tmp_path / "foreign").own_drag is None
    gone = frame.with_columns(events=pl.lit("home_run"))
    assert _season(gone, tmp_path / "selected").own_drag is None


def test_few_distances_move_the_drag_less(tmp_path: Path) -> None:
    few, many = _season(_tracked(1.08).head(30), tmp_path / "few"), _season(_tracked(1.08), tmp_path / "many")
    assert few.own_drag is not None and many.own_drag is not None
    assert few.own_drag.error > 2 * many.own_drag.error
    pulls = [np.log(one.drag) / np.log(one.measured.drag) for one in (few.own_drag, many.own_drag)]
    assert 0 < pulls[0] < pulls[1] < 1


def test_a_park_by_option_and_by_column_are_one(tmp_path: Path) -> None:
    option = season_columns(
        _hits(), setting=season_setting(contact=False, flights=FlightChoice(park="wrigley"))
    ).collect()
    named = _hits().with_columns(ballpark=pl.lit("Wrigley Field"))
    column = season_columns(named, setting=season_setting(contact=False)).collect()
    for name in ("carry_ft", "home_run_here", "home_runs_in_30"):
        assert option[name].equals(column[name])
    assert option["home_run_here"].null_count() == 0
    unknown = named.with_columns(ballpark=pl.lit("Nowhere"), home_team=pl.lit("CHC"))
    fallen_back = season_columns(unknown, setting=season_setting(contact=False)).collect()
    assert fallen_back["home_run_here"].equals(option["home_run_here"])


def test_a_nearer_fence_gives_more_home_runs_and_a_softball_no_thirty_parks() -> None:
    near, far = (
        season_columns(
            _hits(),
            setting=season_setting(
                contact=False,
                flights=FlightChoice(park=fenced_field([d * FOOT, (d + 60) * FOOT, d * FOOT], height=2.4)),
            ),
        ).collect()["home_run_here"]
        for d in (300, 340)
    )
    assert bool((near >= far - 1e-6).all()) and float(near.sum()) > 1.5 * float(far.sum())
    softball = season_columns(
        _hits(),
        setting=season_setting(contact=False, flights=FlightChoice(ball="softball-12in-fast", park="fast-pitch")),
    ).collect()
    assert softball["home_runs_in_30"].null_count() == softball["home_run_parks"].null_count() == COUNT
    assert softball["home_run_here"].null_count() == 0


def test_refused_options(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    _hits().write_csv(tmp_path / "table.csv")
    with pytest.raises(InputError, match=r"drag was given as 3 of the law's; allowed is 0\.5 to 2"):
        season_answer(SeasonQuestion(paths=[tmp_path / "table.csv"], flights=FlightChoice(drag=3.0)))
    for options, words in (
        (["--park", "coors", "--fence", "330ft,400ft,330ft"], "--park and --fence were both given"),
        (["--fence-height", "10ft"], "--fence-height was given without --fence"),
        (["--fence", "330ft"], "a fence needs two distances or more"),
    ):
        with pytest.raises(SystemExit, match=r"^2$"):
            main(["season", str(tmp_path / "table.csv"), "--flight-only", *options])
        assert words in capsys.readouterr().err

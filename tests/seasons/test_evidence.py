"""Seasons made up by the kernels themselves, with known truth: what is said of them holds as often as it is said to."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import polars as pl
import pytest

from sweetspot import catalog
from sweetspot.collision.contact_table import SPEED_ERROR
from sweetspot.collision.hit_in_space import Contact, strikes
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.flight.air import Air
from sweetspot.flight.conditions import FlightConditions
from sweetspot.flight.home_runs import USUAL, home_run_chances
from sweetspot.motion.ball_motion import BallMotions
from sweetspot.motion.swing_path import Swings, path_axes
from sweetspot.seasons.made_up import LIKE_THE_LEAGUE, MadeSeason, made_season
from sweetspot.seasons.plane_hits import PLACES, USUAL_TURN, bat_in_plane, hit_towards
from sweetspot.seasons.pooling import pooled, spread_of
from sweetspot.seasons.season_drag import drag_by_month, home_runs_with
from sweetspot.seasons.season_table import Season, analyse_season, season_setting
from sweetspot.seasons.standings import all_standings
from sweetspot.units import INCH, MPH, RPM
from tests.real_data import real_file

BAT = "r161-ash"


@pytest.fixture(scope="module")
def made() -> pl.DataFrame:
    return made_season(catalog.bat(BAT), MadeSeason(players=40, balls=110))


@pytest.fixture(scope="module")
def answered(tmp_path_factory: pytest.TempPathFactory) -> Callable[[pl.DataFrame], Season]:
    setting = season_setting(bats={"": BAT}, others=("mlb-a",))

    def run(frame: pl.DataFrame) -> Season:
        folder = tmp_path_factory.mktemp("made")
        frame.write_parquet(folder / "made.parquet")
        return analyse_season([folder / "made.parquet"], setting=setting, folder=folder / "out")

    return run


@pytest.fixture(scope="module")
def season(made: pl.DataFrame, answered: Callable[[pl.DataFrame], Season]) -> Season:
    return answered(made)


@pytest.fixture(scope="module")
def balls(season: Season) -> pl.DataFrame:
    return season.balls().filter(pl.col("contact_outcome") == "ok").collect()


def number(value: Any) -> float:
    """Return what polars gives as a number."""
    return float(value)


def covered(truth: pl.Series, low: pl.Series, high: pl.Series) -> float:
    return number(((truth >= low) & (truth <= high)).mean())


def test_intervals_of_the_place_hold_as_often_as_they_say(balls: pl.DataFrame) -> None:
    for name, truth in (
        ("from_tip", balls["true_from_tip_in"]),
        ("from_best", (balls["true_from_tip_in"] - balls["best_from_tip_in"]).abs()),
    ):
        half = covered(truth, balls[f"{name}_low50_in"], balls[f"{name}_high50_in"])
        most = covered(truth, balls[f"{name}_low90_in"], balls[f"{name}_high90_in"])
        assert 0.47 < half < 0.54, name
        assert 0.88 < most < 0.93, name


def test_intervals_of_small_tables_hold_too(answered: Callable[[pl.DataFrame], Season]) -> None:
    """Four clubs of eight batters: what a few hundred balls leave open of the relation is in the interval."""
    told = []
    for seed in (1, 2, 3, 4):
        club = made_season(catalog.bat(BAT), MadeSeason(players=8, balls=60), seed=seed)
        told.append(answered(club).balls().filter(pl.col("contact_outcome") == "ok").collect())
    place = pl.col("true_from_tip_in")
    held = [
        number(
            pl.concat(told)
            .select(place.is_between(f"from_tip_low{level}_in", f"from_tip_high{level}_in").mean())
            .item()
        )
        for level in (50, 90)
    ]
    assert held[0] == pytest.approx(0.5, abs=0.05)
    assert held[1] == pytest.approx(0.9, abs=0.03)  # 0.85 where learned weights count as known


def test_offsets_hold_as_often_as_they_say(balls: pl.DataFrame) -> None:
    off = (balls["offset_in"] - balls["true_offset_in"]) / balls["offset_spread_in"]
    assert abs(number(off.median())) < 0.1
    assert 0.45 < number((off.abs() < 0.6745).mean()) < 0.55
    assert 0.86 < number((off.abs() < 1.6449).mean()) < 0.93


def test_the_side_of_the_bat_is_told_with_right_chances(balls: pl.DataFrame) -> None:
    tip = balls["true_from_tip_in"] < balls["best_from_tip_in"]
    for low in (0.0, 0.2, 0.4, 0.6, 0.8):
        mine = (balls["tip_side"] >= low) & (balls["tip_side"] <= low + 0.2)
        expected = balls["tip_side"].filter(mine).mean()
        assert number(tip.filter(mine).mean()) == pytest.approx(expected, abs=0.07)


def test_what_was_put_in_is_learnt(season: Season) -> None:
    assert season.setting.contact is not None
    relation = season.setting.contact.relation
    assert relation.weights[1] / 0.3 == pytest.approx(-0.25, rel=0.1)
    assert relation.spread == pytest.approx(np.hypot(1.8, 0.4) * INCH, rel=0.08)
    assert abs(relation.level) < 0.006
    assert relation.noise < 2.5 * MPH


def test_without_the_pitch_s_place_nobody_knows_the_side(
    made: pl.DataFrame, answered: Callable[[pl.DataFrame], Season]
) -> None:
    """A permutation test: pitches dealt out anew tell nothing, and nothing is what is made of them."""
    dealt = made.with_columns(made.select("plate_x", "plate_z").sample(fraction=1.0, shuffle=True, seed=3))
    season = answered(dealt)
    assert season.setting.contact is not None
    assert abs(season.setting.contact.relation.weights[1]) < 0.25 * 0.25 * 0.3 * 2
    balls = season.balls().filter(pl.col("contact_outcome") == "ok").collect()
    truth = balls["true_from_tip_in"]
    assert 0.85 < covered(truth, balls["from_tip_low90_in"], balls["from_tip_high90_in"]) < 0.94
    assert number(balls["tip_side"].std()) < 0.25


def test_no_pile_up_at_the_best_place_for_balls_above_a_ceiling(balls: pl.DataFrame) -> None:
    above = balls.filter(pl.col("squared_up_ratio") > 1.0)
    assert len(above) > 50
    assert number(above["from_best_in"].min()) > 0.1
    assert 0.05 < number(above["above_improbable"].mean()) < 0.5


def test_another_bat_by_the_kernel_itself(made: pl.DataFrame, season: Season) -> None:
    """On average over a season, as far as the swing law's own exponent says."""
    own, other = catalog.bat(BAT), catalog.bat("mlb-a")
    ball, law = catalog.ball(), catalog.swing_law()
    models = [reduced_bat(bat, ball=ball) for bat in (own, other)]
    moi = [model.body.moi(model.bat.choke + law.axis) for model in models]
    ratio = law.speed_ratio(moi[1], reference_moi=moi[0])
    place, offset = made["true_from_tip_in"].to_numpy() * INCH, made["true_offset_in"].to_numpy() * INCH
    speed, speeds = np.full(len(made), 71.5 * MPH), []
    for model, factor in zip(models, (1.0, ratio), strict=True):
        bat = model.bat
        omega = factor * speed / (own.length - own.choke - 6 * INCH)
        there = omega * (bat.length - bat.choke - place)
        struck = strikes(
            model,
            ball=ball,
            swings=Swings(there, path_axes(0.15, 0.0, tilt=0.55, left=False), bat.choke),
            pitches=BallMotions(velocity=(0.0, -36.8, -4.3), spin=np.zeros(3)),
            contact=Contact(bat.length - place, offset),
        )
        speeds.append(struck.exit_speed)
    truth = float(np.nanmean(speeds[1] - speeds[0])) / MPH
    told = season.balls().select(gain=pl.col("exit_speed_with_mlb_a_mph") - pl.col("launch_speed")).collect()["gain"]
    assert number(told.mean()) == pytest.approx(truth, abs=0.35)


def test_drag_that_was_put_in_is_found(answered: Callable[[pl.DataFrame], Season]) -> None:
    found = []
    for drag in (1.0, 1.06):
        frame = made_season(catalog.bat(BAT), MadeSeason(players=20, balls=150, drag=drag), seed=5)
        season = answered(frame.drop("bat_speed"))
        found.append(drag_by_month(season.counted(), flown_with=season.setting.flight.drag or 1.0)[0])
    change = found[1].drag / found[0].drag
    error = np.hypot(found[0].error, found[1].error)
    assert change == pytest.approx(1.06, abs=3 * error)
    assert error < 0.02


def test_reliability_is_the_correlation_of_two_halves(season: Season) -> None:
    counted = season.counted().collect()
    _, spread = pooled(counted, key="batter", measure="bat_speed")
    halves = [
        counted.gather_every(2, first).group_by("batter").agg(pl.col("bat_speed").mean(), balls=pl.len()).sort("batter")
        for first in (0, 1)
    ]
    found = float(np.corrcoef(halves[0]["bat_speed"], halves[1]["bat_speed"])[0, 1])
    assert found == pytest.approx(float(spread.reliability(number(halves[0]["balls"].mean()))), abs=0.1)


def test_players_who_differ_like_the_league_s_are_told_apart_better_than_by_its_rate(
    answered: Callable[[pl.DataFrame], Season],
) -> None:
    """At 34 balls of 209 players the league's numbers are 0.43, 0.23 and 0.52; one such league scatters by 0.05."""
    frame = made_season(catalog.bat(BAT), LIKE_THE_LEAGUE, seed=3)
    counted = answered(frame.filter(pl.int_range(pl.len()).over("batter") < 68)).counted().collect()
    found = {
        name: float(pooled(counted, key="batter", measure=name)[1].reliability(34.0))
        for name in ("exit_speed", "league_squared_up", "blast", "squared_up_ratio")
    }
    for name, published in (("exit_speed", 0.43), ("league_squared_up", 0.23), ("blast", 0.52)):
        assert found[name] == pytest.approx(published, abs=0.1), name
    own = found["squared_up_ratio"]
    assert own == pytest.approx(0.34, abs=0.08) and own > found["league_squared_up"] + 0.03
    turn = counted.with_columns(turn=pl.int_range(pl.len()).over("batter") % 2)
    halves = turn.group_by("batter").agg(
        pl.col("squared_up_ratio").filter(pl.col("turn") == half).mean().alias(str(half)) for half in (0, 1)
    )
    assert float(np.corrcoef(halves["0"], halves["1"])[0, 1]) == pytest.approx(own, abs=0.12)


def test_on_time_and_perfect_are_the_league_s(tmp_path: Path) -> None:
    """Every third ball is met when it usually is, every third 8 ms earlier; of the others nothing is told."""
    speed = 0.92 * 90 * MPH  # at the plate
    usual, late = ((0.018 + seconds) * speed / 0.92 / INCH for seconds in (0.0, 0.008))
    frame = made_season(catalog.bat(BAT), MadeSeason(players=3, balls=60)).with_columns(release_speed=pl.lit(90.0))
    where = pl.int_range(pl.len()) % 3
    name = "intercept_ball_minus_batter_pos_y_inches"
    frame = frame.with_columns(pl.when(where == 0).then(usual).when(where == 1).then(late).alias(name))
    frame.write_parquet(tmp_path / "made.parquet")
    counted = analyse_season([tmp_path / "made.parquet"], folder=tmp_path / "out").counted().collect()
    third = np.arange(len(counted)) % 3
    on_time, perfect = (counted[column].fill_null(-1.0).to_numpy() for column in ("on_time", "perfect"))
    assert [set(on_time[third == number].tolist()) for number in range(3)] == [{1.0}, {0.0}, {-1.0}]
    both = (counted["centred"] * counted["lined_up"]).fill_null(-1.0).to_numpy()
    assert np.array_equal(perfect[third == 0], both[third == 0]) and 0.2 < (both[third == 0] == 1).mean() < 0.9
    assert set(perfect[third == 1].tolist()) <= {0.0, -1.0} and set(perfect[third == 2].tolist()) == {-1.0}


def test_balls_of_a_real_game_are_on_time_as_often_as_may_be(tmp_path: Path) -> None:
    path = real_file("savant_2024-07-25_cease_nohitter_full118col.csv.gz")
    counted = analyse_season([path], folder=tmp_path).counted().collect()
    told = counted["on_time"].drop_nulls()
    assert len(told) >= 15 and 0.4 < number(told.mean()) < 1.0


def test_pooled_means_hold_as_often_as_they_say() -> None:
    """Two hundred groups of made-up numbers with between 3 and 60 balls each."""
    rng = np.random.default_rng(4)
    truth = rng.normal(10.0, 1.0, 200)
    sizes = rng.integers(3, 60, 200)
    frame = pl.DataFrame(
        {
            "who": np.repeat(np.arange(200), sizes).astype(str),
            "value": np.concatenate([rng.normal(mean, 4.0, size) for mean, size in zip(truth, sizes, strict=True)]),
        }
    )
    table, spread = pooled(frame, key="who", measure="value")
    mine = pl.Series(truth[table["who"].cast(pl.Int64).to_numpy()])
    assert spread.between == pytest.approx(1.0, rel=0.4) and spread.within == pytest.approx(16.0, rel=0.1)
    assert 0.42 < covered(mine, table["low50"], table["high50"]) < 0.58
    assert 0.85 < covered(mine, table["low90"], table["high90"]) < 0.95
    raw, partly = (number(((table[name] - mine) ** 2).mean()) for name in ("mean", "pooled"))
    assert partly < 0.7 * raw


def test_tables_of_players_are_added_up_part_by_part(season: Season) -> None:
    """However the balls are cut, and as when they are held together."""
    counted = season.counted()
    rows = counted.collect()
    parts = [rows.lazy().slice(start, 700) for start in range(0, len(rows), 700)]
    whole, added = all_standings([counted], keys=["batter"])["batter"], all_standings(parts)["batter"]
    assert len(parts) > 4
    for name in whole.table.columns:
        one, two = whole.table[name], added.table[name]
        assert one.equals(two, null_equal=True) or np.allclose(
            one.to_numpy(), two.to_numpy(), rtol=1e-9, equal_nan=True
        )
    together, spread = pooled(rows, key="batter", measure="from_best")
    assert added.table["from_best"].to_numpy() == pytest.approx(together["pooled"].to_numpy(), rel=1e-9)
    assert added.spreads["from_best"].between == pytest.approx(spread.between, rel=1e-6)
    hardest = (
        rows.group_by("batter")
        .agg(ev20=pl.col("exit_speed").filter(pl.col("exit_speed") >= pl.col("exit_speed").quantile(0.8)).mean())
        .sort("batter")
    )
    assert added.table["ev20"].to_numpy() == pytest.approx(hardest["ev20"].to_numpy(), abs=0.1 * MPH)


def test_groups_that_do_not_differ_are_one() -> None:
    rng = np.random.default_rng(7)
    means = rng.normal(0, 0.1, 30)
    assert spread_of(np.full(30, 100.0), means - means, np.full(30, 99.0)).between == 0.0


@pytest.mark.parametrize("name", [BAT, "mlb-a", "college-alloy"])
def test_hits_that_leave_in_a_direction_are_the_kernel_s(name: str) -> None:
    """As balls in play are: every pitch, up to 2500 rpm, 1 to 16 in from the tip, up to 50 degrees off the path."""
    bat, ball = catalog.bat(name), catalog.ball()
    table, rng, count = bat_in_plane(bat, ball=ball).table, np.random.default_rng(1), 2000
    speed, ratio = rng.uniform(45 * MPH, 85 * MPH, count), rng.uniform(0.8, 1.6, count)
    slant, spin = np.radians(rng.uniform(-10, 35, count)), RPM * rng.uniform(-2500, 2500, count)
    at = rng.integers(4, 65, count)
    offset = rng.uniform(-0.8, 0.8, count) * table.reach[at]
    ahead, up, still = -ratio * speed * np.cos(slant), -ratio * speed * np.sin(slant), np.zeros(count)
    struck = strikes(
        reduced_bat(bat, ball=ball),
        ball=ball,
        swings=Swings(speed * table.arm[at], path_axes(0.0, 0.0, tilt=0.0, left=False), bat.choke),
        pitches=BallMotions(
            velocity=np.stack([still, ahead, up], axis=-1), spin=np.stack([spin, still, still], axis=-1)
        ),
        contact=Contact(bat.length - PLACES[at], offset),
    )
    turned = np.arctan2(struck.velocity[:, 2], struck.velocity[:, 1])
    asked = np.stack([speed, ahead, up, ball.radius * spin], axis=-1).tolist()
    found = np.array([
        hit_towards(table, place, tuple(hit), np.cos(angle), np.sin(angle), angle / USUAL_TURN, USUAL_TURN)[:2]
        for place, hit, angle in zip(at, asked, turned, strict=True)
    ])  # fmt: skip
    leaves = np.isfinite(struck.exit_speed) & (np.abs(turned) < np.radians(50))
    assert np.isfinite(found[leaves, 0]).mean() > 0.999
    fast = np.hypot(struck.velocity[:, 1], struck.velocity[:, 2])
    part = 1.0 if bat.shell is None else 1.5  # 14 in from its tip a ball touches a thin wall twice
    for miss, most in ((found[:, 0] - fast, SPEED_ERROR), (found[:, 1] - offset, 1e-5)):
        assert np.nanquantile(np.abs(miss[leaves]), 0.95) < part * most


def test_the_ceiling_is_the_hardest_of_all_hits() -> None:
    """Searched for by hand among the kernel's hits of a swing of 65 mph and a pitch 1.2 times as fast."""
    bat, ball = catalog.bat(BAT), catalog.ball()
    swung, speed = bat_in_plane(bat, ball=ball), 65 * MPH
    place, angle = (grid.ravel() for grid in np.meshgrid(np.arange(4, 44), np.linspace(-0.3, 0.3, 25)))
    struck = strikes(
        reduced_bat(bat, ball=ball),
        ball=ball,
        swings=Swings(speed * swung.table.arm[place], path_axes(0.0, 0.0, tilt=0.0, left=False), bat.choke),
        pitches=BallMotions(velocity=(0.0, -1.2 * speed, 0.0), spin=np.zeros(3)),
        contact=Contact(bat.length - PLACES[place], np.sin(angle) * swung.table.reach[place]),
    )
    assert swung.ceiling[1, 6, 1] == pytest.approx(np.max(struck.exit_speed) / speed, rel=1e-3)
    assert swung.best_place[1, 6, 1] == pytest.approx(PLACES[place[np.argmax(struck.exit_speed)]], abs=0.2 * INCH)


def test_held_out_exit_speeds_hold_in_every_band(tmp_path: Path) -> None:
    """Learnt from one half, told of the other, both ways: intervals hold 47-53 and 88-92 % in every band.

    Slow swings are late or broken off, bats that still go down meet the ball elsewhere, grazed balls and inside pitches
    scatter by more, and intervals know of it.
    """
    table = pl.read_csv(real_file("cmu36sure2026_battedballs_battracking.csv.gz"))
    told = []
    for first in (0, 1):
        paths = [tmp_path / f"{first}-{half}.parquet" for half in ("learnt", "told")]
        for path, start in zip(paths, (first, 1 - first), strict=True):
            table.gather_every(2, start).write_parquet(path)
        learnt = analyse_season(paths[:1], setting=season_setting(), folder=tmp_path / f"{first}-a").setting
        assert learnt.contact is not None and learnt.contact.relation.balls > 5000
        told.append(analyse_season(paths[1:], setting=learnt, folder=tmp_path / f"{first}-b").balls())
    columns = ("bat_speed", "exit_speed_rank", "offset_in", "attack_angle", "launch_angle", "plate_x", "is_stand_left")
    balls = pl.concat([one.select(columns) for one in told]).drop_nulls().collect()
    outside = pl.when(pl.col("is_stand_left") == 1).then(-pl.col("plate_x")).otherwise(pl.col("plate_x"))
    balls = balls.with_columns(outside=outside)

    def held(name: str, low: float, high: float, balls: pl.DataFrame = balls) -> tuple[float, float]:
        ranks = balls.filter((pl.col(name) >= low) & (pl.col(name) < high))["exit_speed_rank"]
        half, most = (number(ranks.is_between(end, 1 - end).mean()) for end in (0.25, 0.05))
        return half, most

    for low, high in ((55.0, 66.0), (66, 70), (70, 74), (74, 78), (78, 100)):
        half, most = held("bat_speed", low, high)
        assert 0.47 < half < 0.53, (low, half)
        assert 0.88 < most < 0.92, (low, most)
    for low, high in ((-4.0, -1.4), (-1.4, -1), (-1, 1), (1, 1.4), (1.4, 4)):
        half, most = held("offset_in", low, high)
        assert 0.47 < half < 0.56, (low, half)  # of some 1,300 balls: +- 0.014
        assert 0.88 < most < 0.93, (low, most)
    for low, high in ((-4, -1.8), (1.8, 4)):  # of 435 and 355 balls that were only grazed: +- 0.026 and 0.016
        half, most = held("offset_in", low, high)
        assert 0.44 < half < 0.58 and 0.86 < most < 0.95, (low, half, most)
    for low, high in ((-90.0, -8.0), (-8, -2), (-2, 4), (4, 10), (10, 16), (16, 22), (22, 90)):
        half, most = held("attack_angle", low, high)
        assert 0.46 < half < 0.54, (low, half)  # of 617 balls in the first: +- 0.02
        assert 0.87 < most < 0.93, (low, most)
    for low, high in ((-1.0, -0.6), (-0.6, 0.6), (0.6, 1), (1, 3)):
        half, most = held("outside", low, high)
        assert 0.45 < half < 0.56, (low, half)  # of 654 balls in the last: +- 0.02
        assert 0.87 < most < 0.93, (low, most)
    half, most = held("outside", -3, -1)  # a bat's table that ends 14 in from the tip has 0.82 here
    assert 0.46 < half < 0.64 and 0.86 < most < 0.96  # of 346 balls: +- 0.027 and 0.016
    half, most = held("bat_speed", 40, 55)
    assert 0.42 < half < 0.58 and 0.86 < most < 0.95  # of 156 balls: +- 0.04 and 0.024
    topped = balls.filter((pl.col("attack_angle") < 0) & (pl.col("launch_angle") < -30))
    half, most = held("bat_speed", 40, 100, topped)
    assert 0.44 < half < 0.56 and 0.86 < most < 0.95  # of 330 balls: +- 0.03 and 0.017


def test_places_that_a_club_measured_are_learned_from(
    made: pl.DataFrame, season: Season, answered: Callable[[pl.DataFrame], Season]
) -> None:
    """Every second ball's, with errors of 0.5 in: they hold as they should, the others too, and the slope is surer."""
    error = np.random.default_rng(5).normal(0, 0.5, len(made))
    known = pl.int_range(pl.len()) % 2 == 0
    found = answered(made.with_columns(axial_offset_in=pl.when(known).then(6 - pl.col("true_from_tip_in") + error)))
    balls = found.balls().filter(pl.col("contact_outcome") == "ok").collect()
    for mine in (balls["axial_offset_in"].is_not_null(), balls["axial_offset_in"].is_null()):
        some = balls.filter(mine)
        for percent, least, most in ((50, 0.46, 0.54), (90, 0.87, 0.93)):
            ends = some[f"from_tip_low{percent}_in"], some[f"from_tip_high{percent}_in"]
            assert least < covered(some["true_from_tip_in"], *ends) < most
    errors = []
    for one in (found, season):
        assert one.setting.contact is not None
        errors.append(np.diag(one.setting.contact.relation.covariance)[1])
    assert errors[0] < 0.95 * errors[1]


def test_home_runs_by_the_season_s_own_drag() -> None:
    # exact: the kernel's chances with 6 % more drag in every park are those of the law's, shifted
    parks, ball = catalog.parks(), catalog.ball()
    through = FlightConditions(ball=ball, aerodynamics=catalog.aerodynamics(), air=Air(temperature=22.0))
    balls = BallMotions(velocity=[(3.0 * side, 41.5, 23.0) for side in range(-5, 6)], spin=(200.0, 0.0, 0.0))
    more = replace(USUAL, roof_shift=USUAL.roof_shift + 0.06, open_shift=USUAL.open_shift + 0.06)
    by_law, truth = (
        home_run_chances(balls, through, parks=parks, scatter=scatter).chance.ravel() for scatter in (USUAL, more)
    )
    names = [park.name for park in parks] * 11
    counted = pl.LazyFrame({"park": names, "home_run_here": by_law, "event": ["fly out"] * len(names)})
    law, own = home_runs_with(counted, drag=1.0), home_runs_with(counted, drag=1.06, error=0.01)
    assert law is not None and own is not None
    assert (law.low, law.value, law.high) == pytest.approx((by_law.sum(),) * 3)
    assert 1 < own.value < 0.95 * law.value and own.low < own.value < own.high
    assert own.value == pytest.approx(truth.sum(), rel=1e-6)
    assert home_runs_with(counted.with_columns(event=pl.lit("Home Run")), drag=1.06, error=0.01) is None

"""Where a player stands among others: the league's quantiles, the usual player, the hardest-hit balls."""

from __future__ import annotations

from dataclasses import replace
from statistics import NormalDist

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.catalog.league_batters import hardest_hit, major_league
from sweetspot.numerics.interval import ENDS, Interval
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import PlayerPosterior, fit_player
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.player.standing import AGAINST_USUAL, player_standing, share_of, squared_up_share
from sweetspot.units import DEGREE, INCH, MPH

OWN, BALL = catalog.bat("r161-ash"), catalog.ball()


def fitted(**standard: float) -> PlayerPosterior:
    row = np.zeros(len(NAMES))
    for name, value in standard.items():
        row[NAMES.index(name)] = value
    swings = simulated_swings(natural(row), bats=[OWN], ball=BALL, count=80, pitch_speed=82 * MPH, seed=3)
    return fit_player(player_model(swings, bat=OWN, ball=BALL))


@pytest.fixture(scope="module")
def posterior() -> PlayerPosterior:
    return fitted(bat_speed=0.4, position_spread=1.0, attack_angle=1.0)


def level_of(posterior: PlayerPosterior, name: str, against: str) -> Interval:
    (standing,) = [
        standing
        for standing in player_standing(posterior).quantities
        if (standing.name, standing.against) == (name, against)
    ]
    return standing.share_below


def test_the_median_batter_is_above_half_of_the_league() -> None:
    league = major_league()
    assert league.bat_speed.level(72.15 * MPH) == pytest.approx(0.5)
    assert league.bat_speed.level(40 * MPH) == 0.05 and league.bat_speed.level(90 * MPH) == 0.95  # no further told
    assert np.all(np.diff(league.bat_speed.values) > 0) and np.all(np.diff(league.squared_up.values) > 0)


def test_scatter_and_attack_angle_are_held_against_the_usual_player(posterior: PlayerPosterior) -> None:
    level = level_of(posterior, "position_spread", "usual")
    scatter = posterior.learned["position_spread"].interval.value
    assert level.value == pytest.approx(NormalDist(np.log(1.8 * INCH), 0.4).cdf(np.log(scatter)))  # as the prior says
    angle = level_of(posterior, "attack_angle", "usual")
    assert angle.low < 0.84 < angle.high  # one standard deviation of the prior above its median


def test_what_swings_do_not_tell_has_no_place() -> None:
    speeds = [PlayerSwing(row, 30.0 + 0.1 * row, None, None, None, None, None, "") for row in range(2, 14)]
    standing = player_standing(fit_player(player_model(speeds, bat=OWN, ball=BALL)))
    assert {one.name for one in standing.quantities} <= {"bat_speed", "bat_speed_spread"}
    assert standing.off_path is None


def test_fast_swings_are_held_against_fast_ones(posterior: PlayerPosterior) -> None:
    """A fast swinger squares up fewer balls; the same share stands higher among batters as fast."""
    fast = replace(
        posterior,
        learned={
            **posterior.learned,
            "bat_speed": replace(posterior.learned["bat_speed"], interval=Interval(*(77 * MPH + np.array([0, -1, 1])))),
        },
    )
    assert (
        level_of(fast, "squared_up", "same bat speed").value > level_of(posterior, "squared_up", "same bat speed").value
    )
    assert level_of(fast, "squared_up", "league") == level_of(posterior, "squared_up", "league")


def test_squared_up_balls_are_counted_by_the_leagues_formula() -> None:
    most = 1.23 * 30 + 0.23 * 35
    swings = [
        PlayerSwing(2, 30.0, 0.81 * most, 35.0, None, None, None, ""),
        PlayerSwing(3, 30.0, 0.79 * most, 35.0, None, None, None, ""),
        PlayerSwing(4, 30.0, None, None, None, None, None, ""),
    ]
    assert squared_up_share(player_model(swings, bat=OWN, ball=BALL)) == (1, 2)


@pytest.mark.parametrize(("some", "count"), [(0, 20), (20, 20), (13, 20)])
def test_a_share_has_an_interval_that_holds_it(some: int, count: int) -> None:
    share = share_of(some, count)
    assert 0 <= share.low <= share.value <= share.high <= 1 and share.low < share.high
    random = np.random.default_rng(1).beta(some + 0.5, count - some + 0.5, 40_000)
    assert [share.low, share.high][some == 0] == pytest.approx(np.quantile(random, ENDS[int(some == 0)]), abs=0.01)


def test_the_hardest_hits_are_those_of_the_players_bat_speed(posterior: PlayerPosterior) -> None:
    speed = posterior.learned["bat_speed"].interval.value
    hardest = player_standing(posterior).hardest_hit
    assert hardest is not None and hardest.slowest <= speed < hardest.fastest
    assert hardest.best_off_path < hardest.others_off_path < 30 * DEGREE
    assert hardest_hit(50 * MPH) is None


def test_another_sports_batters_are_not_held_against_this_league(posterior: PlayerPosterior) -> None:
    table = posterior.model.bats[0]
    softball = replace(posterior.model, bats=(replace(table, bat=catalog.bat("slow-pitch")),))
    standing = player_standing(replace(posterior, model=softball))
    assert standing.hardest_hit is None and all(one.against == "usual" for one in standing.quantities)
    assert {one.name for one in standing.quantities} <= set(AGAINST_USUAL)

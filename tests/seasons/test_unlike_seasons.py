"""Seasons unlike what the model supposes are as unlike as they say, and intervals still hold about as often."""

from __future__ import annotations

import numpy as np
import pytest

from studies.unlike_seasons import UNLIKE, Unlike, heavy_scatter, row_of, two_humps, unlike_season


@pytest.mark.parametrize("scatter", [heavy_scatter, two_humps])
def test_scatter_is_as_wide_as_a_normal_one(scatter) -> None:  # type: ignore[no-untyped-def]
    drawn = scatter(np.random.default_rng(1), 200_000)
    assert drawn.mean() == pytest.approx(0, abs=0.02) and drawn.std() == pytest.approx(1, abs=0.08)
    kurtosis = float(np.mean(drawn**4)) / float(np.mean(drawn**2)) ** 2
    assert kurtosis > 6 if scatter is heavy_scatter else kurtosis < 1.8  # 3 of a normal one


def test_what_is_measured_is_as_unlike_as_it_says() -> None:
    alike, unlike = (
        unlike_season(one, players=20, balls=100)
        for one in (Unlike(), Unlike(together=0.7, wrong_sides=0.02, untracked=0.5))
    )
    assert len(alike) == len(unlike)
    assert (alike["stand"] != unlike["stand"]).mean() == pytest.approx(0.02, abs=0.012)
    assert unlike["bat_speed"].null_count() / len(unlike) == pytest.approx(0.5, abs=0.05)
    assert (unlike["bat_speed"].is_null() == unlike["attack_angle"].is_null()).all()
    errors = (unlike["launch_speed"] - unlike["true_exit_speed_mph"]).to_numpy()
    assert errors.std() == pytest.approx(1, abs=0.06)
    both = np.isfinite(unlike["bat_speed"].to_numpy())
    exact = (unlike["bat_speed"] - alike["bat_speed"]).to_numpy()[both]  # 0.7 of the other error less 0.29 of its own
    assert np.corrcoef(errors[both], exact)[0, 1] == pytest.approx(0.92, abs=0.04)


def test_intervals_hold_in_a_season_that_is_unlike_in_every_way() -> None:
    places, most_places, speeds, most_speeds, *players = row_of(
        UNLIKE["all of it, places about two middles"], players=20, balls=80, truth=100, seeds=1
    )
    assert 42 < places < 58 and 83 < most_places < 96
    assert 43 < speeds < 59 and 83 < most_speeds < 96
    assert len(players) == 4 and all(0 <= value <= 100 for value in players)

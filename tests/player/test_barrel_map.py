"""The map of exit speed over the barrel, the cloud of contacts, and the bat's ceiling."""

from __future__ import annotations

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.player.barrel_map import CLOUD, ceiling, contact_map
from sweetspot.player.expected_gain import Expectation
from sweetspot.player.goal import Goal
from sweetspot.player.model import player_model
from sweetspot.player.posterior import PlayerPosterior, fit_player
from sweetspot.player.prior import NAMES, natural
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

PITCH = 75 * MPH


@pytest.fixture(scope="module")
def posterior() -> PlayerPosterior:
    own, ball = catalog.bat("r161-ash"), catalog.ball()
    swings = simulated_swings(natural(np.zeros(len(NAMES))), bats=[own], ball=ball, count=40, pitch_speed=PITCH, seed=2)
    return fit_player(player_model(swings, bat=own, ball=ball))


@pytest.mark.parametrize(("place", "offset"), [(6.0, 0.0), (3.5, 0.6), (9.0, -0.9)])
def test_the_map_is_what_a_player_without_scatter_expects(
    posterior: PlayerPosterior, place: float, offset: float
) -> None:
    row = np.median(posterior.draws, axis=0)
    for name in ("bat_speed_spread", "position_spread", "offset_spread"):
        row[NAMES.index(name)] = 0.0
    row[[NAMES.index("position"), NAMES.index("offset")]] = place * INCH, offset * INCH
    alone = Expectation(posterior.model, row[None], Goal(), PITCH, None, np.zeros((4, 1, 1)))
    found = contact_map(posterior, PITCH)
    column = int(np.argmin(np.abs(found.from_tip - place * INCH)))
    mapped = np.interp(offset * INCH, found.offset, found.exit_speed[column])
    assert mapped == pytest.approx(alone.of(posterior.model.bats[0])[0], rel=2e-3)


def test_the_ceiling_is_the_maps_best_head_on(posterior: PlayerPosterior) -> None:
    speed = np.median(posterior.draws[:, NAMES.index("bat_speed")])
    best = float(np.nanmax(contact_map(posterior, PITCH).exit_speed))
    (most,) = ceiling(posterior, np.array([speed]), PITCH)
    assert best == pytest.approx(most, rel=0.01)
    slow, fast = ceiling(posterior, np.array([speed - 2, speed + 2]), PITCH)
    assert slow < most < fast


def test_the_cloud_scatters_as_the_player_does(posterior: PlayerPosterior) -> None:
    cloud = contact_map(posterior, PITCH).cloud
    assert cloud.shape[0] == 2 and cloud.shape[1] + 1 >= CLOUD
    middle, spread = (posterior.learned[name].interval for name in ("position", "position_spread"))
    assert abs(cloud[0].mean() - middle.value) < 0.3 * spread.value
    assert spread.low * 0.8 < cloud[0].std() < 1.3 * np.hypot(spread.high, middle.high - middle.low)

"""Errors of bat sensors: a bias common to all swings does not pass for a dead bat, and noise not for a player's own."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.player.model import player_model
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import evidence_of, fit_player, refitted
from sweetspot.player.prior import ANYBODY, NAMES, natural
from sweetspot.player.sensor import Sensor, sensor_of
from sweetspot.player.simulate import simulated_swings
from sweetspot.player.standing import player_standing
from sweetspot.units import DEGREE, MPH

OWN, BALL, PITCH = catalog.bat("r161-ash"), catalog.ball(), 65 * MPH
SHIFT, SPEED = NAMES.index("efficiency_shift"), NAMES.index("bat_speed")
BLAST = sensor_of("Blast")


def swings(*, bias: float, seed: int = 11, count: int = 80) -> list[PlayerSwing]:
    made = simulated_swings(natural(np.zeros(10)), bats=[OWN], ball=BALL, count=count, pitch_speed=PITCH, seed=seed)
    random = np.random.default_rng(seed)
    return [
        replace(
            swing,
            bat_speed=swing.bat_speed * (1 + bias) + 0.66 * MPH * random.standard_normal(),
            attack_angle=swing.attack_angle + 6 * DEGREE * random.standard_normal(),
        )
        for swing in made
        if swing.bat_speed is not None and swing.attack_angle is not None
    ]


def test_the_prior_is_as_wide_as_a_bias_makes_a_ball_seem() -> None:
    """An exit speed stays while the bat speed read is too high by b: q' (p + v') + v' = q (p + v) + v."""
    assert BLAST is not None
    v, p, q = 30.0, 27.0, 0.2
    low, high = (q - (q * (p + v) + v - v * (1 + b)) / (p + v * (1 + b)) for b in (-0.06, 0.06))
    spread = BLAST.population(bat_speed=v, pitch_speed=p).spread[SHIFT]
    assert spread == pytest.approx(np.hypot(1.0, (high - low) / 2 / 0.02), rel=0.01)
    assert sensor_of("plain") is None and sensor_of("HitTrax") is None


@pytest.mark.parametrize("bias", [-0.08, 0.08])
def test_a_biased_sensor_does_not_move_the_scatter(bias: float) -> None:
    """Read 8 % too fast, bats seem dead, and not the balls badly met."""
    row = natural(np.zeros(10))
    row[SHIFT] = -1.2 * bias * row[SPEED] / (PITCH + (1 + bias) * row[SPEED])
    row[[SPEED, NAMES.index("bat_speed_spread")]] *= 1 + bias
    fit = fit_player(player_model(swings(bias=bias), bat=OWN, ball=BALL, sensor=BLAST), seed=2)
    assert fit.converged
    for name, true in zip(NAMES, row, strict=True):
        found = fit.learned[name].interval
        # one file of one player: within two and a half of its deviations, as all but one in a hundred are
        assert abs(found.value - true) < 1.5 * (found.high - found.low) / 2, name
    blind = fit_player(player_model(swings(bias=bias), bat=OWN, ball=BALL), seed=2)
    near, far = (abs(one.learned["efficiency_shift"].interval.value - row[SHIFT]) for one in (fit, blind))
    assert near < far  # a prior without the bias pulls the efficiency back to the usual ball's


def test_a_bat_speed_stands_among_others_no_surer_than_its_sensor() -> None:
    sure, unsure = (
        player_standing(fit_player(player_model(swings(bias=0.0), bat=OWN, ball=BALL, sensor=sensor))).quantities[0]
        for sensor in (None, BLAST)
    )
    assert unsure.name == sure.name == "bat_speed"
    assert unsure.value.high - unsure.value.low > 5 * (sure.value.high - sure.value.low)
    assert unsure.value.high / unsure.value.value == pytest.approx(1 + 1.645 * 0.06, abs=0.01)


def test_a_team_with_a_sensor_is_pooled_from_its_own_prior() -> None:
    """What swings say of a player is what the posterior adds to the prior that the fit began with."""
    fit = fit_player(player_model(swings(bias=0.0), bat=OWN, ball=BALL, sensor=BLAST), seed=3)
    assert fit.weighted is not None and fit.population.spread[SHIFT] > 2
    evidence = evidence_of([(fit.weighted, fit.population)]).precision[0]
    assert np.all(np.linalg.eigvalsh(evidence) > -1e-9)
    again = refitted(fit, ANYBODY)
    assert again.learned["efficiency_shift"].width_ratio < fit.learned["efficiency_shift"].width_ratio
    assert again.learned["bat_speed"].interval.value == pytest.approx(fit.learned["bat_speed"].interval.value, rel=0.02)


def test_a_sensor_without_errors_changes_nothing_but_its_noise() -> None:
    none = Sensor("ideal", 0.0, 1 * MPH, 0.0)
    population = none.population(bat_speed=30.0, pitch_speed=30.0)
    assert population.spread == pytest.approx(ANYBODY.spread)

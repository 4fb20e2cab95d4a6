"""The fit: priors, likelihood, draws, and made-up players whose parameters come back."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest

from sweetspot import catalog
from sweetspot.errors import InputError
from sweetspot.motion.swing_law import Interval
from sweetspot.numerics.arrays import Array
from sweetspot.player.contact_tables import ContactTable, contact_table, farthest_offset
from sweetspot.player.likelihood import combined, fill_folded, fill_weights, normal, swung, within
from sweetspot.player.model import PlayerModel, bats_of, player_model, speed_ratio
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import Posterior, interval, split_r_hat, summarised, walked
from sweetspot.player.prior import NAMES, fixed, log_prior, natural, prior_draws, priors, standardised
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

BALL = catalog.ball()
OWN, YOUTH = catalog.bat("r161-ash"), catalog.bat("youth-30")
PITCH = 82 * MPH
TYPICAL = np.array([0.4, 0.3, 0.4, 0.3, -0.3, 0.2, -0.2, 0.1, 0.2, 0.0])
"""Standard parameters of a made-up player."""


@pytest.fixture(scope="module")
def table() -> ContactTable:
    return contact_table(OWN, ball=BALL, axis=0.0)


def modelled(standard: Array, *, count: int, seed: int, several: bool = False) -> PlayerModel:
    bats = [OWN, YOUTH] if several else [OWN]
    swings = simulated_swings(natural(standard), bats=bats, ball=BALL, count=count, pitch_speed=PITCH, seed=seed)
    return player_model(swings, bat=OWN, ball=BALL, others={YOUTH.name: YOUTH})


def fitted(model: PlayerModel, seed: int = 1) -> Posterior:
    return walked(model, seed=seed, steps=220, warm_up=160)


def test_every_prior_reads_and_turns_round() -> None:
    """Exact: natural and standardised are inverse; the exponent's centre is the baseball law's."""
    draws = prior_draws(200, seed=3)
    assert np.allclose(standardised(natural(draws)), draws)
    assert priors()["exponent"].centre == catalog.swing_law().exponent
    outside = np.zeros(10)
    outside[NAMES.index("exponent")] = -4
    assert log_prior(outside) == -np.inf


@pytest.fixture(scope="module")
def nothing() -> PlayerModel:
    """A swing with nothing measured."""
    return player_model([PlayerSwing(2, None, None, None, None, None, None, "")], bat=OWN, ball=BALL)


def test_without_data_the_posterior_is_the_prior(nothing: PlayerModel) -> None:
    """Exact: a swing with nothing measured is as likely under any parameters."""
    places = prior_draws(300, seed=5)
    assert np.ptp(nothing.log_likelihood(places)) == 0.0
    assert np.allclose(nothing.log_posterior(places), log_prior(places), atol=1e-12)


def test_without_data_the_draws_are_the_prior(nothing: PlayerModel) -> None:
    """Means within 5 standard errors, the widths' mean within 3 % (its noise: 0.7 %; a wrong kind of step gave 5 %)."""
    result = walked(nothing, steps=1800, warm_up=400)
    for name, one in result.learned.items():
        noise = 1 / math.sqrt(one.independent_draws)
        assert abs(np.mean(standardised(result.draws)[:, NAMES.index(name)])) < 5 * noise, name
        assert not one.told
    assert np.mean([one.width_ratio for one in result.learned.values()]) == pytest.approx(1.0, abs=0.03)


@pytest.fixture(scope="module")
def typical() -> Posterior:
    return fitted(modelled(TYPICAL, count=60, seed=4))


@pytest.mark.parametrize("seed", [1, 2])
def test_a_made_up_player_comes_back(seed: int) -> None:
    """Truth known by construction; 95 % intervals may miss two of the ten, and no parameter by more than 4.5 sd."""
    truth = prior_draws(2, seed=7)[seed - 1]
    found = fitted(modelled(truth, count=50, seed=seed), seed)
    standard = standardised(found.draws)
    deviation = (truth - standard.mean(axis=0)) / standard.std(axis=0)
    assert np.abs(deviation).max() < 4.5
    values = natural(truth)
    inside = [one.interval.low <= values[i] <= one.interval.high for i, one in enumerate(found.learned.values())]
    assert sum(inside) >= 8


def test_one_bat_leaves_the_exponent_at_its_prior_and_two_bats_find_it(typical: Posterior) -> None:
    two = fitted(modelled(TYPICAL, count=40, seed=4, several=True))
    assert not typical.learned["exponent"].told
    assert not typical.model.several_bats and two.model.several_bats
    learned = two.learned["exponent"]
    assert learned.width_ratio < 0.6
    assert learned.interval.low < natural(TYPICAL)[NAMES.index("exponent")] < learned.interval.high


def test_five_swings_are_enough_to_answer_and_the_intervals_are_wide(typical: Posterior) -> None:
    few = fitted(modelled(TYPICAL, count=5, seed=5))
    for name in ("bat_speed", "position_spread", "offset_spread"):
        widths = [found.learned[name].interval for found in (few, typical)]
        assert widths[0].high - widths[0].low > 1.3 * (widths[1].high - widths[1].low), name
    assert np.median([one.width_ratio for one in few.learned.values()]) > 0.5


def test_the_same_seed_gives_the_same_draws() -> None:
    model = modelled(TYPICAL, count=10, seed=6)
    first, second, other = (walked(model, seed=seed, steps=20, warm_up=5) for seed in (1, 1, 2))
    assert np.array_equal(first.draws, second.draws)
    assert not np.array_equal(first.draws, other.draws)


def test_progress_is_told_and_can_interrupt() -> None:
    calls: list[tuple[int, int]] = []

    def stop(done: int, total: int) -> None:
        calls.append((done, total))
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        walked(modelled(TYPICAL, count=5, seed=6), steps=100, warm_up=10, progress=stop)
    assert calls == [(25, 110)]


def test_an_interrupt_inside_the_likelihood_is_quiet(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    model = modelled(TYPICAL, count=5, seed=6)
    asked = PlayerModel.log_posterior
    calls: list[int] = []

    def interrupted(self: PlayerModel, standard: Array) -> Array:
        calls.append(1)
        if len(calls) > 20:
            raise KeyboardInterrupt
        return asked(self, standard)

    monkeypatch.setattr(PlayerModel, "log_posterior", interrupted)
    with pytest.raises(KeyboardInterrupt):
        walked(model, steps=100, warm_up=10)
    assert capsys.readouterr().out == ""


def test_likelihood_prefers_the_truth_with_each_kind_of_data() -> None:
    """Without launch angles, without bat speeds, and with positions: the truth beats parameters moved well away."""
    swings = modelled(TYPICAL, count=150, seed=8).swings
    kinds = {
        "no launch angle": [replace(one, launch_angle=None) for one in swings],
        "no attack angle": [replace(one, attack_angle=None) for one in swings],
        "no bat speed": [replace(one, bat_speed=None) for one in swings],
    }
    for kind, changed in kinds.items():
        model = player_model(changed, bat=OWN, ball=BALL)
        for name, away in (("position_spread", 2.5), ("bat_speed", 1.0)):
            moved = np.tile(TYPICAL, (3, 1))
            moved[1:, NAMES.index(name)] += (-away, away)
            height = model.log_likelihood(moved)
            assert height[0] > height[1:].max() + 2, (kind, name)


def test_measured_positions_are_used() -> None:
    swings = [replace(one, position=7.5 * INCH) for one in modelled(TYPICAL, count=30, seed=9).swings]
    found = fitted(player_model(swings, bat=OWN, ball=BALL))
    assert found.learned["position"].interval.value == pytest.approx(7.5 * INCH, abs=0.3 * INCH)
    assert found.learned["position"].width_ratio < 0.3


def test_off_centre_hits_lose_speed_and_turn(table: ContactTable) -> None:
    """Published slope, about 26 degrees per inch (launch minus attack angle), and what kept falls to [sure2026]."""
    middle = len(table.offset) // 2
    assert table.kept[:, middle] == pytest.approx(1.0)
    inch = float(np.interp(1 * INCH, table.offset, table.deflection[3]))
    assert math.degrees(inch) == pytest.approx(26, abs=3)
    assert float(np.interp(1 * INCH, table.offset, table.kept[3])) == pytest.approx(0.945, abs=0.02)
    assert farthest_offset(table) > 1.5 * INCH


def test_speed_ratio_is_the_swing_law(table: ContactTable) -> None:
    """Exact: omega as the law says, at equal distances from the tip."""
    law = catalog.swing_law()
    choked = contact_table(OWN.choked_up(INCH), ball=BALL, axis=law.axis, like=table)
    found = speed_ratio(choked, table, law=law, speed_from_tip=6 * INCH, exponent=np.array([0.2, 0.4]))
    for exponent, ratio in zip((0.2, 0.4), found, strict=True):
        turned = law.speed_ratio(choked.moi, reference_moi=table.moi, exponent=exponent)
        assert ratio == pytest.approx(turned * 26 / 27, rel=1e-6)


def test_pieces_of_the_likelihood() -> None:
    """Exact: closed forms of normal distributions."""
    assert normal(1.0, 1.0, 1.0) == 0.0
    mean, variance = combined(2.0, 1.0, 0.0, 1.0)
    assert (mean, variance) == pytest.approx((1.0, 0.5))
    assert combined(math.nan, 1.0, 3.0, 2.0) == (3.0, 4.0)
    assert within(0.0, 1.0, 1.959964) == pytest.approx(0.95, abs=1e-6)
    weight = np.zeros(65)
    first, last = fill_weights(weight, 0.0, 0.25, 6.0, 1.5**2)
    assert weight[first:last].sum() == pytest.approx(1.0)
    assert float(weight @ (0.25 * np.arange(65))) == pytest.approx(6.0, abs=1e-3)
    folded = np.zeros(5)
    fill_folded(folded, np.linspace(0.1, 2, 5), 0.2, 0.8)
    assert folded.sum() == pytest.approx(1.0)


def test_bats_by_name() -> None:
    swing = PlayerSwing(2, 30.0, None, None, None, None, None, "my gamer")
    good, bats, bad, notes = bats_of([swing], load=catalog.bat)
    assert (len(good), bats, bad) == (1, {}, ())
    assert "taken for the bat given with --bat" in notes[0]
    named = replace(swing, row=3, bat="youth-30")
    good, bats, bad, notes = bats_of([swing, named], load=catalog.bat)
    assert [one.row for one in good] == [3]
    assert bad[0].row == 2 and "not in the catalogue" in bad[0].reason
    assert set(bats) == {"youth-30"}
    with pytest.raises(InputError, match="none of the bats"):
        bats_of([swing, replace(swing, bat="other one")], load=catalog.bat)
    with pytest.raises(InputError, match="no swing"):
        player_model([], bat=OWN, ball=BALL)


def test_summaries() -> None:
    """Exact: chains at two places are not mixed; the median and the ends of evenly spread numbers."""
    apart = np.concatenate([np.zeros((100, 4)), np.ones((100, 4))]) + 1e-3 * np.random.default_rng(1).random((200, 4))
    assert split_r_hat(apart) > 5
    assert interval(np.arange(2001.0)) == Interval(1000.0, 50.0, 1950.0)
    chains = np.random.default_rng(2).standard_normal((300, 20, 10)) * 0.5
    learned = summarised(chains)
    assert all(one.width_ratio == pytest.approx(0.5, abs=0.05) for name, one in learned.items() if name != "exponent")


def test_the_compiled_likelihood_is_the_readable_one(table: ContactTable) -> None:
    """Other code: the same sums in numpy, for a swing without launch angle and one whose place was measured."""
    theta = natural(TYPICAL)
    value = dict(zip(NAMES, theta, strict=True))
    plain = PlayerSwing(2, None, 44.0, PITCH, None, None, None, "")
    model = player_model([plain], bat=OWN, ball=BALL)
    found = float(model.log_likelihood(TYPICAL)[0])
    place = table.from_tip
    weight = np.exp(-0.5 * ((place - value["position"]) / value["position_spread"]) ** 2)
    arm = (OWN.length - place) / (OWN.length - 6 * INCH)
    speed, there = value["bat_speed"], value["bat_speed"] * arm
    closing = PITCH + there
    q = table.efficiency + value["efficiency_shift"] + table.efficiency_slope * closing
    out, slope = q * closing + there, (1 + q + table.efficiency_slope * closing) * arm
    kept = np.interp(model.table.far, table.offset, model.table.kept[0])[:, None]
    sides = [
        np.exp(-0.5 * ((model.table.far + sign * value["offset"]) / value["offset_spread"]) ** 2) for sign in (1, -1)
    ]
    above = (sides[0] + sides[1])[:, None]
    variance = value["exit_noise"] ** 2 + fixed("model_noise") ** 2 + (slope * kept * value["bat_speed_spread"]) ** 2
    density = np.exp(-0.5 * (44.0 - out * kept) ** 2 / variance) / np.sqrt(2 * math.pi * variance)
    total = np.sum(density * above * weight) / (above.sum() * weight.sum())
    assert speed > 0
    assert found == pytest.approx(math.log(0.99 * total + 0.01 / 60), abs=1e-3)


def test_a_slow_swing_says_little_of_the_others() -> None:
    """Exact limits: near the mean it is the normal law; far below its own reading counts, the density falls slowly."""
    slow = (0.05, 10 * MPH, 8 * MPH)
    mean, spread, noise = 70 * MPH, 3 * MPH, 1 * MPH
    _, usual, _ = swung(69 * MPH, noise, mean, spread, slow)
    assert usual == pytest.approx(combined(69 * MPH, noise, mean, spread)[0], abs=0.02 * MPH)
    said, speed, _ = swung(50 * MPH, noise, mean, spread, slow)
    assert abs(speed - 50 * MPH) < 0.3 * MPH
    assert said > normal(50 * MPH, mean, spread**2 + noise**2) + 10
    assert swung(math.nan, noise, mean, spread, slow) == (0.0, mean, spread**2)


def test_a_steeper_swing_turns_the_ball_further(table: ContactTable) -> None:
    """Other code: full collisions; off a tee not at all, for usual speeds by half as much again."""
    assert abs(table.turning[0]) < 0.01
    assert 0.45 < table.turning[3] < 0.65 and np.all(np.diff(table.turning) > 0)


def test_the_likelihood_is_smooth() -> None:
    """Fine steps of the exit noise change the slope of the logarithm by next to nothing: no rounding shows."""
    model = modelled(TYPICAL, count=40, seed=3)
    places = np.tile(TYPICAL, (41, 1))
    places[:, NAMES.index("exit_noise")] += np.linspace(-0.5, 0.5, 41)
    assert np.abs(np.diff(model.log_likelihood(places), 3)).max() < 1e-3

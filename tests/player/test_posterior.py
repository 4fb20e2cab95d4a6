"""The fit: priors, likelihood, draws, and made-up players whose parameters come back."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import erf, erfinv

from sweetspot import catalog
from sweetspot.collision.hit_in_space import Contact, strike
from sweetspot.dynamics.reduction import reduced_bat
from sweetspot.errors import InputError
from sweetspot.motion.ball_motion import BallMotion
from sweetspot.motion.swing import Swing
from sweetspot.motion.swing_path import SwingPath
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.interval import Interval
from sweetspot.player.bat_response import MISSED, BatResponse, farthest_offset, response_of
from sweetspot.player.contact_rate import fill_hits, fill_untold, fill_weights
from sweetspot.player.likelihood import COUNTED, combined, normal, swung
from sweetspot.player.model import PlayerModel, bats_of, player_model, speed_ratio
from sweetspot.player.off_centre import (
    STEEPEST_LAUNCH,
    UNTOLD_EVERY,
    at_swings,
    deflection_noise,
    gauss_points,
    untold_kept,
)
from sweetspot.player.player_swing import PlayerSwing
from sweetspot.player.posterior import PlayerPosterior, fit_player, interval, summarised
from sweetspot.player.prior import NAMES, fixed, log_prior, natural, prior_draws, priors, standardised
from sweetspot.player.simulate import simulated_swings
from sweetspot.units import INCH, MPH

BALL = catalog.ball()
OWN, YOUTH = catalog.bat("r161-ash"), catalog.bat("youth-30")
PITCH = 82 * MPH
TYPICAL = np.array([0.4, 0.3, 0.4, 0.3, -0.3, 0.2, -0.2, 0.1, 0.2, 0.0])
"""Standard parameters of a made-up player."""


@pytest.fixture(scope="module")
def table() -> BatResponse:
    return response_of(OWN, ball=BALL, axis=0.0)


def modelled(standard: Array, *, count: int, seed: int, several: bool = False) -> PlayerModel:
    bats = [OWN, YOUTH] if several else [OWN]
    swings = simulated_swings(natural(standard), bats=bats, ball=BALL, count=count, pitch_speed=PITCH, seed=seed)
    return player_model(swings, bat=OWN, ball=BALL, others={YOUTH.name: YOUTH})


def fitted(model: PlayerModel, seed: int = 1) -> PlayerPosterior:
    return fit_player(model, seed=seed)


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


@pytest.fixture(scope="module")
def typical() -> PlayerPosterior:
    return fitted(modelled(TYPICAL, count=60, seed=4))


@pytest.mark.parametrize("seed", [1, 2])
def test_a_made_up_player_comes_back(seed: int) -> None:
    """Truth known by construction; 90 % intervals may miss two of the ten, and no parameter by more than 4.5 sd."""
    truth = prior_draws(2, seed=7)[seed - 1]
    found = fitted(modelled(truth, count=50, seed=seed), seed)
    standard = standardised(found.draws)
    deviation = (truth - standard.mean(axis=0)) / standard.std(axis=0)
    assert np.abs(deviation).max() < 4.5
    values = natural(truth)
    inside = [one.interval.low <= values[i] <= one.interval.high for i, one in enumerate(found.learned.values())]
    assert sum(inside) >= 8


def test_one_bat_leaves_the_exponent_at_its_prior_and_two_bats_find_it(typical: PlayerPosterior) -> None:
    two = fitted(modelled(TYPICAL, count=40, seed=4, several=True))
    assert not typical.learned["exponent"].told
    assert len(typical.model.bats) == 1 and len(two.model.bats) > 1
    learned = two.learned["exponent"]
    assert learned.width_ratio < 0.6
    assert learned.interval.low < natural(TYPICAL)[NAMES.index("exponent")] < learned.interval.high


def test_five_swings_are_enough_to_answer_and_the_intervals_are_wide(typical: PlayerPosterior) -> None:
    few = fitted(modelled(TYPICAL, count=5, seed=5))
    for name in ("bat_speed", "position_spread", "offset_spread"):
        widths = [found.learned[name].interval for found in (few, typical)]
        assert widths[0].high - widths[0].low > 1.3 * (widths[1].high - widths[1].low), name
    assert np.median([one.width_ratio for one in few.learned.values()]) > 0.5


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


def test_a_launch_angle_without_an_attack_angle_decides_only_what_counts() -> None:
    """Exact: as likely as without either, but for what is usual of all balls; such draws ran away before."""
    swings = [replace(one, attack_angle=None) for one in modelled(TYPICAL, count=20, seed=8).swings]
    bare = [replace(one, launch_angle=None) for one in swings]
    alone = [*swings, replace(swings[0], bat_speed=None, exit_speed=None)]
    found = [player_model(some, bat=OWN, ball=BALL).log_likelihood(TYPICAL) for some in (swings, bare, alone)]
    assert found[0] == found[1] and found[2] == pytest.approx(found[1], abs=0.01)


def test_measured_positions_are_used() -> None:
    swings = [replace(one, position=7.5 * INCH) for one in modelled(TYPICAL, count=30, seed=9).swings]
    found = fitted(player_model(swings, bat=OWN, ball=BALL))
    assert found.learned["position"].interval.value == pytest.approx(7.5 * INCH, abs=0.3 * INCH)
    assert found.learned["position"].width_ratio < 0.3


def test_off_centre_hits_lose_speed_and_turn(table: BatResponse) -> None:
    """Published slope, about 26 degrees per inch (launch minus attack angle), and what kept falls to [sure2026]."""
    middle = len(table.offset) // 2
    kept, deflection = (part[0, 0] for part in at_swings(table, np.array([1.2]), np.zeros(1), np.array([6 * INCH])))
    assert table.retained[2, :13, :, middle] == pytest.approx(
        1.0, abs=0.01
    )  # in line with the swing, but for 2 degrees
    inch = float(np.interp(1 * INCH, table.offset, deflection))
    assert math.degrees(inch) == pytest.approx(26, abs=3)
    assert float(np.interp(1 * INCH, table.offset, kept)) == pytest.approx(0.945, abs=0.02)
    assert farthest_offset(table) > 1.5 * INCH


def test_speed_ratio_is_the_swing_law(table: BatResponse) -> None:
    """Exact: omega as the law says, at equal distances from the tip."""
    law = catalog.swing_law()
    choked = response_of(OWN.choked_up(INCH), ball=BALL, axis=law.axis, like=table)
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
    weight = np.zeros(65)
    first, last = fill_weights(weight, 0.0, 0.25, 6.0, 1.5**2)
    assert weight[first:last].sum() == pytest.approx(1.0)
    assert float(weight @ (0.25 * np.arange(65))) == pytest.approx(6.0, abs=1e-3)


def test_bats_by_name() -> None:
    swing = PlayerSwing(2, 30.0, None, None, None, None, None, "my gamer")
    good, bats, bad, notes = bats_of([swing], load=catalog.bat)
    assert (len(good), bats, bad) == (1, {}, ())
    assert "'my gamer', which is not known here; it is taken for the bat that was given" in notes[0]
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
    """Exact: the median and the ends of evenly spread numbers; draws half as wide as the prior."""
    assert interval(np.arange(2001.0)) == Interval(1000.0, 100.0, 1900.0)
    learned = summarised(np.random.default_rng(2).standard_normal((6000, 10)) * 0.5, independent=6000)
    assert all(one.width_ratio == pytest.approx(0.5, abs=0.05) for name, one in learned.items() if name != "exponent")


def chance_of_a_hit(model: PlayerModel, theta: Array) -> float:
    """Return how likely it is that a ball met leaves as a hit."""
    places, offsets = model.table.selected.shape[2:]
    steeper = theta[NAMES.index("attack_angle")] - priors()["attack_angle"].centre
    return fill_hits(np.empty(offsets), np.empty(places), model.table, 0, theta, float(steeper))


def readable(model: PlayerModel, standard: Array) -> float:
    """Return the log-likelihood of one swing with a fine grid of offsets in place of a few points."""
    table, swing = model.bats[0], model.swings[0]
    value = dict(zip(NAMES, natural(standard), strict=True))
    usual, spread = priors()["attack_angle"].centre, value["offset_spread"]
    place = table.from_tip[::2]
    weight = np.exp(-0.5 * ((place - value["position"]) / value["position_spread"]) ** 2)
    weight /= weight.sum()
    assert swing.pitch_speed is not None and swing.exit_speed is not None
    bat_speed = value["bat_speed"] if swing.bat_speed is None else swing.bat_speed
    said, speed, variance = swung(
        math.nan if swing.bat_speed is None else bat_speed,
        fixed("bat_speed_noise"),
        value["bat_speed"],
        value["bat_speed_spread"],
        (fixed("slow_part"), fixed("slow_by"), fixed("slow_spread")),
    )
    ratio = np.array([swing.pitch_speed / (priors()["bat_speed"].centre if swing.bat_speed is None else bat_speed)])
    attack = usual if swing.attack_angle is None else swing.attack_angle
    if swing.attack_angle is not None:
        said += normal(attack, value["attack_angle"], fixed("attack_angle_spread") ** 2)
    kept, deflection = (part[0] for part in at_swings(table, ratio, np.array([attack - usual]), place))
    noise = deflection_noise(table, ratio)[0]
    if swing.launch_angle is None:
        angle = np.zeros(deflection.shape)
        for away in np.linspace(-3, 3, 25):  # the attack angle is not known either
            steeper = value["attack_angle"] + away * fixed("attack_angle_spread") - usual
            launch = usual + steeper + at_swings(table, ratio, np.array([steeper]), place)[1][0]
            ends = [erf((STEEPEST_LAUNCH + sign * launch) / noise / math.sqrt(2)) / 2 for sign in (-1, 1)]
            angle += (
                np.where(launch < MISSED / 2, sum(ends), 0.0) * math.exp(-0.5 * away**2) / 4 / math.sqrt(2 * math.pi)
            )
    else:
        away = swing.launch_angle - attack - deflection
        angle = np.exp(-0.5 * (away / noise) ** 2) / noise / math.sqrt(2 * math.pi)
    arm = (OWN.length - place) / (OWN.length - 6 * INCH)
    there = speed * arm
    closing = swing.pitch_speed + there
    rise = table.efficiency_slope[::2] * closing
    q = table.efficiency[::2] + value["efficiency_shift"] + rise
    out, slope = (q * closing + there)[:, None] * kept, ((1 + q + rise) * arm)[:, None] * kept
    wide = value["exit_noise"] ** 2 + fixed("model_noise") ** 2 + slope**2 * variance
    density = 0.99 * np.exp(-0.5 * (swing.exit_speed - out) ** 2 / wide) / np.sqrt(2 * math.pi * wide) + 0.01 / 60
    above = np.exp(-0.5 * ((table.offset - value["offset"]) / spread) ** 2) / spread / math.sqrt(2 * math.pi)
    total = np.sum(weight[:, None] * above * angle * density) * (table.offset[1] - table.offset[0])
    met = chance_of_a_hit(model, np.array([value[name] for name in NAMES]))
    return float(said + COUNTED * math.log(total / met))


@pytest.mark.parametrize(
    "swing",
    [
        PlayerSwing(2, None, 44.0, PITCH, None, None, None, ""),
        PlayerSwing(2, 31.0, 42.0, PITCH, 0.35, 0.1, None, ""),
        PlayerSwing(2, 31.0, 30.0, PITCH, -0.8, 0.2, None, ""),
        PlayerSwing(2, None, 40.0, PITCH, 0.7, 0.15, None, ""),
    ],
    ids=["no angle", "usual", "topped", "no bat speed"],
)
def test_the_compiled_likelihood_is_the_readable_one(swing: PlayerSwing) -> None:
    """Other code: the same sums in numpy, over every offset of the table."""
    model = player_model([swing], bat=OWN, ball=BALL)
    places = np.array([TYPICAL, TYPICAL + 0.5, np.zeros(10)])
    found = model.log_likelihood(places)
    assert found == pytest.approx([readable(model, place) for place in places], abs=0.05)


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


def test_a_steeper_swing_turns_the_ball_further(table: BatResponse) -> None:
    """Other code: full collisions; off a tee not at all, for usual speeds by half as much again."""
    middle = table.deflection[:, table.barrel, :, len(table.offset) // 2]
    turning = (middle[3] - middle[1]) / math.radians(20)
    assert abs(turning[0]) < 0.01
    assert 0.45 < turning[3] < 0.65 and np.all(np.diff(turning) > 0)


def test_where_little_comes_back_the_ball_is_turned_further_and_keeps_more(table: BatResponse) -> None:
    """Exact in kind: the part across the line of centres does not hang on what the bat gives back."""
    at = int(np.argmin(np.abs(table.offset - 1.2 * INCH)))
    best, poor = table.barrel, int(np.argmin(np.abs(table.places - 12 * INCH)))
    assert table.deflection[2, poor, 3, at] > 1.2 * table.deflection[2, best, 3, at]
    assert table.retained[2, poor, 3, at + 8] > table.retained[2, best, 3, at + 8] + 0.05


def test_tables_are_the_full_collision(table: BatResponse) -> None:
    """Other code: one oblique hit at a time in space; 0.3 mph and 0.3 degrees between the table's places."""
    attack, place, offset, speed = math.radians(14.0), 8.4 * INCH, -0.9 * INCH, 32.0
    path = SwingPath(attack_angle=attack, tilt=fixed("swing_tilt"))
    arm = (OWN.length - place) / (OWN.length - 6 * INCH)
    descent = fixed("pitch_descent")
    pitch = BallMotion(
        position=np.zeros(3),
        velocity=PITCH * np.array([0.0, -math.cos(descent), -math.sin(descent)]),
        spin=np.array([-fixed("pitch_backspin"), 0.0, 0.0]),
    )
    swing = Swing(bat_speed=speed, measured_at=OWN.length - 6 * INCH)
    done = strike(reduced_bat(OWN, ball=BALL), ball=BALL, swing=swing, path=path, pitch=pitch,
                  contact=Contact(OWN.length - place, offset))  # fmt: skip
    kept, deflection = (
        float(np.interp(offset, table.offset, part[0, 0]))
        for part in at_swings(
            table, np.array([PITCH / speed]), np.array([attack - priors()["attack_angle"].centre]), np.array([place])
        )
    )
    assert done.launched is not None
    out = done.launched.velocity
    assert attack + deflection == pytest.approx(math.atan2(out[2], math.hypot(out[0], out[1])), abs=math.radians(0.3))
    closing = PITCH + speed * arm
    q = np.interp(place, table.from_tip, table.efficiency + closing * table.efficiency_slope)
    assert (q * closing + speed * arm) * kept == pytest.approx(float(np.linalg.norm(out)), abs=0.3 * MPH)


def test_what_counts_as_a_hit_is_counted(table: BatResponse) -> None:
    """Other code: made-up balls of a player, of which those that leave within the range are counted."""
    model = modelled(TYPICAL, count=5, seed=6)
    random, many, usual = np.random.default_rng(3), 20_000, priors()["attack_angle"].centre
    ratio = PITCH / priors()["bat_speed"].centre
    attack = usual + fixed("attack_angle_spread") * random.standard_normal(many)
    above = 0.3 * INCH + 1.2 * INCH * random.standard_normal(many)
    steeper = np.linspace(-0.4, 0.4, 41)
    deflection = at_swings(table, np.full(41, ratio), steeper, np.array([6 * INCH]))[1][:, 0]
    row = np.clip(np.round((attack - usual + 0.4) / 0.02).astype(int), 0, 40)
    turned = np.array([np.interp(one, table.offset, deflection[i], left=MISSED, right=MISSED)
                       for one, i in zip(above, row, strict=True)])  # fmt: skip
    part = np.mean(np.abs(attack + turned) < STEEPEST_LAUNCH)
    theta = natural(np.zeros(10))
    theta[3:8] = 6 * INCH, 0.2 * INCH, 0.3 * INCH, 1.2 * INCH, usual
    assert chance_of_a_hit(model, theta) == pytest.approx(part, abs=0.02)
    theta[3] = 12 * INCH  # where little comes back more balls leave too steeply
    assert chance_of_a_hit(model, theta) < part - 0.02


def test_a_ball_that_leaves_too_steeply_leaves_its_bat_speed() -> None:
    swing = PlayerSwing(2, 31.0, 42.0, PITCH, math.radians(61), 0.1, None, "")
    models = [
        player_model([one], bat=OWN, ball=BALL) for one in (swing, replace(swing, launch_angle=None, exit_speed=None))
    ]
    places = prior_draws(20, seed=2)
    assert models[0].log_likelihood(places) == pytest.approx(models[1].log_likelihood(places))


def test_offsets_that_nothing_told_cannot_all_be_the_same() -> None:
    """Exact limit: a law of offsets much narrower than its grid says no more than one offset does."""
    swings = [PlayerSwing(row, 30.0 + 0.1 * row, 42.0 + 0.1 * row, PITCH, None, None, None, "") for row in range(20)]
    model, places = player_model(swings, bat=OWN, ball=BALL), np.tile(TYPICAL, (2, 1))
    places[:, NAMES.index("offset_spread")] = -12.0, -16.0
    narrow, narrower = model.log_likelihood(places)
    assert narrower == pytest.approx(narrow, abs=2.0)


def test_what_is_kept_at_an_attack_angle_that_nothing_told(table: BatResponse) -> None:
    """Agreement with 200 attack angles and 9 offsets to the next ones: mean to 0.0004, scatter to 0.0015 of it all."""
    ratio, places, nothing = np.array([1.1]), np.array([0.15]), np.array([np.nan])
    kept, variance = untold_kept([table], np.array([0]), ratio=ratio, attack=nothing, places=places)
    wide = np.hypot(fixed("attack_angle_spread"), priors()["attack_angle"].width)
    steeper = wide * np.sqrt(2) * erfinv(np.linspace(-1, 1, 201)[:-1] + 1 / 200)
    many = at_swings(table, np.full(200, ratio[0]), steeper, places)[0][:, 0]
    middles = table.offset[::UNTOLD_EVERY]
    hits = np.flatnonzero(np.abs(middles) < 1.4 * INCH)
    assert len(hits) > 3
    for k in hits:
        reach = np.linspace(-0.5, 0.5, 9) * UNTOLD_EVERY * (table.offset[1] - table.offset[0])
        near = np.array([np.interp(middles[k] + reach, table.offset, row) for row in many])
        assert kept[0, k, 0] == pytest.approx(near.mean(), abs=0.0004)
        assert np.sqrt(variance[0, k, 0]) == pytest.approx(near.std(), abs=0.0015)


def test_hits_that_no_launch_angle_told_are_met_as_all_hits_are() -> None:
    """Exact sum, and a ball is a hit less often towards the tip than at the barrel."""
    model = player_model([PlayerSwing(2, 30.0, 42.0, PITCH, None, None, None, "")], bat=OWN, ball=BALL)
    count = model.table.efficiency.shape[1]
    weight, share = np.zeros(count), np.zeros((model.table.untold_kept.shape[1], count))
    theta = natural(TYPICAL)
    fill_weights(weight, 0.0, model.table.place_step, theta[3], theta[4] ** 2)
    fill_untold(share, weight, model.table, 0, theta, 0.0)
    assert (share @ weight).sum() == pytest.approx(1.0)
    assert share.sum(axis=0)[2] < 0.97 * share.sum(axis=0)[12]


def test_points_of_gauss_sum_a_law_of_two_hills() -> None:
    """Exact: polynomials up to the fifth degree, and nothing of nothing."""
    places = np.linspace(-2.0, 2.0, 61)
    weights = np.exp(-50 * (places - 1) ** 2) + 0.3 * np.exp(-30 * (places + 1.5) ** 2)
    found, shares = gauss_points(np.tile(places, (2, 1)), np.array([weights, np.zeros(61)]), 3)
    for power in range(6):
        assert shares[0] @ found[0] ** power == pytest.approx(weights @ places**power, rel=1e-9)
    assert not shares[1].any()


def test_the_likelihood_is_smooth() -> None:
    """Fine steps of the exit noise change the slope of the logarithm by next to nothing: no rounding shows."""
    model = modelled(TYPICAL, count=40, seed=3)
    places = np.tile(TYPICAL, (41, 1))
    places[:, NAMES.index("exit_noise")] += np.linspace(-0.5, 0.5, 41)
    assert np.abs(np.diff(model.log_likelihood(places), 3)).max() < 1e-3

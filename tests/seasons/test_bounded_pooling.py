"""Intervals of groups' means hold as often as they say, of few groups too; those of rates lie between 0 and 1."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import polars as pl
import pytest
from numpy.typing import NDArray

from sweetspot.numerics.arrays import Array
from sweetspot.seasons.pooling import FEWEST_GROUPS, POSITIVE, pooled_groups
from sweetspot.seasons.standings import BOUNDS, Standing, rare_shares

SHARE = (0.0, 1.0)


def groups_of(counts: Array | NDArray[np.int64], means: Array, squares: Array | None = None) -> pl.DataFrame:
    """Return what is added up of groups of yes or no."""
    own = counts * means * (1 - means) if squares is None else squares
    return pl.DataFrame({"who": np.arange(len(counts)), "balls": counts, "mean": means, "squares": own})


def held(told: pl.DataFrame, truth: Array, percent: int) -> float:
    low, high = (told[f"{side}{percent}"].to_numpy() for side in ("low", "high"))
    return float(np.mean((low <= truth) & (truth <= high)))


@pytest.mark.parametrize("part", [0.5, 0.9])
@pytest.mark.parametrize(
    ("mean", "bounds"), [*((mean, SHARE) for mean in (0.01, 0.05, 0.3, 0.65, 0.95, 0.99)), (0.5, (-1.0, 1.0))]
)
def test_intervals_hold_as_often_as_they_say(mean: float, part: float, bounds: tuple[float, float]) -> None:
    """300 groups of 3 to 120 balls, forty times; how much groups differ in terms of the nearer bound."""
    rng = np.random.default_rng(round(1000 * mean) + round(10 * part))
    low, span = bounds[0], bounds[1] - bounds[0]
    kappa = mean * (1 - mean) / (part * min(mean, 1 - mean)) ** 2 - 1
    halves, nines = [], []
    for _ in range(40):
        truth = rng.beta(mean * kappa, (1 - mean) * kappa, 300)
        counts = rng.integers(3, 120, 300)
        rates = rng.binomial(counts, truth) / counts
        told, _ = pooled_groups(
            groups_of(counts, low + span * rates, span**2 * counts * rates * (1 - rates)), key="who", bounds=bounds
        )
        for percent in (50, 90):
            assert told[f"low{percent}"].min() >= low and told[f"high{percent}"].max() <= low + span  # type: ignore[operator]
            assert (told[f"low{percent}"] <= told["pooled"]).all() and (told["pooled"] <= told[f"high{percent}"]).all()
        halves.append(held(told, low + span * truth, 50))
        nines.append(held(told, low + span * truth, 90))
    assert 0.45 < np.mean(halves) < 0.57
    assert 0.84 < np.mean(nines) < 0.93


@pytest.mark.parametrize(
    ("groups", "balls", "mean", "between", "bounds"),
    [(60, 100, 0.25, 0.033, SHARE), (300, 60, 0.05, 0.01, SHARE), (8, 60, 0.3, 0.06, SHARE), (60, 100, 5.0, 0.08, None),
     (300, 3, 5.0, 0.3, None), (200, 30, 5.0, 0.06, POSITIVE)],
)  # fmt: skip
def test_intervals_hold_where_groups_differ_by_little(
    groups: int, balls: int, mean: float, between: float, bounds: tuple[float, float] | None
) -> None:
    """By so little, R 0.1 to 0.4 for the most part, that how much they do is badly known; balls scatter by 1.

    With a prior flat in tau these hold 82 to 87 %.
    """
    rng = np.random.default_rng(groups + balls)
    halves, nines = [], []
    for _ in range(max(40, 6000 // groups)):
        if bounds == SHARE:
            kappa = mean * (1 - mean) / between**2 - 1
            truth = rng.beta(mean * kappa, (1 - mean) * kappa, groups)
            means = rng.binomial(balls, truth) / balls
            squares = balls * means * (1 - means)
        else:
            truth = rng.normal(mean, between, groups)
            means = truth + rng.normal(0, 1, groups) / np.sqrt(balls)
            squares = rng.chisquare(balls - 1, groups)
        told, _ = pooled_groups(groups_of(np.full(groups, balls), means, squares), key="who", bounds=bounds)
        halves.append(held(told, truth, 50))
        nines.append(held(told, truth, 90))
    assert 0.47 < np.mean(halves) < 0.56
    assert 0.88 < np.mean(nines) < 0.935


def test_probabilities_tell_more_than_yes_or_no() -> None:
    """Balls whose values scatter little are worth several trials: intervals are narrower, and hold as often."""
    rng = np.random.default_rng(5)
    truth = rng.beta(30, 3, 300)
    balls = [rng.beta(7 * one, 7 * (1 - one), 20) for one in truth]
    means = np.array([one.mean() for one in balls])
    squares = np.array([np.sum((one - one.mean()) ** 2) for one in balls])
    told, _ = pooled_groups(groups_of(np.full(300, 20), means, squares), key="who", bounds=SHARE)
    rates = rng.binomial(20, truth) / 20
    coarse, _ = pooled_groups(groups_of(np.full(300, 20), rates), key="who", bounds=SHARE)
    assert 0.45 < held(told, truth, 50) < 0.57 and 0.86 < held(told, truth, 90) < 0.94
    wide = (one["high90"] - one["low90"] for one in (told, coarse))
    assert float(next(wide).mean()) < 0.8 * float(next(wide).mean())  # type: ignore[arg-type]


@pytest.mark.parametrize("groups", [1, 3, 40])
@pytest.mark.parametrize("rate", [0.0, 1.0])
def test_what_never_or_always_happened_is_not_certain(groups: int, rate: float) -> None:
    """Of 30 balls none or all: an interval from the bound on, at most some parts of a hundred wide."""
    told, _ = pooled_groups(groups_of(np.full(groups, 30), np.full(groups, rate)), key="who", bounds=SHARE)
    wide = (told["high90"] - told["low90"]).to_numpy()
    assert np.all(wide > 0.0005) and np.all(wide < 0.07)
    assert (told["low90" if rate == 0 else "high90"] == rate).all()


@pytest.mark.parametrize("spread", [0.15, 0.3])
def test_what_is_never_negative_has_intervals_above_zero_that_hold(spread: float) -> None:
    """200 groups of 3 to 60 balls, twenty times; distances of half a normal distribution about groups' own mean."""
    rng = np.random.default_rng(round(100 * spread))
    halves, nines, below, above = [], [], [], []
    for _ in range(20):
        truth = rng.gamma(1 / spread**2, spread**2, 200)
        counts = rng.integers(3, 60, 200)
        balls = [np.abs(rng.normal(0, 1, n)) * np.sqrt(np.pi / 2) * one for n, one in zip(counts, truth, strict=True)]
        means = np.array([one.mean() for one in balls])
        squares = np.array([np.sum((one - one.mean()) ** 2) for one in balls])
        told, _ = pooled_groups(groups_of(counts, means, squares), key="who", bounds=POSITIVE)
        assert (told["low90"] > 0).all() and (told["low90"] < told["low50"]).all()
        assert (told["high90"] - told["high50"] > told["low50"] - told["low90"]).all()
        halves.append(held(told, truth, 50))
        nines.append(held(told, truth, 90))
        below.append(np.mean(truth < told["low90"].to_numpy()))
        above.append(np.mean(truth > told["high90"].to_numpy()))
    assert 0.45 < np.mean(halves) < 0.57 and 0.86 < np.mean(nines) < 0.94
    assert 0.02 < np.mean(below) < 0.07 and 0.03 < np.mean(above) < 0.08


def drawn_groups(groups: int, count: int, times: int) -> Iterator[tuple[Array, pl.DataFrame]]:
    """Yield the truth of a few groups and what a few balls of each say."""
    rng = np.random.default_rng(10 * groups + count)
    for _ in range(times):
        truth = rng.normal(5, 0.7, groups)
        balls = rng.normal(truth[:, None], 1, (groups, count))
        squares = np.sum((balls - balls.mean(axis=1, keepdims=True)) ** 2, axis=1)
        yield truth, groups_of(np.full(groups, count), balls.mean(axis=1), squares)


@pytest.mark.parametrize("bounds", [None, POSITIVE])
@pytest.mark.parametrize("groups", [1, 2, 3, 6])
def test_one_ball_each_has_no_interval(groups: int, bounds: tuple[float, float] | None) -> None:
    """It tells nothing of how balls scatter: no interval, no reliability, and no error of 0."""
    for _, table in drawn_groups(groups, 1, 3):
        pooled, _ = pooled_groups(table, key="who", bounds=bounds)
        empty = pooled.select("reliability", "spread", "low50", "high50", "low90", "high90").null_count()
        assert empty.row(0) == (groups,) * 6
        assert pooled["pooled"].to_list() == pooled["mean"].to_list()


@pytest.mark.parametrize("count", [2, 3])
@pytest.mark.parametrize("groups", [1, 2, 3, 6])
def test_few_balls_of_few_groups_have_wide_intervals(groups: int, count: int) -> None:
    nines, halves = [], []
    for truth, table in drawn_groups(groups, count, 300):
        pooled, _ = pooled_groups(table, key="who")
        near, _ = pooled_groups(table, key="who", bounds=POSITIVE)
        assert pooled["reliability"].null_count() == (groups if groups < FEWEST_GROUPS else 0)
        assert (near["low90"] < near["low50"]).all() and (near["high90"] > near["high50"]).all()
        halves.append(held(pooled, truth, 50))
        nines.append(held(pooled, truth, 90))
    assert 0.42 < np.mean(halves) < 0.6 and 0.85 < np.mean(nines) < 0.95


def test_one_ball_each_of_a_share_has_an_interval_all_the_same() -> None:
    """Yes or no says by itself how it scatters: 3 of 8 players squared their only ball up."""
    told, spread = pooled_groups(groups_of(np.ones(8), np.array([1.0] * 3 + [0.0] * 5)), key="who", bounds=SHARE)
    assert np.isnan(spread.between) and told["reliability"].null_count() == 8
    assert ((told["high90"] - told["low90"]) > 0.4).all() and told["low90"].min() >= 0  # type: ignore[operator]


def test_groups_that_nothing_tells_apart_are_all_in_the_middle() -> None:
    told, spread = pooled_groups(groups_of(np.full(6, 30), np.full(6, 0.4)), key="who", bounds=SHARE)
    assert spread.between == 0 and (told["percentile"] == 50).all()


def test_one_group_has_jeffreys_interval() -> None:
    """5 of 20: Beta(5.5, 15.5) by its tables, 0.116 to 0.428 between its parts of 0.05 and 0.95."""
    from scipy.stats import beta

    told, _ = pooled_groups(groups_of(np.array([20]), np.array([0.25])), key="who", bounds=SHARE)
    worth = 0.25 * 0.75 / (20 * 0.25 * 0.75 / 19)  # trials a ball, by the unbiased variance
    assert worth == pytest.approx(0.95)  # at least one is taken
    assert told.select("low90", "high90").row(0) == pytest.approx(beta.ppf([0.05, 0.95], 5.5, 15.5), abs=1e-9)


def test_every_share_has_bounds() -> None:
    assert BOUNDS["squared_up"] == BOUNDS["home_run_here"] == SHARE
    assert BOUNDS["squared_up_above"] == (-1.0, 1.0) and "exit_speed" not in BOUNDS


@pytest.mark.parametrize(
    ("blasts", "rare"), [(1, ["blast"]), (2, ["blast"]), (3, []), (37, []), (39, ["blast"]), (40, [])]
)
def test_shares_of_few_of_a_kind_are_named(blasts: int, rare: list[str]) -> None:
    """Each of six players with 40 balls; near 100 % it is the others that are few, and all or none is another thing."""
    share = np.full(6, blasts / 40)
    told, spread = pooled_groups(groups_of(np.full(6, 40), share), key="who", bounds=SHARE)
    assert rare_shares(Standing("batter", told, {"blast": spread, "exit_speed": spread})) == rare
